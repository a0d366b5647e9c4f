"""Frames under loads between their joints, against closed forms of the stiffness and force methods.

Members hardly stretch (area 1 m^2 against second moments of 1e-6 m^4), as the closed forms have it. Forms 1 to 8 follow from
the beam's equation E I w'''' = q with its end conditions; those of portals from the slope-deflection equations, in which a
member has the moments 2 E I/l (2 phi_A + phi_B - 3 psi) and what a load on it makes at clamped ends.
"""

import numpy as np
import pytest

import kinetruss as kt

E, INERTIA, L, H = 200e9, 1e-6, 4.0, 3.0
EI = E * INERTIA
STEEL = kt.Material(E=E, density=0.0)


def section(inertia=INERTIA):
    return kt.General(area=1.0, I2=inertia, I3=inertia, c2=0.1, c3=0.1)


def frame(nodes, beams, loads, clamped=(), pinned=(), **more):
    model = kt.Model(
        nodes=nodes, clamped=list(clamped), fixed=pinned, beams=beams, loads=loads, material=STEEL, section=section(), **more
    )
    found = kt.statics.linear(model)
    return model, found, kt.strength.beams(model, found, stations=[0.0, 0.5, 1.0])


def moments(cut, beam):
    """Moments of both nodes on a beam, counter-clockwise."""
    return cut.end_moment.sel(beam=beam).values.ravel()


def span(load, clamped=("A", "B"), pinned=()):
    _, found, cut = frame({"A": (0, 0), "B": (L, 0)}, {"beam": ("A", "B")}, {"q": load}, clamped, pinned)
    return found, cut


def test_1_clamped_under_a_triangle():
    """q l^2/30 where it is 0, q l^2/20 where it is q."""
    _, cut = span(kt.MemberLoad(member="beam", force=(0, -900.0), shape=(0, 1)))
    np.testing.assert_allclose(moments(cut, "beam"), 900 * L**2 * np.array([1 / 30, -1 / 20]), rtol=1e-8)


def test_2_clamped_under_half_a_uniform_load():
    """11 q l^2/192 and 5 q l^2/192."""
    _, cut = span(kt.MemberLoad(member="beam", force=(0, -900.0), end="50 %"))
    np.testing.assert_allclose(moments(cut, "beam"), 900 * L**2 * np.array([11, -5]) / 192, rtol=1e-8)


def test_3_clamped_under_a_trapezoid():
    """From q to 3 q: those of a uniform load and of a triangle."""
    _, cut = span(kt.MemberLoad(member="beam", force=(0, -900.0), shape=(1, 3)))
    wanted = 900 * L**2 * np.array([1 / 12 + 2 / 30, -1 / 12 - 2 / 20])
    np.testing.assert_allclose(moments(cut, "beam"), wanted, rtol=1e-8)


def test_4_clamped_under_two_forces_at_thirds():
    """2 P l/9 at both ends."""
    model = {"A": (0, 0), "B": (L, 0)}, {"beam": ("A", "B")}
    loads = {
        name: kt.MemberPointForce(member="beam", force=(0, -500.0), at=at) for name, at in (("a", L / 3), ("b", 2 * L / 3))
    }
    _, _, cut = frame(*model, loads, ("A", "B"))
    np.testing.assert_allclose(moments(cut, "beam"), 500 * L * np.array([2, -2]) / 9, rtol=1e-8)


def test_5_propped_under_a_force_in_the_middle():
    """Clamped at A, on a support at B: M_A = 3 P l/16, R_B = 5 P/16."""
    found, cut = span(kt.MemberPointForce(member="beam", force=(0, -500.0), at="50 %"), ("A",), ["B"])
    np.testing.assert_allclose(moments(cut, "beam"), [3 * 500 * L / 16, 0.0], atol=1e-5)
    np.testing.assert_allclose(found.reaction.sel(support="B", axis="y"), 5 * 500 / 16, rtol=1e-7)


def test_6_propped_under_a_couple_in_the_middle():
    """M_A = C/8, R_B = 9 C/(8 l), down."""
    found, cut = span(kt.MemberPointCouple(member="beam", moment=700.0, at="50 %"), ("A",), ["B"])
    np.testing.assert_allclose(moments(cut, "beam"), [700 / 8, 0.0], atol=1e-5)
    np.testing.assert_allclose(found.reaction.sel(support="B", axis="y"), -9 * 700 / (8 * L), rtol=1e-7)


