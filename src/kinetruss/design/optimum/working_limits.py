"""The search with few limits of very many: instants, places and members that matter, taken in as they are reached.

A limit over 50,000 instants is 50,000 rows, of which an optimum reaches a handful. The search sees a working set; at its end
all rows are computed once, and those that are exceeded join, until none is (an exchange method: Hettich and Kortanek, SIAM
Review 35 (1993) 380).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.design.optimum.certificate import Certificate, certificate, worst_of_families
from kinetruss.design.optimum.evaluations import UNKNOWN, BeyondError, Evaluations, OutsideError
from kinetruss.design.optimum.solvers import Method, joining, search

if TYPE_CHECKING:
    from numpy.typing import NDArray

ALL = 200
"""Up to this number of limits all are in the working set."""
NEAR = 0.3
"""Limits with less than this left, of their size, are taken at the start."""
ROUNDS = 30


@dataclass(frozen=True, kw_only=True)
class Found:
    """Where a search ended. p (n,); rows : the working set at the end; said : by the solver."""

    p: NDArray[np.float64]
    certificate: Certificate
    rows: NDArray[np.int64]
    said: str


def optimum(asked: Evaluations, start: NDArray[np.float64], method: Method, iterations: int, tolerance: float) -> Found:
    """Search from a point p (n,), with a working set of limits, until no other limit is exceeded.

    Where another solver than SLSQP stops before the conditions of first order hold, SLSQP goes on from there.
    """
    problem = asked.problem
    z = problem.scaled(start)
    count = len(problem.limits)
    rows = np.arange(count) if count <= ALL else worst_of_families(asked.values(problem.real(z))[1], problem.family, NEAR)
    for _ in range(ROUNDS):
        began = z
        try:
            z, said = search(asked, rows, z, method, iterations, tolerance)
        except BeyondError as beyond:
            if isinstance(beyond, OutsideError) or not len(more := joining(asked, beyond.p, rows)):
                if method == "slsqp":
                    raise
                method = "slsqp"
                continue
            rows = np.union1d(rows, more)
            continue
        if len(more := joining(asked, problem.real(z), rows)):
            rows = np.union1d(rows, more)
            if (asked.values(problem.real(z))[1] >= UNKNOWN).any():  # where limits are infinite no search can begin
                z = began
            continue
        if method == "slsqp" or certificate(asked, problem.real(z)).first_order:
            break
        method = "slsqp"
    proof = certificate(asked, problem.real(z))
    return Found(p=problem.real(z), certificate=proof, rows=rows, said=said)
