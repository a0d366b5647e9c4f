"""Verbs for runs."""
