"""Demand on drive trains along a motion, against their limits."""
