"""Histories from tables: nodes, drives, strains."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault, ModelError, few
from kinetruss.io.csv_tables import Table, read_table
from kinetruss.io.yaml_text import MAX_SIZE
from kinetruss.model import Measured, Model, nearest
from kinetruss.units import Tagged

if TYPE_CHECKING:
    from numpy.typing import NDArray


AGREE = 1e-4
"""Tolerance of fixed nodes: distance of table and model as a fraction of the model's size."""


MAX_HISTORY = 2_000_000_000
_KINDS = {"": ("position", "length"), "v": ("velocity", "speed"), "a": ("acceleration", "acceleration")}


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class NodeHistory:
    """Positions of nodes over time, and optionally velocities and accelerations, SI.

    times (n_times,) s; nodes: names; position (n_times, n_nodes, dim) m; velocity m/s and acceleration m/s^2 of the same
    shape, or None if the file has none; source: the file.
    """

    times: NDArray[np.float64]
    nodes: tuple[str, ...]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64] | None
    acceleration: NDArray[np.float64] | None
    source: str


def read_history(
    path: str | Path, *, dim: int | None = None, nodes: Iterable[str] | None = None, max_size: int = MAX_HISTORY
) -> NodeHistory:
    r"""Read a node-history CSV: columns ``t``, ``NODE.x``, ``NODE.y``[, ``NODE.z``], ``NODE.vx`` .., ``NODE.ax`` ..

    Parameters
    ----------
    path : the file; a header may carry a unit, ``N4.x [mm]``, and is SI without one.
    dim : number of axes; if None, found from the columns. nodes : allowed names; if None, any.
    max_size : bytes; a larger file is refused before it is read.

    Raises
    ------
    ModelError : all faults of the table, each with file, line and column: unknown nodes, columns missing, cells that are not a
    number, time that decreases.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> table = "t,B.x [mm],B.y [mm],B.vx,B.vy,B.ax,B.ay\n0,2000,0,0,0,0,0\n1,2000,0,0,0,0,0\n"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "motion.csv")
    ...     _ = file.write_text(table)
    ...     history = kt.io.read_history(file)
    >>> history.nodes, history.position[0].tolist()  # m
    (('B',), [[2.0, 0.0]])
    """
    known = None if nodes is None else frozenset(nodes)
    table = read_table(Path(path), lambda name: _quantity(name, known), max_size=max_size)
    names = tuple(dict.fromkeys(_parts(name)[0] for name in table.columns))
    axes = "xyz"[: dim or (3 if any(_parts(name)[1:] == ("", "z") for name in table.columns) else 2)]
    if faults := _missing(table, names, axes) + _surplus(table, axes):
        raise ModelError(faults)
    arrays = {
        kind: np.stack([np.stack([table.columns[f"{n}.{prefix}{a}"].values for a in axes], axis=1) for n in names], axis=1)
        for prefix, (kind, _) in _KINDS.items()
        if f"{names[0]}.{prefix}x" in table.columns
    }
    return NodeHistory(
        times=table.times,
        nodes=names,
        position=arrays["position"],
        velocity=arrays.get("velocity"),
        acceleration=arrays.get("acceleration"),
        source=str(path),
    )


def history_faults(model: Model, history: NodeHistory) -> list[Fault]:
    """Faults of a table as the motion of a model: missing moving nodes or rates, other positions of fixed nodes."""
    found = []
    for kind, columns in (("velocity", "velocities (NODE.vx ..)"), ("acceleration", "accelerations (NODE.ax ..)")):
        if getattr(history, kind) is None:
            found.append(_about(history, f"has no {columns}.", "Inertia forces need them: add the columns."))
    whole, axes = model.whole, "xyz"[: model.dim]
    moving = [n for n in whole.nodes if set(whole.fixed.get(n, "")) != set(axes) or n in whole.support_motion]
    if missing := [name for name in moving if name not in history.nodes]:
        found.append(_about(history, f"has no columns for {few(missing, 12)}.", "Add them; only fixed nodes may be omitted."))
    places = np.array([node.at for node in whole.nodes.values()], float)
    allowed = AGREE * float(np.ptp(places, axis=0).max())
    for k, name in enumerate(history.nodes):
        for axis in () if name in whole.support_motion else whole.fixed.get(name, ""):
            column, place = history.position[:, k, "xyz".index(axis)], whole.nodes[name].at["xyz".index(axis)]
            off = np.abs(column - place)
            if off.max(initial=0.0) > allowed:
                at = int(off.argmax())
                here = f"{name}.{axis} is {column[at]:.9g} m at t = {history.times[at]:g} s"
                mend = "Give the positions of this model, remove the node from fixed, or give its support_motion."
                found.append(_about(history, f"{here}; the model holds it at {place:.9g} m.", mend))
    return found


