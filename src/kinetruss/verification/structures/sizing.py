"""Sizing: the lightest of all combinations of a small case, and a truss whose tubes follow by hand."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from kinetruss import design
from kinetruss.library import vgt
from kinetruss.model import Bar, Catalogue, Material, Mission, Model, NodalForce, Node, Run, Spline
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["bracket_task", "cases", "chain_task"]

SIZES = {"14x1": (14, 1), "16x1": (16, 1), "18x1.5": (18, 1.5), "20x1.5": (20, 1.5), "25x2": (25, 2)}
"""Tubes of the small case by name: outer diameter and wall, mm."""

OPTIMUM = {"lower": 0.016, "upper": 0.018, "actuators": 0.018}
"""Outer diameters (m) of the lightest of all 125 combinations in which every utilisation is at most 1."""

MASS = 8.452619335228121
"""Mass of all its members, kg."""

EXHAUSTIVE = Reference(
    "agreement",
    "All 125 combinations of 3 groups and 5 tubes judged by strength.check: the lightest in which everything carries",
)
SETTLED = Reference("agreement", "forces of the finished model and those of the last pass")
BY_HAND = Reference("closed-form", "By hand: N = F/2/sin 60 deg, Euler's load pi^2 E I/l^2")


def chain_task(duration: float = 0.6) -> tuple[Model, Mission]:
    """Two bays that slew so fast that their own masses rule the forces; three groups, five tubes."""
    slew = vgt.slew(2, beta=(0.0, math.radians(14)), gamma=(0.0, math.radians(9)), duration=duration)
    chain = vgt.double_octahedral(2, payload_mass=3.0, base_mass=0.5, material="aluminium_6061_t6")
    tubes = {name: {"outer": f"{outer} mm", "wall": f"{wall} mm"} for name, (outer, wall) in SIZES.items()}
    groups = {
        "lower": ["B1.M[1-6]", "B1.M1[3-8]"],
        "upper": ["B1.M19", "B1.M2[01]", "B2.M[1-6]", "B2.M1[3-9]", "B2.M2[01]"],
        "actuators": ["B?.M7", "B?.M9", "B?.M11"],
    }
    catalogue: Any = {"source": "made up for this case", "material": "aluminium_6061_t6", "tubes": tubes}
    safety: Any = {"yielding": 1.5, "buckling": 3.0}
    mission = Mission(groups=groups, catalogues={"tubes": Catalogue(**catalogue)}, safety=safety)
    return chain.with_(runs={"slew": Run(trajectory=slew, samples=21)}), mission


def bracket_task(force: float = 3000.0) -> tuple[Model, Mission]:
    """Two massless struts of 1 m in an equilateral triangle that bear a force at the top; tubes of 1 mm wall."""
    still = Spline(times=(0.0, 0.5, 0.8, 1.0), values={"left": (1.0,) * 4})
    model = Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": Node(at=(0.5, math.sqrt(0.75)))},
        fixed=["A", "B"],
        bars={"left": Bar(ends=("A", "C"), kind="driven"), "right": ("B", "C")},
        material=Material(E=70e9, density=0.0, yield_strength=240e6),
        loads={"push": NodalForce(node="C", force=(0, -force))},
        runs={"stand": Run(trajectory=still, samples=2)},
    )
    tubes = {f"{outer}x1": {"outer": f"{outer} mm", "wall": "1 mm"} for outer in range(8, 31)}
    catalogue: Any = {"source": "made up for this case", "tubes": tubes}
    safety: Any = {"yielding": 1.5, "buckling": 2.0}
    mission = Mission(groups={"struts": ["left", "right"]}, catalogues={"tubes": Catalogue(**catalogue)}, safety=safety)
    return model, mission


def chain() -> dict[str, Any]:
    """What the sizing of the small case says."""
    model, mission = chain_task()
    found = design.size(model, mission)
    diameter = {name: outer / 1e3 for name, (outer, _) in SIZES.items()}
    return {
        "tube": {row.name: diameter[row.tube] for row in found.groups},
        "mass": found.mass_after,
        "carries": float(max(row.utilisation for row in found.groups) <= 1),
        "smaller fails": {row.name: float(row.smaller_utilisation > 1) for row in found.groups},
        "settled": found.settled,
    }


def bracket() -> dict[str, float]:
    """Outer diameter (mm) and utilisation of the struts, and by how much the tube one size smaller buckles."""
    (row,) = design.size(*bracket_task()).groups
    return {
        "outer": float(row.tube.split("x")[0]),
        "utilisation": row.utilisation,
        "smaller": row.smaller_utilisation,
    }


def cases() -> Iterator[Case]:
    """Choices are exact; a utilisation is good to round-off."""
    for group, outer in OPTIMUM.items():
        yield Case(f"sizing.exhaustive.{group}.outer", EXHAUSTIVE, outer, 1e-12, chain, at=("tube", group))
        yield Case(
            f"sizing.exhaustive.{group}.one_size_smaller_fails", EXHAUSTIVE, 1.0, 0.0, chain, at=("smaller fails", group)
        )
    yield Case("sizing.exhaustive.mass", EXHAUSTIVE, MASS, 1e-9, chain, at=("mass",))
    yield Case("sizing.exhaustive.carries", EXHAUSTIVE, 1.0, 0.0, chain, at=("carries",))
    yield Case("sizing.settled", SETTLED, 0.0, 1e-12, chain, at=("settled",), scale=1.0)
    outer, loads = _by_hand()
    yield Case("sizing.bracket.outer", BY_HAND, outer, 0.0, bracket, at=("outer",))
    yield Case("sizing.bracket.utilisation", BY_HAND, loads[0], 1e-10, bracket, at=("utilisation",))
    yield Case("sizing.bracket.one_size_smaller", BY_HAND, loads[1], 1e-10, bracket, at=("smaller",))


def _by_hand() -> tuple[float, tuple[float, float]]:
    """Least outer diameter (mm) that holds Euler's load twice, and the utilisations of it and of the one below."""
    thrust = 3000.0 / 2 / math.sin(math.pi / 3)
    load = {
        outer: 2 * thrust / (math.pi**3 * 70e9 / 64 * ((outer / 1e3) ** 4 - ((outer - 2) / 1e3) ** 4)) for outer in range(8, 31)
    }
    least = min(outer for outer, used in load.items() if used <= 1)
    return float(least), (load[least], load[least - 1])
