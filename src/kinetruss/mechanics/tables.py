"""The element tables of a compiled model: constant and changing masses, laws of bars, pins, springs, masses at nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np
from scipy.sparse import csr_array

from kinetruss.elements.caching import cached
from kinetruss.elements.kinds import element_arrays
from kinetruss.elements.numbers import chosen
from kinetruss.kernels.structure.structure import NodalLoads, Structure
from kinetruss.mechanics.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.continua_arrays import Continua
    from kinetruss.mechanics.loads import Loads


@cached()
def structure_of(system: System) -> Structure:
    """The record of a structure."""
    return Structure.of(structure_arrays(system))


def structure_arrays(system: System) -> dict[str, NDArray[Any]]:
    """Fields of `Structure` by name; read-only."""
    return elements(system) | element_arrays(system)


def nodal_loads(loads: Loads) -> NodalLoads:
    """Loads of a case, all of them on nodes, as kernels take them."""
    return NodalLoads(loads.gravity, loads.lump_gravity, loads.node, loads.force, np.asarray(loads.t, float))


@cached()
def elements(system: System) -> dict[str, NDArray[Any]]:
    """Fields of `Structure` by name, without the table of kinds; read-only."""
    share = system.node_mass - system.lump
    if system.continua is not None:
        share = share + system.continua.lump
    own = {"lump": system.lump, "share": share}
    return _pairs(system) | _varying(system) | _laws(system) | own


def _pairs(system: System) -> dict[str, NDArray[Any]]:
    """Members of constant mass, then masses of bodies, membranes and solids between two nodes."""
    rods, lead = system.rods, system.rods.shape[:-2]
    heavy = chosen(rods[..., 0] != 0.0, "bars without mass")
    steady = np.flatnonzero(~system.two_rods & (heavy | system.is_body))
    mass = np.zeros((*lead, len(steady), 4), rods.dtype)
    # uniform bar: m/6 [[2, 1], [1, 2]]
    mass[..., 0] = mass[..., 2] = rods[..., steady, 0] / 3.0
    mass[..., 1] = rods[..., steady, 0] / 6.0
    at = system.is_body[steady]
    bodies = steady[at]
    m, e, f, inertia = np.moveaxis(system.body[..., bodies, :], -1, 0)
    mass[..., at, :] = planar_body_mass(m, e, f, inertia, system.length0[..., bodies])
    # bodies on nodes, membranes and solids: AB alone; AA and BB stand with the nodes (share)
    apart = np.flatnonzero(system.pair_p != system.pair_q)
    p, q = [system.p[steady], system.pair_p[apart]], [system.q[steady], system.pair_q[apart]]
    between, skew = [system.pair_mass[..., apart]], [system.pair_skew[..., apart]]
    if (found := system.continua) is not None and found.lump.any():
        p, q, between = [*p, found.p], [*q, found.q], [*between, found.mass]
        skew.append(np.zeros((*lead, len(found.p))))
    more = np.zeros((*lead, sum(one.shape[-1] for one in between), 4), rods.dtype)
    more[..., 1], more[..., 3] = np.concatenate(between, axis=-1), np.concatenate(skew, axis=-1)
    return {
        "pair_A": 3 * np.concatenate(p).astype(np.int64),
        "pair_B": 3 * np.concatenate(q).astype(np.int64),
        "pair": np.concatenate([mass, more], axis=-2),
        "pair_member": np.concatenate([steady, np.full(more.shape[-2], -1)]),
    }


def mass_of_pairs(A: NDArray[np.int64], B: NDArray[np.int64], pair: NDArray[np.float64], lump: NDArray[np.float64]) -> Any:
    """M (3 n, 3 n), kg, of mass pairs (`Structure`) and of masses at nodes, lump (n,)."""
    AA, AB, BB, s = pair.T
    nodes = np.arange(0, 3 * len(lump), 3)
    # s 1 of each block
    plain = [(nodes, nodes, lump), (A, A, AA), (B, B, BB), (A, B, AB), (B, A, AB)]
    entries = [(i + c, j + c, m) for i, j, m in plain for c in range(3)]
    # skew part of AB of planar bodies
    entries += [(A, B + 1, -s), (A + 1, B, s), (B, A + 1, s), (B + 1, A, -s)]
    i, j, m = (np.concatenate(part) for part in zip(*entries, strict=True))
    kept = m != 0.0
    return csr_array((m[kept], (i[kept], j[kept])), shape=(3 * len(lump),) * 2)


def pair_weights(pair: NDArray[np.float64], g: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weight (k, 2, 3), N, of mass pairs (k, 4) at their first and second node under gravity g (3,), m/s^2."""
    AA, AB, BB, skew = pair.T[:, :, None]
    # the skew part of planar bodies acts across g
    turned = skew * np.array([-g[1], g[0], 0.0])
    return np.stack([(AA + AB) * g + turned, (AB + BB) * g - turned], axis=1)


