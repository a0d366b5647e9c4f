"""What is said of a simulation: how it ended, what asked for its steps, whether it kept its energy."""
