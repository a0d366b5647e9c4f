"""The methods that a run used, and their publications."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["methods"]

GIVEN = (
    "Motion",
    "Node positions satisfy the lengths and angles that bars and drives prescribe, by Newton's method on the blocks "
    "into which the structure falls, from sample to sample with steps cut so that the configuration stays the one "
    "connected to the start. Velocities and accelerations follow from the same matrix; nothing is differenced in "
    "time.",
    "Lacy (1991), chapters 2 to 6; Calladine (1978); Pellegrino and Calladine (1986)",
)
MEASURED = (
    "Motion",
    "Positions, velocities and accelerations of the nodes are those of the given record.",
    "",
)
FORWARD = (
    "Forward dynamics",
    "M a + Jᵀ N = f with the constraints on the level of accelerations, in the coordinates of the nodes. Power "
    "series and the explicit method of order 8, both error controlled, bring positions and velocities back onto the "
    "constraints after every step; the implicit ones hold them at the end of each step. Between steps the motion is read "
    "from the step's own polynomial.",
    "Jorba and Zou, Experimental Mathematics 14 (2005) 99 (power series); Hairer, Nørsett and Wanner, Solving Ordinary "
    "Differential Equations I (DOP853)",
)
LINEAR = (
    "Linear statics",
    "f N − G u = 0 and Gᵀ N = F together, with f = l/(E A): equivalent to the stiffness method, but forces follow from "
    "equilibrium and not from differences of displacements. Displacements are small; drives are locked.",
    "",
)
EQUILIBRIUM = (
    "Equilibrium",
    "Positions at which all nodes are in balance, with large displacements; stability by the stiffness at the solution.",
    "",
)
INVERSE = (
    "Forces",
    "Jᵀ N = f − M a at every sample. A uniform bar has the consistent mass matrix, so that the forces on its joints "
    "are those of Newton and Euler for a rigid rod; the member force is the mean of the tension over its length. An "
    'active member is two rods, base and tube, that slide on one line. "At rest" are the same poses without velocity '
    "and acceleration.",
    "Lacy (1991), chapters 2, 4 and 6",
)
STRENGTH = (
    "Strength",
    "Section forces follow in closed form from the accelerations of the ends. Yield: the largest von Mises stress "
    "along the part and over its section. Buckling: Euler's load, Johnson's parabola for stocky members, for the "
    "length of that instant. Beam-column: linear interaction of both, amplified by the axial force. Utilisation is "
    "demand over capacity, safety factors included; margin is 1/utilisation − 1. Limits of validity: straight "
    "prismatic parts, small strain; no local buckling of thin walls, no strength of joints, no fatigue.",
    "Lacy (1991), eq. 2.20 to 2.35; Shigley, Mechanical Engineering Design; Timoshenko and Gere, Mechanics of "
    "Materials; AISC, Allowable Stress Design (1989), eq. H1-1",
)
DRIVES = (
    "Drives",
    "Thrust is minus the tension of the active member at the nut. The screw raises or lowers by the sign of its "
    "power, with the friction of its thread; the motor's torque has the inertia of motor and gear besides; current is "
    "torque over torque constant, voltage what winding and back-emf need.",
    "Lacy (1991), eq. 2.36 to 2.40 and 4.78; Shigley, Mechanical Engineering Design (power screws)",
)
CHECKS = (
    "Checks",
    "Energy balance: power of drives, loads and moving supports minus the rate of kinetic and potential energy and "
    "what dampers dissipate; forces and motion enter independently, so an error in either opens it. Singularity: an "
    "estimate of the smallest singular value of the gradients of all lengths and angles, in rows of unit length. "
    "Lengths: found anew from node positions.",
    "",
)


SOLVED = {"statics.linear": LINEAR, "statics.equilibrium": EQUILIBRIUM}


def methods(run: RunResult) -> Iterator[tuple[str, str, str]]:
    """Name, what was done, and published sources (or none) of each method that the run used."""
    told = run.told
    if run.simulation is not None or told.analysis == "dynamics.simulate":
        yield FORWARD
    elif told.analysis in SOLVED:
        yield SOLVED[told.analysis]
    else:
        yield GIVEN if told.motion is None else MEASURED
    if run.forces and told.analysis not in SOLVED:
        yield INVERSE
    if run.verdict is not None:
        yield STRENGTH
    if run.demand:
        yield DRIVES
    yield CHECKS
