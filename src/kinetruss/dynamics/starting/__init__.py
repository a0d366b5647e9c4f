"""Starts of a simulation, and the way through singular positions."""
