"""Elements of all kinds in the equations: a row of addresses for each kind that a structure has, and the loops over the rows.

A kind is a record of all its elements and some kernels on it (kinetruss.elements). Nothing here knows which there are: its
buffers stand one behind the other in `element_ints` and `element_reals` of the structure.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.calls import Interface
from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, I1, I2, Record
from kinetruss.kernels.structure.structure import Structure

FORCE, ENERGY, BALANCE, TANGENT, SWAP, INTS, INTS_END, REALS, REALS_END = range(9)
"""Columns of `Structure.element`: addresses, and where the buffers of the record begin and end."""


@Interface
def force(s: Record, t: float, x: F1, v: F1, f: F1) -> None:
    """Add the nodal forces (N) at time t (s), positions x and velocities v (3 n,) to f (3 n,)."""


@Interface
def energy(s: Record, x: F1) -> float:
    """Energy stored, J."""
    raise NotImplementedError  # never called: a declaration, of which Interface reads the annotations


@Interface
def balance(s: Record, t: float, x: F1, v: F1, out: F1) -> None:
    """Add the energy (J), its rate (W) and the power taken (W) to out (3,)."""


@Interface
def tangent(s: Record, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """Add beta K + gamma C to the lower triangle of a matrix in value; K, C : minus the derivatives of the forces by x and v.

    at (rows, w w) : places of the entries between the w coordinates of each row of the coordinates of the kind.
    """


@Interface
def swap(s: Record, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:
    """Replace the forces at (xe, ve), the middle of a step of h (s) from x0 to x1, in f by such as keep the energy.

    f already has those at (xe, ve): add what the others exceed them by.
    """


INTERFACES = (force, energy, balance, tangent, swap)
"""Those of the columns FORCE to SWAP."""

_force, _energy, _balance, _tangent, _swap = (one.call for one in INTERFACES)


@kernel_inline
def forces_of(e: I2, ints: I1, reals: F1, t: float, x: F1, v: F1, f: F1) -> None:
    """Add the nodal forces of all kinds of a table to f."""
    for k in range(e.shape[0]):
        _force(e[k, FORCE], (ints[e[k, INTS] : e[k, INTS_END]], reals[e[k, REALS] : e[k, REALS_END]], t, x, v, f))


@kernel_inline
def element_forces(s: Structure, t: float, x: F1, v: F1, f: F1) -> None:
    """Add the nodal forces of all elements to f."""
    forces_of(s.element, s.element_ints, s.element_reals, t, x, v, f)


@kernel_inline
def element_energies(s: Structure, x: F1) -> float:
    """Energy stored in all elements, J."""
    e, ints, reals, total = s.element, s.element_ints, s.element_reals, 0.0
    for k in range(e.shape[0]):
        total += _energy(e[k, ENERGY], (ints[e[k, INTS] : e[k, INTS_END]], reals[e[k, REALS] : e[k, REALS_END]], x))
    return total


@kernel_inline
def element_balances(s: Structure, t: float, x: F1, v: F1, out: F1) -> None:
    """Add energy, its rate and the power taken of all elements to out (3,)."""
    e, ints, reals = s.element, s.element_ints, s.element_reals
    for k in range(e.shape[0]):
        _balance(e[k, BALANCE], (ints[e[k, INTS] : e[k, INTS_END]], reals[e[k, REALS] : e[k, REALS_END]], t, x, v, out))


@kernel_bare
def element_tangents(s: Structure, places: I1, ptr: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """Add beta K + gamma C of all elements; places : of kind k in places[ptr[k, 0]:], ptr[k, 1:] rows and columns."""
    e, ints, reals = s.element, s.element_ints, s.element_reals
    for k in range(e.shape[0]):
        first, rows, columns = ptr[k, 0], ptr[k, 1], ptr[k, 2]
        at = places[first : first + rows * columns].reshape(rows, columns)
        own = (ints[e[k, INTS] : e[k, INTS_END]], reals[e[k, REALS] : e[k, REALS_END]])
        _tangent(e[k, TANGENT], (own[0], own[1], at, x, v, beta, gamma, value))


@kernel_inline
def swap_elements(s: Structure, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:
    """Make the forces of all elements in f such as keep the energy over a step."""
    e, ints, reals = s.element, s.element_ints, s.element_reals
    for k in range(e.shape[0]):
        own = (ints[e[k, INTS] : e[k, INTS_END]], reals[e[k, REALS] : e[k, REALS_END]])
        _swap(e[k, SWAP], (own[0], own[1], t, x0, x1, xe, ve, h, f))
