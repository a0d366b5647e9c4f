"""Robots of bars: counts of the papers, the Delta robot's closed forms, Stewart-Gough platforms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

P, V, A = np.array([0.05, -0.08, -0.75]), np.array([1.2, -0.7, 0.5]), np.array([8.0, -5.0, 12.0])
"""Place (m), velocity and acceleration of the Delta robot's platform."""
TORQUE = (-7.024949349790452, -0.35332027885705214, -4.538558518535321)
CORNERS = [f"P{k}{side}" for k in (1, 2, 3) for side in "ab"]
SHORT = ("P1a-P2a", "P2a-P3a", "P3a-P1a")
LONG = (("P1a", "P2b"), ("P1b", "P3a"), ("P2a", "P3b"))


def counts(name: str) -> dict[str, float]:
    """Bars, coordinates, fixed ones, rank, freedoms before drives."""
    model = getattr(kt.library.mechanisms, name)()
    found = kt.kinematics.mobility(model)
    own: dict[str, float] = {"coordinates": found.coordinates, "fixed": found.fixed, "rank": found.rank}
    return own | {"bars": len(model.bars), "freedoms": found.degrees_of_freedom}


def long_diagonals() -> dict[str, float]:
    """The Delta robot with the long diagonals of its platform in place of the short ones."""
    model = kt.library.mechanisms.delta()
    bars = {name: bar for name, bar in model.bars.items() if name not in SHORT}
    return {"rank": kt.kinematics.mobility(model.with_(bars=bars | {f"{a}-{b}": kt.Bar(ends=(a, b)) for a, b in LONG})).rank}


def path() -> Any:
    """Motion of the Delta robot whose platform passes P with V and A, in the middle of 41 samples; from another place."""
    t = np.linspace(0.0, 0.04, 41)
    places = (P - (0, 0, 0.05))[:, None] + np.outer(V, t - 0.02) + np.outer(A, (t - 0.02) ** 2 / 2)
    targets = kt.Spline(times=tuple(t), values={f"Q.{axis}": tuple(row) for axis, row in zip("xyz", places, strict=True)})
    return kt.kinematics.inverse(kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7)), targets, samples=41)


def driven() -> dict[str, Any]:
    """Angles of the arms where the platform stands in P, rad, their rates and second rates, and the torques, N m."""
    motion = path()
    now = motion.data.isel(time=20)
    model = kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7))
    forces = kt.dynamics.inverse(model, motion)
    return {
        f"{name}_{k}": value
        for name, three in (
            ("angle", now.drive_position.values),
            ("rate", now.drive_velocity.values),
            ("acceleration", now.drive_acceleration.values),
            ("torque", forces.drive_force.isel(time=20).values),
        )
        for k, value in enumerate(three, start=1)
    }


def held() -> dict[str, float]:
    """Torques that hold the platform in P, N m."""
    model = kt.library.mechanisms.delta(at=tuple(P))
    torques = kt.dynamics.simulate(model, 0.001, samples=2).forces.drive_force.isel(time=0).values
    return {f"static_torque_{k}": value for k, value in enumerate(torques, start=1)}


def pushed() -> Any:
    """Acceleration of the platform in P at velocity V under the torques, m/s^2."""
    now = path().data.isel(time=20)
    model = kt.library.mechanisms.delta(at=tuple(P))
    tasks = {f"arm{k}": kt.GivenForce(torque=torque) for k, torque in enumerate(TORQUE, start=1)}
    velocities = {name: tuple(now.velocity.sel(node=name).values) for name in model.nodes if name not in model.fixed}
    run = kt.dynamics.simulate(model, 1e-4, samples=2, tasks=tasks, velocities=velocities)
    return run.motion.acceleration.sel(node=CORNERS).isel(time=0).mean("node").values


def fallen() -> Any:
    """Middle of the Delta robot's platform after 0.15 s without torques, m."""
    model = kt.library.mechanisms.delta(at=tuple(P))
    tasks = dict.fromkeys(model.drives, kt.Free())
    run = kt.dynamics.simulate(model, 0.15, samples=2, tasks=tasks, method=kt.DOP853(rtol=1e-12, atol=1e-14))
    return run.motion.position.sel(node=CORNERS).isel(time=-1).mean("node").values


def legs() -> dict[str, float]:
    """Leg lengths of the inverse kinematics for a pose, m; distance of the forward kinematics from it, m."""
    model = kt.library.mechanisms.stewart()
    heads = [name for name in model.nodes if name.startswith("P")]
    pose = {"x": 0.05, "y": -0.04, "z": 0.08, "roll": 0.1, "pitch": -0.15, "yaw": 0.25}
    targets = kt.Quintic(moves={key: (0.0, value) for key, value in pose.items()}, duration=1.0)
    end = kt.kinematics.inverse(model, targets, platform=heads, samples=11).data.isel(time=-1)
    found = {f"leg{k}": float(end.drive_position.sel(drive=f"leg{k}")) for k in range(1, 7)}
    forward = kt.kinematics.assemble(model, found)
    return found | {"off": float(np.abs(forward - end.position.values).max())}


def platforms(kind: str) -> dict[str, float]:
    """Freedoms of a platform before and after its drives."""
    spread = {"base_spread": math.pi / 3, "platform_spread": math.pi / 3}
    model = kt.library.build("mechanisms.stewart", spread if kind == "similar" else {"kind": kind})
    found = kt.kinematics.mobility(model)
    return {"before_drives": found.degrees_of_freedom, "after_drives": found.undriven}
