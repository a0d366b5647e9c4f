"""Strain gauges against the measured poses of Lacy (1991) and against the closed form of a level bar."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics, kinematics, strength
from kinetruss.model import Bar, Gauge, Material, Model, NodalForce, Tube
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference
from kinetruss.verification.thesis.printed import printed
from kinetruss.verification.thesis.tables import LEVEL, LONG, SHORT, at_rest

__all__ = ["cases"]

THREE = {f"G{k}": Gauge(member="M6", at=0.5, angle=2 * math.pi * k / 3, factor=2.1, group="M6") for k in range(3)}

PULL, MASS, SPAN, GRAVITY, E = 250.0, 1.5, 2.0, 9.81, 71e9
TUBE = Tube(outer=0.025, inner=0.021)
BEAM = Reference("closed-form", "a level bar: P/(E A) and, at midspan, m g L/8 times c/(E I)")


def table_5_5(pose: str) -> float:
    """Axial microstrain of the group on M6 in one of the three poses, without weight."""
    model, forces = at_rest("B", {"equilibrium": LEVEL, "M7_long": LONG, "M7_short": SHORT}[pose])
    strains = strength.gauges(model.with_(gauges=THREE), forces)
    return float(strains["group_strain"].sel(group="M6", component="axial").item())


def level_bar() -> dict[str, float]:
    """Readings of gauges on a level bar that is pulled and bends under its weight."""
    turns = {"top": 0.0, "side": math.pi / 2, "low": math.pi}
    model = Model(
        nodes={"A": (0, 0, 0), "B": (SPAN, 0, 0)},
        fixed={"A": "xyz", "B": "yz"},
        gravity=(0, 0, -GRAVITY),
        bars={"bar": Bar(ends=("A", "B"), mass=MASS)},
        section=TUBE,
        material=Material(E=E, density=0.0),
        loads={"pull": NodalForce(node="B", force=(PULL, 0, 0))},
        gauges={name: Gauge(member="bar", angle=angle, factor=2.1, group="mid") for name, angle in turns.items()},
    )
    still = np.zeros((1, 2, 3))
    motion = kinematics.from_arrays(model, [0.0], kinematics.assemble(model)[None], still, still)
    found = strength.gauges(model, dynamics.inverse(model, motion, static=False)).isel(time=0)
    readings = {str(name): found["strain"].sel(gauge=name).item() for name in turns}
    parts = {str(name): found["group_strain"].sel(group="mid", component=name).item() for name in ("axial", "bending_3")}
    return readings | parts | {"bridge": found["bridge"].sel(gauge="low").item()}


def cases() -> Iterator[Case]:
    """Table 5.5 through gauges, the level bar."""
    for one in printed("bay"):
        if "strain_M6" in one.id:
            pose = one.id.rsplit(".", 1)[1]
            yield Case(f"gauges.table_5_5.{pose}", one.reference, one.expected, one.tolerance, table_5_5, (pose,))
    axial = 1e6 * PULL / (E * TUBE.area)
    bending = 1e6 * MASS * GRAVITY * SPAN / 8 * TUBE.outer / 2 / (E * TUBE.second_moments[0])
    change = 2.1e-6 * (axial + bending)
    expected = {
        "top": axial - bending,
        "side": axial,
        "low": axial + bending,
        "axial": axial,
        "bending_3": bending,
        "bridge": (1 + change) / (2 + change) - 0.5,
    }
    for name, value in expected.items():
        tolerance = 1e-9 if name == "bridge" else 1e-12  # a difference of two halves
        yield Case(f"gauges.level_bar.{name}", BEAM, value, tolerance, level_bar, at=(name,))
