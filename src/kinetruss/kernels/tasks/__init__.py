"""Tasks of a structure: their coordinates as functions of the nodes, and the drives that meet them."""
