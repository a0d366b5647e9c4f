"""Frequencies of beams, frames and grids of textbooks and validation manuals, and a column under its own weight."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.measures import Numbers, modes
from kinetruss.verification.textbook_frames import CLAMP, PIN, ROLLER, STIFF, matter, section, seven_storeys

LIGHT = 1e-7
"""Mass of beams that have none, of the masses on them."""


def frequencies(count: int, **parts: Any) -> Any:
    """The first frequencies of a model, Hz."""
    return np.sort(kt.dynamics.linearise(kt.Model(**parts)).frequency.values)[:count]


def divided(nodes: dict[str, Any], members: dict[str, Any], parts: int) -> dict[str, Any]:
    """Nodes and beams of members from node to node (name -> ends), each of several equal beams."""
    nodes, beams = dict(nodes), {}
    for name, (a, b) in members.items():
        ways = np.linspace(nodes[a], nodes[b], parts + 1)[1:-1]
        inner = {f"{name}.{k}": tuple(way) for k, way in enumerate(ways, 1)}
        nodes |= inner
        for k, ends in enumerate(pairwise([a, *inner, b])):
            beams[f"{name}.{k}"] = kt.Beam(ends=ends)
    return {"nodes": nodes, "beams": beams}


def short_beam() -> Numbers:
    """SDLL01: a short beam on two supports, flexible in shear; bending and stretching modes."""
    area, inertia = 0.02, 2e-4 / 3
    return modes(
        frequencies(
            6,
            **divided({"A": (0.0, 0.0), "B": (1.0, 0.0)}, {"b": ("A", "B")}, 80),
            supports={"A": PIN, "B": ROLLER},
            section=section(area, inertia, shear=area / 1.17692),
            material=matter(2e11, 2e11 / 2.6, 7800.0),
        )
    )


def folded_beam() -> Numbers:
    """SDLL02: a slender cantilever folded back on itself, its halves 0.1 mm apart."""
    places = {"A": (0.0, 0.0), "B": (0.5, 0.0), "C": (0.0, 1e-4)}
    return modes(
        frequencies(
            8,
            **divided(places, {"out": ("A", "B"), "back": ("B", "C")}, 16),
            supports={"A": CLAMP},
            section=section(2.5e-4 * STIFF, 0.05 * 0.005**3 / 12),
            material=matter(2.1e11, density=7800.0 / STIFF),
        )
    )


def mass_on_spring(share: float) -> Numbers:
    """SDLL04: a beam on two supports and, over its quarter, a mass on a spring; the mass as a share of the beam's."""
    beam = divided({"A": (0.0, 0.0), "D": (2.5, 0.0), "B": (10.0, 0.0)}, {"AD": ("A", "D"), "DB": ("D", "B")}, 10)
    beam["nodes"] |= {"C": kt.Node(at=(2.5, 1.0), mass=share * 780.0)}
    spring = kt.Spring(coordinate=kt.DistanceCoordinate(nodes=("C", "D")), stiffness=75979.1 * share)
    return modes(
        frequencies(
            3,
            **beam,
            supports={"A": PIN, "B": ROLLER},
            fixed={"C": "x"},
            springs={"k": spring},
            section=section(0.01 * STIFF, 0.39e-5),
            material=matter(2e11, density=7800.0 / STIFF),
        )
    )


def crossed_beams() -> Numbers:
    """SDLL08: two beams on supports and a third pinned to their middles: frequencies, and the response to a force on it."""
    at = {"A": (-2.5, -2.5), "B": (-2.5, 0), "C": (-2.5, 2.5), "D": (2.5, -2.5), "E": (2.5, 0), "F": (2.5, 2.5), "G": (0, 0)}
    places = {name: (*map(float, place), 0.0) for name, place in at.items()}
    parts = divided(places, {ends: tuple(ends) for ends in ("AB", "BC", "DE", "EF", "BG", "GE")}, 6)
    for name, end in (("BG.0", "B"), ("GE.5", "E")):
        parts["beams"][name] = parts["beams"][name].with_(release=(end,))
    model = kt.Model(
        **parts,
        fixed=dict.fromkeys(parts["nodes"], "xy") | dict.fromkeys("ACDF", "xyz"),
        section=section(2.872e-3 * STIFF, 1.943e-5, J=1.0),
        material=matter(2e11, density=7800.0 / STIFF),
    )
    small = kt.dynamics.linearise(model, inputs=["G.z"], outputs=["B.z", "G.z"])
    found = modes(np.sort(small.frequency.values)[:3])
    for node in "BG":
        found[f"{node}.shaken"] = -1e5 * complex(small.frequency_response(80.0, of=f"{node}.z", wrt="G.z").item()).real
    return found


