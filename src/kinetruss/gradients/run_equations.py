"""The equations of a run with other numbers, what is read of it, and the runs whose gradient is not known."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.integrators import watched
from kinetruss.dynamics.simulation_problem import Problem, all_rows
from kinetruss.dynamics.simulation_records import Trace
from kinetruss.dynamics.simulation_setup import Options
from kinetruss.errors import InputError
from kinetruss.gradients.run_adjoint import States
from kinetruss.kernels.coordinates.straight_line import addresses_of
from kinetruss.kernels.integrate.state import COORDINATE, FORCE, LENGTH
from kinetruss.kernels.solve.residuals import residuals
from kinetruss.kernels.structure.terms import measure_value
from kinetruss.model import ERROR_CONTROLLED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class At:
    """The equations of a run with some numbers. given : places and velocities (3 n,) before they are brought onto the
    constraints. shift (3 n,) : of supports.
    """

    problem: Problem
    given: tuple[Floats, Floats]
    shift: Floats

    def solved(self, at: States) -> tuple[States, Floats]:
        """The states with these numbers at the same free coordinates, and their residual (s, free + rows)."""
        eq, x, v, a = self.problem.eq, at.x + self.shift, at.v, at.a
        if len(eq.held):  # they are set
            v, a = v.copy(), a.copy()
        out = np.empty((len(x), len(eq.free) + len(eq.row)))
        residuals(eq, self.problem.ws, at.t, x, v, a, at.N, out)
        return States(at.t, x, v, a, at.N), out

    def trace(self, at: States) -> Trace:
        """Samples of solved states."""
        N = all_rows(self.problem, at.t, at.x, at.v, at.N)
        return Trace(t=at.t, x=at.x, v=at.v, a=at.a, N=N, extra=np.zeros((len(N), 0)), diagnostics=np.zeros((len(N), 6)))


@dataclass(eq=False)
class Reading:
    """What responses read at marks (m,): names of variables; kept, part : where their values are; weight (k, m, values), site
    (values,); sx, sv (m, k, free) and z (m, k, residuals) from them; share : longest cell in steps; error : of the adjoint.
    """

    names: list[str]
    kept: dict[str, tuple[NDArray[np.int64], ...]]
    part: dict[str, str]
    others: bool
    states: States
    weight: Any = None
    site: Any = None
    sx: Any = None
    sv: Any = None
    z: Any = None
    share: float = 1.0
    error: float = field(default=np.inf)


def gaps(problem: Problem, eq: Any, states: States) -> Floats:
    """What each event watches, less its value, (s, events)."""
    found = []
    for one in watched(problem.system, eq, problem.events):
        if one.kind == COORDINATE:
            own = states.x[:, one.a]
        elif one.kind == LENGTH:
            own = np.linalg.norm(states.x[:, one.b : one.b + 3] - states.x[:, one.a : one.a + 3], axis=1)
        elif one.kind == FORCE:
            own = states.N[:, one.a]
        else:
            kinds, places, data = (np.array(column) for column in zip(*one.terms, strict=True))
            forms, data = addresses_of(kinds), data.astype(float)
            own = np.array([measure_value(forms, places, data, 0, len(data), x) for x in states.x])
        found.append(own - one.value)
    return np.array(found).reshape(len(found), len(states.t)).T


def refuse(problem: Problem, options: Options) -> None:
    """Refuse runs whose gradient is not known, by what in them it is."""
    model = problem.system.model
    found = {
        f"{type(problem.method).__name__} has steps whose error of second order the gradient does not have: take Taylor, "
        "DOP853 or Radau": not isinstance(problem.method, ERROR_CONTROLLED),
        "motors with an input switch (friction, saturation): give the drives motions or forces": problem.motors is not None,
        "the user's force has no derivatives: give it as a load": options.user_force is not None,
        "drives are fed back: give them motions or forces": options.feedback is not None,
        "the base rotates: take one that does not": problem.user.given
        and options.user_force is None
        and options.feedback is None,
        "there is dry friction in bearings: leave it out": bool(model.bearings),
        "rigid links keep the shape of beams: make them elastic, or bars": problem.shapes is not None,
        "the start is at or near a singular position: start beside it": bool(problem.singular and problem.singular.near),
        "nothing is free to move: take dynamics.inverse": not len(problem.eq.free),
    }
    for why, holds in found.items():
        if holds:
            raise InputError(f"The run has no gradient: {why}.")
