"""Beams, frames, grids and trusses of textbooks and validation manuals in linear statics, in the units of their sources.

Every model has consistent units: newtons and metres, or kips (pounds) and inches, so that the printed digits can be compared.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import kinetruss as kt
from kinetruss.verification.measures import Numbers

CLAMP, PIN, ROLLER = kt.Support(x="held", y="held", rotation="held"), kt.Support(x="held", y="held"), kt.Support(y="held")
STIFF = 1e3
"""Area of members of which the source counts bending alone."""


def section(
    area: float, inertia: float, side: float | None = None, J: float | None = None, shear: float | None = None
) -> kt.General:
    """A section: second moments about axis 3 and, by default the same, about 2 (`side`); shear : its shear areas."""
    return kt.General(area=area, I2=side or inertia, I3=inertia, c2=1.0, c3=1.0, J=J, A2=shear, A3=shear)


def matter(E: float, G: float | None = None, density: float = 0.0) -> kt.Material:
    """A material of a modulus of elasticity and, where it counts, of a shear modulus."""
    return kt.Material(E=E, density=density, poisson=0.3 if G is None else E / (2 * G) - 1)


def solve(**parts: Any) -> Any:
    """Linear statics of a model."""
    return kt.statics.linear(kt.Model(**parts))


def moved(found: Any, node: str) -> Numbers:
    """Displacement of a node, and its rotation about the axes if it is the end of a beam."""
    shift = {f"u{axis}": found.displacement.sel(node=node, axis=axis) for axis in found.axis.values}
    if "node_rotation" not in found.data or node not in found.data.node_rotation.frame.values:
        return shift
    turn = found.data.node_rotation.sel(frame=node)
    return shift | {f"r{axis}": turn.sel(about=axis) for axis in turn.about.values}


def held(found: Any, node: str) -> Numbers:
    """Reaction of a support: forces and, where there are some, moments."""
    names = {f"F{axis}": found.reaction.sel(support=node, axis=axis) for axis in found.axis.values}
    if "reaction_moment" in found.data and node in found.data.reaction_moment.support.values:
        moment = found.data.reaction_moment.sel(support=node)
        names |= {f"M{axis}": moment.sel(rotation=axis) for axis in moment.rotation.values}
    return names


def down(node: str, force: float) -> kt.NodalForce:
    """A force down on a node of a plane model."""
    return kt.NodalForce(node=node, force=(0.0, -force))


def along(model: kt.Model, found: Any, stations: int = 2) -> Any:
    """Bending moments (beam, station) of a plane model."""
    return kt.strength.beams(model, found, stations=stations).section_M.sel(moment="3")


def side_links() -> Numbers:
    """SSLL10: four beams that meet in A, one of them hinged; a force on AD, a load along AB. Rotation and moments at A."""
    sides = {"AB": 0.04, "AC": 0.01, "AD": 0.01, "AE": 0.02}
    model = kt.Model(
        nodes={"A": (0, 0), "B": (4, 0), "C": (0, 1), "D": (-1, 0), "E": (0, -2)},
        beams={name: kt.Beam(ends=tuple(name), section=section(STIFF, side**4 / 12)) for name, side in sides.items()},
        supports={"B": CLAMP, "C": PIN, "D": CLAMP, "E": CLAMP},
        material=matter(2e11),
        loads={
            "F": kt.MemberPointForce(member="AD", force=(0.0, -1e5), at=0.5),
            "p": kt.MemberLoad(member="AB", force=(0.0, -1e3)),
        },
    )
    found = kt.statics.linear(model)
    moments = abs(along(model, found).isel(station=0))
    return {"turn": moved(found, "A")["rz"]} | {name: moments.sel(beam=name) for name in sides}


def hinged_portal(case: str) -> Numbers:
    """SSLL14: a portal with a pitched roof and hinged feet, under one of four loads or all. Ridge C, foot A."""
    column, rafter = section(STIFF, 5e-4), section(STIFF, 2.5e-4)
    loads = {
        "along": kt.MemberLoad(member="DC", force=(0.0, -3000.0)),
        "ridge": down("C", 20e3),
        "side": kt.NodalForce(node="D", force=(-10e3, 0.0)),
        "couple": kt.BodyCouple(body="D", moment=-100e3),
    }
    found = solve(
        nodes={"A": (0, 0), "D": (0, 8), "C": (10, 12), "E": (20, 8), "B": (20, 0)},
        fixed=["A", "B"],
        beams={
            name: kt.Beam(ends=tuple(name), section=column if name in ("AD", "EB") else rafter)
            for name in ("AD", "DC", "CE", "EB")
        },
        material=matter(2.1e11),
        loads=loads if case == "all" else {case: loads[case]},
    )
    return {"C": moved(found, "C"), "A": held(found, "A")}


def ball_and_springs() -> Numbers:
    """SSLL04: two elbows in space that share a ball joint, on springs; a force at a corner."""
    k = 52500.0
    found = solve(
        nodes={"A": (0, 2, 1), "D": (0, 0, 1), "H": (0, 0, 0), "C": (0, 0, -1), "B": (2, 0, -1)},
        beams={"AD": ("A", "D"), "DH": ("D", "H"), "HC": kt.Beam(ends=("H", "C"), release=("H",)), "CB": ("C", "B")},
        supports={
            "A": kt.Support(x="held", y=k, z="held", rotation_x=k, rotation_y="held", rotation_z=k),
            "B": kt.Support(x=k, y="held", z="held", rotation_x="held", rotation_y=k, rotation_z=k),
        },
        section=section(1e-3, 1e-6, J=2e-6),
        material=matter(2.1e11, 2.1e11 / (2 * (1 + 1 / 3))),
        loads={"F": kt.NodalForce(node="D", force=(0.0, 0.0, -10e3))},
    )
    return {"A": moved(found, "A"), "C": moved(found, "C"), "MA": held(found, "A")}


def linked_cantilevers() -> Numbers:
    """SSLL05: two parallel cantilevers whose ends a rigid piece joins; a force on one."""
    found = solve(
        nodes={"A": (0, 0), "B": (2, 0), "C": (0, -0.2), "D": (2, -0.2)},
        beams={"AB": ("A", "B"), "CD": ("C", "D"), "BD": kt.Beam(ends=("B", "D"), kind="rigid", mass=0)},
        supports={"A": CLAMP, "C": CLAMP},
        section=section(STIFF, 4e-8 / 3),
        material=matter(2e11),
        loads={"F": down("D", 1e3)},
    )
    return {"uy": moved(found, "D")["uy"], "MA": held(found, "A")["Mz"], "MC": held(found, "C")["Mz"]}


def four_bars() -> Numbers:
    """SSLL11: a truss of four bars of two sections."""
    found = solve(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0.5, 0.5), "D": (2, 1)},
        fixed=["A", "B"],
        bars={
            name: kt.Bar(ends=tuple(name), section=section(2e-4 if name in ("AC", "BC") else 1e-4, 1e-9))
            for name in ("AC", "BC", "CD", "BD")
        },
        material=matter(1.962e11),
        loads={"F": down("D", 9810.0)},
    )
    return {"C": moved(found, "C"), "D": moved(found, "D")}


TRUSS = {
    "A": (0, 0), "N01": (0, 4), "N02": (5, 0), "E": (10, 4), "N03": (15, 0), "B": (20, -4), "N04": (20, 4), "F": (30, 4),
    "C": (35, 0), "D": (25, 0),
}  # fmt: skip
TRUSS_BARS = (
    "A N01, A N02, N01 N02, N01 E, N02 E, N02 N03, E N03, E N04, N03 N04, N03 B, B N04, B D, N04 D, N04 F, D F, D C, F C"
)


def inclined_roller(case: str) -> Numbers:
    """SSLL12: a truss on a roller on a slope of 30 degrees, once redundant: under two forces, or as its supports settle."""
    one, two = section(1.41e-3, 1e-6), section(4 * 3.58942e-3 * (0.2 - 3.58942e-3), 1e-6)
    names = [f"M{k:02}" for k in range(1, 18)]
    bars = {
        name: kt.Bar(
            ends=tuple(ends.split()), section=one if name in ("M01", "M03", "M05", "M07", "M09", "M13", "M15", "M17") else two
        )
        for name, ends in zip(names, TRUSS_BARS.split(", "), strict=True)
    }
    settled = {"A": -0.020, "B": -0.030, "C": -0.015} if case == "settled" else dict.fromkeys("ABC", 0.0)
    vertical = {name: kt.Restraint(settlement=way) if way else "held" for name, way in settled.items()}
    found = solve(
        nodes=TRUSS,
        bars=bars,
        supports={
            "A": kt.Support(x="held", y=vertical["A"]),
            "B": kt.Support(y=vertical["B"]),
            "C": kt.Support(y=vertical["C"], turned=math.pi / 6),
        },
        material=matter(2.1e11),
        loads={} if case == "settled" else {"E": down("E", 150e3), "F": down("F", 100e3)},
    )
    return {name: found.member_force.sel(member=name) for name in names}


def settled_middle() -> Numbers:
    """Sennett, section 3.8: a beam over two spans, clamped at one end, whose middle support sinks. Moments and reactions."""
    found = solve(
        nodes={"A": (0, 0), "B": (120, 0), "C": (240, 0)},
        beams={"AB": ("A", "B"), "BC": ("B", "C")},
        supports={"A": CLAMP, "B": kt.Support(y=kt.Restraint(settlement=-0.25)), "C": ROLLER},
        section=section(1.0, 1.0),
        material=matter(2.9e6),
    )
    A, B, C = (held(found, name) for name in "ABC")
    return {"A": A["Fy"], "MA": A["Mz"], "B": B["Fy"], "C": C["Fy"]}


def hinge_in_frame() -> Numbers:
    """Sennett, example 7.4: a portal on pins, with one hinge at a corner, under a side load. Displacement of the corner."""
    found = solve(
        nodes={"A": (0, 0), "B": (0, 120), "C": (120, 120), "D": (120, 0)},
        fixed=["A", "D"],
        beams={"AB": kt.Beam(ends=("A", "B"), release=("B",)), "BC": ("B", "C"), "DC": ("D", "C")},
        section=section(10.0, 100.0),
        material=matter(29e6),
        loads={"P": kt.NodalForce(node="B", force=(1000.0, 0.0))},
    )
    return {"ux": moved(found, "B")["ux"], "uy": moved(found, "B")["uy"]}


def weaver() -> Numbers:
    """Weaver, problem 8: a space frame of three members, forces and a couple. Displacements of both joints, kips and inches."""
    L = 120.0
    found = solve(
        nodes={"J1": (0, L, 0), "J2": (2 * L, L, 0), "J3": (0, 0, 0), "J4": (3 * L, 0, L)},
        clamped=["J3", "J4"],
        beams={"b31": ("J3", "J1"), "b12": ("J1", "J2"), "b24": ("J2", "J4")},
        section=section(11.0, 56.0, J=83.0),
        material=matter(30000.0, 12000.0),
        loads={
            "F": kt.NodalForce(node="J1", force=(2.0, 0.0, 0.0)),
            "P": kt.NodalForce(node="J2", force=(0.0, -1.0, 0.0)),
            "M": kt.BodyCouple(body="J2", moment=(0.0, 0.0, -120.0)),
        },
    )
    return {"J1": moved(found, "J1"), "J2": moved(found, "J2"), "J3": held(found, "J3"), "J4": held(found, "J4")}


def three_legs() -> Numbers:
    """Logan, example 5.8: a node on three legs in space, a force and a couple. Displacement and rotation, kips and inches."""
    found = solve(
        nodes={"N1": (0, 0, 0), "N2": (-100, 0, 0), "N3": (0, 0, -100), "N4": (0, -100, 0)},
        clamped=["N2", "N3", "N4"],
        beams={"a": ("N2", "N1"), "b": ("N3", "N1"), "c": ("N4", "N1")},
        section=section(10.0, 100.0, J=50.0),
        material=matter(30000.0, 10000.0),
        loads={
            "F": kt.NodalForce(node="N1", force=(0.0, -50.0, 0.0)),
            "M": kt.BodyCouple(body="N1", moment=(-1000.0, 0.0, 0.0)),
        },
    )
    return moved(found, "N1")


def beam_on_springs() -> Numbers:
    """McGuire, Gallagher and Ziemian, example 4.15: a beam on fifteen springs under a force in its middle; kips, inches."""
    names = [f"N{k}" for k in range(17)]
    model = kt.Model(
        nodes={name: (15.0 * k, 0.0) for k, name in enumerate(names)},
        beams={f"b{k}": ends for k, ends in enumerate(pairwise(names))},
        supports={name: kt.Support(y=22.5) for name in names[1:-1]} | {"N0": PIN, "N16": ROLLER},
        section=section(10.3, 128.5),
        material=matter(29000.0),
        loads={"P": down("N8", 40.0)},
    )
    found = kt.statics.linear(model)
    return {"uy": moved(found, "N8")["uy"], "M": along(model, found).sel(beam="b8")[0]}


def three_legs_of_steel() -> Numbers:
    """Sennett, section 6.4: three clamped legs in space under a couple at their common end; of one leg the forces, the
    moment at the couple and the torque, pounds and inches.
    """
    L = 180.0
    found = solve(
        nodes={"J1": (L, 0, L), "J2": (0, 0, L), "J3": (L, L, L), "J4": (L, 0, 0)},
        clamped=["J2", "J3", "J4"],
        beams={
            "a": kt.Beam(ends=("J1", "J2"), orientation=(0.0, 0.0, 1.0)),
            "b": kt.Beam(ends=("J3", "J1"), orientation=(0.0, 0.0, 1.0)),
            "c": kt.Beam(ends=("J1", "J4"), orientation=(1.0, 0.0, 0.0)),
        },
        section=section(7.08, 82.8, 18.3, J=0.35),
        material=matter(29e6, 11.15e6),
        loads={"M": kt.BodyCouple(body="J1", moment=(0.0, 41000 * 12, 0.0))},
    )
    foot = held(found, "J2")
    return {"Fx": abs(foot["Fx"]), "Fz": abs(foot["Fz"]), "M": abs(foot["Fz"]) * L - foot["My"], "T": abs(foot["Mx"])}


def settled_spans() -> Numbers:
    """Kassimali, example 13.14: three spans under a load along them, as three supports sink. Reactions, kips."""
    names = "ABCD"
    sunk = {"B": -0.625, "C": -1.5, "D": -0.75}
    found = solve(
        nodes={name: (240.0 * k, 0.0) for k, name in enumerate(names)},
        beams={"".join(ends): ends for ends in pairwise(names)},
        supports={"A": PIN} | {name: kt.Support(y=kt.Restraint(settlement=way)) for name, way in sunk.items()},
        section=section(20.0, 7800.0),
        material=matter(29000.0),
        loads={f"q{a}": kt.MemberLoad(member=a + b, force=(0.0, -2 / 12)) for a, b in pairwise(names)},
    )
    return {name: held(found, name)["Fy"] for name in names}


def lund_frame() -> Numbers:
    """CALFEM, exs_beam2: a portal, one foot clamped and one hinged, a side force, a load along the girder."""
    column = section(2e-3, 1.6e-5)
    found = solve(
        nodes={"A": (0, 0), "B": (0, 4), "C": (6, 4), "D": (6, 0)},
        supports={"A": CLAMP, "D": PIN},
        beams={
            "AB": kt.Beam(ends=("A", "B"), section=column),
            "DC": kt.Beam(ends=("D", "C"), section=column),
            "BC": kt.Beam(ends=("B", "C"), section=section(6e-3, 5.4e-5)),
        },
        material=matter(200e9),
        loads={"P": kt.NodalForce(node="B", force=(2e3, 0.0)), "q": kt.MemberLoad(member="BC", force=(0.0, -10e3))},
    )
    return {"A": held(found, "A"), "D": {name: held(found, "D")[name] for name in ("Fx", "Fy")}, "B": moved(found, "B")}


def lund_braced() -> Numbers:
    """CALFEM, exs_beambar2: a clamped beam held up by two bars, under a load along two thirds of it."""
    found = solve(
        nodes={"A": (0, 2), "B": (2, 2), "C": (4, 2), "D": (6, 2), "F": (0, 0)},
        supports={"A": CLAMP},
        fixed=["F"],
        beams={"AB": ("A", "B"), "BC": ("B", "C"), "CD": ("C", "D")},
        bars={
            "FB": kt.Bar(ends=("F", "B"), section=section(1e-3, 1e-9)),
            "FC": kt.Bar(ends=("F", "C"), section=section(1e-3, 1e-9)),
        },
        section=section(4e-3, 5.4e-5),
        material=matter(200e9),
        loads={name: kt.MemberLoad(member=name, force=(0.0, -10e3)) for name in ("BC", "CD")},
    )
    return {"A": held(found, "A"), "F": {n: held(found, "F")[n] for n in ("Fx", "Fy")}} | {
        name: found.member_force.sel(member=name) for name in ("FB", "FC")
    }


def end_couples() -> Numbers:
    """Lu, Jia and Tang, example 7.1: two spans of two materials under couples at their three supports. Rotations."""
    found = solve(
        nodes={"A": (0, 0), "B": (5, 0), "C": (12, 0)},
        fixed=["A", "B", "C"],
        beams={
            "AB": kt.Beam(ends=("A", "B"), section=section(1e-3, 1.44e-5), material=matter(3e10)),
            "BC": kt.Beam(ends=("B", "C"), section=section(1e-3, 1.152e-5), material=matter(2.06e11)),
        },
        loads={name: kt.BodyCouple(body=name, moment=M) for name, M in (("A", -15e3), ("B", -25e3), ("C", 35e3))},
    )
    return {name: moved(found, name)["rz"] for name in "ABC"}


SHAPES = {
    "W14X176": (51.7, 2150.0), "W14X211": (62.1, 2670.0), "W14X246": (72.3, 3230.0), "W14X287": (84.4, 3910.0),
    "W24X110": (32.5, 3330.0), "W24X130": (38.3, 4020.0), "W24X160": (47.1, 5120.0),
}  # fmt: skip
"""Area and second moment of rolled sections, in^2 and in^4."""
OUTER, INNER = (246, 246, 246, 211, 211, 176, 176), (287, 287, 287, 246, 246, 211, 211)
GIRDERS = (160, 160, 130, 130, 110, 110, 110)
STOREYS = (162.0, 162.0, *5 * (156.0,))


def seven_storeys(density: float = 0.0, loads: Any = ()) -> kt.Model:
    """A frame of two bays and seven storeys with rigid floors and a mass on each, kips and inches; in sway alone."""
    heights = [sum(STOREYS[:k]) for k in range(8)]
    nodes = {
        f"{c}{k}": kt.Node(at=(x, y)) for k, y in enumerate(heights) for x, c in zip((0.0, 360.0, 720.0), "ABC", strict=True)
    }
    nodes |= {f"B{k}": nodes[f"B{k}"].with_(mass=0.49) for k in range(1, 8)}
    beams, couplings = {}, {}
    for k in range(1, 8):
        for c, size in zip("ABC", (OUTER[k - 1], INNER[k - 1], OUTER[k - 1]), strict=True):
            beams[f"column.{c}{k}"] = kt.Beam(ends=(f"{c}{k - 1}", f"{c}{k}"), section=section(*SHAPES[f"W14X{size}"]))
        for a, b in ("AB", "BC"):
            ends = f"{a}{k}", f"{b}{k}"
            beams[f"girder.{a}{k}"] = kt.Beam(ends=ends, section=section(*SHAPES[f"W24X{GIRDERS[k - 1]}"]))
            terms = tuple((kt.CoordinateDrive(node=node, axis="x"), sign) for node, sign in zip(ends, (1, -1), strict=True))
            couplings[f"floor.{a}{k}"] = kt.Coupling(terms=terms)
    return kt.Model(
        nodes=nodes,
        beams=beams,
        couplings=couplings,
        clamped=["A0", "B0", "C0"],
        fixed={f"B{k}": "y" for k in range(1, 8)},  # in sway the column in the middle moves sideways alone
        material=matter(29500.0, density=density),
        loads=dict(loads),
    )


def seven_storeys_pushed() -> Numbers:
    """Forces on its floors: displacement of the top, axial force and moment at the foot of an outer column."""
    pushes = {f"P{k}": kt.NodalForce(node=f"A{k}", force=(F, 0.0)) for k, F in enumerate((2.5, 5, 7.5, 10, 12.5, 15, 20), 1)}
    found = kt.statics.linear(seven_storeys(loads=pushes))
    foot = held(found, "A0")
    return {"top": moved(found, "A7")["ux"], "N": abs(foot["Fy"]), "M": abs(foot["Mz"])}
