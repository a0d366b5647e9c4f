"""Loads on beams and bars against the formulas of beam theory; combinations of loads; a mass that meets a stop."""

from __future__ import annotations

import math
from typing import Any

import kinetruss as kt
from kinetruss.verification.measures import Numbers

STEEL = kt.Material(E=200e9, density=0.0)
SQUARE = kt.Rectangle(width=0.02, height=0.02)
LINE, LENGTH = 120.0, 1.6
MASS, SPEED, GAP = 2.0, 3.0, 0.6


def _beam(load: Any, *clamped: str, pieces: int = 2) -> kt.Model:
    """Beams without mass, from N0 along x over 1.6 m, under loads along each of them: load(begin, end) as fractions."""
    names = [f"N{i}" for i in range(pieces + 1)]
    return kt.Model(
        nodes={name: (LENGTH * i / pieces, 0.0) for i, name in enumerate(names)},
        beams={f"b{i}": (names[i], names[i + 1]) for i in range(pieces)},
        clamped=clamped,
        loads={f"q{i}": load(i / pieces, (i + 1) / pieces, f"b{i}") for i in range(pieces)},
        section=SQUARE,
        material=STEEL,
    )


def _triangle(begin: float, end: float, beam: str) -> kt.MemberLoad:
    """Down, from 0 at the left end of all beams to LINE at the right."""
    return kt.MemberLoad(member=beam, force=(0.0, -LINE), shape=(begin, end))


def triangle() -> Numbers:
    """A load that rises from 0 at N0 to q at the other end, L = 1.6 m: on a cantilever held at N0 the deflection over
    q L^4/(E I) and the moment over q L^2; on a beam clamped at both ends the moments over q L^2.
    """
    EI, whole = STEEL.E * SQUARE.second_moments[1], LINE * LENGTH**2
    cantilever, held = _beam(_triangle, "N0"), _beam(_triangle, "N0", "N2")
    bent = kt.statics.linear(cantilever)
    moment = kt.strength.beams(cantilever, bent, stations=2).section_M.sel(moment="3")
    ends = kt.strength.beams(held, kt.statics.linear(held), stations=2).section_M.sel(moment="3")
    return {
        "deflection": -bent.displacement.sel(node="N2", axis="y") * EI / (whole * LENGTH**2),
        "clamp": -moment[0][0] / whole,
        "clamp.0": -ends[0][0] / whole,
        "clamp.q": -ends[1][1] / whole,
    }


def part() -> Numbers:
    """A bar on two supports, L = 1.6 m, under q on its last quarter: reactions over q L, moment under the begin over q L^2."""
    bar = kt.Model(
        nodes={"A": (0, 0), "B": (LENGTH, 0), "D": (LENGTH, -1)},
        fixed=["A", "D"],
        bars={"bar": ("A", "B"), "post": ("D", "B")},
        loads={"q": kt.MemberLoad(member="bar", force=(0.0, -LINE), start=0.75 * LENGTH)},
        section=SQUARE,
        material=STEEL,
    )
    forces = kt.runs.forces_at_rest(bar)
    left, right = (forces.reaction.sel(support=name, axis="y")[0] / (LINE * LENGTH) for name in "AD")
    moment = kt.strength.sections(bar, forces, [0.75]).data.section_M.sel(part="bar", moment="3").values.item()
    return {"left": left, "right": right, "moment": abs(moment) / (LINE * LENGTH**2)}


def bounce(exponent: float, damping: float) -> Numbers:
    """A mass that meets a stop at 3 m/s, with the contact force k d^n (1 + damping d'): its speed before over that after, as
    c (v + w) = ln((1 + c v)/(1 - c w)) has them, off 1; without damping the duration over pi sqrt(m/k) for n = 1.
    """
    runner = kt.Model(
        nodes={"O": (-1, 0), "P": kt.Node(at=(0, 0), mass=MASS)},
        fixed={"O": "xy", "P": "y"},
        bars={"eye": kt.Bar(ends=("O", "P"), kind="free")},
        velocities={"P": (SPEED, 0.0)},
        stops={
            "wall": kt.Stop(
                coordinate=kt.CoordinateDrive(node="P", axis="x"),
                upper=GAP,
                stiffness=800.0,
                exponent=exponent,
                damping=damping,
            )
        },
    )
    run = kt.dynamics.simulate(runner, 1.0, samples=3, method=kt.DOP853(rtol=1e-12, atol=1e-13))
    after = -float(run.motion.velocity.sel(node="P", axis="x")[-1])
    begin, end = (one.time for one in run.events)
    if not damping:
        return {
            "speed": after / SPEED,
            "lasts": (end - begin) / (math.pi * math.sqrt(MASS / 800.0)),
            "meets": begin * SPEED / GAP,
        }
    return {"speed": math.log((1 + damping * SPEED) / (1 - damping * after)) / (damping * (SPEED + after))}


