"""How kernels are compiled and kept, and what they are made of: records on flat buffers, workspaces."""
