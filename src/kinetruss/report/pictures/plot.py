"""Quantities of one or more runs over time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.report.pictures.draw import SCREEN, SUFFIXES, draw, write
from kinetruss.report.pictures.picture import width_of
from kinetruss.report.pictures.quantities import COMPONENTS, Curve, curves, quantities
from kinetruss.report.pictures.specs import Histories, Panel
from kinetruss.report.text.labels import run_labels

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["plot"]

MOST = 14
"""Largest number of curves in one panel that can be distinguished."""

LIMITS = {"motor_torque": "max_torque", "current": "max_current", "voltage": "max_voltage", "motor_speed": "max_speed"}


def plot(
    runs: RunResult | Sequence[RunResult],
    quantity: str | Sequence[str],
    file: str | Path,
    *,
    members: Sequence[str] = (),
    case: str | None = None,
    station: float | None = None,
    width: str | float | None = None,
) -> Path:
    """Draw quantities over time, for one run or several in the same picture; dashed: the same poses at rest.

    Parameters
    ----------
    runs : one or several.
    quantity : a result by name, e.g. ``von_mises``, ``member_force``, ``drive_position``, ``current``; several give panels
    above each other, as do ``motion``, ``components`` and ``drive``.
    file : ``.png``, ``.svg`` or ``.pdf``.
    members : members, nodes, drives or supports to show; by default those with the largest values.
    case : load case; by default the first.
    station : fraction of a member's length from its end towards A, for stresses and section forces; by default stresses
        take their largest value along the member, signed ones the station where they are largest.
    width : mm, or ``column`` (90 mm), ``page`` (190 mm): for print, with letters of 7 and 8 points, the legend below and no
        title; by default for a screen.

    Raises
    ------
    InputError : a name that no run has (the message offers the nearest), or an unknown suffix.
    StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.plot([kt.run(model)], "member_force", f"{folder}/forces.svg", members=["coupler"]).name
    'forces.svg'
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: pictures end in {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    figure = specification(runs if isinstance(runs, Sequence) else [runs], quantity, members, case, station)
    if width is not None:
        figure = replace(figure, width=width_of(width))
    write(draw(figure), path, dots=SCREEN if width is None else 300)
    return path


def specification(
    runs: Sequence[RunResult],
    quantity: str | Sequence[str],
    members: Sequence[str] = (),
    case: str | None = None,
    station: float | None = None,
) -> Histories:
    """The specification of `plot`. Curves keep their own times; the axis covers the longest."""
    wanted = quantities([quantity] if isinstance(quantity, str) else quantity)
    labels = run_labels(runs)
    panels, shown = [], []
    for name in wanted:
        try:
            found = [curves(run, name, members, case, station) for run in runs]
        except InputError:
            if name in COMPONENTS and len(wanted) > 1 and name != COMPONENTS[0]:
                continue  # in the plane there are three of the five components
            raise
        shown.append([_largest(one, len(runs)) for one in found])
        panels.append(_panel(runs, labels, name, shown[-1]))
    longest = max((one.time for group in shown for found in group for one in found), key=lambda time: float(time[-1]))
    return Histories(name="_".join(wanted), title=_title(runs, wanted, shown), time=longest, panels=tuple(panels))


def _panel(runs: Sequence[RunResult], labels: Sequence[str], name: str, found: Sequence[Sequence[Curve]]) -> Panel:
    alone = _of(found) is not None
    lines: dict[str, Any] = {}
    dashed: dict[str, Any] = {}
    times: dict[str, Any] = {}
    for run_label, group in zip(labels, found, strict=True):
        for one in group:
            label = _label(run_label, one.of, len(runs) > 1, alone)
            lines[label], times[label] = one.values, one.time
            if one.static is not None:
                dashed[label] = one.static
    return Panel(
        quantity=name.replace("_", " ").replace("mises", "Mises"),
        unit=found[0][0].unit,
        lines=lines,
        dashed=dashed,
        times=times,
        limit=_limit(runs, name, {one.of for group in found for one in group}),
    )


def _label(run: str, of: str, several: bool, alone: bool) -> str:
    if several:
        return run if alone else f"{run}: {of}"
    return of or run


def _title(runs: Sequence[RunResult], wanted: Sequence[str], found: Sequence[Sequence[Sequence[Curve]]]) -> str:
    """The quantity, and its subject if all panels have the same."""
    names = {_of(group) for group in found}
    of = next(iter(names)) if len(names) == 1 else None
    titles = {run.model.title or run.name for run in runs}
    what = found[0][0][0].words[:1].upper() + found[0][0][0].words[1:] if len(wanted) == 1 else ""
    title = next(iter(titles)) if len(titles) == 1 and not (what and of) else ""
    parts = [what or title, of or "", title if what else ""]
    return ": ".join(part for part in parts if part)


def _of(found: Sequence[Sequence[Curve]]) -> str | None:
    """The subject of all curves, if they have the same."""
    names = {one.of for group in found for one in group}
    return next(iter(names)) if len(names) == 1 else None


def _largest(found: list[Curve], runs: int) -> list[Curve]:
    """The largest curves, as many as can be distinguished, in their original order."""
    most = max(1, MOST // runs)
    if len(found) <= most:
        return found
    ranked = sorted(found, key=lambda one: -float(abs(one.values).max(initial=0)))[:most]
    return [one for one in found if one in ranked]


def _limit(runs: Sequence[RunResult], name: str, members: set[str]) -> float | None:
    """The limit of the motors shown, if it is the same for all."""
    if name not in LIMITS:
        return None
    found = set()
    for run in runs:
        for member in members & set(run.model.actuators):
            motor = run.model.actuators[member].motor
            record = run.model.motors[motor] if isinstance(motor, str) else motor
            found.add(None if record is None else getattr(record, LIMITS[name]))
    return found.pop() if len(found) == 1 else None
