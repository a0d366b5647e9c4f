"""Values of arguments and options that the shell completes: from the library, and from the model or run on the line."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import wraps
from pathlib import Path
from typing import Any

import click

Complete = Callable[[click.Context, click.Parameter, str], list[str]]
MODELS = ("model", "what", "out", "run")
"""Names of arguments that hold a model file or a run folder."""
MEMBERS = ("bars", "active", "beams", "links")
MOST = 400
"""Largest number of values that are offered."""


def _offered(find: Callable[[click.Context], Iterable[str]]) -> Complete:
    """Those of the found values that begin as what is typed; none where there is nothing to find them in."""

    @wraps(find)
    def complete(context: click.Context, _parameter: click.Parameter, begun: str) -> list[str]:
        try:
            found = dict.fromkeys(str(one) for one in find(context) if str(one).startswith(begun))
        except Exception:  # noqa: BLE001 - a faulty file is reported by the command, not by the tab key
            return []
        return list(found)[:MOST]

    return complete


def one_of(*values: str) -> Complete:
    """Fixed values."""
    return _offered(lambda _context: values)


def _data(context: click.Context) -> dict[str, Any]:
    """The tables of the model on the line: of its file, or of the run in its folder."""
    from kinetruss.io.writing import data_of

    # click leaves the arguments unread where the last word is an option without its value; the model is the first of them
    given = next((context.params[name] for name in MODELS if context.params.get(name)), None) or context.args[0]
    path = Path(given[0] if isinstance(given, tuple) else given)
    if path.is_dir():
        from kinetruss.results.folder import is_store

        folder = path if is_store(path) else next(one for one in sorted(path.iterdir()) if is_store(one))
        path = folder / "model.json"
    return data_of(path.read_text(encoding="utf-8-sig"), path.parent)[0]


def _names(context: click.Context, *tables: str) -> list[str]:
    data = _data(context)
    return [name for table in tables for name in data.get(table) or {}]


def _driven(data: dict[str, Any]) -> list[str]:
    """Names of what moves: drives, active members, driven bars."""
    bars = [name for name, bar in (data.get("bars") or {}).items() if isinstance(bar, dict) and bar.get("kind") == "driven"]
    return [*(data.get("drives") or {}), *(data.get("active") or {}), *bars]


@_offered
def examples(_context: click.Context) -> Iterable[str]:
    """Examples that come with the package."""
    from kinetruss.library import example_files

    return list(example_files())


@_offered
def sources(_context: click.Context) -> Iterable[str]:
    """Examples, and mechanisms of the library."""
    from kinetruss.library import builders, example_files

    mechanisms = "mechanisms."
    return [*example_files(), *(name.removeprefix(mechanisms) for name in builders() if name.startswith(mechanisms))]


@_offered
def materials(_context: click.Context) -> Iterable[str]:
    """Materials of the library."""
    from kinetruss.library.materials import MATERIALS

    return list(MATERIALS)


@_offered
def quantities(_context: click.Context) -> Iterable[str]:
    """What `plot` and `compare` show over time."""
    from kinetruss.report.pictures import ALIASES, BUNDLES, FED, QUANTITIES

    return sorted({*QUANTITIES, *FED, *ALIASES, *BUNDLES})


@_offered
def tests(_context: click.Context) -> Iterable[str]:
    """Classes of the cases of `verify`."""
    from kinetruss.verification import CLAIMS

    return [str(kind) for kind in CLAIMS]


@_offered
def runs(context: click.Context) -> Iterable[str]:
    """Runs of the model."""
    return _names(context, "runs")


@_offered
def cases(context: click.Context) -> Iterable[str]:
    """Load cases of the model."""
    return [*_names(context, "load_cases"), *_names(context, "combinations")]


@_offered
def poses(context: click.Context) -> Iterable[str]:
    """Poses of the model."""
    return _names(context, "poses")


@_offered
def nodes(context: click.Context) -> Iterable[str]:
    """Nodes of the model."""
    return _names(context, "nodes")


@_offered
def members(context: click.Context) -> Iterable[str]:
    """Members of the model."""
    return _names(context, *MEMBERS)


@_offered
def parts(context: click.Context) -> Iterable[str]:
    """Members, nodes and drives of the model."""
    return _names(context, *MEMBERS, "drives", "nodes")


@_offered
def drives(context: click.Context) -> Iterable[str]:
    """Drives of the model, active members included."""
    return _driven(_data(context))


@_offered
def results(context: click.Context) -> Iterable[str]:
    """Results of a pose: forces of members and drives, strains of gauges."""
    data = _data(context)
    force = [f"{name}.force" for table in MEMBERS for name in data.get(table) or {}]
    driven = [f"{name}.drive_force" for name in _driven(data)]
    return [*force, *driven, *(f"{name}.strain" for name in data.get("gauges") or {})]


@_offered
def paths(context: click.Context) -> Iterable[str]:
    """Dotted paths of the values in the model file."""
    return _leaves(_data(context))


def _leaves(table: dict[str, Any], before: str = "") -> Iterator[str]:
    for name, value in table.items():
        if isinstance(value, dict):
            yield from _leaves(value, f"{before}{name}.")
        elif before:
            yield f"{before}{name}"
