"""Power series of a motion."""
