"""Structures at rest along a motion or at single poses."""
