"""Measures of results, and motions at rest, that several subjects use."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt

Numbers = dict[str, Any]
"""What the function of a case gives: numbers, vectors and labelled arrays by name, or more of such mappings."""


def share(part: Any, whole: Any) -> float:
    """Largest size of the one, of the largest of the other."""
    return float(np.abs(part).max() / np.abs(whole).max())


def off(found: Any, exact: Any) -> float:
    """Largest difference, relative to the largest exact value."""
    return share(found - exact, exact)


def missed(found: Any, exact: Any) -> float:
    """Largest difference, relative to the range of the exact values."""
    return float(np.abs(found - exact).max() / np.ptp(exact))


def change(values: Any) -> float:
    """Largest change since the first sample."""
    return float(np.abs(values - values[0]).max())


def drift(run: kt.results.Simulation) -> float:
    """Largest change of the energy, relative to the largest kinetic energy."""
    kinetic = run.kinetic_energy.values
    return change(kinetic + run.potential_energy.values) / float(kinetic.max())


def unit(vector: Any) -> Any:
    """Vectors, along the last axis, of length 1."""
    return vector / np.linalg.norm(vector, axis=-1, keepdims=True)


def at_times(times: Any, histories: Numbers) -> Numbers:
    """Samples of histories (times, ..), each under the name of its instant."""
    return {f"t={t:g}": {name: values[i] for name, values in histories.items()} for i, t in enumerate(times)}


def standing(model: kt.Model, places: Any) -> kt.results.Motion:
    """A motion of one sample, at rest, with the nodes at the given places."""
    x = np.asarray(places, float)[None]
    return kt.kinematics.from_arrays(model, [0.0], x, 0 * x, 0 * x)


def without_weight(model: kt.Model, lengths: dict[str, float], by: str) -> tuple[Any, Any, Any]:
    """Reactions, tensions and stresses of the members, of one section, of a truss at rest under its loads.

    by : ``stiffness``, the stiffness method and |N|/A; ``inverse``, inverse dynamics at rest and section forces.
    """
    if by == "stiffness":
        found = kt.statics.linear(model, kt.kinematics.assemble(model, lengths), weight=False).data
        area = model.section_of(next(iter(model.bars.values()))).area
        return found.reaction, found.member_force, abs(found.member_force) / area
    forces = kt.statics.at_poses(model, [lengths], weight=False)
    now, sections = forces.data.isel(time=0), kt.strength.sections(model, forces, [0.5])
    parts = [f"{name}.tube" if name in model.active else name for name in now.member.values]
    stress = kt.strength.stresses(model, sections)["S2"].isel(time=0, station=0).sel(part=parts)
    return now.reaction, now.member_force, now.member_force.copy(data=stress.values)


def modes(values: Any) -> Numbers:
    """Values of modes as ``mode_1``, ``mode_2``, ..."""
    return {f"mode_{k}": value for k, value in enumerate(values, start=1)}
