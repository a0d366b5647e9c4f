"""What a user reads of a result: their own nodes, members and supports, and the arms of hubs.

Results are computed with all parts of `model.whole`; its inner ones represent beams, bodies and hubs. Coordinates
``inner_node`` and ``inner_member`` mark them; the forces of all supported nodes stand along ``held``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import cached
from kinetruss.results.arrays import Arrays, variable

if TYPE_CHECKING:
    from collections.abc import Callable

    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.kernels.compiled.record import Floats
    from kinetruss.mechanics import System
    from kinetruss.results.arrays import Column

MARKS = {"node": "inner_node", "member": "inner_member"}
"""The coordinates that mark inner parts, by the axis that has them."""

HELD = "held"
"""The axis of all supported nodes, inner ones too."""


@cached()
def part_axes(system: System) -> dict[str, Any]:
    """The axes ``node``, ``axis`` and ``member`` of a result, and what marks inner parts along them."""
    whole, tips = system.model, {arm.name for arms in system.inner.arms.values() for arm in arms}
    found: dict[str, Any] = {
        "node": np.array(system.nodes, dtype=object).astype(str),
        "axis": list("xyz"[: system.dim]),
        "member": np.array(system.members, dtype=object).astype(str),
    }
    inner = {
        "node": [name in system.inner.nodes and name not in tips for name in system.nodes],
        "member": [name not in whole.real_members for name in system.members],
    }
    return found | {MARKS[axis]: (axis, np.array(own)) for axis, own in inner.items() if any(own)}


@cached()
def support_axes(system: System) -> dict[str, Any]:
    """The axes of `reactions`."""
    names, at = _supports(system)
    found: dict[str, Any] = {"support": np.array(names, dtype=object).astype(str)}
    if len(names) < len(at):
        found |= {HELD: np.array(system.supports, dtype=object).astype(str), "rotation": list("xyz"[-_turns(system) :])}
    return found


def reactions(system: System, per: tuple[str, ...], x: Floats, force: Floats) -> dict[str, Column]:
    """Forces of supports, and the moments of clamps about their nodes, from the forces (.., held, 3) of all supported nodes at
    positions x (.., n, 3).

    The force of a clamp is the sum over its node and those of its frame, its moment the sum of theirs about it.
    """
    names, at = _supports(system)
    dim = system.dim
    if len(names) == len(at):
        return {"reaction": variable((*per, "support", "axis"), force[..., :dim], "N", "support force on the structure")}
    place, centre, sums = _held(system)
    total = sums @ force
    arm = x[..., place, :] - x[..., centre, :]
    # r x F; of a few vectors numpy.cross takes several times as long
    turned = np.stack([arm[..., i] * force[..., j] - arm[..., j] * force[..., i] for i, j in ((1, 2), (2, 0), (0, 1))], axis=-1)
    moment = sums @ turned
    words = "moment of a support on the structure, about its node"
    return {
        "reaction": variable((*per, "support", "axis"), total[..., :dim], "N", "support force on the structure"),
        "reaction_moment": variable((*per, "support", "rotation"), moment[..., 3 - _turns(system) :], "N m", words),
        "held_force": variable((*per, HELD, "axis"), force[..., :dim], "N", "force on each node that a support holds"),
    }


def rotation_columns(system: System, per: tuple[str, ...], turned: Callable[[], Floats]) -> dict[str, Column]:
    """The variable of the rotations of nodes that carry a frame, rad; none without frames. turned : (.., frames, 1 or 3)."""
    if not system.inner.frames:
        return {}
    return {"node_rotation": variable((*per, "frame", "about"), turned(), "rad", "rotation of nodes of beams from the model")}


def held_forces(data: Any) -> tuple[list[str], NDArray[np.float64]]:
    """All supported nodes, inner ones too, and the forces on them, from the arrays of a result."""
    of, axis = ("held_force", HELD) if "held_force" in data else ("reaction", "support")
    return [str(name) for name in data[axis].values], data[of].values


def clamps(system: System) -> set[str]:
    """Supports that hold more than their node, so that they have a moment."""
    names, at = _supports(system)
    return {name for k, name in enumerate(names) if at.count(k) > 1}


def users(whole: xr.Dataset) -> xr.Dataset:
    """A dataset without inner parts."""
    marks = {axis: whole[mark].values for axis, mark in MARKS.items() if mark in whole.coords}
    if not marks:
        return whole
    kept = {axis: np.flatnonzero(~inner) for axis, inner in marks.items()}
    # the user's are the first ones, so that values are not copied
    parts = {axis: slice(len(own)) if (own == np.arange(len(own))).all() else own for axis, own in kept.items()}
    gone = [MARKS[axis] for axis in marks]
    return whole.drop_dims(HELD, errors="ignore").isel(parts).drop_vars(gone)


class Shown:
    """The field `data` of a result, kept whole: a dataset, or arrays from which it is made when it is first read."""

    def __get__(self, result: Any, kind: type | None = None) -> xr.Dataset:
        if result is None:
            raise AttributeError("data")
        whole: xr.Dataset = result.whole
        kept: tuple[xr.Dataset, xr.Dataset] | None = result.__dict__.get("_users")
        if kept is None or kept[0] is not whole:
            kept = result.__dict__["_users"] = whole, users(whole)
        return kept[1]

    def __set__(self, result: Any, given: xr.Dataset | Arrays) -> None:
        result.__dict__["data"] = given


SHOWN: Any = Shown()


def completed(given: xr.Dataset, whole: xr.Dataset) -> xr.Dataset:
    """A dataset that a user cut or changed, with the inner parts of `whole`, from which it was taken.

    Raises
    ------
    InputError : it has instants that `whole` lacks, so that where the inner parts are is not known.
    """
    inner = [axis for axis, mark in MARKS.items() if mark in whole.coords and mark not in given.coords]
    if not inner:
        return given
    cut = [axis for axis in whole.indexes if axis in given.coords and axis not in (*MARKS, "support")]
    kept = {axis: given[axis].values for axis in cut if not whole.indexes[axis].equals(given.indexes.get(axis))}
    try:
        found = whole.sel(kept) if kept else whole
    except KeyError as error:
        message = f"The data have {error.args[0]}, which the result does not have: its inner parts, which represent beams, "
        raise InputError(f"{message}bodies and hubs, are not known there. Give instants of the result.") from None
    own = {axis: np.flatnonzero(~whole[MARKS[axis]].values) for axis in inner}
    for name, one in given.variables.items():
        if name in found.indexes:
            continue
        if name in found.variables and found[name].sizes != one.sizes:
            values = np.array(found[name].values)
            values[np.ix_(*(own.get(str(axis), np.arange(found.sizes[axis])) for axis in one.dims))] = one.values
            one = found.variables[name].copy(data=values)
        found = found.assign_coords({name: one}) if name in given.coords else found.assign({name: one})
    return found.drop_vars([name for name in found.data_vars if name not in given and HELD not in found[name].dims])


def marked(system: System, data: xr.Dataset, position: xr.DataArray) -> xr.Dataset:
    """A dataset as an earlier version wrote it, without marks, and with the forces of all supported nodes as reactions.

    position : of the nodes, with the axes of the reactions before the last two.
    """
    axes, supports = part_axes(system), support_axes(system)
    for axis, mark in MARKS.items():
        if mark in axes and mark not in data.coords and axis in data.indexes:
            inner = set(axes[axis][axes[mark][1]].tolist())
            data = data.assign_coords({mark: (axis, [name in inner for name in data[axis].values.tolist()])})
    if "reaction" not in data or HELD not in supports or "held_force" in data:
        return data

    def full(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.pad(values, [(0, 0)] * (values.ndim - 1) + [(0, 3 - system.dim)])

    force = data["reaction"].sel(support=list(system.supports))
    x = full(position.sel(node=list(system.nodes)).values)
    per = tuple(map(str, force.dims[:-2]))
    return data.drop_dims("support").assign(reactions(system, per, x, full(force.values))).assign_coords(supports)


def _turns(system: System) -> int:
    """Rotations about the axes of space: one in the plane, three in space."""
    return 1 if system.dim == 2 else 3


@cached()
def _held(system: System) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]:
    """The nodes that supports hold, those to which they belong, and how what acts on the former adds up to that on the user's
    supports (supports, held).
    """
    names, at = _supports(system)
    place = np.array([system.node_index(name) for name in system.supports], np.int64)
    centre = np.array([system.node_index(names[of]) for of in at], np.int64)
    return place, centre, (np.array(at)[None] == np.arange(len(names))[:, None]).astype(float)


@cached()
def _supports(system: System) -> tuple[list[str], list[int]]:
    """The user's supported nodes, and of every supported node the index of that to which it belongs."""
    inner = system.inner.nodes
    at = [inner[name].at if name in inner else name for name in system.supports]
    names = list(dict.fromkeys(at))
    return names, [names.index(name) for name in at]
