"""What can move and what is held twice: rank, mechanisms, self-stress, degrees of freedom by choice."""
