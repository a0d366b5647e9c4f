"""Mass, damping and stiffness of a structure as sparse matrices, assembled member by member."""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array

from kinetruss.elements.caching import cached
from kinetruss.kernels.structure.laws import law_values
from kinetruss.mechanics.elements import element_tangents
from kinetruss.mechanics.row_gradients import angle_hessians, direction_rates, dot, ends_of, length_hessians
from kinetruss.mechanics.tables import elements, mass_of_pairs

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


class BarLaws(NamedTuple):
    """tension, N; slope dN/dL, N/m; damping dN/dL', N s/m; energy, J; all (..., members), 0 for bars without a law."""

    tension: NDArray[np.float64]
    slope: NDArray[np.float64]
    damping: NDArray[np.float64]
    energy: NDArray[np.float64]


def bar_laws(
    system: System, L: NDArray[np.float64], Ld: NDArray[np.float64] | None = None, member: Any = slice(None)
) -> BarLaws:
    """The laws of members (k,), all by default, at lengths L and their rates (..., k), m and m/s; without rates, at rest."""
    kind, k, l0, c = (one[member] for one in (system.law, system.spring, system.natural, system.damping))
    flat, found = (prod(np.shape(L)[:-1]), len(kind)), np.empty((4, *np.shape(L)))
    rates = np.zeros((1, len(kind))) if Ld is None else np.asarray(Ld, float).reshape(flat)
    law_values(kind, k, l0, c, np.asarray(L, float).reshape(flat), rates, found.reshape(4, *flat))
    return BarLaws(*found)


# Mass, damping and stiffness of a structure as sparse matrices, assembled member by member.
#
#     M : uniform bar m/6 [[2, 1], [1, 2]], planar body, base rod and tube, lumped masses, bodies
#     C : dN/dL' u u^T of dampers + dF/dq' g g^T of elements on coordinates
#     K : dN/dL u u^T of laws + N/L P of every member that carries a force, rigid ones too, + T/L^2 (n u^T + u n^T) of torques,
#         + the tangents of elements on coordinates, of membranes and solids
#
# All are by flat coordinates 3 node + axis; K is minus the derivative of the forces on the nodes at fixed multipliers. Members
# whose inertia depends on where they point (base rod and tube, rotary inertia) are differentiated by complex steps, which is
# exact to round-off (Squire & Trapp, SIAM Review 40 (1998) 110-112).

STEP = 1e-30
"""Size of complex steps: its square underflows to 0 beside 1."""


def mass_matrix(system: System, x: NDArray[np.float64]) -> Any:
    """M (3 n, 3 n), kg, at positions x (n, 3): the constant part, and the members whose mass matrix depends on their
    direction.

    Blocks of those: AA = m_A 1 + p P, AB = -p P ... with P = 1 - u u^T (kernels.structure.mass).
    """
    found = elements(system)
    if not len(found["varying"]):
        return constant_mass(system)
    A, B = found["varying_A"] // 3, found["varying_B"] // 3
    AA, AB, BB = varying_blocks(system, x)
    own = np.concatenate([3 * A[:, None] + np.arange(3), 3 * B[:, None] + np.arange(3)], axis=1)
    where = np.repeat(own, 6, axis=1).reshape(-1), np.tile(own, (1, 6)).reshape(-1)
    return constant_mass(system) + csr_array((_blocks(AA, AB, AB, BB).reshape(-1), where), shape=(system.x0.size,) * 2)


def mass_by_nodes(system: System) -> NDArray[np.float64]:
    """Mass (n,) of everything, kg, by nodes: in their sum, twice the kinetic energy in a translation at 1 m/s."""
    moved = np.zeros_like(system.x0)
    moved[[not node.scalar for node in system.model.nodes.values()], 0] = 1.0
    way = moved.reshape(-1)
    return np.asarray((way * (mass_matrix(system, system.x0) @ way)).reshape(-1, 3)[:, 0])


