"""``kinetruss compile``."""

from __future__ import annotations

import logging
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click

from kinetruss.cli._progress import bar
from kinetruss.cli._verb import HELP, Verb, json_option, print_json

__all__ = ["compile_kernels"]

EPILOG = """\b
Example:
  kinetruss compile
"""
RUNS = (("double_octahedral_slew", "slew"), ("double_pendulum", "fall"), ("double_pendulum", "long"))
"""Runs that between them need what most others need: a prescribed motion with forces, strength and motors; simulations."""
STEP = 20
"""Kernels from line to line, where there is no terminal for a bar."""


@click.command("compile", cls=Verb, context_settings=HELP, epilog=EPILOG)
@json_option
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
def compile_kernels(as_json: bool, quiet: bool) -> None:
    """Compile the kernels that most runs need, and keep them: some minutes, once; else the first runs do it.

    What is kept already is not compiled again. For images of containers: build them with this, run them without the right to
    write. NUMBA_CACHE_DIR names another folder to keep kernels in.

    Exit code 0: done; 1: compiled kernels cannot be kept on disk.
    """
    from kinetruss.errors import KernelCacheWarning, StoreError

    began = time.perf_counter()
    with bar(quiet or as_json, "kernels", first="") as seen:
        told = seen or _silent if quiet or as_json or seen else _lines
        try:
            with _counted(told) as compiled, warnings.catch_warnings():
                warnings.simplefilter("error", KernelCacheWarning)
                _run_all()
        except KernelCacheWarning as error:
            raise StoreError(str(error)) from None
    seconds = time.perf_counter() - began
    if as_json:
        print_json("compile", {"compiled": len(compiled), "seconds": seconds})
    elif not quiet:
        click.echo(f"{len(compiled)} kernels compiled in {seconds:.0f} s. What other runs need is compiled by them.")


def _run_all() -> None:
    from kinetruss.io import read
    from kinetruss.library import example_files
    from kinetruss.runs import run

    shelf = example_files()
    for example, name in RUNS:
        run(read(shelf[example][0]), name)


@contextmanager
def _counted(told: Callable[[int, int], None]) -> Iterator[set[str]]:
    """Names of the kernels that are compiled; after each, how many of all are there."""
    from kinetruss.kernels.compiled import jit
    from kinetruss.kernels.compiled.caches import count_kernels

    count, kept, compiled = count_kernels(jit.folder), jit.keeper.kept(), set[str]()

    class Counter(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            compiled.add(record.getMessage().removeprefix("compiled "))
            told(len(kept | compiled), count)

    logger, counter = logging.getLogger("kinetruss.kernels"), Counter()
    level = logger.level
    logger.addHandler(counter)
    logger.setLevel(logging.INFO)
    told(len(kept), count)
    try:
        yield compiled
    finally:
        logger.setLevel(level)
        logger.removeHandler(counter)


def _silent(_done: int, _count: int) -> None:
    pass


def _lines(done: int, count: int) -> None:
    if not done % STEP:
        click.echo(f"Compiling the kernels: {done} of at most {count}", err=True)
