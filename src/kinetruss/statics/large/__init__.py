"""Large displacements: equilibria and paths of them."""