def varying_blocks(system: System, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
    """Blocks AA, AB = BA, BB (..., k, 3, 3), kg, of the members whose mass matrix depends on their direction, at positions x
    (..., n, 3).
    """
    found = elements(system)
    A, B = found["varying_A"] // 3, found["varying_B"] // 3
    d = x[..., B, :] - x[..., A, :]
    L = np.linalg.norm(d, axis=-1)[..., None, None]
    u = d[..., None] / L
    m_A, m_B, h_A, h_B, second, axial = (column[:, None, None] for column in found["varying"].T)
    # s 1 + r u u^T of each block, written with the projector P across the member
    outer, turn = u * u.swapaxes(-1, -2), second / L**2
    P, along = np.eye(3) - outer, axial * outer
    AA = m_A * np.eye(3) + (turn - 2 * h_A / L) * P + along
    AB = ((h_A + h_B) / L - turn) * P - along
    BB = m_B * np.eye(3) + (turn - 2 * h_B / L) * P + along
    return AA, AB, BB


@cached()
def constant_mass(system: System) -> Any:
    """M (3 n, 3 n), kg, of masses at nodes and between pairs of them."""
    found = elements(system)
    return mass_of_pairs(found["pair_A"], found["pair_B"], found["pair"], found["lump"] + found["share"])


@cached()
def body_and_continua_mass(system: System) -> Any:
    """M (3 n, 3 n), kg, of bodies, membranes and solids; constant."""
    found = elements(system)
    own = found["pair_member"] < 0
    return mass_of_pairs(found["pair_A"][own], found["pair_B"][own], found["pair"][own], found["share"])


def tangents(
    system: System,
    x: NDArray[np.float64],
    tension: NDArray[np.float64],
    torque: NDArray[np.float64],
    gravity: NDArray[np.float64],
    v: NDArray[np.float64] | None = None,
    a: NDArray[np.float64] | None = None,
) -> tuple[Any, Any]:
    """`member_tangents` and those of elements of all kinds."""
    members, others = member_tangents(system, x, tension, torque, gravity, v, a), element_tangents(system, x, v)
    return members[0] + others[0], members[1] + others[1]


def member_tangents(
    system: System,
    x: NDArray[np.float64],
    tension: NDArray[np.float64],
    torque: NDArray[np.float64],
    gravity: NDArray[np.float64],
    v: NDArray[np.float64] | None = None,
    a: NDArray[np.float64] | None = None,
) -> tuple[Any, Any]:
    """Stiffness K and damping C (3 n, 3 n), N/m and N s/m: minus the derivatives of f - M a - J^T N by x and by v,
    of members: bars with their laws and forces, and inertia and weight that turn with them.

    x, v, a (n, 3). tension (m,): total axial force of each member, N. torque (m,): the torque on it, N m. gravity (3,).
    """
    d, L, u = ends_of(system, x)
    dv = np.zeros_like(d) if v is None else v[system.q] - v[system.p]
    Ld = np.einsum("mc,mc->m", u, dv)
    _, slope, damping, _ = bar_laws(system, L, Ld)
    outer, H = u[:, :, None] * u[:, None, :], length_hessians(u, L)
    # dN/dL u u^T + N/L (1 - u u^T): material and geometric stiffness
    k = slope[:, None, None] * outer + _geometric(u, L, tension, torque)
    if np.any(damping) and np.any(dv):
        # c L' u: L' changes with the direction
        k += damping[:, None, None] * u[:, :, None] * np.einsum("mij,mj->mi", H, dv)[:, None, :]
    # dN/dL' u u^T
    c = damping[:, None, None] * outer
    k6, c6 = _blocks(k, -k, -k, k), _blocks(c, -c, -c, c)
    turning = turning_members(system)
    if len(turning):
        kt, ct = _turning_tangents(system, turning, x, v, a, gravity)
        k6[turning] += kt
        c6[turning] += ct
    K = _assembled(system, k6)
    C = _assembled(system, c6) if np.any(damping) or len(turning) else csr_array(K.shape)
    return K, C


def geometric_stiffness(
    system: System, x: NDArray[np.float64], tension: NDArray[np.float64], torque: NDArray[np.float64]
) -> Any:
    """The part (3 n, 3 n), N/m, of the stiffness of members that their axial forces (m,), N, and torques, N m, make."""
    _, L, u = ends_of(system, x)
    k = _geometric(u, L, tension, torque)
    return _assembled(system, _blocks(k, -k, -k, k))


def _geometric(
    u: NDArray[np.float64], L: NDArray[np.float64], tension: NDArray[np.float64], torque: NDArray[np.float64]
) -> NDArray[np.float64]:
    k: NDArray[np.float64] = tension[:, None, None] * length_hessians(u, L)
    if np.any(torque):  # of the transverse forces that it makes
        k -= (torque / L)[:, None, None] * angle_hessians(u, L)
    return k


def turning_members(system: System) -> NDArray[np.int64]:
    """Members whose inertia or weight depends on their direction."""
    return elements(system)["varying_member"]


def turning_inertia(
    system: System, members: NDArray[np.int64], x: NDArray[Any], v: NDArray[Any], a: NDArray[Any], g: NDArray[np.float64]
) -> NDArray[Any]:
    """Inertia forces minus weight at the ends of `turning_members`, (..., members, 2, 3) N; x, v, a (..., members, 2, 3)
    may be complex.

    For active members the whole force; for uniform bars the part by rotary inertia alone. See `kernels.structure.mass`.
    """
    (A, B), (vA, vB), (aA, aB) = ((y[..., 0, :], y[..., 1, :]) for y in (x, v, a))
    (L, _, Ldd), (u, w, s) = direction_rates(B - A, vB - vA, aB - aA)
    # component of u'' across u
    cross = s + dot(w, w) * u
    found = elements(system)
    m_A, m_B, h_A, h_B, second, axial = (
        column[:, None] for column in found["varying"][np.searchsorted(found["varying_member"], members)].T
    )
    bA, bB = aA - g, aB - g
    # transverse inertia force of the first moments h and the second moment J, and the axial mass m L''
    swing = (h_A * (bA - dot(bA, u) * u) - h_B * (bB - dot(bB, u) * u) + second * cross) / L + axial * Ldd * u
    return np.stack([m_A * bA + h_A * s - swing, m_B * bB - h_B * s + swing], axis=-2)


def _turning_tangents(
    system: System,
    members: NDArray[np.int64],
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None,
    a: NDArray[np.float64] | None,
    g: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """d(forces of the ends)/dx and /dv, (members, 6, 6)."""
    ends = np.stack([system.p[members], system.q[members]], axis=1)
    at = [np.zeros((*ends.shape, 3)) if y is None else y[ends] for y in (x, v, a)]
    found = []
    # complex steps: derivative of the end forces by x, then by v
    for order in range(2):
        stepped = [y + np.zeros((6, *y.shape), complex) for y in at]
        for k in range(6):
            stepped[order][k, :, k // 3, k % 3] += 1j * STEP
        found.append(turning_inertia(system, members, stepped[0], stepped[1], stepped[2], g).imag / STEP)
    k6, c6 = (np.asarray(one.reshape(6, len(members), 6).transpose(1, 2, 0)) for one in found)
    return k6, c6


def _blocks(AA: Any, AB: Any, BA: Any, BB: Any) -> NDArray[np.float64]:
    """(m, 6, 6) from (m, 3, 3)."""
    return np.concatenate([np.concatenate([AA, AB], axis=2), np.concatenate([BA, BB], axis=2)], axis=1)


@cached()
def _pattern(system: System) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Places of the entries of (m, 6, 6) in a sparse matrix: place, columns, row pointers."""
    own = np.concatenate([3 * system.p[:, None] + np.arange(3), 3 * system.q[:, None] + np.arange(3)], axis=1).astype(np.int64)
    size = system.x0.size
    rows = np.repeat(own, 6, axis=1).reshape(-1)
    columns = np.tile(own, (1, 6)).reshape(-1)
    found, place = np.unique(rows * size + columns, return_inverse=True)
    pointers = np.searchsorted(found // size, np.arange(size + 1))
    return place.reshape(-1), found % size, pointers


def _assembled(system: System, blocks: NDArray[np.float64]) -> Any:
    place, columns, pointers = _pattern(system)
    data = np.bincount(place, weights=blocks.reshape(-1), minlength=len(columns))
    return csr_array((data, columns, pointers), shape=(system.x0.size,) * 2)
