"""The double-octahedral bay and chains of it: exact slews and poses, and the printed numbers of Lacy (1991, chapter 5).

He used four sets of sizes and loads, none of them his Table 5.1; `SETS` holds what his numbers need, and each number names
the inputs of its set that were inferred. Tables 5.3 and 5.4 stand swapped against his text: the first has M7 short.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

import kinetruss as kt
from kinetruss.verification.measures import Numbers, at_times, without_weight

double_octahedral = kt.library.vgt.double_octahedral

Lengths = tuple[float, float, float]
INCH = 0.0254
BASE = 48 * INCH
LEVEL = (1.1684, 1.1684, 1.1684)
SHORT, LONG = (1.1077, 1.2289, 1.2289), (1.2289, 1.1077, 1.1077)
START, END = LONG, SHORT
"""Of the slew in section 5.7."""
POSES = {
    "table_5_2": LEVEL,
    "table_5_3": SHORT,
    "table_5_3.refit": (1.10795, 1.22896, 1.22896),
    "table_5_4": LONG,
    "table_5_4.refit": (1.22895, 1.10797, 1.10797),
}
"""Lengths of M7, M9, M11, m; refit: the lengths that the printed forces belong to."""
SETS = {
    "A": {"longeron": 35.0, "inner": 0.62, "force": 44.498, "density": 0.0, "gravity": 0.0},
    "B": {"longeron": 35.5, "inner": 0.63, "force": 45.0, "density": 0.0, "gravity": 0.0},
    "C": {"longeron": 35.5, "inner": 0.63, "force": 46.0, "density": 3000.0, "gravity": 9.81},
}
"""Cross longeron and inner diameter (in), force at each top node (N), density (kg/m^3), gravity (m/s^2, upwards).

