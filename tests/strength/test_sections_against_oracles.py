"""Section forces at every station against the cut of the member, integrated mass element by mass element."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from reference import newton_euler, sections
from reference.of_model import external_forces, truss_of

ROUNDING = 1e-12  # of the largest force (times 1 m for moments)
STATIONS = np.array([0.0, 0.1, 1 / 3, 0.5, 0.8, 1.0])


def bay(tube_length: float) -> tuple[kt.Model, kt.Quintic]:
    """A bay under weight and load; with a tube of 0.6 m, base and tube overlap."""
    model = kt.library.vgt.double_octahedral(
        tube_length=tube_length, tip_force=(3.0, -5.0, 46.0), gravity=(0.5, 1.0, -9.81), rotary_inertia=True
    )
    return model, kt.library.vgt.slew(beta=(-0.15, 0.2), gamma=(0.1, -0.12), duration=0.7)


def triangle(tube_length: float) -> tuple[kt.Model, kt.StepResponse]:
    return kt.library.vgt.triangular(tube_length=tube_length), kt.library.vgt.lacy_step()


def oracle_section(truss, k: int, part: str, solution, sample, xi: float):
    member = truss.members[k]
    length = newton_euler.axis_motion(member, *sample)[0]
    if part.endswith(".base"):
        return sections.base_section(truss, k, solution, sample, xi * member.rods[0].length)
    if part.endswith(".tube"):
        return sections.tube_section(truss, k, solution, sample, length - (1 - xi) * member.rods[1].length)
    return sections.bar_section(truss, k, solution, sample, xi)


def axes(model: kt.Model, name: str, x: np.ndarray) -> np.ndarray:
    """Member axes by the documented rule, as rows."""
    nodes, member = list(model.nodes), model.members[name]
    a, b = (x[nodes.index(end)] for end in member.ends)
    u = (b - a) / np.linalg.norm(b - a)
    if len(u) == 2:
        return np.array([u, [-u[1], u[0]]])
    third = np.cross(u, x[nodes.index(member.orientation)] - a)
    third /= np.linalg.norm(third)
    return np.array([u, np.cross(third, u), third])


@pytest.mark.slow
@pytest.mark.parametrize(("make", "tube_length"), [(bay, 0.254), (bay, 0.6), (triangle, 2.0), (triangle, 1.2)])
def test_sections_of_every_part(make, tube_length):
    model, trajectory = make(tube_length)
    motion = kt.kinematics.follow(model, trajectory, times=np.array([0.0, 0.21, 0.4]))
    forces = kt.dynamics.inverse(model, motion, static=False)
    found = kt.strength.sections(model, forces, STATIONS).data
    truss, external = truss_of(model), external_forces(model)
    names = list(model.members)
    for i in range(3):
        sample = tuple(motion.data[name].values[i] for name in ("position", "velocity", "acceleration"))
        solution = newton_euler.solve(truss, *sample, external)
        largest = np.abs(solution.force_b).max()
        for part in found["part"].values:
            name = str(found["member"].sel(part=part).item())
            frame = axes(model, name, sample[0])
            at = found.sel(part=part).isel(time=i)
            for n, xi in enumerate(STATIONS):
                force, moment = oracle_section(truss, names.index(name), str(part), solution, sample, xi)
                local = [at["section_T"].values[n], *at["section_V"].values[n]]
                np.testing.assert_allclose(local, frame @ force, rtol=0, atol=ROUNDING * largest)
                turning = frame[1:] @ moment if len(moment) == 3 else moment
                np.testing.assert_allclose(at["section_M"].values[n], turning, rtol=0, atol=ROUNDING * largest)
