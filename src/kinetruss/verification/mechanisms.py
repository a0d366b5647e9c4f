"""Mechanisms and robots: hinges and gears, joints by name, loops whose count misleads, assembly modes, Delta and hexapods."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model, stored
from kinetruss.verification.measures import Numbers, drift, off, unit

simulate, library = kt.dynamics.simulate, kt.library.mechanisms

FINE = kt.DOP853(rtol=1e-12, atol=1e-13)
AXIS, OTHER, PLACE = np.array([0.0, 0.6, 0.8]), np.array([1.0, 0.0, 0.0]), np.array([1.1, 0.2, 0.1])
FLAT = AXIS[1:]
JOINTS: dict[str, tuple[int, str, dict[str, Any]]] = {
    "spherical": (3, "spherical", {}),
    "revolute": (3, "revolute", {"axis": AXIS}),
    "universal": (3, "universal", {"axes": (AXIS, OTHER)}),
    "prismatic": (3, "prismatic", {"axis": AXIS}),
    "cylindrical": (3, "cylindrical", {"axis": AXIS}),
    "planar": (3, "planar", {"axis": AXIS}),
    "weld": (3, "weld", {}),
    "plane.pin": (2, "pin", {}),
    "plane.weld": (2, "weld", {}),
    "plane.prismatic": (2, "prismatic", {"axis": FLAT}),
    "plane.parallelogram": (2, "parallelogram", {"axis": FLAT}),
    "plane.double_parallelogram": (2, "parallelogram", {"axis": FLAT, "double": True}),
}
"""Dimension, function, arguments."""
BENNETT: dict[str, dict[str, Any]] = {
    "default": {"twist": 0.7, "other_twist": 1.3, "angle": 1.0},
    "slender": {"twist": 0.3, "other_twist": 1.5, "angle": 2.0},
    "wide": {"twist": 0.5, "other_twist": 2.5, "angle": 0.3},
}


def hinge() -> Numbers:
    """A mass on a hinge about z: the torque of a given motion over more than a full turn, against m r^2 q'' + m g r sin q."""
    mass, path = model("hinged_mass"), kt.Quintic(moves={"turn": (math.pi / 2, math.pi / 2 + 7)}, duration=1.0)
    motion = kt.kinematics.follow(mass, path, samples=101)
    exact = 2.0 * motion.drive_acceleration + 2.0 * 9.81 * np.sin(motion.drive_position)
    return {"hinge": off(kt.dynamics.inverse(mass, motion).drive_force.values, exact.values)}


def screw() -> Numbers:
    """A nut falls on a thread for 3 s: height and turns."""
    end = simulate(model("nut"), 3.0, samples=4, method=FINE).motion.position[-1]
    rim = end.sel(node="D")
    return {"fall": end.sel(node="C", axis="z") - 1.0, "rim.x": rim[0], "rim.y": rim[1]}


def gears() -> Numbers:
    """Two arms geared 2 : 1 under a torque on the faster one: its angle after 3 s."""
    run = simulate(model("geared_arms"), 3.0, samples=61, tasks={"motor": kt.GivenForce(torque=4.0)}, method=FINE)
    return {"turned": run.motion.drive_position[-1, 0]}


def slider() -> Numbers:
    """Two masses on a rod that turns steadily: how far their centre is after 0.8 s, and the torque on the rod."""
    path = kt.ConstantRate(rates={"motor": 3.0}, duration=0.8)
    run = simulate(model("beads"), 0.8, samples=5, trajectory=path, method=FINE)
    C, D = run.motion.position[-1].sel(node=["C", "D"]).values
    return {"away": np.linalg.norm((2.0 * C + D) / 3.0), "torque": run.forces.drive_force[-1, 0]}


def _pair(name: str) -> kt.Model:
    """Two free bodies with the joint between them."""
    dim, function, given = JOINTS[name]
    corners = np.vstack([np.zeros(dim), np.eye(dim)])
    places = {"A": corners, "B": np.array([1.2, 0.3, 0.1])[:dim] + 0.8 * corners}
    bodies = kt.Model(
        nodes={f"{body}{k}": tuple(at) for body, table in places.items() for k, at in enumerate(table)},
        bodies={body: kt.Body(nodes=[f"{body}{k}" for k in range(dim + 1)], mass=m) for body, m in (("A", 1.5), ("B", 2.0))},
    )
    made: kt.Model = getattr(kt.library.joints, function)(bodies, "joint", bodies=("A", "B"), at=PLACE[:dim], **given)
    return made


def freedoms(name: str) -> Numbers:
    """Relative degrees of freedom by rank, and number of redundant bars."""
    pair = _pair(name)
    found = kt.kinematics.mobility(pair)
    return {"freedoms": found.degrees_of_freedom - (3 if pair.dim == 2 else 6), "redundant": found.self_stress}


def motion(name: str) -> Numbers:
    """Largest deviation from the classical joint, m and rad, while the bodies move."""
    pair = _pair(name)
    found = kt.kinematics.mobility(pair)
    basis = np.linalg.qr(found.mechanisms.reshape(len(found.mechanisms), -1).T)[0]
    speed = (basis @ np.cos(1.0 + np.arange(basis.shape[1]))).reshape(found.mechanisms.shape[1:])
    moving = {node: tuple(v) for node, v in zip(found.node_names, speed, strict=True) if v.any()}
    run = simulate(pair.with_(velocities=moving), 0.3, samples=4)
    (R, d), (S, e) = (_moved(run.motion.position, pair, body) for body in "AB")
    place = PLACE[: pair.dim]
    way = S @ place + e - R @ place - d
    kept = _kept(name.removeprefix("plane."), pair, np.swapaxes(R, 1, 2) @ S, np.einsum("tji,tj->ti", R, way))
    return {"deviation": max(np.abs(part).max() for part in kept)}


def _moved(position: Any, pair: kt.Model, body: str) -> tuple[Any, Any]:
    """Rotation and displacement of a body, x = R x0 + d."""
    names = [f"{body}{k}" for k in range(pair.dim + 1)]
    start, x = np.array([pair.nodes[name].at for name in names]), position.sel(node=names).values
    R = np.swapaxes(x[:, 1:] - x[:, :1], 1, 2) @ np.linalg.inv((start[1:] - start[0]).T)
    return R, x[:, 0] - R @ start[0]


def _kept(kind: str, pair: kt.Model, Q: Any, p: Any) -> list[Any]:
    """What the classical joint keeps at 0: Q turns the second body in the first, p moves its point at the joint there."""
    u, v = AXIS[-pair.dim :], OTHER[: pair.dim]
    turned, aside = Q - np.eye(pair.dim), p - (p @ u)[:, None] * u
    if kind == "parallelogram":
        link = np.subtract(pair.nodes["joint.3"].at, pair.nodes["joint.1"].at)
        return [turned, np.linalg.norm(p + link, axis=1) - np.linalg.norm(link)]
    return {
        "spherical": [p],
        "pin": [p],
        "revolute": [p, turned @ u],
        "weld": [p, turned],
        "universal": [p, (Q @ v) @ u],
        "prismatic": [turned, aside],
        "cylindrical": [turned @ u, aside],
        "planar": [turned @ u, p @ u],
        "double_parallelogram": [turned],
    }[kind]


def fall(name: str) -> Numbers:
    """How far a body on the ground has slid down a steep axis, or in an upright plane, after 0.2 s, m."""
    axis = {"prismatic": (0.6, 0.0, 0.8), "cylindrical": (0.0, 0.0, 1.0), "planar": (0.0, 1.0, 0.0)}[name]
    names = [f"B{k}" for k in range(4)]
    corners = np.array([1.2, 0.3, 0.1]) + 0.8 * np.vstack([np.zeros(3), np.eye(3)])
    free = kt.Model(
        nodes={node: tuple(at) for node, at in zip(names, corners, strict=True)},
        bodies={"B": kt.Body(nodes=names, mass=2.0)},
        gravity=(0.0, 0.0, -9.81),
    )
    hung = getattr(kt.library.joints, name)(free, "joint", bodies=("ground", "B"), at=PLACE, axis=axis)
    z = simulate(hung, 0.2, samples=2).motion.position.sel(node=names, axis="z").mean("node")
    return {"z": z[1] - z[0]}


def counts(name: str) -> Numbers:
    """Bars, coordinates, fixed ones, count of bars less freedoms, and what the rank says, no drive held."""
    free = getattr(library, name)().with_(drives={}, runs={})
    found = kt.kinematics.mobility(free)
    of_rank = {
        "rank": found.rank,
        "freedoms": found.degrees_of_freedom,
        "mechanisms": found.undriven,
        "self_stress": found.self_stress,
    }
    return of_rank | {"bars": len(free.bars), "coordinates": found.coordinates, "fixed": found.fixed, "count": found.maxwell}


def line(name: str) -> Numbers:
    """Largest and smallest x of P along its run, m."""
    linkage = getattr(library, name)()
    x = kt.kinematics.follow(linkage, linkage.runs["swing"].trajectory, samples=101).position.sel(node="P", axis="x")
    return {"most": x.max(), "least": x.min()}


def straight() -> Numbers:
    """Largest way of the Sarrus linkage's platform off its line, and turn, m."""
    linkage = library.sarrus()
    x = kt.kinematics.follow(linkage, linkage.runs["lift"].trajectory, samples=51).position.sel(node=["G", "H", "K"]).values
    return {"off": np.abs((x - x[0])[..., [0, 2]]).max() + np.ptp((x - x[0])[..., 1], axis=1).max()}


