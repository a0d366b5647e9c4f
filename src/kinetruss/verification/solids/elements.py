"""Membranes and solids: elements against the total-Lagrangian formulas, patches, a cantilever, a bar's waves, energy."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss import dynamics, kinematics, statics, strength
from kinetruss.library import meshes
from kinetruss.model import EnergyMomentum, Material, Membrane, Model, NodalForce, Orthotropic, Solid
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

LAGRANGE = Reference("closed-form", "f = -V0 F S grad N, S = C E, E = (F^T F - 1)/2 (Bathe, Finite Element Procedures, 6.3)")
COMPLEX = Reference("closed-form", "derivative of the total-Lagrangian forces by complex steps")
RIGID = Reference("identity", "no strain under a rotation")
PATCH = Reference("closed-form", "uniform stress (patch test; Irons & Razzaque, 1972)")
BEAM = Reference("closed-form", "P/(6 E I) (2 L^3 + (4 + 5 nu) D^2 L/4) (Timoshenko & Goodier, Theory of Elasticity, art. 21)")
ORDER = Reference("count", "the error of the energy falls like h^(2 p), p the degree of the displacements (Strang & Fix, 1973)")
WAVES = Reference("closed-form", "(2 k - 1)/(4 L) sqrt(E/rho), a bar held at one end, Richardson's limit of two meshes")
ENERGY = Reference("identity", "energy is kept")
KINDS = (
    "plane_stress",
    "plane_strain",
    "orthotropic",
    "membrane",
    "membrane_orthotropic",
    "tetrahedron",
    "tetrahedron_orthotropic",
    "six_nodes",
)
STEEL = Material(E=210e9, density=7850.0, poisson=0.3)
PLY = Orthotropic(E1=140e9, E2=10e9, nu12=0.3, G12=5e9, E3=9e9, nu13=0.28, nu23=0.4, G13=4.5e9, G23=3e9, density=1600.0)
TURN = 0.5


def one_element(kind: str) -> Model:
    """A model of one element, not regular."""
    if kind.startswith("tetrahedron"):
        nodes = {"A": (0.1, 0.0, 0.2), "B": (1.1, 0.1, 0.0), "C": (0.2, 0.9, -0.1), "D": (0.3, 0.2, 1.2)}
        chosen: dict[str, Any] = {"material": STEEL}
        if kind.endswith("orthotropic"):
            chosen = {"orthotropic": PLY, "axes": ((1.0, 0.4, 0.2), (-0.3, 1.0, 0.1))}
        return Model(nodes=nodes, solids={"one": Solid(elements=[tuple(nodes)], **chosen)})
    if kind.startswith("membrane"):
        space = {"A": (0.1, 0.0, 0.2), "B": (1.1, 0.1, 0.0), "C": (0.2, 0.9, -0.1)}
        chosen = {"material": STEEL} if kind == "membrane" else {"orthotropic": PLY, "axis": (1.0, 0.4, 0.2)}
        return Model(nodes=space, membranes={"one": Membrane(elements=[tuple(space)], thickness=0.02, **chosen)})
    flat = {"A": (0.1, 0.0), "B": (1.1, 0.1), "C": (0.2, 0.9)}
    if kind == "six_nodes":
        flat |= {"D": (0.6, 0.05), "E": (0.65, 0.5), "F": (0.15, 0.45)}
    fields: dict[str, dict[str, Any]] = {
        "plane_stress": {"material": STEEL},
        "plane_strain": {"material": STEEL, "plane": "strain"},
        "orthotropic": {"orthotropic": PLY, "axis": (math.cos(TURN), math.sin(TURN))},
        "six_nodes": {"material": STEEL, "strain": "linear"},
    }
    return Model(nodes=flat, membranes={"one": Membrane(elements=[tuple(flat)], thickness=0.02, **fields[kind])})


def elastic_law(kind: str) -> NDArray[np.float64]:
    """C in material axes, Pa, written out."""
    if kind.endswith("orthotropic"):
        E1, E2, E3 = PLY.E1, PLY.E2, PLY.E3 or 0.0
        n12, n13, n23 = PLY.nu12, PLY.nu13 or 0.0, PLY.nu23 or 0.0
        if not kind.startswith("tetrahedron"):
            n21 = n12 * E2 / E1
            one = 1 - n12 * n21
            return np.array([[E1 / one, n12 * E2 / one, 0], [n12 * E2 / one, E2 / one, 0], [0, 0, PLY.G12]])
        n21, n31, n32 = n12 * E2 / E1, n13 * E3 / E1, n23 * E3 / E2
        one = (1 - n12 * n21 - n23 * n32 - n13 * n31 - 2 * n21 * n32 * n13) / (E1 * E2 * E3)
        C = np.zeros((6, 6))
        C[0, :3] = np.array([1 - n23 * n32, n21 + n31 * n23, n31 + n21 * n32]) / (E2 * E3 * one)
        C[1, :3] = np.array([n12 + n13 * n32, 1 - n31 * n13, n32 + n31 * n12])
        C[1, :3] = [C[0, 1], C[1, 1] / (E1 * E3 * one), C[1, 2] / (E1 * E3 * one)]
        C[2, :3] = [C[0, 2], C[1, 2], (1 - n12 * n21) / (E1 * E2 * one)]
        C[3, 3], C[4, 4], C[5, 5] = PLY.G23 or 0.0, PLY.G13 or 0.0, PLY.G12
        return C
    E, nu = STEEL.E, STEEL.poisson
    if kind in ("plane_stress", "membrane", "six_nodes"):
        return E / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    lame, G = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
    if kind == "plane_strain":
        return np.array([[lame + 2 * G, lame, 0], [lame, lame + 2 * G, 0], [0, 0, G]])
    return np.asarray(lame * np.pad(np.ones((3, 3)), (0, 3)) + G * np.diag([2.0, 2, 2, 1, 1, 1]))


def lagrangian(kind: str, x0: NDArray[Any], x: NDArray[Any]) -> NDArray[Any]:
    """Forces on the nodes (v, 3), N, by the total-Lagrangian formulas; x (v, 3) may be complex."""
    C, axes = elastic_law(kind), _axes(kind, x0)
    X = (x0 - x0[0]) @ axes.T
    total = np.zeros(x.shape, x.dtype)
    for weight, local in _points(len(x0)):
        J = local.T @ X
        grad = local @ np.linalg.inv(J).T
        volume = weight * abs(np.linalg.det(J)) * (1.0 if len(C) == 6 else 0.02)
        F = x.T @ grad
        green = 0.5 * (F.T @ F - np.eye(len(axes)))
        if len(C) == 6:
            pairs = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
        else:
            pairs = ((0, 0), (1, 1), (0, 1))  # type: ignore[assignment]
        S = np.zeros(green.shape, x.dtype)
        for value, (a, b) in zip(C @ np.array([green[a, b] * (1 if a == b else 2) for a, b in pairs]), pairs, strict=True):
            S[a, b] = S[b, a] = value
        total -= volume * grad @ S @ F.T
    return total


def _axes(kind: str, x0: NDArray[np.float64]) -> NDArray[np.float64]:
    """Material axes as rows."""
    if kind == "orthotropic":
        return np.array([[math.cos(TURN), math.sin(TURN), 0], [-math.sin(TURN), math.cos(TURN), 0]])
    if kind.startswith("membrane"):
        normal = np.cross(x0[1] - x0[0], x0[2] - x0[0])
        normal /= np.linalg.norm(normal)
        wanted = np.array([1.0, 0.4, 0.2]) if kind.endswith("orthotropic") else np.array([1.0, 0, 0])
        one = wanted - (wanted @ normal) * normal
        one /= np.linalg.norm(one)
        return np.array([one, np.cross(normal, one)])
    if kind == "tetrahedron_orthotropic":
        one, two = np.array([1.0, 0.4, 0.2]), np.array([-0.3, 1.0, 0.1])
        one = one / np.linalg.norm(one)
        two = two - (two @ one) * one
        two /= np.linalg.norm(two)
        return np.array([one, two, np.cross(one, two)])
    return np.eye(3)[: 3 if kind == "tetrahedron" else 2]


def _points(nodes: int) -> list[tuple[float, NDArray[np.float64]]]:
    """Weights and derivatives (v, s) of the shape functions; six nodes: the seven-point rule of degree 5 (Radon, 1948)."""
    if nodes in (3, 4):
        return [(1 / math.factorial(nodes - 1), np.vstack([-np.ones((1, nodes - 1)), np.eye(nodes - 1)]))]
    found, root = [], math.sqrt(15.0)
    places = [(9 / 40, 1 / 3, 1 / 3)]
    for w, a in (((155 - root) / 1200, (6 - root) / 21), ((155 + root) / 1200, (6 + root) / 21)):
        places += [(w, a, a), (w, 1 - 2 * a, a), (w, a, 1 - 2 * a)]
    for w, r, s in places:
        t = 1 - r - s
        by_r = [1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s]
        by_s = [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]
        found.append((w / 2, np.array([by_r, by_s]).T))
    return found


def element(kind: str) -> dict[str, float]:
    """Largest differences of force and tangent, of the largest, over large random displacements; stress of a rotation, of E."""
    model = one_element(kind)
    random, worst = np.random.default_rng(3), {"force": 0.0, "tangent": 0.0}
    start = np.array([node.at for node in model.nodes.values()], float)
    size, dim = start.shape
    for _ in range(5):
        x = start + 0.4 * random.standard_normal((size, dim))
        exact = _lagrangian_flat(kind, start, x)
        found = _holding(model, x)
        worst["force"] = max(worst["force"], float(np.abs(found - exact).max() / np.abs(exact).max()))
        K = dynamics.linearise(
            model, x, dofs=[f"{name}.{axis}" for name in model.nodes for axis in "xyz"[:dim]]
        ).stiffness.values
        steps = x + 1e-30j * np.eye(x.size).reshape(-1, size, dim)
        by_step = -np.array([_lagrangian_flat(kind, start, y).imag / 1e-30 for y in steps])
        worst["tangent"] = max(worst["tangent"], float(np.abs(K - by_step).max() / np.abs(by_step).max()))
    turned = start @ _rotation(dim).T
    stress = strength.elements(model, turned, "one").stress.values
    return worst | {"rotation": float(np.abs(stress).max() / 210e9)}


def _holding(model: Model, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces of the element on its nodes (v dim,), N, at positions x (v, dim): minus the reactions of nodes held there."""
    held, still = model.with_(fixed=list(model.nodes)), np.zeros((1, *x.shape))
    motion = kinematics.from_arrays(held, [0.0], x[None], still, still)
    reaction = dynamics.inverse(held, motion, static=False).reaction.sel(support=list(model.nodes))
    return -np.asarray(reaction.values[0]).reshape(-1)


