"""Supports that yield, settle, are turned or have a gap, and frames on them: values over their closed forms."""

from __future__ import annotations

import math
from typing import Any

import kinetruss as kt
from kinetruss.verification.measures import Numbers

E, SIDE = 200e9, 0.1
EI = E * SIDE**4 / 12
MATTER: dict[str, Any] = {"section": kt.Rectangle(width=SIDE, height=SIDE), "material": kt.Material(E=E, density=0.0)}
SPAN, LOAD, PARTS = 2.0, 1200.0, 16
PIN, ROLLER = kt.Support(x="held", y="held"), kt.Support(y="held")
CLAMP = kt.Support(x="held", y="held", rotation="held")


def _row(*places: float, forces: Any = (), **supports: kt.Support) -> Any:
    """Linear statics of beams along x, with forces down on nodes N0, N1, ..."""
    nodes = {f"N{k}": (x, 0.0) for k, x in enumerate(places)}
    beams = {f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(len(places) - 1)}
    loads = {node: kt.NodalForce(node=node, force=(0.0, -force)) for node, force in dict(forces).items()}
    return kt.statics.linear(kt.Model(nodes=nodes, beams=beams, supports=supports, loads=loads, **MATTER))


def _up(found: Any, node: str) -> float:
    return float(found.reaction.sel(support=node, axis="y"))


def settled() -> Numbers:
    """A prop that sinks by d, 3 E I d/L^3 and 3 E I d/L^2; a clamp that turns by a, 3 E I a/L."""
    sunk = _row(0, SPAN, N0=CLAMP, N1=kt.Support(y=kt.Restraint(settlement=-4e-3)))
    foot = kt.Support(x="held", y="held", rotation=kt.Restraint(settlement=2e-3))
    turned = _row(0, SPAN, N0=foot, N1=ROLLER)
    return {
        "prop": -_up(sunk, "N1") * SPAN**3 / (3 * EI * 4e-3),
        "clamp": float(sunk.reaction_moment[0, 0]) * SPAN**2 / (3 * EI * 4e-3),
        "turned": float(turned.reaction_moment[0, 0]) * SPAN / (3 * EI * 2e-3),
    }


def yielding() -> Numbers:
    """A clamp c and a prop k that yield: P L^3/(3 E I) + P L^2/c; P k/(k + 3 E I/L^3)."""
    c, k = 4e5, 2e5
    soft = _row(0, SPAN, forces={"N1": LOAD}, N0=kt.Support(x="held", y="held", rotation=c))
    propped = _row(0, SPAN, forces={"N1": LOAD}, N0=CLAMP, N1=kt.Support(y=k))
    wanted = LOAD * SPAN**3 / (3 * EI) + LOAD * SPAN**2 / c
    return {
        "deflection": -float(soft.displacement.sel(node="N1", axis="y")) / wanted,
        "prop": _up(propped, "N1") * (k + 3 * EI / SPAN**3) / (LOAD * k),
    }


def one_sided() -> Numbers:
    """A gap g below a tip, c (P - k g)/(k + c); a support that the beam lifts off; a roller on a slope, P/(2 cos a)."""
    k, c, g, a = 3 * EI / SPAN**3, 4e6, 1e-3, math.radians(35)
    met = _row(0, SPAN, forces={"N1": 20 * k * g}, N0=CLAMP, N1=kt.Support(y=kt.Restraint(stiffness=c, gap=g)))
    presses = kt.Support(y=kt.Restraint(stiffness=1e12, gap=(0, None)))
    lifted = _row(0, SPAN / 2, SPAN, 2 * SPAN, forces={"N1": LOAD}, N0=PIN, N2=ROLLER, N3=presses)
    slope = _row(0, SPAN / 2, SPAN, forces={"N1": LOAD}, N0=PIN, N2=kt.Support(y="held", turned=a))
    return {
        "gap": _up(met, "N1") * (k + c) / (19 * k * g * c),
        "lifted": 2 * _up(lifted, "N0") / LOAD,
        "slope": float(slope.reaction_own.sel(support="N2", axis="y")) * 2 * math.cos(a) / LOAD,
    }


def _column(height: float, parts: int = PARTS, **supports: kt.Support) -> float:
    """The load at which a column of beams buckles, N; its ends are N0 and N1."""
    names = ["N0", *(f"M{k}" for k in range(1, parts)), "N1"]
    nodes = {name: (0.0, height * k / parts) for k, name in enumerate(names)}
    beams = {f"b{k}": (names[k], names[k + 1]) for k in range(parts)}
    loads = {"P": kt.NodalForce(node="N1", force=(0.0, -1.0))}
    found = kt.statics.buckling(kt.Model(nodes=nodes, beams=beams, supports=supports, loads=loads, **MATTER), "P")
    return float(found.load_factor[0])


def euler() -> Numbers:
    """Euler's four cases, over pi^2 E I/l^2."""
    upright, guided = kt.Support(x="held"), kt.Support(x="held", rotation="held")
    unit = math.pi**2 * EI / 16.0
    return {
        "clamped_free": _column(4.0, N0=CLAMP) / unit,
        "pinned": _column(4.0, N0=PIN, N1=upright) / unit,
        "clamped_pinned": _column(4.0, N0=CLAMP, N1=upright) / unit,
        "clamped": _column(4.0, N0=CLAMP, N1=guided) / unit,
    }


def foot() -> Numbers:
    """z tan z = c l/(E I), z = l sqrt(P/E I), of a free column whose foot turns with the stiffness c."""
    c, height = 1.5e6, 3.0
    z = height * math.sqrt(_column(height, N0=kt.Support(x="held", y="held", rotation=c)) / EI)
    return {"foot": z * math.tan(z) * EI / (c * height)}
