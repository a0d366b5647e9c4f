"""Equations of motion: forces along a given motion."""

from kinetruss.dynamics._inverse import inverse

__all__ = ["inverse"]
