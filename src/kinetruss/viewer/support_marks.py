"""Which symbols stand for a support: the one rule of pictures, pages and drawings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model.joints import GROUND
from kinetruss.model.supports import axes_of_support

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model, Restraint

    Array = NDArray[np.float64]


WORDS = {
    "clamp": "clamped: a hatched wall",
    "pin": "pinned: a triangle",
    "roller": "held in one direction: a triangle on rollers",
    "spring": "spring: a zigzag",
    "gap": "gap: two plates",
    "turn": "rotation held: a square",
    "turning spring": "spring of a rotation: a coil",
    "turning gap": "gap of a rotation: an arc",
}
"""What each symbol of `SUPPORTS` stands for."""
LEVEL = 0.1
"""Upward component of a direction up to which it is level, so that the ground is beside the structure and not below it."""
SIDE = 1e-9
"""Share of the size of a structure by which a node lies on one side of its middle."""


def support_marks(model: Model) -> list[dict[str, Any]]:
    """Node, ``kind`` of symbol and direction ``along`` (3,) of all supports of a model.

    along : from the ground to the node; of rotations their axis, and zero of one about all axes. A node that is held in all
    translations is a ``pin``, with its rotations a ``clamp``, which stands across the members that join it; else each direction
    that is held rigidly has a ``roller`` (also one that settles) or ``turn``, each elastic one a spring, each side of a gap its
    own mark. Where the direction may count either way the ground is below, above nodes of the upper half, and of level
    directions on the far side of the structure.

    >>> import kinetruss as kt
    >>> beam = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, beams={"b": ("A", "B")}, section=kt.Rod(diameter=0.1),
    ...     material="steel_s235", clamped=["A"], supports={"B": kt.Support(y="2 kN/mm")})
    >>> [(one["node"], one["kind"], one["along"]) for one in support_marks(beam)]
    [('A', 'clamp', [1.0, 0.0, 0.0]), ('B', 'spring', [0.0, 1.0, 0.0])]
    """
    whole, dim = model.whole, model.dim
    own = {name: node for name, node in model.nodes.items() if not node.scalar}
    if not own:
        return []
    at = {name: np.array([*node.at, 0.0][:3], float) for name, node in own.items()}
    low, high = np.min([*at.values()], axis=0), np.max([*at.values()], axis=0)
    clamped = {name for name, to in whole.clamped.items() if to == GROUND}
    joined: dict[str, list[str]] = {}
    for p, q in (member.ends for member in whole.members.values()):
        if p in at and q in at:
            joined.setdefault(p, []).append(q)
            joined.setdefault(q, []).append(p)
    found = []
    for node in dict.fromkeys([*whole.fixed, *model.supports]):
        if node not in at:
            continue
        axes = np.eye(3)
        if (one := model.supports.get(node)) is not None:
            axes[:dim, :dim] = axes_of_support(model, node)
            shifts, turns = dict[int, Any](one.shifts), one.turns_in(dim)
        else:
            shifts, turns = dict.fromkeys(("xyz".index(axis) for axis in whole.fixed[node]), None), {}
        every = len(shifts) == dim and all(way is None or way.stiffness is None for way in shifts.values())
        beyond = at[node] - (low + high) / 2
        away = np.where(np.abs(beyond) > SIDE * np.max(high - low), beyond, 0.0)
        if node in clamped or (every and len(turns) == 2 * dim - 3 and all(way.stiffness is None for way in turns.values())):
            found.append((node, "clamp", _into([at[other] - at[node] for other in joined.get(node, ())], _upright(dim, away))))
            continue
        if every:
            found.append((node, "pin", _upright(dim, away)))
        else:
            found += [(node, kind, way) for k, held in shifts.items() for kind, way in _held(held, axes[k], dim, away)]
        turning = {k: _turning(held) for k, held in turns.items()}
        if len(turning) == 3 and len(set(turning.values())) == 1:
            turning, axes = {0: turning[0]}, np.zeros((3, 3))
        found += [(node, kind, axes[k]) for k, kind in turning.items()]
    return [{"node": node, "kind": kind, "along": [float(v) + 0.0 for v in way]} for node, kind, way in found]


def _held(one: Restraint | None, axis: Array, dim: int, away: Array) -> Iterator[tuple[str, Array]]:
    """The marks of a translation that is held: None stands for a rigid one."""
    if one is None or one.gap is None:
        level = abs(float(axis[dim - 1])) < LEVEL
        turned = axis @ away > 0 if level else axis @ _upright(dim, away) < 0
        yield "roller" if one is None or one.stiffness is None else "spring", -axis if turned else axis
        return
    below, above = one.gap
    if below is not None:
        yield "gap", axis
    if above is not None:
        yield "gap", -axis


def _turning(one: Restraint) -> str:
    return "turning gap" if one.gap is not None else "turn" if one.stiffness is None else "turning spring"


def _upright(dim: int, away: Array) -> Array:
    """Upwards, or downwards for a node in the upper half, from which the structure hangs."""
    up: Array = np.eye(3)[dim - 1]
    return -up if away[dim - 1] > 0 else up


def _into(ways: list[Array], upright: Array) -> Array:
    """The direction of the members at a node, whose other ends are `ways` from it; `upright` where they balance each other."""
    whole = sum((way / (np.linalg.norm(way) or 1.0) for way in ways), np.zeros(3))
    size = float(np.linalg.norm(whole))
    return whole / size if size > SIDE else upright


def frame_of(kind: str, along: Array) -> Array:
    """Axes x and y of a symbol in space as rows (2, 3): y along the direction held; both across the axis of a rotation. Zero of
    a rotation about all axes, whose symbol faces the eye.
    """
    if not along.any():
        return np.zeros((2, 3))
    across = np.cross(along, [0.0, 0.0, 1.0])
    if np.linalg.norm(across) < SIDE:
        across = np.array([1.0, 0.0, 0.0])
    across = across / np.linalg.norm(across)
    return np.array([across, np.cross(along, across) if kind.startswith("turn") else along])