def energy(name: str) -> Numbers:
    """Change of energy of a loop released for 0.3 s, of the largest kinetic one."""
    return {"energy": drift(simulate(getattr(library, name)(), 0.3, samples=31))}


def hinge_angles(loop: kt.Model, position: Any) -> Any:
    """Angles (samples, hinges) of a loop `P1`, `A1`, `P2` ..., rad, measured at the links."""
    P, A = (position.sel(node=[name for name in loop.nodes if name[0] == kind]).values for kind in "PA")
    axis, came, goes = unit(A - P), P - np.roll(P, 1, axis=1), np.roll(P, -1, axis=1) - P
    return np.arctan2((axis * np.cross(came, goes)).sum(axis=2), (came * goes).sum(axis=2))


def bennett_turn() -> Numbers:
    """tan(t1/2) tan(t2/2) after 0.2 s, from hinge angles measured at the links."""
    loop = library.bennett()
    angles = hinge_angles(loop, simulate(loop, 0.2, samples=2).motion.position)[-1]
    return {"turn": math.tan(angles[0] / 2) * math.tan(angles[1] / 2)}


def _let_go(name: str, time: float) -> tuple[kt.Model, kt.results.Simulation]:
    """One of `BENNETT`, or the orthogonal loop of six."""
    loop = library.bricard() if name == "bricard" else library.bennett(**BENNETT[name])
    return loop, simulate(loop, time, samples=301, method=kt.DOP853(rtol=1e-11, atol=1e-12))


