"""How sure results are: standard errors of measured motions, error budgets of poses."""
