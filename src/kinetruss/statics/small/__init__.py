"""Small displacements: the stiffness method with iterative refinement and error bounds; linear buckling."""
