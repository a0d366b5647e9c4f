"""Equations of motion: forces along a given motion, free bodies, labelled systems."""

from kinetruss.dynamics._free_body import Body, Equation, FreeBody, Term, free_body
from kinetruss.dynamics._inverse import inverse
from kinetruss.dynamics._newton_euler import LabelledSystem, newton_euler

__all__ = ["Body", "Equation", "FreeBody", "LabelledSystem", "Term", "free_body", "inverse", "newton_euler"]