def continuous(load):
    nodes = {"A": (0, 0), "B": (L, 0), "C": (2 * L, 0)}
    return frame(nodes, {"one": ("A", "B"), "two": ("B", "C")}, load, pinned=["A", "B", "C"])


def test_7_two_spans_under_a_uniform_load():
    """q l^2/8 over the middle support, reactions 3/8, 10/8, 3/8 of q l."""
    loads = {name: kt.MemberLoad(member=name, force=(0, -900.0)) for name in ("one", "two")}
    _, found, cut = continuous(loads)
    np.testing.assert_allclose(moments(cut, "one")[1], -900 * L**2 / 8, rtol=1e-7)
    np.testing.assert_allclose(found.reaction.sel(axis="y"), 900 * L * np.array([3, 10, 3]) / 8, rtol=1e-7)


def test_8_two_spans_under_a_force_in_the_middle_of_one():
    """3 P l/32 over the middle support, reactions 13/32, 22/32, -3/32 of P."""
    _, found, cut = continuous({"P": kt.MemberPointForce(member="one", force=(0, -500.0), at="50 %")})
    np.testing.assert_allclose(moments(cut, "one")[1], -3 * 500 * L / 32, rtol=1e-7)
    np.testing.assert_allclose(found.reaction.sel(axis="y"), 500 * np.array([13, 22, -3]) / 32, rtol=1e-7)


# A portal: clamped columns A-B and D-C of the height h, a girder B-C of the span l.


def portal(loads, girder=2.0):
    nodes = {"A": (0, 0), "B": (0, H), "C": (L, H), "D": (L, 0)}
    beams = {"left": ("A", "B"), "girder": kt.Beam(ends=("B", "C"), section=section(girder * INERTIA)), "right": ("D", "C")}
    return frame(nodes, beams, loads, ("A", "D"))


def slope_deflection(clamped, girder, push=0.0):
    """Moments at A, D of a portal by slope deflection: `clamped` (3, 2) those of the loads on left (A, B), girder (B, C) and
    right (D, C), by the supports on members, counter-clockwise; `push` : horizontal force at the girder with all joints held.
    """
    c, g = 2 * EI / H, 2 * EI * girder / L
    # unknowns phi_B, phi_C, psi of the columns (counter-clockwise); moments at joints, and the forces of the columns
    K = np.array([[2 * c + 2 * g, g, -3 * c], [g, 2 * c + 2 * g, -3 * c], [-3 * c, -3 * c, 12 * c]])
    (_, b1), (b2, c1), (_, c2) = clamped
    right = -np.array([b1 + b2, c1 + c2, 0.0])
    # columns turn by psi: the work of the clamping moments and of the push on it
    right[2] = sum(clamped[0]) + sum(clamped[2]) - push * H
    phi_b, phi_c, psi = np.linalg.solve(K, right)
    return clamped[0][0] + c * (phi_b - 3 * psi), clamped[2][0] + c * (phi_c - 3 * psi)


@pytest.mark.parametrize("girder", [0.5, 2.0])
def test_9_a_portal_under_a_uniform_load_on_its_girder(girder):
    """With k = I_g h/(I_c l): q l^2/(12 (k + 2)) at the feet, twice that at the corners."""
    _, _, cut = portal({"q": kt.MemberLoad(member="girder", force=(0, -900.0))}, girder)
    k = girder * H / L
    foot = 900 * L**2 / (12 * (k + 2))
    wanted = slope_deflection([(0, 0), (900 * L**2 / 12, -900 * L**2 / 12), (0, 0)], girder)
    np.testing.assert_allclose(wanted, [-foot, foot], rtol=1e-12)
    np.testing.assert_allclose([moments(cut, "left")[0], moments(cut, "right")[0]], wanted, rtol=2e-5)
    np.testing.assert_allclose(moments(cut, "girder"), [2 * foot, -2 * foot], rtol=2e-5)


def test_10_a_portal_under_a_force_on_its_girder():
    """In the middle: P l/(8 (k + 2)) at the feet; at a quarter by slope deflection, with sway."""
    _, _, cut = portal({"P": kt.MemberPointForce(member="girder", force=(0, -500.0), at="50 %")})
    foot = 500 * L / (8 * (2 * H / L + 2))
    np.testing.assert_allclose(np.abs([moments(cut, "left")[0], moments(cut, "right")[0]]), foot, rtol=2e-5)
    _, _, cut = portal({"P": kt.MemberPointForce(member="girder", force=(0, -500.0), at="25 %")})
    held = 500 * L * np.array([9, -3]) / 64  # P a b^2/l^2, P a^2 b/l^2
    wanted = slope_deflection([(0, 0), held, (0, 0)], 2.0)
    np.testing.assert_allclose([moments(cut, "left")[0], moments(cut, "right")[0]], wanted, rtol=2e-4)


