"""Arms, friction of pins, screws: closed forms of `kinetruss verify`, group members."""

from __future__ import annotations

import math

__all__ = ["joints"]


def joints() -> dict[str, float]:
    """Expected values by the names of the cases."""
    W, e, d = 200.0, 0.05, 0.02
    m, l, w, g, arm = 3.0, 0.5, 2.0, 9.81, 0.2 * 0.03
    # reaction of the pin at the angle phi: against weight and centrifugal force
    pin = [math.hypot(m * l * w * w * math.cos(phi), m * g - m * l * w * w * math.sin(phi)) for phi in (0.0, 1.0)]
    area = math.pi / 4 * (0.02**2 - 0.016**2)
    N = 500.0 / 0.8
    longer = N * ((1.0 - 0.4) / 2.5e6 + 0.4 / (2.1e11 * area) + 1 / 3e7 + 1 / 8e6)
    lead, mu, mean = 2 * math.pi * 0.001, 0.12, 0.02
    k = 0.2 * 0.03 / 0.5
    slowed = 1 / (1 / 6.0 + k / math.sqrt(1 - k * k))
    part, thick = 30.0 / math.sqrt(2), math.pi * 0.03**3
    # first moments about the axis: of the tube and its mass, of it up to the middle, of the base and its mass
    tube, near, base = 0.5 * 0.65 + 0.6 * 0.78, 0.25 * (0.4 + 0.65) / 2, 1.1 * 0.3 + 0.4 * 0.1
    return {
        "hub.hinge.member": 2.0 * 10 * 1.0,
        "hub.hinge.arm": 2.0 * 10 * 0.1,
        "hub.hinge.torsion": 2.0 * 10 * 1.0,
        "bearing.slowing.pin.rate": slowed,
        "bearing.slowing.hinge.rate": slowed,
        "bearing.hinge.torque": 0.25 * 0.02 * 4.0 * math.hypot(g, 9.0 * 0.8),
        "hub.twisted.torsion": part,
        "hub.twisted.moment": part,
        "hub.twisted.stress": math.sqrt((32 * part / thick) ** 2 + 3 * (16 * part / thick) ** 2),
        "rods.masses.base": 9.0 * (tube + base),
        "rods.masses.behind": 9.0 * (tube + 1.1 / 2 * 0.45),
        "rods.masses.drive": -9.0 * tube,
        "rods.masses.tube": 9.0 * (tube - near),
        "hub.bracket.couple": W * e,
        "hub.bracket.stress": 32 * W * e / (math.pi * d**3),
        "bearing.pendulum.start": arm * pin[0],
        "bearing.pendulum.end": arm * pin[1],
        "actuator.compliance.elongation": longer,
        "actuator.compliance.sinks": longer / 0.8,
        "actuator.axis_torque.torque": -N * mean / 2 * (lead + math.pi * mu * mean) / (math.pi * mean - mu * lead),
    }
