"""Entry point of the command ``kinetruss``: Ctrl-C ends it with one line, also during imports."""

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
