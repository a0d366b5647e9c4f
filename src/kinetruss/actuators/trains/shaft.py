"""Gear and screw, or gear alone, seen from the motor's shaft.

What it moves is a length against a thrust, or an angle against a torque: of an angle, read N m for N, rad for m, kg m^2 for kg.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinetruss.actuators.trains.screw import lowering_torque, raising_torque, sticking
from kinetruss.errors import InputError
from kinetruss.model import DriveTrain

__all__ = ["Shaft", "shaft_of"]


@dataclass(frozen=True, slots=True)
class Shaft:
    """What a thrust and a rate of length are at the motor.

    speed : rad/m, motor speed a rate of length, G/lead. gear : G. lead : m/rad. inertia : kg m^2, of motor and gear.
    friction : N m, of the motor. up, down : N m a newton at the motor, along the motion, to raise and to lower a load; negative
    where lowering must be held back. rest_up, rest_down : the same with the screw's static friction. screw_up, screw_down : at
    the screw, or behind the gear of an angle (1, -1), whose lead is 1. turns : it is an angle.
    """

    speed: float
    gear: float
    lead: float
    inertia: float
    friction: float
    up: float
    down: float
    rest_up: float
    rest_down: float
    screw_up: float
    screw_down: float
    turns: bool

    def resistance(self, against: float) -> float:
        """Torque (N m) along the motion for a thrust (N) counted along the motion: positive is raised, negative lowered."""
        return against * self.up if against >= 0 else -against * self.down

    def needed(self, direction: int, thrust: float) -> float:
        """Torque (N m) along `direction` that keeps the drive moving at a constant speed."""
        return self.friction + self.resistance(direction * thrust)

    def breakaway(self, direction: int, thrust: float) -> float:
        """Torque (N m) along `direction` that starts it from rest."""
        against = direction * thrust
        return self.friction + (against * self.rest_up if against >= 0 else -against * self.rest_down)

    def acceleration(self, direction: int, torque: float, thrust: float, mass: float) -> float:
        """Acceleration of the length (m/s^2) when the motor gives `torque` (N m) and moves `mass` (kg) against `thrust` (N).

        J G/lead a = T - T_f - R(F + m a) along the motion; R has one slope for raising and one for lowering, so that the
        solution is on one of two straight lines.
        """
        given = direction * torque - self.friction
        load, rotor = direction * thrust, self.inertia * self.speed
        found = (given - load * self.up) / (rotor + mass * self.up)
        if load + mass * found < 0:
            found = (given + load * self.down) / (rotor - mass * self.down)
        return direction * found


def shaft_of(train: DriveTrain) -> Shaft:
    """Gear and screw of a drive train at its motor's shaft.

    The gear's efficiency divides what flows to the screw, and multiplies what flows back.
    """
    screw, gear = train.screw, train.gear

    def geared(torque: float) -> float:
        return torque / gear.ratio / gear.efficiency if torque > 0 else torque / gear.ratio * gear.backwards

    up, down, rest_up, rest_down = 1.0, -1.0, 1.0, -1.0
    if screw is not None:
        rest = sticking(screw)
        up, down = raising_torque(screw, 1.0), lowering_torque(screw, 1.0)
        rest_up, rest_down = raising_torque(rest, 1.0), lowering_torque(rest, 1.0)
    lead = 1.0 if screw is None else screw.lead
    inertia = train.motor.inertia + gear.inertia
    if inertia <= 0:
        raise InputError("A drive without inertia of motor and gear has no acceleration. Give the motor's inertia.")
    return Shaft(
        speed=gear.ratio / lead,
        gear=gear.ratio,
        lead=lead,
        inertia=inertia,
        friction=train.motor.friction_torque,
        up=geared(up),
        down=geared(down),
        rest_up=geared(rest_up),
        rest_down=geared(rest_down),
        screw_up=up,
        screw_down=down,
        turns=screw is None,
    )
