"""Bodies carried by nodes: masses in closed form, free and heavy tops, loads; whatever nodes carry them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.library import bodies
from kinetruss.model import DOP853, Bar, Body, BodyCouple, BodyForce, Model, body_mass
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

BARYCENTRIC = Reference("closed-form", "m_ij = int L_i L_j dm (natural coordinates: Garcia de Jalon & Bayo, 1994)")
ENERGY = Reference("closed-form", "T = m v^2/2 + w I w/2 for a random twist of a random body")
EULER = Reference("closed-form", "Jacobi's elliptic functions (Landau & Lifshitz, Mechanics, section 37)")
TOP = Reference(
    "closed-form", "steady precession, I1 W^2 cos(theta) - I3 w3 W + m g l = 0 (Goldstein, Classical Mechanics, section 5.7)"
)
BACK = Reference("agreement", "a body as bars and lumped masses, and as a body again")
RIGID = Reference("closed-form", "a rigid body")
TIGHT = DOP853(rtol=1e-12, atol=1e-12)

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
        found |= {f"{name}.lump.{i}": float(value) for i, value in enumerate(made.lumped)}
    return found


EXPECTED = (
    {f"tetrahedron.bar.{pair}": 0.3 for pair in ("01", "02", "03", "12", "13", "23")}
    | {f"tetrahedron.lump.{i}": -0.2 for i in range(4)}
    | {f"cuboid.bar.{pair}": -2.0 for pair in ("01", "02", "03")}
    | {f"cuboid.bar.{pair}": 1.5 for pair in ("12", "13", "23")}
    | {"cuboid.lump.0": 2.5}
    | {f"alternate.bar.{pair}": 0.25 for pair in ("01", "02", "03", "12", "13", "23")}
    | {f"alternate.lump.{i}": -0.125 for i in range(4)}
)

CORNER = ((0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.0, 0.8, 0.0), (0.0, 0.0, 1.25))
GENERAL: dict[str, Any] = {
    "mass": 3.0,
    "center": (0.2, -0.1, 0.4),
    "inertia": ((0.5, 0.03, -0.02), (0.03, 0.6, 0.01), (-0.02, 0.01, 0.7)),
}


def entries() -> dict[str, float]:
    """m_ij of a general body on a right-angled corner."""
    names = tuple("OXYZ")
    body = Body(nodes=names, **GENERAL)
    m, _ = body_mass(Model(nodes=dict(zip(names, CORNER, strict=True)), bodies={"b": body}), body)
    return {f"{i}{j}": float(m[i, j]) for i in range(4) for j in range(i, 4)}


def exact_entries() -> dict[str, float]:
    """The same by hand: L_x = x/a and so on, L_0 = 1 - L_x - L_y - L_z."""
    m, c, inertia = GENERAL["mass"], np.array(GENERAL["center"]), np.array(GENERAL["inertia"])
    edge = np.array([0.5, 0.8, 1.25])
    J = (0.5 * np.trace(inertia) * np.eye(3) - inertia + m * np.outer(c, c)) / np.outer(edge, edge)
    first = m * c / edge
    found = {f"{i + 1}{j + 1}": float(J[i, j]) for i in range(3) for j in range(i, 3)}
    found |= {f"0{i + 1}": float(first[i] - J[i].sum()) for i in range(3)}
    return found | {"00": float(m - 2 * first.sum() + J.sum())}


def energies(seed: int) -> tuple[dict[str, float], dict[str, float]]:
    """Kinetic energy and momenta of a random body in a random twist: by nodes, and by the formulas of a rigid body."""
    rng = np.random.default_rng(seed)
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    size, mass = rng.uniform(0.3, 1.5, 3).tolist(), float(rng.uniform(1, 3))
    shape = bodies.box_properties(size, mass=mass, at=rng.normal(size=3), axes=axes)
    points = ALTERNATE + rng.uniform(-0.2, 0.2, (4, 3)) + shape.center
    model = bodies.rigid(Model(nodes={"G": (9.0, 9.0, 9.0)}), "b", shape, points=points)
    names = list(model.bodies["b"].nodes)
    at = np.array([model.nodes[name].at for name in names])
    v, w = rng.normal(size=(2, 3))
    velocity = v + np.cross(w, at - shape.center)
    p = _mass_times(model, names, velocity)
    spin = np.cross(at - shape.center, p).sum(axis=0)
    found = {"T": float(0.5 * np.sum(p * velocity)), "p": float(p.sum(axis=0)[0]), "L": float(spin[2])}
    L = shape.inertia @ w
    return found, {"T": float(0.5 * (shape.mass * v @ v + w @ L)), "p": float(shape.mass * v[0]), "L": float(L[2])}


def _mass_times(model: Model, names: list[str], velocity: Any) -> Any:
    """M times velocities (v, 3) of a body's nodes, kg m/s: the reactions of held nodes to accelerations of these numbers."""
    held = model.with_(fixed=list(model.nodes))
    rows = [list(model.nodes).index(name) for name in names]
    at = np.array([[node.at for node in model.nodes.values()]], float)
    still, moved = np.zeros_like(at), np.zeros_like(at)
    moved[0, rows] = velocity
    motion = kinematics.from_arrays(held, [0.0], at, still, moved)
    return dynamics.inverse(held, motion, static=False).reaction.sel(support=names).values[0]


