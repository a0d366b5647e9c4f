"""Where the command ``kinetruss`` begins: Ctrl-C ends it in one line from the first import on."""

from __future__ import annotations

import sys

from kinetruss.cli._codes import INTERRUPTED

__all__ = ["start"]


def start() -> None:
    """Run the command line, and end the process with its exit code."""
    try:
        from kinetruss.cli._main import main

        main()
    except KeyboardInterrupt:
        sys.stderr.write("Interrupted.\n")
        sys.exit(INTERRUPTED)
