"""One double-octahedral bay, slewed in 1 s and in 5.5 s, against exact physics."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss import dynamics, kinematics, strength
from kinetruss.library import vgt
from kinetruss.model import Material, Model, Tube
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._frames import member_axes
from kinetruss.verification._reference import Reference

__all__ = ["cases", "table_of", "truss_of"]

Floats = NDArray[np.float64]

EXACT = 1e-8
"""Ten digits are stored."""

HEIGHT = 1.1218253458835146
TILT = math.radians(10)


def truss_of(inputs: dict[str, Any], bays: int = 1, **parameters: Any) -> Model:
    """The truss with the stored sizes and masses."""
    return vgt.double_octahedral(
        bays,
        base=inputs["base"],
        longeron=inputs["cl"],
        height=HEIGHT,
        section=Tube(outer=inputs["odl"], inner=inputs["idl"]),
        material=Material(E=71e9, density=inputs["rho"]),
        base_mass=inputs["mb"],
        base_length=inputs["lb"],
        tube_length=inputs["ls"],
        gravity=tuple(inputs["g"]),
        **parameters,
    )


def slew(duration: float, times: tuple[float, ...]) -> dict[str, Any]:
    """Everything the references hold, at the given times: arrays (times, ...), or a table of them by member."""
    model = truss_of(load("single_bay")["inputs"], tip_force=(0.0, 0.0, 46.0))
    motion = kinematics.follow(model, vgt.slew(beta=(-TILT, TILT), duration=duration), times=np.array(times))
    forces = dynamics.inverse(model, motion)
    sections = strength.sections(model, forces)
    active = ["M7", "M9", "M11"]
    return {
        "active_lengths": motion.length.sel(member=active).values,
        "N8": motion.position.sel(node="N8").values,
        "A8": motion.acceleration.sel(node="N8").values,
        "reactions": forces.reaction.sel(support=["N1", "N2", "N3"]).values,
        "tension_at_B_end": table_of(forces.end_force.sel(end="B"), "member"),
        "mean_tension_lambda": table_of(forces.member_force, "member"),
        "actuator_axial": table_of(forces.interface_force.sel(component="axial"), "active"),
        "M6_mid": _section(model, forces, sections, "M6", "M6", 3),
        "M7_cantilever": _section(model, forces, sections, "M7", "M7.tube", 0),
    }


def table_of(values: Any, dimension: str) -> dict[str, Floats]:
    """Histories by name along a dimension."""
    return {str(name): values.sel({dimension: name}).values for name in values[dimension].values}


def _section(model: Model, forces: Any, sections: Any, member: str, part: str, station: int) -> dict[str, Floats]:
    """T (times, 1), V and M (times, 3) in global axes, exerted by the B side on the A side as in the product."""
    at = sections.data.sel(part=part).isel(station=station)
    axes = member_axes(model, forces.motion.data, member)[:, 1:]
    return {
        "T": at["section_T"].values[:, None],
        "V": np.einsum("ti,tij->tj", at["section_V"].values, axes),
        "M": np.einsum("ti,tij->tj", at["section_M"].values, axes),
    }


def cases() -> Iterator[Case]:
    """All members, reactions, actuators, lengths and positions, at two instants of each slew."""
    data = load("single_bay")
    source = Reference("independent", data["source"])
    instants = [(*(float(word.split("=")[1]) for word in label.split()), label) for label in data["values"]]
    for duration in dict.fromkeys(one[0] for one in instants):
        times = tuple(t for d, t, _ in instants if d == duration)
        for i, label in enumerate(name for d, _, name in instants if d == duration):
            stored = data["values"][label]
            largest = {"A8": max(abs(a) for d, _, name in instants if d == duration for a in data["values"][name]["A8"])}
            for quantity, expected in stored.items():
                prefix = f"bay.{label.replace(' ', '.')}.{quantity}"
                yield from _cases(prefix, source, quantity, expected, (duration, times, i), largest)


def _cases(
    prefix: str,
    source: Reference,
    quantity: str,
    expected: Any,
    at: tuple[float, tuple[float, ...], int],
    largest: dict[str, float],
) -> Iterator[Case]:
    given, i = at[:2], at[2]
    if quantity in ("M6_mid", "M7_cantilever"):
        for name, vector in expected.items():
            values = np.atleast_1d(vector)
            # T and V are the components of one force
            scale = abs(expected["T"]) if name == "V" else float(np.abs(values).max())
            for k, value in enumerate(values):
                label = f"{prefix}.{name}" + (f".{'xyz'[k]}" if len(values) > 1 else "")
                yield Case(label, source, float(value), EXACT, slew, given, (quantity, name, (i, k)), scale)
    elif isinstance(expected, dict):
        for number, value in expected.items():
            yield Case(f"{prefix}.M{number}", source, value, EXACT, slew, given, (quantity, f"M{number}", i))
    else:
        values = np.array(expected)
        for index in np.ndindex(values.shape):
            # components of one vector are measured against its largest
            scale = largest.get(quantity) or (float(np.abs(values[index[:-1]]).max()) if quantity != "active_lengths" else 0.0)
            label = f"{prefix}.{_name(quantity, index)}"
            yield Case(label, source, float(values[index]), EXACT, slew, given, (quantity, (i, *index)), scale)


def _name(quantity: str, index: tuple[int, ...]) -> str:
    if quantity == "active_lengths":
        return ("M7", "M9", "M11")[index[0]]
    if quantity == "reactions":
        return f"N{index[0] + 1}.{'xyz'[index[1]]}"
    return "xyz"[index[0]]
