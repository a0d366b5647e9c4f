"""Membranes and solids: elements against the total-Lagrangian formulas, patches, a cantilever, a bar's waves, energy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

import kinetruss as kt
from kinetruss.verification._cases import stored
from kinetruss.verification._measures import off

STEEL = kt.Material(E=210e9, density=7850.0, poisson=0.3)
PLY = kt.Orthotropic(E1=140e9, E2=10e9, nu12=0.3, G12=5e9, E3=9e9, nu13=0.28, nu23=0.4, G13=4.5e9, G23=3e9, density=1600.0)
TURN = 0.5


def one_element(kind: str) -> kt.Model:
    """A model of one element, not regular."""
    if kind.startswith("tetrahedron"):
        nodes = {"A": (0.1, 0.0, 0.2), "B": (1.1, 0.1, 0.0), "C": (0.2, 0.9, -0.1), "D": (0.3, 0.2, 1.2)}
        chosen: dict[str, Any] = {"material": STEEL}
        if kind.endswith("orthotropic"):
            chosen = {"orthotropic": PLY, "axes": ((1.0, 0.4, 0.2), (-0.3, 1.0, 0.1))}
        return kt.Model(nodes=nodes, solids={"one": kt.Solid(elements=[tuple(nodes)], **chosen)})
    if kind.startswith("membrane"):
        space = {"A": (0.1, 0.0, 0.2), "B": (1.1, 0.1, 0.0), "C": (0.2, 0.9, -0.1)}
        chosen = {"material": STEEL} if kind == "membrane" else {"orthotropic": PLY, "axis": (1.0, 0.4, 0.2)}
        return kt.Model(nodes=space, membranes={"one": kt.Membrane(elements=[tuple(space)], thickness=0.02, **chosen)})
    flat = {"A": (0.1, 0.0), "B": (1.1, 0.1), "C": (0.2, 0.9)}
    if kind == "six_nodes":
        flat |= {"D": (0.6, 0.05), "E": (0.65, 0.5), "F": (0.15, 0.45)}
    fields: dict[str, dict[str, Any]] = {
        "plane_stress": {"material": STEEL},
        "plane_strain": {"material": STEEL, "plane": "strain"},
        "orthotropic": {"orthotropic": PLY, "axis": (math.cos(TURN), math.sin(TURN))},
        "six_nodes": {"material": STEEL, "strain": "linear"},
    }
    return kt.Model(nodes=flat, membranes={"one": kt.Membrane(elements=[tuple(flat)], thickness=0.02, **fields[kind])})


def element(kind: str) -> dict[str, float]:
    """Largest differences of force and tangent, of the largest, over large displacements; stress of a rotation, of E.

    The tangent is compared by what it gives for one displacement that has all components.
    """
    model, worst = one_element(kind), {"force": 0.0, "tangent": 0.0}
    start = np.array([node.at for node in model.nodes.values()], float)
    dim = start.shape[1]
    dofs = [f"{name}.{axis}" for name in model.nodes for axis in "xyz"[:dim]]
    for state in stored("solids")["exact"][kind]:
        x = np.array(state["at"])
        K = kt.dynamics.linearise(model, x, dofs=dofs).stiffness.values
        worst["force"] = max(worst["force"], off(_holding(model, x), np.array(state["force"])))
        worst["tangent"] = max(worst["tangent"], off(K @ moved(x.size), np.array(state["tangent"])))
    stress = kt.strength.elements(model, start @ _rotation(dim).T, "one").stress.values
    return worst | {"rotation": float(np.abs(stress).max() / 210e9)}


def moved(size: int) -> NDArray[np.float64]:
    """A displacement that has all components."""
    return np.asarray(np.cos(1.0 + np.arange(size)))


def _holding(model: kt.Model, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces of the element on its nodes (v dim,), N, at positions x (v, dim): minus the reactions of nodes held there."""
    held, still = model.with_(fixed=list(model.nodes)), np.zeros((1, *x.shape))
    motion = kt.kinematics.from_arrays(held, [0.0], x[None], still, still)
    reaction = kt.dynamics.inverse(held, motion, static=False).reaction.sel(support=list(model.nodes))
    return -np.asarray(reaction.values[0]).reshape(-1)


