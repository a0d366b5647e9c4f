"""Loads at places of members, on their projection, on active members, and couples on beams: closed forms and virtual work."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import action_models
import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import case_loads, unit_loads_of

STEEL = kt.Material(E=200e9, density=0.0)
RODS = {"section": kt.Rod(diameter=0.02), "material": STEEL}
EI, L = 200e9 * np.pi * 0.02**4 / 64, 2.0


def supported(load, angle=0.0, **more):
    """A bar of length L on a pin, and on a post across it at the other end."""
    end = (L * np.cos(angle), L * np.sin(angle))
    return kt.Model(
        nodes={"A": (0, 0), "B": end, "D": (end[0] + np.sin(angle), end[1] - np.cos(angle))},
        fixed=["A", "D"], bars={"bar": ("A", "B"), "post": ("D", "B")}, loads={"q": load}, **RODS, **more,
    )  # fmt: skip


def beam(load, clamped=("A",), dim=2, **more):
    """A beam of length L along x."""
    held = {"fixed": [one for one in "AB" if one not in clamped]} if clamped != ("A",) else {}
    return kt.Model(
        nodes={"A": (0, 0, 0)[:dim], "B": (L, 0, 0)[:dim]}, clamped=list(clamped), beams={"arm": ("A", "B")},
        loads={"q": load}, **RODS, **held, **more,
    )  # fmt: skip


def along(model, xi, forces=None, part="bar"):
    found = kt.strength.sections(model, forces or kt.runs.forces_at_rest(model), xi).data.sel(part=part)
    return found.section_V.sel(transverse="2").values, found.section_M.sel(moment="3").values


# A bar on two supports.


@settings(deadline=None, max_examples=15)
@given(place=st.integers(1, 39), size=st.integers(-3000, 3000), angle=st.integers(0, 3))
def test_a_force_on_a_bar_on_two_supports(place, size, angle):
    """M = P a b/l under the force, the shear force jumps by P there, and the reactions add up to it."""
    a = place / 20
    model = supported(kt.MemberPointForce(member="bar", force=(0, size), at=a, axes="member"), 0.4 * angle)
    forces = kt.runs.forces_at_rest(model)
    behind = np.nextafter(a / L, 1.0)
    V, M = along(model, [0.0, a / L, behind, 1.0], forces)
    np.testing.assert_allclose(M[0], np.array([0, 1, 1, 0]) * -size * a * (L - a) / L, atol=1e-9 * (1 + abs(size)))
    np.testing.assert_allclose(V[0, 2] - V[0, 1], -size, atol=1e-9 * (1 + abs(size)))
    across = size * np.array([-np.sin(0.4 * angle), np.cos(0.4 * angle)])
    np.testing.assert_allclose(forces.data.reaction.sum("support").values[0], -across, atol=1e-9 * (1 + abs(size)))


def test_the_largest_moment_is_under_the_force():
    """`strength.check` finds it between its stations."""
    a, size = 0.7367, 900.0
    model = supported(kt.MemberPointForce(member="bar", force=(0, -size), at=a)).with_(
        material=STEEL.with_(yield_strength=235e6)
    )
    worst = kt.strength.check(model, kt.runs.forces_at_rest(model), stations=2).data.sel(part="bar", rule="yield")
    bending = size * a * (L - a) / L * 32 / (np.pi * 0.02**3)
    np.testing.assert_allclose(worst.position, a, rtol=1e-9)
    np.testing.assert_allclose(worst.value, bending, rtol=1e-3)  # beside the shear stress of the same section
    assert worst.value >= bending * (1 - 1e-12)


def test_a_share_is_a_place():
    one, two = (along(supported(kt.MemberPointForce(member="bar", force=(0, -5.0), at=at)), 9) for at in ("37.5 %", 0.375 * L))
    np.testing.assert_array_equal(one, two)
    part = [kt.MemberLoad(member="bar", force=(0, -5.0), start=a, end=b) for a, b in (("25%", "75 %"), (0.5, 1.5))]
    np.testing.assert_allclose(*(along(supported(load), 9) for load in part), atol=1e-12)


@settings(deadline=None, max_examples=10)
@given(place=st.integers(5, 35), forces=st.tuples(st.integers(-900, 900), st.integers(-900, 900)), member=st.booleans())
def test_a_force_is_the_limit_of_a_short_load(place, forces, member):
    """On 2 e of the length: nodal forces are those of the force, M differs under it by P e/4 (order 1)."""
    a, axes = place / 20, "member" if member else "global"
    point = supported(kt.MemberPointForce(member="bar", force=forces, at=a, axes=axes), 0.3)
    wanted = along(point, [a / L])[1]
    for e in (0.02, 0.01):
        short = kt.MemberLoad(member="bar", force=tuple(f / (2 * e) for f in forces), start=a - e, end=a + e, axes=axes)
        model = supported(short, 0.3)
        x = compile(model).x0
        one, two = (case_loads(compile(m), np.zeros(1), None).at(x[None]) for m in (point, model))
        np.testing.assert_allclose(two.force.sum(axis=1), one.force.sum(axis=1), atol=1e-9)
        across = forces[1] if member else forces[1] * np.cos(0.3) - forces[0] * np.sin(0.3)
        np.testing.assert_allclose(along(model, [a / L])[1] - wanted, across * e / 4, atol=1e-8)


def test_a_couple_at_a_place_of_a_bar():
    """Shear -C/l, the moment falls by C at the place."""
    model = supported(kt.MemberPointCouple(member="bar", moment=70.0, at="25 %"))
    V, M = along(model, [0.0, 0.25, np.nextafter(0.25, 1), 1.0])
    np.testing.assert_allclose(V, -70 / L, atol=1e-10)
    np.testing.assert_allclose(M[0], [0, 17.5, -52.5, 0], atol=1e-10)


@pytest.mark.parametrize("axes", ["global", "member"])
def test_a_pendulum_with_a_force_on_it(axes):
    """M = P_2 a b/l at the force in motion, beside what the bar's own mass does; free body and energy are in balance."""
    heavy = kt.Material(E=200e9, density=7800.0)
    pendulum = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"bar": ("A", "B")}, gravity=(0, -9.81),
        section=kt.Rod(diameter=0.02), material=heavy, drives={"turn": kt.AngleDrive("bar")},
    )  # fmt: skip
    a, push = 0.3, (40.0, -90.0)
    loaded = pendulum.with_(loads={"q": kt.MemberPointForce(member="bar", force=push, at=a, axes=axes)})
    motion = kt.kinematics.follow(loaded, kt.ConstantRate(rates={"turn": 1.3}, duration=1.0), samples=5)
    one, two = (kt.dynamics.inverse(model, motion) for model in (pendulum, loaded))
    u = motion.position.sel(node="B").values
    P = np.tile(push, (5, 1)) if axes == "global" else push[0] * u + push[1] * np.stack([-u[:, 1], u[:, 0]], axis=1)
    across = u[:, 0] * P[:, 1] - u[:, 1] * P[:, 0]
    added = two.data.drive_force.values[:, 0] - one.data.drive_force.values[:, 0]
    np.testing.assert_allclose(added, -across * a, atol=1e-9)
    # held at A by the drive: the moment of the force about the section
    difference = along(loaded, [0.1, a, 0.8], two)[1] - along(pendulum, [0.1, a, 0.8], one)[1]
    np.testing.assert_allclose(difference, np.stack([across * (a - 0.1), 0 * across, 0 * across], axis=1), atol=1e-9)
    np.testing.assert_allclose(two.data.energy_balance, 0.0, atol=1e-8)
    body = kt.dynamics.free_body(loaded, motion, two, member="bar", time=0.5)
    assert body.residual < 1e-9
    assert any(term.symbol == "P" for term in body.bodies[0].terms)


