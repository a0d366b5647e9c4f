"""Forward dynamics: closed forms, invariants, orders of convergence."""
