"""Entry point of the command ``kinetruss``: Ctrl-C ends it with one line, also during imports."""

from __future__ import annotations

import sys

from kinetruss.cli.codes import INTERRUPTED


def start() -> None:
    """Run the command line, and end the process with its exit code."""
    try:
        from kinetruss.cli.commands import main

        main()
    except KeyboardInterrupt:
        sys.stderr.write("Interrupted.\n")
        sys.exit(INTERRUPTED)
