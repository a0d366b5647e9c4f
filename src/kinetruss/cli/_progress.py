"""Progress of long computations, on stderr: a bar on a terminal, some lines elsewhere."""

from __future__ import annotations

import logging
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from typing import Any

import click

__all__ = ["KERNELS", "bar", "compiling", "heard"]

KERNELS = "kinetruss.kernels"
"""The logger that hears of every kernel that is compiled; while it has a handler, nothing else is written about them."""
OFTEN = 15.0
"""Seconds between two lines where there is no terminal."""

Shown = Callable[[int, int | None], None]


@contextmanager
def bar(silent: bool, what: str = "samples", *, first: str = "", kernels: bool = True) -> Iterator[Shown | None]:
    """A function to call with the number of items done and of all items (None: not known), or None.

    silent : show nothing. first : text shown until the first item is done; without a terminal a line. kernels : a bar says too
    that kernels are compiled. Without a terminal a line is written now and then, from `OFTEN` seconds on.
    """
    if silent:
        yield None
    elif not sys.stderr.isatty():
        if first:
            click.echo(f"kinetruss: {what}{first} ...", err=True)
        yield _lines(what)
    else:
        with _on_terminal(what, first, kernels) as shown:
            yield shown


@contextmanager
def _on_terminal(what: str, first: str, kernels: bool) -> Iterator[Shown]:
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[count]}"), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as found:
        task = found.add_task(f"{what}{first}", total=None, count="")
        seen: list[int] = []

        def shown(done: int, total: int | None) -> None:
            count = f"{done}/{total}" if total is not None else str(done)
            found.update(task, completed=done, total=total, description=what, count=count)

        class Compiled(logging.Handler):
            def emit(self, record: logging.LogRecord) -> None:  # noqa: ARG002
                seen.append(1)
                found.update(task, description="compiling (first start only)", count=f"{len(seen)} kernels")

        with heard(Compiled()) if kernels else nullcontext():
            yield shown


def _lines(what: str) -> Shown:
    """A function that writes a line now and then; the last one is that of the end."""
    began = last = time.monotonic()
    told = False

    def shown(done: int, total: int | None) -> None:
        nonlocal last, told
        _compiled()
        now = time.monotonic()
        if not (told if done == total else now - last >= OFTEN):
            return
        last, told = now, True
        of = "" if total is None else f" of {total}"
        click.echo(f"kinetruss: {done}{of} {what}, {now - began:.0f} s", err=True)

    return shown


@contextmanager
def compiling(silent: bool) -> Iterator[None]:
    """Within it, lines on stderr say that kernels are compiled, and how many they were; none if silent."""
    if silent:
        with heard(logging.NullHandler()):
            yield
        return
    try:
        yield
    finally:
        _compiled()


def _compiled() -> None:
    """Say how much was compiled, if a line said that it began."""
    jit: Any = sys.modules.get("kinetruss.kernels.compiled.jit")  # a command that computes nothing has not loaded it
    if jit is not None:
        jit.keeper.progress.end()


@contextmanager
def heard(handler: logging.Handler) -> Iterator[None]:
    """Within it the handler hears of every kernel that is compiled."""
    logger = logging.getLogger(KERNELS)
    level = logger.level
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.setLevel(level)
        logger.removeHandler(handler)
