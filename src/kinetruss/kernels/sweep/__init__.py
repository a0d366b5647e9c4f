"""Sweeps over the blocks of a structure: motion from the base up, forces from the tip down."""
