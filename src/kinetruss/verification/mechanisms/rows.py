"""Hinges, angles about axes and couplings: closed forms, and Andrews' mechanism with a rotation coordinate."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.library import mechanisms
from kinetruss.model import (
    DOP853,
    AngleDrive,
    Bar,
    ConstantRate,
    CoordinateDrive,
    Coupling,
    GivenForce,
    HingeDrive,
    Model,
    Node,
    OffsetCoordinate,
    Quintic,
)
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

FINE = DOP853(rtol=1e-12, atol=1e-13)
PITCH, TORQUE, RATE = 0.02, 4.0, 3.0
GROWTH = TORQUE / (2.0 * 0.5**2 + 0.25 * 1.0 * 0.3**2)
FALL = -3.5 * 9.81 / (3.5 + 0.5 * 0.3**2 * (2 * math.pi / PITCH) ** 2)
CENTRE = 1.4 / 3.0


def _bars(*pairs: str) -> dict[str, Bar]:
    return {pair: Bar(ends=(pair[0], pair[1]), mass=0.0) for pair in pairs}


def hinge() -> dict[str, float]:
    """A mass on a hinge about z: the torque of a given motion over more than a full turn, against m r^2 q'' + m g r sin q."""
    model = Model(
        nodes={"A": (0, 0, 0), "B": (0, 0, 1.0), "C": Node(at=(1, 0, 0.3), mass=2.0), "D": (0, -1, 0)},
        fixed=["A", "B", "D"],
        bars=_bars("AC", "BC"),
        gravity=(0, -9.81, 0),
        drives={"turn": HingeDrive(axis=("A", "B"), start="D", end="C")},
    )
    path = Quintic(moves={"turn": (math.pi / 2, math.pi / 2 + 7)}, duration=1.0)
    motion = kinematics.follow(model, path, samples=101)
    q, second = motion.data["drive_position"].values[:, 0], motion.data["drive_acceleration"].values[:, 0]
    found = dynamics.inverse(model, motion).data["drive_force"].values[:, 0]
    exact = 2.0 * second + 2.0 * 9.81 * np.sin(q)
    return {"hinge": float(np.abs(found - exact).max() / np.abs(exact).max())}


def screw() -> dict[str, float]:
    """A nut falls on a thread for 3 s: height and turns."""
    thread = ((CoordinateDrive(node="C", axis="z"), 2 * math.pi / PITCH), (AngleDrive("CD", axis="z"), -1.0))
    model = Model(
        nodes={"C": Node(at=(0, 0, 1.0), mass=3.0), "E": (0, 0, 1.2), "D": Node(at=(0.3, 0, 1.0), mass=0.5)},
        fixed={"C": "xy", "E": "xy"},
        gravity=(0, 0, -9.81),
        bars=_bars("CD", "CE", "ED"),
        couplings={"thread": Coupling(terms=thread)},
    )
    run = dynamics.simulate(model, 3.0, samples=4, method=FINE)
    C, D = (run.motion.position.isel(time=-1).sel(node=name).values for name in "CD")
    return {"fall": float(C[2]) - 1.0, "rim.x": float(D[0]), "rim.y": float(D[1])}


def gears() -> dict[str, float]:
    """Two arms geared 2 : 1 under a torque on the faster one: its angle after 3 s."""
    mesh = ((HingeDrive(axis=("A",), start="C", end="B"), -1.0), (HingeDrive(axis=("C",), start="A", end="D"), 2.0))
    model = Model(
        nodes={"A": (0, 0), "B": Node(at=(0.5, 0), mass=2.0), "C": (1, 0), "D": Node(at=(1, 0.3), mass=1.0)},
        fixed=["A", "C"],
        bars=_bars("AB", "CD"),
        drives={"motor": AngleDrive("AB")},
        couplings={"mesh": Coupling(terms=mesh)},
    )
    run = dynamics.simulate(model, 3.0, samples=61, tasks={"motor": GivenForce(torque=TORQUE)}, method=FINE)
    return {"turned": run.motion.drive_position.values[-1].item()}


def slider() -> dict[str, float]:
    """Two masses on a rod that turns steadily: how far their centre is after 0.8 s, and the torque on the rod."""
    sides = {
        f"side_{name}": Coupling(terms=((OffsetCoordinate(line=("A", "B"), point=name), 1.0),), value=0.0) for name in "CD"
    }
    model = Model(
        nodes={"A": (0, 0), "B": (1.0, 0), "C": Node(at=(0.4, 0), mass=2.0), "D": Node(at=(0.6, 0), mass=1.0)},
        fixed=["A"],
        bars=_bars("AB", "CD"),
        drives={"motor": AngleDrive("AB")},
        couplings=sides,
        velocities={"B": (0, RATE), "C": (0, 0.4 * RATE), "D": (0, 0.6 * RATE)},
    )
    path = ConstantRate(rates={"motor": RATE}, duration=0.8)
    run = dynamics.simulate(model, 0.8, samples=5, trajectory=path, method=FINE)
    at = run.motion.position.isel(time=-1)
    centre = (2.0 * at.sel(node="C").values + at.sel(node="D").values) / 3.0
    return {"away": float(np.linalg.norm(centre)), "torque": run.forces.drive_force.values[-1].item()}


def beam() -> dict[str, float]:
    """Andrews' mechanism with the rotation of its crank as a coordinate, at 0.03 s; and the coordinates counted."""
    model = mechanisms.andrews(form="beam")
    counts = kinematics.mobility(model)
    run = dynamics.simulate(
        model,
        0.03,
        samples=31,
        tasks={"motor": GivenForce(torque=mechanisms.ANDREWS_TORQUE)},
        method=DOP853(rtol=1e-13, atol=1e-15),
    )
    at = run.motion.data.isel(time=-1)
    found = {name: at[name].sel(node="beta", axis="x").item() for name in ("position", "velocity", "acceleration")}
    found |= {f"{node}.{axis}": at["position"].sel(node=node, axis=axis).item() for node in "FEDGH" for axis in "xy"}
    return found | {"coordinates": counts.coordinates, "fixed": counts.fixed, "freedoms": counts.degrees_of_freedom}


