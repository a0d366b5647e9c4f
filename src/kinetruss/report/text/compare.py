"""The largest values of quantities across runs, as a table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, number, quantity
from kinetruss.errors import InputError
from kinetruss.report._page import Page
from kinetruss.report.pictures.quantities import Curve, curves, quantities
from kinetruss.report.run_text.columns import poses_of
from kinetruss.report.text.labels import run_labels

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["Maximum", "compare"]

USUAL = ("von_mises", "thrust", "drive_velocity", "motor_torque", "current", "voltage")
HEAD = ("quantity", "of", "run", "maximum", "time", "at rest", "time", "ratio")


@dataclass(frozen=True, slots=True, kw_only=True)
class Maximum:
    """The value of largest magnitude of one quantity in one run.

    run : label. of : member, node, drive. maximum : in `unit`, with its sign, at `time` (s). static_maximum, static_time :
    the same of the poses at rest (None: there are none). pose, static_pose : names of the poses of a run of poses,
    whose times are their numbers. ratio : maximum over static maximum, of the magnitudes.
    motion_maximum, motion_time : largest magnitude of the difference of the two.
    """

    run: str
    path: str | None
    settings: dict[str, str]
    quantity: str
    of: str
    unit: str
    maximum: float
    time: float
    static_maximum: float | None = None
    static_time: float | None = None
    ratio: float | None = None
    motion_maximum: float | None = None
    motion_time: float | None = None
    pose: str = ""
    static_pose: str = ""


def compare(
    runs: Sequence[RunResult],
    quantity: str | Sequence[str] = (),
    *,
    members: Sequence[str] = (),
    case: str | None = None,
    station: float | None = None,
) -> Page:
    """The largest values of quantities across runs.

    Parameters
    ----------
    quantity : as for `plot`; by default von Mises stress, actuator force, drive rate, motor torque, current and voltage, if all
    runs have them.
    members, case, station : as for `plot`. Without members, the largest value over all members of each run is used.

    Returns
    -------
    A page with one `Maximum` per quantity, member and run, in this order.

    Raises
    ------
    InputError : a name that no run has; no quantity that all runs have.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> light, heavy = kt.run(model), kt.run(kt.io.set_values(model, {"nodes.C.mass": 1.0}))
    >>> page = kt.report.compare([light, heavy], "drive_force")
    >>> [row[:3] for row in page.rows[1:]]
    [['mass 500 g', 'drive_force', 'motor'], ['mass 1 kg', 'drive_force', 'motor']]
    """
    names = quantities([quantity] if isinstance(quantity, str) else quantity)
    labels = run_labels(runs)
    found: list[Maximum] = []
    for name in names or USUAL:
        try:
            groups = [curves(run, name, members, case, station) for run in runs]
        except InputError:
            if names:
                raise
            continue
        if not names and not any(np.nan_to_num(one.values).any() for group in groups for one in group):
            continue
        chosen = [group if members else [max(group, key=_size)] for group in groups]
        order = list(dict.fromkeys(one.of for group in chosen for one in group)) if members else [None]
        for of in order:
            for run, label, group in zip(runs, labels, chosen, strict=True):
                found += [_maximum(run, label, name, one) for one in group if of in (None, one.of)]
    if not found:
        raise InputError(f"The runs have none of {', '.join(USUAL)} of {', '.join(members) or 'all'}. Name a --quantity.")
    return Page(found=found, as_record=_records, as_text=_text, as_rows=_rows)


def _text(found: Sequence[Maximum]) -> str:
    """A table, the runs of one quantity below each other."""
    posed = all(one.pose for one in found)
    return Table(["pose" if posed and name == "time" else name for name in HEAD], map(_cells, found)).text


def _records(found: Sequence[Maximum]) -> list[dict[str, Any]]:
    return [{name: getattr(one, name) for name in one.__slots__} for one in found]


def _rows(found: Sequence[Maximum]) -> Iterator[list[Any]]:
    """In SI units, one column a setting."""
    settings = list(dict.fromkeys(name for one in found for name in one.settings))
    fields = [name for name in Maximum.__slots__ if name not in ("settings", "path")]
    yield [*settings, *fields]
    for one in found:
        values = [getattr(one, name) for name in fields]
        yield [*(one.settings.get(name, "") for name in settings), *("" if v is None else v for v in values)]


def _size(curve: Curve) -> float:
    return float(np.nanmax(np.abs(curve.values)))


def _largest(values: Any, time: Any) -> tuple[float, float]:
    at = int(np.nanargmax(np.abs(values)))
    return float(values[at]), float(time[at])


def _maximum(run: RunResult, label: str, name: str, curve: Curve) -> Maximum:
    value, when = _largest(curve.values, curve.time)
    rest: dict[str, Any] = {}
    poses = poses_of(run)
    if curve.static is not None:
        held, held_when = _largest(curve.static, curve.time)
        moved, moved_when = _largest(curve.values - curve.static, curve.time)
        rest = {
            "static_maximum": held,
            "static_time": held_when,
            "static_pose": poses[round(held_when)] if poses else "",
            "ratio": abs(value / held) if held else None,
            "motion_maximum": moved,
            "motion_time": moved_when,
        }
    return Maximum(
        run=label,
        path=None if run.path is None else str(run.path),
        settings=dict(run.settings),
        quantity=name,
        of=curve.of,
        unit=curve.unit,
        maximum=value,
        time=when,
        pose=poses[round(when)] if poses else "",
        **rest,
    )


def _cells(one: Maximum) -> tuple[str, ...]:
    rest = ("-", "-", "-")
    if one.static_maximum is not None:
        ratio = "-" if one.ratio is None else number(one.ratio, 4)
        rest = (quantity(one.static_maximum, one.unit), one.static_pose or instant(one.static_time), ratio)
    return one.quantity, one.of or "-", one.run, quantity(one.maximum, one.unit), one.pose or instant(one.time), *rest
