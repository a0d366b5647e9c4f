"""Which solver, and what of its work is done once: orders, patterns, blocks."""