def test_a_bar_that_flies_with_a_force_between_pin_ended_members():
    """A pin-ended bar of a linkage in motion: P a b/l beside the same motion without the force."""
    plain = kt.library.mechanisms.four_bar()
    name = "coupler"
    motion = kt.kinematics.follow(plain, kt.ConstantRate(rates={"motor": 1.0}, duration=1.0), samples=7)
    length = float(motion.data.length.sel(member=name).values[0])
    a = 0.3 * length
    loaded = plain.with_(loads={**plain.loads, "P": kt.MemberPointForce(member=name, force=(0, 55.0), at=a, axes="member")})
    one, two = (kt.dynamics.inverse(model, motion) for model in (plain, loaded))
    difference = along(loaded, [0.0, 0.3, 1.0], two, name)[1] - along(plain, [0.0, 0.3, 1.0], one, name)[1]
    wanted = np.tile([0.0, -55.0 * a * (length - a) / length, 0.0], (7, 1))
    np.testing.assert_allclose(difference, wanted, atol=1e-8)


# The projection: snow.


@pytest.mark.parametrize("angle", [0.0, 0.4, 1.1, np.pi / 2])
def test_snow_on_an_inclined_bar(angle):
    """Whole s l cos, moment in the middle s (l cos)^2/8."""
    model = supported(kt.MemberLoad(member="bar", force=(0, -1000.0), per="projection"), angle)
    forces, level = kt.runs.forces_at_rest(model), L * np.cos(angle)
    np.testing.assert_allclose(forces.data.reaction.sum("support").values[0], [0, 1000 * level], atol=1e-9)
    np.testing.assert_allclose(along(model, [0.5], forces)[1], 1000 * level**2 / 8, atol=1e-9)


