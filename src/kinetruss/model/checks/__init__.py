"""Cross-checks of a whole model: every fault with its mend."""
