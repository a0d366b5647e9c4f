"""Adaptive trusses against the numbers of Lacy (1991) and against exact physics."""
