"""The kinds of elements of a structure, a file each: their tables, kernels and laws."""
