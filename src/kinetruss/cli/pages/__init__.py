"""Verbs for pages and pictures."""