def history(name: str, time: float) -> Numbers:
    """Change of the energy of the largest kinetic one, and the residual of the closed form of the angles."""
    loop, run = _let_go(name, time)
    t = hinge_angles(loop, run.motion.position)
    if name == "bricard":
        c, d = np.cos(t), np.roll(np.cos(t), 1, axis=1)
        left = c + d + c * d
    else:
        (one, two, *_), twist, other = t.T / 2, BENNETT[name]["twist"], BENNETT[name]["other_twist"]
        down, up = math.sin((other - twist) / 2), math.sin((other + twist) / 2)
        left = down * np.sin(one) * np.sin(two) - up * np.cos(one) * np.cos(two)
    return {"energy": drift(run), "closure": np.abs(left).max()}


def against_one_freedom(name: str) -> Numbers:
    """Largest distance of P2, A2, P3, A3 after 3 s from where the equation of the one freedom has them, m."""
    end = _let_go(name, 3.0)[1].motion.position[-1].sel(node=["P2", "A2", "P3", "A3"]).values
    return {"one_freedom": np.abs(end - stored("mechanisms")["exact"]["bennett"][name]).max()}


def modes(kind: Any) -> Numbers:
    """Complex solutions of one block, and paths whose end is not known."""
    platform = model(kind) if kind == "3-RPR" else library.stewart(kind=kind, turned=(0.1, 0.2, 0.1))
    found = kt.kinematics.assembly_modes(platform).attrs
    return {"complex": found["complex_solutions"][0], "lost": found["lost"]}


P, V, A = np.array([0.05, -0.08, -0.75]), np.array([1.2, -0.7, 0.5]), np.array([8.0, -5.0, 12.0])
"""Place (m), velocity and acceleration of the Delta robot's platform."""
TORQUE = (-7.024949349790452, -0.35332027885705214, -4.538558518535321)
CORNERS = [f"P{k}{side}" for k in (1, 2, 3) for side in "ab"]
PLATFORM = tuple(f"P{k}" for k in range(1, 7))


