"""Forward dynamics: a problem, steps to wanted times, the record of what happened."""
