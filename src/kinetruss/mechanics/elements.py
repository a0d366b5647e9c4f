"""Springs, membranes, solids and beams in the equations: forces, energies and tangent stiffness at given positions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.elements import scalars
from kinetruss.elements.caching import cached
from kinetruss.elements.continua import edge_blocks, edge_densities, force as edge_forces
from kinetruss.elements.kinds import on_coordinates, spans_of
from kinetruss.errors import AnalysisError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.continua import Continua
    from kinetruss.mechanics.system import System


class Histories(NamedTuple):
    """value and rate of the coordinate (m or rad, m/s or rad/s), force on it (N or N m), energy (J), all (times, elements).

    An angle is known within half a turn of the rest.
    """

    value: NDArray[np.float64]
    rate: NDArray[np.float64]
    force: NDArray[np.float64]
    energy: NDArray[np.float64]


def scalar_motions(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> Histories:
    """Elements on coordinates along x, v (times, n, 3) or flat; without v at rest. A positive force raises the coordinate."""
    place, rate = (
        np.ascontiguousarray(y, float).reshape(-1, system.x0.size) for y in (x, np.zeros(system.x0.size) if v is None else v)
    )
    if (every := on_coordinates(system)) is None:
        return Histories(*np.zeros((4, len(place), 0)))
    found = np.empty((4, len(place), len(every.law)))
    scalars.histories(every, place, rate, found)
    return Histories(found[0] + every.rest, *found[1:])


def named_motions(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> Histories:
    """`scalar_motions` of those with a name, (times, force_elements)."""
    first = spans_of(system)["friction"].stop
    return Histories(*(one[:, first:] for one in scalar_motions(system, x, v)))


def refuse_turns(system: System, t: NDArray[np.float64], x: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Refuse motions x, v (times, 3 n) of angles beyond half a turn from the rest of an element, where its law would jump.

    Of two samples on both sides of the jump, the rates distinguish the way over it from that through the rest.

    Raises
    ------
    AnalysisError : the spring and the time.
    """
    period = system.measure_period[system.force_element_measure]
    if not np.any(period):
        return
    found = named_motions(system, x, v)
    change, ahead = np.diff(found.value, axis=0), 0.5 * (found.rate[1:] + found.rate[:-1]) * np.diff(t)[:, None]
    over = (np.abs(change) > 0.5 * period) & (np.abs(change - np.sign(change) * period - ahead) < 0.25 * period)
    for i, k in np.argwhere(over & (period > 0.0))[:1]:
        name = system.force_elements[k]
        kind = system.model.force_elements[name][0]
        raise AnalysisError(
            f"{kind.capitalize()} {name!r} passes half a turn from its rest between t = {t[i]:.6g} and {t[i + 1]:.6g} s, where "
            "its law would jump. Give another rest, or the moment of a spring wound up by more as its preload."
        )


def scalar_forces(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """Forces of elements on coordinates on the nodes (3 n,), N, at x, v (n, 3); without v at rest."""
    found = np.zeros(system.x0.size)
    if (every := on_coordinates(system)) is not None:
        place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros_like(found) if v is None else v))
        scalars.force(every, 0.0, place, rate, found)
    return found


def scalar_laws(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """Resistance F, dF/dq and dF/dq' of each element on a coordinate (elements, 3) at x, v (n, 3)."""
    if (every := on_coordinates(system)) is None:
        return np.zeros((0, 3))
    found = np.zeros((len(every.law), 3))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(system.x0.size) if v is None else v))
    scalars.slopes(every, place, rate, found)
    return found


def named_laws(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """`scalar_laws` of those with a name."""
    return scalar_laws(system, x, v)[spans_of(system)["friction"].stop :]


def scalar_tangents(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None, resistance: NDArray[np.float64]
) -> tuple[Any, Any]:
    """K and C (3 n, 3 n), N/m and N s/m: minus the derivatives of the forces -F g by x and by v, both (n, 3).

    resistance (elements, 3) : F, dF/dq and dF/dq'. g, H : gradient and Hessian of q, so that C = dF/dq' g g^T and
    K = dF/dq g g^T + F H + dF/dq' g (H v)^T.
    """
    every = _whole(system)
    places = _places(system)
    count, width = places.shape
    blocks = np.empty((2, count, width, width))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(x.size) if v is None else v))
    scalars.blocks(every, places, place, rate, resistance, *blocks)
    rows, columns = np.repeat(places, width, axis=1).reshape(-1), np.tile(places, (1, width)).reshape(-1)
    own = (rows >= 0) & (columns >= 0)
    at, shape = (rows[own], columns[own]), (x.size, x.size)
    K, C = (csr_array(coo_array((one.reshape(-1)[own], at), shape=shape)) for one in blocks)
    return K, C


