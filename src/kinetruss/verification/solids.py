"""Membranes, solids and rigid bodies: elements by their formulas, patches, convergence, masses on nodes, tops."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model, stored
from kinetruss.verification.measures import Numbers, off

simulate, meshes, bodies = kt.dynamics.simulate, kt.library.meshes, kt.library.bodies

STEEL = kt.Material(E=210e9, density=7850.0, poisson=0.3)
TIGHT = kt.DOP853(rtol=1e-12, atol=1e-12)


def held(of: kt.Model, places: Any, accelerations: Any = 0.0) -> Any:
    """Reactions (v, dim), N, of the nodes, all held in places and given accelerations."""
    fixed, x = of.with_(fixed=list(of.nodes)), np.asarray(places, float)[None]
    motion = kt.kinematics.from_arrays(fixed, [0.0], x, 0 * x, 0 * x + accelerations)
    return kt.dynamics.inverse(fixed, motion, static=False).reaction.sel(support=list(of.nodes)).values[0]


def drawn(of: kt.Model) -> Any:
    """Places of the nodes of a model (v, dim), m."""
    return np.array([node.at for node in of.nodes.values()], float)


def moved(size: int) -> Any:
    """A displacement that has all components."""
    return np.cos(1.0 + np.arange(size))


def element(kind: str) -> Numbers:
    """Largest differences of force and tangent, of the largest, over large displacements; stress of a rotation, of E.

    The tangent is compared by what it gives for one displacement that has all components.
    """
    one, found = model(f"element.{kind}"), []
    start = drawn(one)
    dim = start.shape[1]
    dofs = [f"{name}.{axis}" for name in one.nodes for axis in "xyz"[:dim]]
    for state in stored("solids")["exact"][kind]:
        x = np.array(state["at"])
        K = kt.dynamics.linearise(one, x, dofs=dofs).stiffness.values
        found.append((off(-held(one, x).ravel(), np.array(state["force"])), off(K @ moved(x.size), np.array(state["tangent"]))))
    c, s = math.cos(2.1), math.sin(2.1)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    turn = np.roll(about_z, 1, (0, 1)) @ about_z if dim == 3 else about_z[:2, :2]
    stress = kt.strength.elements(one, start @ turn.T, "one").stress
    force, tangent = np.max(found, axis=0)
    return {"force": force, "tangent": tangent, "rotation": abs(stress).max() / STEEL.E}


def patch(kind: str) -> Numbers:
    """Largest difference from the displacements of a patch of uneven elements under uniform stress, of the largest."""
    if kind == "tetrahedra":
        grid = meshes.box(size=(1.0, 1.0, 1.0), cells=(2, 2, 2))
    else:
        grid = meshes.rectangle(width=1.0, height=1.0, columns=3, rows=3, six_nodes=kind != "triangles")
    points, axes = grid.points.copy(), "xyz"[: grid.points.shape[1]]
    if kind in ("triangles", "tetrahedra"):
        inner = grid.nearest((0.5, 0.5, 0.5) if kind == "tetrahedra" else (1 / 3, 1 / 3))
        points[grid.names.index(inner)] += 0.1
    shaped = meshes.mesh(points, grid.elements)
    kept = {
        name: "".join(a for a, x in zip(axes, at, strict=True) if x == 0) for name, at in zip(shaped.names, points, strict=True)
    }
    fields: dict[str, Any] = {"fixed": {name: keep for name, keep in kept.items() if keep}, "nodes": shaped.nodes}
    if kind == "tetrahedra":
        fields |= {"solids": {"p": shaped.solid()}, "loads": _pulled_face(shaped)}
    else:
        linear = kind == "linear"
        fields |= {"membranes": {"p": shaped.membrane(thickness=1.0, strain="linear" if linear else "constant")}}
        fields |= {"loads": _pulled(shaped, 1.0, lambda _: (1e6, 0.0), linear)}
    found = kt.statics.linear(kt.Model(**fields, material=STEEL)).displacement.values
    return {"displacement": off(found, points * np.array([1.0, -STEEL.poisson, -STEEL.poisson])[: len(axes)] * 1e6 / STEEL.E)}


def _pulled_face(grid: Any) -> dict[str, kt.NodalForce]:
    """Loads of a traction of 1 MPa along x on the triangles in the face x = 1."""
    on, loads = grid.points[:, 0] == 1.0, np.zeros(len(grid.points))
    for side in ([k for k in row if on[k]] for row in grid.elements):
        if len(side) == 3:
            a, b = grid.points[side[1:]] - grid.points[side[0]]
            loads[side] += 1e6 * np.linalg.norm(np.cross(a, b)) / 6
    return {f"F{grid.names[k]}": kt.NodalForce(node=grid.names[k], force=(loads[k], 0.0, 0.0)) for k in np.flatnonzero(on)}


def _pulled(grid: Any, x: float, traction: Any, quadratic: bool) -> dict[str, kt.NodalForce]:
    """Loads that do the work of a traction (Pa, of y) on a side of a sheet 1 m thick, whose edges bend if quadratic."""
    heights = {name: grid.points[grid.names.index(name), 1] for name in grid.at(x=x)}
    side = sorted(heights, key=heights.__getitem__)
    y, push, step = [heights[name] for name in side], np.zeros((len(side), 2)), 2 if quadratic else 1
    for k in range(0, len(side) - 1, step):
        half = (y[k + step] - y[k]) / 2
        for s, w in zip(*np.polynomial.legendre.leggauss(4), strict=True):
            shape = [s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2] if quadratic else [(1 - s) / 2, (1 + s) / 2]
            push[k : k + step + 1] += w * half * np.outer(shape, traction(y[k] + (s + 1) * half))
    return {f"F{name}": kt.NodalForce(node=name, force=tuple(f)) for name, f in zip(side, push.tolist(), strict=True)}


LENGTH, DEPTH, END = 4.0, 1.0, 1e6
INERTIA = DEPTH**3 / 12


def cantilever(strain: str, rows: int) -> tuple[float, float]:
    """Deflection of the tip, m, and strain energy, J, under the tractions of the exact solution; triangles in `rows` rows."""
    six = strain == "linear"
    sheet = meshes.rectangle(width=LENGTH, height=DEPTH, columns=2 * rows, rows=rows, six_nodes=six)
    grid = sheet.moved((0.0, -DEPTH / 2))

    def shear(y: float) -> float:
        return END / (2 * INERTIA) * (DEPTH**2 / 4 - y**2)

    loads = _pulled(grid, LENGTH, lambda y: (0.0, shear(y)), six)
    loads |= _pulled(grid, 0.0, lambda y: (END * LENGTH * y / INERTIA, -shear(y)), six)
    beam = kt.Model(
        nodes=grid.nodes,
        fixed={grid.nearest((0, 0)): "xy", grid.nearest((0, -DEPTH / 2)): "x"},
        loads=loads,
        material=STEEL,
        membranes={"beam": grid.membrane(thickness=1.0, strain=strain)},
    )
    found = kt.statics.linear(beam)
    return found.displacement.sel(node=grid.nearest((LENGTH, 0)), axis="y").item(), found.energy.item()


def order(strain: str) -> Numbers:
    """Order of convergence of the energy, and Richardson's limit of the tip's deflection, m."""
    (one, coarse), (two, fine) = (cantilever(strain, rows) for rows in ((16, 32) if strain == "constant" else (8, 16)))
    share = 4.0 if strain == "constant" else 16.0
    bending = END**2 * LENGTH**3 / (6 * STEEL.E * INERTIA)
    exact = bending + 3 * END**2 * LENGTH * 2 * (1 + STEEL.poisson) / (5 * STEEL.E * DEPTH)
    return {"order": math.log2((exact - coarse) / (exact - fine)), "limit": (share * two - one) / (share - 1)}


def waves() -> Numbers:
    """Lowest frequencies, Hz, of a bar of tetrahedra whose material has no Poisson's ratio, guided along x."""
    found, material = [], kt.Material(E=70e9, density=2700.0, poisson=0.0)
    for cells in (8, 16):
        grid = meshes.box(size=(1.0, 0.02, 0.02), cells=(cells, 1, 1))
        fixed = dict.fromkeys(grid.names, "yz") | dict.fromkeys(grid.at(x=0.0), "xyz")
        bar = kt.Model(nodes=grid.nodes, fixed=fixed, solids={"bar": grid.solid(material=material)})
        found.append(kt.dynamics.linearise(bar).frequency.values[:2])
    return dict(zip(("first", "second"), (4 * found[1] - found[0]) / 3, strict=True))


