"""Node histories: a motion from elsewhere, as a table in time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import Fault, ModelError
from kinetruss.io._table import Table, read_table

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["NodeHistory", "read_history"]

MAX_HISTORY = 2_000_000_000
_KINDS = {"": ("position", "length"), "v": ("velocity", "speed"), "a": ("acceleration", "acceleration")}


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class NodeHistory:
    """Positions (and perhaps velocities, accelerations) of nodes in time, SI.

    times (n_times,) s; nodes: names; position (n_times, n_nodes, dim) m; velocity m/s and acceleration m/s^2 of the same
    shape, or None where the file has none; source: the file.
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
    """Read a node-history CSV: columns ``t``, ``NODE.x``, ``NODE.y``[, ``NODE.z``], ``NODE.vx`` .., ``NODE.ax`` ..

    Parameters
    ----------
    path : the file; a header may carry a unit, ``N4.x [mm]``, and is SI without one.
    dim : number of axes; found from the columns where None. nodes : names that may stand; any where None.
    max_size : bytes; a larger file is refused before it is read.

    Raises
    ------
    ModelError : all faults of the table, each with file, line and column: unknown nodes, columns missing, cells that are no
        number, time that goes back.
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


def _parts(column: str) -> tuple[str, str, str]:
    """Node, prefix (empty, v or a) and axis of a column; empty strings where it is none."""
    node, _, last = column.rpartition(".")
    prefix, axis = last[:-1], last[-1:]
    return (node, prefix, axis) if node and prefix in _KINDS and axis in tuple("xyz") else ("", "", "")


def _quantity(column: str, known: frozenset[str] | None) -> str | None:
    node, prefix, axis = _parts(column)
    if not axis or (known is not None and node not in known):
        return None
    return _KINDS[prefix][1]


def _missing(table: Table, names: tuple[str, ...], axes: str) -> list[Fault]:
    """Every node needs all axes of position, and of velocity and acceleration where any node has them."""
    if not names:
        return [table.fault("has no column but t.", "Give NODE.x, NODE.y and, in space, NODE.z of every moving node.")]
    found = []
    for prefix in [p for p in _KINDS if not p or any(_parts(name)[1] == p for name in table.columns)]:
        for node in names:
            lacking = [f"{node}.{prefix}{axis}" for axis in axes if f"{node}.{prefix}{axis}" not in table.columns]
            if lacking:
                found.append(table.fault(f"{', '.join(lacking)} missing.", "Add the column, or leave out all of its kind."))
    return found


def _surplus(table: Table, axes: str) -> list[Fault]:
    return [
        table.fault(f"column {name!r} has an axis too many for a model of {len(axes)} axes.", "Remove it.", column=one.at)
        for name, one in table.columns.items()
        if _parts(name)[2] not in axes
    ]
