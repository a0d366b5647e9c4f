"""Coordinates of nodes: each kind written once, as an expression, from which code for single points and for series is made."""
