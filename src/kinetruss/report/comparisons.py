"""Runs and models beside each other: the largest values of quantities, one structure with two kinds of joints."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, quantity
from kinetruss.display.ranks import largest, largest_first, place_of_largest
from kinetruss.display.tables import Column, measured, mixed, seconds, words
from kinetruss.errors import InputError
from kinetruss.io.values import resolved
from kinetruss.model import Of, Record, turns
from kinetruss.model.members import Brace
from kinetruss.report.page import Page
from kinetruss.report.pictures.quantities import Curve, curves, quantities
from kinetruss.report.run_data import entry
from kinetruss.results.records import check_samples
from kinetruss.runs.doubts import poses_of
from kinetruss.runs.variant_sets import short_paths
from kinetruss.strength import sections, stresses
from kinetruss.units import EITHER, NUMBER, unit_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.report.entries import Entry
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult


MOST = 2
"""Largest number of differences in a label; if models differ more, the name of the run's folder is used."""


def run_labels(runs: Sequence[RunResult]) -> list[str]:
    """One label per run: settings that differ, else differences of the models, else names of folders or runs."""
    if len(runs) == 1:
        return [runs[0].path.name if runs[0].path else runs[0].name]
    found = _by_values(runs, [run.settings for run in runs]) if all(run.settings for run in runs) else None
    if found is None:
        found = _by_values(runs, [_leaves(run.model.model_dump(exclude={"title"})) for run in runs], MOST)
    return found or _numbered([run.path.name if run.path else run.name for run in runs])


def _by_values(runs: Sequence[RunResult], tables: Sequence[Mapping[str, Any]], most: int = 10) -> list[str] | None:
    """Labels from the values that differ between tables; None if they do not distinguish the runs."""
    if len({tuple(table) for table in tables}) > 1:
        return None
    differing = [path for path in tables[0] if len({str(table[path]) for table in tables}) > 1]
    if not 0 < len(differing) <= most:
        return None
    keys = short_paths(differing)
    labels = [
        ", ".join(f"{keys[path].replace('_', ' ')} {_with_unit(run.model, path, str(table[path]))}" for path in differing)
        for run, table in zip(runs, tables, strict=True)
    ]
    return labels if len(set(labels)) == len(labels) else None


def _with_unit(model: Model, path: str, value: str) -> str:
    """A bare number with the SI unit of its field."""
    if not NUMBER.fullmatch(value):
        return value
    here: Any = model
    unit = ""
    try:
        for key in resolved(model, path):
            if isinstance(here, Record):
                rules = [rule for rule in type(here).model_fields[str(key)].metadata if isinstance(rule, Of)]
                unit = unit_of(rules[0].quantity) if rules and rules[0].quantity not in EITHER else ""
                here = getattr(here, str(key))
            else:
                here = here[key]
    except (KeyError, IndexError, ValueError):
        return value  # a parameter of a library model: the value as it was given
    return quantity(float(value), unit, 6)


def _leaves(value: Any, path: str = "") -> dict[str, Any]:
    """Every value of nested tables by its dotted path."""
    if isinstance(value, Mapping):
        items: Any = value.items()
    elif isinstance(value, (list, tuple)) and len(value) <= 10:
        items = enumerate(value)
    else:
        return {path: value}
    found: dict[str, Any] = {}
    for key, below in items:
        found |= _leaves(below, f"{path}.{key}" if path else str(key))
    return found


def _numbered(names: Sequence[str]) -> list[str]:
    """Names, with a number if one occurs more than once."""
    return [f"{name} ({k + 1})" if names.count(name) > 1 else name for k, name in enumerate(names)]


# The largest values of quantities across runs, as a table.

USUAL = ("von_mises", "thrust", "drive_velocity", "motor_torque", "current", "voltage")


