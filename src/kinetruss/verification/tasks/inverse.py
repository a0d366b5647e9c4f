"""Forward after inverse for every kind of task, the gimbal angles of three bays, and ranks of straight masts."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import kinetruss as kt

TOP = ("B3.N7", "B3.N9", "B3.N8")
BASE = ("B1.N1", "B1.N2", "B1.N3")
SOURCE, TARGET = np.array([1.0, 2.0, 12.0]), np.array([-3.0, 1.0, 11.0])


@cache
def _bent() -> kt.Model:
    """Three bays whose active members differ, so that nothing is symmetric."""
    straight = kt.library.vgt.double_octahedral(bays=3)
    a, b = (np.array(straight.nodes[name].at) for name in straight.active["B1.M7"].ends)
    lengths = {name: float(np.linalg.norm(b - a)) + 0.05 * np.sin(2.0 + 3.0 * k) for k, name in enumerate(straight.all_drives)}
    return _drawn(straight, kt.kinematics.assemble(straight, lengths))


def _drawn(model: kt.Model, x: Any) -> kt.Model:
    nodes = zip(model.nodes.items(), x.tolist(), strict=True)
    return model.with_(nodes={name: node.with_(at=tuple(at)) for (name, node), at in nodes})


def _done(task: Any) -> tuple[kt.Model, Any]:
    """The model before, and the place to which the drive lengths at the end lead by themselves."""
    model = _bent()
    motion = kt.kinematics.inverse(model, task, samples=11)
    lengths = dict(zip(model.all_drives, motion.data["drive_position"].values[-1].tolist(), strict=True))
    x = kt.kinematics.assemble(model, lengths)[None]
    return model, kt.kinematics.from_arrays(model, [0.0], x, 0 * x, 0 * x)


def _centre() -> Any:
    return np.mean([_bent().nodes[name].at for name in TOP], axis=0)


def gimbal() -> dict[str, float]:
    """Misses of the gimbal angles, rad."""
    task = kt.Gimbal(platform=TOP, base=BASE, moves={"beta": 0.2, "gamma": -0.1})
    found = kt.kinematics.platform(*_done(task), TOP, base=BASE)
    return {"beta": float(found["beta"].values[0]) - 0.2, "gamma": float(found["gamma"].values[0]) + 0.1}


def positioning() -> dict[str, float]:
    """Misses of the centroid, m."""
    wanted = np.add(_centre(), (0.05, -0.03, 0.02))
    task = kt.Positioning(nodes=TOP, moves=dict(zip("xyz", wanted.tolist(), strict=True)))
    found = kt.kinematics.platform(*_done(task), TOP)["centroid"].values[0]
    return dict(zip("xyz", (found - wanted).tolist(), strict=True))


def docking() -> dict[str, float]:
    """Misses of place (m) and Euler angles (rad) of a frame on the top, which is to be where other lengths have it."""
    model, names = _bent(), ("x", "y", "z", "roll", "pitch", "yaw")
    frame = kt.Frame(origin=tuple(np.add(_centre(), (0.0, 0.0, 0.3))))

    def read(lengths: Any) -> Any:
        x = kt.kinematics.assemble(model, dict(zip(model.all_drives, lengths.tolist(), strict=True)))[None]
        found = kt.kinematics.pose(model, kt.kinematics.from_arrays(model, [0.0], x, 0 * x, 0 * x), TOP, frame=frame)
        return np.r_[found["position"].values[0], found["euler"].values[0][::-1]]

    ends = [[np.array(model.nodes[end].at) for end in model.active[name].ends] for name in model.all_drives]
    wanted = read(np.array([np.linalg.norm(b - a) for a, b in ends]) + 0.03 * np.cos(np.arange(9.0) ** 2))
    task = kt.Docking(platform=TOP, frame=frame)
    found = kt.kinematics.reach(model, task, {name: [one] for name, one in zip(names, wanted.tolist(), strict=True)})
    return dict(zip(names, (read(found["drive_position"].values[0]) - wanted).tolist(), strict=True))


def reflecting() -> dict[str, float]:
    """What the mirrored ray misses the target by, m, and the place of the mirror, m."""
    wanted = np.add(_centre(), (0.02, 0.02, 0.0))
    moves = dict(zip("xyz", wanted.tolist(), strict=True))
    task = kt.Reflecting(platform=TOP, source=tuple(SOURCE), target=tuple(TARGET), moves=moves)
    found = kt.kinematics.platform(*_done(task), TOP)
    centre, normal = found["centroid"].values[0], found["normal"].values[0]
    ray = (centre - SOURCE) / np.linalg.norm(centre - SOURCE)
    ray = ray - 2 * (ray @ normal) * normal
    away = TARGET - centre
    return {"ray": float(np.linalg.norm(away - (away @ ray) * ray)), "place": float(np.abs(centre - wanted).max())}


def pointing() -> dict[str, float]:
    """Angle (rad) between the normal and the direction to the place that it points at."""
    found = kt.kinematics.platform(*_done(kt.Pointing(platform=TOP, at=tuple(SOURCE))), TOP)
    away = SOURCE - found["centroid"].values[0]
    return {
        "angle": float(np.arctan2(np.linalg.norm(np.cross(found["normal"].values[0], away)), found["normal"].values[0] @ away))
    }


def follower() -> dict[str, float]:
    """Largest difference of the actuator's length from the law of cosines, m, while the follower turns."""
    model = kt.library.vgt.triangular(base_length=1.0, tube_length=1.0)
    d = np.subtract(model.nodes["B"].at, model.nodes["O1"].at)
    start = float(np.arctan2(d[1], d[0]))
    motion = kt.kinematics.inverse(model, kt.Quintic(moves={"follower.angle": (start, 2.3)}, duration=1.0), samples=31)
    t = motion.data["time"].values
    angle = start + (2.3 - start) * t**3 * (10 - 15 * t + 6 * t**2)
    exact = np.sqrt(8.0 + 8.0 * np.cos(angle))
    return {"length": float(np.abs(motion.data["drive_position"].values[:, 0] - exact).max())}


def three_bays(division: str) -> dict[str, float]:
    """Gimbal angles (deg) of the tip and of the second bay for 30 and 30 degrees."""
    model = kt.library.vgt.double_octahedral(bays=3)
    task = kt.Gimbal.model_validate({"platform": TOP, "base": BASE, "moves": {"beta": "30 deg", "gamma": "30 deg"},
                                     "division": division})  # fmt: skip
    motion = kt.kinematics.inverse(model, task, samples=5)
    tip = kt.kinematics.platform(model, motion, TOP, base=BASE)
    bay = kt.kinematics.platform(model, motion, ("B2.N7", "B2.N9", "B2.N8"), base=("B1.N7", "B1.N9", "B1.N8"))
    found = {"tip": tip, "bay": bay}
    return {
        f"{what}_{name}": float(np.degrees(one[name].values[-1])) for what, one in found.items() for name in ("beta", "gamma")
    }


def straight(bays: int) -> dict[str, float]:
    """Rank that a refused docking of a straight mast names, and whether the direction that it lacks is yaw."""
    model = kt.library.vgt.double_octahedral(bays=bays)
    try:
        kt.kinematics.inverse(model, kt.Docking(platform=[f"B{bays}.N{k}" for k in (7, 9, 8)], moves={"yaw": 0.1}), samples=3)
    except kt.InputError as error:
        text = str(error)
        return {"rank": float(text.partition("(rank ")[2].partition(")")[0]), "yaw": float("cannot yaw" in text)}
    return {"rank": 6.0, "yaw": 0.0}
