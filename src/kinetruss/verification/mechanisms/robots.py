"""Robots of bars: counts of the papers, the Delta robot's closed forms, Stewart-Gough platforms."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics, kinematics, library
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, Bar, Free, GivenForce, Model, Quintic, Spline
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

COUNTED = "J. P. Meijaard, truss elements in multibody dynamics: counts of the mechanism"
PLACED = (
    "sizes and masses, where the paper has a figure and counts; the model was made to have the counts of bars and coordinates",
)
PAPER = Reference("count", COUNTED, "", PLACED)
BUILT = Reference("input-check", COUNTED, "", PLACED)
BACK = Reference("agreement", "leg lengths of a pose, and the pose of these lengths")
INVERSE = Reference("closed-form", "2 L (a cos t - z sin t) = d^2 + L^2 - l^2 (own, 16 digits)")
FALL = Reference("independent", "virtual work in the three coordinates of the platform, integrated apart (own, 14 digits)")
WORK = Reference("closed-form", "M(P) P'' + h = J^T torque by virtual work (own, 15 digits)")
LEGS = Reference("closed-form", "l = |p + R b - a|")

P, V, A = np.array([0.05, -0.08, -0.75]), np.array([1.2, -0.7, 0.5]), np.array([8.0, -5.0, 12.0])
"""Place (m), velocity and acceleration of the Delta robot's platform."""
THETA = (0.2032907176392995, 0.44966326347074936, 0.21341826311254275)
RATE = (-2.9806636844361205, 1.2791692942618247, -0.8570788305816782)
SECOND = (-38.776627501548965, -2.016527008940502, -21.182229332779013)
TORQUE = (-7.024949349790452, -0.35332027885705214, -4.538558518535321)
STATIC = (-2.431500212975645, -1.7843495613724354, -2.4074807777433316)
FALLEN = (0.05112539021292342, -0.08176370419970541, -0.8862096864133835)
CORNERS = [f"P{k}{side}" for k in (1, 2, 3) for side in "ab"]
SHORT = ("P1a-P2a", "P2a-P3a", "P3a-P1a")
LONG = (("P1a", "P2b"), ("P1b", "P3a"), ("P2a", "P3b"))

COUNTS = ("bars", "coordinates", "fixed", "rank", "freedoms")


def counts(name: str) -> dict[str, float]:
    """Bars, coordinates, fixed ones, rank, freedoms before drives."""
    model = getattr(mechanisms, name)()
    found = kinematics.mobility(model)
    return dict(
        zip(COUNTS, (len(model.bars), found.coordinates, found.fixed, found.rank, found.degrees_of_freedom), strict=True)
    )


def long_diagonals() -> dict[str, float]:
    """The Delta robot with the long diagonals of its platform in place of the short ones."""
    model = mechanisms.delta()
    bars = {name: bar for name, bar in model.bars.items() if name not in SHORT}
    return {"rank": kinematics.mobility(model.with_(bars=bars | {f"{a}-{b}": Bar(ends=(a, b)) for a, b in LONG})).rank}


def path() -> Any:
    """Motion of the Delta robot whose platform passes P with V and A, in the middle of 41 samples; from another place."""
    t = np.linspace(0.0, 0.04, 41)
    places = (P - (0, 0, 0.05))[:, None] + np.outer(V, t - 0.02) + np.outer(A, (t - 0.02) ** 2 / 2)
    targets = Spline(times=tuple(t), values={f"Q.{axis}": tuple(row) for axis, row in zip("xyz", places, strict=True)})
    return kinematics.inverse(mechanisms.delta(at=(0.0, 0.0, -0.7)), targets, samples=41)


def driven() -> dict[str, Any]:
    """Angles of the arms where the platform stands in P, rad, their rates and second rates, and the torques, N m."""
    motion = path()
    now = motion.data.isel(time=20)
    model = mechanisms.delta(at=(0.0, 0.0, -0.7))
    forces = dynamics.inverse(model, motion)
    return {
        "angle": now.drive_position.values,
        "rate": now.drive_velocity.values,
        "second": now.drive_acceleration.values,
        "torque": forces.drive_force.isel(time=20).values,
    }


def held() -> Any:
    """Torques that hold the platform in P, N m."""
    model = mechanisms.delta(at=tuple(P))
    return dynamics.simulate(model, 0.001, samples=2).forces.drive_force.isel(time=0).values


def pushed() -> Any:
    """Acceleration of the platform in P at velocity V under the torques, m/s^2."""
    now = path().data.isel(time=20)
    model = mechanisms.delta(at=tuple(P))
    tasks = {f"arm{k + 1}": GivenForce(torque=torque) for k, torque in enumerate(TORQUE)}
    velocities = {name: tuple(now.velocity.sel(node=name).values) for name in model.nodes if name not in model.fixed}
    run = dynamics.simulate(model, 1e-4, samples=2, tasks=tasks, velocities=velocities)
    return run.motion.acceleration.sel(node=CORNERS).isel(time=0).mean("node").values


