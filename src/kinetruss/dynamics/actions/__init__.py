"""What acts on bars between their ends: loads, clamped masses, couples of drives and couplings."""
