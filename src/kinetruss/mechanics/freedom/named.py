"""Coordinates of a model by name: what they measure, how they change with the nodes, and which of them are prescribed.

``N8`` all axes of a node, ``N8.x`` one; ``M7`` or ``M7.length`` the length of a member, ``crank.angle`` its angle in the
plane; the name of a drive; ``bay.beta``, ``bay.gamma``, ``bay.height`` of a pose.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, cast

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.structure.plan import ANGLE, LENGTH, SUM
from kinetruss.mechanics import System, constraint_gradients, kept, measured, row_scales
from kinetruss.mechanics.configuration.bay import POSE, pose_gradients, pose_values
from kinetruss.mechanics.configuration.positions import names_of
from kinetruss.model import AngleDrive, CoordinateDrive, LengthDrive, nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "OWN",
    "Coordinate",
    "coordinates",
    "coordinate_gradients",
    "is_prescribed",
    "row_of",
    "coordinate_rows",
    "coordinate_values",
]

OWN = "length", "angle", "sum"
"""Kinds of coordinates that rows can prescribe."""


@dataclass(frozen=True, slots=True)
class Coordinate:
    """One coordinate: `index` is a flat node coordinate, a member, a measure of the system (the angle of a hinge, or about an
    axis), or 0, 1, 2 of the pose `pose`; `name` is the given name.
    """

    name: str
    kind: Literal["node", "length", "angle", "sum", "pose"]
    index: int
    pose: str = ""

    @property
    def unit(self) -> str:
        """SI unit."""
        return "rad" if self.kind in ("angle", "sum") or (self.kind == "pose" and self.index < 2) else "m"


def coordinates(system: System, names: str | Iterable[str]) -> list[Coordinate]:
    """The coordinates that names stand for, in their order.

    Raises
    ------
    InputError : an unknown or ambiguous name, offering the nearest ones, or one named twice.
    """
    found = [one for name in names_of(names, "coordinates, e.g. ['N8', 'M7']") for one in _named(system, name)]
    seen: set[tuple[str, int, str]] = set()
    for one in found:
        key = (one.kind, one.index, one.pose)
        if key in seen:
            raise InputError(f"{one.name!r} is named twice. Name each coordinate once.")
        seen.add(key)
    if not found:
        raise InputError("No coordinate is named. Give for example 'N8', 'N8.x', a drive, or a pose coordinate.")
    return found


def _named(system: System, name: str) -> list[Coordinate]:
    model = system.model
    if name in model.all_drives:
        return [_drive(system, name)]
    if name in system.members and name in system.nodes:
        raise InputError(f"{name!r} is a node and a member. Write {name}.x for the node, or {name}.length for the member.")
    if name in system.members:
        return [Coordinate(name, "length", system.members.index(name))]
    axes = "xyz"[: system.dim]
    if name in system.nodes:
        return [Coordinate(f"{name}.{axis}", "node", 3 * system.node_index(name) + k) for k, axis in enumerate(axes)]
    whole, _, part = name.rpartition(".")
    if whole in system.nodes and part and part in axes:
        return [Coordinate(name, "node", 3 * system.node_index(whole) + axes.index(part))]
    if whole in system.members and (part == "length" or (part == "angle" and system.dim == 2)):
        return [Coordinate(name, "length" if part == "length" else "angle", system.members.index(whole))]
    if whole in model.poses and part in POSE:
        return [Coordinate(name, "pose", POSE.index(part), whole)]
    known = [*model.all_drives, *system.members, *(f"{node}.{axis}" for node in system.nodes for axis in axes)]
    known += [f"{pose}.{part}" for pose in model.poses for part in POSE]
    raise InputError(f"No coordinate called {name!r}. {nearest(name, known)}".rstrip())


def _drive(system: System, name: str) -> Coordinate:
    drive = system.model.all_drives[name]
    if isinstance(drive, CoordinateDrive):
        return Coordinate(name, "node", 3 * system.node_index(drive.node) + "xyz".index(drive.axis))
    if (m := int(system.drive_measure[system.drives.index(name)] if name in system.drives else -1)) >= 0:
        return Coordinate(name, "sum", m)
    of_bar = cast("LengthDrive | AngleDrive", drive)  # all others are measured
    return Coordinate(name, of_bar.kind, system.members.index(of_bar.bar))


def row_of(system: System, one: Coordinate) -> int | None:
    """The row that prescribes a length or an angle, or None."""
    if one.kind == "sum":
        found = np.flatnonzero(system.row_measure == one.index)
        return int(found[0]) if len(found) else None
    kind = {"length": LENGTH, "angle": ANGLE}.get(one.kind)
    if kind is None:
        return None
    found = np.flatnonzero((system.row_member == one.index) & (system.row_kind == kind))
    return int(found[0]) if len(found) else None


def is_prescribed(system: System, one: Coordinate) -> bool:
    """True if the model prescribes the coordinate: the length or angle of a row, a held coordinate of a node."""
    return bool(system.prescribed[one.index]) if one.kind == "node" else row_of(system, one) is not None


def coordinate_values(system: System, chosen: list[Coordinate], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (times, k), m or rad, at flat positions x (times, 3 n); angles unwrapped."""
    nodes = x.reshape(len(x), -1, 3)
    d = nodes[:, system.q] - nodes[:, system.p]
    found = np.empty((len(x), len(chosen)))
    poses = {}
    for k, one in enumerate(chosen):
        if one.kind == "node":
            found[:, k] = x[:, one.index]
        elif one.kind == "length":
            found[:, k] = np.linalg.norm(d[:, one.index], axis=1)
        elif one.kind == "sum":
            found[:, k] = measured(system, one.index, nodes)[:, 0]
        elif one.kind == "angle":
            found[:, k] = np.unwrap(np.arctan2(d[:, one.index, 1], d[:, one.index, 0]))
        else:
            if one.pose not in poses:
                poses[one.pose] = pose_values(system, one.pose, x)
            found[:, k] = poses[one.pose][:, one.index]
    return found


@kept()
def coordinate_rows(system: System, chosen: tuple[Coordinate, ...]) -> System:
    """The system whose rows are the chosen lengths, angles and sums, in their order, in place of its own."""
    sums = np.array([one.kind == "sum" for one in chosen], np.bool_)
    index = np.array([one.index for one in chosen], np.int64)
    none = np.full(len(chosen), -1, np.int32)
    return replace(
        system,
        row_member=np.where(sums, 0, index).astype(np.int32),
        row_kind=np.array([{"length": LENGTH, "angle": ANGLE, "sum": SUM}[one.kind] for one in chosen], np.int8),
        row_measure=np.where(sums, index, -1),
        row_drive=none,
        row_value=np.full(len(chosen), np.nan),
    )


def coordinate_gradients(system: System, chosen: list[Coordinate], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """d(coordinates)/d(node coordinates), (times, k, 3 n), at flat positions x (times, 3 n)."""
    found = np.zeros((len(x), len(chosen), x.shape[1]))
    own = [k for k, one in enumerate(chosen) if one.kind in OWN]
    if own:
        rows, nodes = coordinate_rows(system, tuple(chosen[k] for k in own)), x.reshape(len(x), -1, 3)
        found[:, own] = constraint_gradients(rows, nodes) / row_scales(rows, nodes)[..., None]
    poses = {}
    for k, one in enumerate(chosen):
        if one.kind == "node":
            found[:, k, one.index] = 1.0
        elif one.kind == "pose":
            if one.pose not in poses:
                poses[one.pose] = pose_gradients(system, one.pose, x)
            found[:, k] = poses[one.pose][:, one.index]
    return found
