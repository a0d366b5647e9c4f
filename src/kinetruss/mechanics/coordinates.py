"""Coordinates of a model by name, and chosen degrees of freedom.

``N8`` all axes of a node, ``N8.x`` one; ``M7`` or ``M7.length`` the length of a member, ``crank.angle`` its angle in the
plane; the name of a drive; ``bay.beta``, ``bay.gamma``, ``bay.height`` of a pose.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np
from scipy.sparse import csc_array, csr_array, vstack

from kinetruss.elements.caching import cached
from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SUM
from kinetruss.mechanics.arguments import names_of
from kinetruss.mechanics.bays import POSE, pose_gradients, pose_values
from kinetruss.mechanics.measures import measured
from kinetruss.mechanics.members import DRIVEN, RIGID
from kinetruss.mechanics.mode_texts import moves_text
from kinetruss.mechanics.row_gradients import (
    RANK_TOLERANCE,
    constraint_curvature,
    constraint_gradients,
    constraint_jacobian,
    row_scales,
)
from kinetruss.mechanics.rows import Derivatives, factors_of, null_basis, row_derivatives
from kinetruss.mechanics.system import System
from kinetruss.model import AngleDrive, CoordinateDrive, LengthDrive, nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray


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


@cached()
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


# Degrees of freedom by choice: the rows that hold a structure and the coordinates that move it, as one square system.

LARGEST = 1e9
"""If a unit change of a coordinate displaces some node by more than this, the coordinate does not fix the configuration."""


@cached()
def released(system: System, drives: tuple[str, ...]) -> System:
    """The system with some drives released: without their rows, and with their coordinates free."""
    if not drives:
        return system
    gone = [system.drives.index(name) for name in drives]
    keep = ~np.isin(system.row_drive, gone)
    off = np.isin(system.coordinate_drive[:, 1], gone)
    prescribed = system.prescribed.copy()
    prescribed[system.coordinate_drive[off, 0]] = False
    return system.with_rows(keep, prescribed=prescribed, coordinate_drive=system.coordinate_drive[~off])


def chosen_dofs(system: System, names: str | Iterable[str]) -> tuple[list[Coordinate], tuple[str, ...]]:
    """The coordinates that are named as degrees of freedom, and the drives that must be released for them.

    Raises
    ------
    InputError : unknown names; a coordinate that a support or a rigid bar holds; a pose coordinate.
    """
    chosen = coordinates(system, names)
    drives = []
    for one in chosen:
        if one.kind == "pose":
            raise InputError(f"{one.name!r} is a pose coordinate. Name lengths, angles or node coordinates.")
        if (drive := _drive_of(system, one)) is not None:
            drives.append(drive)
        elif one.kind == "node" and system.prescribed[one.index]:
            raise InputError(f"{one.name!r} is held by a support, so it is no degree of freedom. Name one that can move.")
        elif one.kind == "length" and system.kind[one.index] == RIGID:
            raise InputError(
                f"{one.name!r} is a rigid bar, so its length cannot change. Make it elastic or driven, or name another."
            )
    return chosen, tuple(dict.fromkeys(drives))


def _drive_of(system: System, one: Coordinate) -> str | None:
    """The drive that moves a coordinate, or None."""
    if one.kind == "node":
        found = system.coordinate_drive[system.coordinate_drive[:, 0] == one.index, 1]
        return system.drives[found[0]] if len(found) else None
    if one.kind == "length" and system.kind[one.index] != DRIVEN:
        return None
    if one.kind == "sum":
        return one.name if (system.row_drive == system.drives.index(one.name)).any() else None
    kind = ANGLE if one.kind == "angle" else LENGTH
    rows = (system.row_member == one.index) & (system.row_kind == kind) & (system.row_drive >= 0)
    return system.drives[system.row_drive[rows][0]] if rows.any() else None


def derivatives_of(
    system: System,
    chosen: list[Coordinate],
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None = None,
    a: NDArray[np.float64] | None = None,
) -> Derivatives:
    """Derivatives of coordinates by name; those of poses at rest only."""
    nodes, poses, rows = ([k for k, one in enumerate(chosen) if one.kind in kinds] for kinds in (("node",), ("pose",), OWN))
    if poses and any(y is not None and np.any(y) for y in (v, a)):
        raise InputError(f"{chosen[poses[0]].name!r} is a pose coordinate, which is taken at rest only. Name lengths or nodes.")
    own = row_derivatives(coordinate_rows(system, tuple(chosen[k] for k in rows)), x, v, a)
    flats = np.array([chosen[k].index for k in nodes], np.int64)
    units = csr_array((np.ones(len(nodes)), flats, np.arange(len(nodes) + 1)), shape=(len(nodes), x.size))
    bent = csr_array(coordinate_gradients(system, [chosen[k] for k in poses], x.reshape(1, -1))[0].reshape(len(poses), x.size))
    order = np.argsort([*nodes, *poses, *rows], kind="stable")
    r = np.zeros((len(chosen), 3))
    r[:, 0] = 1.0
    r[rows] = own.r
    still = csr_array((len(nodes) + len(poses), x.size))
    first = vstack([units, bent, own.g[0]], format="csr")[order]
    later = [vstack([still, g], format="csr")[order] for g in own.g[1:]]
    return Derivatives(g=(first, later[0], later[1]), r=r)


@dataclass(frozen=True, kw_only=True, eq=False)
class Basis:
    """The square system [J; S] dx = [rows; coordinates] at one configuration.

    system : without the rows of released drives. x : (n, 3) m. dofs : the coordinates, and scale : (dofs,) their r.
    rows : (kept,) indices of independent rows. factors : of the square matrix.
    """

    system: System
    x: NDArray[np.float64]
    dofs: list[Coordinate]
    scale: NDArray[np.float64]
    rows: NDArray[np.int64]
    factors: Any

    def solve(self, rows: NDArray[np.float64], dofs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Changes of all coordinates (3 n, k) for right sides of all rows (rows, k) and of the dofs (dofs, k)."""
        full = np.zeros((self.system.x0.size, dofs.shape[1]))
        full[self.system.free] = self.factors.solve(np.ascontiguousarray(np.vstack([rows[self.rows], dofs])))
        return full


