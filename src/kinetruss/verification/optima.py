"""Optima of trusses that the literature knows, from the product's own models: least weight in lb, and the certificate."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.cases import model, stored
from kinetruss.verification.measures import Numbers

POUND, INCH = 0.45359237, 0.0254
FLAT: dict[str, Any] = {"kind": "general", "I2": 1e-9, "I3": 1e-9, "c2": 0.01, "c3": 0.01}
"""A section of which the area alone matters."""
STRESS = {"of": "axial_stress", "at_most": "25 ksi", "at_least": "-25 ksi"}
MOVED = {"of": "displacement", "at_most": "2 in", "at_least": "-2 in"}
SHARPNESS = 800
"""Exponent by which the third and the fourth frequency, which meet, become one smooth number below both."""


def ten_bars(E: str = "1e4 ksi", density: str = "0.1 lb/in^3", area: float = 20 * INCH**2, mass: float = 0.0) -> kt.Model:
    """The cantilever of ten bars in two bays of 360 in; 100,000 lbf at both lower nodes, or a mass at each free one."""
    data = stored("models")["ten_bars"]
    loads = {f"P{node}": kt.NodalForce(node=node, force=(0, "-100000 lbf")) for node in ("2", "4")}
    return kt.Model(
        nodes={name: kt.Node(at=at, mass=0.0 if name in data["fixed"] else mass) for name, at in data["nodes"].items()},
        fixed=data["fixed"],
        bars={name: {"ends": bar["ends"], "section": {**FLAT, "area": area}} for name, bar in data["bars"].items()},
        material=kt.Material(E=E, density=density),
        loads={} if mass else loads,
    )


def areas(truss: kt.Model, low: str, high: str, **more: Any) -> dict[str, Any]:
    """A variable for the area of each bar."""
    return {f"area_{name}": {"of": f"bars.{name}.section.area", "between": (low, high), **more} for name in truss.bars}


def ten_bar_task(limited: str, **options: Any) -> tuple[kt.Model, kt.OptimumTask]:
    """The task with limits on ``stresses``, or on ``displacements`` too."""
    truss = ten_bars()
    limits = {"stress": STRESS} | ({"displacement": MOVED} if limited == "displacements" else {})
    return truss, kt.OptimumTask(
        variables=areas(truss, "0.1 in^2", "40 in^2"), limits=limits, arguments={"weight": False}, **options
    )


def ten_bar_weight(limited: str) -> Numbers:
    """Its least weight, lb, and the residual of the certificate."""
    return _weight(kt.design.optimise(*ten_bar_task(limited)))


def _weight(found: Any) -> Numbers:
    return {"weight": found.objective / POUND, "residual": found.certificate.residual if found.certificate.feasible else np.nan}


GROUPS = ("1", "2345", "6789", "AB", "CD", "EFGH", "IJKL", "MNOP")
"""Bars of the tower of 25 by group, one letter each, in the order of the model."""
PUSHED = (35.092, 11.590, 17.305, 35.092, 35.092, 6.759, 6.959, 11.082)
"""Largest compressive stress of each group, ksi (Schmit and Farshi 1974)."""


def twenty_five_bar_task(**options: Any) -> tuple[kt.Model, kt.OptimumTask]:
    """The tower of 25 bars in 8 groups under two load cases; tops move at most 0.35 in."""
    tower, ends = model("twenty_five_bars"), np.cumsum([0, *map(len, GROUPS)])
    groups = [list(tower.bars)[a:b] for a, b in pairwise(ends)]
    variables = {
        f"group_{k}": {"of": [f"bars.{name}.section.area" for name in names], "between": ("0.01 in^2", "3.4 in^2")}
        for k, names in enumerate(groups, start=1)
    }
    limits: dict[str, Any] = {
        f"top_{node}": {"of": f"displacement[{node}]", "at_most": "0.35 in", "at_least": "-0.35 in"} for node in "12"
    }
    limits |= {
        f"stress_{name}": {"of": f"axial_stress[{name}]", "at_most": "40 ksi", "at_least": f"{-push} ksi"}
        for names, push in zip(groups, PUSHED, strict=True)
        for name in names
    }
    task = kt.OptimumTask(
        variables=variables, limits=limits, load_cases=list(tower.load_cases), arguments={"weight": False}, **options
    )
    return tower, task


def twenty_five_bar_weight() -> Numbers:
    """Its least weight, lb, and the residual of the certificate."""
    return _weight(kt.design.optimise(*twenty_five_bar_task()))


def frequency_task(E: float, **options: Any) -> tuple[kt.Model, kt.OptimumTask]:
    """Ten bars with 454 kg at each free node: frequencies of at least 7, 15 and 20 Hz."""
    truss = ten_bars(E=f"{E} Pa", density="2770 kg/m^3", area=20e-4, mass=454.0)
    both = " + ".join(f"(frequency[{k}]*s/20)**-{SHARPNESS}" for k in (3, 4))
    own: dict[str, Any] = {"analysis": "flexible.frequencies", "arguments": {"modes": 4}}
    limits: dict[str, Any] = {
        "first": {"of": "frequency[1]", "at_least": "7 Hz", **own},
        "second": {"of": "frequency[2]", "at_least": "15 Hz", **own},
        "third": {"of": f"({both})**-{1 / SHARPNESS}", "at_least": 1.0, **own},
    }
    variables = areas(truss, "0.645 cm^2", "50 cm^2")
    return truss, kt.OptimumTask(variables=variables, limits=limits, **options)


def frequency_mass(E: float) -> Numbers:
    """Least mass of the bars from six starts, kg; the residual; how far frequencies are from limits, Hz, by their analysis."""
    found = kt.design.optimise(*frequency_task(E, starts=6, seed=1))
    own = kt.flexible.frequencies(found.model, kt.runs.forces_at_rest(found.model), 4).frequency.values[0]
    return {
        "mass": found.objective - 4 * 454.0,
        "residual": found.certificate.residual,
        "above_first": own[0] - 7.0,
        "below_third": max(0.0, 20.0 - own[2]),
    }


SECTIONS = (
    1.62, 1.80, 1.99, 2.13, 2.38, 2.62, 2.63, 2.88, 2.93, 3.09, 3.13, 3.38, 3.47, 3.55, 3.63, 3.84, 3.87, 3.88, 4.18, 4.22,
    4.49, 4.59, 4.80, 4.97, 5.12, 5.74, 7.22, 7.97, 11.5, 13.5, 13.9, 14.2, 15.5, 16.0, 16.9, 18.8, 19.9, 22.0, 22.9, 26.5,
    30.0, 33.5,
)  # fmt: skip
"""in^2 (Rajeev and Krishnamoorthy 1992)."""


def ten_bar_sections() -> Numbers:
    """Least weight with sections from a list, lb, and the gap of branch and bound."""
    truss, task = ten_bar_task("displacements")
    variables = {name: {"of": one.of, "choose": [f"{area} in^2" for area in SECTIONS]} for name, one in task.variables.items()}
    found = kt.design.optimise(truss, task.with_(variables=variables))
    proof: Any = found.proof
    return {"weight": found.objective / POUND, "gap": proof.gap if proof.closed else np.nan}
