"""Poses of bodies, planes and platforms; where they can go."""
