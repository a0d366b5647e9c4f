"""What a structure is made of, for kernels: its arrays, and the mass, laws and loads of its elements."""