def long_diagonals() -> Numbers:
    """The Delta robot with the long diagonals of its platform in place of the short ones."""
    robot = library.delta()
    bars = {name: bar for name, bar in robot.bars.items() if name not in ("P1a-P2a", "P2a-P3a", "P3a-P1a")}
    long = {f"{a}-{b}": kt.Bar(ends=(a, b)) for a, b in (("P1a", "P2b"), ("P1b", "P3a"), ("P2a", "P3b"))}
    return {"rank": kt.kinematics.mobility(robot.with_(bars=bars | long)).rank}


def _path() -> tuple[kt.Model, kt.results.Motion]:
    """Motion of the Delta robot whose platform passes P with V and A, in the middle of 41 samples; from another place."""
    t, robot = np.linspace(0.0, 0.04, 41), library.delta(at=(0.0, 0.0, -0.7))
    places = (P - (0, 0, 0.05))[:, None] + np.outer(V, t - 0.02) + np.outer(A, (t - 0.02) ** 2 / 2)
    targets = kt.Spline(times=tuple(t), values={f"Q.{axis}": tuple(row) for axis, row in zip("xyz", places, strict=True)})
    return robot, kt.kinematics.inverse(robot, targets, samples=41)


def driven() -> Numbers:
    """Angles of the arms where the platform stands in P, rad, their rates and second rates, and the torques, N m."""
    robot, motion = _path()
    torque = kt.dynamics.inverse(robot, motion).drive_force
    values = (motion.drive_position, motion.drive_velocity, motion.drive_acceleration, torque)
    rows = zip(("angle", "rate", "acceleration", "torque"), values, strict=True)
    return {f"{name}_{k + 1}": row[20, k] for name, row in rows for k in range(3)}


def held() -> Numbers:
    """Torques that hold the platform in P, N m."""
    torques = simulate(library.delta(at=tuple(P)), 0.001, samples=2).forces.drive_force[0]
    return {f"static_torque_{k}": value for k, value in enumerate(torques, start=1)}


def pushed() -> Numbers:
    """Acceleration of the platform in P at velocity V under the torques, m/s^2."""
    now, robot = _path()[1].velocity[20], library.delta(at=tuple(P))
    tasks = {f"arm{k}": kt.GivenForce(torque=torque) for k, torque in enumerate(TORQUE, start=1)}
    velocities = {name: tuple(now.sel(node=name).values) for name in robot.nodes if name not in robot.fixed}
    run = simulate(robot, 1e-4, samples=2, tasks=tasks, velocities=velocities)
    return {"": run.motion.acceleration[0].sel(node=CORNERS).mean("node")}


def fallen() -> Numbers:
    """Middle of the Delta robot's platform after 0.15 s without torques, m."""
    robot = library.delta(at=tuple(P))
    tasks = dict.fromkeys(robot.drives, kt.Free())
    run = simulate(robot, 0.15, samples=2, tasks=tasks, method=kt.DOP853(rtol=1e-12, atol=1e-14))
    return {"": run.motion.position[-1].sel(node=CORNERS).mean("node")}


def legs() -> Numbers:
    """Leg lengths of the inverse kinematics for a pose, m; distance of the forward kinematics from it, m."""
    platform, pose = library.stewart(), {"x": 0.05, "y": -0.04, "z": 0.08, "roll": 0.1, "pitch": -0.15, "yaw": 0.25}
    targets = kt.Quintic(moves={key: (0.0, value) for key, value in pose.items()}, duration=1.0)
    motion = kt.kinematics.inverse(platform, targets, platform=list(PLATFORM), samples=11)
    lengths = dict(zip(platform.all_drives, motion.drive_position.values[-1].tolist(), strict=True))
    return lengths | {"off": np.abs(kt.kinematics.assemble(platform, lengths) - motion.position.values[-1]).max()}


def jacobian() -> Numbers:
    """Largest difference of the inverse Jacobian's entries of a Stewart-Gough platform from the closed form."""
    platform = library.stewart(turned=(0.1, -0.2, 0.3), at=(0.05, -0.02, 0.62))
    found = kt.kinematics.platform_jacobian(platform, PLATFORM)
    middle = np.mean([platform.nodes[name].at for name in PLATFORM], axis=0)
    ends = np.array([[platform.nodes[end].at for end in platform.bars[str(name)].ends] for name in found["drive"].values])
    along = unit(ends[:, 1] - ends[:, 0])
    return {"inverse": np.abs(found["inverse"].values - np.hstack([along, np.cross(ends[:, 1] - middle, along)])).max()}