def twist(seed: int) -> dict[str, float]:
    """What the nodes say."""
    return energies(seed)[0]


def tumbling(change: float) -> dict[str, float]:
    """Angular velocity about the body's own axes, rad/s, and kinetic energy of a free box after 10 s.

    The least moment is about the longest edge, x, the largest about z.

    change : how far the nodes that carry it are moved from the corners, m.
    """
    rng = np.random.default_rng(7)
    shape = bodies.box_properties(SIZE, mass=MASS)
    points = ALTERNATE * SIZE + change * rng.uniform(-1, 1, (4, 3))
    model = bodies.rigid(Model(nodes={"G": (9.0, 9.0, 9.0)}, fixed=["G"]), "b", shape, points=points)
    names = model.bodies["b"].nodes
    start = {name: tuple(np.cross(SPIN, model.nodes[name].at)) for name in names}
    run = dynamics.simulate(model.with_(velocities=start), t_end=10.0, method=TIGHT)
    end = run.motion.data.sel(node=list(names)).isel(time=-1)
    turn, w = _attitude(np.array([model.nodes[name].at for name in names]), end["position"].values, end["velocity"].values)
    own = turn.T @ w
    return {"x": float(own[0]), "y": float(own[1]), "z": float(own[2]), "T": float(run.data["kinetic_energy"][-1])}


def _attitude(start: Any, x: Any, v: Any) -> tuple[Any, Any]:
    """Rotation (3, 3) from the start, and angular velocity (3,) in global axes, of points of a body."""
    r, r0, s = x - x.mean(axis=0), start - start.mean(axis=0), v - v.mean(axis=0)
    turn = np.linalg.lstsq(r0, r, rcond=None)[0].T
    rate = np.linalg.lstsq(r, s, rcond=None)[0].T
    return turn, 0.5 * np.array([rate[2, 1] - rate[1, 2], rate[0, 2] - rate[2, 0], rate[1, 0] - rate[0, 1]])


def exact_tumbling() -> dict[str, float]:
    """w1 = a1 cn, w2 = a2 sn, w3 = a3 dn for I1 < I2 < I3 and M^2 > 2 E I2."""
    from scipy.special import ellipj

    I1, I2, I3 = np.sort(np.diag(bodies.box_properties(SIZE, mass=MASS).inertia))
    energy = I1 * SPIN[0] ** 2 + I3 * SPIN[2] ** 2  # twice it
    square = (I1 * SPIN[0]) ** 2 + (I3 * SPIN[2]) ** 2
    rate = math.sqrt((I3 - I2) * (square - energy * I1) / (I1 * I2 * I3))
    modulus = (I2 - I1) * (energy * I3 - square) / ((I3 - I2) * (square - energy * I1))
    sn, cn, dn, _ = ellipj(10.0 * rate, modulus)
    a2 = math.sqrt((energy * I3 - square) / (I2 * (I3 - I2)))
    return {"x": SPIN[0] * float(cn), "y": a2 * float(sn), "z": SPIN[2] * float(dn), "T": energy / 2}


RADIUS, HEIGHT, TILT, TURN = 0.08, 0.02, 0.5, 2.0
"""A disc on a massless stem of 0.1 m, inclined by 0.5 rad, precessing with 2 rad/s."""


