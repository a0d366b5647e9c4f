"""Section forces of beams that turn far: in balance with supports, loads and the curve itself with few elements."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

STEEL = kt.Material(E=2.1e11, density=7850.0, yield_strength=2.35e8)
LEAF = kt.Rectangle(width=0.02, height=0.004)


def cantilever(count: int, **loads: kt.NodalForce | kt.BodyCouple) -> kt.Model:
    """A leaf of 2 m along x, clamped at its first node."""
    return kt.Model(
        nodes={f"n{i}": (2.0 * i / count, 0) for i in range(count + 1)},
        clamped=["n0"],
        beams={f"b{i}": (f"n{i}", f"n{i + 1}") for i in range(count)},
        section=LEAF,
        material=STEEL,
        loads=loads,
    )


@pytest.mark.slow
@pytest.mark.parametrize("count", [8, 16])
def test_a_leaf_bent_far_has_the_forces_of_its_free_body(count: int) -> None:
    """N, V and M at every station are those of the load at the tip: P across the tangent, P along it, P times its arm."""
    P = 10 * 2.1e11 * 0.02 * 0.004**3 / 12 / 4  # P L^2/(E I) = 10
    model = cantilever(count, tip=kt.NodalForce(node=f"n{count}", force=(0, P)))
    found = kt.statics.equilibrium(model)
    along = kt.strength.beams(model, found, stations=[0.0, 0.5, 1.0])
    x = found.data.position
    tip = x.sel(node=f"n{count}").values
    for i in range(count):
        a, b = x.sel(node=f"n{i}").values, x.sel(node=f"n{i + 1}").values
        M, T, V = (along[f"section_{name}"].sel(beam=f"b{i}").values.reshape(3, -1)[:, 0] for name in "MTV")
        assert M[[0, 2]] == pytest.approx([P * (tip[0] - a[0]), P * (tip[0] - b[0])], rel=1e-9, abs=1e-9 * P)
        assert np.hypot(T, V) == pytest.approx(P, rel=1e-9)
        assert along.end_force.sel(beam=f"b{i}", end="A").values == pytest.approx([0, -P], abs=1e-8 * P)
    # at the clamp the load is across the leaf, at the tip nearly along it
    first = along.sel(beam="b0", station=0.0)
    assert abs(float(first.section_T)) < 0.01 * P and float(first.section_V.sum()) == pytest.approx(P, rel=1e-4)
    about = found.reaction_moment.sel(support="n0").values
    assert along.end_moment.sel(beam="b0", end="A").values == pytest.approx(about, rel=1e-9)


@pytest.mark.slow
def test_a_circle_has_a_moment_and_no_axial_force() -> None:
    """Bent by an end moment M to the whole circle: N = V = 0 everywhere, M the same."""
    M = 2 * np.pi * 2.1e11 * 0.02 * 0.004**3 / 12 / 2
    model = cantilever(12, tip=kt.BodyCouple(body="n12", moment=M))
    along = kt.strength.beams(model, kt.statics.equilibrium(model))
    assert along.section_M.values == pytest.approx(M, rel=1e-9)
    for name in ("section_T", "section_V"):
        assert np.abs(along[name].values).max() < 1e-8 * M


@pytest.mark.slow
def test_a_bend_in_space_has_the_forces_of_its_free_body() -> None:
    """Bathe's bend of 45 degrees under 600: the resultants at all ends are the load and its moment."""
    count, R, P = 8, 100.0, 600.0
    angle = np.linspace(0, np.pi / 4, count + 1)
    model = kt.Model(
        nodes={f"n{i}": (R * np.sin(t), R * (1 - np.cos(t)), 0.0) for i, t in enumerate(angle)},
        clamped=["n0"],
        beams={f"b{i}": (f"n{i}", f"n{i + 1}") for i in range(count)},
        section=kt.Rectangle(width=1.0, height=1.0),
        material=kt.Material(E=1e7, density=1.0, poisson=0.0),
        loads={"tip": kt.NodalForce(node=f"n{count}", force=(0, 0, P))},
    )
    found = kt.statics.equilibrium(model)
    along = kt.strength.beams(model, found, stations=[0.0, 1.0])
    x, load = found.data.position, np.array([0, 0, P])
    tip = x.sel(node=f"n{count}").values
    for i in range(count):
        one = along.sel(beam=f"b{i}")
        for k, (end, sign) in enumerate((("A", -1.0), ("B", 1.0))):
            arm = tip - x.sel(node=f"n{i + k}").values
            assert one.end_force.sel(end=end).values == pytest.approx(sign * load, abs=1e-8 * P)
            assert one.end_moment.sel(end=end).values == pytest.approx(sign * np.cross(arm, load), abs=1e-7 * P * R)
            # the same in the axes of the section: as large, and split into torsion and bending
            here = one.isel(station=k)
            force = np.hypot(float(here.section_T), np.linalg.norm(here.section_V))
            moment = np.hypot(float(here.torsion), np.linalg.norm(here.section_M))
            assert force == pytest.approx(P, rel=1e-9)
            assert moment == pytest.approx(float(np.linalg.norm(np.cross(arm, load))), abs=1e-7 * P * R)


@pytest.mark.slow
def test_a_soft_pendulum_is_in_balance_at_every_joint() -> None:
    """Bent while it swings: no moment at the pin, the reaction there, and at nodes what one beam takes the other gives."""
    model = kt.Model(
        nodes={f"n{i}": (0.25 * i, 0) for i in range(5)},
        fixed=["n0"],
        beams={f"b{i}": (f"n{i}", f"n{i + 1}") for i in range(4)},
        section=kt.Rectangle(width=0.02, height=0.01),
        material=STEEL.with_(E=2e9),
        gravity=(0, -9.81),
    )
    run = kt.dynamics.simulate(model, 0.4, samples=5, method=kt.EnergyMomentum(step=2e-4))
    along = kt.strength.beams(model, run, stations=[0.0, 1.0])
    size = float(np.abs(along.end_moment).max())
    assert size > 0.3
    reaction = run.forces.data.reaction.sum("support").values
    assert along.end_force.sel(beam="b0", end="A").values == pytest.approx(reaction, abs=1e-9 * np.abs(reaction).max())
    assert np.abs(along.end_moment.sel(beam="b0", end="A")).max() < 1e-9 * size
    for i in range(3):
        for name in ("end_force", "end_moment"):
            one, two = (along[name].sel(beam=beam, end=end).values for beam, end in ((f"b{i}", "B"), (f"b{i + 1}", "A")))
            assert one[1:] == pytest.approx(-two[1:], abs=1e-8 * np.abs(two[1:]).max())
        first, second = (along.section_M.sel(beam=f"b{i + k}", station=1.0 - k).values for k in (0, 1))
        assert first == pytest.approx(second, abs=1e-9 * size)
