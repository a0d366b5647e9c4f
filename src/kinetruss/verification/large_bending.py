"""Beams far from small strains and small rotations: thick, compressed, flexible in shear; frames that snap, buckle and spin."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.optimize import brentq

import kinetruss as kt
from kinetruss.verification.beams import line, row
from kinetruss.verification.measures import Numbers

STRIP = kt.Rectangle(width=3.2024e-3, height=12.377e-3)
"""That of the Princeton beam experiment."""


def _section(EA: float, EI: float, **more: float) -> dict[str, Any]:
    """Section and material with E = EA, as arguments of a model."""
    section = kt.General(area=1.0, I2=EI / EA, I3=EI / EA, c2=0.1, c3=0.1, **more)
    return {"section": section, "material": kt.Material(E=EA, density=1.0, poisson=0.25)}


def heavy(count: int) -> Numbers:
    """Tip of a cantilever of slenderness 20 under its weight."""
    places = [(2.0 * i / count, 0.0) for i in range(count + 1)]
    own = row(places, **_section(1e6, 1e6 / 1200), gravity=(0.0, -9.81))
    model = kt.Model(**own | {"material": kt.Material(E=1e6, density=78.0)})
    x, y = kt.statics.equilibrium(model).position.sel(node=f"N{count}")
    return {"x": x - 2.0, "y": y}


def column(count: int, strain: float) -> Numbers:
    """Load at which a clamped-free column loses its stiffness over P of P (1 - P/EA) = pi^2 E I/(4 L^2), P/EA near `strain`."""
    euler = math.pi**2 / 4
    EA = euler / strain
    exact = 0.5 * EA * (1 - math.sqrt(1 - 4 * strain))
    parts = row(line(count), **_section(EA, 1.0))

    def stiffness(load: float) -> float:
        push = kt.NodalForce(node=f"N{count}", force=(-load, 0.0))
        model = kt.Model(**parts, loads={"P": push})
        # in balance: straight and shorter by P/EA
        at = np.array([node.at for node in model.whole.nodes.values()])
        at[:, 0] -= load / EA * np.array([int(name.partition(".")[0][1:]) / count for name in model.whole.nodes])
        return float(np.linalg.eigvals(kt.dynamics.linearise(model, at).stiffness.values).real.min())

    return {"load": brentq(stiffness, 0.9 * exact, 1.1 * exact) / exact}


def column_order(strain: float) -> Numbers:
    """Order in which this load converges, from 4 to 8 elements."""
    coarse, fine = (abs(column(count, strain)["load"] - 1) for count in (4, 8))
    return {"order": math.log2(coarse / fine)}


def timoshenko(dim: int) -> Numbers:
    """One beam that is flexible in shear, under an end load and under a load along it: deflection over that of the theory."""
    EI, GA, side = 2.0, 30.0, {"orientation": (0.0, 1.0, 0.0)} if dim == 3 else {}
    section = kt.General(area=1.0, I2=0.02, I3=0.02, c2=0.1, c3=0.1, J=0.03, A2=GA / 40, A3=GA / 40)
    beam = row(line(1, dim), section=section, beams={"b0": kt.Beam(ends=("N0", "N1"), **side)})
    beam["material"] = kt.Material(E=100.0, density=1.0, poisson=0.25)
    end = kt.NodalForce(node="N1", force=(0.0, -0.01, 0.0)[:dim])
    found = {}
    for name, load, exact in (
        ("end", end, 0.01 * (1 / (3 * EI) + 1 / GA)),
        ("along", kt.MemberLoad(member="b0", force=(0.0, -0.01, 0.0)[:dim]), 0.01 * (1 / (8 * EI) + 1 / (2 * GA))),
    ):
        moved = kt.statics.linear(kt.Model(**beam, loads={"P": load})).displacement
        found[name] = -moved.sel(node="N1", axis="y") / exact
    return found


def sheared(count: int) -> Numbers:
    """Tip of a cantilever that bends by 0.66 of its length, with shear strains of up to 6 %."""
    push = kt.NodalForce(node=f"N{count}", force=(-20.0, 60.0))
    model = kt.Model(**row(line(count), **_section(1e4, 25.0, A2=0.25, A3=0.25), loads={"P": push}))
    x, y = kt.statics.equilibrium(model).position.sel(node=f"N{count}")
    return {"x": x, "y": y}


def diamond(count: int, load: float) -> Numbers:
    """A square frame on its corner, hinged at top and bottom: how far top and sides move from the middle."""
    a, EI = math.sqrt(0.5), 1.0
    corners = {"B": (0.0, -a), "R": (a, 0.0), "T": (0.0, a), "L": (-a, 0.0)}
    nodes, beams = dict(corners), dict[str, kt.Beam]()
    for one, two in (("R", "B"), ("R", "T"), ("L", "B"), ("L", "T")):
        p, q = (np.array(corners[name]) for name in (one, two))
        names = [one, *(f"{one}{two}{i}" for i in range(1, count)), two]
        nodes |= {name: tuple((p + (q - p) * i / count).tolist()) for i, name in enumerate(names)}
        ends = pairwise(names)
        beams |= {f"{one}{two}.{i}": kt.Beam(ends=pair, release=[two] if two in pair else []) for i, pair in enumerate(ends)}
    parts = _section(4.8e7 * EI, EI)
    push = kt.NodalForce(node="T", force=(0.0, load * EI))
    frame = kt.Model(nodes=nodes, beams=beams, fixed={"B": "xy", "T": "x"}, loads={"P": push}, **parts)
    found = kt.statics.equilibrium(frame).position
    return {"top": 0.5 * (found.sel(node="T", axis="y") + a) - a, "side": a - found.sel(node="R", axis="x")}


def toggle(count: int) -> Numbers:
    """Largest and least load of a toggle of two shallow legs, clamped at their feet."""
    span, rise = 12.943, 0.386
    places = [(span * i / count, rise * (1 - abs(i / count - 1))) for i in range(2 * count + 1)]
    push = kt.NodalForce(node=f"N{count}", force=(0.0, -1.0))
    parts = row(places, **_section(1.885e6, 9.27e3), loads={"P": push}) | {"clamped": ["N0", f"N{2 * count}"]}
    found = kt.statics.path(kt.Model(**parts), "P", to=60.0, points=200, step=0.002, largest_step=0.01)
    high, low = found.limit_points[:2]
    return {"high": high, "low": low}


def lee(count: int) -> Numbers:
    """Largest load of Lee's frame; count : elements of the loaded fifth of its beam."""
    each = 24.0 / count
    up = [(0.0, each * i) for i in range(5 * count + 1)]
    places = up + [(each * i, 120.0) for i in range(1, 5 * count + 1)]
    last, loaded = f"N{10 * count}", f"N{6 * count}"
    push = kt.NodalForce(node=loaded, force=(0.0, -1.0))
    parts = row(places, **_section(4320.0, 1440.0), loads={"P": push}) | {"clamped": [], "fixed": {"N0": "xy", last: "xy"}}
    found = kt.statics.path(kt.Model(**parts), "P", to=2.5, points=60)
    return {"high": found.limit_points[0]}


