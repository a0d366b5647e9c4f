"""Messages of a simulation: how it ended, what limited its steps, whether energy was conserved."""
