"""What can move and what is held: rank, coordinates by name, degrees of freedom by choice, and what follows their changes."""
