"""The problem of a simulation: equations, a consistent start, a method; and the forces of all its rows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.joint_loads import jammed
from kinetruss.dynamics.user_forces import UserForce
from kinetruss.kernels.structure.equations import (
    DENSE,
    SPARSE,
    SWEEP,
    Equations,
    Workspace,
)
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics import System
from kinetruss.mechanics.elements import fed
from kinetruss.model import (
    GivenForce,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.motors import Motors
    from kinetruss.dynamics.starting import Singular
    from kinetruss.dynamics.tracking import Tracker
    from kinetruss.kernels.integrate.state import Control
    from kinetruss.kernels.structure.equations import Equations, Workspace
    from kinetruss.mechanics.beam_shapes import FixedShapes


@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """Equations of a model, applied forces, a consistent start and a method.

    x0, v0 (3 n,), z0 (extra,) : start. notes, start_attrs : what was changed to make it consistent. extra : name, unit
    and description of states other than positions and velocities. not_unique : members whose force is not unique. motors :
    those with an input. singular : data of a start near a singular position.
    shapes : rigid links, which rows of `system` hold. tracker : feedback of drives.
    controls : control data of integrators, by the end of the run (s).
    """

    system: System
    eq: Equations
    ws: Workspace
    user: UserForce
    method: Any
    events: Mapping[str, Any]
    tasks: Mapping[str, Any]
    load_case: str | None
    x0: NDArray[np.float64]
    v0: NDArray[np.float64]
    z0: NDArray[np.float64]
    notes: tuple[str, ...] = ()
    start_attrs: Mapping[str, float] = field(default_factory=dict)
    extra: tuple[tuple[str, str, str], ...] = ()
    not_unique: tuple[str, ...] = ()
    motors: Motors | None = None
    singular: Singular | None = None
    shapes: FixedShapes | None = None
    tracker: Tracker | None = None
    controls: dict[float, Control] = field(default_factory=dict)

    def fresh(self) -> Problem:
        """A copy with its own buffers, to which a run writes, and without a user force."""
        return replace(
            self,
            eq=self.eq.copy(),
            ws=self.ws.copy(),
            user=self.user.again(),
            x0=self.x0.copy(),
            v0=self.v0.copy(),
            z0=self.z0.copy(),
        )

    @property
    def isolated(self) -> bool:
        """True if nothing supplies energy: no moving drive or support, no given force, no user force, no element that feeds."""
        in_time = len(self.eq.force_kind) or len(self.eq.load) or len(self.eq.motion_kind)
        return not (self.user.given or in_time or fed(self.system) or self.eq.bearing_ints.size)

    @property
    def error(self) -> BaseException | None:
        """What the user's function raised last, or a joint that jams."""
        return self.user.error or jammed(self.system, self.ws)

    @property
    def solver(self) -> str:
        """Name of the chosen solver."""
        return {DENSE: "dense", SPARSE: "sparse", SWEEP: "sweep"}[self.eq.solver]


# Forces of all rows of a system: those of the equations, and those of released drives.


def all_rows(
    problem: Problem, t: NDArray[np.float64], x: NDArray[np.float64], v: NDArray[np.float64], N: NDArray[np.float64]
) -> NDArray[np.float64]:
    """N (s, rows of the system) from N of the rows of the equations (s, rows), at times t (s,), x and v (s, 3 n).

    The row of a drive with a given force F has N = -F; of one with a given torque minus the torque over the length.
    """
    system, row = problem.system, problem.eq.row
    found = np.zeros((len(N), len(system.row_member)))
    found[:, row] = N
    given = system.row_drive >= 0
    given[row] = False
    fed = {} if problem.tracker is None else dict(zip(problem.tracker.names, problem.tracker.along(t, x, v)[0].T, strict=True))
    for r in np.flatnonzero(given):
        name = system.drives[system.row_drive[r]]
        task = problem.tasks[name]
        if isinstance(task, GivenForce) or name in fed:
            found[:, r] = -(fed[name] if name in fed else _amount(task, t))
            if (m := system.row_measure[r]) >= 0:
                found[:, r] /= system.measure_scale[m]
            if system.row_kind[r] == ANGLE:
                i, y = system.row_member[r], x.reshape(len(x), len(system.nodes), 3)
                found[:, r] /= np.sqrt(((y[:, system.q[i]] - y[:, system.p[i]]) ** 2).sum(axis=1))
    return found


def _amount(task: GivenForce, t: NDArray[np.float64]) -> NDArray[np.float64]:
    if task.times is None or task.table is None:
        return np.full(len(t), task.constant)
    return np.interp(t, task.times, task.table)
