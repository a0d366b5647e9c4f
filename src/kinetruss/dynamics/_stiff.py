"""Stiff elastic bars under explicit steps: seen early, from how far the first steps come."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels import _march_state as m
from kinetruss.kernels._plan import NONE
from kinetruss.model import DOP853, Taylor
from kinetruss.system import System

if TYPE_CHECKING:
    from kinetruss.dynamics._stepper import Stepper

__all__ = ["LOOKS", "stiffest", "too_stiff", "vibrating"]

LOOKS = (4_000, 32_000, 256_000)
"""Steps after which it is asked how many the whole run would take."""
MANY = 20_000
"""Steps from which on it is worth telling that most of them only follow a vibration."""
BY_FAR = 5
"""Times the steps that a run may take."""
RADIANS = 0.02
"""Step times fastest vibration from which on the vibration asks for the steps: 0.1 is met where round-off alone excites it."""


def stiffest(system: System) -> tuple[int, float]:
    """The elastic bar with the fastest vibration, and its frequency (rad/s); (-1, 0) where there is none.

    w^2 = k (1/m_A + 1/m_B) with the masses at its ends alone: of the order of the highest frequency of the structure.
    """
    elastic = np.flatnonzero(system.law != NONE)
    if not len(elastic):
        return -1, 0.0
    count, share = len(system.nodes), system.rods[:, 0] / 3 + system.rods[:, 3] / 3
    mass = system.node_mass + np.bincount(system.p, share, count) + np.bincount(system.q, share, count)
    still = system.prescribed.reshape(-1, 3).all(axis=1)
    # a node without mass has what rigid bars bring along; it is passed over
    give = np.where(still | (mass <= 0), 0.0, 1 / np.where(mass > 0, mass, 1.0))
    square = system.spring[elastic] * (give[system.p[elastic]] + give[system.q[elastic]])
    k = int(np.argmax(square))
    return int(elastic[k]), float(np.sqrt(square[k]))


def vibrating(work: Stepper) -> int:
    """The bar whose vibration asks for the explicit steps, or -1."""
    bar, frequency = stiffest(work.problem.system)
    explicit = isinstance(work.problem.method, DOP853 | Taylor)
    return bar if explicit and float(work.memory.real[m.H]) * frequency > RADIANS else -1


def too_stiff(work: Stepper) -> bool:
    """True where the whole run would take more steps than it may, because a vibration asks for them.

    Where no bar is known whose vibration it is (its ends get their mass from bodies), only long after the start and by far.
    """
    real, steps = work.memory.real, int(work.memory.count[m.STEPS])
    if not isinstance(work.problem.method, DOP853 | Taylor) or not real[m.T] > 0:
        return False
    if vibrating(work) < 0 and (steps < LOOKS[1] or not np.any(work.problem.system.law != NONE)):
        return False
    margin = 1 if vibrating(work) >= 0 else BY_FAR
    return bool(steps * work.t_end / real[m.T] > margin * work.problem.method.max_steps)