def mass_at_the_tip() -> Numbers:
    """SDLL15: a tube with a mass at its end, without rotary inertia in the plane; and in space on an arm across it."""
    area, inertia = math.pi / 4 * (0.35**2 - 0.32**2), math.pi / 64 * (0.35**4 - 0.32**4)
    plane = divided({"A": (0.0, 0.0), "B": (10.0, 0.0)}, {"b": ("A", "B")}, 16)
    plane["nodes"]["B"] = kt.Node(at=(10.0, 0.0), mass=1000.0)
    straight = frequencies(
        4,
        **plane,
        supports={"A": CLAMP},
        section=section(area * STIFF, inertia),
        material=matter(2.1e11, density=7800.0 / STIFF),
    )
    space = divided({"A": (0.0, 0.0, 0.0), "B": (10.0, 0.0, 0.0)}, {"b": ("A", "B")}, 12)
    space["nodes"]["P"] = kt.Node(at=(10.0, 1.0, 0.0), mass=1000.0)
    space["beams"]["arm"] = kt.Beam(ends=("B", "P"), kind="rigid", mass=0)
    tube = kt.Tube(outer=0.35, inner=0.32)
    beside = frequencies(2, **space, clamped=["A"], section=tube, material=matter(2.1e11, 2.1e11 / 2.6, 7800.0))
    return {"straight": modes(straight), "beside": modes(beside)}


def two_storeys() -> Numbers:
    """SDLX01: a plane frame of two storeys."""
    places = {"A": (-0.3, 0.0), "B": (-0.3, 0.36), "C": (-0.3, 0.81), "D": (0.3, 0.81), "E": (0.3, 0.36), "F": (0.3, 0.0)}
    return modes(
        frequencies(
            9,
            **divided(places, {ends: tuple(ends) for ends in ("AB", "BC", "CD", "DE", "EF", "BE")}, 8),
            clamped=["A", "F"],
            section=section(0.029 * 0.0048, 0.029 * 0.0048**3 / 12),
            material=matter(2.1e11, density=7850.0),
        )
    )


def three_masses() -> Numbers:
    """Ghali and Neville, example 24.2: masses 4, 1 and 1 on a cantilever; angular frequencies over sqrt(E I/(m L^3))."""
    nodes = {f"N{k}": kt.Node(at=(0.0, float(k)), mass=(0, 1, 1, 4)[k]) for k in range(4)}
    found = frequencies(
        3,
        nodes=nodes,
        beams={f"b{k}": ends for k, ends in enumerate(pairwise(nodes))},
        clamped=["N0"],
        section=section(STIFF, 1.0),
        material=matter(1.0, density=LIGHT / STIFF),
    )
    return modes(2 * math.pi * found)


def beam_on_two_springs() -> Numbers:
    """Timoshenko, Young and Weaver, problem 1.1-3: a weight on a beam on two springs, pounds and inches; its period, s."""
    found = frequencies(
        1,
        nodes={"A": (0.0, 0.0), "M": kt.Node(at=(84.0, 0.0), mass=1000 / 386.088), "B": (120.0, 0.0)},
        beams={"AM": ("A", "M"), "MB": ("M", "B")},
        supports={"A": kt.Support(y=300.0), "B": kt.Support(y=300.0)},
        fixed={"M": "x"},
        section=section(1.0, 1.0),
        material=matter(3e7, density=LIGHT),
    )
    return {"period": 1 / found[0]}


def ten_bays() -> Numbers:
    """Bathe and Wilson: a frame of ten bays and nine storeys, its mass in its nodes; squares of angular frequencies."""
    nodes, beams = {}, {}
    for i in range(11):
        for k in range(10):
            length = 10.0 * ((k > 0) + (0 < k < 9)) + 20.0 * ((i > 0) + (i < 10)) * (k > 0)
            nodes[f"N{i}.{k}"] = kt.Node(at=(20.0 * i, 10.0 * k), mass=1.5 * length if k else 0.0)
            if k:
                beams[f"column{i}.{k}"] = kt.Beam(ends=(f"N{i}.{k - 1}", f"N{i}.{k}"))
            if k and i:
                beams[f"girder{i}.{k}"] = kt.Beam(ends=(f"N{i - 1}.{k}", f"N{i}.{k}"))
    found = frequencies(
        3,
        nodes=nodes,
        beams=beams,
        clamped=[f"N{i}.0" for i in range(11)],
        section=section(3.0, 1.0),
        material=matter(432000.0, density=LIGHT),
    )
    return modes((2 * math.pi * found) ** 2)


def seven_storeys_swaying() -> Numbers:
    """Periods of the frame of `seven_storeys`, s."""
    found = np.sort(kt.dynamics.linearise(seven_storeys(density=1e-10)).frequency.values)[:7]
    return modes(1 / found)


def own_weight() -> Numbers:
    """SSLL403: a clamped column that its own weight buckles."""
    column = divided({"A": (0.0, 0.0), "B": (0.0, 1.0)}, {"b": ("A", "B")}, 16)
    weight = {f"w{name}": kt.MemberLoad(member=name, force=(0.0, -7800 * 1e-4 * 9.81)) for name in column["beams"]}
    model = kt.Model(**column, supports={"A": CLAMP}, section=section(1e-4, 1e-8 / 12), material=matter(2e11), loads=weight)
    return {"factor": kt.statics.buckling(model, dict.fromkeys(weight, 1.0), modes=1).load_factor[0]}
