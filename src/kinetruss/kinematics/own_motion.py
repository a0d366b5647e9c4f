"""Check that a model can follow a motion: its nodes, its rigid and fixed parts, its drive positions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from kinetruss.errors import InputError, shown
from kinetruss.kernels.structure.structure import ANGLE, LENGTH
from kinetruss.mechanics import System, cached, measured
from kinetruss.mechanics.positions import drive_places, shortest
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.results import Motion
from kinetruss.results.records import check_samples

if TYPE_CHECKING:
    from numpy.typing import NDArray


OWN = 1e-6
"""Largest misfit of a computed motion, as a fraction of the length or, for angles, in rad."""

GIVEN = 1e-2
"""The same for a given motion that does not record its misfit."""

MEND = "Follow this model's own trajectory."


class Misfit(NamedTuple):
    """A difference between a motion and the model: what, its size (fraction of a length, or rad), and its time (s)."""

    kind: Literal["place", "length", "coupling", "drive"]
    what: str
    share: float
    text: str


def check_motion(system: System, motion: Motion, *, members: bool = False) -> None:
    """Refuse a motion that the model cannot follow.

    Rigid lengths, couplings and fixed places must be those of the model within 1e-6, and the drives must have the positions
    that the motion says. For a given motion (`from_arrays`, `from_csv`), misfits up to those to its own model are allowed.

    Parameters
    ----------
    members : the members and drives of the motion must be those of the model, too.

    Raises
    ------
    InputError : no sample; other nodes, members or drives; a fixed or rigid part of the model changes in the motion.
    """
    if not isinstance(motion, Motion):
        raise InputError(f"{shown(motion)} is not a motion. Give one, e.g. of kinematics.follow.")
    found = motion.arrays
    check_samples(motion)
    if not _same(found["node"].values, system.nodes):
        raise InputError(f"The motion belongs to a model with other nodes. {MEND}")
    if members and not _same(found["member"].values, system.members):
        raise InputError(f"The motion belongs to a model with other nodes or members. {MEND}")
    if members and not _same(found["drive"].values, system.drives):
        raise InputError(f"The motion belongs to a model with other drives. {MEND}")
    given = motion.attrs.get("trajectory_space") == "given"
    allowed = max(OWN, 1.5 * float(motion.attrs.get("misfit", GIVEN))) if given else OWN
    x = flat_positions(system, found["position"].values)
    own = "length" in found and _same(found["member"].values, system.members)
    length = found["length"].values if own else lengths_of(system, x)
    off = misfits(system, x, length, allowed)
    if not off and system.drives and _same(found["drive"].values, system.drives):
        off = _drive_misfits(system, x, length, found["drive_position"].values, allowed)
    if off:
        worst = max(off, key=lambda one: one.share if np.isfinite(one.share) else np.inf)
        more = f" So are {len(off) - 1} more." if len(off) > 1 else ""
        raise InputError(f"The motion is not of this model: {worst.text}.{more} {MEND}")


def _same(found: NDArray[Any], names: tuple[str, ...]) -> bool:
    """Whether the names along an axis are these, in this order."""
    own: bool = found.tolist() == list(names)
    return own


def lengths_of(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Lengths (times, members), m, at flat positions x (times, 3 n)."""
    nodes = x.reshape(len(x), len(system.nodes), 3)
    return np.asarray(np.linalg.norm(nodes[:, system.q] - nodes[:, system.p], axis=2))


def misfits(system: System, x: NDArray[np.float64], length: NDArray[np.float64], allowed: float) -> list[Misfit]:
    """Rigid lengths, couplings and fixed places with more than the allowed misfit, at their worst sample.

    x : flat positions (times, 3 n), m. length : (times, members), m.
    """
    if not len(x):
        return []
    return [*_places(system, x, allowed), *_lengths(system, length, allowed), *_couplings(system, x, allowed)]


def _places(system: System, x: NDArray[np.float64], allowed: float) -> list[Misfit]:
    """Fixed coordinates, without moving supports."""
    flats = _fixed(system)
    start = system.x0.reshape(-1)[flats]
    off = np.abs(x[:, flats] - start)
    if not off.size or off.max() <= allowed * shortest(system):
        return []
    worst, columns = off.argmax(axis=0), np.arange(len(flats))
    share = off[worst, columns] / shortest(system)
    found = []
    for j in np.flatnonzero(~(share <= allowed)):
        at, axis = divmod(int(flats[j]), 3)
        name = f"{system.nodes[at]}.{'xyz'[axis]}"
        text = f"{name} is fixed at {start[j]:.6g} m in the model, in it at {x[worst[j], flats[j]]:.6g} m"
        found.append(Misfit("place", name, float(share[j]), text))
    return found


