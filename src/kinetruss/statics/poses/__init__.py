"""Static forces at single poses, and elastic deflection along a motion."""