def heavy_top() -> dict[str, float]:
    """Azimuth and inclination, rad, of a top after 1 s of steady precession, and the vertical force on its tip, N."""
    axis = np.array([math.sin(TILT), 0.0, math.cos(TILT)])
    side = np.array([math.cos(TILT), 0.0, -math.sin(TILT)])
    frame = np.array([side, np.cross(axis, side), axis])
    shape = bodies.cylinder_properties(HEIGHT, RADIUS, mass=0.5, at=0.1 * axis, axes=frame)
    ground = Model(nodes={"O": (0.0, 0.0, 0.0)}, fixed=["O"], gravity=(0, 0, -9.81))
    model = bodies.rigid(ground, "top", shape, nodes={"O": None, "P": tuple(0.15 * axis)})
    w = _spin() * axis + TURN * (np.array([0, 0, 1.0]) - math.cos(TILT) * axis)
    start = {name: tuple(np.cross(w, model.nodes[name].at)) for name in model.bodies["top"].nodes if name != "O"}
    run = dynamics.simulate(model.with_(velocities=start), t_end=1.0, method=TIGHT)
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
    moments = {f"I{i}{j}": float(found.inertia[i, j]) for i in range(3) for j in range(i, 3)}
    return {"mass": found.mass, "x": float(found.center[0]), "z": float(found.center[2])} | moments


def turned() -> dict[str, float]:
    """Angular acceleration of a free box under a couple (0, 0, 0.5) N m, rad/s^2, at once, and of its centre under a force."""
    loads = {"m": BodyCouple(body="b", moment=(0, 0, 0.5)), "f": BodyForce(body="b", force=(0.3, 0, 0), follows=True)}
    start = Model(nodes={"G": (9.0, 9.0, 9.0)}, fixed=["G"])
    model = bodies.rigid(start, "b", bodies.box_properties(SIZE, mass=MASS), points=ALTERNATE * SIZE).with_(loads=loads)
    run = dynamics.simulate(model, t_end=1e-3)
    names = list(model.bodies["b"].nodes)
    a = run.motion.data["acceleration"].sel(node=names).isel(time=0).values
    x = np.array([model.nodes[name].at for name in names])
    return {"turn": float(_attitude(x, x, a)[1][2]), "push": float(a.mean(axis=0)[0])}


def stiff(follows: bool) -> dict[str, float]:
    """Square of the frequency, 1/s^2, of a rod of 3 kg and 2 m that hangs and is pulled along by 20 N at its end."""
    load = BodyForce(body="b", at=(2.0, 0.0), force=(0.0, -20.0), follows=follows)
    model = Model(
        nodes={"A": (0.0, 0.0), "B": (0.0, -2.0)},
        fixed={"A": "xy"},
        bars={"b": Bar(ends=("A", "B"), mass=3.0)},
        gravity=(0, -9.81),
        loads={"f": load},
    )
    return {"w2": float(dynamics.linearise(model, dofs="b.angle").data["frequency_squared"].item())}


def cases() -> Iterator[Case]:
    """Masses, twists, tops, loads."""
    for name, value in EXPECTED.items():
        yield Case(f"bodies.{name}", BARYCENTRIC, value, 1e-12, worth, (), (name,))
    for name, value in exact_entries().items():
        yield Case(f"bodies.entry.{name}", BARYCENTRIC, value, 1e-12, entries, (), (name,))
    for seed in (1, 2, 3):
        for name, value in energies(seed)[1].items():
            yield Case(f"bodies.twist.{seed}.{name}", ENERGY, value, 1e-11, twist, (seed,), (name,))
    for change in (0.0, 0.05):
        for name, value in exact_tumbling().items():
            yield Case(f"bodies.euler.{change:g}.{name}", EULER, value, 1e-9, tumbling, (change,), (name,))
    yield Case("bodies.top.azimuth", TOP, TURN, 1e-9, heavy_top, (), ("azimuth",))
    yield Case("bodies.top.tilt", TOP, TILT, 1e-9, heavy_top, (), ("tilt",))
    yield Case("bodies.top.force", TOP, 0.5 * 9.81, 1e-8, heavy_top, (), ("force",))
    inertia = np.array(GENERAL["inertia"])
    exact = {"mass": GENERAL["mass"], "x": GENERAL["center"][0], "z": GENERAL["center"][2]}
    exact |= {f"I{i}{j}": float(inertia[i, j]) for i in range(3) for j in range(i, 3)}
    for name, value in exact.items():
        yield Case(f"bodies.back.{name}", BACK, value, 1e-12, there_and_back, (), (name,), 1.0)
    yield Case("bodies.couple", RIGID, 0.5 / (MASS / 12 * (SIZE[0] ** 2 + SIZE[1] ** 2)), 1e-12, turned, (), ("turn",))
    yield Case("bodies.force", RIGID, 0.3 / MASS, 1e-12, turned, (), ("push",))
    for follows, arm in ((True, 0.0), (False, 20.0 * 2.0)):
        name = "follower" if follows else "dead"
        yield Case(f"bodies.{name}.stiffness", RIGID, (3 * 9.81 + arm) / 4, 1e-11, stiff, (follows,), ("w2",))