def _rotation(dim: int) -> NDArray[np.float64]:
    c, s = math.cos(2.1), math.sin(2.1)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    about_x = np.array([[1.0, 0, 0], [0, math.cos(0.7), -math.sin(0.7)], [0, math.sin(0.7), math.cos(0.7)]])
    return np.asarray((about_x @ about_z) if dim == 3 else about_z[:2, :2])


def patch(kind: str) -> dict[str, float]:
    """Largest difference from the displacements of a patch of uneven elements under uniform stress, of the largest."""
    if kind == "tetrahedra":
        grid = kt.library.meshes.box(size=(1.0, 1.0, 1.0), cells=(2, 2, 2))
        inner, axes = grid.nearest((0.5, 0.5, 0.5)), "xyz"
    else:
        grid = kt.library.meshes.rectangle(width=1.0, height=1.0, columns=3, rows=3, six_nodes=kind != "triangles")
        inner, axes = grid.nearest((1 / 3, 1 / 3)), "xy"
    points = grid.points.copy()
    if kind in ("triangles", "tetrahedra"):
        points[grid.names.index(inner)] += 0.1
    shaped = kt.library.meshes.mesh(points, grid.elements)
    held = {"n0": axes}
    for name, at in zip(shaped.names[1:], shaped.points[1:].tolist(), strict=True):
        keep = "".join(axis for axis, coordinate in zip(axes, at, strict=True) if coordinate == 0)
        if keep:
            held[name] = keep
    force = _pulled(shaped, 1e6, (1, 2, 1) if kind == "four" else (2 / 3, 8 / 3, 2 / 3))
    fields: dict[str, Any] = {"fixed": held, "material": STEEL, "nodes": shaped.nodes}
    fields["loads"] = {f"at {n}".replace(" ", "_"): kt.NodalForce(node=n, force=f) for n, f in force.items()}
    if kind == "tetrahedra":
        model = kt.Model(**fields, solids={"p": shaped.solid()})
    else:
        strain = "linear" if kind == "linear" else "constant"
        model = kt.Model(**fields, membranes={"p": shaped.membrane(thickness=1.0, strain=strain)})
    found = kt.statics.linear(model).displacement.values
    wide = np.array([1.0, -STEEL.poisson, -STEEL.poisson])[: len(axes)] * 1e6 / STEEL.E
    wanted = shaped.points * wide
    return {"displacement": float(np.abs(found - wanted).max() / np.abs(wanted).max())}


def _pulled(grid: Any, traction: float, shares: tuple[float, float, float]) -> dict[str, tuple[float, ...]]:
    """Nodal forces of a traction along x on the side x = 1 of the unit square (thickness 1 m) or cube."""
    dim, share = grid.points.shape[1], np.zeros(len(grid.points))
    on = grid.points[:, 0] == 1.0
    for row in grid.elements:
        side = [k for k in row if on[k]]
        if len(row) == 6 and len(side) == 3:
            ends = [k for k in row[:3] if on[k]]
            middle = next(k for k in row[3:] if on[k])
            size = abs(grid.points[ends[1], 1] - grid.points[ends[0], 1])
            share[ends] += size * shares[0] / 4
            share[middle] += size * shares[1] / 4
        elif len(row) == dim + 1 and len(side) == dim:
            d = grid.points[side[1:]] - grid.points[side[0]]
            share[side] += np.linalg.norm(d[0] if dim == 2 else np.cross(*d) / 2) / dim
    return {grid.names[k]: (traction * float(share[k]), *(0.0,) * (dim - 1)) for k in np.flatnonzero(share)}


LENGTH, DEPTH, END = 4.0, 1.0, 1e6


