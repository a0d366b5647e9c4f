"""Where the command ``kinetruss`` begins: Ctrl-C ends it in one line from the first import on."""

from __future__ import annotations

import sys

__all__ = ["INTERRUPTED", "start"]

INTERRUPTED = 130
"""Exit code after Ctrl-C, as shells have it: 128 and the number of the signal."""


def start() -> None:
    """Run the command line, and end the process with its exit code."""
    try:
        from kinetruss.cli._main import main

        main()
    except KeyboardInterrupt:
        sys.stderr.write("Interrupted.\n")
        sys.exit(INTERRUPTED)
