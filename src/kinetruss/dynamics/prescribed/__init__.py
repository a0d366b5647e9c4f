"""Forces along a given motion."""
