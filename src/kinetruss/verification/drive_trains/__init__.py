"""Screws, gears and motors."""
