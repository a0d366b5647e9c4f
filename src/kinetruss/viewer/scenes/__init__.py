"""Scenes as plain data: what is seen of a model, a motion or a run."""
