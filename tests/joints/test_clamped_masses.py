"""Masses clamped on bars: against the bar cut in two there, with the mass at the node between."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kinetruss as kt

LENGTH, STATION, MASS = 1.0, 0.3, 2.0
ROD = kt.Rod(diameter=0.02)
STEEL: Any = kt.library.materials.STEEL_S235


def common(dim: int) -> dict[str, Any]:
    """A swinging bar from A to B, whose end drives move; B at (1, 0)."""
    z = () if dim == 2 else (0.0,)
    nodes = {"A": (0, 0, *z), "B": (LENGTH, 0, *z), "C": (1, 1, *z)} | ({} if dim == 2 else {"D": (1.2, 0.3, 1)})
    fixed = [name for name in nodes if name != "B"]
    bars = {name.lower(): kt.Bar(ends=(name, "B"), kind="driven", mass=0.4) for name in nodes if name in "CD"}
    return {"nodes": nodes, "fixed": fixed, "bars": bars, "gravity": (0, -9.81, *z)}


def moved(model: kt.Model) -> Any:
    """The forces along a move of the drives."""
    moves = {name: (length, length + 0.1) for name, length in (("c", 1.0), ("d", float(np.sqrt(1.13)))) if name in model.bars}
    motion = kt.kinematics.follow(model, kt.Quintic(moves=moves, duration=0.3), samples=7)
    return kt.dynamics.inverse(model, motion)


def loaded(dim: int) -> kt.Model:
    """The bar with the mass clamped on it."""
    given, z = common(dim), () if dim == 2 else (0.0,)
    bars = given["bars"] | {"bar": kt.Bar(ends=("A", "B"), section=ROD, material=STEEL)}
    inertia = 0.0 if dim == 2 else (0, 0, 0)
    body = kt.Body(nodes=("A", "B"), mass=MASS, center=(STATION, 0, *z), inertia=inertia)
    return kt.Model(**given | {"bars": bars}, bodies={"clamped": body})


def test_against_a_bar_cut_in_two() -> None:
    """Drive forces, joint forces, section forces on both sides of the mass, and the jump of shear there."""
    given, whole = common(2), loaded(2)
    halves = {
        name: kt.Bar(ends=ends, section=ROD, material=STEEL) for name, ends in (("left", ("A", "M")), ("right", ("M", "B")))
    }
    middle = {"M": kt.Node(at=(STATION, 0), mass=MASS)}
    cut = kt.Model(
        **given | {"bars": given["bars"] | halves, "nodes": given["nodes"] | middle},
        hubs={"M": kt.Hub(clamped=["left", "right"])},
    )
    one, two = moved(whole), moved(cut)
    assert np.allclose(one.data.drive_force, two.data.drive_force, rtol=1e-10)
    at_b = [forces.data.joint_force.sel(member=name, end="B") for forces, name in ((one, "bar"), (two, "right"))]
    assert np.allclose(*at_b, rtol=1e-9, atol=1e-9)
    here = kt.strength.sections(whole, one, [0, 0.15, STATION, 0.65, 1]).data
    apart = kt.strength.sections(cut, two, [0, 0.5, 1]).data
    for name in ("section_T", "section_V", "section_M"):
        size = float(np.abs(here[name].sel(part="bar")).max())
        left, right = apart[name].sel(part="left"), apart[name].sel(part="right")
        bar = here[name].sel(part="bar")
        assert np.allclose(bar.isel(station=[0, 1, 2]), left, atol=1e-9 * size)
        assert np.allclose(bar.isel(station=[3, 4]), right.isel(station=[1, 2]), atol=1e-9 * size)


@pytest.mark.parametrize("dim", [2, 3])
def test_the_jump_of_shear(dim: int) -> None:
    """T and V jump by m (a - g) at the mass; the equations of Newton and Euler hold."""
    model = loaded(dim)
    forces = moved(model)
    step = 1e-9
    found = kt.strength.sections(model, forces, [STATION - step, STATION + step]).data.sel(part="bar")
    a = (1 - STATION) * forces.motion.data.acceleration.sel(node="A") + STATION * forces.motion.data.acceleration.sel(node="B")
    free = a.values - np.array(model.gravity)
    axes = kt.kinematics.member_rates(model, forces.motion).member_axes.sel(member="bar").values
    along = np.einsum("tij,tj->ti", axes, free)
    jump = np.concatenate([np.diff(found.section_T, axis=1), np.diff(found.section_V, axis=1)[:, 0]], axis=1)
    assert np.allclose(jump, MASS * along, rtol=1e-6)
    cut = kt.dynamics.newton_euler(model, forces.motion, forces, time=0.15)
    assert cut.residual < 1e-11 * cut.largest