def test_wind_along_a_slanting_line_is_the_same_as_snow_turned_with_the_model():
    angle = 0.7
    level = supported(kt.MemberLoad(member="bar", force=(0, -400.0), per="projection"), 0.3)
    wind = (400.0 * np.sin(angle), -400.0 * np.cos(angle))
    slanting = supported(kt.MemberLoad(member="bar", force=wind, per="projection"), 0.3 + angle)
    np.testing.assert_allclose(along(level, 7), along(slanting, 7), atol=1e-9)


@pytest.mark.parametrize("dim", [2, 3])
def test_snow_on_an_inclined_beam(dim):
    """A cantilever that rises: moment at its root s (l cos)^2/2, at its end the deflection of s cos^2 across it."""
    c, s = np.cos(0.5), np.sin(0.5)
    end = (L * c, L * s) if dim == 2 else (L * c, 0.0, L * s)
    down = (0, -700.0) if dim == 2 else (0, 0, -700.0)
    model = kt.Model(
        nodes={"A": (0,) * dim, "B": end}, clamped=["A"], beams={"roof": ("A", "B")},
        loads={"snow": kt.MemberLoad(member="roof", force=down, per="projection")}, **RODS,
    )  # fmt: skip
    found = kt.statics.linear(model)
    cut = kt.strength.beams(model, found, stations=[0.0, 1.0]).sel(beam="roof")
    moment = np.linalg.norm(cut.section_M.values, axis=-1)
    np.testing.assert_allclose(moment, [700 * (L * c) ** 2 / 2, 0.0], atol=1e-8)
    across = np.array([-s, c]) if dim == 2 else np.array([-s, 0, c])
    moved = found.displacement.sel(node="B").values @ across
    np.testing.assert_allclose(moved, -700 * c * c * L**4 / (8 * EI), rtol=1e-9)


def test_the_projection_is_that_of_the_present_position():
    """A bar that is turned upright loses its snow; forward and inverse dynamics agree, and so do their methods."""
    heavy = kt.Material(E=200e9, density=7800.0)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"bar": ("A", "B")}, gravity=(0, -9.81),
        section=kt.Rod(diameter=0.02), material=heavy,
        loads={"snow": kt.MemberLoad(member="bar", force=(0, -30.0), per="projection")},
    )  # fmt: skip
    run = kt.dynamics.simulate(model, 0.8, samples=9, method=kt.DOP853(rtol=1e-11, atol=1e-12))
    forces = kt.dynamics.inverse(model, run.motion)
    np.testing.assert_allclose(forces.data.energy_balance, 0.0, atol=1e-6)
    level = np.abs(run.motion.position.sel(node="B", axis="x").values)
    mass = 7800 * np.pi * 0.01**2
    held = forces.data.reaction.sum("support").values[:, 1]
    rise = run.motion.acceleration.sel(node="B", axis="y").values
    np.testing.assert_allclose(held, 30 * level + mass * (9.81 + rise / 2), atol=1e-6)
    other = kt.dynamics.simulate(model, 0.8, samples=9, method=kt.Radau(rtol=1e-10, atol=1e-11))
    np.testing.assert_allclose(other.motion.position, run.motion.position, atol=1e-6)


# Active members.


def vgt(**load):
    model = kt.library.vgt.triangular(payload_mass=10.0)
    return model.with_(loads={"w": kt.MemberLoad(member="actuator", **load)})


