"""Stiff elastic bars under explicit steps: detected early, from the progress of the first steps."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.kernels.structure.plan import NONE
from kinetruss.mechanics import System
from kinetruss.model import DOP853, Taylor

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.integration import Integration

__all__ = ["LOOKS", "Stiffest", "longer_steps", "stiffest", "too_stiff", "vibrating"]

LOOKS = (4_000, 32_000, 128_000, 512_000)
"""Number of steps after which the steps of the whole run are estimated."""
MANY = 20_000
"""Number of steps above which a message says that most of them only follow a vibration."""
BY_FAR = 5.0
"""Allowed estimate of steps, as a multiple of max_steps, if no vibrating bar is known: at the second check."""

LATER = 1.5
"""The same from the third check on."""
RADIANS = 0.02
"""The fastest vibration limits the steps if step times its frequency exceeds this: 0.1 occurs if round-off alone excites it."""


class Stiffest(NamedTuple):
    """The elastic bar that needs the smallest steps: its index (-1: none), its rate (rad/s, 1/s), and whether its damper is
    faster than its spring.
    """

    bar: int
    rate: float
    damped: bool

    def words(self, system: System) -> str:
        """The vibration or decay in words, with the name of the bar."""
        name = system.members[self.bar]
        if self.damped:
            return f"the damper of {name}, which slows its ends within {1 / self.rate:.3g} s"
        return f"the vibration of {name} ({self.rate:.3g} rad/s)"


def stiffest(system: System) -> Stiffest:
    """The elastic bar with the fastest vibration or the fastest damper.

    w^2 = k (1/m_A + 1/m_B) and the rate c (1/m_A + 1/m_B) of a damper, with the masses at its ends alone: of the order of the
    highest frequencies of the structure.
    """
    elastic = np.flatnonzero(system.law != NONE)
    if not len(elastic):
        return Stiffest(-1, 0.0, damped=False)
    count, share = len(system.nodes), system.rods[:, 0] / 3 + system.rods[:, 3] / 3
    mass = system.node_mass + np.bincount(system.p, share, count) + np.bincount(system.q, share, count)
    still = system.prescribed.reshape(-1, 3).all(axis=1)
    # a massless node gets its inertia through rigid bars, which is unknown here: it is skipped
    give = np.where(still | (mass <= 0), 0.0, 1 / np.where(mass > 0, mass, 1.0))
    both = give[system.p[elastic]] + give[system.q[elastic]]
    spring, damper = np.sqrt(system.spring[elastic] * both), system.damping[elastic] * both
    k = int(np.argmax(np.maximum(spring, damper)))
    return Stiffest(int(elastic[k]), float(max(spring[k], damper[k])), bool(damper[k] > spring[k]))


def longer_steps(work: Integration, found: Stiffest) -> str:
    """What may step farther than explicit steps, in words."""
    if work.problem.motors is not None:
        return "make the bar rigid: motors are simulated with explicit steps"
    if found.damped:
        return "use method=Radau(), whose steps follow the motion, or EnergyMomentum(step=...)"
    return "use method=EnergyMomentum(step=...), whose steps may be far longer, or Radau(), which lets the vibration die down"


def vibrating(work: Integration) -> int:
    """The bar whose vibration or damper limits the explicit steps, or -1."""
    bar, rate, _ = stiffest(work.problem.system)
    explicit = isinstance(work.problem.method, DOP853 | Taylor)
    return bar if explicit and float(work.memory.h) * rate > RADIANS else -1


def too_stiff(work: Integration) -> bool:
    """True if the whole run would take more steps than allowed, because a vibration limits them.

    If no such bar is known (its ends get their mass from bodies), only long after the start and by a wide margin.
    """
    steps = int(work.memory.steps)
    if not isinstance(work.problem.method, DOP853 | Taylor) or not work.memory.t > 0:
        return False
    if vibrating(work) < 0 and (
        steps < LOOKS[1] or not (np.any(work.problem.system.law != NONE) or work.problem.system.springs)
    ):
        return False
    margin = 1.0 if vibrating(work) >= 0 else BY_FAR if steps < LOOKS[2] else LATER
    return bool(steps * work.t_end / work.memory.t > margin * work.problem.method.max_steps)
