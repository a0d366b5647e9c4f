"""Runs in blocks of samples."""
