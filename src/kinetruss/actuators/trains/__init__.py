"""Screw, gear and motor of a drive."""
