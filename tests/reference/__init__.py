"""Oracles: the same physics by other roads, in plain NumPy, clear and slow. They share no code with the product."""
