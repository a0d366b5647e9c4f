"""Kinematics: tasks forward after inverse, limits, workspaces, gimbal poses, rates, first-order prediction."""

from __future__ import annotations

from functools import cache
from itertools import product
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model
from kinetruss.verification.measures import Numbers, at_times, standing, unit
from kinetruss.verification.thesis_bay import BASE, TILT, double_octahedral
from kinetruss.verification.thesis_triangle import triangular

kinematics = kt.kinematics

TOP, FOOT = ("B3.N7", "B3.N9", "B3.N8"), ("B1.N1", "B1.N2", "B1.N3")
SOURCE, TARGET = np.array([1.0, 2.0, 12.0]), np.array([-3.0, 1.0, 11.0])
LONGERON = 0.889  # m
STEPS = (4e-3, 2e-3, 1e-3)
"""m or rad; small enough for the square to rule, large enough for round-off not to."""


@cache
def _bent() -> tuple[kt.Model, Any]:
    """Three bays whose active members differ, so that nothing is symmetric; centroid of the top."""
    straight = double_octahedral(bays=3)
    lengths = {name: 1.1684 + 0.05 * np.sin(2.0 + 3.0 * k) for k, name in enumerate(straight.all_drives)}
    places = dict(zip(straight.nodes, kinematics.assemble(straight, lengths).tolist(), strict=True))
    bent = straight.with_(nodes={name: node.with_(at=tuple(places[name])) for name, node in straight.nodes.items()})
    return bent, np.mean([places[name] for name in TOP], axis=0)


def _driven(lengths: Any) -> kt.results.Motion:
    """The place to which drive lengths lead by themselves."""
    bent, _ = _bent()
    return standing(bent, kinematics.assemble(bent, dict(zip(bent.all_drives, lengths.tolist(), strict=True))))


def _top(task: Any, base: Any = None) -> Any:
    """Plane of the top at the end of a task, from the drive lengths alone."""
    lengths = kinematics.inverse(_bent()[0], task, samples=11).drive_position.values[-1]
    return kinematics.platform(_bent()[0], _driven(lengths), TOP, base=base).isel(time=0)


def gimbal() -> Numbers:
    """Misses of the gimbal angles, rad."""
    found = _top(kt.Gimbal(platform=TOP, base=FOOT, moves={"beta": 0.2, "gamma": -0.1}), FOOT)
    return {"beta": found["beta"] - 0.2, "gamma": found["gamma"] + 0.1}


def positioning() -> Numbers:
    """Misses of the centroid, m."""
    wanted = _bent()[1] + (0.05, -0.03, 0.02)
    found = _top(kt.Positioning(nodes=TOP, moves=dict(zip("xyz", wanted.tolist(), strict=True))))
    return {"": found["centroid"].values - wanted}


def docking() -> Numbers:
    """Misses of place (m) and Euler angles (rad) of a frame on the top, which is to be where other lengths have it."""
    (bent, centre), names = _bent(), ("x", "y", "z", "roll", "pitch", "yaw")
    frame = kt.Frame(origin=tuple(np.add(centre, (0.0, 0.0, 0.3))))

    def read(lengths: Any) -> Any:
        found = kinematics.pose(bent, _driven(lengths), TOP, frame=frame).isel(time=0)
        return np.r_[found["position"].values, found["euler"].values[::-1]]

    ends = np.array([[bent.nodes[end].at for end in bent.active[name].ends] for name in bent.all_drives])
    wanted = read(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) + 0.03 * np.cos(np.arange(9.0) ** 2))
    values = {name: [one] for name, one in zip(names, wanted.tolist(), strict=True)}
    found = kinematics.reach(bent, kt.Docking(platform=TOP, frame=frame), values)
    return dict(zip(names, read(found["drive_position"].values[0]) - wanted, strict=True))


def reflecting() -> Numbers:
    """What the mirrored ray misses the target by, m, and the place of the mirror, m."""
    wanted = _bent()[1] + (0.02, 0.02, 0.0)
    moves = dict(zip("xyz", wanted.tolist(), strict=True))
    found = _top(kt.Reflecting(platform=TOP, source=tuple(SOURCE), target=tuple(TARGET), moves=moves))
    centre, normal = found["centroid"].values, found["normal"].values
    ray, away = unit(centre - SOURCE), TARGET - centre
    ray = ray - 2 * (ray @ normal) * normal
    return {"ray": np.linalg.norm(away - (away @ ray) * ray), "place": np.abs(centre - wanted).max()}


