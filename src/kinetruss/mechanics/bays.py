"""The double-octahedral bay that a pose stands for: its nodes, found from its three drives, and its pose measured from them.

Nodes by their numbers in one bay (Lacy, 1991): base 1, 2, 3; middle 4, 5, 6; top 7, 9, 8, over 1, 2, 3. M7 joins 4 and 5, M9
joins 5 and 6, M11 joins 4 and 6; longerons join a middle node to two corners of the base and to the two corners of the top
above them.
"""

from __future__ import annotations

from itertools import permutations
from math import prod
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.errors import Fault, ModelError
from kinetruss.mechanics.positions import gimbal_angles, normalised, size, vector_area
from kinetruss.mechanics.system import System
from kinetruss.model import LengthDrive

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray


POSE = ("beta", "gamma", "height")

FIT = 1e-6
"""Largest difference between a bay and its pose: of lengths as a fraction of the longeron, of angles in rad."""

NAMED = (
    "Name the active members M7 (of nodes 4 and 5), M9 (5 and 6), M11 (4 and 6) of one double-octahedral bay, in this order."
)


class Bay(NamedTuple):
    """Indices of the nodes of a bay: 1, 2, 3; 4, 5, 6; 7, 9, 8 (over 1, 2, 3)."""

    base: tuple[int, int, int]
    middle: tuple[int, int, int]
    top: tuple[int, int, int]


def pose_members(system: System, pose: str) -> list[int]:
    """Members that the drives of a pose move, in its order.

    Raises
    ------
    ModelError : a drive that moves no length, or one that is named twice.
    """
    drives = system.model.poses[pose].drives
    found = [system.model.all_drives[name] for name in drives]
    if odd := [name for name, drive in zip(drives, found, strict=True) if not isinstance(drive, LengthDrive)]:
        raise pose_fault(pose, f"{odd[0]!r} does not drive the length of a member.", NAMED, "drives")
    members = [system.members.index(drive.bar) for drive in found if isinstance(drive, LengthDrive)]
    if len(set(members)) < 3:
        raise pose_fault(pose, f"names a drive twice: {', '.join(drives)}.", NAMED, "drives")
    return members


def bay_of(system: System, pose: str) -> Bay:
    """The bay that a pose moves.

    Raises
    ------
    ModelError : the drives belong to no double-octahedral bay, or stand in another order than M7, M9, M11.
    """
    bay = _bay_of(system, pose, tuple(pose_members(system, pose)))
    if _in_order(system, pose, bay):
        return bay
    record = system.model.poses[pose]
    right = [
        order
        for order in permutations(record.drives)
        if _in_order(system, pose, _bay_of(system, pose, tuple(_member(system, name) for name in order)))
    ]
    mend = f"Write drives: [{', '.join(right[0])}]." if right else NAMED
    raise pose_fault(pose, f"has its drives in another order than M7, M9, M11: {', '.join(record.drives)}.", mend, "drives")


def departs(system: System, pose: str, x: NDArray[np.float64], asked: NDArray[np.float64]) -> int | None:
    """First sample at which a bay at x (times, 3 n) is not in the prescribed pose (times, 3), or None."""
    off = np.abs(pose_values(system, pose, x) - asked).max(axis=1) > 10 * FIT * max(1.0, system.model.poses[pose].longeron)
    return int(off.argmax()) if off.any() else None


