"""Results as tables: utilisation rows, worst first; histories with one row per instant; units of drives."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from kinetruss.display import Table, instant, margin, number, quantity
from kinetruss.display.ranks import levels
from kinetruss.mechanics import cached
from kinetruss.results.arrays import Column, variable

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.elements.element import Results
    from kinetruss.kernels.compiled.record import Floats
    from kinetruss.mechanics import System
    from kinetruss.results.arrays import Columns


_NUMBERS = ("value", "limit", "utilisation", "margin", "time_of", "station", "position")
_TEXTS = ("load_case", "pose", "note")
"""Variables of the entries of a row, in its order."""
COLUMNS = ("part", "rule", "value", "limit", "utilisation", "margin", "time", "station", "load_case", "note")
_UNITS = {"value": "", "limit": "", "utilisation": "%", "position": "m"}

NOT_CHECKED = "not checked: "
"""Start of the note of an entry that lacks data for its rule."""

CABLE = "a cable does not buckle"
"""Note of a rule that asks nothing of its part. Older releases wrote it as not checked."""

SLACK = 1e-9
"""Excess over a limit, as a fraction of it, that is round-off."""


def exceeds(utilisation: float) -> bool:
    """True if a utilisation is above 1 by more than round-off: what is held at its limit does not exceed it."""
    return utilisation > 1 + SLACK


@dataclass(frozen=True, slots=True)
class Row:
    """One entry of a utilisation table.

    part : bar, active member or its ``.base`` or ``.tube``; member : the member it belongs to. rule : what was checked.
    value, limit : in `unit`. utilisation : value/limit; margin : 1/utilisation - 1 (negative: not enough). Infinite, and -1,
    for a beam-column whose compression reaches Euler's load; `note` says so.
    time : s, of the worst instant; station : fraction of the part's length from its end towards A, and position : m from end
    A (NaN if the entry has no place). pose : name of the worst pose, for forces of poses at rest.
    note : the formula used, or why it was not checked (then the numbers are NaN).
    """

    part: str
    member: str
    rule: str
    value: float
    limit: float
    unit: str
    utilisation: float
    margin: float
    time: float
    station: float = math.nan
    position: float = math.nan
    load_case: str = ""
    pose: str = ""
    note: str = ""

    @property
    def checked(self) -> bool:
        """False for an entry that lacks data for its rule; `note` says which."""
        return not math.isnan(self.utilisation)

    @property
    def status(self) -> Literal["kept", "exceeded", "not checked", "not asked"]:
        """Whether its limit is kept. ``not asked`` : there is no limit, or the rule does not apply; `note` says so."""
        if self.checked:
            return "exceeded" if exceeds(self.utilisation) else "kept"
        return "not checked" if self.note.startswith(NOT_CHECKED) and self.note != NOT_CHECKED + CABLE else "not asked"

    @property
    def place(self) -> str:
        """``M7, voltage: 93.1 % at 6.55 s, gust``: how much is used, when, and under which load case if there are several."""
        case = f", {self.load_case}" if self.load_case not in ("", "all") else ""
        when = f", pose {self.pose}" if self.pose else f" at {instant(self.time)}" if math.isfinite(self.time) else ""
        return f"{self.part}, {self.rule}: {quantity(self.utilisation, '%')}{when}{case}"

    @property
    def text(self) -> str:
        """``crank, yield: 3.6 % (8.451 MPa of 235 MPa)``; of an entry not checked its note."""
        if not self.checked:
            return f"{self.part}, {self.rule}: {self.note}"
        if math.isinf(self.utilisation) and self.note:
            return f"{self.part}, {self.rule}: {self.note}"
        given = f"{self.part}, {self.rule}: {quantity(self.utilisation, '%')}"
        return f"{given} ({quantity(self.value, self.unit)} of {quantity(self.limit, self.unit)})" if self.unit else given

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.text}>"


def rows_of(data: xr.Dataset | Columns, subject: str, rule: str, *, timed: bool = True) -> list[Row]:
    """Rows from arrays over (subject, rule), highest utilisation first, entries not checked last. An infinite one, of a
    beam-column beyond Euler's load, follows the finite one of its part that says by how much the limit is exceeded.

    Entries that do not apply (NaN without a note) are omitted. timed : False for one pose at rest, whose time says nothing.

    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> rows = kt.results.rows_of(kt.strength.check(model, forces).data, "part", "rule")
    >>> [(row.part, row.rule) for row in rows[:2]]
    [('strut', 'buckling'), ('strut', 'beam-column')]
    """
    parts, rules = data[subject].values.tolist(), [str(name) for name in data[rule].values]
    count = len(parts)
    members = data["member"].values.tolist() if "member" in data else parts
    units = data["unit"].values.tolist() if "unit" in data else [""] * len(rules)
    # read whole arrays: reading single values from a dataset takes a hundred times as long
    numbers = {key: _column(data, key, count, len(rules), math.nan) for key in _NUMBERS}
    texts = {key: _column(data, key, count, len(rules), "") for key in _TEXTS}
    if not timed:
        numbers["time_of"] = [math.nan] * (count * len(rules))
    share, note = numbers["utilisation"], texts["note"]
    rows = [
        Row(parts[k // len(rules)], members[k // len(rules)], rules[k % len(rules)], value, limit, units[k % len(rules)], *more)
        for k, (value, limit, *more) in enumerate(zip(*numbers.values(), *texts.values(), strict=True))
        if note[k] or not math.isnan(share[k])
    ]
    of: dict[str, list[float]] = {row.part: [] for row in rows if math.isinf(row.utilisation)}
    for row in rows:
        if row.part in of:
            of[row.part].append(row.utilisation)
    most = {part: most_used(values) for part, values in of.items()}
    used = [most[row.part] if math.isinf(row.utilisation) else row.utilisation if row.checked else 0.0 for row in rows]
    level = levels(used)

    def worst_first(k: int) -> tuple[bool, int, str, bool]:
        row = rows[k]
        # rows of one part stay together where one of them is infinite
        together = used[k] == most.get(row.part)
        return not row.checked, level[k], row.part if together else "", math.isinf(row.utilisation)

    return [rows[k] for k in sorted(range(len(rows)), key=worst_first)]


def most_used(values: Iterable[float]) -> float:
    """The highest of the utilisations of a part, NaN if none is known. An infinite one, of a beam-column beyond Euler's load,
    gives way to a finite one from 1 on: that of buckling says by how much.

    >>> most_used([0.3, math.inf, 1.29]), most_used([0.3, math.inf]), most_used([math.nan])
    (1.29, inf, nan)
    """
    known = [value for value in values if not math.isnan(value)]
    finite = max((value for value in known if math.isfinite(value)), default=math.nan)
    return finite if finite >= 1 or not known else max(known)


def _column(data: xr.Dataset | Columns, key: str, count: int, rules: int, missing: Any) -> list[Any]:
    """Values over (subject, rule), those of one subject behind those of the one before."""
    if key not in data:
        return [missing] * (count * rules)
    values = data[key].values
    found: list[Any] = values.astype(float if isinstance(missing, float) else str, copy=False).reshape(-1).tolist()
    return found


def row_text(rows: Iterable[Row], columns: tuple[str, ...] = COLUMNS) -> str:
    """Rows as plain text, one line each, below a head line; ``-`` if there is no value.

    >>> print(row_text([Row(part="M6", member="M6", rule="yield", value=1.2e6, limit=2.4e8, unit="Pa", utilisation=0.005,
    ...                     margin=199.0, time=0.5, station=1.0)], ("part", "rule", "value", "utilisation", "margin")))
    part  rule     value  utilisation  margin
    M6    yield  1.2 MPa        0.5 %   > 100
    """
    return Table(columns, [[_cell(row, name) for name in columns] for row in rows]).text


def _cell(row: Row, column: str) -> str:
    value = getattr(row, column)
    if column in _UNITS:
        return quantity(value, _UNITS[column] or row.unit)
    if column == "margin":
        return margin(value)
    return number(value) if isinstance(value, float) else value or "-"


# Units of drives, couplings and elements on coordinates: those of lengths or of angles; where a structure has both, one for
# each.

Found = tuple[str, dict[str, tuple[str, list[str]]]]


def unit_along(axis: str, units: Sequence[str], name: str, none: str) -> Found:
    """The unit of values along an axis: that of all entries; or, where they differ, the name of a coordinate of units.

    units : of the entries. name : of that coordinate. none : the unit where there are no entries.

    >>> unit_along("drive", ["N", "N"], "drive_force_unit", "N")
    ('N', {})
    >>> unit_along("drive", ["N", "N m"], "drive_force_unit", "N")
    ('drive_force_unit', {'drive_force_unit': ('drive', ['N', 'N m'])})
    """
    if len(set(units)) < 2:
        return (units[0] if units else none), {}
    return name, {name: (axis, list(units))}


@cached(of_records=True)
def drive_unit(system: System) -> Found:
    """The unit of the positions of drives, as of `unit_along`."""
    return unit_along("drive", [_unit(system.model.all_drives.get(name)) for name in system.drives], "drive_unit", "m")


@cached()
def force_units(system: System, *axes: str) -> tuple[dict[str, str], dict[str, tuple[str, list[str]]]]:
    """The units of the forces of ``drive``, ``coupling`` and each kind of elements on coordinates, as ``spring``, and of their
    values, as ``spring_value``; and the coordinates that they name, with those that mark parts of supports.

    axes : of the coordinates; by default all. A coupling and an element have the unit of their first coordinate.
    """
    model, own = system.model, coordinate_axes(system)
    firsts = {
        "drive": [_unit(model.all_drives.get(name)) for name in system.drives],
        "coupling": [_unit(one.terms[0][0]) for one in model.couplings.values()],
        **{kind: [_unit(model.force_elements[name][1].parts[0][0]) for name in names] for kind, names in own.items()},
    }
    found = {
        axis: unit_along(axis, [_force(one) for one in units], f"{axis}_force_unit", "N") for axis, units in firsts.items()
    }
    found |= {f"{kind}_value": unit_along(kind, firsts[kind], f"{kind}_unit", "m") for kind in own}
    named: dict[str, Any] = {name: one for _, coordinate in found.values() for name, one in coordinate.items()}
    # couplings, springs and stops of supports stand in their reactions
    of_supports = {
        name for name, owner in {**system.inner.couplings, **system.inner.elements}.items() if owner.table == "supports"
    }
    for axis, names in {"coupling": list(model.couplings), **own}.items():
        if any(inner := [name in of_supports for name in names]):
            named[f"inner_{axis}"] = (axis, inner)
    units = {axis: unit for axis, (unit, _) in found.items()}
    return units, {name: one for name, one in named.items() if one[0] in (axes or firsts)}


@cached()
def element_axes(system: System) -> dict[str, list[str]]:
    """Axes of the kinds of elements with results that a system has, with the names of their elements."""
    from kinetruss.mechanics.elements import element_results

    return coordinate_axes(system) | {one.kind: list(one.names) for one in element_results(system, system.x0[None])}


def coordinate_axes(system: System) -> dict[str, list[str]]:
    """Of `element_axes` those of elements on coordinates."""
    return {kind: list(system.force_elements[own]) for kind, own in system.force_element_spans.items()}


def element_columns(system: System, per: tuple[str, ...], force: Floats, value: Floats | None = None) -> dict[str, Column]:
    """Variables of the elements on coordinates, from their forces and, if given, values of these, (..., force_elements)."""
    units, found = force_units(system)[0], dict[str, Column]()
    for kind, own in system.force_element_spans.items():
        if value is not None:
            words = f"coordinate of the {kind}"
            found[f"{kind}_value"] = variable((*per, kind), value[..., own], units[f"{kind}_value"], words)
        words = f"force or torque of the {kind} on its coordinate"
        found[f"{kind}_force"] = variable((*per, kind), force[..., own], units[kind], words)
    return found


def other_columns(
    system: System, per: tuple[str, ...], x: Floats, v: Floats | None = None, t: Floats | None = None
) -> dict[str, Column]:
    """Variables of the elements that are not on coordinates, along x, v (times, n, 3) and t (times,); without v at rest."""
    from kinetruss.mechanics.elements import element_results

    return _columns(system, per, element_results(system, x, v, t))


def displaced_columns(system: System, x: Floats, u: Floats) -> tuple[dict[str, Column], dict[str, list[str]]]:
    """The same with small displacements u from x, both (n, 3), as far as kinds of elements have them; and their axes."""
    from kinetruss.mechanics.elements import displaced_results

    results = displaced_results(system, x, u)
    return _columns(system, (), results), {one.kind: list(one.names) for one in results}


def _columns(system: System, per: tuple[str, ...], results: Iterable[Results]) -> dict[str, Column]:
    found = {}
    for one in results:
        for name, (values, unit, words) in one.values.items():
            vectors = values.ndim == 3
            values = values[..., : system.dim] if vectors else values
            dims = (*per, one.kind, "axis") if vectors else (*per, one.kind)
            found[f"{one.kind}_{name}"] = variable(dims, values if per else values[0], unit, words)
    return found


def _unit(coordinate: Any) -> str:
    """The unit of a coordinate as a drive would move it."""
    kind = getattr(coordinate, "kind", "length")
    return "rad" if kind in ("angle", "hinge") else "1" if kind == "cosine" else "m"


def _force(unit: str) -> str:
    return "N" if unit == "m" else "N m"


# Histories as one table: one row per instant, one column per value.


def wide(data: xr.Dataset) -> Any:
    """A pandas table of a dataset along time, with a column for every value of an instant; without time one row per name.

    An empty dimension (no supports, no active members) has no columns and does not affect the others.
    """
    import importlib

    import numpy as np

    pd = importlib.import_module("pandas")  # pandas comes with xarray; its types are in a separate package

    if "time" not in data.dims:
        return data.drop_vars([name for name, one in data.data_vars.items() if not one.size]).to_dataframe()
    kept = {str(key): one for key, one in data.data_vars.items() if one.dims[:1] == ("time",)}
    heads = [f"{key}[{','.join(names)}]" if names else key for key, one in kept.items() for names in labels(one)]
    if "pose" in data.coords:
        index = pd.Index(data["pose"].values.astype(str), name="pose")
    else:
        index = pd.Index(data["time"].values, name="time")
    columns = [flat(one) for one in kept.values()]
    values = np.hstack(columns) if columns else np.empty((len(index), 0))
    return pd.DataFrame(values, index=index, columns=heads)


def flat(data: xr.DataArray) -> Any:
    """A history as (times, values), in the order of `labels`."""
    return data.values.reshape(data.shape[0], math.prod(data.shape[1:]))


def labels(data: xr.DataArray) -> Iterator[tuple[str, ...]]:
    """Names of the values of one instant, in the order of the flat array."""
    return itertools.product(*([_label(value) for value in data[dim].values] for dim in data.dims[1:]))


def units_of(data: xr.DataArray) -> Iterator[str]:
    """Units of the values of one instant, in the order of `labels`; the name of a coordinate stands for its entries."""
    text = str(data.attrs.get("units", ""))
    named = [name for name in re.findall(r"\w+_unit\b", text) if name in data.coords and data[name].dims]
    for place in itertools.product(*(range(size) for size in data.shape[1:])):
        unit, at = text, dict(zip(data.dims[1:], place, strict=True))
        for name in named:
            unit = unit.replace(name, str(data[name].values[at[data[name].dims[0]]]))
        yield unit


def _label(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)
