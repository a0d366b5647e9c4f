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
    from kinetruss.elements.beam_kernels import deformations

    out = np.empty((len(x), *found.rigidity.shape))
    for i, place in enumerate(np.ascontiguousarray(x, float).reshape(len(x), -1)):
        deformations(found.record, place, out[i])
    return out


def mode_gradients(found: BeamElements, x: Floats) -> csr_array:
    """B (beams x modes, 3 n), 1/m, at positions x (n, 3)."""
    from kinetruss.elements.beam_kernels import coordinates, gradients

    at = coordinates(found.record)
    k, s = found.rigidity.shape
    values = np.empty((k, s, at.shape[1]))
    gradients(found.record, _flat(x), values)
    rows = np.repeat(np.arange(k * s), at.shape[1])
    columns = np.broadcast_to(at[:, None], values.shape).reshape(-1)
    return csr_array(coo_array((values.reshape(-1), (rows, columns)), shape=(k * s, x.size)))


def mode_rates(found: BeamElements, x: Floats, v: Floats) -> NDArray[np.float64]:
    """Rates of the modes (times, k, s), 1/s, at x, v (times, n, 3); or x (1, n, 3)."""
    places = np.broadcast_to(x, v.shape)
    return np.array([mode_gradients(found, x) @ _flat(v) for x, v in zip(places, v, strict=True)]).reshape(
        len(v), *found.rigidity.shape
    )


def mode_forces(found: BeamElements, x: Floats, forces: Floats) -> NDArray[np.float64]:
    """sum S_s B_s of mode forces (times, k, s), N m, by beam: (times, k, v, 3), N, at positions x (times, n, 3)."""
    from kinetruss.elements.beam_kernels import gradients

    k, v = found.nodes.shape
    values, out = np.empty((*found.rigidity.shape, 3 * v)), np.empty((len(forces), k, v, 3))
    for i, own in enumerate(forces):
        gradients(found.record, _flat(x[i]), values)
        out[i] = np.einsum("ks,ksw->kw", own, values).reshape(k, v, 3)
    return out


def beam_stiffness(found: BeamElements, x: Floats, forces: Floats = None, rigidity: Floats = None) -> csr_array:
    """Sums over modes of rigidity (k, s) B^T B and of forces (k, s) times second derivatives, (3 n, 3 n), N/m, at x (n, 3).

    By default those of the beams at x: their tangent stiffness.
    """
    from kinetruss.elements.beam_kernels import blocks, coordinates

    S = found.rigidity * mode_values(found, x[None])[0] if forces is None else np.ascontiguousarray(forces, float)
    R = found.rigidity if rigidity is None else np.ascontiguousarray(rigidity, float)
    at = coordinates(found.record)
    out = np.empty((*at.shape, at.shape[1]))
    blocks(found.record, _flat(x), S, R, out)
    rows, columns = (np.broadcast_to(one, out.shape).reshape(-1) for one in (at[:, :, None], at[:, None, :]))
    return csr_array(coo_array((out.reshape(-1), (rows, columns)), shape=(x.size, x.size)))


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
    from kinetruss.elements.beam_kernels import blocks, coordinates

    at = coordinates(found.record)
    out = np.empty((*at.shape, at.shape[1]))
    blocks(found.record, _flat(x), forces, np.zeros(found.rigidity.shape), out)
    values = np.einsum("kij,kj->ki", out, v[at])
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
