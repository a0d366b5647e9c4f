"""Tasks of structures: what is asked for against what the drives give, and what cannot be done."""