def pointing() -> Numbers:
    """Angle (rad) between the normal and the direction to the place that it points at."""
    found = _top(kt.Pointing(platform=TOP, at=tuple(SOURCE)))
    normal, away = found["normal"].values, SOURCE - found["centroid"].values
    return {"angle": np.arctan2(np.linalg.norm(np.cross(normal, away)), normal @ away)}


def follower() -> Numbers:
    """Largest difference of the actuator's length from the law of cosines, m, while the follower turns."""
    truss = triangular(base_length=1.0, tube_length=1.0)
    d = np.subtract(truss.nodes["B"].at, truss.nodes["O1"].at)
    start = float(np.arctan2(d[1], d[0]))
    motion = kinematics.inverse(truss, kt.Quintic(moves={"follower.angle": (start, 2.3)}, duration=1.0), samples=31)
    t = motion.time.values
    angle = start + (2.3 - start) * t**3 * (10 - 15 * t + 6 * t**2)
    return {"length": np.abs(motion.drive_position.values[:, 0] - np.sqrt(8.0 + 8.0 * np.cos(angle))).max()}


def three_bays(division: Any) -> Numbers:
    """Gimbal angles (deg) of the tip and of the second bay for 30 and 30 degrees."""
    bays, angle = double_octahedral(bays=3), np.radians(30.0)
    moves = {"beta": angle, "gamma": angle}
    motion = kinematics.inverse(bays, kt.Gimbal(platform=TOP, base=FOOT, moves=moves, division=division), samples=5)
    second = [[f"B{k}.N{n}" for n in (7, 9, 8)] for k in (2, 1)]
    planes = {"tip": (TOP, FOOT), "bay": second}
    found = {name: kinematics.platform(bays, motion, top, base=foot).isel(time=-1) for name, (top, foot) in planes.items()}
    return {f"{name}_{angle}": np.degrees(one[angle]) for name, one in found.items() for angle in ("beta", "gamma")}


def straight(bays: int) -> Numbers:
    """Rank that a refused docking of a straight mast names, and whether the direction that it lacks is yaw."""
    task = kt.Docking(platform=[f"B{bays}.N{k}" for k in (7, 9, 8)], moves={"yaw": 0.1})
    try:
        kinematics.inverse(double_octahedral(bays=bays), task, samples=3)
    except kt.InputError as error:
        return {"rank": str(error).partition("(rank ")[2].partition(")")[0], "yaw": "cannot yaw" in str(error)}
    return {"rank": 6.0, "yaw": 0.0}


def shared_rate() -> Numbers:
    """Two slides in a row with largest rates 0.3 and 0.6 m/s take their end 1 m on in 2 s: the least common excess."""
    task = kt.Coordinates(moves={"C.x": 3.0}, duration=2.0, rate={"a": 0.3, "b": 0.6})
    return {"ratio": kinematics.inverse(model("slides_in_a_row"), task).attrs["worst_ratio"]}


def nearest_corner() -> Numbers:
    """The place on two actuators with strokes that is nearest to one out of reach, between two corners of the region."""
    found = kinematics.reach(model("jib"), kt.Positioning(node="C", moves={"x": 0.05, "y": -0.2}))
    return {"": found.position.sel(node="C")[0].values}


def arm_map() -> Numbers:
    """The map of an arm of two bars, 0.4 m and 0.3 m: its border, and the least singular value at three radii."""
    radii = ("x", np.array([0.08, 0.12, 0.3, 0.5, 0.69, 0.71]))
    line = kinematics.workspace(model("serial_arm"), "T", radii, ("y", [0.0, 0.02])).isel(y=0)
    values = {f"serial_{round(1000 * r)}": line.serial.sel(x=r) for r in (0.12, 0.3, 0.5)}
    return values | {"reached": line.reachable.sum(), "beyond": line.reachable.sel(x=0.71)}


