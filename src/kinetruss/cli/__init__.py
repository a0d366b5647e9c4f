"""The command line: verbs, each a few lines over the Python interface."""

from kinetruss.cli._main import main

__all__ = ["main"]
