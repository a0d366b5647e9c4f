"""Run folders as arguments: single ones, and folders that hold several."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinetruss.errors import InputError

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["found_runs", "opened", "opened_run"]


def found_runs(paths: Sequence[Path]) -> list[Path]:
    """The named run folders, and those inside named folders, each once; variants in one folder in the order of their
    numbers.
    """
    from kinetruss.results.store import is_store

    found: list[Path] = []
    for path in paths:
        if not path.is_dir():
            continue  # `OUT/*` matches other files too
        inside = [] if is_store(path) else [below for below in sorted(path.iterdir()) if is_store(below)]
        if not is_store(path) and not inside:
            raise InputError(f"{path} holds no run. Make one: kinetruss run MODEL -o {path}")
        found += inside or [path]
    if not found:
        raise InputError(f"{', '.join(map(str, paths))}: no run folder among them.")
    found = list(dict.fromkeys(found))
    # a shell sorts 10 before 3
    return sorted(found, key=_by_numbers) if len({path.parent for path in found}) == 1 else found


def opened(paths: Sequence[Path]) -> list[RunResult]:
    """The opened runs; a line on stderr reports each run that is not complete."""
    return [opened_run(path) for path in found_runs(paths)]


def opened_run(path: Path, out: Path | None = None) -> RunResult:
    """One run, opened in the same way; of a mission its governing pair, done as a run (written to `out`)."""
    from kinetruss import runs

    found = runs.load(path)
    if isinstance(found, runs.MissionRun):
        found = runs.governing(found, out=out)
        click.echo(f"{path}: a mission has an envelope and no histories; its governing pair is shown, {found.name}.", err=True)
    if not found.whole:
        click.echo(f"{path}: the run is not complete: {found.good} of {found.samples} samples are good.", err=True)
    return found


def _by_numbers(path: Path) -> list[tuple[int, float, str]]:
    parts = re.split(r"((?<![\w.])-?\d+(?:\.\d+)?)", path.name)
    return [(1, float(part), "") if k % 2 else (0, 0.0, part) for k, part in enumerate(parts)]
