"""Verbs for models."""
