"""What a structure is made of, for kernels: its arrays, its rows, and the mass, laws and loads of its elements."""
