"""``kinetruss compile``."""

from __future__ import annotations

import logging
import sys
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, wait
from contextlib import contextmanager
from importlib import import_module
from multiprocessing import get_context
from pkgutil import walk_packages

import click

from kinetruss.cli.common import HELP, KERNELS, Verb, bar, heard, json_option, print_json

EPILOG = """\b
Example:
  kinetruss compile
"""
RUNS = (("double_octahedral_slew", "slew"),), (("double_pendulum", "fall"), ("double_pendulum", "long"))
"""Runs that together need the kernels of most models: a prescribed motion with forces, strength and motors; simulations.

The groups share few kernels, so each group is compiled in its own process; drawings follow the first."""
POLL = 0.5
"""Seconds between two checks of the kernels compiled by other processes."""
STEP = 20
"""Number of kernels per printed line, if there is no terminal."""


@click.command("compile", cls=Verb, context_settings=HELP, epilog=EPILOG)
@json_option
@click.option("--all", "rare", is_flag=True, help="Also what only some models need: hinges, membranes, large structures.")
@click.option("--runs", "only_runs", is_flag=True, help="Only what runs need; drawings compile theirs when they need them.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
def compile_kernels(as_json: bool, rare: bool, only_runs: bool, quiet: bool) -> None:
    """Compile the kernels of most runs and drawings, and keep them.

    They are kept on disk. It takes some minutes, once; otherwise the first runs do it.

    Kernels that are already on disk are not compiled again. For container images: compile with `--all` when they are built;
    they then run without write permission. NUMBA_CACHE_DIR names another folder for the kernels.

    Exit code 0: done; 1: compiled kernels cannot be kept on disk.
    """
    from kinetruss.errors import KernelCacheWarning, StoreError
    from kinetruss.kernels.compiled import jit

    began = time.perf_counter()
    with bar(quiet or as_json or not sys.stderr.isatty(), "kernels", kernels=False) as seen:
        shown = seen or ((lambda _done, _total: None) if quiet or as_json else _lines())
        try:
            with _counted(shown) as (compiled, look), warnings.catch_warnings():
                warnings.simplefilter("error", KernelCacheWarning)
                _run_all(look, drawn=not only_runs)
                if rare:
                    _compile_rare()
        except KernelCacheWarning as error:
            raise StoreError(str(error)) from None
    seconds = time.perf_counter() - began
    folders = [str(folder) for folder in jit.keeper.folders()]
    if as_json:
        print_json("compile", {"compiled": len(compiled), "seconds": seconds, "folders": folders})
    elif not quiet:
        click.echo(
            f"{len(compiled)} kernels compiled in {seconds:.0f} s. Other kernels are compiled by the runs that need them."
        )
        if folders:
            click.echo(f"They are kept in {' and '.join(folders)}")


def _run_all(look: Callable[[], None], *, drawn: bool) -> None:
    """Do all runs, the groups in parallel if there are enough processors. look : called regularly while other processes
    work. drawn : then draw, too.
    """
    from kinetruss.runs.processes import processors

    first, *others = RUNS
    if processors() < len(RUNS):
        for group in RUNS:
            _run_group(group)
        if drawn:
            _draw()
        return
    with ProcessPoolExecutor(len(others), get_context("spawn"), _silenced) as pool:
        running = [pool.submit(_run_group, group) for group in others]
        _run_group(first)
        if drawn:
            _draw()  # shares kernels with the runs before, and few with those beside
        while wait(running, POLL).not_done:
            look()
        for one in running:
            one.result()


def _silenced() -> None:
    """This process reports what all of them compile."""
    logging.getLogger(KERNELS).addHandler(logging.NullHandler())


def _compile_rare() -> None:
    from kinetruss import kernels
    from kinetruss.elements.kinds import compile_kinds
    from kinetruss.kernels.compiled.calls import Apart
    from kinetruss.mechanics.solvers import KERNELS, addresses_of

    for module in walk_packages(kernels.__path__, f"{kernels.__name__}."):
        import_module(module.name)
    for group in Apart.every:
        group.addresses()
    for solver in KERNELS:
        addresses_of(solver)
    compile_kinds()


def _run_group(group: Sequence[tuple[str, str]]) -> None:
    from kinetruss.errors import KernelCacheWarning
    from kinetruss.io import read
    from kinetruss.library import example_files
    from kinetruss.runs import run

    shelf = example_files()
    with warnings.catch_warnings():
        warnings.simplefilter("error", KernelCacheWarning)
        for example, name in group:
            run(read(shelf[example][0]), name)


def _draw() -> None:
    """Draw what the tools of the studio draw: springs, ropes, gear wheels, blocks and beams are in none of the runs."""
    from kinetruss.studio.first_use import used

    for dim in (2, 3):
        used(dim)


@contextmanager
def _counted(shown: Callable[[int, None], None]) -> Iterator[tuple[set[str], Callable[[], None]]]:
    """Names of the compiled kernels, and a function that counts those of other processes too; reports the count after each."""
    from kinetruss.kernels.compiled import jit

    kept, compiled = jit.keeper.kept(), set[str]()

    def look() -> None:
        compiled.update(jit.keeper.kept() - kept)
        shown(len(compiled), None)

    class Counter(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            compiled.add(record.getMessage().removeprefix("compiled "))
            look()

    with heard(Counter()):
        yield compiled, look


def _lines() -> Callable[[int, None], None]:
    """A function that prints a line after every `STEP` kernels."""
    last = 0

    def shown(done: int, _total: None) -> None:
        nonlocal last
        if done // STEP > last:
            last = done // STEP
            click.echo(f"Compiling the kernels: {last * STEP} so far", err=True)

    return shown