def vibration() -> Numbers:
    """Largest change of the energy of freely moving elements, of the energy, by energy-momentum steps."""
    grid, rubber = meshes.box(size=(1.0, 0.3, 0.3), cells=(2, 1, 1)), kt.Material(E=1e6, density=1000.0, poisson=0.3)
    random = 3 * np.random.default_rng(1).standard_normal((18, 3))
    velocities = {name: tuple(v) for name, v in zip(grid.names, random.tolist(), strict=False)}
    block = kt.Model(nodes=grid.nodes, solids={"block": grid.solid(material=rubber)}, velocities=velocities)
    run = simulate(block, t_end=0.5, samples=101, method=kt.EnergyMomentum(step=1e-3))
    energy, spin = run.data["energy"].values, run.data["angular_momentum"].values
    return {"energy": np.ptp(energy) / energy[0], "spin": np.ptp(spin, axis=0).max() / np.abs(spin).max()}


def matrix(turned: float) -> Numbers:
    """Entries of the mass matrix of a body whose bar stands at an angle (rad): reactions to unit accelerations of its ends."""
    d = 0.5 * cmath.exp(1j * turned)
    body = kt.PlanarBody(mass=2.0, center=(0.2, 0.1), inertia=0.03)
    bar = kt.Model(
        nodes={"A": (0.0, 0.0), "B": (d.real, d.imag)}, bars={"body": {"ends": ("A", "B"), "length": 0.5, "body": body}}
    )
    found = np.array([held(bar, drawn(bar), unit.reshape(2, 2)).ravel() for unit in np.eye(4)]).T
    return {f"{i}{j}": found[i, j] for i in range(4) for j in range(4)} | {"det": np.linalg.det(found)}


