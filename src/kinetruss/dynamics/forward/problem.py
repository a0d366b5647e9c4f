"""The problem of a simulation: equations, a consistent start, a method."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from kinetruss.dynamics.assembly.user import UserForce
from kinetruss.kernels.structure.equations import DENSE, SPARSE, SWEEP

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from kinetruss.dynamics.motors.motors import Motors
    from kinetruss.dynamics.starting.singular import Singular
    from kinetruss.kernels.integrate.state import Control
    from kinetruss.kernels.structure.equations import Equations, Workspace
    from kinetruss.mechanics import System

__all__ = ["Problem"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """Equations of a model, applied forces, a consistent start and a method.

    x0, v0 (3 n,), z0 (extra,) : start. notes, start_attrs : what was changed to make it consistent. extra : name, unit
    and description of states other than positions and velocities. not_unique : members whose force is not unique. motors :
    those with an input. singular : data of a start near a singular position. controls : control data of integrators, by the
    end of the run (s).
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
        """True if nothing supplies energy: no moving drive or support, no given force, no user force."""
        in_time = len(self.eq.force_kind) or len(self.eq.follower_mode) or len(self.eq.motion_kind)
        return not (self.user.given or in_time)

    @property
    def solver(self) -> str:
        """Name of the chosen solver."""
        return {DENSE: "dense", SPARSE: "sparse", SWEEP: "sweep"}[self.eq.solver]
