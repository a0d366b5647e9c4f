"""Hubs and their arms, friction from the force in a joint, the torque of a screw about its axis, screw and nut in series."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

STEEL = kt.Material(E=2.1e11, density=7850.0)
ROD: dict[str, Any] = {"section": kt.Rod(diameter=0.02), "material": STEEL}
TIE = kt.Tube(outer=0.02, inner=0.016)
SCREW = kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.12)


def bracket() -> dict[str, float]:
    """Couple and stress at the root of an arm of 50 mm from which 200 N hang."""
    light = kt.Material(E=2e11, density=0.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, -0.5)},
        fixed={"A": "xy", "B": "x"},
        bars={"rod": kt.Bar(ends=("A", "B"), mass=0.0)},
        loads={"W": kt.NodalForce(node="B", force=(0, -200))},
        hubs={"A": kt.Hub(arms={"rod": (0.05, 0)}, section=kt.Rod(diameter=0.02), material=light)},
    )
    x = np.array([[node.at for node in model.nodes.values()]] * 2)
    forces = kt.dynamics.inverse(model, kt.kinematics.from_arrays(model, [0.0, 1.0], x, 0 * x, 0 * x))
    found = kt.strength.sections(model, forces, 2)
    stress = kt.strength.stresses(model, found).von_mises.sel(part="A.rod", station=0)
    return {"couple": abs(float(found.data.section_M.sel(part="A.rod", station=0)[0, 0])), "stress": float(stress[0])}


def linkage() -> dict[str, float]:
    """A heavy four-bar linkage with hubs: residuals of all free bodies and of the energy, relative."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D": (0.9, 0)},
        fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        drives={"motor": kt.AngleDrive("crank")},
        loads={"p": kt.NodalForce(node="C", force=(40, -25))},
        gravity=(0, -9.81),
        hubs={
            "B": kt.Hub(arms={"coupler": (0.03, 0.04)}, clamped=["crank"]),
            "C": kt.Hub(arms={"coupler": 0.04}, clamped=["rocker"]),
            "D": kt.Hub(arms={"rocker": (-0.02, 0.05)}),
        },
        **ROD,
    )
    start = math.atan2(0.15, 0.05)
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": (start, start + 1.0)}, duration=0.4), samples=9)
    forces = kt.dynamics.inverse(model, motion)
    cuts = [{"member": name} for name, bar in model.bars.items() if not bar.brace] + [{"node": name} for name in model.nodes]
    left = [kt.dynamics.free_body(model, motion, forces, time=t, **cut).residual for t in (0.1, 0.2, 0.25) for cut in cuts]
    data = forces.data
    return {
        "free_bodies": max(left) / float(np.abs(data.joint_force).max()),
        "energy": float(np.abs(data.energy_balance).max() / np.abs(data.power).max()),
    }


def pendulum() -> dict[str, float]:
    """Additional torque of the drive of a pendulum by its pin, at both ends of a turn of 1 rad at 2 rad/s."""
    smooth = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=3.0)},
        fixed=["O"],
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0.0)},
        gravity=(0, -9.81),
        drives={"turn": kt.AngleDrive("arm")},
    )
    rough = smooth.with_(bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.03, friction=0.2)})
    motion = kt.kinematics.follow(smooth, kt.ConstantRate(rates={"turn": 2.0}, duration=0.5), samples=3)
    torque = [kt.dynamics.inverse(model, motion).data.drive_force.values[:, 0] for model in (rough, smooth)]
    return {"start": float(torque[0][0] - torque[1][0]), "end": float(torque[0][-1] - torque[1][-1])}


def circles() -> dict[str, float]:
    """Sine of the angle between a massless rod and its force, less that of the tangent to both friction circles."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D": (0.9, 0)},
        fixed=["A", "D"],
        bars={
            name: kt.Bar(ends=ends, mass=0.0)
            for name, ends in (("crank", ("A", "B")), ("coupler", ("B", "C")), ("rocker", ("C", "D")))
        },
        drives={"motor": kt.AngleDrive("crank")},
        loads={"p": kt.NodalForce(node="C", force=(40, -25))},
        bearings={
            "b": kt.Bearing(member="coupler", node="B", radius=0.02, friction=0.15),
            "c": kt.Bearing(member="coupler", node="C", radius=0.03, friction=0.2),
        },
    )
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 1e-3}, duration=1000.0), samples=9)
    push = kt.dynamics.inverse(model, motion).data.joint_force.sel(member="coupler", end="B").values
    rate = kt.kinematics.member_rates(model, motion).angular_velocity.values[:, :, 0]
    x = motion.data.position.values
    d = x[:, 2] - x[:, 1]
    length = np.linalg.norm(d, axis=1)
    sine = (d[:, 0] * push[:, 1] - d[:, 1] * push[:, 0]) / (length * np.linalg.norm(push, axis=1))
    exact = (0.003 * np.sign(rate[:, 1] - rate[:, 0]) + 0.006 * np.sign(rate[:, 1] - rate[:, 2])) / length
    return {"angle": float(np.abs(sine - exact).max())}


def _crane(compliance: kt.Compliance | None) -> kt.Model:
    """A boom held by an active tie under 500 N; its screw raises the load."""
    active = kt.Active(
        ends=("B", "C"),
        base=kt.Part(length=0.6, mass=0.0),
        tube=kt.Part(length=0.4, mass=0.0, section=TIE, material=STEEL),
        screw=SCREW,
        compliance=compliance,
    )
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.8), "C": (0.6, 0)},
        fixed=["A", "B"],
        bars={"boom": kt.Bar(ends=("A", "C"), mass=0.0)},
        active={"tie": active},
        loads={"W": kt.NodalForce(node="C", force=(0, -500))},
    )


def in_series() -> dict[str, float]:
    """Elongation of the tie, and how far the load sinks."""
    found = kt.statics.linear(_crane(kt.Compliance(screw=2.5e6, nut=3e7, base=8e6)))
    sinks = -float(found.data.displacement.sel(node="C", axis="y"))
    return {"elongation": float(found.data.elongation.sel(member="tie")), "sinks": sinks}


def screw() -> dict[str, float]:
    """Torque of the screw about the axis of the tie as it starts to lift the load (in tension: negative)."""
    model = _crane(None)
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"tie": -0.01}, duration=1.0), samples=3)
    demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    return {"torque": float(demand.data.axis_torque.sel(active="tie")[0])}