def platforms(kind: str) -> Numbers:
    """Freedoms of a platform before and after its drives."""
    spread = {"base_spread": math.pi / 3, "platform_spread": math.pi / 3}
    platform = kt.library.build("mechanisms.stewart", spread if kind == "similar" else {"kind": kind})
    found = kt.kinematics.mobility(platform)
    return {"before_drives": found.degrees_of_freedom, "after_drives": found.undriven}


def conventional(name: str) -> Numbers:
    """Largest differences of a robot or mechanism of beams with rotations from that of bars, along one motion of the drives,
    relative to the largest value; its coordinates with rotations of three, and with four Euler parameters.
    """
    bars, beams = (kt.library.build(f"mechanisms.{name}", {"form": form}) for form in ("bars", "conventional"))
    start = kt.kinematics.mobility(beams)
    turning = sum(frame not in beams.clamped for frame in beams.whole.inner.frames)
    if name == "andrews":
        begin = beams.nodes["beta"].at[0]
        path: Any = kt.Quintic(moves={"motor": (begin, begin + 7.0)}, duration=0.03)
    else:
        path = bars.runs["move"].trajectory
    both = [kt.kinematics.follow(model, path, samples=101) for model in (bars, beams)]
    common = [node for node in bars.nodes if node in beams.nodes]
    one, other = (motion.data.sel(node=common) for motion in both)
    forces = [kt.dynamics.inverse(*pair, static=False).drive_force.values for pair in zip((bars, beams), both, strict=True)]
    found: Numbers = {key: off(other[key].values, one[key].values) for key in ("position", "velocity", "acceleration")}
    return found | {
        "drive_force": off(forces[1], forces[0]),
        "coordinates": start.coordinates,
        "euler_parameters": start.coordinates + turning,
        "fixed": start.fixed,
        "freedoms": start.degrees_of_freedom,
    }


def five_freedoms() -> Numbers:
    """Lift, swing, shoulder, reach, wrist at four instants under given forces, and their rates."""
    robot, times = library.robot(rates=(-0.3, 0.8, 0.5, 0.2, -1.0)), (0.2, 0.4, 0.6, 0.8)
    names, tasks = list(robot.nodes), dict.fromkeys(robot.all_drives, kt.Free())

    def push(t: float, x: Any, _: Any) -> dict[str, Any]:
        return _given_forces(t, dict(zip(names, x, strict=True)))

    fine = kt.DOP853(rtol=1e-11, atol=1e-12)
    motion = simulate(robot, 0.8, times=(0.0, *times), tasks=tasks, user_force=push, method=fine).motion
    found: Numbers = {f"{t}s": motion.drive_position.sel(time=t) for t in times}
    return found | {f"0.8s.{name}_rate": motion.drive_velocity[-1].sel(drive=name) for name in robot.all_drives}


def _given_forces(t: float, at: dict[str, Any]) -> dict[str, Any]:
    """Forces of the drives on the nodes, N: along the lift and the reach, and as couples at the three hinges."""
    force = {name: np.zeros(3) for name in "ABGXEJU"}
    force["B"] += (0.0, 0.0, 3550 + 200 * math.sin(4 * t))
    swing, shoulder, wrist = 60 * math.cos(3 * t), -60 + 60 * math.sin(6 * t), 78 + 15 * math.cos(5 * t)
    upper, lower = shoulder * unit(at["C"] - at["B"]), wrist * unit(at["H"] - at["G"])
    pulls = [("G", "B", (-80 + 60 * t) * unit(at["G"] - at["B"]))]
    couples = (
        ("X", "B", np.array([0.0, 0.0, swing])),
        ("E", "B", upper),
        ("X", "B", -upper),
        ("U", "G", lower),
        ("J", "G", -lower),
    )
    for node, foot, moment in couples:
        # across an arm, as two forces at its ends
        arm = at[node] - at[foot]
        pulls.append((node, foot, np.cross(moment, arm) / (arm @ arm)))
    for node, foot, pull in pulls:
        force[node] += pull
        force[foot] -= pull
    return force
