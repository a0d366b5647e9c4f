"""Constraints along a motion, their rank, null spaces and what these mean in words."""