@pytest.mark.parametrize("axes", ["global", "member"])
def test_a_load_along_an_active_member(axes):
    """Forces of base and tube from both sides of the nut are one; both free bodies are in balance; M = 0 at the joints."""
    model = vgt(force=(300.0, -500.0), shape=(1, 0.3), axes=axes).with_(gravity=None)
    forces = kt.runs.forces_at_rest(model)
    start = forces.motion.data.length.sel(member="actuator").item() - 2.0
    cut = kt.strength.sections(model, forces, [0.0, start / 2.1, 1.0]).data
    base, tube = (cut.sel(part=f"actuator.{one}").isel(time=0) for one in ("base", "tube"))
    for name in ("section_T", "section_V", "section_M"):
        np.testing.assert_allclose(base[name].values[1], tube[name].values[0], atol=1e-9)
    np.testing.assert_allclose(base.section_M.values[[0, 2]], 0.0, atol=1e-9)
    np.testing.assert_allclose(tube.section_M.values[2], 0.0, atol=1e-9)
    between = forces.data.sel(active="actuator").isel(time=0)
    np.testing.assert_allclose(between.interface_force, [tube.section_T[0], tube.section_V[0, 0]], atol=1e-9)
    np.testing.assert_allclose(between.interface_moment[0], tube.section_M[0, 0], atol=1e-9)
    # the actuator pushes with what passes between base and tube
    np.testing.assert_allclose(forces.data.drive_force.sel(drive="actuator"), -between.interface_force[0], atol=1e-9)
    body = kt.dynamics.free_body(model, forces.motion, forces, member="actuator")
    assert body.residual < 1e-9
    whole = 2.5 * 0.65 * np.hypot(300, 500)
    pushed = [term.force for one in body.bodies for term in one.terms if term.symbol == "P"]
    np.testing.assert_allclose(np.linalg.norm(sum(pushed)), whole, rtol=1e-12)


def test_the_work_of_a_load_along_an_active_member_is_that_on_base_and_tube():
    """Virtual work of the nodal forces against that of the load on points of base and tube, at another length."""
    model, dice = vgt(force=(300.0, -500.0), shape=(1, 0.3)), np.random.default_rng(4)
    system = compile(model)
    A, B = (system.node_index(name) for name in model.active["actuator"].ends)
    x = system.x0.copy()
    x[B] += [0.2, -0.1, 0.0]
    dx = dice.normal(size=(2, 3)) * [1, 1, 0]
    d = x[B] - x[A]
    length, whole = np.linalg.norm(d), 2.5
    u = d / length
    turn = (dx[1] - dx[0]) - u * (u @ (dx[1] - dx[0]))
    at, weight = np.polynomial.legendre.leggauss(20)
    work, nut = 0.0, 1 - 2.0 / length
    for lo, hi, end, own in ((0.0, nut, dx[0], 0.0), (nut, 1.0, dx[1], 1.0)):
        xi = lo + (hi - lo) * 0.5 * (1 + at)
        q = 0.5 * (hi - lo) * weight * whole * (1 - 0.7 * xi)
        # a point of a rod moves as its end, and turns with the member
        moved = end + turn * (xi - own)[:, None]
        work += np.sum(q[:, None] * moved * [300.0, -500.0, 0.0])
    found = 0.0
    for unit, amount in zip(unit_loads_of(system, "w"), (300.0, -500.0), strict=True):
        for node, f in zip(unit.nodes, amount * unit.forces(x[unit.nodes]), strict=True):
            found += f @ dx[[A, B].index(node)]
    np.testing.assert_allclose(found, work, rtol=1e-12)


# Elastic beams.


def test_a_force_at_a_place_of_a_cantilever_and_of_a_clamped_beam():
    """Deflection P a^2 (3 l - a)/(6 E I) at the end; clamped at both ends M_A = P a b^2/l^2, under P 2 P a^2 b^2/l^3."""
    a, b, P = 0.5, 1.5, 300.0
    arm = beam(kt.MemberPointForce(member="arm", force=(0, -P), at=a))
    found = kt.statics.linear(arm)
    np.testing.assert_allclose(found.displacement.sel(node="B", axis="y"), -P * a**2 * (3 * L - a) / (6 * EI), rtol=1e-9)
    both = beam(kt.MemberPointForce(member="arm", force=(0, -P), at="25 %"), clamped=("A", "B"))
    behind = np.nextafter(0.25, 1)
    cut = kt.strength.beams(both, kt.statics.linear(both), stations=[0.0, 0.25, behind, 1.0]).sel(beam="arm")
    M = cut.section_M.sel(moment="3").values
    np.testing.assert_allclose(np.abs(M), P * np.array([a * b**2 / L**2, 2 * a**2 * b**2 / L**3, 2 * a**2 * b**2 / L**3, a**2 * b / L**2]), rtol=1e-9)  # fmt: skip  # noqa: E501
    V = cut.section_V.sel(transverse="2").values
    np.testing.assert_allclose(V[2] - V[1], P, rtol=1e-9)
    np.testing.assert_allclose(np.abs(V[[0, 3]]), P * np.array([b**2 * (3 * a + b), a**2 * (a + 3 * b)]) / L**3, rtol=1e-9)