def fallen() -> Any:
    """Middle of the Delta robot's platform after 0.15 s without torques, m."""
    model = mechanisms.delta(at=tuple(P))
    tasks = dict.fromkeys(model.drives, Free())
    run = dynamics.simulate(model, 0.15, samples=2, tasks=tasks, method=DOP853(rtol=1e-12, atol=1e-14))
    return run.motion.position.sel(node=CORNERS).isel(time=-1).mean("node").values


def legs() -> dict[str, float]:
    """Leg lengths that the inverse finds for a pose, m; how far the forward way ends from it, m."""
    model = mechanisms.stewart()
    heads = [name for name in model.nodes if name.startswith("P")]
    pose = {"x": 0.05, "y": -0.04, "z": 0.08, "roll": 0.1, "pitch": -0.15, "yaw": 0.25}
    targets = Quintic(moves={key: (0.0, value) for key, value in pose.items()}, duration=1.0)
    end = kinematics.inverse(model, targets, platform=heads, samples=11).data.isel(time=-1)
    found = {f"leg{k}": float(end.drive_position.sel(drive=f"leg{k}")) for k in range(1, 7)}
    forward = kinematics.assemble(model, found)
    return found | {"off": float(np.abs(forward - end.position.values).max())}


def exact_legs() -> list[float]:
    """Of the same pose in closed form, m."""
    model = mechanisms.stewart()
    R = _turns(0.1, -0.15, 0.25)
    home = np.array([0.0, 0.0, 0.6])
    lengths = []
    for k in range(1, 7):
        foot, head = (np.array(model.nodes[end].at) for end in model.bars[f"leg{k}"].ends)
        lengths.append(float(np.linalg.norm(home + (0.05, -0.04, 0.08) + R @ (head - home) - foot)))
    return lengths


def _turns(roll: float, pitch: float, yaw: float) -> Any:
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a), math.sin(a)) for a in (roll, pitch, yaw))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def platforms(kind: str) -> dict[str, float]:
    """Freedoms of a platform before and after its drives."""
    found = kinematics.mobility(_platform(kind))
    return {"before": found.degrees_of_freedom, "after": found.undriven}


def _platform(kind: str) -> Model:
    if kind == "similar":
        return mechanisms.stewart(base_spread=math.pi / 3, platform_spread=math.pi / 3)
    built: Model = library.build("mechanisms.stewart", {"kind": kind})
    return built


def cases() -> Iterator[Case]:
    """Whole numbers; closed forms to 1e-12, the fall to 1e-10 m."""
    for name, numbers in (("delta", (45, 66, 18, 45, 3)), ("robot", (53, 63, 7, 51, 5))):
        for key, number in zip(COUNTS, numbers, strict=True):
            reference = PAPER if key in ("rank", "freedoms") else BUILT
            yield Case(f"{name}.{key}", reference, number, 0.0, counts, (name,), (key,), 1.0)
    source = Reference(
        "count", "six points on a conic, joined as in K(3,3): E. D. Bolker & B. Roth, Pacific J. Math. 90 (1980) 27-44"
    )
    yield Case("delta.rank_of_long_diagonals", source, 44, 0.0, long_diagonals, (), ("rank",), 1.0)
    for k, theta in enumerate(THETA):
        yield Case(f"delta.angle_{k + 1}", INVERSE, theta, 1e-12, driven, (), ("angle", k))
        yield Case(f"delta.rate_{k + 1}", INVERSE, RATE[k], 1e-11, driven, (), ("rate", k))
        yield Case(f"delta.acceleration_{k + 1}", INVERSE, SECOND[k], 1e-10, driven, (), ("second", k), 40.0)
        yield Case(f"delta.torque_{k + 1}", WORK, TORQUE[k], 1e-10, driven, (), ("torque", k), 7.0)
        yield Case(f"delta.static_torque_{k + 1}", WORK, STATIC[k], 1e-11, held, (), (k,))
        yield Case(f"delta.forward.{'xyz'[k]}", WORK, A[k], 1e-11, pushed, (), (k,), 12.0)
    for k, value in enumerate(FALLEN):
        yield Case(f"delta.fall.{'xyz'[k]}", FALL, value, 1e-10, fallen, (), (k,), 1.0)
    for k, length in enumerate(exact_legs(), start=1):
        yield Case(f"stewart.leg{k}", LEGS, length, 1e-12, legs, (), (f"leg{k}",))
    yield Case("stewart.forward_after_inverse", BACK, 0.0, 1e-12, legs, (), ("off",), 1.0)
    for kind, after in (("6-6", 0), ("6-3", 0), ("3-3", 0), ("similar", 3)):
        text = "six legs hold a body" if after == 0 else "all legs of similar hexagons face to face meet in one point"
        reference = Reference("count", text)
        yield Case(f"stewart.{kind}.before_drives", reference, 6, 0.0, platforms, (kind,), ("before",), 1.0)
        yield Case(f"stewart.{kind}.after_drives", reference, after, 0.0, platforms, (kind,), ("after",), 1.0)
