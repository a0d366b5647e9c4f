"""Bodies carried by nodes: masses in closed form, free and heavy tops, loads; whatever nodes carry them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

bodies = kt.library.bodies

TIGHT = kt.DOP853(rtol=1e-12, atol=1e-12)

SIZE, MASS = (1.0, 0.6, 0.3), 2.0
SPIN = (0.4, 0.0, 3.0)
"""rad/s about the axes of least, middle and largest moment of the box, so that it starts where the middle one is 0."""
ALTERNATE = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / 2


def worth() -> dict[str, float]:
    """Bars and lumped masses of a tetrahedron, and of a cuboid from its corner and from alternate corners; mass 1 kg."""
    points = np.array([[0.3, 0.1, 0.0], [1.2, 0.0, 0.4], [0.0, 0.9, 0.1], [0.2, 0.3, 1.1]])
    solid = bodies.tetrahedron_properties(points, mass=1.0)
    corner = np.array([[0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4]])
    found: dict[str, float] = {}
    for name, at, shape in (
        ("tetrahedron", points, solid),
        ("cuboid", corner, bodies.box_properties((2, 3, 4), mass=1.0, at=(1, 1.5, 2))),
        ("alternate", ALTERNATE * (2, 3, 4), bodies.box_properties((2, 3, 4), mass=1.0)),
    ):
        made = bodies.bar_masses(at, shape.mass, shape.center, shape.inertia)
        found |= {f"{name}.bar.{i}{j}": value for (i, j), value in made.bars.items()}
        found |= {f"{name}.lump.{i}": value for i, value in enumerate(made.lumped)}
    return found


CORNER = ((0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.0, 0.8, 0.0), (0.0, 0.0, 1.25))
GENERAL: dict[str, Any] = {
    "mass": 3.0,
    "center": (0.2, -0.1, 0.4),
    "inertia": ((0.5, 0.03, -0.02), (0.03, 0.6, 0.01), (-0.02, 0.01, 0.7)),
}


def entries() -> dict[str, float]:
    """m_ij of a general body on a right-angled corner."""
    names = tuple("OXYZ")
    body = kt.Body(nodes=names, **GENERAL)
    m, _ = kt.model.body_mass(kt.Model(nodes=dict(zip(names, CORNER, strict=True)), bodies={"b": body}), body)
    return {f"{i}{j}": m[i, j] for i in range(4) for j in range(i, 4)}


def twist(seed: int) -> dict[str, float]:
    """Kinetic energy and momenta that the nodes of a random body in a random twist have."""
    model, shape, v, w = random_body(seed)
    names = list(model.bodies["b"].nodes)
    arms = np.array([model.nodes[name].at for name in names]) - shape.center
    velocity = v + np.cross(w, arms)
    p = _mass_times(model, names, velocity)
    return {"T": 0.5 * np.sum(p * velocity), "p": p.sum(axis=0)[0], "L": np.cross(arms, p).sum(axis=0)[2]}


def random_body(seed: int) -> tuple[kt.Model, Any, Any, Any]:
    """A body, its properties, the velocity of its centre, m/s, and its angular velocity, rad/s."""
    rng = np.random.default_rng(seed)
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    size, mass = rng.uniform(0.3, 1.5, 3).tolist(), float(rng.uniform(1, 3))
    shape = bodies.box_properties(size, mass=mass, at=rng.normal(size=3), axes=axes)
    points = ALTERNATE + rng.uniform(-0.2, 0.2, (4, 3)) + shape.center
    model = bodies.rigid(kt.Model(nodes={"G": (9.0, 9.0, 9.0)}), "b", shape, points=points)
    v, w = rng.normal(size=(2, 3))
    return model, shape, v, w


def _mass_times(model: kt.Model, names: list[str], velocity: Any) -> Any:
    """M times velocities (v, 3) of a body's nodes, kg m/s: the reactions of held nodes to accelerations of these numbers."""
    held = model.with_(fixed=list(model.nodes))
    rows = [list(model.nodes).index(name) for name in names]
    at = np.array([[node.at for node in model.nodes.values()]], float)
    still, moved = np.zeros_like(at), np.zeros_like(at)
    moved[0, rows] = velocity
    motion = kt.kinematics.from_arrays(held, [0.0], at, still, moved)
    return kt.dynamics.inverse(held, motion, static=False).reaction.sel(support=names).values[0]


def tumbling(change: float) -> dict[str, float]:
    """Angular velocity about the body's own axes, rad/s, and kinetic energy of a free box after 10 s.

    The least moment is about the longest edge, x, the largest about z.

    change : how far the nodes that carry it are moved from the corners, m.
    """
    rng = np.random.default_rng(7)
    shape = bodies.box_properties(SIZE, mass=MASS)
    points = ALTERNATE * SIZE + change * rng.uniform(-1, 1, (4, 3))
    model = bodies.rigid(kt.Model(nodes={"G": (9.0, 9.0, 9.0)}, fixed=["G"]), "b", shape, points=points)
    names = model.bodies["b"].nodes
    start = {name: tuple(np.cross(SPIN, model.nodes[name].at)) for name in names}
    run = kt.dynamics.simulate(model.with_(velocities=start), t_end=10.0, method=TIGHT)
    end = run.motion.data.sel(node=list(names)).isel(time=-1)
    turn, w = _attitude(np.array([model.nodes[name].at for name in names]), end["position"].values, end["velocity"].values)
    return {"": turn.T @ w, "T": run.data["kinetic_energy"][-1]}