@dataclass(frozen=True, slots=True, kw_only=True)
class Maximum:
    """The value of largest magnitude of one quantity in one run.

    run : label. of : member, node, drive. maximum : in `unit`, with its sign, at `time` (s). static_maximum, static_time :
    the same of the poses at rest (None: there are none). pose, static_pose : names of the poses of a run of poses,
    whose times are their numbers. ratio : maximum over static maximum, of the magnitudes.
    motion_maximum, motion_time : largest magnitude of the difference of the two. partial : why the run is not that which was
    asked for, so that a larger value may be missing.
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
    partial: str = ""


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
        chosen = [group if members else [largest(group, lambda one: float(np.nanmax(np.abs(one.values))))] for group in groups]
        order = list(dict.fromkeys(one.of for group in chosen for one in group)) if members else [None]
        for of in order:
            for run, label, group in zip(runs, labels, chosen, strict=True):
                found += [_maximum(run, label, name, one) for one in group if of in (None, one.of)]
    if not found:
        raise InputError(f"The runs have none of {', '.join(USUAL)} of {', '.join(members) or 'all'}. Name a --quantity.")
    return Page(found=found, as_record=_records, as_entries=_entries, as_rows=_rows)


def _entries(found: Sequence[Maximum]) -> list[Entry]:
    """A table, the runs of one quantity below each other."""
    columns = [
        words("quantity"),
        words("of", lambda one: one.of or "-"),
        words("run"),
        mixed("maximum", "maximum"),
        _when(found, "pose", "time"),
        mixed("at rest", "static_maximum"),
        _when(found, "static_pose", "static_time"),
        measured("ratio"),
    ]
    short = dict.fromkeys(f"warning: {one.run}: {one.partial}" for one in found if one.partial)
    return [Table(columns, found), *short]


def _when(found: Sequence[Maximum], pose: str, time: str) -> Column:
    """Times, or names of poses."""
    if not any(getattr(one, pose) for one in found):
        return seconds("time", time)
    head = "pose" if all(one.pose for one in found) else "time"
    return words(head, lambda one: getattr(one, pose) or instant(getattr(one, time)))


def _records(found: Sequence[Maximum | Both]) -> list[dict[str, Any]]:
    return [entry(one) for one in found]


def _rows(found: Sequence[Maximum]) -> Iterator[list[Any]]:
    """In SI units, one column a setting."""
    settings = list(dict.fromkeys(name for one in found for name in one.settings))
    fields = [name for name in Maximum.__slots__ if name not in ("settings", "path")]
    yield [*settings, *fields]
    for one in found:
        values = [getattr(one, name) for name in fields]
        yield [*(one.settings.get(name, "") for name in settings), *("" if v is None else v for v in values)]


def _largest(values: Any, time: Any) -> tuple[float, float]:
    at = place_of_largest(np.abs(values))
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
        partial=run.partial,
        **rest,
    )


# Two models of one structure in one table: ideal joints beside hubs, friction, compliance.

ROUND_OFF = 1e-12
"""Share of the largest value of a quantity up to which another one is round-off."""
UNITS = {"member_force": "N", "drive_force": "N", "von_mises": "Pa", "position": "m"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Both:
    """One quantity of one member, drive, part or node in both models.

    ideal, real : the values of largest magnitude along the motion, with sign; None for places. difference : the largest
    difference at one instant; of places the largest distance. ratio : of the magnitudes, real over ideal; None if that is
    round-off beside the largest of the quantity.
    """

    quantity: str
    of: str
    unit: str
    ideal: float | None
    real: float | None
    difference: float
    ratio: float | None


def beside(ideal: tuple[Model, Forces], real: tuple[Model, Forces]) -> Page:
    """Forces, stresses and places of two models of one structure, by the names that both have.

    Parameters
    ----------
    ideal, real : a model and its forces, from `dynamics.inverse`, at the same instants. The second may have hubs, bearings and
        what else is real.

    Returns
    -------
    A page with one `Both` per quantity and name, those of each quantity by falling difference: ``member_force`` (mean over the
    length, N), ``drive_force`` (N or N m), ``von_mises`` (largest over the stations of a part, Pa), ``position`` (m).

    Raises
    ------
    InputError : other instants; nothing in common.

    >>> import kinetruss as kt
    >>> arm = kt.Model(nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=3)}, fixed=["O"], bars={"arm": ("O", "A")},
    ...                drives={"turn": kt.AngleDrive("arm")}, gravity=(0, -9.81))
    >>> rough = arm.with_(bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.03, friction=0.2)})
    >>> motion = kt.kinematics.follow(arm, kt.ConstantRate(rates={"turn": 1}, duration=0.5), samples=3)
    >>> found = kt.report.beside(*((one, kt.dynamics.inverse(one, motion)) for one in (arm, rough)))
    >>> print(found.text.splitlines()[2])
    drive_force   turn  14.71 N m  14.89 N m  176.8 mN m  1.012
    """
    (one, first), (two, second) = ideal, real
    check_samples(first)
    if not np.array_equal(first.arrays["time"].values, second.arrays["time"].values):
        raise InputError("The two have other instants. Follow the same trajectory with the same samples.")
    found: list[Both] = []
    for name, axis in (("member_force", "member"), ("drive_force", "drive")):
        pair = [_columns(forces.arrays[axis].values, forces.arrays[name].values) for forces in (first, second)]
        found += _both(name, pair)
    moments = {name for name, drive in one.all_drives.items() if turns(drive)}
    found = [replace(row, unit="N m") if row.quantity == "drive_force" and row.of in moments else row for row in found]
    braces = {name for model in (one, two) for name, bar in model.whole.bars.items() if isinstance(bar, Brace)}
    found = [row for row in found if row.of not in braces]
    found += _both("von_mises", [_stress(model, forces) for model, forces in (ideal, real)])
    places = [
        _columns(forces.motion.arrays["node"].values, forces.motion.arrays["position"].values) for forces in (first, second)
    ]
    found += _both("position", places)
    if not found:
        raise InputError("The two models have no member, drive or node in common.")
    return Page(found=found, as_record=_records, as_entries=_beside_entries, as_rows=_beside_rows)


def _stress(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Largest von Mises stress over the stations of every part with a section, (times,) Pa."""
    data = stresses(model, sections(model, forces)).von_mises
    values = data.values.max(axis=2)
    return {name: values[:, k] for k, name in enumerate(data["part"].values.tolist()) if np.isfinite(values[:, k]).all()}


