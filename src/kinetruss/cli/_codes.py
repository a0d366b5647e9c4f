"""Exit codes that no library gives."""

__all__ = ["INTERRUPTED"]

INTERRUPTED = 130
"""After Ctrl-C, as shells have it: 128 and the number of the signal."""
