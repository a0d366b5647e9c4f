"""What a structure is made of, element by element: the tables from which all its forces and energies are found.

pairs        constant masses between two nodes: uniform bars, planar bodies, bodies carried by nodes
varying          members whose mass matrix turns with them: active members, bars with rotary inertia (kernels.structure.mass)
laws         constitutive laws: tension of bars by length and rate of length (kernels.structure.laws)
pins         friction between two bars that turn about one pin (kernels.structure.pins)
springs      laws on sums of coordinate terms (kernels.constraints.springs)
lump, share  masses at single nodes: lumped ones, which may have a gravity of their own, and shares of bodies
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Record, record

__all__ = ["EndForces", "NodalLoads", "States", "Structure"]


@record
class Structure(Record):
    """Element tables of a structure. Places of ends are flat, 3 node.

    pair_A, pair_B (k,) ends, pair (k, 4) : AA, AB, BB and the skew part of AB about z, kg; pair_member (k,) the member that it
    is, or -1. varying_A, varying_B (j,), varying (j, 6) : m_A, m_B, h_A, h_B, second moment, axial mass; varying_member (j,).
    law_A, law_B (s,), law_kind (s,), law (s, 3) : stiffness, natural length, damping; law_member (s,). pin_P, pin_A, pin_B (k,)
    the pin and the far ends of two bars (pin_B = pin_P: the ground), pin (k,) N m s. lump, share (n,) kg.
    spring (s, 8) : stiffness, rest, damping, friction, slip, play, preload, period; terms spring_ptr[k]:spring_ptr[k + 1] of
    spring k in spring_kind (t,), spring_at (t, 4), spring_data (t, 7) (constraints.terms), with their nodes P, 1, 2 as counted
    among those of the spring in spring_local (t, 3); points spring_table_ptr[k]:spring_table_ptr[k + 1] of its table in
    spring_table (p, 4) : deflection, force, slope, energy.
    """

    pair_A: I1
    pair_B: I1
    pair_member: I1
    varying_A: I1
    varying_B: I1
    varying_member: I1
    law_A: I1
    law_B: I1
    law_kind: I1
    law_member: I1
    pin_P: I1
    pin_A: I1
    pin_B: I1
    spring_ptr: I1
    spring_kind: I1
    spring_table_ptr: I1
    spring_at: I2
    spring_local: I2
    pair: F2
    varying: F2
    law: F2
    spring: F2
    spring_data: F2
    spring_table: F2
    pin: F1
    lump: F1
    share: F1


class NodalLoads(NamedTuple):
    """gravity (3,), lump_gravity (n, 3), m/s^2; node (loads,) and force (times, loads, 3), N."""

    gravity: np.ndarray
    lump_gravity: np.ndarray
    node: np.ndarray
    force: np.ndarray


class States(NamedTuple):
    """Histories x, v, a (times, 3 n); at rest v and a are one row of zeros, (1, 3 n)."""

    x: np.ndarray
    v: np.ndarray
    a: np.ndarray


class EndForces(NamedTuple):
    """joint (times, members, 2, 3) : force on each member at its ends, N; rest (times, 3 n) : what is left at the nodes, N."""

    joint: np.ndarray
    rest: np.ndarray
