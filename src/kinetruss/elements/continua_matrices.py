"""Stiffness of membranes and solids as sparse matrices, and forces from changes of squared lengths."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array

from kinetruss.elements.continua import EdgeElements, edge_blocks, edge_densities, force

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.continua_arrays import Continua
    from kinetruss.mechanics.system import System


def squared_changes(found: Continua, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Squared lengths of the edges minus their stress-free values, (e,), m^2, at positions x (n, 3)."""
    moved, whole = x - found.start, x + found.start
    p, q = found.ends
    return np.asarray(np.einsum("ec,ec->e", moved[q] - moved[p], whole[q] - whole[p]))


def densities(found: Continua, s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Force densities of the edges (e,), N/m, from changes s (e,), m^2, of their squared lengths."""
    q = np.empty(len(s))
    edge_densities(found.record, s, q)
    return q


def continua_forces(found: Continua, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces on the nodes (times, 3 n), N, at positions x (times, 3 n)."""
    out, rest = np.zeros_like(x), np.zeros(x.shape[1])
    for i in range(len(x)):
        force(found.record, 0.0, x[i], rest, out[i])
    return out


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
    first, second = found.ends
    np.subtract.at(own, first, blocks)
    np.subtract.at(own, second, blocks[:, [0, 3, 6, 1, 4, 7, 2, 5, 8]])
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


def continua_geometric(found: Continua, x: NDArray[np.float64], u: NDArray[np.float64]) -> Any:
    """Geometric stiffness (3 n, 3 n), N/m, of the stresses that small displacements u (n, 3) from x (n, 3) add."""
    p, q = found.ends
    # squared_changes to first order in u: 2 d . (u_q - u_p)
    added = densities(found, 2 * np.einsum("ec,ec->e", x[q] - x[p], u[q] - u[p]))
    return continua_stiffness(found, x, added, material=False)


def table(system: System) -> EdgeElements | None:
    """All membranes and solids of a system; None where there are none."""
    return None if system.continua is None or not system.continua.patches else system.continua.record


def fields(system: System) -> dict[str, Any] | None:
    """The fields of `table`."""
    return None if system.continua is None or not system.continua.patches else system.continua.fields()


def tangents(
    system: System,
    record: EdgeElements,  # noqa: ARG001
    x: NDArray[np.float64],
    v: NDArray[np.float64] | None,  # noqa: ARG001
) -> tuple[Any, Any]:
    """As elements.kinds.Element.tangents."""
    return continua_stiffness(system.continua, x), csr_array((x.size, x.size))  # type: ignore[arg-type]


def geometric(system: System, record: EdgeElements, x: NDArray[np.float64], u: NDArray[np.float64]) -> Any:  # noqa: ARG001
    """As elements.kinds.Element.geometric."""
    return continua_geometric(system.continua, x, u)  # type: ignore[arg-type]


def without_series(system: System) -> str | None:
    """As elements.kinds.Element.without_series."""
    return None if table(system) is None else "membranes or solids resist"
