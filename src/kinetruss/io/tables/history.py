"""Node histories: a motion from another source, as a table over time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import Fault, ModelError, few
from kinetruss.io.tables.table import Table, read_table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model

__all__ = ["NodeHistory", "history_faults", "read_history"]

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
    whole = "xyz"[: model.dim]
    moving = [n for n in model.nodes if set(model.fixed.get(n, "")) != set(whole) or n in model.support_motion]
    if missing := [name for name in moving if name not in history.nodes]:
        found.append(_about(history, f"has no columns for {few(missing, 12)}.", "Add them; only fixed nodes may be omitted."))
    places = np.array([node.at for node in model.nodes.values()], float)
    allowed = AGREE * float(np.ptp(places, axis=0).max())
    for k, name in enumerate(history.nodes):
        for axis in () if name in model.support_motion else model.fixed.get(name, ""):
            column, place = history.position[:, k, "xyz".index(axis)], model.nodes[name].at["xyz".index(axis)]
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
