"""Figures and line drawings."""