def test_a_couple_at_a_place_of_a_cantilever_and_of_a_clamped_beam():
    """Deflection C a (l - a/2)/(E I) at the end; clamped at both ends M_A = C b (2 a - b)/l^2, M_B = C a (2 b - a)/l^2."""
    a, b, C = 0.5, 1.5, 70.0
    found = kt.statics.linear(beam(kt.MemberPointCouple(member="arm", moment=C, at=a)))
    np.testing.assert_allclose(found.displacement.sel(node="B", axis="y"), C * a * (L - a / 2) / EI, rtol=1e-9)
    both = beam(kt.MemberPointCouple(member="arm", moment=C, at=a), clamped=("A", "B"))
    cut = kt.strength.beams(both, kt.statics.linear(both), stations=[0.0, 0.25, np.nextafter(0.25, 1), 1.0]).sel(beam="arm")
    M = cut.section_M.values.ravel()
    np.testing.assert_allclose(
        cut.end_moment.values.ravel(), C * np.array([b * (2 * a - b), a * (2 * b - a)]) / L**2, rtol=1e-9
    )
    np.testing.assert_allclose(M[2] - M[1], -C, rtol=1e-9)
    np.testing.assert_allclose(cut.section_V.values.ravel(), -6 * C * a * b / L**3, rtol=1e-9)