def _about(history: NodeHistory, message: str, mend: str) -> Fault:
    return Fault(("motion",), message, mend, file=history.source)


def _parts(column: str) -> tuple[str, str, str]:
    """Node, prefix (empty, v or a) and axis of a column; empty strings if the column is not of a node."""
    node, _, last = column.rpartition(".")
    prefix, axis = last[:-1], last[-1:]
    return (node, prefix, axis) if node and prefix in _KINDS and axis in tuple("xyz") else ("", "", "")


def _quantity(column: str, known: frozenset[str] | None) -> str | None:
    node, prefix, axis = _parts(column)
    if not axis or (known is not None and node not in known):
        return None
    return _KINDS[prefix][1]


def _missing(table: Table, names: tuple[str, ...], axes: str) -> list[Fault]:
    """Faults of missing columns: every node needs all axes of position, and of velocity and acceleration if any node has
    them.
    """
    if not names:
        return [table.fault("has no column but t.", "Give NODE.x, NODE.y and, in space, NODE.z of every moving node.")]
    found = []
    for prefix in [p for p in _KINDS if not p or any(_parts(name)[1] == p for name in table.columns)]:
        for node in names:
            lacking = [f"{node}.{prefix}{axis}" for axis in axes if f"{node}.{prefix}{axis}" not in table.columns]
            if lacking:
                found.append(table.fault(f"{', '.join(lacking)} missing.", "Add the column, or remove all of its kind."))
    return found


def _surplus(table: Table, axes: str) -> list[Fault]:
    return [
        table.fault(f"column {name!r} has an axis too many for a model of {len(axes)} axes.", "Remove it.", column=one.at)
        for name, one in table.columns.items()
        if _parts(name)[2] not in axes
    ]


# Measured records of drives or pose coordinates, with or without their rates and accelerations.

_MEASURED = {"rate": ("rates", "rate"), "acceleration": ("accelerations", "second rate")}


def read_measured(path: str | Path, *, max_size: int = MAX_SIZE, **options: Any) -> Measured:
    """Read a measured record of lengths, angles or pose coordinates.

    Parameters
    ----------
    path : CSV: ``t``, a column for each coordinate (``M7 [mm]``), and, where they were measured too, ``M7.rate [mm/s]`` and
    ``M7.acceleration [mm/s^2]``; SI without a unit. max_size : bytes; a larger file is not read. options : other fields of
    `kt.Measured`, e.g. ``outliers="replace"``.

    Raises
    ------
    ModelError : faults of the table, each with file, line and column; accelerations without rates, rates without values.

    Examples
    --------
    >>> import kinetruss as kt
    >>> record = kt.io.read_measured(kt.library.example_files()["measured_slew"][1], outliers="replace")
    >>> list(record.values), float(record.values["M7"][0])  # m
    (['M7', 'M9', 'M11'], 1.24146)
    """
    table = read_measured_table(Path(path), max_size)
    return Measured(times=tuple(table.times), **measured_columns(table), **options)


def read_measured_table(path: Path, max_size: int) -> Table:
    """The table with the quantity of every column."""
    return read_table(path, lambda name: _split(name)[2], max_size=max_size, least_rows=4)


def measured_columns(table: Table) -> dict[str, Any]:
    """Fields of a `Measured` from the columns of a table.

    Raises
    ------
    ModelError : a rate or acceleration without the column that it belongs to.
    """
    fields: dict[str, dict[str, Any]] = {"values": {}, "rates": {}, "accelerations": {}}
    for name, column in table.columns.items():
        of, field, _ = _split(name)
        fields[field][of] = [Tagged(value, column.quantity) for value in column.values.tolist()]
    lacking = [(name, f"{name}.rate") for name in fields["rates"] if name not in fields["values"]]
    lacking += [(f"{name}.rate", f"{name}.acceleration") for name in fields["accelerations"] if name not in fields["rates"]]
    if lacking:
        raise ModelError(
            [
                table.fault(
                    f"column {need!r} is missing; {whole!r} needs it.",
                    f"Add the column {need}, or remove {whole}.",
                    column=table.columns[whole].at,
                )
                for need, whole in lacking
            ]
        )
    if not fields["values"]:
        raise ModelError([table.fault("has no column but t.", "Give one column for each moving coordinate, e.g. M7 [mm].")])
    return {field: columns for field, columns in fields.items() if columns}


