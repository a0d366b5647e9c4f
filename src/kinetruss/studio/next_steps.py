"""What one click may add to a drawing in space so that less of it moves: a support, a drive, a bar. Each takes motions that are
there, and none is held twice by it.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.studio.edits import MEMBERS, Data, ends_of, supports
from kinetruss.studio.judging import on_members
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.mobility import Mobility
    from kinetruss.model import Model

FEET, FEW = 4, 3
"""Largest number of supports of what nothing holds, and of clicks of each other kind."""

MOST = 100
"""Largest number of nodes and of motions that are looked at."""

STILL = 1e-6
"""Of a motion of unit size, below which a node stands still."""

CLEAR = 0.3
"""Share of the largest effect of any bar, or of that of any axis, that one must have to be offered."""


@one_thread
def clicks(data: Data, model: Model, mobility: Mobility) -> list[dict[str, Any]]:
    """Clicks for a drawing in space in which something moves with all drives held, the likeliest first.

    Returns
    -------
    Records ``{"do": "hold", "node": .., "axes": ..}`` (all that are held then), ``{"do": "push", "node": .., "axis": ..}``,
    ``{"do": "turn", "bar": .., "node": .., "axis": ..}`` or ``{"do": "join", "ends": ..}``. While the whole can move as a rigid
    body: supports and drives. Then supports of loose ends, drives and bars; without any of these supports of what moves.

    >>> import kinetruss as kt
    >>> data = {"nodes": {"A": [0, 0, 0], "B": [1, 0, 0]}, "fixed": {"A": "xyz"}, "bars": {"b": ["A", "B"]}}
    >>> model = kt.Model(**data)
    >>> clicks(data, model, kt.kinematics.mobility(model))[0]
    {'do': 'hold', 'node': 'B', 'axes': 'yz'}
    """
    names = list(model.nodes)
    if not mobility.undriven or len(names) > MOST or mobility.undriven > MOST:
        return []
    index = {name: k for k, name in enumerate(mobility.node_names)}
    own = mobility.mechanisms[:, [index[name] for name in names]]
    x = mobility.position[[index[name] for name in names]]
    modes = _orthonormal(own.reshape(len(own), -1)).reshape(-1, len(names), 3)
    if not len(modes):  # what moves turns on the spot
        return []
    drawn = [ends_of(entry) for table in MEMBERS for entry in (data.get(table) or {}).values()]
    count = {name: sum(name in ends for ends in drawn) for name in names}
    hold = _holds(data, model, modes, count, x)
    floats = bool(hold) and _rigid(modes, x)
    found = hold[:FEET] if floats else [one for one in hold if count[one["node"]] == 1][:FEW]
    found += [*_turns(model, modes, x)[:FEW], *_pushes(data, model, modes)[:FEW]]
    found += [] if floats else _bars(names, modes, x, drawn)[:FEW]
    return found or hold[:FEW]


def _orthonormal(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """An orthonormal basis, in rows, of what rows span."""
    _, size, basis = np.linalg.svd(rows, full_matrices=False)
    return np.asarray(basis[size > STILL * size.max(initial=1.0)])


def _rigid(modes: NDArray[np.float64], x: NDArray[np.float64]) -> bool:
    """Whether all nodes can move together as a rigid body."""
    arm = x - x.mean(axis=0)
    size = float(np.abs(arm).max(initial=0.0)) or 1.0
    axes = np.eye(3)
    body = [np.tile(axis, (len(x), 1)) for axis in axes] + [np.cross(axis, arm / size) for axis in axes]
    whole = _orthonormal(np.array(body).reshape(6, -1))
    shared = np.linalg.svd(modes.reshape(len(modes), -1) @ whole.T, compute_uv=False)
    return bool(shared.max(initial=0.0) > 1.0 - STILL)


def _holds(
    data: Data, model: Model, modes: NDArray[np.float64], count: dict[str, int], x: NDArray[np.float64]
) -> list[dict[str, Any]]:
    """Supports of nodes with members, those with the fewest and the lowest first: along as many axes as the node moves."""
    fixed, rows = supports(data), []
    taken = {*(data.get("supports") or {}), *(data.get("clamped") or ())}
    for k, name in enumerate(model.nodes):
        own = modes[:, k]
        size = np.linalg.svd(own, compute_uv=False)
        ways = int((size > STILL).sum())
        if not ways or not count[name] or name in taken:
            continue
        worth = {axes: np.linalg.svd(own[:, axes], compute_uv=False)[ways - 1] for axes in combinations(range(3), ways)}
        axes = max(worth, key=lambda one: round(float(worth[one] / size[0]), 6))
        held = "".join(sorted({*fixed.get(name, ""), *("xyz"[axis] for axis in axes)}))
        rows.append((count[name], round(float(x[k, 2]), 9), k, {"do": "hold", "node": name, "axes": held}))
    return [row[-1] for row in sorted(rows, key=lambda row: row[:3])]


def _turns(model: Model, modes: NDArray[np.float64], x: NDArray[np.float64]) -> list[dict[str, Any]]:
    """Angles of bars that turn about a still end, each about the axis about which it turns most."""
    still = {name: not np.abs(modes[:, k]).max() > STILL for k, name in enumerate(model.nodes)}
    index = {name: k for k, name in enumerate(model.nodes)}
    driven = {getattr(drive, "bar", None) for drive in model.all_drives.values()}
    found = []
    for name, bar in model.bars.items():
        if bar.kind != "rigid" or name in driven or still[bar.ends[0]] == still[bar.ends[1]]:
            continue
        foot, tip = bar.ends if still[bar.ends[0]] else bar.ends[::-1]
        along = x[index[tip]] - x[index[foot]]
        arm = np.cross(np.eye(3), along / np.linalg.norm(along))  # about each axis, the way of the tip
        moves = np.linalg.norm(modes[:, index[tip]] @ arm.T, axis=0)
        moves[np.linalg.norm(arm, axis=1) < CLEAR] = 0.0  # nearly along the axis: it has hardly an angle about it
        axis = int(np.argmax(np.round(moves, 6)[::-1]))  # of equal ones the last
        if moves[::-1][axis] > STILL:
            found.append({"do": "turn", "bar": name, "node": foot, "axis": "zyx"[axis]})
    return found


def _pushes(data: Data, model: Model, modes: NDArray[np.float64]) -> list[dict[str, Any]]:
    """Nodes that are held along two axes and go along the third."""
    fixed, driven = supports(data), {getattr(drive, "node", None) for drive in model.all_drives.values()}
    return [
        {"do": "push", "node": name, "axis": axis}
        for k, name in enumerate(model.nodes)
        for i, axis in enumerate("xyz")
        if set("xyz") - {axis} == set(fixed.get(name, "")) and name not in driven and np.abs(modes[:, k, i]).max() > STILL
    ]


def _bars(names: list[str], modes: NDArray[np.float64], x: NDArray[np.float64], drawn: list[list[str]]) -> list[dict[str, Any]]:
    """Bars between nodes whose distance changes clearly, the shortest first; none along another member or through a node."""
    first, second = np.triu_indices(len(names), 1)
    along = x[second] - x[first]
    length = np.linalg.norm(along, axis=1)
    far = np.maximum(length, STILL * float(np.ptp(x, axis=0).max()))[:, None]
    rate = np.linalg.norm(np.einsum("mpk,pk->mp", modes[:, second] - modes[:, first], along / far), axis=0)
    joined = {frozenset(two) for ends in drawn for two in combinations(ends, 2)}
    places, found = dict(zip(names, x.tolist(), strict=True)), list[dict[str, Any]]()
    clear = np.flatnonzero(rate > max(STILL, CLEAR * float(rate.max(initial=0.0))))
    for k in clear[np.argsort(np.round(length[clear], 9), kind="stable")].tolist():
        ends = [names[first[k]], names[second[k]]]
        if len(found) < FEW and frozenset(ends) not in joined and not on_members(places, {"": ends}):
            found.append({"do": "join", "ends": ends})
    return found