def test_a_couple_along_a_beam():
    """A uniform couple along a cantilever: as a force m at its end but without shear; deflection m l^3/(3 E I)."""
    model = beam(kt.MemberCouple(member="arm", moment=40.0))
    found = kt.statics.linear(model)
    np.testing.assert_allclose(found.displacement.sel(node="B", axis="y"), 40 * L**3 / (3 * EI), rtol=1e-9)
    cut = kt.strength.beams(model, found, stations=[0.0, 0.5, 1.0]).sel(beam="arm")
    np.testing.assert_allclose(cut.section_M.values.ravel(), [80.0, 40.0, 0.0], atol=1e-9)
    np.testing.assert_allclose(cut.section_V.values, 0.0, atol=1e-9)
    part = beam(kt.MemberCouple(member="arm", moment=40.0, shape=(0, 2), start=0.5, end="50 %"))
    cut = kt.strength.beams(part, kt.statics.linear(part), stations=[0.0, 0.375, 0.5]).sel(beam="arm")
    np.testing.assert_allclose(cut.section_M.values.ravel(), [20.0, 15.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("axes", ["global", "member"])
def test_couples_on_beams_in_space(axes):
    """Torque and both bending moments of a couple at a place of a beam that is clamped at both ends."""
    nodes, u = {"A": (0, 0, 0), "B": (1.2, 0, 1.6)}, np.array([0.6, 0, 0.8])
    flat = kt.Rectangle(height=0.03, width=0.01)
    model = kt.Model(
        nodes=nodes, clamped=["A", "B"], beams={"arm": ("A", "B")}, material=STEEL, section=flat,
        loads={"C": kt.MemberPointCouple(member="arm", moment=(10.0, 20.0, 30.0), at="25 %", axes=axes)},
    )  # fmt: skip
    cut = kt.strength.beams(model, kt.statics.linear(model), stations=[0.0, 0.25, np.nextafter(0.25, 1), 1.0]).sel(beam="arm")
    two = np.cross(np.cross(u, [0, 0, 1]), u)
    frame = np.stack([u, two / np.linalg.norm(two), np.cross(u, two / np.linalg.norm(two))])
    C = np.array([10.0, 20, 30]) if axes == "member" else frame @ [10.0, 20, 30]
    a, b = 0.25, 0.75
    M = np.column_stack([cut.torsion.values, cut.section_M.values])
    np.testing.assert_allclose(M[1] - M[2], C, rtol=1e-9)
    np.testing.assert_allclose(M[0], [C[0] * b, -C[1] * b * (2 * a - b), -C[2] * b * (2 * a - b)], rtol=1e-8)
    np.testing.assert_allclose(M[3], [-C[0] * a, C[1] * a * (2 * b - a), C[2] * a * (2 * b - a)], rtol=1e-8)


def test_loads_at_places_of_beams_are_exact_with_shear():
    """A beam that is flexible in shear, clamped at both ends, under a force: the ends of Timoshenko's beam."""
    a, P = 0.5, 300.0
    box = kt.Rectangle(height=0.4, width=0.1, shear_coefficient=5 / 6)
    model = kt.Model(
        nodes={"A": (0, 0), "M": (a, 0), "B": (L, 0)}, clamped=["A", "B"], material=STEEL, section=box,
        beams={"one": ("A", "M"), "two": ("M", "B")},
        loads={"P": kt.NodalForce(node="M", force=(0, -P))},
    )  # fmt: skip
    whole = model.with_(
        nodes={"A": (0, 0), "B": (L, 0)}, beams={"arm": ("A", "B")},
        loads={"P": kt.MemberPointForce(member="arm", force=(0, -P), at=a)},
    )  # fmt: skip
    wanted = kt.strength.beams(model, kt.statics.linear(model), stations=[0.0, 1.0])
    found = kt.strength.beams(whole, kt.statics.linear(whole), stations=[0.0, 1.0]).sel(beam="arm")
    ends = [wanted.end_moment.sel(beam="one", end="A").item(), wanted.end_moment.sel(beam="two", end="B").item()]
    np.testing.assert_allclose(found.end_moment.values.ravel(), ends, rtol=1e-9)


def test_a_couple_on_a_beam_follows_it_in_large_turns():
    """A couple at the end of a cantilever of 8 beams bends it into an arc of the angle C l/(E I) in `statics.equilibrium`."""
    count, angle = 8, 0.6
    places = {f"n{k}": (L * k / count, 0.0) for k in range(count + 1)}
    beams = {f"b{k}": (f"n{k}", f"n{k + 1}") for k in range(count)}
    load = kt.MemberPointCouple(member=f"b{count - 1}", moment=angle * EI / L, at="100 %")
    model = kt.Model(nodes=places, clamped=["n0"], beams=beams, loads={"C": load}, **RODS)
    found = kt.statics.equilibrium(model).position.sel(node=f"n{count}").values
    R = L / angle
    np.testing.assert_allclose(found, [R * np.sin(angle), R * (1 - np.cos(angle))], rtol=1e-4)


# Faults.


def active_with(**load):
    return vgt(**load), "actuator"


@pytest.mark.parametrize(
    ("load", "words"),
    [
        (kt.MemberPointForce(member="bar", force=(0, 1), at=2.1), r"loads\.q\.at: is 2.1 m along 'bar', which is 2 m long"),
        (kt.MemberPointCouple(member="bar", moment=1, at=2.1), r"loads\.q\.at: is 2.1 m along 'bar'"),
        (kt.MemberPointForce(member="bra", force=(0, 1), at=1), r"no bar, active member, beam or link called 'bra'.*'bar'"),
        (kt.MemberPointForce(member="bar", force=(0, 1, 2), at=1), r"loads\.q\.force: has 3 components"),
        (kt.MemberPointCouple(member="bar", moment=(0, 1, 2), at=1), r"loads\.q\.moment: is three numbers"),
        (
            kt.MemberLoad(member="bar", times=(0, 1), forces=((0, 1), (1, 0)), per="projection"),
            r"loads\.q\.forces: has forces in several directions",
        ),
        (kt.MemberLoad(member="bar", force=(0, 1), start="60 %", end="50 %"), r"loads\.q\.start: is 1.2 m, not before"),
    ],
)
def test_faults(load, words):
    with pytest.raises(kt.ModelError, match=words):
        kt.check(supported(load))


def test_faults_of_records():
    with pytest.raises(kt.ModelError, match="no share of a length"):
        kt.MemberPointForce(member="bar", force=(0, 1), at="120 %")
    with pytest.raises(kt.ModelError, match="before the first end"):
        kt.MemberPointForce(member="bar", force=(0, 1), at="-3 mm")
    with pytest.raises(kt.ModelError, match="projection along a force that turns"):
        kt.MemberLoad(member="bar", force=(0, 1), per="projection", axes="member")
    with pytest.raises(kt.ModelError, match="has at, the place of a load, and start, of one along a member"):
        kt.MemberPointForce(member="bar", force=(0, 1), at=1, start=0.5)
    with pytest.raises(kt.ModelError, match="neither a force nor a table"):
        kt.MemberPointForce(member="bar", at=1)


def test_faults_on_active_members():
    model = kt.library.vgt.triangular(payload_mass=10.0)
    for load, words in (
        (kt.MemberLoad(member="actuator", force=(0, 1), start=0.3), r"start: is a place on the active member"),
        (kt.MemberPointForce(member="actuator", force=(0, 1), at=0.3), r"at: is a place on the active member"),
        (kt.MemberCouple(member="actuator", moment=1), "couple on an active member"),
        (kt.MemberLoad(member="actuator", force=(0, 1), shape=(1, -1)), "whose sum is 0"),
    ):
        with pytest.raises(kt.ModelError, match=words):
            kt.check(model.with_(loads={"w": load}))


def test_a_load_on_a_member_of_no_length():
    bar = {"nodes": {"A": (0, 0), "B": (0, 0)}, "fixed": ["A"], "bars": {"bar": ("A", "B")}}
    with pytest.raises(kt.ModelError, match="bars.bar.ends: has zero length"):
        kt.check(kt.Model(**bar, loads={"q": kt.MemberPointForce(member="bar", force=(0, 1), at="50 %")}, **RODS))


# Every analysis.


METHODS = [
    kt.Taylor(), kt.DOP853(rtol=1e-11, atol=1e-12), kt.Radau(rtol=1e-10, atol=1e-11), kt.GeneralizedAlpha(step=2e-4),
    kt.EnergyMomentum(step=2e-4), kt.Rattle(step=2e-4),
]  # fmt: skip


@pytest.mark.parametrize("load", ["place", "snow", "member"])
def test_all_methods_of_simulation_agree(load):
    """A pendulum with a force at a place of it, in global axes or its own, and with snow."""
    loads = {
        "place": kt.MemberPointForce(member="bar", times=(0, 1), forces=((0, -30), (20, 5)), at="30 %"),
        "snow": kt.MemberLoad(member="bar", force=(0, -30.0), per="projection"),
        "member": kt.MemberPointForce(member="bar", force=(3.0, -20.0), at=0.7, axes="member"),
    }
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"bar": ("A", "B")}, gravity=(0, -9.81), loads={"q": loads[load]},
        section=kt.Rod(diameter=0.02), material=kt.Material(E=200e9, density=7800.0),
    )  # fmt: skip
    ends = []
    for method in METHODS:
        if load != "place" and isinstance(method, kt.Taylor):
            continue  # which has the series of constant directions
        ends.append(kt.dynamics.simulate(model, 0.3, samples=3, method=method).motion.position.values[-1])
    for one in ends[1:]:
        np.testing.assert_allclose(one, ends[0], atol=2e-6)