def gimbal_of_cell(bays: int) -> Numbers:
    """Largest difference between the wanted pose of a grid over the workspace, and that of the nodes which the solver finds."""
    cells, corners = kt.library.cells, (("N1", "N2", "N3"), ("N7", "N9", "N8"))
    cell = (cells.double_octahedron if bays == 1 else cells.quadruple_octahedron)(base_length=0.2, tube_length=0.1)
    stacked = cells.stack([cell])
    names = [
        [name if bays == 1 else f"{half}.{name}" for name in side] for half, side in zip(("H1", "H2"), corners, strict=True)
    ]
    angles, worst = np.radians([-40.0, -20.0, 0.0, 20.0, 40.0]), np.zeros(3)
    for beta, gamma, height in product(angles, angles, (0.55, 0.75, 0.9)):  # all angles are reachable at all heights of a bay
        wanted = np.array([beta, gamma, bays * height])
        lengths = kinematics.chain_lengths(BASE, LONGERON, beta, gamma, bays * height, bays)
        x = kinematics.assemble(stacked, dict(zip(stacked.active, lengths.tolist(), strict=True)))
        found = kinematics.platform(stacked, standing(stacked, x), names[1], base=names[0]).isel(time=0)
        for pose in ([found.beta, found.gamma, found.height], kinematics.chain_pose(BASE, LONGERON, lengths)):
            worst = np.maximum(worst, np.abs(np.array(pose) - wanted))
    return dict(zip(("beta", "gamma", "height"), worst, strict=True))


def shares(beta: float, gamma: float, bays: int) -> Numbers:
    """Angles of each of equal bays (degrees) that give these angles of the top, from its lengths."""
    lengths = kinematics.chain_lengths(BASE, LONGERON, np.radians(beta), np.radians(gamma), bays * 1.1, bays)
    one, other, _ = kinematics.gimbal_pose(BASE, LONGERON, lengths[:3])
    return {"beta": np.degrees(one), "gamma": np.degrees(other)}


def count(name: str) -> Numbers:
    """Nodes, members, freedoms besides those of a rigid body, and states of self-stress of a free cell, drives held."""
    cell = getattr(kt.library.cells, name)()
    found = kinematics.mobility(kt.library.cells.stack([cell], fixed=()))
    internal = found.undriven - (6 if found.system.dim == 3 else 3)
    return {"nodes": len(cell.nodes), "members": len(cell.members), "freedoms": internal, "self_stress": found.self_stress}


def tilted(angle: str) -> Numbers:
    """Top plane of a bay whose beta or gamma goes from -10 to 10 degrees in 1 s."""
    bay, times = double_octahedral(), (0.25, 0.5, 0.8)
    motion = kinematics.follow(bay, kt.Quintic(moves={f"bay.{angle}": (-TILT, TILT)}, duration=1.0), times=times)
    found = kinematics.platform(bay, motion, ("N7", "N9", "N8"), base=("N1", "N2", "N3"))
    return at_times(times, {str(name): values.values for name, values in found.items()})


def slope(case: str) -> Numbers:
    """Order of the error of the first-order prediction: slope of its logarithm over the step's."""
    truss, drives = {
        "triangle": (triangular(), {"actuator": 1.0}),
        "chain": (double_octahedral(3, beta=0.1, gamma=0.05), {"B1.M7": 1.0, "B2.M9": -0.5, "B3.M11": 0.7}),
        "bay": (double_octahedral(beta=0.1), {"M7": 1.0, "M9": -0.4, "M11": 0.2}),
        "bay_in_pose": (double_octahedral(beta=0.1), {"bay.beta": 1.0, "bay.gamma": -0.5}),
    }[case]
    errors = []
    for step in STEPS:
        if case == "bay_in_pose":
            move: Any = kt.library.vgt.slew(beta=(0.1, 0.1 + step), gamma=(0.0, -0.5 * step))
        else:
            move = kt.ConstantRate(rates={name: step * rate for name, rate in drives.items()}, duration=1.0)
        coordinates = list(drives) if case == "bay_in_pose" else None
        found = kinematics.first_order(truss, kinematics.follow(truss, move, times=[0.0, 1.0]), coordinates)
        errors.append(found["largest_error"].values[-1])
    return {"slope": np.polyfit(np.log(STEPS), np.log(errors), 1)[0]}
