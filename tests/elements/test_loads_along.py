"""Loads along members: nodal forces, section forces and deflections in closed form, work and energy."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import unit_loads_of

STEEL = kt.Material(E=200e9, density=0.0)
RODS = {"section": kt.Rod(diameter=0.02), "material": STEEL}
L = 2.0


def supported(load, angle=0.0, **more):
    """A bar of length L on a pin, and on a post across it at the other end."""
    end = (L * np.cos(angle), L * np.sin(angle))
    return kt.Model(
        nodes={"A": (0, 0), "B": end, "D": (end[0] + np.sin(angle), end[1] - np.cos(angle))},
        fixed=["A", "D"], bars={"bar": ("A", "B"), "post": ("D", "B")}, loads={"q": load}, **RODS, **more,
    )  # fmt: skip


def simple_beam(q, shape, start, end, x):
    """V and M at x of a beam on two supports of span L under a load that pushes up, by quadrature of its free body."""
    at, weight = np.polynomial.legendre.leggauss(8)

    def over(lo, hi, arm):
        s = lo + (hi - lo) * 0.5 * (1 + at)
        load = q * (shape[0] + (shape[1] - shape[0]) * (s - start) / (end - start))
        return 0.5 * (hi - lo) * weight @ (load * arm(s)) if hi > lo else 0.0

    at_a = -over(start, end, lambda s: 1 - s / L)  # force of the support on the bar, up
    stop = np.clip(x, start, end)
    # what the part behind exerts on that before it
    return -(at_a + over(start, stop, np.ones_like)), at_a * x + over(start, stop, lambda s: x - s)


@settings(deadline=None, max_examples=12)
@given(
    q=st.integers(-3000, 3000),
    shape=st.tuples(st.integers(-10, 20), st.integers(-10, 20)),
    places=st.tuples(st.integers(0, 12), st.integers(1, 8)),
)
def test_section_forces_of_a_trapezoid_on_a_part_of_a_bar(q, shape, places):
    start, end, shape = places[0] / 10, (places[0] + places[1]) / 10, (shape[0] / 10, shape[1] / 10)
    load = kt.MemberLoad(member="bar", force=(0, q), shape=shape, start=start, end=end)
    model = supported(load)
    xi = np.linspace(0, 1, 23)
    found = kt.strength.sections(model, kt.runs.forces_at_rest(model), xi).data.sel(part="bar").isel(time=0)
    wanted = np.array([simple_beam(q, shape, start, end, L * s) for s in xi])
    scale = abs(q) * max(map(abs, shape)) * L + 1e-6
    np.testing.assert_allclose(found.section_V.sel(transverse="2"), wanted[:, 0], atol=1e-11 * scale)
    np.testing.assert_allclose(found.section_M.sel(moment="3"), wanted[:, 1], atol=1e-11 * scale)


def test_linear_statics_has_the_same_section_forces(tmp_path):
    load = kt.MemberLoad(member="bar", force=(200.0, -900.0), shape=(1, 0.2), start=0.3, end=1.7)
    model = supported(load, angle=0.4, runs={"rest": kt.Run(analysis="statics.linear")})
    wanted = kt.strength.sections(model, kt.runs.forces_at_rest(model), 9).data
    block = kt.run(model, "rest")
    found = kt.strength.sections(model, block.forces["all"], 9).data
    for name in ("section_T", "section_V", "section_M"):
        np.testing.assert_allclose(found[name], wanted[name], atol=1e-6)
    assert block.verdict.utilisation.sel(member="bar").max() > 0


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.5])
def test_a_load_in_the_axes_of_the_member_turns_with_it(angle):
    load = kt.MemberLoad(member="bar", force=(300.0, -500.0), axes="member", shape=(1, 2), start=0.5)
    level, turned = (supported(load, one) for one in (0.0, angle))
    for name in ("section_T", "section_V", "section_M"):
        one, two = (
            kt.strength.sections(model, kt.runs.forces_at_rest(model), 9).data[name].sel(part="bar").values
            for model in (level, turned)
        )
        if name != "section_T":
            np.testing.assert_allclose(two, one, atol=1e-9)
        np.testing.assert_allclose(two[:, -1] - two[:, 0], one[:, -1] - one[:, 0], atol=1e-9)


def test_a_couple_along_a_bar():
    """A uniform couple c: shear -cL/L everywhere, no bending; on half of the bar a triangle of bending."""
    model = supported(kt.MemberCouple(member="bar", moment=70.0))
    found = kt.strength.sections(model, kt.runs.forces_at_rest(model), 5).data.sel(part="bar")
    np.testing.assert_allclose(found.section_V, -70.0 * np.ones_like(found.section_V), atol=1e-10)
    np.testing.assert_allclose(found.section_M, 0.0, atol=1e-10)
    model = supported(kt.MemberCouple(member="bar", moment=70.0, shape=(0, 2), end=1.0))
    found = kt.strength.sections(model, kt.runs.forces_at_rest(model), [0, 0.25, 0.5, 0.75, 1]).data.sel(part="bar")
    # the whole couple 70 N m is balanced by forces of 35 N; M = 35 x - 70 x^2 up to 1 m, 35 x - 70 behind it
    np.testing.assert_allclose(found.section_M.values.ravel(), [0.0, 0.0, -35.0, -17.5, 0.0], atol=1e-10)


def test_loads_along_bars_in_space():
    """Forces along 2 and 3 of a bar with an orientation node, and the sections of a beam on two supports."""
    nodes = {"A": (0, 0, 0), "B": (1.2, 0, 1.6), "P": (0, 1, 0), "Q": (1, 1, 1.6), "R": (1.2, 2.0, 1.0), "O": (0.3, 0.4, 1)}
    model = kt.Model(
        nodes=nodes, fixed=["A", "P", "Q", "R", "O"], **RODS,
        bars={"bar": kt.Bar(ends=("A", "B"), orientation="O"), "a": ("P", "B"), "b": ("Q", "B"), "c": ("R", "B")},
        loads={"q": kt.MemberLoad(member="bar", force=(0, 40.0, 90.0), axes="member")},
    )  # fmt: skip
    forces = kt.runs.forces_at_rest(model)
    middle = kt.strength.sections(model, forces, [0.5]).data.sel(part="bar")
    # M3 = q2 x (x - L)/2 with M3' = -V2; M2' = V3
    np.testing.assert_allclose(middle.section_M.sel(moment="3"), -40 * L**2 / 8, atol=1e-10)
    np.testing.assert_allclose(middle.section_M.sel(moment="2"), 90 * L**2 / 8, atol=1e-10)
    u = np.array(nodes["B"]) / L
    two = np.array(nodes["O"]) - (u @ nodes["O"]) * u
    two /= np.linalg.norm(two)
    whole = L * (40 * two + 90 * np.cross(u, two))
    np.testing.assert_allclose(forces.data.reaction.sum("support")[0] + whole, 0.0, atol=1e-10)


def test_a_cantilever_under_a_triangle_on_a_part():
    """Section forces, and the deflection at the end: exact where the end of the load is a node, and so is it without one."""
    EI = 200e9 * np.pi * 0.02**4 / 64
    load = kt.MemberLoad(member="arm", force=(0, -800.0), shape=(0, 1), start=0.5, end=1.4)
    model = kt.Model(nodes={"A": (0, 0), "B": (L, 0)}, clamped=["A"], beams={"arm": ("A", "B")}, loads={"q": load}, **RODS)
    at, weight = np.polynomial.legendre.leggauss(8)
    s = 0.5 + 0.9 * 0.5 * (1 + at)
    q = 0.45 * weight * -800.0 * (s - 0.5) / 0.9
    found = kt.statics.linear(model)
    np.testing.assert_allclose(found.displacement.sel(node="B", axis="y"), q @ (s**2 * (3 * L - s) / (6 * EI)), rtol=1e-9)
    cut = kt.strength.beams(model, found, stations=[0.0, 0.4, 0.7, 1.0]).sel(beam="arm")
    moment = [-(q @ s), None, 0.0, 0.0]
    # moment at 0.8 m: of the load behind it
    t = 0.8 + 0.6 * 0.5 * (1 + at)
    moment[1] = -(0.3 * weight * -800.0 * (t - 0.5) / 0.9) @ (t - 0.8)
    np.testing.assert_allclose(-cut.section_M.sel(moment="3").values, moment, atol=1e-8)
    np.testing.assert_allclose(cut.section_V.sel(transverse="2").values[[0, 2, 3]], [q.sum(), 0.0, 0.0], atol=1e-8)


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("member", ["bar", "beam"])
def test_loads_that_turn_have_the_same_size_everywhere(dim, member):
    rng = np.random.default_rng(3)
    places = {name: tuple(rng.normal(size=dim)) for name in "ABCDE"}
    parts = {"bars": {"m": kt.Bar(ends=("A", "B"), orientation="E") if dim == 3 else ("A", "B")}}
    if member == "beam":
        parts = {"beams": {"m": ("A", "B")}}
    load = kt.MemberLoad(member="m", force=tuple(rng.normal(size=dim)), axes="member", shape=(1, 0.3), start=0.1)
    model = kt.Model(
        nodes=places, clamped=["A"] if member == "beam" else (), fixed=["C", "D"], loads={"q": load}, **parts, **RODS
    )
    system = compile(model)
    x = system.x0 + 0.1 * rng.normal(size=system.x0.shape)
    if dim == 2:
        x[:, 2] = 0.0
    for unit in unit_loads_of(system, "q"):
        r = x[unit.nodes]
        step = 1e-6 * rng.normal(size=r.shape)
        change = (unit.forces(r + step) - unit.forces(r - step)).reshape(-1) / 2
        np.testing.assert_allclose(unit.tangent(r) @ step.reshape(-1), change, atol=1e-13)
        whole = unit.forces(x[unit.nodes])
        # a force in the axes of the member has the same size everywhere
        np.testing.assert_allclose(
            np.linalg.norm(whole.sum(axis=0)), np.linalg.norm(unit.forces(r + step).sum(axis=0)), rtol=1e-12
        )


@pytest.mark.parametrize("axes", ["global", "member"])
def test_energy_of_a_pendulum_under_a_load_along_it(axes):
    """Work of a load along a swinging bar: its power closes the balance; forward after inverse gives the same motion."""
    load = kt.MemberLoad(
        member="bar", times=(0, 1, 2), forces=((0, -30), (20, 5), (-40, 10)), shape=(1, 2), start=0.3, axes=axes
    )
    heavy = kt.Material(E=200e9, density=7800.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"bar": ("A", "B")}, loads={"q": load}, gravity=(0, -9.81),
        section=kt.Rod(diameter=0.02), material=heavy,
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 2.0, samples=41, method=kt.DOP853(rtol=1e-11, atol=1e-12))
    forces = kt.dynamics.inverse(model, run.motion)
    np.testing.assert_allclose(forces.data.energy_balance, 0.0, atol=1e-6)
    xi = np.linspace(0, 1, 7)
    found = kt.strength.sections(model, forces, xi).data
    np.testing.assert_allclose(found.section_M.values[:, :, [0, -1]], 0.0, atol=1e-8)
    # the other method, by series or by steps of its own, ends at the same place
    other = kt.dynamics.simulate(model, 2.0, samples=41, method=kt.Radau(rtol=1e-10, atol=1e-11))
    np.testing.assert_allclose(other.motion.position, run.motion.position, atol=1e-6)


def test_a_load_along_a_beam_that_is_driven():
    """Against the same motion without the load: torque q L^2/2 of the drive, q L^2/8 in the middle of the beam."""
    plain = kt.Model(
        nodes={"A": (0, 0), "B": (L, 0)}, fixed=["A"], beams={"arm": ("A", "B")}, gravity=(0, -9.81), **RODS,
        drives={"turn": kt.AngleDrive("arm.chord")},
    )  # fmt: skip
    loaded = plain.with_(loads={"q": kt.MemberLoad(member="arm", force=(10, -50.0), axes="member")})
    found = []
    for model in (plain, loaded):
        motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 1.0}, duration=1.0), samples=5)
        forces = kt.dynamics.inverse(model, motion)
        np.testing.assert_allclose(forces.data.energy_balance, 0.0, atol=1e-11)
        moment = kt.strength.beams(model, forces, stations=[0, 0.5, 1.0]).section_M.sel(beam="arm", moment="3").values
        found.append((forces.drive_force.values[:, 0], moment))
    np.testing.assert_allclose(found[1][0] - found[0][0], 50 * L**2 / 2, rtol=1e-12)
    np.testing.assert_allclose(found[1][1] - found[0][1], np.tile([0.0, 50 * L**2 / 8, 0.0], (5, 1)), atol=1e-9)


def test_a_beam_turned_by_a_load_in_its_axes():
    """A cantilever bent into a circle of small curvature by a load that stays across its chord: large against small loads."""
    load = kt.MemberLoad(member="arm", force=(0, 0.5), axes="member")
    model = kt.Model(nodes={"A": (0, 0), "B": (L, 0)}, clamped=["A"], beams={"arm": ("A", "B")}, loads={"q": load}, **RODS)
    small, large = kt.statics.linear(model), kt.statics.equilibrium(model)
    moved = large.position.sel(node="B", axis="y").item()
    np.testing.assert_allclose(moved, small.displacement.sel(node="B", axis="y").item(), rtol=1e-4)


@pytest.mark.parametrize(
    ("load", "words"),
    [
        (kt.MemberLoad(member="bar", force=(0, 1), end=3.0), r"loads\.q\.end: is 3 m along 'bar', which is 2 m long"),
        (
            kt.MemberLoad(member="bar", force=(0, 1), start=1.5, end=1.0),
            r"loads\.q\.start: is 1.5 m, not before the end",
        ),
        (kt.MemberLoad(member="bra", force=(0, 1)), r"loads\.q\.member: no bar, active member, beam or link called 'bra'.*bar"),
        (kt.MemberLoad(member="bar", force=(0, 1, 2)), r"loads\.q\.force: has 3 components"),
    ],
)
def test_faults(load, words):
    with pytest.raises(kt.ModelError, match=words):
        kt.check(supported(load))


def test_couples_need_a_bar_of_the_plane():
    space = kt.Model(nodes={"A": (0, 0, 0), "B": (1, 0, 0)}, fixed=["A"], bars={"bar": ("A", "B")}, **RODS)
    with pytest.raises(kt.ModelError, match="couple on a bar in space"):
        kt.check(space.with_(loads={"c": kt.MemberCouple(member="bar", moment=1.0)}))
    with pytest.raises(kt.ModelError, match="sum is 0"):
        kt.MemberCouple(member="bar", moment=1.0, shape=(1, -1))
    rope = kt.Bar(ends=("A", "B"), kind="cable", stiffness=1e3)
    with pytest.raises(kt.ModelError, match="between the ends of the cable bar 'bar'"):
        kt.check(space.with_(bars={"bar": rope}, loads={"q": kt.MemberLoad(member="bar", force=(0, 1, 0))}))
