"""Statics, small motions, sizing, gauges, free bodies."""
