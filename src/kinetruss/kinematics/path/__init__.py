"""Positions along a path: one configuration, a trajectory, what lies between its samples."""
