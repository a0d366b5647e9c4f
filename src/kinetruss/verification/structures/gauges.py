"""Strain gauges against the measured poses of Lacy (1991) and against the closed form of a horizontal bar."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt
from kinetruss.verification.thesis.tables import LEVEL, LONG, SHORT, at_rest

THREE = {f"G{k}": kt.Gauge(member="M6", at=0.5, angle=2 * math.pi * k / 3, factor=2.1, group="M6") for k in range(3)}

TENSION, MASS, SPAN, GRAVITY, E = 250.0, 1.5, 2.0, 9.81, 71e9
TUBE = kt.Tube(outer=0.025, inner=0.021)


def table_5_5(pose: str) -> dict[str, float]:
    """Axial microstrain of the group on M6 in one of the three poses, without weight."""
    model, forces = at_rest("B", {"equilibrium": LEVEL, "M7_long": LONG, "M7_short": SHORT}[pose])
    strains = kt.strength.gauges(model.with_(gauges=THREE), forces)
    return {"strain": strains["group_strain"].sel(group="M6", component="axial").item()}


def level_bar() -> dict[str, float]:
    """Readings of gauges on a horizontal bar in tension that bends under its weight."""
    turns = {"top": 0.0, "side": math.pi / 2, "low": math.pi}
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (SPAN, 0, 0)},
        fixed={"A": "xyz", "B": "yz"},
        gravity=(0, 0, -GRAVITY),
        bars={"bar": kt.Bar(ends=("A", "B"), mass=MASS)},
        section=TUBE,
        material=kt.Material(E=E, density=0.0),
        loads={"end": kt.NodalForce(node="B", force=(TENSION, 0, 0))},
        gauges={name: kt.Gauge(member="bar", angle=angle, factor=2.1, group="mid") for name, angle in turns.items()},
    )
    still = np.zeros((1, 2, 3))
    motion = kt.kinematics.from_arrays(model, [0.0], kt.kinematics.assemble(model)[None], still, still)
    found = kt.strength.gauges(model, kt.dynamics.inverse(model, motion, static=False)).isel(time=0)
    readings = {str(name): found["strain"].sel(gauge=name).item() for name in turns}
    parts = {str(name): found["group_strain"].sel(group="mid", component=name).item() for name in ("axial", "bending_3")}
    return readings | parts | {"bridge": found["bridge"].sel(gauge="low").item()}


def rosette() -> dict[str, float]:
    """Principal strains of a rosette at 0, 45, 90 degrees that reads 500, 350, -100, and their angle."""
    found = kt.strength.rosette([500.0, 350.0, -100.0], np.radians([0, 45, 90]))
    return {"largest": float(found.principal[0]), "least": float(found.principal[1]), "tangent": float(np.tan(2 * found.angle))}


def shunt() -> dict[str, float]:
    """Reading of a 120 ohm gauge, factor 2, with a resistor of 59,880 ohm across it, from the voltage of its bridge."""
    arm = 120 * 59880 / (120 + 59880)
    strain = kt.strength.bridge_strain(10 * (arm / (arm + 120) - 0.5), kt.Bridge(excitation=10), 2.0)
    return {"strain": float(strain)}