def cases() -> Iterator[Case]:
    """Closed forms; 28-digit values of Andrews' mechanism."""
    yield Case("rows.hinge.torque", Reference("closed-form", "m r^2 q'' + m g r sin q"), 0.0, 1e-10, hinge, (), ("hinge",), 1.0)
    source = Reference("closed-form", "z'' = -m g/(m + m_rim r^2 (2 pi/p)^2)")
    angle = 2 * math.pi / PITCH * FALL * 4.5
    yield Case("joints.screw.fall", source, FALL * 4.5, 1e-10, screw, (), ("fall",))
    for axis, value in (("x", 0.3 * math.cos(angle)), ("y", 0.3 * math.sin(angle))):
        yield Case(f"joints.screw.rim.{axis}", source, value, 1e-8, screw, (), (f"rim.{axis}",), 0.3)
    yield Case(
        "rows.gears.angle", Reference("closed-form", "T t^2/2/(I_1 + I_2/n^2)"), 4.5 * GROWTH, 1e-10, gears, (), ("turned",)
    )
    away = CENTRE * math.cosh(RATE * 0.8)
    source = Reference("closed-form", "r'' = w^2 r, torque 2 m r r' w")
    yield Case("rows.slider.away", source, away, 1e-10, slider, (), ("away",))
    torque = 6.0 * away * CENTRE * RATE * math.sinh(RATE * 0.8) * RATE
    yield Case("rows.slider.torque", source, torque, 1e-9, slider, (), ("torque",))
    data = load("forward")["andrews"]
    source = Reference("independent", data["source"])
    for k, (name, tolerance) in enumerate((("position", 1e-11), ("velocity", 1e-9), ("acceleration", 1e-8))):
        yield Case(f"rows.andrews.beta.{name}", source, data["exact"][7 * k], tolerance, beam, (), (name,))
    for node, place in data["points"].items():
        for axis, value in zip("xy", place, strict=True):
            yield Case(f"rows.andrews.{node}.{axis}", source, value, 1e-11, beam, (), (f"{node}.{axis}",), 0.02)
    counted = "J. P. Meijaard, truss elements in multibody dynamics: nine bars and a rigid beam with a rotation coordinate"
    built = ("ten bars, a scalar node and a coupling, where the paper has nine bars and a rigid beam",)
    for name, count in (("coordinates", 19), ("fixed", 8), ("freedoms", 1)):
        reference = Reference("count" if name == "freedoms" else "input-check", counted, "", built)
        yield Case(f"rows.andrews.{name}", reference, count, 0.0, beam, (), (name,))