def _split(column: str) -> tuple[str, str, str]:
    """Coordinate, field of the record, and quantity of a column."""
    name, _, last = column.rpartition(".")
    return (name, *_MEASURED[last]) if name and last in _MEASURED else (column, "values", "coordinate")


# Measured strain histories.

LARGEST = 0.1
"""Largest strain in a measured table; for a larger one the unit must be missing."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class StrainHistory:
    """A measured record: times (n_times,) s, columns by name (n_times,) in 1e-6, the file, and the line of each row.

    errors : standard error of every value, NaN where there is one reading only. volts : columns that are still voltages, V.
    """

    times: NDArray[np.float64]
    columns: dict[str, NDArray[np.float64]]
    source: str
    lines: tuple[int, ...]
    errors: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    volts: tuple[str, ...] = ()


def strain_columns(model: Model) -> list[str]:
    """Names a column may have: gauges, and GROUP.axial, GROUP.bending_2, GROUP.bending_3."""
    groups = dict.fromkeys(gauge.group for gauge in model.gauges.values() if gauge.group is not None)
    bending = ("bending_3",) if model.dim == 2 else ("bending_2", "bending_3")
    return [*model.gauges, *(f"{group}.{part}" for group in groups for part in ("axial", *bending))]


def read_strains(path: str | Path, model: Model, *, max_size: int = MAX_SIZE) -> StrainHistory:
    """Read a measured strain record.

    Parameters
    ----------
    path : CSV: ``t``, then a column per gauge or part of a group, e.g. ``G1 [microstrain]``, ``M6.axial [microstrain]``; a
    column without unit is strain in m/m. Readings of a gauge may be volts, ``G1 [mV]``: `strength.measured_strains` turns them
    into strain. Rows of the same time are averaged. max_size : bytes; a larger file is not read.

    Raises
    ------
    ModelError : all faults of the table, each with file, line and column: unknown columns, cells that are not a number,
    time that decreases, numbers too large to be strain.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model, record = kt.library.example_files()["strain_gauges"][:2]
    >>> history = kt.io.read_strains(record, kt.read(model))
    >>> list(history.columns), float(history.columns["M6.axial"][0])  # 1e-6
    (['M6.axial'], 4.07)
    """
    known = strain_columns(model)
    try:
        table = read_table(Path(path), lambda _: ("strain", "voltage"), max_size=max_size, repeats=True)
    except ModelError as error:
        raise ModelError([replace(fault, path=("measured",)) for fault in error.faults]) from None
    volts = tuple(name for name, one in table.columns.items() if one.quantity == "voltage")
    faults = [
        table.fault(f"column {name!r} is not a gauge or group of the model.", nearest(name, known), column=one.at)
        for name, one in table.columns.items()
        if name not in known
    ]
    if not table.columns:
        faults.append(table.fault("has no column but t.", f"Give one of: {', '.join(known) or 'no gauge in the model'}."))
    faults += [
        _too_large(table, name)
        for name, one in table.columns.items()
        if name not in volts and np.abs(one.values).max() > LARGEST
    ]
    if faults:
        raise ModelError([replace(fault, path=("measured",)) for fault in faults])
    times, first, which, count = np.unique(table.times, return_index=True, return_inverse=True, return_counts=True)
    columns, errors = {}, {}
    for name, one in table.columns.items():
        values = one.values if name in volts else 1e6 * one.values
        mean = np.bincount(which, values) / count
        spread = np.bincount(which, (values - mean[which]) ** 2)
        columns[name] = mean
        errors[name] = np.where(count > 1, np.sqrt(spread / np.maximum(count - 1, 1) / count), np.nan)
    lines = tuple(table.lines[int(k)] for k in first)
    return StrainHistory(times=times, columns=columns, errors=errors, source=str(path), lines=lines, volts=volts)


def _too_large(table: Table, name: str) -> Fault:
    column = table.columns[name]
    row = int(np.argmax(np.abs(column.values) > LARGEST))
    message = f"column {name!r} holds a strain of {column.values[row]:g} m/m."
    return table.fault(message, f"Give the unit in the header: {name} [microstrain].", table.lines[row], 1)
