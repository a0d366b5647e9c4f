"""Springs in the equations: their values, forces and energies along a motion, their tangents as sparse matrices."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.errors import AnalysisError
from kinetruss.kernels.constraints.springs import add_spring_forces, spring_blocks, spring_histories, spring_slopes
from kinetruss.mechanics.assembly.tables import elements, structure_of
from kinetruss.mechanics.kept import kept

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["SpringHistories", "refuse_turns", "spring_forces", "spring_laws", "spring_motions", "spring_tangents"]


class SpringHistories(NamedTuple):
    """value and rate of the coordinate (m or rad, m/s or rad/s), force on it (N or N m), energy (J), all (times, springs).

    An angle is known within half a turn of the rest.
    """

    value: NDArray[np.float64]
    rate: NDArray[np.float64]
    force: NDArray[np.float64]
    energy: NDArray[np.float64]


def spring_motions(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> SpringHistories:
    """The springs along x, v (times, n, 3) or flat; without v at rest. A positive force raises the coordinate."""
    place, rate = (
        np.ascontiguousarray(y, float).reshape(-1, system.x0.size) for y in (x, np.zeros(system.x0.size) if v is None else v)
    )
    found = np.empty((4, len(place), len(system.springs)))
    spring_histories(structure_of(system), place, rate, found)
    return SpringHistories(found[0] + system.spring_law[:, 1], *found[1:])


def refuse_turns(system: System, t: NDArray[np.float64], x: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Refuse motions x, v (times, 3 n) of angles beyond half a turn from the rest of a spring, where its law would jump.

    Of two samples on both sides of the jump, the rates distinguish the way over it from that through the rest.

    Raises
    ------
    AnalysisError : the spring and the time.
    """
    period = system.measure_period[system.spring_measure]
    if not np.any(period):
        return
    found = spring_motions(system, x, v)
    change, ahead = np.diff(found.value, axis=0), 0.5 * (found.rate[1:] + found.rate[:-1]) * np.diff(t)[:, None]
    over = (np.abs(change) > 0.5 * period) & (np.abs(change - np.sign(change) * period - ahead) < 0.25 * period)
    for i, k in np.argwhere(over & (period > 0.0))[:1]:
        raise AnalysisError(
            f"Spring {system.springs[k]!r} passes half a turn from its rest between t = {t[i]:.6g} and {t[i + 1]:.6g} s, where "
            "its law would jump. Give another rest, or the moment of a spring wound up by more as its preload."
        )


def spring_forces(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """Forces of springs on the nodes (3 n,), N, at x, v (n, 3); without v at rest."""
    found = np.zeros(system.x0.size)
    if system.springs:
        place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros_like(found) if v is None else v))
        add_spring_forces(structure_of(system), place, rate, found)
    return found


def spring_laws(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """Resistance F, dF/dc and dF/dc' of each spring (springs, 3) at x, v (n, 3)."""
    found = np.zeros((len(system.springs), 3))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(system.x0.size) if v is None else v))
    spring_slopes(structure_of(system), place, rate, found)
    return found


def spring_tangents(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None, law: NDArray[np.float64]
) -> tuple[Any, Any]:
    """K and C (3 n, 3 n), N/m and N s/m: minus the derivatives of the forces -F g by x and by v, both (n, 3).

    law (springs, 3) : F, dF/dc and dF/dc'. g, H : gradient and Hessian of c, so that C = dF/dc' g g^T and
    K = dF/dc g g^T + F H + dF/dc' g (H v)^T.
    """
    places = _places(system)
    count, width = places.shape
    blocks = np.empty((2, count, width, width))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(x.size) if v is None else v))
    spring_blocks(structure_of(system), places, place, rate, law, *blocks)
    rows, columns = np.repeat(places, width, axis=1).reshape(-1), np.tile(places, (1, width)).reshape(-1)
    own = (rows >= 0) & (columns >= 0)
    at, shape = (rows[own], columns[own]), (x.size, x.size)
    K, C = (csr_array(coo_array((one.reshape(-1)[own], at), shape=shape)) for one in blocks)
    return K, C


@kept()
def _places(system: System) -> NDArray[np.int64]:
    """Coordinates (springs, w) of the nodes of springs, ascending; those that have fewer end with -1."""
    found = elements(system)
    ptr, at = found["spring_ptr"], found["spring_at"]
    nodes = [np.unique(at[first:last, :3]) for first, last in pairwise(ptr)]
    places = np.full((len(nodes), max(map(len, nodes), default=0), 3), -1, np.int64)
    for one, own in zip(places, nodes, strict=True):
        one[: len(own)] = own[:, None] + np.arange(3)
    return places.reshape(len(nodes), places.shape[1] * 3)
