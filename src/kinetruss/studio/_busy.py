"""What a page is told while its answer takes long."""

from __future__ import annotations

import time

from kinetruss.kernels.compiled.jit import keeper

__all__ = ["Busy"]

LATELY = 1.0
"""Seconds after a kernel within which the next one is expected."""


class Busy:
    """What is done since it was made, in words."""

    def __init__(self) -> None:
        self.began, self.before, self.spent = time.monotonic(), keeper.progress.count, keeper.progress.seconds

    def compiling(self) -> str:
        """How much was compiled; empty where nothing is compiled now."""
        found = keeper.progress
        if not found.at_work and (found.changed < self.began or found.clock() - found.changed > LATELY):
            return ""
        count, seconds = found.count - self.before, found.seconds - self.spent
        return f"Compiling (first start only): {count} kernel{'' if count == 1 else 's'}, {seconds:.0f} s"

    def text(self) -> str:
        """What is done, and for how long."""
        seconds = int(time.monotonic() - self.began)
        return self.compiling() or (f"Computing: {seconds} s" if seconds else "Computing ...")
