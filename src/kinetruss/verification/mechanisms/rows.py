"""Hinges, angles about axes and couplings: closed forms, and Andrews' mechanism with a rotation coordinate."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import off

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)
PITCH, TORQUE, RATE = 0.02, 4.0, 3.0


def _bars(*pairs: str) -> dict[str, kt.Bar]:
    return {pair: kt.Bar(ends=(pair[0], pair[1]), mass=0.0) for pair in pairs}


def hinge() -> dict[str, float]:
    """A mass on a hinge about z: the torque of a given motion over more than a full turn, against m r^2 q'' + m g r sin q."""
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (0, 0, 1.0), "C": kt.Node(at=(1, 0, 0.3), mass=2.0), "D": (0, -1, 0)},
        fixed=["A", "B", "D"],
        bars=_bars("AC", "BC"),
        gravity=(0, -9.81, 0),
        drives={"turn": kt.HingeDrive(axis=("A", "B"), start="D", end="C")},
    )
    path = kt.Quintic(moves={"turn": (math.pi / 2, math.pi / 2 + 7)}, duration=1.0)
    motion = kt.kinematics.follow(model, path, samples=101)
    q, second = motion.data["drive_position"].values[:, 0], motion.data["drive_acceleration"].values[:, 0]
    found = kt.dynamics.inverse(model, motion).data["drive_force"].values[:, 0]
    exact = 2.0 * second + 2.0 * 9.81 * np.sin(q)
    return {"hinge": off(found, exact)}


def screw() -> dict[str, float]:
    """A nut falls on a thread for 3 s: height and turns."""
    thread = ((kt.CoordinateDrive(node="C", axis="z"), 2 * math.pi / PITCH), (kt.AngleDrive("CD", axis="z"), -1.0))
    model = kt.Model(
        nodes={"C": kt.Node(at=(0, 0, 1.0), mass=3.0), "E": (0, 0, 1.2), "D": kt.Node(at=(0.3, 0, 1.0), mass=0.5)},
        fixed={"C": "xy", "E": "xy"},
        gravity=(0, 0, -9.81),
        bars=_bars("CD", "CE", "ED"),
        couplings={"thread": kt.Coupling(terms=thread)},
    )
    run = kt.dynamics.simulate(model, 3.0, samples=4, method=FINE)
    C, D = (run.motion.position.isel(time=-1).sel(node=name).values for name in "CD")
    return {"fall": float(C[2]) - 1.0, "rim.x": D[0], "rim.y": D[1]}


def gears() -> dict[str, float]:
    """Two arms geared 2 : 1 under a torque on the faster one: its angle after 3 s."""
    mesh = ((kt.HingeDrive(axis=("A",), start="C", end="B"), -1.0), (kt.HingeDrive(axis=("C",), start="A", end="D"), 2.0))
    model = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.5, 0), mass=2.0), "C": (1, 0), "D": kt.Node(at=(1, 0.3), mass=1.0)},
        fixed=["A", "C"],
        bars=_bars("AB", "CD"),
        drives={"motor": kt.AngleDrive("AB")},
        couplings={"mesh": kt.Coupling(terms=mesh)},
    )
    run = kt.dynamics.simulate(model, 3.0, samples=61, tasks={"motor": kt.GivenForce(torque=TORQUE)}, method=FINE)
    return {"turned": run.motion.drive_position.values[-1].item()}


def slider() -> dict[str, float]:
    """Two masses on a rod that turns steadily: how far their centre is after 0.8 s, and the torque on the rod."""
    sides = {
        f"side_{name}": kt.Coupling(terms=((kt.OffsetCoordinate(line=("A", "B"), point=name), 1.0),), value=0.0)
        for name in "CD"
    }
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1.0, 0), "C": kt.Node(at=(0.4, 0), mass=2.0), "D": kt.Node(at=(0.6, 0), mass=1.0)},
        fixed=["A"],
        bars=_bars("AB", "CD"),
        drives={"motor": kt.AngleDrive("AB")},
        couplings=sides,
        velocities={"B": (0, RATE), "C": (0, 0.4 * RATE), "D": (0, 0.6 * RATE)},
    )
    path = kt.ConstantRate(rates={"motor": RATE}, duration=0.8)
    run = kt.dynamics.simulate(model, 0.8, samples=5, trajectory=path, method=FINE)
    at = run.motion.position.isel(time=-1)
    centre = (2.0 * at.sel(node="C").values + at.sel(node="D").values) / 3.0
    return {"away": float(np.linalg.norm(centre)), "torque": run.forces.drive_force.values[-1].item()}


def beam() -> dict[str, float]:
    """Andrews' mechanism with the rotation of its crank as a coordinate, at 0.03 s; and the coordinates counted."""
    model = kt.library.mechanisms.andrews(form="beam")
    counts = kt.kinematics.mobility(model)
    run = kt.dynamics.simulate(
        model,
        0.03,
        samples=31,
        tasks={"motor": kt.GivenForce(torque=kt.library.mechanisms.ANDREWS_TORQUE)},
        method=kt.DOP853(rtol=1e-13, atol=1e-15),
    )
    at = run.motion.data.isel(time=-1)
    found = {name: at[name].sel(node="beta", axis="x").item() for name in ("position", "velocity", "acceleration")}
    found |= {f"{node}.{axis}": at["position"].sel(node=node, axis=axis).item() for node in "FEDGH" for axis in "xy"}
    return found | {"coordinates": counts.coordinates, "fixed": counts.fixed, "freedoms": counts.degrees_of_freedom}