SIZE, MASS = (1.0, 0.6, 0.3), 2.0
SPIN = (0.4, 0.0, 3.0)
"""rad/s about the axes of least, middle and largest moment of the box, so that it starts where the middle one is 0."""
ALTERNATE = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / 2
CORNER = ((0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.0, 0.8, 0.0), (0.0, 0.0, 1.25))
GENERAL: dict[str, Any] = {
    "mass": 3.0,
    "center": (0.2, -0.1, 0.4),
    "inertia": ((0.5, 0.03, -0.02), (0.03, 0.6, 0.01), (-0.02, 0.01, 0.7)),
}


def worth() -> Numbers:
    """Bars and lumped masses of a tetrahedron, and of a cuboid from its corner and from alternate corners; mass 1 kg."""
    points = np.array([[0.3, 0.1, 0.0], [1.2, 0.0, 0.4], [0.0, 0.9, 0.1], [0.2, 0.3, 1.1]])
    corner = np.array([[0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4]])
    found: Numbers = {}
    for name, at, shape in (
        ("tetrahedron", points, bodies.tetrahedron_properties(points, mass=1.0)),
        ("cuboid", corner, bodies.box_properties((2, 3, 4), mass=1.0, at=(1, 1.5, 2))),
        ("alternate", ALTERNATE * (2, 3, 4), bodies.box_properties((2, 3, 4), mass=1.0)),
    ):
        made = bodies.bar_masses(at, shape.mass, shape.center, shape.inertia)
        found |= {f"{name}.bar.{i}{j}": value for (i, j), value in made.bars.items()}
        found |= {f"{name}.lump.{i}": value for i, value in enumerate(made.lumped)}
    return found


def entries() -> Numbers:
    """m_ij of a general body on a right-angled corner."""
    body = kt.Body(nodes=tuple("OXYZ"), **GENERAL)
    m, _ = kt.model.body_mass(kt.Model(nodes=dict(zip("OXYZ", CORNER, strict=True)), bodies={"b": body}), body)
    return {f"{i}{j}": m[i, j] for i in range(4) for j in range(i, 4)}


def there_and_back() -> Numbers:
    """A general body as bars and lumped masses, and as a body again."""
    bars = bodies.bar_masses(np.array(CORNER), **GENERAL)
    found = bodies.mass_properties(np.array(CORNER), bars.bars, bars.lumped)
    moments = {f"I{i}{j}": found.inertia[i, j] for i in range(3) for j in range(i, 3)}
    return {"mass": found.mass, "x": found.center[0], "z": found.center[2]} | moments


def random_body(seed: int) -> tuple[kt.Model, Any, Any, Any]:
    """A body, its properties, the velocity of its centre, m/s, and its angular velocity, rad/s."""
    rng = np.random.default_rng(seed)
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    size, mass = rng.uniform(0.3, 1.5, 3).tolist(), float(rng.uniform(1, 3))
    shape = bodies.box_properties(size, mass=mass, at=rng.normal(size=3), axes=axes)
    carried = _carried(shape, ALTERNATE + rng.uniform(-0.2, 0.2, (4, 3)) + shape.center)
    return carried, shape, *rng.normal(size=(2, 3))


