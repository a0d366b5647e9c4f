"""A progress bar for long computations."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

__all__ = ["bar"]

FIRST = " (the first start on a machine compiles, once)"


@contextmanager
def bar(silent: bool, what: str = "samples", first: str = FIRST) -> Iterator[Callable[[int, int], None] | None]:
    """A progress bar on stderr, if that is a terminal. first : text shown until the first item is done."""
    if silent or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as found:
        # the first start compiles kernels for a minute or more, without output
        task = found.add_task(f"{what}{first}", total=None)
        yield lambda done, total: found.update(task, completed=done, total=total, description=what)
