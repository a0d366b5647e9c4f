"""Motors coupled with a structure: their modes, friction, histories."""