@cached()
def _places(system: System) -> NDArray[np.int64]:
    """`scalars.coordinates` of a system that has such."""
    return scalars.coordinates(_whole(system))


def _whole(system: System) -> scalars.Scalars:
    return cast("scalars.Scalars", on_coordinates(system))


# Membranes, solids and beams at rest: forces, energy and tangent stiffness at given positions.


def squared_changes(found: Continua, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Squared lengths of the edges minus their stress-free values, (e,), m^2, at positions x (n, 3)."""
    d = x[found.q] - x[found.p]
    return np.asarray(np.einsum("ec,ec->e", d, d) - found.rest)


def densities(found: Continua, s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Force densities of the edges (e,), N/m, from changes s (e,), m^2, of their squared lengths."""
    q = np.empty(len(s))
    edge_densities(found.record, s, q)
    return q


def continua_forces(found: Continua, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces on the nodes (times, 3 n), N, at positions x (times, 3 n)."""
    out, rest = np.zeros_like(x), np.zeros(x.shape[1])
    for i in range(len(x)):
        edge_forces(found.record, 0.0, x[i], rest, out[i])
    return out


def resting_forces(found: Continua, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces on the nodes (n, 3), N, at positions x (n, 3); exactly 0 in the stress-free configuration."""
    # q d of each edge
    force = densities(found, squared_changes(found, x))[:, None] * (x[found.q] - x[found.p])
    out = np.zeros_like(x)
    np.add.at(out, found.p, force)
    np.subtract.at(out, found.q, force)
    return out


def continua_energy(found: Continua, x: NDArray[np.float64]) -> float:
    """Energy stored, J, at positions x (n, 3)."""
    s = squared_changes(found, x)
    return float(0.25 * s @ densities(found, s))


def continua_stiffness(
    found: Continua, x: NDArray[np.float64], q: NDArray[np.float64] | None = None, *, material: bool = True
) -> Any:
    """Tangent stiffness (3 n, 3 n), N/m, at positions x (n, 3).

    q (e,) : force densities of the geometric part, by default those at x. material : include the material part as well.
    """
    A, B = found.record.A, found.record.B
    density = densities(found, squared_changes(found, x)) if q is None else q
    # geometric part -q 1 of K_pq
    blocks = -density[:, None] * np.eye(3).reshape(-1)
    if material:
        edge_blocks(found.record, density, np.ascontiguousarray(x, float).reshape(-1), blocks)
    n = x.shape[0]
    # K_pp = -sum of K_pq over the neighbours q, symmetric but for round-off
    own = np.zeros((n, 9))
    np.subtract.at(own, found.p, blocks)
    np.subtract.at(own, found.q, blocks[:, [0, 3, 6, 1, 4, 7, 2, 5, 8]])
    own = 0.5 * (own + own[:, [0, 3, 6, 1, 4, 7, 2, 5, 8]])
    every = 3 * np.arange(n)
    row, column = np.divmod(np.arange(9), 3)
    # blocks pq, qp and pp
    i = np.concatenate([(A[:, None] + row).reshape(-1), (B[:, None] + column).reshape(-1), (every[:, None] + row).reshape(-1)])
    j = np.concatenate(
        [(B[:, None] + column).reshape(-1), (A[:, None] + row).reshape(-1), (every[:, None] + column).reshape(-1)]
    )
    value = np.concatenate([blocks.reshape(-1), blocks.reshape(-1), own.reshape(-1)])
    return csr_array((value, (i, j)), shape=(3 * n, 3 * n))


def material_stiffness(system: System, x: NDArray[np.float64]) -> Any:
    """Stiffness (3 n, 3 n), N/m, of membranes, solids and beams at x (n, 3), without that of their stresses there."""
    if system.continua is None:
        return csr_array((x.size, x.size))
    return continua_stiffness(system.continua, x, np.zeros(len(system.continua.p)))


def continua_geometric(found: Continua, x: NDArray[np.float64], u: NDArray[np.float64]) -> Any:
    """Geometric stiffness (3 n, 3 n), N/m, of the stresses that small displacements u (n, 3) from x (n, 3) add."""
    d = x[found.q] - x[found.p]
    # squared_changes to first order in u: 2 d . (u_q - u_p)
    added = densities(found, 2 * np.einsum("ec,ec->e", d, u[found.q] - u[found.p]))
    return continua_stiffness(found, x, added, material=False)
