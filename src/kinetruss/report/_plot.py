"""One quantity of one or more runs over time."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError, StoreError
from kinetruss.report._draw import SUFFIXES, draw, write
from kinetruss.report._specs import Histories, Panel

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.runs import RunResult

__all__ = ["plot"]

MOST = 14
"""Curves in one picture: beyond it nobody can tell them apart."""


def plot(
    runs: Sequence[RunResult], quantity: str, file: str | Path, *, members: Sequence[str] = (), case: str | None = None
) -> Path:
    """Draw one quantity over time, of one run or several in the same picture.

    Parameters
    ----------
    quantity : a variable of a result, e.g. ``member_force``, ``length``, ``position``, ``current``.
    file : ``.png``, ``.svg`` or ``.pdf``.
    members : members, nodes, drives or supports to show; by default those with the largest values.
    case : load case; by default the first.

    Raises
    ------
    InputError : a name that no run has, or another suffix.
    StoreError : the file cannot be written.
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: pictures end in {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    figure = specification(runs, quantity, members, case)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write(draw(figure), path)
    except OSError as error:
        raise StoreError(f"{path}: the picture cannot be written ({error.strerror}).") from error
    return path


def specification(runs: Sequence[RunResult], quantity: str, members: Sequence[str], case: str | None) -> Histories:
    """What `plot` shows. Curves of several runs keep their own times only if those agree."""
    lines: dict[str, Any] = {}
    times: dict[str, Any] = {}
    unit = ""
    names = [run.path.name if run.path else run.name for run in runs]
    for k, run in enumerate(runs):
        if not run.good:
            raise InputError(f"{names[k]} has no good sample to draw.")
        data = _found(run, quantity, case)
        unit = str(data.attrs.get("units", ""))
        number = f" ({k + 1})" if names.count(names[k]) > 1 else ""
        prefix = f"{names[k]}{number}: " if len(runs) > 1 else ""
        for label, values in _curves(data, members).items():
            lines[prefix + label], times[prefix + label] = values, data["time"].values
    if not lines:
        raise InputError(f"{', '.join(map(repr, members))} is not in {quantity}. It has: {_known(runs, quantity, case)}.")
    lines, times = dict(list(lines.items())[:MOST]), dict(list(times.items())[:MOST])
    longest = max(times.values(), key=len)
    panel = Panel(quantity=quantity.replace("_", " "), unit=unit, lines=lines, times=times)
    return Histories(name=quantity, title=runs[0].model.title or runs[0].name, time=longest, panels=(panel,))


def _found(run: RunResult, quantity: str, case: str | None) -> xr.DataArray:
    """The variable of that name in any of the run's results."""
    if case is not None and case not in run.forces:
        raise InputError(f"No load case called {case!r}. There are: {', '.join(run.forces)}.")
    chosen = case or next(iter(run.forces), None)
    datasets = [run.motion.data] + [
        kind[chosen].data for kind in (run.forces, run.demand, run.sections) if chosen is not None and chosen in kind
    ]
    for data in datasets:
        if quantity in data and data[quantity].dims[:1] == ("time",):
            return data[quantity]
    known = [str(name) for data in datasets for name, one in data.data_vars.items() if one.dims[:1] == ("time",)]
    raise InputError(f"The run has no quantity called {quantity!r}. There are: {', '.join(known)}.")


def _curves(data: xr.DataArray, members: Sequence[str]) -> dict[str, Any]:
    """Label -> values (times,): one curve for every combination of names; the largest first where none is asked for."""
    flat = data.stack(curve=data.dims[1:]) if data.ndim > 1 else data.expand_dims(curve=[()], axis=1)
    curves = {}
    for k, names in enumerate(flat["curve"].values):
        words = [str(name) for name in (names if isinstance(names, tuple) else (names,))]
        if not members or (words[:1] and words[0] in members):
            curves[" ".join(words) or str(data.name)] = flat.values[:, k]
    if members:
        return curves
    return dict(sorted(curves.items(), key=lambda item: -float(abs(item[1]).max(initial=0)))[:MOST])


def _known(runs: Sequence[RunResult], quantity: str, case: str | None) -> str:
    data = _found(runs[0], quantity, case)
    return ", ".join(map(str, data[data.dims[1]].values)) if data.ndim > 1 else "one curve"
