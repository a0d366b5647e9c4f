"""What beams, membranes and solids resist besides the rows of a system: gradients of their strains, as rows of unit size.

Stiffnesses do not enter, only whether there is one: a change of positions that leaves all these strains and all rows as they
are is a mechanism, whatever the slenderness of the parts. The rank of unit rows decides this for long chains of slender beams,
where the least eigenvalue of a stiffness is far below the rounding of the largest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import coo_array, csr_array, diags_array, vstack

from kinetruss.mechanics import System
from kinetruss.mechanics.beams import mode_gradients

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Deformations", "beam_deformations", "deformations"]

STRAINED = 1e-10
"""Eigenvalues of the stiffness of an element above this fraction of its largest belong to strains."""


class Deformations(NamedTuple):
    """rows (r, 3 n) : unit gradients of strains. names (r,) : of the beam, of the membrane or of the solid of each."""

    rows: csr_array
    names: tuple[str, ...]


def beam_deformations(system: System, x: NDArray[np.float64]) -> Deformations:
    """Of elastic beams at positions x (n, 3): three for each in the plane, six in space."""
    beams = None if system.continua is None else system.continua.beams
    if beams is None:
        return Deformations(csr_array((0, x.size)), ())
    names = tuple(name for name in beams.names for _ in range(beams.modes.shape[1]))
    return Deformations(_unit(mode_gradients(beams, x)), names)


def deformations(system: System, x: NDArray[np.float64]) -> Deformations:
    """Of elastic beams, membranes and solids at positions x (n, 3)."""
    own = beam_deformations(system, x)
    found = system.continua
    if found is None or not found.patches:
        return own
    rows = [_elements(system, x, v) for v in found.groups]
    whole = csr_array(vstack(rows))
    return Deformations(csr_array(vstack([own.rows, whole])), (*own.names, *("" for _ in range(whole.shape[0]))))


def _elements(system: System, x: NDArray[np.float64], v: int) -> csr_array:
    """Of the elements of membranes and solids with v nodes: the strains with stiffness, by squared lengths of their edges."""
    found: Any = system.continua
    edge, upper = found.groups[v]
    if found.beams is not None and found.beams.nodes.shape[1] == v:  # beams are the last elements
        edge, upper = edge[: -len(found.beams.names)], upper[: -len(found.beams.names)]
    w = edge.shape[1]
    stiff = np.zeros((len(edge), w, w))
    i, j = np.triu_indices(w)
    stiff[:, i, j] = stiff[:, j, i] = upper
    values, modes = np.linalg.eigh(stiff)
    element, mode = np.nonzero(values > STRAINED * values[:, -1:])
    share = modes[element, :, mode]  # (r, w) coefficients of the edges
    d = 2 * (x[found.q[edge]] - x[found.p[edge]])[element] * share[:, :, None]
    row = np.broadcast_to(np.arange(len(element))[:, None, None], d.shape).reshape(-1)
    parts = []
    for nodes, sign in ((found.p, -1.0), (found.q, 1.0)):
        columns = (3 * nodes[edge][element].astype(np.int64)[:, :, None] + np.arange(3)).reshape(-1)
        parts.append(coo_array((sign * d.reshape(-1), (row, columns)), shape=(len(element), x.size)))
    return _unit(csr_array(parts[0] + parts[1]))


def _unit(rows: csr_array) -> csr_array:
    size = np.sqrt(np.asarray(rows.multiply(rows).sum(axis=1)).reshape(-1))
    return csr_array(diags_array(1.0 / np.where(size > 0, size, 1.0)) @ rows)
