"""First and second derivatives: Jacobians, transfer functions, conditioning; degrees of freedom along a motion."""
