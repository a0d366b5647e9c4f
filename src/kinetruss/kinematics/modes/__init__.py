"""Assembly modes: all ways to put a structure together."""