def pose_values(system: System, pose: str, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """beta, gamma (rad) and height (m) of the top seen from the base, (times, 3), measured at flat positions x (times, 3 n)."""
    return np.stack([one[0] for one in _measured(system, bay_of(system, pose), [x])], axis=1)


def pose_gradients(system: System, pose: str, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """d(beta, gamma, height)/d(node coordinates), (times, 3, 3 n): the rates for unit velocities of the bay's coordinates."""
    bay = bay_of(system, pose)
    flats = [3 * node + axis for node in (*bay.base, *bay.top) for axis in range(3)]
    places = np.repeat(x, len(flats), axis=0)
    velocity = np.zeros_like(places)
    velocity[np.arange(len(places)), np.tile(flats, len(x))] = 1.0
    rates = _measured(system, bay, [places, velocity, 0 * places])
    found = np.zeros((len(x), 3, x.shape[1]))
    for k, one in enumerate(rates):
        found[:, k, flats] = one[1].reshape(len(x), -1)
    return found


def _measured(system: System, bay: Bay, histories: list[NDArray[np.float64]]) -> list[Any]:
    """Beta, gamma and height with the rates that the histories have, as in `platform`: by the triangles of base and top."""
    arms, centres = [], []
    for side in (bay.base, bay.top):
        nodes = [y.reshape(len(y), prod(y.shape[1:]) // 3, 3)[:, side] for y in histories]
        centres.append([y.mean(axis=1) for y in nodes])
        arms.append([y - c[:, None] for y, c in zip(nodes, centres[-1], strict=True)])
    angles = gimbal_angles(normalised(vector_area(arms[1])), arms[0], [system.nodes[i] for i in bay.base])
    return [angles["beta"], angles["gamma"], size([b - a for a, b in zip(*centres, strict=True)])]


def _member(system: System, drive: str) -> int:
    return system.members.index(cast("LengthDrive", system.model.all_drives[drive]).bar)


@cached()
def _known(system: System) -> dict[tuple[Any, ...], Any]:
    """Stored results of a system: the neighbours of each node; then its bays by their members."""
    joined: list[set[int]] = [set() for _ in system.nodes]
    for a, b in zip(system.p.tolist(), system.q.tolist(), strict=True):
        joined[a].add(b)
        joined[b].add(a)
    return {("joined",): joined}


def _bay_of(system: System, pose: str, members: tuple[int, ...]) -> Bay:
    known = _known(system)
    if ("bay", members) not in known:
        known["bay", members] = _found_bay(system, pose, members)
    bay: Bay = known["bay", members]
    return bay


def _found_bay(system: System, pose: str, members: tuple[int, ...]) -> Bay:
    """The bay of three members taken as M7, M9, M11: seen from above, its middle nodes 4, 5, 6 run clockwise."""
    seven, nine, eleven = ({int(system.p[i]), int(system.q[i])} for i in members)
    middle = [one & other for one, other in ((seven, eleven), (seven, nine), (nine, eleven))]
    if {len(one) for one in middle} != {1} or len(seven | nine | eleven) != 3:
        named = ", ".join(system.members[i] for i in members)
        raise pose_fault(pose, f"{named} do not form a triangle.", NAMED, "drives")
    four, five, six = (one.pop() for one in middle)
    neighbours = _known(system)[("joined",)]
    joined = [neighbours[node] - {four, five, six} for node in (four, five, six)]
    shared = [joined[0] & joined[2], joined[1] & joined[2], joined[0] & joined[1]]  # over corners 1, 2, 3
    if any(len(pair) != 2 for pair in shared) or len(set.union(*shared)) != 6:
        named = ", ".join(system.nodes[i] for i in (four, five, six))
        raise pose_fault(pose, f"nodes {named} are not each joined to two corners of a base and two of a top.", NAMED, "drives")
    x = system.x0
    down, center = np.cross(x[five] - x[four], x[six] - x[four]), x[[four, five, six]].mean(axis=0)
    sides = [sorted(pair, key=lambda node: float((x[node] - center) @ down)) for pair in shared]
    top, base = (tuple(pair[k] for pair in sides) for k in (0, 1))
    return Bay(base, (four, five, six), top)


def _in_order(system: System, pose: str, bay: Bay) -> bool:
    """False if another order of the drives gives the natural frame: base below top, x axis of the base along global x.

    A base that is the top of another pose keeps the order of its corners; a fixed base has global axes if possible.
    """
    whole = [bool(system.prescribed.reshape(-1, 3)[list(side)].all()) for side in (bay.base, bay.top)]
    if whole[0]:
        return _aligned(system.x0, bay.base)
    if whole[1]:
        return False
    for other in system.model.poses:
        if other == pose:
            continue
        below = _quiet_bay(system, other)
        if below is None:
            continue
        if set(below.top) == set(bay.base):
            return below.top == bay.base
        if set(below.top) == set(bay.top):
            return False
    return True


def _quiet_bay(system: System, pose: str) -> Bay | None:
    try:
        return _bay_of(system, pose, tuple(pose_members(system, pose)))
    except ModelError:
        return None


def _aligned(x: NDArray[np.float64], base: Sequence[int]) -> bool:
    """False if another side than that from corner 1 to 2 is along global x."""
    sides = [x[b] - x[a] for a, b in zip(base, (*base[1:], base[0]), strict=True)]
    along = [float(side[0]) / max(float(np.linalg.norm(side)), 1e-300) for side in sides]
    return along[0] > 1 - 1e-9 or max(along[1:]) <= 1 - 1e-9


def pose_fault(pose: str, message: str, mend: str, field: str | None = None) -> ModelError:
    """The error for a pose, at one of its fields if that is known."""
    return ModelError([Fault(("poses", pose) if field is None else ("poses", pose, field), message, mend)])