def princeton(count: int, load: float, degrees: float) -> Numbers:
    """Tip of the strip of the Princeton beam experiment under a load at an angle from its wide side."""
    places = [(0.508 * i / count, 0.0, 0.0) for i in range(count + 1)]
    beams = {f"b{i}": kt.Beam(ends=(f"N{i}", f"N{i + 1}"), orientation=(0.0, 1.0, 0.0)) for i in range(count)}
    angle = math.radians(degrees)
    push = kt.NodalForce(node=f"N{count}", force=(0.0, load * math.cos(angle), load * math.sin(angle)))
    parts = row(places, section=STRIP, loads={"P": push}) | {"beams": beams}
    model = kt.Model(**parts | {"material": kt.Material(E=71.7e9, density=2770.0, poisson=0.31)})
    _, y, z = kt.statics.equilibrium(model).position.sel(node=f"N{count}")
    return {"wide": y, "narrow": z}


def right_angle(count: int) -> Numbers:
    """Load in its plane at which a strip bent at a right angle buckles sideways."""
    leg = 240.0
    places = [(leg * i / count, 0.0, 0.0) for i in range(count + 1)]
    places += [(leg, -leg * i / count, 0.0) for i in range(1, count + 1)]
    beams = {f"b{i}": kt.Beam(ends=(f"N{i}", f"N{i + 1}"), orientation=(1.0, 1.0, 0.0)) for i in range(2 * count)}
    push = kt.NodalForce(node=f"N{2 * count}", force=(1.0, 0.0, 0.0))
    parts = row(places, section=kt.Rectangle(width=0.6, height=30.0), loads={"P": push}) | {"beams": beams}
    frame = kt.Model(**parts | {"material": kt.Material(E=71240.0, density=1.0, poisson=0.31)})
    return {"load": kt.statics.buckling(frame, "P", modes=1).load_factor[0]}


def spinning(count: int) -> Numbers:
    """Stretch of a rod that spins, kept over a turn, over that of the closed form from which it starts."""
    EA, line_mass, length, w = 2.8e7, 1.2, 10.0, 6.0
    k = w * math.sqrt(line_mass / EA)
    places = [(length * i / count, 0.0) for i in range(count + 1)]
    parts = row(places, **_section(EA, 1.4e4)) | {"clamped": [], "fixed": ["N0"]}
    model = kt.Model(**parts | {"material": kt.Material(E=EA, density=line_mass)})
    start = np.array([node.at for node in model.whole.nodes.values()])
    for i, name in enumerate(model.whole.nodes):
        at = places[int(name.partition(".")[0][1:])][0]
        # r = sin(k s)/(k cos(k L))
        start[i, 0] += math.sin(k * at) / (k * math.cos(k * length)) - at
    rate = w * np.column_stack([-start[:, 1], start[:, 0]])
    method = kt.GeneralizedAlpha(step=2e-3)
    run = kt.dynamics.simulate(model, 1.0, samples=201, positions=start, velocities=rate, method=method)
    reach = np.linalg.norm(run.motion.position.sel(node=f"N{count}").values, axis=1) - length
    return {"stretch": reach.mean() / (math.tan(k * length) / k - length)}
