"""How fast anything goes with anything: Jacobians, transfer functions, conditioning; degrees of freedom along a motion."""
