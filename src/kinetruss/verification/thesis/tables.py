"""The double-octahedral bay against the printed numbers of Lacy (1991), chapter 5.

He used four sets of sizes and loads, none of them his Table 5.1; `SETS` holds what his numbers need, and each number names
the inputs of its set that were inferred. Tables 5.3 and 5.4 stand swapped against his text: the first has M7 short.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

import kinetruss as kt

Lengths = tuple[float, float, float]

INCH = 0.0254
LEVEL = (1.1684, 1.1684, 1.1684)
SHORT, LONG = (1.1077, 1.2289, 1.2289), (1.2289, 1.1077, 1.1077)
POSES = {
    "table_5_2": LEVEL,
    "table_5_3": SHORT,
    "table_5_3.refit": (1.10795, 1.22896, 1.22896),
    "table_5_4": LONG,
    "table_5_4.refit": (1.22895, 1.10797, 1.10797),
}
"""Lengths of M7, M9, M11, m; refit: the lengths that the printed forces belong to."""

START, END = LONG, SHORT
"""Of the slew in section 5.7."""


@dataclass(frozen=True)
class Setup:
    """Cross longeron and inner diameter (m), force at each top node (N), density (kg/m^3), gravity (m/s^2, upwards)."""

    longeron: float
    inner: float
    force: float
    density: float
    gravity: float


SETS = {
    "A": Setup(35 * INCH, 0.62 * INCH, 44.498, 0.0, 0.0),
    "B": Setup(35.5 * INCH, 0.63 * INCH, 45.0, 0.0, 0.0),
    "C": Setup(35.5 * INCH, 0.63 * INCH, 46.0, 3000.0, 9.81),
}
"""A: Tables 5.2 to 5.4, its load inferred. B: Table 5.5, longeron and load inferred. C: sections 5.7 and 5.8, longeron and
density inferred."""


def at_rest(name: str, lengths: Lengths) -> tuple[kt.Model, kt.results.Forces]:
    """The truss of a set, standing with the given lengths of M7, M9, M11."""
    setup = SETS[name]
    model = kt.library.vgt.double_octahedral(
        base=48 * INCH,
        longeron=setup.longeron,
        section=kt.Tube(outer=0.75 * INCH, inner=setup.inner),
        material=kt.Material(E=71e9, density=setup.density),
        gravity=(0.0, 0.0, setup.gravity),
        tip_force=(0.0, 0.0, setup.force),
    )
    position = kt.kinematics.assemble(model, lengths=dict(zip(("M7", "M9", "M11"), lengths, strict=True)))
    still = np.zeros((1, *position.shape))
    motion = kt.kinematics.from_arrays(model, [0.0], position[None], still, still)
    return model, kt.dynamics.inverse(model, motion, static=False)


def table(where: str) -> dict[str, float]:
    """Tables 5.2 to 5.4: without weight."""
    model, forces = at_rest("A", POSES[where])
    tension = forces.member_force.isel(time=0)
    reaction = forces.reaction.sel(support="N1").values[0]
    stress = kt.strength.stresses(model, kt.strength.sections(model, forces, [0.5]))["S2"].isel(time=0, station=0)
    return {f"R_N1_{axis}": value for axis, value in zip("xyz", reaction, strict=True)} | {
        "tension_M6": tension.sel(member="M6").item(),
        "compression_M19": -tension.sel(member="M19").item(),
        "stress_M6": stress.sel(part="M6").item(),
        "stress_M19": stress.sel(part="M19").item(),
    }


def strain(pose: str) -> dict[str, float]:
    """Table 5.5: microstrain of M6, without weight."""
    found = _components("B", {"equilibrium": LEVEL, "M7_long": LONG, "M7_short": SHORT}[pose])
    return {"strain_M6": found["axial_microstrain"].sel(part="M6").item()}


def _components(name: str, lengths: Lengths) -> Any:
    """Stress components at mid length."""
    model, forces = at_rest(name, lengths)
    return kt.strength.components(model, kt.strength.sections(model, forces, [0.5])).isel(time=0, station=0)


def _outer_fibre(name: str, lengths: Lengths, part: str) -> float:
    """Largest stress over the section at mid length, both bendings counted, Pa."""
    model, forces = at_rest(name, lengths)
    found = kt.strength.stresses(model, kt.strength.sections(model, forces, [0.5]))["S2"]
    return float(found.sel(part=part).isel(time=0, station=0).item())


def slewed() -> dict[str, float]:
    """Sections 5.7 and 5.8: read from his graphs, at rest in the end positions, with weight.

    His b2 is the normal of the face 2-3-5 that M6 bounds: local axis 3 of the product; b1 is local axis 2. M19 has the
    normal of the top plane as axis 3. His von Mises stresses count one bending of two. The force of M8 is the actuator's
    of the member M7/M8, M7 in the product.
    """
    poses = {"start": START, "end": END}
    tension = {pose: at_rest("C", lengths)[1].member_force.isel(time=0) for pose, lengths in poses.items()}
    stress = {pose: abs(_components("C", lengths)) for pose, lengths in poses.items()}
    m6, m19 = ({key: value.item() for key, value in stress["end"].sel(part=name).items()} for name in ("M6", "M19"))
    return {
        "compression_M19": -tension["end"].sel(member="M19").item(),
        "compression_M20": -tension["start"].sel(member="M20").item(),
        "compression_M21": -tension["start"].sel(member="M21").item(),
        "compression_M8_start": -tension["start"].sel(member="M7").item(),
        "compression_M8_largest": -min(found.sel(member="M7").item() for found in tension.values()),
        "compression_M8_end": -tension["end"].sel(member="M7").item(),
        "M6_axial": m6["axial"],
        "M6_bending_2": m6["bending_3"],
        "M6_bending_1": stress["start"]["bending_2"].sel(part="M6").item(),
        "M6_von_mises": m6["axial"] + m6["bending_3"],
        "M19_von_mises": m19["axial"] + m19["bending_2"],
        "M6_von_mises.product": _outer_fibre("C", END, "M6"),
        "M19_von_mises.product": _outer_fibre("C", END, "M19"),
    }


def buckling() -> dict[str, float]:
    """Section 5.8: M19 computed with the length of a longeron and the thick tube, as he did, and with its own; M8."""
    thick, thin = (kt.Tube(outer=0.75 * INCH, inner=inner * INCH).second_moments[0] for inner in (0.62, 0.63))
    return {
        "buckling_M19": float(kt.strength.euler_load(71e9, thick, 35 * INCH)),
        "buckling_M19.product": float(kt.strength.euler_load(71e9, thin, 48 * INCH)),
        "buckling_M8": float(kt.strength.euler_load(71e9, thin, 10 * INCH)),
    }