def _columns(names: Any, values: Any) -> dict[str, NDArray[np.float64]]:
    return {name: values[:, k] for k, name in enumerate(names.tolist())}


def _both(name: str, pair: Sequence[dict[str, NDArray[np.float64]]]) -> list[Both]:
    """The rows of one quantity, by falling difference."""
    rows = []
    largest = max((float(np.abs(values).max()) for values in pair[0].values()), default=0.0)
    for of in pair[0]:
        if of not in pair[1]:
            continue
        one, two = pair[0][of], pair[1][of]
        if one.ndim == 2:
            away = float(np.linalg.norm(two - one, axis=1).max())
            rows.append(Both(quantity=name, of=of, unit="m", ideal=None, real=None, difference=away, ratio=None))
            continue
        first, second = (float(values[np.argmax(np.abs(values))]) for values in (one, two))
        rows.append(
            Both(
                quantity=name,
                of=of,
                unit=UNITS[name],
                ideal=first,
                real=second,
                difference=float(np.abs(two - one).max()),
                ratio=abs(second / first) if abs(first) > ROUND_OFF * largest else None,
            )
        )
    return largest_first(rows, lambda row: row.difference)


def _beside_entries(found: Sequence[Both]) -> list[Entry]:
    values = [mixed(name, name) for name in ("ideal", "real", "difference")]
    columns = [words("quantity"), words("of"), *values, measured("ratio")]
    return [Table(columns, found)]


def _beside_rows(found: Sequence[Both]) -> Iterator[list[Any]]:
    yield list(Both.__slots__)
    for one in found:
        yield ["" if getattr(one, name) is None else getattr(one, name) for name in Both.__slots__]
