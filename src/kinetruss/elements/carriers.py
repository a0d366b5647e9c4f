"""Points and directions of bodies by the nodes that carry them, at places that may be complex, and copies.

The coefficients solve A c = b with A made of the places of the carriers, so that dc = A^+ (db - dA c): of complex places they
are those of the real parts, and to first order what the imaginary parts add.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.model.bodies import barycentric, fixed_vector

if TYPE_CHECKING:
    from kinetruss.elements.numbers import Array


def shares_of(points: Array, place: Array) -> Array:
    """Barycentric coordinates (k,) of a place (dim,) among carriers at points (k, dim)."""
    return _solved(points, place, of_place=True)


def fixed_in(points: Array, vector: Array) -> Array:
    """Coefficients (k,) of points (k, dim) with sum 0 that make a vector (dim,) fixed in the body."""
    return _solved(points, vector, of_place=False)


def _solved(points: Array, vector: Array, *, of_place: bool) -> Array:
    lead = points.shape[:-2]
    vector = np.broadcast_to(vector, (*lead, points.shape[-1]))
    found = np.zeros(points.shape[:-1], np.result_type(points, vector))
    for k in np.ndindex(lead):
        real, b = points[k].real, vector[k].real
        own = (barycentric if of_place else fixed_vector)(real, b)[0]
        found[k] = own
        if np.iscomplexobj(found):
            found[k] += 1j * fixed_vector(real, vector[k].imag - own @ points[k].imag)[0]
    return found


def planar_share(r: Array, d: Array) -> tuple[Array, Array]:
    """Real and imaginary part of r/d, vectors (2,) of the plane as complex numbers."""
    lead = r.shape[:-1]
    found = np.zeros((2, *lead), np.result_type(r, d))
    for k in np.ndindex(lead):
        over = complex(*d[k].real)
        share = complex(*r[k].real) / over
        found[(0, *k)], found[(1, *k)] = share.real, share.imag
        if np.iscomplexobj(found):
            change = (complex(*r[k].imag) - share * complex(*d[k].imag)) / over
            found[(0, *k)] += 1j * change.real
            found[(1, *k)] += 1j * change.imag
    return found[0], found[1]
