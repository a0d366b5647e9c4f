"""Hinges of hubs in space and friction in them, torsion of arms, masses clamped on the rods of active members."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt

LIGHT = kt.Material(E=2e11, density=0.0)
THICK: dict[str, Any] = {"section": kt.Rod(diameter=0.03), "material": LIGHT}


def bracket() -> dict[str, float]:
    """Moment of a member at its vertical hinge, torsion and moment of the arm across it, under 20 N at 1 m."""
    model = kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(1, 0.1, 0), mass=2.0)},
        fixed=["O"],
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        hubs={"O": kt.Hub(arms={"arm": (0, 0.1, 0)}, hinges={"arm": "z"})},
        drives={"turn": kt.AngleDrive("arm", axis="z")},
        gravity=(0, 0, -10.0),
        **THICK,
    )
    found = kt.strength.sections(model, kt.statics.at_poses(model, [{}]), 2).data.isel(time=0, station=0)
    at = {"member": found.section_M.sel(part="arm"), "arm": found.section_M.sel(part="O.arm")}
    torsion = {"torsion": abs(float(found.torsion.sel(part="O.arm")))}
    return {name: float(np.linalg.norm(values)) for name, values in at.items()} | torsion


def slowing(form: str) -> dict[str, float]:
    """Rate of a mass on a light arm after 1 s in a bearing, from 6 rad/s: a pin of the plane, or a hinge in space."""
    if form == "pin":
        given: dict[str, Any] = {"nodes": {"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=3)}}
    else:
        hub = kt.Hub(arms={"arm": (0, 0, 0.1)}, hinges={"arm": "z"})
        given = {"nodes": {"O": (0, 0, 0), "A": kt.Node(at=(0.5, 0, 0.1), mass=3)}, "hubs": {"O": hub}}
    model = kt.Model(
        fixed=["O"],
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0)},
        bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.03, friction=0.2)},
        **given,
    )
    run = kt.dynamics.simulate(model, 1.0, samples=2, velocities={"A": (0, 3.0, 0)[: model.dim]})
    return {"rate": float(np.linalg.norm(run.motion.velocity.sel(node="A")[-1])) / 0.5}


def door() -> dict[str, float]:
    """Torque that turns a door steadily against the friction of its hinge."""
    model = kt.Model(
        nodes={"O": (0, 0, 0), "A": kt.Node(at=(0.8, 0, 0.05), mass=4.0)},
        fixed=["O"],
        bars={"door": kt.Bar(ends=("O", "A"), mass=0)},
        hubs={"O": kt.Hub(arms={"door": (0, 0, 0.05)}, hinges={"door": "z"})},
        drives={"turn": kt.AngleDrive("door", axis="z")},
        bearings={"pin": kt.Bearing(member="door", node="O", radius=0.02, friction=0.25)},
        gravity=(0, 0, -9.81),
    )
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 3.0}, duration=0.5), samples=3)
    return {"torque": float(kt.dynamics.inverse(model, motion).drive_force[1, 0])}


def twisted() -> dict[str, float]:
    """Torsion and moment of an arm at 45 degrees to a couple of 30 N m that enters at its joint, and its shear stress."""
    model = kt.Model(
        nodes={"O": (0, 0, 0), "A": (0.1, 0, 1.0)},
        fixed=["O", "A"],
        bars={"rod": ("O", "A")},
        hubs={"O": kt.Hub(arms={"rod": (0.1, 0, 0.1)})},
        loads={"screw": kt.BodyCouple(body="O.hub", member="rod", moment=(0, 0, 30.0))},
        **THICK,
    )
    sections = kt.strength.sections(model, kt.statics.at_poses(model, [{}]), 2)
    stress = kt.strength.stresses(model, sections).von_mises.sel(part="O.rod").isel(time=0, station=0)
    found = sections.data.sel(part="O.rod").isel(time=0, station=0)
    return {
        "torsion": float(found.torsion),
        "moment": float(np.linalg.norm(found.section_M)),
        "stress": float(stress),
    }


def masses() -> dict[str, float]:
    """Axial forces of an active member that turns at 3 rad/s: at the clamped end of its base, behind the mass on it, at the
    nut, and in the tube up to its mass.
    """
    active = kt.Active(
        ends=("A", "B"),
        base=kt.Part(length=0.6, mass=1.1, masses=[{"at": 0.1, "mass": 0.4}]),
        tube=kt.Part(length=0.5, mass=0.5, masses=[{"at": 0.12, "mass": 0.6}]),
    )
    model = kt.Model(nodes={"A": (0, 0), "B": (0.9, 0)}, fixed=["A"], active={"a": active}, drives={"turn": kt.AngleDrive("a")})
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 3.0, "a": 0.0}, duration=0.5), samples=3)
    forces = kt.dynamics.inverse(model, motion)
    T = kt.strength.sections(model, forces, [0.0, 0.5, 1.0]).data.section_T.isel(time=1)
    return {
        "base": float(T.sel(part="a.base", station=0.0)),
        "behind": float(T.sel(part="a.base", station=0.5)),
        "drive": float(forces.drive_force.sel(drive="a")[1]),
        "tube": float(T.sel(part="a.tube", station=0.5)),
    }
