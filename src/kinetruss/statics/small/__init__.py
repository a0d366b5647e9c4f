"""Small displacements: the stiffness method, refined and with bounds on its errors; buckling."""
