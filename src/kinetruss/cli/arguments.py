"""Common arguments of commands: run folders, quantities, ``--set PATH=V1,V2,...``."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinetruss.cli import completing
from kinetruss.cli.common import PLACE
from kinetruss.errors import InputError

if TYPE_CHECKING:
    from kinetruss.runs import RunResult


OPENING, CLOSING = "[{(", "]})"


def settings(texts: Iterable[str]) -> dict[str, list[str]]:
    """Path -> values of all ``--set`` options; commas within brackets, braces or quotes are part of the value.

    >>> settings(["runs.lean.trajectory.duration=3,5 s", "nodes.B.at=[0, 1 m],[0, 2 m]"])
    {'runs.lean.trajectory.duration': ['3', '5 s'], 'nodes.B.at': ['[0, 1 m]', '[0, 2 m]']}
    """
    found: dict[str, list[str]] = {}
    for text in texts:
        path, sign, values = text.partition("=")
        path = path.strip()
        if not sign or not path:
            raise click.UsageError(f"--set {text!r} has no value. Write --set PATH=V1,V2, e.g. --set safety.yielding=1.5,2.")
        if path in found:
            raise click.UsageError(f"--set {path} is given twice. Give all its values at once: --set {path}=V1,V2.")
        found[path] = _split(values)
        if not all(found[path]):
            raise click.UsageError(f"--set {text!r} has an empty value. Write ~ for none.")
    return found


def pairs(option: str, texts: Iterable[str]) -> dict[str, str]:
    """Name -> value of an option that may be given several times.

    >>> pairs("--tolerance", ["M*.length=0.1 mm", "temperature = 20"])
    {'M*.length': '0.1 mm', 'temperature': '20'}
    """
    found: dict[str, str] = {}
    for text in texts:
        name, _, value = (part.strip() for part in text.partition("="))
        if not name or not value:
            raise click.UsageError(f"{option} {text!r} has no name or no value. Write {option} NAME=VALUE.")
        if name in found:
            raise click.UsageError(f"{option} {name} is given twice. Give one value.")
        found[name] = value
    return found


def _split(text: str) -> list[str]:
    depth, quote, parts = 0, "", [""]
    for sign in text:
        if quote:
            quote = "" if sign == quote else quote
        elif sign in "\"'":
            quote = sign
        else:
            depth += (sign in OPENING) - (sign in CLOSING)
        if sign == "," and not quote and depth <= 0:
            parts.append("")
        else:
            parts[-1] += sign
    return [part.strip() for part in parts]


# Run folders as arguments: single ones, and folders that hold several.


def found_runs(paths: Sequence[Path]) -> list[Path]:
    """The named run folders, and those inside named folders, each once; variants in one folder in the order of their
    numbers.
    """
    from kinetruss.results.folder import is_store

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


# Runs and their quantities: the common arguments of ``plot`` and ``compare``.

STATION = "Place along the member, 0 to 1 from its first end (default: the largest along it)."


def curves_of_runs(*, quantity: str, member: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """OUT..., --quantity, --member, --case and --station, with the command's own help for the first two."""
    given = (
        click.argument("out", type=PLACE, nargs=-1, required=True),
        click.option("--quantity", multiple=True, shell_complete=completing.quantities, help=quantity),
        click.option("--member", multiple=True, shell_complete=completing.parts, help=member),
        click.option("--case", shell_complete=completing.cases, help="Load case (default: the first)."),
        click.option("--station", type=float, help=STATION),
    )

    def added(verb: Callable[..., Any]) -> Callable[..., Any]:
        for one in reversed(given):
            verb = one(verb)
        return verb

    return added
