"""Which cables pull under a load: taut ones may slacken, and slack ones become taut.

A cable has T = max(0, k (l - l0 + e)), l and l0 its length and its natural length before the load. Those that the load would
push carry nothing; those that it lengthens beyond l0 pull. The set is found by solving, changing and solving again (an active
set); the structure being stable, there is one such state.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import AnalysisError, few
from kinetruss.kernels.structure.plan import LENGTH
from kinetruss.mechanics import CABLE, System, constraint_jacobian, ends_of
from kinetruss.statics.small.stiffness import Solved, solve

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["WithCables", "solve_with_cables"]

REACHED = 1e-12
"""A cable shorter than its natural length by more than this fraction is slack before the load."""

PULLS = 1e-9
"""A tension below this fraction of the largest force is none."""

MOST = 100
"""Largest number of solutions."""


@dataclass(frozen=True, kw_only=True, eq=False)
class WithCables:
    """The solution, with the flexibility and the tension (rows,) in the configuration that rows have under this load; stored
    (rows,) J : energy that the load adds; slack : names of cables that carry nothing.
    """

    solved: Solved
    flexible: NDArray[np.float64]
    tension: NDArray[np.float64]
    stored: NDArray[np.float64]
    slack: tuple[str, ...]


def solve_with_cables(
    held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], tension: NDArray[np.float64], load: NDArray[np.float64]
) -> WithCables:
    """`solve` with the cables that pull under nodal forces load (3 n,), N, at positions x (n, 3).

    flexible, tension (rows,) : flexibility and force of the rows in the configuration itself.

    Raises
    ------
    InputError : as `solve`; the message names slack cables.
    AnalysisError : no set of cables is consistent.
    """
    G, i = constraint_jacobian(held, x), held.row_member
    cable = (held.row_kind == LENGTH) & (held.law[i] == CABLE) & (flexible != 0)
    length = ends_of(held, x, i)[1]
    stiff = np.where(cable, held.spring[i], 0.0)
    before = np.where(cable, stiff * (length - held.natural[i]), tension)  # below 0 of slack cables
    pulls, seen = cable & (length >= held.natural[i] * (1 - REACHED)), set()
    for _ in range(MOST):
        now = np.where(cable, np.inf, flexible)
        now[pulls] = 1.0 / stiff[pulls]
        given = np.where(cable & ~pulls, 0.0, before)
        solved = solve(held, x, now, load - G.T @ given)
        least = PULLS * float(np.abs(given + solved.force).max(initial=0.0))
        # tension that every cable would have: of slack ones by their present elongation
        wanted = np.where(pulls, given + solved.force, before + stiff * solved.elongation)
        wrong = (pulls & (wanted < -least)) | (cable & ~pulls & (wanted > least))
        if not wrong.any():
            names = tuple(held.members[k] for k in i[cable & ~pulls])
            # of a row that has the force N0 before: N0 e + N e/2
            stored = (0.5 * solved.force + given) * solved.elongation
            total = given + solved.force
            stored[cable] = 0.5 * (total[cable] ** 2 - tension[cable] ** 2) / stiff[cable]
            return WithCables(solved=solved, flexible=now, tension=given, stored=stored, slack=names)
        key = pulls.tobytes()
        if key in seen:  # one at a time, so that it does not go round
            wrong = np.arange(len(wrong)) == int(np.flatnonzero(wrong)[0])
        seen.add(key)
        pulls = pulls ^ wrong
    among = few([held.members[k] for k in i[cable]], 6)
    raise AnalysisError(f"It was not found which of the cables {among} pull under this load. See statics.equilibrium.")