def basis(system: System, dofs: list[Coordinate] | None, x: NDArray[np.float64]) -> Basis:
    """The basis of degrees of freedom at positions x (n, 3); None chooses free node coordinates that are as independent as
    possible.

    Raises
    ------
    InputError : too many or too few; a set that does not fix the configuration, or is held by bars; nothing that can move.
    """
    J = constraint_jacobian(system, x)[:, system.free]
    count = len(system.free)
    wanted = count - J.shape[0]
    if dofs is None or len(dofs) != wanted:
        rows = independent(J)
        wanted = count - len(rows)
    else:
        rows = np.arange(J.shape[0])
    if wanted == 0:
        if not system.drives:
            raise InputError("Nothing can move here: bars and supports hold all nodes. Release a support, or let a bar strain.")
        raise InputError("Nothing can move here: all drives are held. Name those that are released, in dofs or free.")
    if dofs is None:
        dofs = _picked(system, J[rows], wanted)
    if len(dofs) != wanted:
        named = ", ".join(one.name for one in dofs)
        raise InputError(
            f"The structure has {wanted} freedom{'s' if wanted != 1 else ''} here, but {len(dofs)} "
            f"{'are' if len(dofs) != 1 else 'is'} named ({named}). Name as many as it has, or none to have them chosen."
        )
    found = derivatives_of(system, dofs, x)
    factors = _factored(system, dofs, J[rows], found.g[0][:, system.free])
    return Basis(system=system, x=x, dofs=dofs, scale=found.r[:, 0], rows=rows, factors=factors)


def dof_basis(system: System, dofs: str | Iterable[str] | None, x: NDArray[np.float64], free: Iterable[str]) -> Basis:
    """The basis of named degrees of freedom; the drives among them and those of `free` are released."""
    names = [free] if isinstance(free, str) else list(free)
    if unknown := [name for name in names if name not in system.drives]:
        raise InputError(f"No drive called {unknown[0]!r} to release. There are: {', '.join(system.drives) or 'none'}.")
    chosen, own = (None, ()) if dofs is None else chosen_dofs(system, dofs)
    return basis(released(system, tuple(dict.fromkeys([*names, *own]))), chosen, x)


def first_order_of(at: Basis) -> NDArray[np.float64]:
    """F' (3 n, dofs)."""
    return at.solve(np.zeros((len(at.system.row_member), len(at.dofs))), np.diag(at.scale))


def second_order_of(at: Basis, F: NDArray[np.float64]) -> NDArray[np.float64]:
    """F'' (3 n, dofs, dofs)."""
    k = len(at.dofs)
    rows, dofs = 0.0 - constraint_curvature(at.system, at.x, F), np.zeros((k, k, k))
    own = [j for j, one in enumerate(at.dofs) if one.kind in OWN]
    dofs[own] = 0.0 - constraint_curvature(coordinate_rows(at.system, tuple(at.dofs[j] for j in own)), at.x, F)
    i, j = np.triu_indices(k)
    found = np.empty((at.x.size, k, k))
    found[:, i, j] = found[:, j, i] = at.solve(rows[:, i, j], dofs[:, i, j])
    return found


def independent(J: Any) -> NDArray[np.int64]:
    """A largest set of independent rows of unit size."""
    from scipy.linalg import qr

    if 0 in J.shape:
        return np.zeros(0, np.int64)
    R, order = qr(J.toarray().T, mode="r", pivoting=True)
    size = np.abs(np.diag(R))
    return np.sort(order[: int(np.sum(size > RANK_TOLERANCE * max(1.0, size[0])))]).astype(np.int64)


def _picked(system: System, J: Any, wanted: int) -> list[Coordinate]:
    """Free node coordinates that fix the configuration best: pivots of a basis of the null space."""
    from scipy.linalg import qr

    if J.shape[0] == 0:
        chosen = np.arange(len(system.free))
    else:
        _, order = qr(null_basis(J).T, mode="r", pivoting=True)
        chosen = np.sort(order[:wanted])
    flats = system.free[chosen]
    return [Coordinate(f"{system.nodes[flat // 3]}.{'xyz'[flat % 3]}", "node", int(flat)) for flat in flats]


def _factored(system: System, dofs: list[Coordinate], J: Any, S: Any) -> Any:
    """Sparse factors of [J; S]; if that is singular, an InputError says which mechanism is free, and what would fix it."""
    square, rows = csc_array(vstack([J, S])), J.shape[0]
    factors = factors_of(square)
    unit = np.zeros((square.shape[0], len(dofs)))
    unit[rows:] = np.eye(len(dofs))
    if factors is not None and np.abs(factors.solve(unit)).max(initial=0.0) < LARGEST:
        return factors
    _, _, Vt = np.linalg.svd(square.toarray())
    mode = np.zeros(system.x0.size)
    mode[system.free] = Vt[-1]
    text = moves_text(system, mode.reshape(-1, 3)[:, : system.dim])
    better = [one.name for one in _picked(system, J, len(dofs))]
    raise InputError(
        f"{', '.join(one.name for one in dofs)} {'does' if len(dofs) == 1 else 'do'} not fix the configuration: {text} while "
        f"{'it stands' if len(dofs) == 1 else 'they stand'} still. Name others, e.g. {', '.join(better)}."
    )
