"""What a user reads of a result: their own nodes, members and supports, and the arms of hubs.

Results are computed with all parts of `model.whole`; its inner ones represent beams, bodies and hubs. Coordinates
``inner_node`` and ``inner_member`` mark them; the forces of all supported nodes stand along ``held``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, few
from kinetruss.mechanics import cached
from kinetruss.model.supports import axes_of_support, straight
from kinetruss.results.arrays import Arrays, variable

if TYPE_CHECKING:
    from collections.abc import Callable

    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.kernels.compiled.record import Floats
    from kinetruss.mechanics import System
    from kinetruss.results.arrays import Column

OF_SUPPORTS = ("coupling", "spring", "stop")
"""The axes of what supports are made of, besides fixed nodes."""

MARKS = {axis: f"inner_{axis}" for axis in ("node", "member", *OF_SUPPORTS)}
"""The coordinates that mark inner parts, by the axis that has them."""

HELD = "held"
"""The axis of all supported nodes, inner ones too."""


@cached(of_records=True)
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


@cached(of_records=True)
def support_axes(system: System) -> dict[str, Any]:
    """The axes of `reactions`."""
    names = _supports(system)[0]
    found: dict[str, Any] = {"support": np.array(names, dtype=object).astype(str)}
    if _plain(system):
        return found
    found |= {HELD: np.array(system.supports, dtype=object).astype(str)}
    if clamps(system):
        found["rotation"] = list("xyz"[-_turns(system) :])
    return found


def reactions(
    system: System,
    per: tuple[str, ...],
    x: Floats,
    force: Floats,
    couplings: Floats | None = None,
    elements: Floats | None = None,
) -> dict[str, Column]:
    """Forces of supports, and the moments of clamps about their nodes, from the forces (.., held, 3) of all supported nodes at
    positions x (.., n, 3), and from those on the coordinates of couplings (.., couplings) and elements (.., force_elements).

    The force of a clamp is the sum over its node and those of its frame, its moment the sum of theirs about it. What holds a
    single direction adds its force along it, or its moment f (a r^2 - r (a r))/|r - a (a r)|^2: f on the angle about the axis a
    of the arm r that turns with the node.
    """
    dim = system.dim
    if _plain(system):
        return {"reaction": variable((*per, "support", "axis"), force[..., :dim], "N", "support force on the structure")}
    place, centre, sums = _held(system)
    total, moment = sums @ force, np.zeros((*force.shape[:-2], len(sums), 3))
    if len(place):
        arm = x[..., place, :] - x[..., centre, :]
        # r x F; of a few vectors numpy.cross takes several times as long
        parts = [arm[..., i] * force[..., j] - arm[..., j] * force[..., i] for i, j in ((1, 2), (2, 0), (0, 1))]
        moment = moment + sums @ np.stack(parts, axis=-1)
    names, _ = _supports(system)
    on = {"couplings": (couplings, list(system.model.couplings)), "springs": (elements, list(system.force_elements))}
    on["stops"] = on["springs"]
    for one in system.inner.holdings:
        values, known = on[one.table]
        if values is None:
            continue
        f, k, a = values[..., known.index(one.name), None], names.index(one.node), np.array(one.vector)
        if not one.arm:
            total[..., k, :] += f * a
            continue
        r = x[..., system.node_index(one.arm), :] - x[..., system.node_index(one.node), :]
        along = (r @ a)[..., None]
        square = (r * r).sum(axis=-1, keepdims=True)
        moment[..., k, :] += f * (a * square - r * along) / (square - along * along)
    words = "moment of a support on the structure, about its node"
    found = {"reaction": variable((*per, "support", "axis"), total[..., :dim], "N", "support force on the structure")}
    if clamps(system):
        turns = (*per, "support", "rotation")
        found["reaction_moment"] = variable(turns, moment[..., 3 - _turns(system) :], "N m", words)
    if (own := _own_axes(system)) is not None:
        said = "support force on the structure, along the axes of the support"
        along_own = np.einsum("kij,...kj->...ki", own, total)
        found["reaction_own"] = variable((*per, "support", "axis"), along_own[..., :dim], "N", said)
        if dim == 3 and clamps(system):
            said = "moment of a support on the structure, about its axes"
            found["reaction_moment_own"] = variable(turns, np.einsum("kij,...kj->...ki", own, moment), "N m", said)
    return found | {
        "held_force": variable((*per, HELD, "axis"), force[..., :dim], "N", "force on each node that a support holds")
    }


def rotation_columns(system: System, per: tuple[str, ...], turned: Callable[[], Floats]) -> dict[str, Column]:
    """The variable of the rotations of nodes that carry a frame, rad; none without frames. turned : (.., frames, 1 or 3)."""
    if not system.inner.frames:
        return {}
    return {"node_rotation": variable((*per, "frame", "about"), turned(), "rad", "rotation of nodes of beams from the model")}


def lifted(system: System, elements: Floats) -> list[str]:
    """Directions of supports with a gap in which they do not press, as ``A (y)``, from the forces (force_elements,)."""
    names = list(system.force_elements)
    stops = [one for one in system.inner.holdings if one.table == "stops"]
    return [one.text(system.dim) for one in stops if elements[names.index(one.name)] == 0.0]


def lifted_note(system: System, elements: Floats) -> str:
    """The sentence on supports that do not touch; empty if all do."""
    found = lifted(system, elements)
    return f"Within their gap, so that they hold nothing: supports {few(found, 8)}." if found else ""


def held_forces(data: Any) -> tuple[list[str], NDArray[np.float64]]:
    """All supported nodes, inner ones too, and the forces on them, from the arrays of a result."""
    of, axis = ("held_force", HELD) if "held_force" in data else ("reaction", "support")
    return [str(name) for name in data[axis].values], data[of].values


@cached()
def clamps(system: System) -> set[str]:
    """Supports that hold a rotation, so that they have a moment."""
    names, at = _supports(system)
    turning = {one.node for one in system.inner.holdings if one.arm}
    return turning | {name for k, name in enumerate(names) if at.count(k) > 1}


def users(whole: xr.Dataset) -> xr.Dataset:
    """A dataset without inner parts."""
    marks = {axis: whole[mark].values for axis, mark in MARKS.items() if mark in whole.coords}
    if not marks:
        return whole
    kept = {axis: np.flatnonzero(~inner) for axis, inner in marks.items()}
    # the user's are the first ones, so that values are not copied
    parts = {axis: slice(len(own)) if (own == np.arange(len(own))).all() else own for axis, own in kept.items()}
    gone = [MARKS[axis] for axis in marks]
    none = [axis for axis, own in kept.items() if axis in OF_SUPPORTS and not len(own)]
    return whole.drop_dims(HELD, errors="ignore").isel(parts).drop_vars(gone).drop_dims(none, errors="ignore")


def users_of(whole: xr.Dataset, name: str) -> Any:
    """Where the values of a variable that `users` keeps are among all of it, as an index."""
    marks = {axis: ~whole[mark].values for axis, mark in MARKS.items() if mark in whole.coords}
    found = [np.flatnonzero(marks[dim]) if dim in marks else np.arange(size) for dim, size in whole[name].sizes.items()]
    return np.ix_(*found) if found else ()


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
    """The user's supported nodes, and of every node that is held in place the index of that to which it belongs."""
    inner = system.inner.nodes
    at = [inner[name].at if name in inner else name for name in system.supports]
    names = list(dict.fromkeys(at))
    if more := {one.node for one in system.inner.holdings} - set(names):
        names = sorted([*names, *more], key=system.node_index)
    place = {name: k for k, name in enumerate(names)}
    return names, [place[name] for name in at]


@cached()
def _plain(system: System) -> bool:
    """True if every support holds its node only, along axes that are not turned."""
    names, at = _supports(system)
    return len(names) == len(at) and not system.inner.holdings and _own_axes(system) is None


@cached()
def _own_axes(system: System) -> NDArray[np.float64] | None:
    """Axes (supports, 3, 3) of the supports as rows, None if no support is turned."""
    names, model = _supports(system)[0], system.model
    own = [k for k, name in enumerate(names) if name in model.supports and not straight(model, name)]
    if not own:
        return None
    found = np.tile(np.eye(3), (len(names), 1, 1))
    for k in own:
        found[k, : system.dim, : system.dim] = axes_of_support(model, names[k])
    return found
