"""One double-octahedral bay, slewed in 1 s and in 5.5 s, and a chain of three that tilts about both axes at once."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

TILT = math.radians(10)


def truss_of(bays: int = 1, **parameters: Any) -> kt.Model:
    """The truss with the sizes and masses of the reference; gravity upwards for one bay, as in the thesis."""
    tube = kt.Tube(outer=0.019049999999999997, inner=0.016002)
    return kt.library.vgt.double_octahedral(
        bays,
        base=1.2191999999999998,
        longeron=0.889,
        height=1.1218253458835146,
        section=tube,
        material=kt.Material(E=71e9, density=2711.5),
        base_mass=3.0,
        base_length=0.7,
        tube_length=0.254,
        gravity=(0.0, 0.0, 9.81 if bays == 1 else -9.81),
        **parameters,
    )


def slewed(duration: float, times: list[float]) -> tuple[kt.Model, kt.results.Forces]:
    """One bay, and its forces at the given times of a slew."""
    model = truss_of(tip_force=(0.0, 0.0, 46.0))
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-TILT, TILT), duration=duration), times=np.array(times))
    return model, kt.dynamics.inverse(model, motion)


def slew(duration: float, times: list[float]) -> dict[str, Any]:
    """Everything the references hold, at the given times."""
    model, forces = slewed(duration, times)
    sections = kt.strength.sections(model, forces)
    return {f"t={t:g}": _at(model, forces, sections, i) for i, t in enumerate(times)}


def _at(model: kt.Model, forces: kt.results.Forces, sections: kt.results.Sections, i: int) -> dict[str, Any]:
    motion, now = forces.motion.data.isel(time=i), forces.data.isel(time=i)
    return {
        "active_lengths": table_of(motion.length.sel(member=["M7", "M9", "M11"]), "member"),
        "N8": motion.position.sel(node="N8").values,
        "A8": motion.acceleration.sel(node="N8").values,
        "reactions": table_of(now.reaction.sel(support=["N1", "N2", "N3"]), "support"),
        "tension_at_B_end": table_of(now.end_force.sel(end="B"), "member"),
        "mean_tension_lambda": table_of(now.member_force, "member"),
        "actuator_axial": table_of(now.interface_force.sel(component="axial"), "active"),
        "M6_mid": _section(model, motion, sections.data.sel(part="M6").isel(station=3, time=i), "M6"),
        "M7_cantilever": _section(model, motion, sections.data.sel(part="M7.tube").isel(station=0, time=i), "M7"),
    }


def table_of(values: Any, dimension: str) -> dict[str, Any]:
    """Numbers, or vectors, by name along a dimension."""
    return {str(name): values.sel({dimension: name}).values for name in values[dimension].values}


def _section(model: kt.Model, motion: Any, at: Any, name: str) -> dict[str, Any]:
    """T, and V and M in global axes, exerted by the B side on the A side as in the product.

    Axis 1 of a member points from A to B, 3 along 1 x (orientation - A), 2 = 3 x 1.
    """
    member = model.members[name]
    a, b, third = (motion.position.sel(node=node).values for node in (*member.ends, str(member.orientation)))
    along = (b - a) / np.linalg.norm(b - a)
    normal = np.cross(along, third - a)
    normal /= np.linalg.norm(normal)
    axes = np.array([np.cross(normal, along), normal])
    return {"T": at.section_T.values, "V": at.section_V.values @ axes, "M": at.section_M.values @ axes}


def chain() -> dict[str, Any]:
    """Everything the references hold of three bays, at rest and in mid motion."""
    model = truss_of(3, payload_mass=2.0)
    trajectory = kt.library.vgt.slew(3, beta=(0.0, TILT), gamma=(0.0, TILT), duration=3.0)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, trajectory, times=np.array([0.0, 1.5])), static=False)
    return {f"t={t:g}": _of_chain(forces.motion.data.sel(time=t), forces.data.sel(time=t)) for t in (0.0, 1.5)}


def _of_chain(motion: Any, now: Any) -> dict[str, Any]:
    lengths = {"length": motion.length, "rate": motion.length_rate, "acceleration": motion.length_acceleration}
    return {
        "reactions_N1_N2_N3": {f"N{k}": now.reaction.sel(support=f"B1.N{k}").values for k in (1, 2, 3)},
        "tension_at_B_end": table_of(now.end_force.sel(end="B"), "member"),
        "actuator_axial": table_of(now.interface_force.sel(component="axial"), "active"),
        "active_L_Ld_Ldd": {
            name: {kind: values.sel(member=name) for kind, values in lengths.items()} for name in now.active.values
        },
        "top_nodes": {f"N{k}": motion.position.sel(node=f"B3.N{k}").values for k in (7, 8, 9)},
        "top_acc": {f"N{k}": motion.acceleration.sel(node=f"B3.N{k}").values for k in (7, 8, 9)},
    }
