"""Formulas of collections for beams and frames: linear statics over the formula, critical loads as they are."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import kinetruss as kt
from kinetruss.verification.measures import Numbers
from kinetruss.verification.textbook_frames import CLAMP, PIN, ROLLER, STIFF, along, down, held, matter, moved, section, solve
from kinetruss.verification.textbook_modes import divided

SPAN, BEGIN, LINE, RISE = 3.0, 1.2, 700.0, 1100.0
"""A beam, the place where its load begins, the load there and its further rise up to the end."""
EI = 5e4


def part_of_a_span() -> Numbers:
    """A load that rises from a place to the end of a beam whose far end is clamped: on a support in front, or clamped."""
    q, a, L = LINE, BEGIN, SPAN
    parts: dict[str, Any] = {
        "nodes": {"A": (0, 0), "B": (L, 0)},
        "beams": {"b": ("A", "B")},
        "section": section(1.0, 1.0),
        "material": matter(EI),
        "loads": {"q": kt.MemberLoad(member="b", force=(0.0, -q), start=a, shape=(1.0, 1 + RISE / q))},
    }
    propped, both = (held(solve(**parts, supports={"A": foot, "B": CLAMP}), "A") for foot in (ROLLER, CLAMP))
    cube = (L - a) ** 3
    return {
        "propped": propped["Fy"] / (cube / L**3 * (q / 8 * (3 * L + a) + RISE / 40 * (4 * L + a))),
        "clamped": both["Fy"] / (cube / L**3 * (q / 2 * (L + a) + RISE / 20 * (3 * L + 2 * a))),
        "clamped.M": both["Mz"] / (cube / L**2 * (q / 12 * (L + 3 * a) + RISE / 60 * (2 * L + 3 * a))),
    }


def couple_on_a_span() -> Numbers:
    """A couple on a beam on a support and a clamp."""
    found = solve(
        nodes={"A": (0, 0), "B": (SPAN, 0)},
        beams={"b": ("A", "B")},
        supports={"A": ROLLER, "B": CLAMP},
        section=section(1.0, 1.0),
        material=matter(EI),
        loads={"M": kt.MemberPointCouple(member="b", moment=400.0, at=BEGIN)},
    )
    return {"couple": held(found, "A")["Fy"] * 2 * SPAN**3 / (3 * 400.0 * (SPAN**2 - BEGIN**2))}


def equal_spans() -> Numbers:
    """Three equal spans under a load along all of them: reactions over q l, moment over the inner supports over q l^2."""
    names = "ABCD"
    model = kt.Model(
        nodes={name: (SPAN * k, 0.0) for k, name in enumerate(names)},
        beams={a + b: (a, b) for a, b in pairwise(names)},
        supports={"A": PIN} | dict.fromkeys("BCD", ROLLER),
        section=section(1.0, 1.0),
        material=matter(EI),
        loads={a + b: kt.MemberLoad(member=a + b, force=(0.0, -LINE)) for a, b in pairwise(names)},
    )
    found = kt.statics.linear(model)
    moment = along(model, found).sel(beam="BC")[0]
    return {
        "outer": held(found, "A")["Fy"] / (LINE * SPAN),
        "inner": held(found, "B")["Fy"] / (LINE * SPAN),
        "M": -moment / (LINE * SPAN**2),
    }


def hinged_beam() -> Numbers:
    """A Gerber beam: supports at 0, 6 and 12 m, a hinge at 8 m, a load along it. Reactions over q, moment at the support."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (6, 0), "H": (8, 0), "C": (12, 0)},
        beams={"AB": ("A", "B"), "BH": kt.Beam(ends=("B", "H"), release=("H",)), "HC": ("H", "C")},
        supports={"A": PIN, "B": ROLLER, "C": ROLLER},
        section=section(1.0, 1.0),
        material=matter(EI),
        loads={name: kt.MemberLoad(member=name, force=(0.0, -LINE)) for name in ("AB", "BH", "HC")},
    )
    found = kt.statics.linear(model)
    return {name: held(found, name)["Fy"] / LINE for name in "ABC"} | {"M": -along(model, found).sel(beam="BH")[0] / LINE}


