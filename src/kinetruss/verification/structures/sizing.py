"""Sizing: the lightest of all combinations of a small case, and a truss whose tubes follow by hand."""

from __future__ import annotations

import math
from typing import Any

import kinetruss as kt

SIZES = {"14x1": (14, 1), "16x1": (16, 1), "18x1.5": (18, 1.5), "20x1.5": (20, 1.5), "25x2": (25, 2)}
"""Tubes of the small case by name: outer diameter and wall, mm."""


def chain_task(duration: float = 0.6) -> tuple[kt.Model, kt.Mission]:
    """Two bays that slew so fast that their own masses rule the forces; three groups, five tubes."""
    slew = kt.library.vgt.slew(2, beta=(0.0, math.radians(14)), gamma=(0.0, math.radians(9)), duration=duration)
    chain = kt.library.vgt.double_octahedral(2, payload_mass=3.0, base_mass=0.5, material="aluminium_6061_t6")
    tubes = {name: {"outer": f"{outer} mm", "wall": f"{wall} mm"} for name, (outer, wall) in SIZES.items()}
    groups = {
        "lower": ["B1.M[1-6]", "B1.M1[3-8]"],
        "upper": ["B1.M19", "B1.M2[01]", "B2.M[1-6]", "B2.M1[3-9]", "B2.M2[01]"],
        "actuators": ["B?.M7", "B?.M9", "B?.M11"],
    }
    catalogue: Any = {"source": "made up for this case", "material": "aluminium_6061_t6", "tubes": tubes}
    safety: Any = {"yielding": 1.5, "buckling": 3.0}
    mission = kt.Mission(groups=groups, catalogues={"tubes": kt.Catalogue(**catalogue)}, safety=safety)
    return chain.with_(runs={"slew": kt.Run(trajectory=slew, samples=21)}), mission


def bracket_task(force: float = 3000.0) -> tuple[kt.Model, kt.Mission]:
    """Two massless struts of 1 m in an equilateral triangle that bear a force at the top; tubes of 1 mm wall."""
    still = kt.Spline(times=(0.0, 0.5, 0.8, 1.0), values={"left": (1.0,) * 4})
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": kt.Node(at=(0.5, math.sqrt(0.75)))},
        fixed=["A", "B"],
        bars={"left": kt.Bar(ends=("A", "C"), kind="driven"), "right": ("B", "C")},
        material=kt.Material(E=70e9, density=0.0, yield_strength=240e6),
        loads={"push": kt.NodalForce(node="C", force=(0, -force))},
        runs={"stand": kt.Run(trajectory=still, samples=2)},
    )
    tubes = {f"{outer}x1": {"outer": f"{outer} mm", "wall": "1 mm"} for outer in range(8, 31)}
    catalogue: Any = {"source": "made up for this case", "tubes": tubes}
    safety: Any = {"yielding": 1.5, "buckling": 2.0}
    mission = kt.Mission(groups={"struts": ["left", "right"]}, catalogues={"tubes": kt.Catalogue(**catalogue)}, safety=safety)
    return model, mission


def chain() -> dict[str, Any]:
    """What the sizing of the small case says."""
    model, mission = chain_task()
    found = kt.design.size(model, mission)
    diameter = {name: outer / 1e3 for name, (outer, _) in SIZES.items()}
    return {
        row.name: {"outer": diameter[row.tube], "one_size_smaller_fails": row.smaller_utilisation > 1} for row in found.groups
    } | {
        "mass": found.mass_after,
        "carries": max(row.utilisation for row in found.groups) <= 1,
        "settled": found.settled,
    }


def bracket() -> dict[str, float]:
    """Outer diameter (mm) and utilisation of the struts, and by how much the tube one size smaller buckles."""
    (row,) = kt.design.size(*bracket_task()).groups
    outer = float(row.tube.split("x")[0])
    return {"outer": outer, "utilisation": row.utilisation, "one_size_smaller": row.smaller_utilisation}
