"""What is known of kernels while they are compiled, and what a person sees of it: that it happens once, and how far it is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import TextIO

__all__ = ["Progress"]

SOON = 1.0
"""Seconds of compiling before the first line."""
PATIENCE = 3.0
"""Seconds of compiling between two lines."""


class Progress:
    """Counts the kernels that are compiled, and writes lines about them.

    On a terminal and in a notebook a line is written now and then. Elsewhere, as in a pipe or a file, one says what the
    silence is. How many kernels a computation needs is not known before: no total is given.

    count : kernels that were compiled. at_work : whether one is compiled now. changed : when one was begun or done.
    """

    def __init__(self, stream: TextIO | None = None, clock: Callable[[], float] = time.monotonic) -> None:
        self.stream, self.clock = stream, clock
        self.count, self.depth, self.changed = 0, 0, 0.0
        self._before, self._begun = 0.0, 0.0
        self._written, self._open = 0.0, False  # seconds at the last line; whether a line said that it began

    @property
    def at_work(self) -> bool:
        """Whether a kernel is compiled now."""
        return self.depth > 0

    @property
    def seconds(self) -> float:
        """Time spent with compiling."""
        return self._before + (self.clock() - self._begun if self.at_work else 0.0)

    def begin(self, form: str = "draft") -> None:
        """A kernel is compiled from now on, maybe within another one.

        form : what is compiled of it; the "entry" is the outermost, at which kernels before it that failed are forgotten.
        """
        if form == "entry":
            self.rest()
        self.changed = self.clock()
        if not self.depth:
            self._begun = self.changed
        self.depth += 1

    def compiled(self, form: str = "draft") -> None:
        """It is compiled."""
        self.count += form in ("draft", "kernel")
        self.changed = self.clock()
        if form == "entry" or self.depth <= 1:
            self.rest()
        else:
            self.depth -= 1

    def rest(self) -> None:
        """Nothing is compiled any more: it is done, or has failed."""
        if self.depth:
            self._before += self.clock() - self._begun
        self.depth = 0

    def tell(self) -> None:
        """Write a line, if it is time for one."""
        spent, stream = self.seconds, self.stream or sys.stderr
        often = stream.isatty() or _of_notebook(stream)
        if spent - self._written < (PATIENCE if self._open else SOON) or (self._open and not often):
            return
        self._written, self._open = spent, True
        so_far = f": {self._kernels()}, {spent:.0f} s" if often else " ..."
        stream.write(f"kinetruss: compiling (first start only){so_far}\n")
        stream.flush()

    def end(self) -> None:
        """Write how much was compiled, if a line said that it began."""
        if not self._open or self.at_work:
            return
        self._written, self._open = self.seconds, False
        stream = self.stream or sys.stderr
        stream.write(f"kinetruss: compiled {self._kernels()} in {self.seconds:.0f} s.\n")
        stream.flush()

    def _kernels(self) -> str:
        return f"{self.count} kernel{'' if self.count == 1 else 's'}"


def _of_notebook(stream: TextIO) -> bool:
    """Whether the kernel of a notebook shows what is written; it is no terminal."""
    return type(stream).__module__.startswith("ipykernel.")