def test_11_a_portal_under_wind_on_a_column():
    """Uniform on the left column: clamping moments w h^2/12, and w h/2 on the girder."""
    _, found, cut = portal({"w": kt.MemberLoad(member="left", force=(600.0, 0))})
    held = 600 * H**2 / 12
    wanted = slope_deflection([(held, -held), (0, 0), (0, 0)], 2.0, push=600 * H / 2)
    np.testing.assert_allclose([moments(cut, "left")[0], moments(cut, "right")[0]], wanted, rtol=2e-4)
    np.testing.assert_allclose(found.reaction.sel(axis="x").sum(), -600 * H, rtol=1e-8)


def test_12_three_hinged_rafters_under_snow():
    """Two bars that meet at a ridge: thrust s l^2/(8 f), moment s (l/2)^2/8 in the middle of each."""
    f = 1.5
    model = kt.Model(
        nodes={"A": (0, 0), "C": (L / 2, f), "B": (L, 0)}, fixed=["A", "B"], bars={"one": ("A", "C"), "two": ("B", "C")},
        loads={name: kt.MemberLoad(member=name, force=(0, -800.0), per="projection") for name in ("one", "two")},
        section=kt.Rod(diameter=0.1), material=STEEL,
    )  # fmt: skip
    forces = kt.runs.forces_at_rest(model)
    thrust = 800 * L**2 / (8 * f)
    held = forces.data.reaction.isel(time=0)
    np.testing.assert_allclose(held.values, [[thrust, 800 * L / 2], [-thrust, 800 * L / 2]], rtol=1e-10)
    middle = kt.strength.sections(model, forces, [0.5]).data.section_M.sel(moment="3").values.ravel()
    np.testing.assert_allclose(np.abs(middle), 800 * (L / 2) ** 2 / 8, rtol=1e-10)


def test_13_a_force_between_joints_of_a_truss():
    """A triangle with P at a third of its lower chord: joints as under 2 P/3 and P/3, the chord bent by 2 P l/9."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (3, 0), "C": (1.5, 2)}, fixed={"A": "xy", "B": "y"},
        bars={"chord": ("A", "B"), "a": ("A", "C"), "b": ("B", "C")}, section=kt.Rod(diameter=0.1), material=STEEL,
        loads={"P": kt.MemberPointForce(member="chord", force=(0, -900.0), at=1.0)},
    )  # fmt: skip
    forces = kt.runs.forces_at_rest(model)
    np.testing.assert_allclose(forces.data.reaction.sel(axis="y").values[0], [600, 300], rtol=1e-12)
    np.testing.assert_allclose(forces.data.member_force.values[0], 0.0, atol=1e-9)
    found = kt.strength.sections(model, forces, [1 / 3]).data.sel(part="chord")
    np.testing.assert_allclose(np.abs(found.section_M.values.ravel()), 2 * 900 * 3 / 9, rtol=1e-12)


def test_14_a_grid_in_space():
    """A right-angled cantilever with a force at half of its second leg: torsion P l/2 in the first, moments by hand."""
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (L, 0, 0), "C": (L, 2.0, 0)}, clamped=["A"], beams={"one": ("A", "B"), "two": ("B", "C")},
        loads={"P": kt.MemberPointForce(member="two", force=(0, 0, -500.0), at="50 %")}, material=STEEL,
        section=kt.Tube(outer=0.1, inner=0.09),
    )  # fmt: skip
    cut = kt.strength.beams(model, kt.statics.linear(model), stations=[0.0, 1.0])
    one, two = cut.sel(beam="one"), cut.sel(beam="two")
    np.testing.assert_allclose(np.abs(one.torsion), 500.0, rtol=1e-7)
    np.testing.assert_allclose(np.linalg.norm(one.section_M, axis=-1), [500 * L, 0.0], atol=1e-4)
    np.testing.assert_allclose(np.linalg.norm(two.section_M, axis=-1), [500.0, 0.0], atol=1e-4)