@cached()
def _fixed(system: System) -> NDArray[np.int64]:
    """Flat coordinates that are fixed and that no support moves."""
    held = system.prescribed.copy()
    held[system.coordinate_drive[:, 0]] = False
    for node in system.model.support_motion:
        held[3 * system.node_index(node) :][:3] = False
    return np.flatnonzero(held)


@cached()
def _rigid(system: System) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Members whose length is kept, the length, and the length in shares of which it may be off, m."""
    rows = np.flatnonzero((system.row_kind == LENGTH) & (system.row_drive < 0))
    wanted = system.row_value[rows]
    return system.row_member[rows].astype(np.int64), wanted, np.maximum(wanted, 1e-3 * shortest(system))


def _lengths(system: System, length: NDArray[np.float64], allowed: float) -> list[Misfit]:
    """Rigid bars."""
    member, wanted, scale = _rigid(system)
    if not len(member):
        return []
    length = length[:, member]
    off = np.abs(length - wanted)
    off /= scale
    worst = off.argmax(axis=0)
    share = off[worst, np.arange(len(member))]
    found = []
    for j in np.flatnonzero(~(share <= allowed)):
        name = system.members[member[j]]
        text = f"{name!r} is {wanted[j]:.6g} m long in the model, in it {length[worst[j], j]:.6g} m"
        found.append(Misfit("length", name, float(share[j]), text))
    return found


def _couplings(system: System, x: NDArray[np.float64], allowed: float) -> list[Misfit]:
    found = []
    nodes = x.reshape(len(x), -1, 3)
    for r in system.sums[system.row_drive[system.sums] < 0]:
        m = system.row_measure[r]
        off = _wrapped(measured(system, m, nodes)[:, 0] - system.row_value[r], float(system.measure_period[m]))
        share = float(np.abs(off * system.measure_scale[m]).max()) / shortest(system)
        if share <= allowed:
            continue
        found.append(
            Misfit(
                "coupling",
                system.row_name(r),
                share,
                f"coupling {system.row_name(r)!r} is off by {np.abs(off).max():.3g} in it",
            )
        )
    return found


def _drive_misfits(
    system: System, x: NDArray[np.float64], length: NDArray[np.float64], given: NDArray[np.float64], allowed: float
) -> list[Misfit]:
    """Drives: their positions by the nodes, compared with those that the motion says."""
    if not len(x) or not len(system.drives):
        return []
    driven = np.flatnonzero(system.row_drive >= 0)
    along = driven[system.row_kind[driven] == LENGTH]
    if len(along) == len(system.drives):
        value = np.empty_like(given)
        value[:, system.row_drive[along]] = length[:, system.row_member[along]]
    else:
        nodes = x.reshape(len(x), -1, 3)
        value = drive_places(system, nodes)
    off, periods = value - given, _periods(system)
    size = max(shortest(system), 1e-300)
    found = []
    for d, (name, period) in enumerate(zip(system.drives, periods, strict=True)):
        share = np.abs(_wrapped(off[:, d], period)) / (1.0 if period > 0 else size)
        k = int(share.argmax())
        if share[k] <= allowed:
            continue
        text = f"drive {name!r} stands at {given[k, d]:.6g} in it, where the model's nodes have {given[k, d] + off[k, d]:.6g}"
        found.append(Misfit("drive", name, float(share[k]), text))
    return found


@cached()
def _periods(system: System) -> tuple[float, ...]:
    """Of each drive, after which its values are the same (0: never)."""
    period = np.zeros(len(system.drives))
    turned = (system.row_drive >= 0) & (system.row_kind == ANGLE)
    period[system.row_drive[turned]] = 2 * np.pi
    own = system.drive_measure >= 0
    period[own] = system.measure_period[system.drive_measure[own]]
    return tuple(period.tolist())


def _wrapped(off: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Differences of values that are equal after a period (0: none)."""
    return off - period * np.round(off / period) if period > 0 else off
