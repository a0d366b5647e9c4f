"""Least values of convex quadratic functions under linear conditions, by the interior points of Clarabel.

P. J. Goulart and Y. Chen, Clarabel: An interior-point solver for conic programs with quadratic objectives, 2024.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

CLOSE, ENOUGH = 1e-12, 1e-8
"""Residuals and gap of a solution, in units of the given numbers: wanted, and taken where round-off ends it."""


def least_quadratic(H: Any, g: Floats, G: Any, h: Floats, *, equal: int = 0) -> tuple[Floats, bool]:
    """x (n,) of least x^T H x/2 + g^T x with G x <= h, and whether it was found.

    H (n, n) positive semidefinite; G (m, n) dense or sparse, whose first `equal` rows hold as equations.
    """
    import clarabel
    from scipy.sparse import csc_array, triu

    settings = clarabel.DefaultSettings()
    settings.verbose, settings.max_threads = False, 1
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = CLOSE
    settings.reduced_tol_gap_abs = settings.reduced_tol_gap_rel = settings.reduced_tol_feas = ENOUGH
    cones = [clarabel.ZeroConeT(equal), clarabel.NonnegativeConeT(len(h) - equal)]
    found = clarabel.DefaultSolver(triu(csc_array(H), format="csc"), g, csc_array(G), h, cones, settings).solve()
    good = found.status in (clarabel.SolverStatus.Solved, clarabel.SolverStatus.AlmostSolved)
    return np.array(found.x), good