def _attitude(start: Any, x: Any, v: Any) -> tuple[Any, Any]:
    """Rotation (3, 3) from the start, and angular velocity (3,) in global axes, of points of a body."""
    r, r0, s = x - x.mean(axis=0), start - start.mean(axis=0), v - v.mean(axis=0)
    turn = np.linalg.lstsq(r0, r, rcond=None)[0].T
    rate = np.linalg.lstsq(r, s, rcond=None)[0].T
    return turn, 0.5 * np.array([rate[2, 1] - rate[1, 2], rate[0, 2] - rate[2, 0], rate[1, 0] - rate[0, 1]])


RADIUS, HEIGHT, TILT, TURN = 0.08, 0.02, 0.5, 2.0
"""A disc on a massless stem of 0.1 m, inclined by 0.5 rad, precessing with 2 rad/s."""


def heavy_top() -> dict[str, float]:
    """Azimuth and inclination, rad, of a top after 1 s of steady precession, and the vertical force on its tip, N."""
    axis = np.array([math.sin(TILT), 0.0, math.cos(TILT)])
    side = np.array([math.cos(TILT), 0.0, -math.sin(TILT)])
    frame = np.array([side, np.cross(axis, side), axis])
    shape = bodies.cylinder_properties(HEIGHT, RADIUS, mass=0.5, at=0.1 * axis, axes=frame)
    ground = kt.Model(nodes={"O": (0.0, 0.0, 0.0)}, fixed=["O"], gravity=(0, 0, -9.81))
    model = bodies.rigid(ground, "top", shape, nodes={"O": None, "P": tuple(0.15 * axis)})
    w = _spin() * axis + TURN * (np.array([0, 0, 1.0]) - math.cos(TILT) * axis)
    start = {name: tuple(np.cross(w, model.nodes[name].at)) for name in model.bodies["top"].nodes if name != "O"}
    run = kt.dynamics.simulate(model.with_(velocities=start), t_end=1.0, method=TIGHT)
    x, y, z = run.motion.data["position"].sel(node="P").isel(time=-1).values
    force = run.forces.data["reaction"].sel(support="O", axis="z").isel(time=-1)
    return {"azimuth": math.atan2(y, x), "tilt": math.atan2(math.hypot(x, y), z), "force": float(force)}


def _spin() -> float:
    """The whole angular velocity about the axis of the top that goes with its precession."""
    across = 0.5 * (RADIUS**2 / 4 + HEIGHT**2 / 12) + 0.5 * 0.1**2
    along = 0.5 * RADIUS**2 / 2
    return (across * TURN**2 * math.cos(TILT) + 0.5 * 9.81 * 0.1) / (along * TURN)


def there_and_back() -> dict[str, float]:
    """A general body as bars and lumped masses, and as a body again."""
    worth = bodies.bar_masses(np.array(CORNER), GENERAL["mass"], GENERAL["center"], GENERAL["inertia"])
    found = bodies.mass_properties(np.array(CORNER), worth.bars, worth.lumped)
    moments = {f"I{i}{j}": found.inertia[i, j] for i in range(3) for j in range(i, 3)}
    return {"mass": found.mass, "x": found.center[0], "z": found.center[2]} | moments


def turned() -> dict[str, float]:
    """Angular acceleration of a free box under a couple (0, 0, 0.5) N m, rad/s^2, at once, and of its centre under a force."""
    loads = {"m": kt.BodyCouple(body="b", moment=(0, 0, 0.5)), "f": kt.BodyForce(body="b", force=(0.3, 0, 0), follows=True)}
    start = kt.Model(nodes={"G": (9.0, 9.0, 9.0)}, fixed=["G"])
    box = bodies.box_properties(SIZE, mass=MASS)
    model = bodies.rigid(start, "b", box, points=ALTERNATE * SIZE).with_(loads=loads)
    run = kt.dynamics.simulate(model, t_end=1e-3)
    names = list(model.bodies["b"].nodes)
    a = run.motion.data["acceleration"].sel(node=names).isel(time=0).values
    x = np.array([model.nodes[name].at for name in names])
    return {"turn": _attitude(x, x, a)[1][2], "push": a.mean(axis=0)[0]}


def stiff(follows: bool) -> dict[str, float]:
    """Square of the frequency, 1/s^2, of a rod of 3 kg and 2 m that hangs under an axial tension of 20 N at its end."""
    load = kt.BodyForce(body="b", at=(2.0, 0.0), force=(0.0, -20.0), follows=follows)
    model = kt.Model(
        nodes={"A": (0.0, 0.0), "B": (0.0, -2.0)},
        fixed={"A": "xy"},
        bars={"b": kt.Bar(ends=("A", "B"), mass=3.0)},
        gravity=(0, -9.81),
        loads={"f": load},
    )
    return {"w2": kt.dynamics.linearise(model, dofs="b.angle").data["frequency_squared"].item()}