def _lagrangian_flat(kind: str, start: NDArray[Any], x: NDArray[Any]) -> NDArray[Any]:
    """`lagrangian` of positions (v, dim), as (v dim,)."""
    dim = start.shape[1]
    deep = ((0, 0), (0, 3 - dim))
    return lagrangian(kind, np.pad(start, deep), np.pad(x, deep))[:, :dim].reshape(-1)


def _rotation(dim: int) -> NDArray[np.float64]:
    c, s = math.cos(2.1), math.sin(2.1)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    about_x = np.array([[1.0, 0, 0], [0, math.cos(0.7), -math.sin(0.7)], [0, math.sin(0.7), math.cos(0.7)]])
    return np.asarray((about_x @ about_z) if dim == 3 else about_z[:2, :2])


def patch(kind: str) -> dict[str, float]:
    """Largest difference from the displacements of a patch of uneven elements under uniform stress, of the largest."""
    if kind == "tetrahedra":
        grid = meshes.box(size=(1.0, 1.0, 1.0), cells=(2, 2, 2))
        inner, axes = grid.nearest((0.5, 0.5, 0.5)), "xyz"
    else:
        grid = meshes.rectangle(width=1.0, height=1.0, columns=3, rows=3, six_nodes=kind != "triangles")
        inner, axes = grid.nearest((1 / 3, 1 / 3)), "xy"
    points = grid.points.copy()
    if kind in ("triangles", "tetrahedra"):
        points[grid.names.index(inner)] += 0.1
    shaped = meshes.mesh(points, grid.elements)
    held = {"n0": axes}
    for name, at in zip(shaped.names[1:], shaped.points[1:].tolist(), strict=True):
        keep = "".join(axis for axis, coordinate in zip(axes, at, strict=True) if coordinate == 0)
        if keep:
            held[name] = keep
    force = _pulled(shaped, 1e6, (1, 2, 1) if kind == "four" else (2 / 3, 8 / 3, 2 / 3))
    fields: dict[str, Any] = {"fixed": held, "material": STEEL, "nodes": shaped.nodes}
    fields["loads"] = {f"at {n}".replace(" ", "_"): NodalForce(node=n, force=f) for n, f in force.items()}
    if kind == "tetrahedra":
        model = Model(**fields, solids={"p": shaped.solid()})
    else:
        strain = "linear" if kind == "linear" else "constant"
        model = Model(**fields, membranes={"p": shaped.membrane(thickness=1.0, strain=strain)})
    found = statics.linear(model).displacement.values
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
    grid = meshes.rectangle(width=LENGTH, height=DEPTH, columns=columns, rows=rows, six_nodes=six).moved((0.0, -DEPTH / 2))
    loads: dict[str, NodalForce] = {}
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
        loads |= {f"F{name}": NodalForce(node=name, force=tuple(f)) for name, f in zip(side, push.tolist(), strict=True)}
    fixed = {grid.nearest((0, 0)): "xy", grid.nearest((0, -DEPTH / 2)): "x"}
    model = Model(
        nodes=grid.nodes,
        fixed=fixed,
        loads=loads,
        material=STEEL,
        membranes={"beam": grid.membrane(thickness=1.0, strain=strain)},
    )
    found = statics.linear(model)
    return float(found.displacement.sel(node=grid.nearest((LENGTH, 0)), axis="y")), float(found.energy)