def portals() -> Numbers:
    """Portals under a load along the girder, hinged and clamped: thrust and moments at corner and foot, over the formulas."""
    h, L, ratio = 4.0, 7.0, 2.5
    k = ratio * h / L
    corner = {"hinged": LINE * L**2 / (4 * (2 * k + 3)), "clamped": LINE * L**2 / (6 * (k + 2))}
    thrust = {"hinged": corner["hinged"] / h, "clamped": LINE * L**2 / (4 * h * (k + 2))}
    found: Numbers = {}
    for feet, support in (("hinged", PIN), ("clamped", CLAMP)):
        model = kt.Model(
            nodes={"A": (0, 0), "B": (0, h), "C": (L, h), "D": (L, 0)},
            beams={
                "AB": ("A", "B"),
                "DC": ("D", "C"),
                "BC": kt.Beam(ends=("B", "C"), section=section(STIFF**2, ratio)),
            },
            supports={"A": support, "D": support},
            section=section(STIFF**2, 1.0),
            material=matter(EI),
            loads={"q": kt.MemberLoad(member="BC", force=(0.0, -LINE))},
        )
        bent = kt.statics.linear(model)
        found[f"{feet}.thrust"] = held(bent, "A")["Fx"] / thrust[feet]
        found[f"{feet}.corner"] = -along(model, bent).sel(beam="BC")[0] / corner[feet]
    found["clamped.foot"] = abs(held(bent, "A")["Mz"]) * 2 / corner["clamped"]
    return found


def slack_diagonal() -> Numbers:
    """A frame of pins, 15 by 12, with two ties that cross, pushed by 50: the tie that pulls over 50 sqrt(369)/15; the other."""
    found = solve(
        nodes={"A": (0, 0), "B": (0, 12), "C": (15, 12), "D": (15, 0)},
        fixed=["A", "D"],
        bars={
            "AB": ("A", "B"), "BC": ("B", "C"), "DC": ("D", "C"),
            "AC": kt.Bar(ends=("A", "C"), kind="cable"), "DB": kt.Bar(ends=("D", "B"), kind="cable"),
        },
        section=section(2e-3, 1e-6),
        material=matter(2e11),
        loads={"W": kt.NodalForce(node="B", force=(50.0, 0.0))},
    )  # fmt: skip
    pull, other = (found.member_force.sel(member=name) for name in ("AC", "DB"))
    return {"pulls": pull * 15 / (50 * math.sqrt(369)), "slack": other}


def on_a_foundation() -> Numbers:
    """A beam of 240 on two supports and on 159 springs of 0.15 each, under a force in its middle: deflection over Hetenyi's."""
    names, P, k, rigidity = [f"N{i}" for i in range(161)], 40.0, 0.1, 29000.0 * 128.5
    found = solve(
        nodes={name: (1.5 * i, 0.0) for i, name in enumerate(names)},
        beams={f"b{i}": ends for i, ends in enumerate(pairwise(names))},
        supports={name: kt.Support(y=1.5 * k) for name in names[1:-1]} | {names[0]: PIN, names[-1]: ROLLER},
        section=section(10.3, 128.5),
        material=matter(29000.0),
        loads={"P": down("N80", P)},
    )
    scale = (k / (4 * rigidity)) ** 0.25
    u = scale * 240
    wanted = P * scale / (2 * k) * (math.sinh(u) - math.sin(u)) / (math.cosh(u) + math.cos(u))
    return {"deflection": -moved(found, "N80")["uy"] / wanted}


def critical_portals() -> Numbers:
    """Square portals under equal loads on their corners, hinged or clamped, free to sway or held: P h^2/(E I)."""
    places: dict[str, Any] = {"A": (0.0, 0.0), "B": (0.0, 1.0), "C": (1.0, 1.0), "D": (1.0, 0.0)}
    found = {}
    for feet, support in (("hinged", PIN), ("clamped", CLAMP)):
        for head, more in (("free", {}), ("held", {"B": kt.Support(x="held")})):
            frame = kt.Model(
                **divided(places, {ends: tuple(ends) for ends in ("AB", "BC", "DC")}, 8),
                supports={"A": support, "D": support, **more},
                section=section(STIFF**2, 1.0),
                material=matter(1.0),
                loads={name: down(name, 1.0) for name in "BC"},
            )
            found[f"{feet}.{head}"] = kt.statics.buckling(frame, {"B": 1.0, "C": 1.0}, modes=1).load_factor[0]
    return found
