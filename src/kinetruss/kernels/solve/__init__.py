"""Solvers of the equations of motion: dense, sparse, by null space."""