def at_a_place() -> Numbers:
    """A force and a couple at a quarter of a beam of 1.6 m: on a cantilever the deflection over P L^3/(E I) and C L^2/(E I); on
    a beam clamped at both ends the moments of the clamps over P L and C, and the jumps of shear force and moment over P and C.
    """
    EI, P, C = STEEL.E * SQUARE.second_moments[1], 70.0, 30.0
    loads = {
        "force": kt.MemberPointForce(member="b0", force=(0.0, -P), at="25 %"),
        "couple": kt.MemberPointCouple(member="b0", moment=C, at=0.25 * LENGTH),
    }
    found: Numbers = {}
    for name, one, scale in (("force", loads["force"], -P * LENGTH), ("couple", loads["couple"], C)):
        cantilever, held = (_beam(lambda *_, one=one: one, *ends, pieces=1) for ends in (("N0",), ("N0", "N1")))
        bent = kt.statics.linear(cantilever).displacement.sel(node="N1", axis="y")
        cut = kt.strength.beams(held, kt.statics.linear(held), stations=[0.25, math.nextafter(0.25, 1.0)]).isel(beam=0)
        found[name] = bent * EI / (scale * LENGTH**2)
        found[f"{name}.clamp.near"], found[f"{name}.clamp.far"] = (abs(one) / abs(scale) for one in cut.end_moment.values[:, 0])
        jump = cut.section_V[:, 0] if name == "force" else cut.section_M[:, 0]
        found[f"{name}.jump"] = abs(jump[1] - jump[0]) / (P if name == "force" else C)
    return found


def snow() -> Numbers:
    """Two rafters with three hinges, span 4 m, rise 1.5 m, under snow s per projected length: thrust over s l^2/f, reaction
    over s l, moment in the middle of a rafter over s l^2.
    """
    span, rise = 4.0, 1.5
    roof = kt.Model(
        nodes={"A": (0, 0), "C": (span / 2, rise), "B": (span, 0)},
        fixed=["A", "B"],
        bars={"left": ("A", "C"), "right": ("B", "C")},
        loads={name: kt.MemberLoad(member=name, force=(0.0, -LINE), per="projection") for name in ("left", "right")},
        section=SQUARE,
        material=STEEL,
    )
    forces = kt.runs.forces_at_rest(roof)
    held = forces.reaction.sel(support="A")[0].values / LINE
    moment = kt.strength.sections(roof, forces, [0.5]).data.section_M.sel(part="left", moment="3").values.item()
    return {"thrust": held[0] * rise / span**2, "reaction": held[1] / span, "moment": abs(moment) / (LINE * span**2)}


def combinations() -> Numbers:
    """Dead load, imposed load B, snow and wind by EN 1990, 6.10: how many combinations; largest and least vertical and
    horizontal force of 10, 6 and 4 kN down and 5 kN across. By ASCE 7-16, LRFD, of D, L, S and W.
    """
    kinds = (("G", "permanent", "D", (0, -10e3)), ("Q", "imposed B", "L", (0, -6e3)), ("S", "snow", "S", (0, -4e3)))
    found: Numbers = {}
    for name, code, column in (("en", kt.En1990(), 1), ("asce", kt.Asce7(), 2)):
        every = (*kinds, ("W", "wind", "W", (5e3, 0)))
        model = kt.Model(
            nodes={"A": (0, 0)},
            loads={one[0]: kt.NodalForce(node="A", force=one[3]) for one in every},
            load_cases={one[0]: kt.LoadCase(loads={one[0]: 1}, category=one[column]) for one in every},
            combinations={"uls": code},
        )
        cases = [one.loads or {} for label, one in model.cases.items() if label not in model.load_cases]
        down = [10 * case["G"] + 6 * case.get("Q", 0) + 4 * case.get("S", 0) for case in cases]
        found |= {f"{name}.count": len(cases), f"{name}.most": max(down), f"{name}.least": min(down)}
        found[f"{name}.across"] = max(5 * case.get("W", 0) for case in cases)
    return found
