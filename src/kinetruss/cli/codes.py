"""Exit codes of the command line."""

INTERRUPTED = 130
"""After Ctrl-C: 128 plus the number of the signal, as in shells."""
