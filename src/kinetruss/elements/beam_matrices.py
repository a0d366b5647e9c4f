"""Deformations of beams along motions, their gradients and tangents as sparse matrices; beams in the table of kinds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import coo_array, csr_array

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.beam_kernels import BeamTable
    from kinetruss.elements.beams import BeamElements
    from kinetruss.mechanics.system import System

Floats = Any


def mode_values(found: BeamElements, x: Floats) -> NDArray[np.float64]:
    """Deformations (times, k, s) at positions x (times, n, 3)."""
    return np.array([_deformed(found, place, np.empty((0, 0, 0))) for place in x])


def _deformed(found: BeamElements, x: Floats, gradients: NDArray[np.float64]) -> NDArray[np.float64]:
    """Deformations (k, s) at x (n, 3); into gradients (k, s, 3 v), if it has room, those by the nodes of each beam."""
    from kinetruss.elements.beam_kernels import deformations

    out = np.empty(found.rigidity.shape)
    deformations(found.record, _flat(x), out, gradients)
    return out


def mode_gradients(found: BeamElements, x: Floats) -> csr_array:
    """B (beams x modes, 3 n), 1/m, at positions x (n, 3)."""
    from kinetruss.elements.beam_kernels import coordinates

    at, values, (k, s) = coordinates(found.record), _gradients(found, x), found.rigidity.shape
    rows = np.repeat(np.arange(k * s), at.shape[1])
    columns = np.broadcast_to(at[:, None], values.shape).reshape(-1)
    return csr_array(coo_array((values.reshape(-1), (rows, columns)), shape=(k * s, x.size)))


def mode_rates(found: BeamElements, x: Floats, v: Floats) -> NDArray[np.float64]:
    """Rates of the modes (times, k, s), 1/s, at x, v (times, n, 3); or x (1, n, 3)."""
    places, rates = np.broadcast_to(x, v.shape), v[:, found.nodes].reshape(len(v), len(found.nodes), -1)
    return np.array([np.vecdot(_gradients(found, x), v[:, None]) for x, v in zip(places, rates, strict=True)])


def mode_forces(found: BeamElements, x: Floats, forces: Floats) -> NDArray[np.float64]:
    """sum S_s B_s of mode forces (times, k, s), N m, by beam: (times, k, v, 3), N, at positions x (times, n, 3)."""
    own = [np.einsum("ks,ksw->kw", S, _gradients(found, place)) for place, S in zip(x, forces, strict=True)]
    return np.array(own).reshape(len(forces), *found.nodes.shape, 3)


def _gradients(found: BeamElements, x: Floats) -> NDArray[np.float64]:
    """Gradients (k, s, 3 v) of the modes by the nodes of their beams."""
    values = np.empty((*found.rigidity.shape, 3 * found.nodes.shape[1]))
    _deformed(found, x, values)
    return values


def _blocks(found: BeamElements, x: Floats, forces: Floats, rigidity: Floats) -> NDArray[np.float64]:
    """Tangents (k, 3 v, 3 v) of each beam, as elements.beam_kernels.blocks."""
    from kinetruss.elements.beam_kernels import blocks

    w = 3 * found.nodes.shape[1]
    out = np.empty((len(found.nodes), w, w))
    blocks(found.record, _flat(x), np.ascontiguousarray(forces, float), np.ascontiguousarray(rigidity, float), 1.0, 0.0, out)
    return out


def beam_stiffness(found: BeamElements, x: Floats, forces: Floats = None, rigidity: Floats = None) -> csr_array:
    """Sums over modes of rigidity (k, s) B^T B and of forces (k, s) times second derivatives, (3 n, 3 n), N/m, at x (n, 3).

    Without forces those of the beams at x: their tangent stiffness.
    """
    none = np.empty((0, 0))
    blocks = _blocks(found, x, none if forces is None else forces, none if forces is None else rigidity)
    row, column, place = found.pattern
    begin = np.searchsorted(row, np.arange(x.size + 1))
    return csr_array((np.bincount(place, blocks.reshape(-1), len(row)), column, begin), shape=(x.size, x.size))


def mode_stiffness(found: BeamElements, x: Floats, forces: Floats) -> csr_array:
    """sum S_s H_s of mode forces (k, s) and second derivatives of modes at x (n, 3), (3 n, 3 n), N/m."""
    return beam_stiffness(found, x, forces, np.zeros(found.rigidity.shape))


def table(system: System) -> BeamTable | None:
    """All elastic beams of a system; None where there are none."""
    beams = None if system.continua is None else system.continua.beams
    return None if beams is None else beams.record


def fields(system: System) -> dict[str, Any] | None:
    """The fields of `table`."""
    beams = None if system.continua is None else system.continua.beams
    return None if beams is None else beams.fields()


def tangents(
    system: System,
    record: BeamTable,  # noqa: ARG001
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None,
) -> tuple[Any, Any]:
    """As elements.kinds.Element.tangents. Of damping b R m' B: by v sum b R B B^T, by x sum b R (m' H + B (H v)^T)."""
    found: Any = system.continua.beams  # type: ignore[union-attr]
    K, C = beam_stiffness(found, x), csr_array((x.size, x.size))
    if not found.damping.any():
        return K, C
    share, none = found.damping[:, None] * found.rigidity, np.zeros(found.rigidity.shape)
    C = beam_stiffness(found, x, none, share)
    if v is None or not np.any(v):
        return K, C
    B, (k, s), size = mode_gradients(found, x), found.rigidity.shape, x.size
    K = K + mode_stiffness(found, x, share * mode_rates(found, x[None], v[None])[0])
    for i in range(s):
        # H v of one mode of all beams, by beam
        unit = none.copy()
        unit[:, i] = 1.0
        bent = _by_beam(found, x, unit, _flat(v))
        own = B[np.arange(k) * s + i]
        K = K + csr_array(own.T @ bent.multiply(share[:, [i]]))
    return K, csr_array(C.reshape((size, size)))


def _by_beam(found: BeamElements, x: Floats, forces: Floats, v: Floats) -> csr_array:
    """(sum S_s H_s) v of each beam as a row, (k, 3 n)."""
    from kinetruss.elements.beam_kernels import coordinates

    at = coordinates(found.record)
    values = np.einsum("kij,kj->ki", _blocks(found, x, forces, np.zeros(found.rigidity.shape)), v[at])
    rows = np.repeat(np.arange(len(at)), at.shape[1])
    return csr_array(coo_array((values.reshape(-1), (rows, at.reshape(-1))), shape=(len(at), v.size)))


def geometric(system: System, record: BeamTable, x: NDArray[np.float64], u: NDArray[np.float64]) -> Any:  # noqa: ARG001
    """As elements.kinds.Element.geometric."""
    found: Any = system.continua.beams  # type: ignore[union-attr]
    return mode_stiffness(found, x, found.rigidity * mode_rates(found, x[None], u[None])[0])


def without_series(system: System) -> str | None:
    """As elements.kinds.Element.without_series."""
    return None if table(system) is None else "beams resist"


def _flat(x: Floats) -> NDArray[np.float64]:
    return np.ascontiguousarray(x, float).reshape(-1)
