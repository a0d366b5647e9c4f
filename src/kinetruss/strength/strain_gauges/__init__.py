"""Strain gauges: simulated and measured readings."""