def deflection() -> float:
    """Of the exact solution at the tip, m."""
    E, nu, inertia = STEEL.E, STEEL.poisson, DEPTH**3 / 12
    return END / (6 * E * inertia) * (2 * LENGTH**3 + (4 + 5 * nu) * DEPTH**2 * LENGTH / 4)


def stored() -> float:
    """Strain energy of the exact solution, J: bending and shear."""
    E, nu, inertia = STEEL.E, STEEL.poisson, DEPTH**3 / 12
    return END**2 * LENGTH**3 / (6 * E * inertia) + 3 * END**2 * LENGTH * 2 * (1 + nu) / (5 * E * DEPTH)


def order(strain: str) -> dict[str, float]:
    """Order of convergence of the energy, and Richardson's limit of the tip's deflection, m."""
    coarse, fine = (16, 32) if strain == "constant" else (8, 16)
    (one, energy_one), (two, energy_two) = cantilever(strain, coarse), cantilever(strain, fine)
    share = 4.0 if strain == "constant" else 16.0
    power = math.log2((stored() - energy_one) / (stored() - energy_two))
    return {"order": power, "limit": (share * two - one) / (share - 1)}


def waves() -> dict[str, float]:
    """Lowest frequencies, Hz, of a bar of tetrahedra whose material has no Poisson's ratio, guided along x."""
    found = []
    for cells in (8, 16):
        grid = meshes.box(size=(1.0, 0.02, 0.02), cells=(cells, 1, 1))
        fixed = dict.fromkeys(grid.names, "yz") | dict.fromkeys(grid.at(x=0.0), "xyz")
        bar = Material(E=70e9, density=2700.0, poisson=0.0)
        model = Model(nodes=grid.nodes, fixed=fixed, solids={"bar": grid.solid(material=bar)})
        found.append(dynamics.linearise(model).frequency.values[:2])
    limit = (4 * found[1] - found[0]) / 3
    return {"first": float(limit[0]), "second": float(limit[1])}


