"""Beams: cantilever, torsion, circle, elastica, the bend of 45 degrees, frequencies, buckling, a frame, motion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

STEEL = kt.Material(E=200e9, density=7800.0)
SQUARE = kt.Rectangle(width=0.02, height=0.02)
LOAD, TORQUE = 10.0, 7.0


def row(places: Any, **more: Any) -> dict[str, Any]:
    """Beams from place to place, clamped at the first, as arguments of a model."""
    names = [f"N{i}" for i in range(len(places))]
    return {
        "nodes": {name: tuple(map(float, place)) for name, place in zip(names, places, strict=True)},
        "beams": {f"b{i}": (names[i], names[i + 1]) for i in range(len(names) - 1)},
        "clamped": names[:1],
        **more,
    }


def line(count: int, dim: int = 2, length: float = 1.0) -> list[tuple[float, ...]]:
    """Places along x."""
    return [(length * i / count, 0.0, 0.0)[:dim] for i in range(count + 1)]


def cantilever(dim: int) -> dict[str, float]:
    """One beam under an end load and under its weight: deflection and moments, of their closed forms; twist in space."""
    side = {"orientation": (0.0, 1.0, 0.0)} if dim == 3 else {}
    base = row(line(1, dim), material=STEEL, section=SQUARE) | {"beams": {"b0": kt.Beam(ends=("N0", "N1"), **side)}}
    EI = STEEL.E * SQUARE.second_moments[1]
    model = kt.Model(**base, loads={"P": kt.NodalForce(node="N1", force=(0.0, -LOAD, 0.0)[:dim])})
    bent = kt.statics.linear(model)
    M = kt.strength.beams(model, bent, stations=3).section_M.sel(moment="3").values[0]
    found = {"deflection": -bent.displacement.sel(node="N1", axis="y").item() * 3 * EI / LOAD}
    found |= {"clamp": -M[0] / LOAD, "middle": -M[1] / LOAD, "end": M[2] / LOAD}
    heavy = kt.Model(**base, gravity=(0.0, -9.81, 0.0)[:dim])
    M = kt.strength.beams(heavy, kt.statics.linear(heavy), stations=3).section_M.sel(moment="3").values[0]
    weight = STEEL.density * SQUARE.area * 9.81
    found |= {"weight.clamp": -2 * M[0] / weight, "weight.middle": -8 * M[1] / weight}
    if dim == 3:
        twisted = kt.Model(**base, loads={"T": kt.BodyCouple(body="N1", moment=(TORQUE, 0.0, 0.0))})
        moved = kt.statics.linear(twisted)
        turn = (moved.displacement.sel(node="N1.d2") - moved.displacement.sel(node="N1")).sel(axis="z").item()
        arm = twisted.nodes["N1.d2"].at[1]
        GJ = STEEL.E / 2.6 * SQUARE.torsion_constant
        found["twist"] = turn / arm * GJ / TORQUE
    return found


def circle(count: int) -> dict[str, float]:
    """A thin strip under the end moment 2 pi E I/L: distance of its ends (L = 1) and rotation over 2 pi."""
    strip = kt.Rectangle(width=0.1, height=5e-4)
    moment = 2 * math.pi * STEEL.E * strip.second_moments[1]
    loads = {"M": kt.BodyCouple(body=f"N{count}", moment=moment)}
    found = kt.statics.equilibrium(kt.Model(**row(line(count), material=STEEL, section=strip, loads=loads)))
    at = found.position.sel(node=f"N{count}").values
    d = found.position.sel(node=f"N{count}.d1").values - at
    return {"gap": float(np.linalg.norm(at)), "turn": math.atan2(d[1], d[0]) / (2 * math.pi) + 1.0}


def elastica(count: int, load: float) -> dict[str, float]:
    """Tip of a slender cantilever under the end load `load` E I/L^2, L = 1: deflection and shortening."""
    strip = kt.Rectangle(width=0.1, height=5e-4)
    force = load * STEEL.E * strip.second_moments[1]
    loads = {"P": kt.NodalForce(node=f"N{count}", force=(0.0, force))}
    found = kt.statics.equilibrium(kt.Model(**row(line(count), material=STEEL, section=strip, loads=loads)))
    x, y = found.position.sel(node=f"N{count}").values
    return {"deflection": y, "shortening": 1 - x}


def elastica_order(exact: float) -> dict[str, float]:
    """Order in which the deflection under 5 E I/L^2 converges, from 8 to 16 elements."""
    coarse, fine = (abs(elastica(count, 5)["deflection"] / exact - 1) for count in (8, 16))
    return {"order": math.log2(coarse / fine)}


def bend(count: int, load: float) -> dict[str, float]:
    """Tip of the 45-degree bend of radius 100 under a load across its plane; the coordinates are those of the source."""
    section = kt.General(area=1.0, I2=1 / 12, I3=1 / 12, c2=0.5, c3=0.5, J=1 / 6)
    material = kt.Material(E=1e7, density=1.0, poisson=0.0)
    angles = np.linspace(0.0, math.pi / 4, count + 1)
    places = [(100 * math.sin(a), 100 * (1 - math.cos(a)), 0.0) for a in angles]
    loads = {"P": kt.NodalForce(node=f"N{count}", force=(0.0, 0.0, load))}
    found = kt.statics.equilibrium(kt.Model(**row(places, section=section, material=material, loads=loads)))
    x, y, z = found.position.sel(node=f"N{count}").values
    return {"x": y, "y": x, "z": z}


def frequencies(count: int) -> dict[str, float]:
    """First angular frequencies over sqrt(E I/(rho A L^4)): clamped-free, clamped-clamped, free-free, and their order."""
    wire = kt.Rod(diameter=1e-3)
    base = row(line(count), material=STEEL, section=wire)
    scale = math.sqrt(STEEL.E * wire.second_moments[1] / (STEEL.density * wire.area))
    last = f"N{count}"
    held = {"clamped_free": ["N0"], "clamped_clamped": ["N0", last], "free_free": []}
    found = {}
    for name, clamped in held.items():
        all_of = kt.dynamics.linearise(kt.Model(**base | {"clamped": clamped})).frequency.values * 2 * math.pi / scale
        found[name] = float(all_of[all_of > 1e-3][0])
    return found


def frequency_order() -> dict[str, float]:
    """Order of the clamped-free frequency, from 2 to 4 elements."""
    exact = 1.8751040687119611**2
    coarse, fine = (abs(frequencies(count)["clamped_free"] / exact - 1) for count in (2, 4))
    return {"order": math.log2(coarse / fine)}


def buckling(count: int) -> dict[str, float]:
    """Load factor of a clamped-free column over pi^2 E I/(4 L^2)."""
    rod = kt.Rod(diameter=0.01)
    euler = math.pi**2 * STEEL.E * rod.second_moments[1] / 4
    loads = {"P": kt.NodalForce(node=f"N{count}", force=(-euler, 0.0))}
    model = kt.Model(**row(line(count), material=STEEL, section=rod, loads=loads))
    return {"factor": kt.statics.buckling(model, "P", modes=1).load_factor.values[0]}


def portal() -> dict[str, float]:
    """Moments of a portal frame with clamped feet under a side load P, over P h: at the foot and the head of a column."""
    h, width, P = 3.0, 4.0, 1000.0
    section = kt.General(area=1e3, I2=1e-5, I3=1e-5, c2=0.1, c3=0.1)
    model = kt.Model(
        nodes={"A": (0.0, 0.0), "B": (0.0, h), "C": (width, h), "D": (width, 0.0)},
        beams={"left": ("A", "B"), "beam": ("B", "C"), "right": ("D", "C")},
        clamped=["A", "D"],
        section=section,
        material=STEEL,
        loads={"P": kt.NodalForce(node="B", force=(P / 2, 0.0)), "Q": kt.NodalForce(node="C", force=(P / 2, 0.0))},
    )
    M = kt.strength.beams(model, kt.statics.linear(model), stations=2).section_M.sel(beam="left", moment="3").values
    return {"foot": abs(M[0]) / (P * h), "head": abs(M[1]) / (P * h)}


def motion() -> dict[str, float]:
    """A free beam that bends and tumbles: changes of its energy and momenta, of the largest."""
    soft = kt.Material(E=2e8, density=7800.0)
    parts = row(line(2, 3), material=soft, section=kt.Rectangle(width=0.02, height=0.01)) | {"clamped": []}
    model = kt.Model(**parts, velocities={"N0": (0.0, -2.0, 0.0), "N2": (0.0, 2.0, 1.0)})
    run = kt.dynamics.simulate(model, 0.05, samples=11)
    found = {}
    for name in ("energy", "momentum", "angular_momentum"):
        values = run.data[name].values.reshape(11, -1)
        found[name] = float(np.abs(values - values[0]).max() / np.abs(values).max())
    return found


def damped(dim: int) -> dict[str, float]:
    """Damping ratios of the first modes of a cantilever over w b/2; work that its damping takes over the energy it loses."""
    delay, axes = 1e-4, slice(dim)
    names = ("N0", "N1", "N2")
    base = row(line(2, dim), material=STEEL, section=SQUARE)
    beams = {f"b{i}": kt.Beam(ends=(names[i], names[i + 1]), damping=delay) for i in range(2)}
    model = kt.Model(**base | {"beams": beams})
    modes = kt.dynamics.linearise(model)
    ratio = modes.modal_damping.values[:3] / (math.pi * modes.frequency.values[:3] * delay)
    start = {name: (0.0, 1.0, 0.5)[axes] for name in model.nodes if name.startswith("N2")}
    run = kt.dynamics.simulate(model.with_(velocities=start), 2e-3, samples=401)
    taken = np.asarray(kt.dynamics.inverse(model, run.motion).dissipation.values)
    step = float(run.data["time"].values[1])
    work = step / 3 * (taken[0] + taken[-1] + 4 * taken[1:-1:2].sum() + 2 * taken[2:-1:2].sum())
    energy = run.energy.values
    return {"ratio": float(np.abs(ratio - 1).max() + 1), "energy": float(work / (energy[0] - energy[-1]))}


def hinged() -> dict[str, float]:
    """Deflection in the middle of a beam, clamped but for a hinge about axis 2 at one end, over P L^3/(E I): along 2 and 3."""
    section = kt.Rectangle(width=0.02, height=0.03)
    found = {}
    for axis, I in zip((1, 2), reversed(section.second_moments), strict=True):
        force = np.eye(3)[axis] * LOAD
        model = kt.Model(
            nodes={"A": (0.0, 0.0, 0.0), "M": (0.5, 0.0, 0.0), "B": (1.0, 0.0, 0.0)},
            beams={
                "a": kt.Beam(ends=("A", "M"), orientation=(0.0, 1.0, 0.0)),
                "b": kt.Beam(ends=("M", "B"), orientation=(0.0, 1.0, 0.0), hinges={"B": 2}),
            },
            clamped=["A", "B"],
            material=STEEL,
            section=section,
            loads={"P": kt.NodalForce(node="M", force=tuple(force))},
        )
        moved = kt.statics.linear(model).displacement.sel(node="M").values[axis]
        found[("along_2", "along_3")[axis - 1]] = float(moved * STEEL.E * I / LOAD)
    return found


def driven() -> dict[str, float]:
    """A beam without mass on a crank that turns half around: its moment at the crank over that of the mass at its tip."""
    mass, gravity = 2.0, np.array([0.0, -9.81])
    model = kt.Model(
        nodes={"O": (0.0, 0.0), "C": (0.5, 0.0), "D": (0.5, 0.2), "T": kt.Node(at=(1.5, 0.0), mass=mass)},
        fixed=["O"],
        bars={"crank": ("O", "C")},
        bodies={"hub": kt.Body(nodes=("O", "C", "D"))},
        beams={"arm": kt.Beam(ends=("C", "T"), mass=0.0)},
        clamped={"C": "hub"},
        drives={"turn": kt.AngleDrive(bar="crank")},
        gravity=tuple(gravity),
        material=STEEL,
        section=SQUARE,
    )
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (0.0, math.pi)}, duration=0.4), samples=21)
    forces = kt.dynamics.inverse(model, motion)
    moment = kt.strength.beams(model, forces, stations=[0.0]).section_M.sel(beam="arm", moment="3", station=0.0).values
    angle, rate, second = (motion.data[f"drive_{name}"].values[:, 0] for name in ("position", "velocity", "acceleration"))
    along, across = np.stack([np.cos(angle), np.sin(angle)], axis=1), np.stack([-np.sin(angle), np.cos(angle)], axis=1)
    radius = 1.5
    push = mass * (gravity - radius * second[:, None] * across + radius * rate[:, None] ** 2 * along)
    exact = along[:, 0] * push[:, 1] - along[:, 1] * push[:, 0]
    light = model.with_(gravity=(0.0, 0.0))
    still: Any = kt.dynamics.inverse(light, motion).static
    shaken = kt.flexible.frequencies(light, still, rigid=("crank",), modes=1).frequency.values[:, 0]
    I = SQUARE.second_moments[1]
    return {
        "moment": float(np.abs(moment - exact).max() / np.abs(exact).max()),
        "frequency": float((2 * math.pi * shaken[-1]) ** 2 * mass / (3 * STEEL.E * I)),
    }
