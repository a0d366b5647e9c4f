"""Loops, joints and robots: counts, closed forms, rates, assembly modes."""