@pytest.mark.parametrize("way", ["loaded_along", "telescope_under_a_load"])
def test_equations_of_motion_and_free_bodies(way):
    """The labelled equations have the forces of inverse dynamics as their only solution; free bodies are in balance."""
    rng = np.random.default_rng(5)
    model = getattr(action_models, way)(rng)
    forces = action_models.moved(model, rng, samples=3)
    found = kt.dynamics.newton_euler(model, forces.motion, forces, time=0.2)
    largest = np.abs(found.product).max()
    np.testing.assert_allclose(found.matrix @ found.product, found.right, atol=1e-9 * largest)
    np.testing.assert_allclose(found.solution, found.product, atol=1e-7 * largest)
    for member in model.members:
        body = kt.dynamics.free_body(model, forces.motion, forces, member=member, time=0.2)
        assert body.residual < 1e-9 * body.largest


def test_small_motions_about_a_place_have_the_stiffness_of_the_load():
    """A pendulum held by a force in its own axes does not feel it turn; one in global axes gives it the stiffness P a."""
    a, P = 0.4, 25.0
    swing = []
    for axes in ("global", "member"):
        push = (0, -P) if axes == "global" else (P, 0.0)
        model = kt.Model(
            nodes={"A": (0, 0), "B": (0, -1)}, fixed=["A"], bars={"bar": ("A", "B")},
            loads={"P": kt.MemberPointForce(member="bar", force=push, at=a, axes=axes)},
            section=kt.Rod(diameter=0.02), material=kt.Material(E=200e9, density=7800.0),
        )  # fmt: skip
        swing.append(kt.dynamics.linearise(model).data.stiffness.values.item())
    np.testing.assert_allclose(swing, [P * a, 0.0], atol=1e-9)


def test_loads_at_places_at_poses_and_in_a_run(tmp_path):
    """A run reports the load, draws it along its member, and its verdict has the bending."""
    strong = kt.Material(E=200e9, density=0.0, yield_strength=235e6)
    loads = {
        "P": kt.MemberPointForce(member="bar", force=(0, -900.0), at="25 %"),
        "q": kt.MemberLoad(member="bar", force=(0, -50.0), per="projection"),
    }
    model = supported(loads["P"], 0.3, runs={"rest": kt.Run(analysis="statics.linear")}).with_(loads=loads, material=strong)
    block = kt.run(model, "rest")
    used = next(row for row in block.verdict.table() if (row.part, row.rule) == ("bar", "yield"))
    bending = 900 * np.cos(0.3) * 0.5 * 1.5 / L * 32 / (np.pi * 0.02**3)
    assert used.value > bending
    np.testing.assert_allclose(used.position, 0.5, atol=1e-6)
    scene = kt.viewer.scene(block)
    drawn = {one["name"]: one for one in scene.header["loads"] if one.get("words", True)}
    assert set(drawn) == {"P", "q"}
    forces = {name: np.zeros(2) for name in loads}
    for one, force in zip(scene.header["loads"], scene.arrays["load_force"][0], strict=True):
        forces[one["name"]] += force
        assert one["member"] == 0
    np.testing.assert_allclose(forces["P"], [0, -900], atol=1e-9)
    np.testing.assert_allclose(forces["q"], [0, -50 * L * np.cos(0.3)], atol=1e-9)
    (p, wp), (q, wq) = drawn["P"]["at"]
    assert (p, q) == (0, 1)
    np.testing.assert_allclose([wp, wq], [0.75, 0.25])
    (tmp_path / "report.html").write_text(kt.report.document_page(block).html, encoding="utf-8")
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    for words in ("47.77 N/m", "900 N", "25 %", "along members parts of the whole"):
        assert words in page.replace("\N{NO-BREAK SPACE}", " "), words


