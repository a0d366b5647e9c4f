"""Bodies, membranes and solids."""