def cantilever(strain: str, rows: int) -> tuple[float, float]:
    """Deflection of the tip, m, and strain energy, J, under the tractions of the exact solution; triangles in `rows` rows."""
    six = strain == "linear"
    columns = 2 * rows
    grid = kt.library.meshes.rectangle(width=LENGTH, height=DEPTH, columns=columns, rows=rows, six_nodes=six).moved(
        (0.0, -DEPTH / 2)
    )
    loads: dict[str, kt.NodalForce] = {}
    inertia = DEPTH**3 / 12
    for x, sign in ((0.0, -1.0), (LENGTH, 1.0)):
        side = sorted(grid.at(x=x), key=lambda name: grid.points[grid.names.index(name), 1])
        y = np.array([grid.points[grid.names.index(name), 1] for name in side])
        push = np.zeros((len(side), 2))
        step = 2 if six else 1
        for k in range(0, len(side) - 1, step):
            half = (y[k + step] - y[k]) / 2
            for s, w in zip(*np.polynomial.legendre.leggauss(4), strict=True):
                at = y[k] + (s + 1) * half
                shape = [s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2] if six else [(1 - s) / 2, (1 + s) / 2]
                along = -END * (LENGTH - x) * at / inertia
                across = END / (2 * inertia) * (DEPTH**2 / 4 - at**2)
                push[k : k + step + 1] += sign * w * half * np.outer(shape, [along, across])
        loads |= {f"F{name}": kt.NodalForce(node=name, force=tuple(f)) for name, f in zip(side, push.tolist(), strict=True)}
    fixed = {grid.nearest((0, 0)): "xy", grid.nearest((0, -DEPTH / 2)): "x"}
    model = kt.Model(
        nodes=grid.nodes,
        fixed=fixed,
        loads=loads,
        material=STEEL,
        membranes={"beam": grid.membrane(thickness=1.0, strain=strain)},
    )
    found = kt.statics.linear(model)
    return float(found.displacement.sel(node=grid.nearest((LENGTH, 0)), axis="y")), float(found.energy)


def order(strain: str) -> dict[str, float]:
    """Order of convergence of the energy, and Richardson's limit of the tip's deflection, m."""
    coarse, fine = (16, 32) if strain == "constant" else (8, 16)
    (one, energy_one), (two, energy_two) = cantilever(strain, coarse), cantilever(strain, fine)
    share = 4.0 if strain == "constant" else 16.0
    E, nu, inertia = STEEL.E, STEEL.poisson, DEPTH**3 / 12
    exact = END**2 * LENGTH**3 / (6 * E * inertia) + 3 * END**2 * LENGTH * 2 * (1 + nu) / (5 * E * DEPTH)  # bending, shear
    power = math.log2((exact - energy_one) / (exact - energy_two))
    return {"order": power, "limit": (share * two - one) / (share - 1)}


def waves() -> dict[str, float]:
    """Lowest frequencies, Hz, of a bar of tetrahedra whose material has no Poisson's ratio, guided along x."""
    found = []
    for cells in (8, 16):
        grid = kt.library.meshes.box(size=(1.0, 0.02, 0.02), cells=(cells, 1, 1))
        fixed = dict.fromkeys(grid.names, "yz") | dict.fromkeys(grid.at(x=0.0), "xyz")
        bar = kt.Material(E=70e9, density=2700.0, poisson=0.0)
        model = kt.Model(nodes=grid.nodes, fixed=fixed, solids={"bar": grid.solid(material=bar)})
        found.append(kt.dynamics.linearise(model).frequency.values[:2])
    limit = (4 * found[1] - found[0]) / 3
    return {"first": float(limit[0]), "second": float(limit[1])}


def vibration() -> dict[str, float]:
    """Largest change of the energy of freely moving elements, of the energy, by energy-momentum steps."""
    grid = kt.library.meshes.box(size=(1.0, 0.3, 0.3), cells=(2, 1, 1))
    rubber = kt.Material(E=1e6, density=1000.0, poisson=0.3)
    random = np.random.default_rng(1)
    velocities = {name: tuple(v) for name, v in zip(grid.names, (3 * random.standard_normal((18, 3))).tolist(), strict=False)}
    model = kt.Model(nodes=grid.nodes, solids={"block": grid.solid(material=rubber)}, velocities=velocities)
    run = kt.dynamics.simulate(model, t_end=0.5, samples=101, method=kt.EnergyMomentum(step=1e-3))
    energy, spin = run.data["energy"].values, run.data["angular_momentum"].values
    turned = float(np.ptp(spin, axis=0).max() / np.abs(spin).max())
    return {"energy": float(np.ptp(energy) / energy[0]), "spin": turned}
