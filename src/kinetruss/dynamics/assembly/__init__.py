"""A compiled model as equations of motion: mass, loads, prescribed motion, stiffness."""
