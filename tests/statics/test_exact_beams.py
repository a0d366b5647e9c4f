"""Beams with strains and rotations of any size: closed forms with few elements, orders, shear, and what stays without it."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_energy, element_forces
from kinetruss.verification import large_bending as cases
from kinetruss.verification.beams import line, row
from reference import rods

SOFT = kt.Material(E=1e4, density=1.0, poisson=0.25)
SECTION = kt.General(area=1.0, I2=0.01, I3=0.01, c2=0.1, c3=0.1, J=0.02)


def turned(model: kt.Model, node: str) -> np.ndarray:
    """Axes of the frame of a node in equilibrium, as rows."""
    at = kt.statics.equilibrium(model).whole["position"]
    axes = [at.sel(node=f"{node}.d{k + 1}").values - at.sel(node=node).values for k in range(model.dim)]
    return np.array([axis / np.linalg.norm(axis) for axis in axes])


def test_one_element_twists_by_any_angle_below_half_a_turn():
    angle = 2.5
    couple = kt.BodyCouple(body="N1", moment=(0.4 * SOFT.E * SECTION.J * angle, 0, 0))
    axes = turned(kt.Model(**row(line(1, 3), section=SECTION, loads={"T": couple}) | {"material": SOFT}), "N1")
    assert math.atan2(axes[1, 2], axes[1, 1]) == pytest.approx(angle, rel=1e-12)


@pytest.mark.parametrize("count", [1, 2])
def test_an_arc_turns_exactly_and_closes_with_the_sixth_power_of_its_angle(count):
    """Under an end moment M the section turns by M L/(E I); f/sin(f) has 31 f^6/15120 after the terms of the element."""
    turn, R = 1.0, 1.0
    couple = kt.BodyCouple(body=f"N{count}", moment=SOFT.E * SECTION.I3 * turn)
    model = kt.Model(**row(line(count), section=SECTION, loads={"M": couple}) | {"material": SOFT})
    at = kt.statics.equilibrium(model).whole["position"]
    axes = turned(model, f"N{count}")
    assert math.atan2(axes[0, 1], axes[0, 0]) == pytest.approx(turn, rel=1e-12)
    x, y = at.sel(node=f"N{count}").values
    assert abs(math.hypot(x, y) - 2 * R * math.sin(0.5 * turn)) < 3.3e-5 * (turn / count) ** 6


@pytest.mark.slow
def test_bending_about_both_axes_with_twist_converges_with_order_4():
    """A strip four times as wide as thick: the twist that grows along it is in the element."""
    torsion = kt.Rectangle(width=rods.STRIP["thickness"], height=rods.STRIP["width"]).torsion_constant
    exact = rods.princeton(torsion, 8.896, 45.0)
    off = [np.linalg.norm([*cases.princeton(k, 8.896, 45).values()] - exact) for k in (4, 8)]
    assert off[1] < 2e-6 * np.linalg.norm(exact)
    assert 3.8 < math.log2(off[0] / off[1]) < 4.2


@pytest.mark.slow
@pytest.mark.parametrize(("case", "exact", "least"), [(cases.heavy, rods.heavy, 3e-6), (cases.sheared, rods.sheared, 8e-6)])
def test_thick_beams_converge_to_the_rod(case, exact, least):
    """Order 2 or better, with an error of the square of the strains."""
    tip = exact()
    off = [float(np.hypot(*(np.array([*case(k).values()]) - tip))) for k in (8, 16)]
    assert off[1] < least
    assert off[0] > 3.3 * off[1]


def test_a_column_beside_its_critical_load_is_found():
    """Pushed by 1e-9 across, at a load that is critical but for 1e-7: y (c + k y^2) is the push."""
    count, euler = 16, math.pi**2 / 4
    EA = euler / 0.01
    push = kt.NodalForce(node=f"N{count}", force=(-1.010205078125 * euler, 1e-9))
    section = kt.General(area=1.0, I2=1 / EA, I3=1 / EA, c2=0.1, c3=0.1)
    column = kt.Model(**row(line(count), section=section, loads={"P": push}) | {"material": kt.Material(E=EA, density=1.0)})
    found = kt.statics.equilibrium(column)
    assert found.attrs["residual"] < 1e-10
    assert 1e-4 < float(found.position.sel(node=f"N{count}", axis="y")) < 2e-3


def test_very_large_shear_areas_change_nothing():
    stiff = SECTION.with_(A2=1e9, A3=1e9)
    push = kt.NodalForce(node="N2", force=(3.0, 20.0, -10.0))
    places = [
        kt.statics.equilibrium(kt.Model(**row(line(2, 3), section=one, loads={"P": push}) | {"material": SOFT})).position
        for one in (SECTION, stiff)
    ]
    np.testing.assert_allclose(*places, rtol=0, atol=1e-9)


@pytest.mark.parametrize("plain", [kt.Rectangle(width=0.2, height=0.3), kt.Rod(diameter=0.2), kt.Tube(outer=0.3, inner=0.2)])
def test_a_coefficient_is_a_shear_area_over_the_area(plain):
    force, moved = 0.1, []
    for section in (plain, plain.with_(shear_coefficient=0.8)):
        model = kt.Model(
            **row(line(1), section=section, loads={"P": kt.NodalForce(node="N1", force=(0.0, force))}) | {"material": SOFT}
        )
        moved.append(float(kt.statics.linear(model).displacement.sel(node="N1", axis="y")))
    assert moved[1] - moved[0] == pytest.approx(force / (0.4 * SOFT.E * 0.8 * plain.area), rel=1e-9)


def test_one_shear_area_of_two_is_a_fault():
    with pytest.raises((InputError, ValueError), match="Give A2 and A3"):
        kt.General(area=1.0, I2=0.01, I3=0.01, c2=0.1, c3=0.1, A2=0.5)


@pytest.mark.slow
def test_sections_that_lean_have_their_own_axial_and_shear_force():
    """At the clamp the section stands across x: N and V are the load."""
    found = {}
    for count in (8, 16):
        push = kt.NodalForce(node=f"N{count}", force=(-2.0, 6.0))
        section = kt.General(area=1.0, I2=2.5e-3, I3=2.5e-3, c2=0.1, c3=0.1, A2=0.25, A3=0.25)
        model = kt.Model(**row(line(count), section=section, loads={"P": push}) | {"material": SOFT})
        rest = kt.statics.equilibrium(model)
        clamp = kt.strength.beams(model, rest, stations=[0.0]).sel(beam="b0", station=0.0)
        found[count] = [float(clamp.section_T) + 2.0, float(clamp.section_V.item()) - 6.0]
        x, y = rest.position.sel(node=f"N{count}").values
        assert float(clamp.section_M.item()) == pytest.approx(6.0 * x + 2.0 * y, rel=1e-8)
    assert np.abs(found[16]).max() < 1.5e-5
    assert np.abs(found[16]).max() < 0.6 * np.abs(found[8]).max()


@pytest.mark.parametrize("dim", [2, 3])
def test_rigid_motions_of_sheared_beams_give_no_energy_and_no_force(dim):
    section = SECTION.with_(A2=0.3, A3=0.6)
    system = compile(kt.Model(**row([(0, 0, 0)[:dim], (1, 0.3, 0.2)[:dim]], section=section) | {"material": SOFT}))
    c, s = math.cos(2.0), math.sin(2.0)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    if dim == 3:
        turn = np.array([[1, 0, 0], [0, s, -c], [0, c, s]]) @ turn
    x = system.x0 @ turn.T + [3.0, -2.0, 0.0]
    assert element_energy(system, x) < 1e-20
    assert np.abs(element_forces(system, x)).max() < 1e-9
