"""What moves a structure and what is asked of it: drives, trajectories, tasks, methods, runs."""
