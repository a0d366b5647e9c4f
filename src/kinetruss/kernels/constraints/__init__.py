"""Constraints: lengths, angles and sums, their values, gradients and how these turn."""