def _carried(shape: Any, points: Any) -> kt.Model:
    """A body carried by nodes at points; the first node of the model is fixed and far away."""
    return bodies.rigid(kt.Model(nodes={"G": (9.0, 9.0, 9.0)}, fixed=["G"]), "b", shape, points=points)


def twist(seed: int) -> Numbers:
    """Kinetic energy and momenta that the nodes of a random body in a random twist have."""
    carried, shape, v, w = random_body(seed)
    arms = drawn(carried) - shape.center
    velocity = v + np.cross(w, arms)
    velocity[0] = 0.0  # of the fixed node
    p = held(carried, drawn(carried), velocity)
    return {"T": 0.5 * np.sum(p * velocity), "p": p.sum(axis=0)[0], "L": np.cross(arms, p).sum(axis=0)[2]}


def tumbling(change: float) -> Numbers:
    """Angular velocity about the body's own axes, rad/s, and kinetic energy of a free box after 10 s.

    The least moment is about the longest edge, x, the largest about z.

    change : how far the nodes that carry it are moved from the corners, m.
    """
    points = ALTERNATE * SIZE + change * np.random.default_rng(7).uniform(-1, 1, (4, 3))
    box = _carried(bodies.box_properties(SIZE, mass=MASS), points)
    names = box.bodies["b"].nodes
    start = {name: tuple(np.cross(SPIN, box.nodes[name].at)) for name in names}
    run = simulate(box.with_(velocities=start), t_end=10.0, method=TIGHT)
    end = kt.kinematics.pose(box, run.motion, names).isel(time=-1)
    return {"": end.rotation_matrix.values.T @ end.angular_velocity.values, "T": run.data["kinetic_energy"][-1]}


def turned() -> Numbers:
    """Angular acceleration of a free box under a couple (0, 0, 0.5) N m, rad/s^2, at once, and of its centre under a force."""
    loads = {"m": kt.BodyCouple(body="b", moment=(0, 0, 0.5)), "f": kt.BodyForce(body="b", force=(0.3, 0, 0), follows=True)}
    box = _carried(bodies.box_properties(SIZE, mass=MASS), ALTERNATE * SIZE).with_(loads=loads)
    found = kt.kinematics.pose(box, simulate(box, t_end=1e-3).motion, box.bodies["b"].nodes).isel(time=0)
    return {"turn": found.angular_acceleration[2], "push": found.acceleration[0]}


def heavy_top() -> Numbers:
    """Azimuth and inclination, rad, of a disc on a massless stem of 0.1 m after 1 s of steady precession, 0.5 rad inclined,
    with 2 rad/s; and the vertical force on its tip, N.
    """
    mass, radius, height, stem, turn = 0.5, 0.08, 0.02, 0.1, 2.0
    s, c = math.sin(0.5), math.cos(0.5)
    axis, side = np.array([s, 0.0, c]), np.array([c, 0.0, -s])
    frame = np.array([side, np.cross(axis, side), axis])
    shape = bodies.cylinder_properties(height, radius, mass=mass, at=stem * axis, axes=frame)
    ground = kt.Model(nodes={"O": (0.0, 0.0, 0.0)}, fixed=["O"], gravity=(0, 0, -9.81))
    top = bodies.rigid(ground, "top", shape, nodes={"O": None, "P": tuple(0.15 * axis)})
    across, along = mass * (radius**2 / 4 + height**2 / 12) + mass * stem**2, mass * radius**2 / 2
    # the whole angular velocity about the axis of the top that goes with its precession
    spin = (across * turn**2 * c + mass * 9.81 * stem) / (along * turn)
    w = spin * axis + turn * (np.array([0, 0, 1.0]) - c * axis)
    start = {name: tuple(np.cross(w, top.nodes[name].at)) for name in top.bodies["top"].nodes if name != "O"}
    run = simulate(top.with_(velocities=start), t_end=1.0, method=TIGHT)
    x, y, z = run.motion.position.sel(node="P").values[-1]
    force = run.forces.data["reaction"].sel(support="O", axis="z")[-1]
    return {"azimuth": math.atan2(y, x), "tilt": math.atan2(math.hypot(x, y), z), "force": force}


def stiff(follows: bool) -> Numbers:
    """Square of the frequency, 1/s^2, of a rod of 3 kg and 2 m that hangs under an axial tension of 20 N at its end."""
    load = kt.BodyForce(body="b", at=(2.0, 0.0), force=(0.0, -20.0), follows=follows)
    rod = model("hanging_rod").with_(loads={"f": load})
    return {"w2": kt.dynamics.linearise(rod, dofs="b.angle").data["frequency_squared"].item()}