def vibration() -> dict[str, float]:
    """Largest change of the energy of freely moving elements, of the energy, by energy-momentum steps."""
    grid = meshes.box(size=(1.0, 0.3, 0.3), cells=(2, 1, 1))
    rubber = Material(E=1e6, density=1000.0, poisson=0.3)
    random = np.random.default_rng(1)
    velocities = {name: tuple(v) for name, v in zip(grid.names, (3 * random.standard_normal((18, 3))).tolist(), strict=False)}
    model = Model(nodes=grid.nodes, solids={"block": grid.solid(material=rubber)}, velocities=velocities)
    run = dynamics.simulate(model, t_end=0.5, samples=101, method=EnergyMomentum(step=1e-3))
    energy, spin = run.data["energy"].values, run.data["angular_momentum"].values
    turned = float(np.ptp(spin, axis=0).max() / np.abs(spin).max())
    return {"energy": float(np.ptp(energy) / energy[0]), "spin": turned}


def cases() -> Iterator[Case]:
    """Differences against 0, of the quantity itself."""
    for kind in KINDS:
        yield Case(f"solids.element.{kind}.force", LAGRANGE, 0.0, 1e-13, element, (kind,), ("force",), 1.0)
        yield Case(f"solids.element.{kind}.tangent", COMPLEX, 0.0, 1e-13, element, (kind,), ("tangent",), 1.0)
        yield Case(f"solids.element.{kind}.rotation", RIGID, 0.0, 1e-14, element, (kind,), ("rotation",), 1.0)
    for kind in ("triangles", "four", "linear", "tetrahedra"):
        yield Case(f"solids.patch.{kind}", PATCH, 0.0, 1e-13, patch, (kind,), ("displacement",), 1.0)
    for strain, power, good, near in (("constant", 2.0, 0.03, 3e-3), ("linear", 4.0, 0.03, 1e-5)):
        yield Case(f"solids.cantilever.{strain}.order", ORDER, power, good, order, (strain,), ("order",))
        yield Case(f"solids.cantilever.{strain}.deflection", BEAM, deflection(), near, order, (strain,), ("limit",))
    speed = math.sqrt(70e9 / 2700.0)
    yield Case("solids.bar.first", WAVES, speed / 4, 1e-5, waves, (), ("first",))
    yield Case("solids.bar.second", WAVES, 3 * speed / 4, 1e-3, waves, (), ("second",))
    yield Case("solids.vibration.energy", ENERGY, 0.0, 1e-12, vibration, (), ("energy",), 1.0)
    yield Case(
        "solids.vibration.spin", Reference("identity", "angular momentum is kept"), 0.0, 1e-12, vibration, (), ("spin",), 1.0
    )
