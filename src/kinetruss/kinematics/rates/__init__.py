"""How fast anything goes with anything: Jacobians, transfer functions, conditioning."""
