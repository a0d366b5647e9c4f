"""Chooses the stepper of a simulation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.dynamics.forward.kernel_stepper import KernelStepper

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.problem import Problem
    from kinetruss.dynamics.forward.stepper import Stepper

__all__ = ["stepper_for"]


def stepper_for(problem: Problem, t_end: float) -> Stepper:
    """The integration of a problem until t_end (s): with motors step by step between input changes, else in one kernel."""
    if problem.motors is None:
        return KernelStepper(problem, t_end)
    # it imports SciPy's integrators, which other simulations do not need
    from kinetruss.dynamics.motors.stepper import MotorStepper

    return MotorStepper(problem, t_end)
