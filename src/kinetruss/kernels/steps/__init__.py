"""Single steps of the integrators, and the states within a step."""
