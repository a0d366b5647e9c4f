"""Where nodes are: what users give of them, poses of bays and groups of nodes, what rows and drives read there."""