A: Tables 5.2 to 5.4, its load inferred. B: Table 5.5, longeron and load inferred. C: sections 5.7 and 5.8, longeron and
density inferred."""
TILT = math.radians(10)


def bay_of(name: str, **changes: float) -> kt.Model:
    """The bay of a set."""
    at = SETS[name] | changes
    return double_octahedral(
        longeron=at["longeron"] * INCH,
        section=kt.Tube(outer=0.75 * INCH, inner=at["inner"] * INCH),
        material=kt.Material(E=71e9, density=at["density"]),
        gravity=(0.0, 0.0, at["gravity"]),
        tip_force=(0.0, 0.0, at["force"]),
    )


def pose(lengths: Iterable[float]) -> dict[str, float]:
    """Lengths of the active members by name."""
    return dict(zip(("M7", "M9", "M11"), lengths, strict=True))


def table(where: str, by: str) -> Numbers:
    """Tables 5.2 to 5.4: without weight."""
    reaction, tension, stress = without_weight(bay_of("A"), pose(POSES[where]), by)
    found = {f"R_N1_{axis}": reaction.sel(support="N1", axis=axis) for axis in "xyz"}
    found |= {f"stress_{name}": stress.sel(member=name) for name in ("M6", "M19")}
    return found | {"tension_M6": tension.sel(member="M6"), "compression_M19": -tension.sel(member="M19")}


def table_5_5(by: str) -> Numbers:
    """Microstrain of M6 in three poses, without weight: by section forces, strain gauges, pose-wise statics, stiffness."""
    model, poses = bay_of("B"), {"equilibrium": pose(LEVEL), "M7_long": pose(LONG), "M7_short": pose(SHORT)}
    if by == "linear":
        places = {name: kt.kinematics.assemble(model, lengths) for name, lengths in poses.items()}
        return {name: 1e6 * kt.statics.linear(model, x, weight=False).strain.sel(member="M6") for name, x in places.items()}
    forces = kt.statics.at_poses(model, poses, weight=False)
    if by == "at_poses":
        found = 1e6 * kt.statics.deflection(model, forces).strain.sel(member="M6")
    elif by == "gauges":
        angles = {f"G{k}": 2 * math.pi * k / 3 for k in range(3)}
        gauges = {name: kt.Gauge(member="M6", at=0.5, angle=angle, factor=2.1, group="M6") for name, angle in angles.items()}
        found = kt.strength.gauges(model.with_(gauges=gauges), forces)["group_strain"].sel(group="M6", component="axial")
    else:
        sections = kt.strength.sections(model, forces, [0.5])
        found = kt.strength.components(model, sections)["axial_microstrain"].sel(part="M6", station=0.5)
    return dict(zip(poses, found.values, strict=True))


def slewed() -> Numbers:
    """Sections 5.7 and 5.8: read from his graphs, at rest in the end positions, with weight.

    His b2 is the normal of the face 2-3-5 that M6 bounds: local axis 3 of the product; b1 is local axis 2. M19 has the
    normal of the top plane as axis 3. His von Mises stresses count one bending of two. The force of M8 is the actuator's
    of the member M7/M8, M7 in the product.
    """
    model = bay_of("C")
    forces = kt.statics.at_poses(model, [pose(START), pose(END)])
    sections = kt.strength.sections(model, forces, [0.5])
    start, end = forces.member_force
    parts = abs(kt.strength.components(model, sections).sel(station=0.5))
    m6, m19 = (parts.isel(time=1).sel(part=name) for name in ("M6", "M19"))
    own = kt.strength.stresses(model, sections)["S2"].isel(time=1, station=0)  # of both bendings
    return {
        "compression_M19": -end.sel(member="M19"),
        "compression_M20": -start.sel(member="M20"),
        "compression_M21": -start.sel(member="M21"),
        "compression_M8_start": -start.sel(member="M7"),
        "compression_M8_largest": -forces.member_force.sel(member="M7").min(),
        "compression_M8_end": -end.sel(member="M7"),
        "M6_axial": m6["axial"],
        "M6_bending_2": m6["bending_3"],
        "M6_bending_1": parts["bending_2"].isel(time=0).sel(part="M6"),
        "M6_von_mises": m6["axial"] + m6["bending_3"],
        "M19_von_mises": m19["axial"] + m19["bending_2"],
        "M6_von_mises.product": own.sel(part="M6"),
        "M19_von_mises.product": own.sel(part="M19"),
    }


def buckling() -> Numbers:
    """Section 5.8: M19 computed with the length of a longeron and the thick tube, as he did, and with its own; M8."""
    thick, thin = (kt.Tube(outer=0.75 * INCH, inner=inner * INCH).second_moments[0] for inner in (0.62, 0.63))
    return {
        "buckling_M19": kt.strength.euler_load(71e9, thick, 35 * INCH),
        "buckling_M19.product": kt.strength.euler_load(71e9, thin, BASE),
        "buckling_M8": kt.strength.euler_load(71e9, thin, 10 * INCH),
    }


def slew_of(duration: float, times: list[float]) -> tuple[kt.Model, kt.results.Forces]:
    """One bay from -10 to 10 degrees, gravity upwards as in the thesis, and its forces at the given times."""
    model = double_octahedral(tip_force=(0.0, 0.0, 46.0), gravity=(0.0, 0.0, 9.81))
    trajectory = kt.library.vgt.slew(beta=(-TILT, TILT), duration=duration)
    return model, kt.dynamics.inverse(model, kt.kinematics.follow(model, trajectory, times=times))


def slew(duration: float, times: list[float]) -> Numbers:
    """Everything the references hold, at the given times; V and M in global axes, on the A side as in the product."""
    model, forces = slew_of(duration, times)
    motion, now, sections = forces.motion.data, forces.data, kt.strength.sections(model, forces).data
    axes = kt.kinematics.member_rates(model, forces.motion).member_axes
    found = {
        "active_lengths": motion.length.sel(member=["M7", "M9", "M11"]),
        "N8": motion.position.sel(node="N8").values,
        "A8": motion.acceleration.sel(node="N8").values,
        "reactions": now.reaction.sel(support=["N1", "N2", "N3"]),
        "tension_at_B_end": now.end_force.sel(end="B"),
        "mean_tension_lambda": now.member_force,
        "actuator_axial": now.interface_force.sel(component="axial"),
    }
    for name, member, part, station in (("M6_mid", "M6", "M6", 3), ("M7_cantilever", "M7", "M7.tube", 0)):
        across = axes.sel(member=member).values[:, 1:]
        at = sections.sel(part=part).isel(station=station)
        found[f"{name}.T"] = at.section_T
        found |= {f"{name}.{kind}": np.einsum("ti,tix->tx", at[f"section_{kind}"].values, across) for kind in "VM"}
    return at_times(times, found)


def chain() -> Numbers:
    """Everything the references hold of three bays that tilt about both axes, at rest and in mid motion."""
    model = double_octahedral(3, payload_mass=2.0)
    trajectory = kt.library.vgt.slew(3, beta=(0.0, TILT), gamma=(0.0, TILT), duration=3.0)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, trajectory, times=(0.0, 1.5)), static=False)
    motion, now = forces.motion.data, forces.data
    found = {"tension_at_B_end": now.end_force.sel(end="B"), "actuator_axial": now.interface_force.sel(component="axial")}
    lengths = {"length": motion.length, "rate": motion.length_rate, "acceleration": motion.length_acceleration}
    for name in model.active:
        found |= {f"active_L_Ld_Ldd.{name}.{kind}": values.sel(member=name) for kind, values in lengths.items()}
    found |= {f"reactions_N1_N2_N3.N{k}": now.reaction.sel(support=f"B1.N{k}") for k in (1, 2, 3)}
    found |= {f"top_nodes.N{k}": motion.position.sel(node=f"B3.N{k}") for k in (7, 8, 9)}
    return at_times((0.0, 1.5), found | {f"top_acc.N{k}": motion.acceleration.sel(node=f"B3.N{k}") for k in (7, 8, 9)})


def lengths_of(beta: float, longeron: float, height: float) -> Numbers:
    """Lengths of the active members for a pure beta tilt (degrees)."""
    return pose(kt.kinematics.gimbal_lengths(BASE, longeron * INCH, np.radians(beta), 0.0, height))


def pose_of(lengths: Lengths, longeron: float) -> Numbers:
    """beta (degrees) and height (m) that three lengths belong to."""
    beta, _, height = kt.kinematics.gimbal_pose(BASE, longeron * INCH, lengths)
    return {"beta": np.degrees(beta), "height": height}


def tip_of(bays: int, beta: float, gamma: float) -> Numbers:
    """Angles (degrees) of the top of a chain, all bays alike, at the end of a slew."""
    model = double_octahedral(bays)
    trajectory = kt.library.vgt.slew(bays, beta=(0.0, math.radians(beta)), gamma=(0.0, math.radians(gamma)))
    motion = kt.kinematics.follow(model, trajectory, times=(0.0, 1.0))
    tip = kt.kinematics.platform(model, motion, [f"B{bays}.N{k}" for k in (7, 9, 8)]).isel(time=-1)
    angles = {"tip_beta": tip.beta, "tip_gamma": tip.gamma, "tilt": np.arccos(tip.normal[2])}
    return {name: np.degrees(angle) for name, angle in angles.items()}
