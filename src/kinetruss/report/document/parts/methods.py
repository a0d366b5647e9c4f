"""The methods that a run used, and their publications."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["methods"]

GIVEN = (
    "Motion",
    "Node positions satisfy the lengths and angles that bars and drives prescribe. They are found by Newton's method from "
    "sample to sample; steps are halved where necessary, so that the configuration stays connected to that of the start. "
    "Velocities and accelerations follow from the same matrix. Nothing is differentiated numerically in time.",
    "Lacy (1991), chapters 2 to 6; Calladine (1978); Pellegrino and Calladine (1986)",
)
MEASURED = (
    "Motion",
    "Positions, velocities and accelerations of the nodes are those of the given record.",
    "",
)
FORWARD = (
    "Forward dynamics",
    "M a + Jᵀ N = f together with the constraints on accelerations, in the coordinates of the nodes. Methods with error "
    "control (power series, Runge-Kutta of order 8) project positions and velocities onto the constraints after every step; "
    "implicit methods satisfy them at the end of each step. Between steps the motion is that of the polynomial of the step.",
    "Jorba and Zou, Experimental Mathematics 14 (2005) 99 (power series); Hairer, Nørsett and Wanner, Solving Ordinary "
    "Differential Equations I (DOP853)",
)
LINEAR = (
    "Linear statics",
    "f N − G u = 0 and Gᵀ N = F together, with f = L/(E A), compatibility matrix G and displacements u. This is equivalent to "
    "the stiffness method, but forces follow from equilibrium and not from differences of displacements. Displacements are "
    "small; drives are locked.",
    "",
)
EQUILIBRIUM = (
    "Equilibrium",
    "Positions at which all nodes are in balance, with large displacements; stability by the stiffness at the solution.",
    "",
)
INVERSE = (
    "Forces",
    "Jᵀ N = f − M a at every sample. A uniform bar has the consistent mass matrix: the forces on its joints are those of "
    "Newton and Euler for a rigid rod. The member force is the mean of the tension over its length. An active member is two "
    'rods, base and tube, that slide along one line. "At rest" means the same poses without velocity and acceleration.',
    "Lacy (1991), chapters 2, 4 and 6",
)
STRENGTH = (
    "Strength",
    "Section forces follow in closed form from the accelerations of the ends. Yield: the largest von Mises stress "
    "along the part and over its section. Buckling: Euler's load, or Johnson's parabola for stocky members, with the length "
    "of that instant. Beam-column: linear interaction of compression and bending; the compression amplifies the bending. "
    "Utilisation is demand over capacity, safety factors included; margin is 1/utilisation − 1. Limits of validity: straight "
    "prismatic parts and small strains; local buckling of thin walls, strength of joints and fatigue are not included.",
    "Lacy (1991), eq. 2.20 to 2.35; Shigley, Mechanical Engineering Design; Timoshenko and Gere, Mechanics of "
    "Materials; AISC, Allowable Stress Design (1989), eq. H1-1",
)
DRIVES = (
    "Drives",
    "The thrust is the compression of the active member at the nut. The sign of its power decides whether the screw raises or "
    "lowers its load, against the friction of its thread. The torque of the motor includes the inertia of motor and gear. The "
    "current is this torque over the torque constant; the voltage is that of the winding plus the back-emf.",
    "Lacy (1991), eq. 2.36 to 2.40 and 4.78; Shigley, Mechanical Engineering Design (power screws)",
)
CHECKS = (
    "Checks",
    "Energy balance: the power of drives, loads and moving supports, minus the rate of kinetic and potential energy, minus the "
    "power that dampers dissipate. Forces and motion enter independently, so that an error in either shows. Singularity: an "
    "estimate of the smallest singular value of the gradients of all lengths and angles, each of unit length. Lengths of bars "
    "are computed again from the positions of the nodes.",
    "",
)


SOLVED = {"statics.linear": LINEAR, "statics.equilibrium": EQUILIBRIUM}


def methods(run: RunResult) -> Iterator[tuple[str, str, str]]:
    """Name, what was done, and published sources (or none) of each method that the run used."""
    definition = run.definition
    if run.simulation is not None or definition.analysis == "dynamics.simulate":
        yield FORWARD
    elif definition.analysis in SOLVED:
        yield SOLVED[definition.analysis]
    else:
        yield GIVEN if definition.motion is None else MEASURED
    if run.forces and definition.analysis not in SOLVED:
        yield INVERSE
    if run.verdict is not None and run.verdict.table():
        yield STRENGTH
    if run.demand:
        yield DRIVES
    yield CHECKS
