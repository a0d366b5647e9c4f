"""Prescribed motion: profiles in time, gimbals, platforms."""
