"""A model compiled to arrays: its nodes, members, constraints, and the order in which they are worked on."""
