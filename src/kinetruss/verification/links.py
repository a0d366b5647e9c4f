"""Links: a scissor lift, a bell crank, a beam with an overhang, a physical pendulum; over their closed forms."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt
from kinetruss.verification.measures import Numbers

STEEL = kt.Material(E=200e9, density=7800.0)
FLAT, SQUARE = kt.Rectangle(width=0.02, height=0.06), kt.Rectangle(width=0.02, height=0.02)
G = 9.81


def closed_forms() -> Numbers:
    """Push and moment at the pin of a scissor lift, force of a bell crank, tip of a beam with an overhang."""
    load, weight = 1e3, FLAT.area * STEEL.density * G
    lift = kt.Model(
        nodes={"A": (0, 0), "B": (0.8, 0), "M": (0.4, 0.3), "C": (0.8, 0.6), "D": (0, 0.6)},
        fixed={"A": "xy", "B": "y"},
        links={"front": ("A", "M", "C"), "back": ("B", "M", "D")},
        drives={"push": kt.CoordinateDrive(node="B", axis="x")},
        loads={side: kt.NodalForce(node=side, force=(0, -load)) for side in ("C", "D")},
        gravity=(0, -G),
        section=FLAT,
        material=STEEL,
    )
    rest = kt.runs.forces_at_rest(lift)
    moment = kt.strength.beams(lift, rest, stations=[0.5]).section_M.sel(beam="front", moment="3").values.item()
    found = {"push": -rest.drive_force.values.item() / ((2 * load + weight) * 0.8 / 0.6)}
    found["pin_moment"] = -moment / (0.8 * (load * 0.5 + weight * 0.5 * 0.25))
    crank = kt.Model(
        nodes={"A": (-0.3, 0), "O": (0, 0), "B": (0, 0.2), "R": (0.5, 0.2)},
        fixed=["O", "R"],
        links={"crank": ("A", "O", "B")},
        bars={"rod": ("B", "R")},
        loads={"P": kt.NodalForce(node="A", force=(0, -load))},
        section=FLAT,
        material=STEEL,
    )
    found["bell_crank"] = kt.statics.linear(crank).member_force.values.item() / load
    beam = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1.5, 0)},
        fixed={"A": "xy", "B": "y"},
        links={"beam": ("A", "B", "C")},
        loads={"P": kt.NodalForce(node="C", force=(0, -load))},
        section=FLAT,
        material=STEEL,
    )
    tip = -kt.statics.linear(beam).displacement.sel(node="C", axis="y").item()
    found["overhang"] = tip * 3 * STEEL.E * FLAT.second_moments[1] / (load * 0.5**2 * 1.5)
    return found


def pendulum() -> Numbers:
    """Period of a link of 1 m that swings by 90 degrees about a pin 0.3 m from its middle, over the closed form; change of
    energy in ten swings, over the largest kinetic one.
    """
    from scipy.special import ellipk

    d = 0.3
    rate = math.sqrt(G * d / (1 / 12 + 0.02**2 / 12 + d**2))  # of small swings
    modulus = math.sin(math.pi / 4)
    period = 4 * ellipk(modulus**2) / rate
    rod = kt.Model(
        nodes={"A": (0, 0.2), "O": (0, 0), "B": (0, -0.8)},
        fixed=["O"],
        links={"rod": ("A", "O", "B")},
        gravity=(0, -G),
        section=SQUARE,
        material=STEEL,
        velocities={"B": (2 * modulus * rate * 0.8, 0)},
    )
    run = kt.dynamics.simulate(rod, 10 * period, times=np.array([0.0, 9.9, 10.0]) * period)
    x, v = (getattr(run.motion, name).sel(node="B", axis="x").values for name in ("position", "velocity"))
    return {"period": 1 - x[-1] / (v[-1] * 10 * period), "energy": np.ptp(run.energy.values) / run.kinetic_energy.values.max()}
