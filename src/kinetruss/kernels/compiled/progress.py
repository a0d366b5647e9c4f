"""What a person sees while kernels are compiled: a line now and then, that it happens once and how far it is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import TextIO

__all__ = ["Progress"]

PATIENCE = 3.0
"""Seconds before the first line, and between two."""


class Progress:
    """Lines on a terminal or in a notebook; nothing where nobody looks, as in a pipe or a file.

    most : gives the number of kernels there are at most; asked when the first line is written.
    """

    def __init__(
        self, most: Callable[[], int], stream: TextIO | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.most, self.clock, self.stream = most, clock, stream
        self.count, self.reported = 0, clock()
        self.begun: float | None = None

    def compiled(self) -> None:
        """One more kernel is compiled."""
        now, stream = self.clock(), self.stream or sys.stderr
        self.count += 1
        if self.begun is None:
            self.begun = self.reported = now
        if now - self.reported < PATIENCE or not (stream.isatty() or _of_notebook(stream)):
            return
        self.reported = now
        spent = now - self.begun
        stream.write(
            f"kinetruss compiles its kernels, once on this machine: {self.count} of at most {self.most()}, {spent:.0f} s\n"
        )
        stream.flush()


def _of_notebook(stream: TextIO) -> bool:
    """Whether the kernel of a notebook shows what is written; it is no terminal."""
    return type(stream).__module__.startswith("ipykernel.")