@pytest.mark.parametrize("angle", [0.0, 0.7])
@pytest.mark.parametrize("dim", [2, 3])
def test_a_load_along_the_axis_of_a_beam_is_shared_as_its_strain_is_uniform(angle, dim):
    """Clamped at both ends: u = int N/EA gives P b/L and P a/L of a force, 1/3 and 2/3 of a triangle; free: u(L) = P a/EA."""
    e, across = np.array([np.cos(angle), np.sin(angle), 0.0])[:dim], np.array([-np.sin(angle), np.cos(angle), 0.0])[:dim]
    part = kt.Model(nodes={"A": (0.0,) * dim, "B": tuple(L * e)}, clamped=["A", "B"], beams={"arm": ("A", "B")}, **RODS)
    triangle = part.with_(loads={"q": kt.MemberLoad(member="arm", force=tuple(600 * e), shape=(0, 1))})
    found = kt.statics.linear(triangle)
    np.testing.assert_allclose(found.reaction.values @ e, [-200.0, -400.0], rtol=1e-9)
    N = kt.strength.beams(triangle, found, stations=[0.0, 0.5, 1.0]).section_T.values[0]
    np.testing.assert_allclose(N, [200.0, 50.0, -400.0], rtol=1e-8)
    slanting = part.with_(loads={"F": kt.MemberPointForce(member="arm", force=tuple(600 * e - 300 * across), at=0.25 * L)})
    found = kt.statics.linear(slanting)
    np.testing.assert_allclose(found.reaction.values @ e, [-450.0, -150.0], rtol=1e-9)
    np.testing.assert_allclose(found.reaction.values @ across, [300 * 0.84375, 300 * 0.15625], rtol=1e-9)
    free = kt.statics.linear(slanting.with_(clamped=["A"]))
    EA = 200e9 * np.pi * 0.02**2 / 4
    assert free.displacement.sel(node="B").values @ e == pytest.approx(600 * 0.25 * L / EA, rel=1e-9)
    deflected = kt.strength.beams(slanting, found, stations=[0.25]).displacement.values[0, 0] @ e
    assert deflected == pytest.approx(600 * 0.25 * 0.75 * L / EA, rel=1e-8)


def test_a_force_at_a_place_of_a_bent_link_does_the_work_of_that_place():
    """Clapeyron: the sum of reactions is the load, and displacement under the load = 2 strain energy over the load."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 1), "C": (3, 1)}, fixed=["A", "C"], links={"knee": ("A", "B", "C")},
        loads={"F": kt.MemberPointForce(member="knee", force=(300.0, -400.0), at=2.0)}, **RODS,
    )  # fmt: skip
    rest = kt.statics.linear(model)
    np.testing.assert_allclose(rest.reaction.sum("support").values, [-300.0, 400.0], rtol=1e-9)
    split = (1.0 + (2.0 - np.sqrt(2.0)), 1.0)
    divided = model.with_(
        nodes={**model.nodes, "D": split}, links={"knee": ("A", "B", "D", "C")},
        loads={"F": kt.NodalForce(node="D", force=(300.0, -400.0))},
    )  # fmt: skip
    other = kt.statics.linear(divided)
    np.testing.assert_allclose(rest.reaction.values, other.reaction.values, rtol=1e-8)
    place = 2.0 / (2.0 + np.sqrt(2.0))
    own = kt.strength.beams(model, rest, stations=[0.2, place, 0.9])
    nodal = kt.strength.beams(divided, other, stations=[0.2, place, 0.9])
    np.testing.assert_allclose(own.section_M.values, nodal.section_M.values, rtol=1e-7, atol=1e-7)
    np.testing.assert_allclose(own.displacement.values[:, 1], nodal.displacement.values[:, 1], rtol=1e-7)