def planar_body_mass(mass: Any, e: Any, f: Any, inertia: Any, length: Any) -> NDArray[np.float64]:
    """AA, AB, BB and the skew part (..., 4), kg, of planar bodies carried by the two ends of a bar.

    A point of the body at (xi, eta) l from the first end, along and to the left of the bar, moves as z = p (1 - w) + q w with
    w = xi + i eta in complex notation, so for [x_A, y_A, x_B, y_B], with mass m, centre (e, f), central inertia I, length l:

        M = [ AA    0    AB  -skew ]    AA = (I + m (l - e)^2 + m f^2)/l^2     AB   = -(I - m e (l - e) + m f^2)/l^2
            [  0   AA  skew    AB  ]    BB = (I + m e^2 + m f^2)/l^2           skew = m f/l
            [ AB  skew   BB     0  ]
            [-skew AB    0     BB  ]    det M = (m I/l^2)^2; M does not change under rotation.

    Weight is a force at the centre, hence M [g; g], constant as well. The concept: J. P. Meijaard, V. van der Wijk, Multibody
    System Dynamics 48 (2020) 259-282; derived here from the moments of the body, the same as natural coordinates (Garcia de
    Jalon, Bayo, 1994).
    """
    polar, left = inertia + mass * f**2, length - e
    AA, AB, BB = polar + mass * left**2, mass * e * left - polar, polar + mass * e**2
    return np.stack([AA / length**2, AB / length**2, BB / length**2, mass * f / length], axis=-1)


@cached()
def body_masses(system: System) -> Any:
    """M (3 n, 3 n), kg, of the bodies that nodes carry; constant."""
    apart = system.pair_p != system.pair_q
    pair = np.zeros((int(apart.sum()), 4))
    pair[:, 1], pair[:, 3] = system.pair_mass[apart], system.pair_skew[apart]
    A, B = (3 * ends[apart].astype(np.int64) for ends in (system.pair_p, system.pair_q))
    return mass_of_pairs(A, B, pair, system.node_mass - system.lump)


@cached()
def continua_mass(system: System) -> Any:
    """M (3 n, 3 n), kg, of the membranes and solids of a system that has some; constant."""
    found = cast("Continua", system.continua)
    pair = np.zeros((len(found.p), 4))
    pair[:, 1] = found.mass
    return mass_of_pairs(3 * found.p.astype(np.int64), 3 * found.q.astype(np.int64), pair, found.lump)


def _varying(system: System) -> dict[str, NDArray[Any]]:
    """Active members and bars with rotary inertia: m_A, m_B, h_A, h_B, J and axial mass (kernels.structure.mass)."""
    members = np.flatnonzero(system.two_rods | chosen(system.rods[..., 2].real > 0.0, "rotary inertia of bars"))
    m_b, l_b, r_b, m_t, l_t, r_t = np.moveaxis(system.rods[..., members, :], -1, 0)
    out = np.zeros((*m_b.shape, 6), m_b.dtype)
    two = system.two_rods[members]
    # J: second moments about the ends, and rotary inertias
    out[..., 4] = np.where(two, (m_b * l_b**2 + m_t * l_t**2) / 3.0 + r_b + r_t, r_b)
    # m_A, m_B and first moments h_A, h_B of active members
    for k, values in enumerate((m_b, m_t, 0.5 * m_b * l_b, 0.5 * m_t * l_t)):
        out[..., k] = np.where(two, values, 0.0)
    p, q = system.p[members].astype(np.int64), system.q[members].astype(np.int64)
    return {"varying_A": 3 * p, "varying_B": 3 * q, "varying": out, "varying_member": members}


def _laws(system: System) -> dict[str, NDArray[Any]]:
    members = np.flatnonzero(system.law)
    return {
        "law_A": 3 * system.p[members].astype(np.int64),
        "law_B": 3 * system.q[members].astype(np.int64),
        "law_kind": system.law[members].astype(np.int64),
        "law_member": members,
        "law": np.stack([one[..., members] for one in (system.spring, system.natural, system.damping)], axis=-1),
    }
