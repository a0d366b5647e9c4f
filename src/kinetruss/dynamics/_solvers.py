"""Which solver of the equations of motion, and its arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels._equations import DENSE, SPARSE, SWEEP, Equations, Workspace
from kinetruss.kernels._kkt_dense import ASSEMBLED, COUPLED, SEPARATE, assemble_mass
from kinetruss.system import System, rearrange

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["room_for", "solver_arrays"]

SOLVERS = {"dense": DENSE, "sparse": SPARSE, "sweep": SWEEP}
LARGEST_DENSE = 60
"""Free coordinates up to which dense algebra is taken."""


def solver_arrays(system: System, masses: dict[str, Any], solver: str) -> tuple[dict[str, Any], NDArray[np.int64]]:
    """Arrays of the chosen solver, and the order of the system's rows in the equations: redundant ones last."""
    if solver != "auto" and solver not in SOLVERS:
        raise InputError(f"no solver called {solver!r}. There are: auto, {', '.join(SOLVERS)}.")
    chosen = DENSE
    arrangement = rearrange(system, system.x0, None) if len(system.row_member) else None
    extra = np.zeros(0, np.int64) if arrangement is None else arrangement.extra
    rows = np.arange(len(system.row_member))
    order = np.concatenate([np.setdiff1d(rows, extra), extra])
    spare = np.isin(order, extra)
    weight = np.ones(len(rows)) if arrangement is None else arrangement.weight[order]
    mode, stiff, inverse, pair = _dense(system, masses, order)
    return {
        "setup": np.array([chosen, mode], np.int64), "dense": np.array([stiff]), "dense_pair": pair, "dense_inverse": inverse,
        "spare": spare, "weight": weight,
    }, order  # fmt: skip


def _dense(system: System, masses: dict[str, Any], order: NDArray[np.int64]) -> tuple[int, float, Any, Any]:
    """Mode, stiffening, inverse mass and quadratic forms of the dense solver."""
    free = system.free
    nf = len(free)
    local = np.full(system.x0.size, -1, np.int64)
    local[free] = np.arange(nf)
    M = np.zeros((nf, nf))
    assemble_mass(local, *(masses[name] for name in ("mass_A", "mass_B", "mass", "lump", "var_A", "var_B", "var")),
                  system.x0.reshape(-1).copy(), nf, M)  # fmt: skip
    size = np.linalg.eigvalsh(M) if nf else np.ones(1)
    stiff = 0.0 if size[0] > 1e-10 * size[-1] else float(max(np.trace(M) / max(nf, 1), 1e-6))
    skew = bool(np.any(masses["mass"][:, 3]))
    if stiff or len(masses["var_A"]) or (skew and system.dim == 3):
        return ASSEMBLED, stiff, np.zeros((0, 0)), np.zeros((0, 0, 0))
    inverse = np.linalg.inv(M)
    inverse = 0.5 * (inverse + inverse.T)
    member = system.row_member[order]
    pick = np.zeros((3, len(order), nf))
    for c in range(3):
        for end, sign in ((system.q, 1.0), (system.p, -1.0)):
            at = local[3 * end[member].astype(np.int64) + c]
            some = at >= 0
            pick[c, np.flatnonzero(some), at[some]] += sign
    axes = [(0, 0), (0, 1), (1, 0), (1, 1)] if skew else [(0, 0), (1, 1), (2, 2)]
    pair = np.stack([pick[a] @ inverse @ pick[b].T for a, b in axes])
    return (COUPLED if skew else SEPARATE), 0.0, inverse, pair


def room_for(eq: Equations) -> Workspace:
    """A workspace for these equations."""
    n, r, nf = eq.local.size, eq.row.size, eq.free.size
    spare = int(max(4, eq.spare.sum() + 4))
    spare = min(spare, r) if r else 1
    return Workspace(
        now=np.zeros((3, eq.motion_kind.size)), u=np.zeros((3, r)), aim=np.zeros((3, r)), gamma=np.zeros(r), f=np.zeros(n),
        g=np.zeros(n), h=np.zeros(n), report=np.zeros(2), D=np.zeros((nf, nf)), W=np.zeros((r, nf)), S=np.zeros((r, r)),
        diagonal=np.zeros(r), rhs=np.zeros(r), pull=np.zeros(r), y=np.zeros(nf), b=np.zeros(nf), dropped=np.zeros(r, np.bool_),
        states=np.zeros((r, r)), matrix=np.zeros((r, r)), order=np.zeros(r + 1, np.int64), z=np.zeros(r + 1),
    )  # fmt: skip
