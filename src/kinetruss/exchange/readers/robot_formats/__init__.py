"""Readers of URDF and MJCF."""
