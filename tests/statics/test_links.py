"""Links: one member through any number of pins. Closed forms of statics, motions and simulations; comparison with beams."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import kinetruss as kt

G = 9.81
STEEL = kt.library.materials.STEEL_S235
SECTION = kt.Rectangle(width=0.02, height=0.06)
LINE = SECTION.area * STEEL.density  # kg/m
E, I3 = STEEL.E, SECTION.second_moments[1]


def scissor(**changes) -> kt.Model:
    """Two legs of 1 m that cross at M, on a pin and a roller that a drive pushes."""
    fields = {
        "nodes": {"A": (0, 0), "B": (0.8, 0), "M": (0.4, 0.3), "C": (0.8, 0.6), "D": (0, 0.6)},
        "fixed": {"A": "xy", "B": "y"},
        "links": {"front": ("A", "M", "C"), "back": ("B", "M", "D")},
        "section": SECTION,
        "material": STEEL,
        "gravity": (0, -G),
        "drives": {"push": kt.CoordinateDrive(node="B", axis="x")},
        "loads": {side: kt.NodalForce(node=side, force=(0, -1e3)) for side in ("C", "D")},
    }
    return kt.Model(**fields | changes)


def boom(**changes) -> kt.Model:
    """A boom O-M-T of 2 m along x, pinned at O, on a driven ram below M."""
    fields = {
        "nodes": {"O": (0, 0), "M": (1, 0), "T": (2, 0), "P": (1, -1)},
        "fixed": ["O", "P"],
        "links": {"boom": ("O", "M", "T")},
        "bars": {"ram": kt.Bar(ends=("P", "M"), kind="driven", mass=0)},
        "section": SECTION,
        "material": STEEL,
        "loads": {"hook": kt.NodalForce(node="T", force=(0, -1e3))},
    }
    return kt.Model(**fields | changes)


def moments(model, result, link, xi):
    """Moment about 3 at fractions of a link, N m; of the first sample of a motion."""
    found = kt.strength.beams(model, result, stations=xi).section_M.sel(beam=link, moment="3")
    return (found if found.ndim == 1 else found[0]).values


@pytest.fixture(scope="module")
def lifted():
    model = scissor()
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"push": (0.8, 0.5)}, duration=4.0), samples=9)
    return model, motion, kt.dynamics.inverse(model, motion)


def test_a_scissor_has_one_freedom():
    found = kt.kinematics.mobility(scissor())
    assert (found.degrees_of_freedom, found.undriven, found.self_stress) == (1, 0, 0)
    assert (found.links, found.beams, found.bars) == (2, 0, 0)
    assert "2 links" in str(found)


def test_the_push_of_a_scissor_lift(lifted):
    """Virtual work at rest: F dx = (W + 2 m g/2) dh with x^2 + h^2 = 1, so F = -(W + m g) x/h."""
    _, motion, forces = lifted
    x = motion.position.sel(node="B", axis="x").values
    h = motion.position.sel(node="C", axis="y").values
    still = forces.static.drive_force.sel(drive="push").values
    np.testing.assert_allclose(still, -(2e3 + LINE * G) * x / h, rtol=1e-10)
    assert still[0] == pytest.approx(-2790, rel=1e-4)


def test_the_moment_at_the_pin_of_a_scissor_lift(lifted):
    """Half a leg is a cantilever from M: half its weight and the load at its tip, across the leg."""
    model, _, forces = lifted
    across = 0.8  # cosine of the slope at the start
    want = -across * (1e3 * 0.5 + LINE * 0.5 * G * 0.25)
    found = kt.strength.beams(model, forces.static)
    at = found.section_M.sel(station=0.5, moment="3").isel(time=0)
    assert at.sel(beam="front").item() == pytest.approx(want, rel=1e-9)
    assert at.sel(beam="back").item() == pytest.approx(-want, rel=1e-9)
    # what the legs exert on each other is equal and opposite, and nothing else acts at M
    pins = found.pin_force.isel(time=0)
    np.testing.assert_allclose(pins.sel(pin="front.M").values, -pins.sel(pin="back.M").values, atol=1e-8)
    # of tips, the force of the node on the link is the load
    np.testing.assert_allclose(pins.sel(pin="front.C").values, (0, -1e3), atol=1e-8)


def test_the_parts_of_results_are_those_of_the_user(lifted):
    model, motion, forces = lifted
    assert forces.data.sizes["member"] == 0
    assert list(motion.data.node.values) == list(model.nodes)
    assert list(kt.strength.beams(model, forces).beam.values) == ["front", "back"]
    rows = kt.strength.check(model, forces).table()
    assert {row.part for row in rows} == {"front", "back"}
    assert "keep their shape" not in motion.message  # rigid links are expected to


def test_a_beam_on_two_supports_with_an_overhang():
    """Weight q: R_B = q L (L/2)/b + P L/b; M at B = -(P a + q a^2/2); between the supports M = R_A x - q x^2/2."""
    b, a, P = 1.2, 0.8, 500.0
    L, q = b + a, LINE * G
    model = boom(
        nodes={"A": (0, 0), "B": (b, 0), "C": (L, 0)},
        fixed={"A": "xy", "B": "y"},
        links={"beam": ("A", "B", "C")},
        bars={},
        gravity=(0, -G),
        loads={"P": kt.NodalForce(node="C", force=(0, -P))},
    )
    R_B = (q * L * L / 2 + P * L) / b
    R_A = q * L + P - R_B
    for result in (kt.statics.linear(model), kt.runs.forces_at_rest(model)):
        x = np.array([0.2, 0.5, b, 1.5]) / L
        hand = [R_A * 0.2 - q * 0.02, R_A * 0.5 - q * 0.125, -(P * a + q * a**2 / 2), -(P * 0.5 + q * 0.125)]
        np.testing.assert_allclose(moments(model, result, "beam", x), hand, rtol=1e-9)
    rest = kt.statics.linear(model)
    assert rest.reaction.sel(support="B", axis="y").item() == pytest.approx(R_B, rel=1e-10)


def test_a_boom_bends_as_two_beams_do():
    """The same boom as two beams that meet at M, to the last digits of the stiffness method."""
    two = boom(links={}, beams={"lower": ("O", "M"), "upper": ("M", "T")})
    for model in (boom(), boom(links={"boom": kt.Link(nodes=("O", "M", "T"), kind="elastic")})):
        one, other = kt.statics.linear(model), kt.statics.linear(two)
        np.testing.assert_allclose(one.displacement.values, other.displacement.values, rtol=1e-9, atol=1e-15)
    # a cantilever of 1 m at the end of a simple beam of 1 m: P a^2 (a + b)/(3 E I)
    hook = kt.statics.linear(boom(bars={}, fixed={"O": "xy", "M": "y"}, nodes={"O": (0, 0), "M": (1, 0), "T": (2, 0)}))
    assert hook.displacement.sel(node="T", axis="y").item() == pytest.approx(-1e3 * 2 / (3 * E * I3), rel=1e-9)


def test_equilibrium_has_the_section_forces_of_a_link():
    model = boom(loads={"hook": kt.NodalForce(node="T", force=(0, -1.0))})
    found = kt.statics.equilibrium(model)
    np.testing.assert_allclose(moments(model, found, "boom", [0.25, 0.5, 0.75]), [-0.5, -1.0, -0.5], rtol=1e-5)


def test_a_crane_of_two_links_and_two_rams():
    """Moments about the knee give the upper ram, moments of all about the foot the lower one."""
    nodes = {
        "O": (0, 0), "M": (0.9, 1.4), "K": (1.5, 2.6), "E": (1.8, 2.9), "N": (2.4, 2.7), "T": (4.1, 2.2), "P": (0.8, -0.2),
    }  # fmt: skip
    model = kt.Model(
        nodes=nodes,
        fixed=["O", "P"],
        links={"lower": ("O", "M", "K"), "arm": ("E", "K", "N", "T")},
        bars={"lift": kt.Bar(ends=("P", "M"), kind="driven", mass=0), "fold": kt.Bar(ends=("M", "E"), kind="driven", mass=0)},
        section=kt.Rectangle(width=0.08, height=0.16),
        material=STEEL,
        gravity=(0, -G),
        loads={"hook": kt.NodalForce(node="T", force=(0, -8e3))},
    )
    x = {name: np.array(at, float) for name, at in nodes.items()}
    line = 0.08 * 0.16 * STEEL.density * G

    def weights(*pins):
        return [((x[p] + x[q]) / 2, line * np.linalg.norm(x[q] - x[p])) for p, q in pairwise(pins)]

    def about(pivot, loads, ram, at):
        """Thrust of a ram that balances weights about a pivot."""
        u = (x[at] - x[ram]) / np.linalg.norm(x[at] - x[ram])
        arm = x[at] - x[pivot]
        return sum(W * (place - x[pivot])[0] for place, W in loads) / (arm[0] * u[1] - arm[1] * u[0])

    upper = [*weights("E", "K", "N", "T"), (x["T"], 8e3)]
    forces = kt.runs.forces_at_rest(model)
    drive = forces.drive_force.isel(time=0)
    assert drive.sel(drive="fold").item() == pytest.approx(about("K", upper, "M", "E"), rel=1e-9)
    assert drive.sel(drive="lift").item() == pytest.approx(about("O", [*upper, *weights("O", "M", "K")], "P", "M"), rel=1e-9)
    # at the knee: all that acts on the arm beyond it
    beyond = [*weights("K", "N", "T"), (x["T"], 8e3)]
    M_K = sum(W * (place - x["K"])[0] for place, W in beyond)
    first = np.linalg.norm(x["K"] - x["E"])
    total = first + np.linalg.norm(x["N"] - x["K"]) + np.linalg.norm(x["T"] - x["N"])
    assert abs(moments(model, forces, "arm", [first / total])[0]) == pytest.approx(abs(M_K), rel=1e-9)


def test_a_bell_crank_turns_a_force():
    """A right angle with arms of 0.3 and 0.2 m: Q = P 0.3/0.2, and the moment at the corner is P 0.3."""
    model = kt.Model(
        nodes={"A": (-0.3, 0), "O": (0, 0), "B": (0, 0.2), "R": (0.5, 0.2)},
        fixed=["O", "R"],
        links={"crank": ("A", "O", "B")},
        bars={"rod": ("B", "R")},
        section=SECTION,
        material=STEEL,
        loads={"P": kt.NodalForce(node="A", force=(0, -400))},
    )
    rest = kt.statics.linear(model)
    assert rest.member_force.sel(member="rod").item() == pytest.approx(400 * 0.3 / 0.2, rel=1e-9)
    assert abs(moments(model, rest, "crank", [0.6])[0]) == pytest.approx(400 * 0.3, rel=1e-9)
    np.testing.assert_allclose(rest.reaction.sel(support="O").values, (-600, 400), rtol=1e-9)


def test_links_without_a_section_move_and_are_not_checked():
    model = boom(links={"boom": kt.Link(nodes=("O", "M", "T"), mass=30.0)}, section=None, material=None, gravity=(0, -G))
    assert kt.kinematics.mobility(model).degrees_of_freedom == 1
    forces = kt.runs.forces_at_rest(model)
    assert forces.drive_force.item() == pytest.approx(30 * G + 2e3, rel=1e-10)
    notes = {(row.part, row.rule): row.note for row in kt.strength.check(model, forces).table()}
    assert notes["boom", "yield"] == "not checked: no section, or no material"


def test_the_torque_on_the_angle_of_a_link_acts_at_its_first_pin():
    model = boom(bars={}, nodes={"O": (0, 0), "M": (1, 0), "T": (2, 0)}, fixed=["O"], drives={"motor": kt.AngleDrive("boom")})
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 1.0}, duration=2 * math.pi), samples=5)
    np.testing.assert_allclose(motion.drive_position[:, 0].values, np.arange(5) * math.pi / 2, atol=1e-9)
    forces = kt.dynamics.inverse(model, motion)
    assert forces.drive_force.values[0, 0] == pytest.approx(2e3, rel=1e-9)
    np.testing.assert_allclose(moments(model, forces, "boom", [0.0, 0.25, 0.5]), [-2e3, -1.5e3, -1e3], rtol=1e-9)


def test_a_welded_link_is_a_cantilever():
    model = boom(
        nodes={"O": (0, 0), "M": (1, 0), "T": (2, 0)}, fixed={}, clamped=["O"], bars={},
        links={"boom": kt.Link(nodes=("O", "M", "T"), weld=["O"])},
    )  # fmt: skip
    rest = kt.statics.linear(model)
    assert rest.displacement.sel(node="T", axis="y").item() == pytest.approx(-1e3 * 8 / (3 * E * I3), rel=1e-9)
    assert rest.reaction_moment.item() == pytest.approx(2e3, rel=1e-9)


SPATIAL = {"O": (0, 0, 0), "M": (1.0, 0, 0.2), "T": (2.0, 0, 0.4), "P": (1.0, -0.6, -1), "Q": (1.0, 0.6, -1)}


def spatial(**changes) -> kt.Model:
    ram = {"kind": "driven", "mass": 0}
    fields = {
        "nodes": SPATIAL,
        "fixed": ["O", "P", "Q"],
        "links": {"boom": ("O", "M", "T")},
        "bars": {"left": kt.Bar(ends=("P", "M"), **ram), "right": kt.Bar(ends=("Q", "M"), **ram)},
        "section": kt.Tube(outer=0.1, inner=0.08),
        "material": STEEL,
        "loads": {"hook": kt.NodalForce(node="T", force=(0, 300.0, -2e3))},
    }
    return kt.Model(**fields | changes)


def test_a_boom_in_space_on_two_rams():
    """Moments about O across the boom: two equations for two thrusts."""
    model = spatial()
    assert kt.kinematics.mobility(model).degrees_of_freedom == 2
    x = {name: np.array(at) for name, at in SPATIAL.items()}
    units = [(x["M"] - x[foot]) / np.linalg.norm(x["M"] - x[foot]) for foot in "PQ"]
    A = np.stack([np.cross(x["M"], u) for u in units], axis=1)
    thrust = np.linalg.lstsq(A, -np.cross(x["T"], (0, 300.0, -2e3)), rcond=None)[0]
    forces = kt.runs.forces_at_rest(model)
    np.testing.assert_allclose(forces.drive_force.values[0], thrust, rtol=1e-9)
    found = kt.strength.beams(model, forces, stations=[0.5]).isel(time=0, station=0).sel(beam="boom")
    bending = np.linalg.norm(np.cross(x["T"] - x["M"], (0, 300.0, -2e3)))
    assert np.linalg.norm(found.section_M.values) == pytest.approx(bending, rel=1e-9)


def test_a_hinge_in_space_holds_a_boom_sideways():
    """On a clamp, turning about y only: one freedom; the side force is a moment of the clamp about z, and twists nothing."""
    model = spatial(
        fixed=["P"], clamped=["O"], links={"boom": kt.Link(nodes=("O", "M", "T"), hinges={"O": (0, 1, 0)})},
        nodes={"O": (0, 0, 0), "M": (1, 0, 0), "T": (2, 0, 0), "P": (1, 0, -1)},
        bars={"ram": kt.Bar(ends=("P", "M"), kind="driven", mass=0)},
    )  # fmt: skip
    assert kt.kinematics.mobility(model).degrees_of_freedom == 1
    rest = kt.statics.linear(model)
    assert rest.reaction_moment.sel(support="O", rotation="z").item() == pytest.approx(-600.0, rel=1e-9)
    assert rest.reaction_moment.sel(support="O", rotation="y").item() == pytest.approx(0.0, abs=1e-6)


@pytest.mark.slow
def test_a_physical_pendulum_with_its_pin_off_the_centre():
    """T = 2 pi sqrt((m L^2/12 + rotary inertia of the section + m d^2)/(m g d))."""
    L, up = 1.0, 0.2
    model = kt.Model(
        nodes={"A": (0, up), "O": (0, 0), "B": (0, up - L)}, fixed=["O"], links={"rod": ("A", "O", "B")}, gravity=(0, -G),
        section=kt.Rectangle(width=0.02, height=0.02), material=STEEL, velocities={"B": (1e-4, 0)},
    )  # fmt: skip
    d = L / 2 - up
    period = 2 * math.pi * math.sqrt((L**2 / 12 + 0.02**2 / 12 + d**2) / (G * d))
    run = kt.dynamics.simulate(model, 1.5 * period, samples=4, times=np.array([0.5, 1.0, 1.5]) * period)
    swing = run.motion.position.sel(node="B", axis="x").values
    np.testing.assert_allclose(swing, 0.0, atol=1e-9)
    # its weight hangs at the pin
    pin = kt.strength.beams(model, run.forces).pin_force.sel(pin="rod.O", axis="y").isel(time=-1)
    assert pin.item() == pytest.approx(0.02**2 * STEEL.density * L * G, rel=1e-6)


@pytest.mark.slow
def test_a_boom_that_falls_keeps_its_energy_and_its_shape():
    model = boom(gravity=(0, -G), loads={})
    run = kt.dynamics.simulate(model, 0.4, samples=9, tasks={"ram": kt.Free()})
    energy = run.energy.values
    assert np.ptp(energy) < 1e-8 * run.kinetic_energy.values.max()
    x = run.motion.position
    for pair, length in ((("O", "M"), 1.0), (("M", "T"), 1.0), (("O", "T"), 2.0)):
        apart = np.linalg.norm(x.sel(node=pair[0]).values - x.sel(node=pair[1]).values, axis=1)
        np.testing.assert_allclose(apart, length, rtol=1e-10)
    # falling about O with alpha = g L/2/(L^2/3 + r^2): weight, inertia and rotary inertia of what is beyond x
    first = moments(model, run.forces, "boom", [0.0, 0.25, 0.5])
    L, r, s = 2.0, 0.06**2 / 12, np.array([0.0, 0.5, 1.0])
    alpha = G * L / 2 / (L**2 / 3 + r)
    swept = (L**3 - s**3) / 3 - s * (L**2 - s**2) / 2
    hand = -LINE * (G * (L - s) ** 2 / 2 - alpha * swept - alpha * r * (L - s))
    np.testing.assert_allclose(first, hand, rtol=1e-9, atol=1e-9)


@pytest.mark.slow
def test_a_simulated_motion_has_the_section_forces_of_inverse_dynamics():
    model, lift = boom(gravity=(0, -G)), kt.Quintic(moves={"ram": (1.0, 1.3)}, duration=1.0)
    motion = kt.kinematics.follow(model, lift, samples=5)
    one = kt.strength.beams(model, kt.dynamics.inverse(model, motion))
    run = kt.dynamics.simulate(model, 1.0, samples=5, trajectory=lift)
    other = kt.strength.beams(model, run.forces)
    for name in ("section_T", "section_V", "section_M", "pin_force"):
        size = float(np.abs(one[name].values).max())
        np.testing.assert_allclose(other[name].values, one[name].values, rtol=1e-6, atol=1e-6 * size)


def test_a_link_is_judged_as_a_column_with_bending():
    """A strut through three pins whose middle a side force bends: Euler over the whole length, H1-1 with C_m = 1."""
    P, Q, L = 20e3, 300.0, 2.0
    model = kt.Model(
        nodes={"A": (0, 0), "M": (1, 0), "B": (L, 0)}, fixed={"A": "xy", "B": "y"}, links={"strut": ("A", "M", "B")},
        section=SECTION, material=STEEL, safety=kt.Safety(buckling=2.0),
        loads={"P": kt.NodalForce(node="B", force=(-P, 0)), "Q": kt.NodalForce(node="M", force=(0, -Q))},
    )  # fmt: skip
    rows = {row.rule: row for row in kt.strength.check(model, kt.runs.forces_at_rest(model)).table()}
    weak, about = math.pi**2 * E * SECTION.second_moments[0] / L**2, math.pi**2 * E * I3 / L**2
    assert rows["buckling"].utilisation == pytest.approx(2 * P / weak, rel=1e-9)
    assert rows["buckling"].note == "Euler, pinned-pinned, over the whole length"
    allowed = STEEL.yield_strength * I3 / 0.03
    want = 2 * P / weak + Q * L / 4 / ((1 - 2 * P / about) * allowed)
    assert rows["beam-column"].value == pytest.approx(want, rel=1e-9)
    assert rows["beam-column"].position == pytest.approx(1.0, rel=1e-9)
    free = boom(loads={"push": kt.NodalForce(node="T", force=(-P, 0))})
    row = next(row for row in kt.strength.check(free, kt.runs.forces_at_rest(free)).table() if row.rule == "buckling")
    assert row.note == "Euler, clamped-free, over the whole length"
    assert row.utilisation == pytest.approx(P / (weak / 4), rel=1e-9)


def test_links_pass_each_other_and_beams_at_a_node():
    """At a node of a portal a link is pinned: the portal's moments are those without it, but for the force that it brings."""
    frame = {
        "nodes": {"A": (0, 0), "B": (0, 3), "C": (4, 3), "D": (4, 0), "F": (2, 5)},
        "clamped": ["A", "D"],
        "beams": {"left": ("A", "B"), "top": ("B", "C"), "right": ("D", "C")},
        "section": SECTION,
        "material": STEEL,
    }
    push = {"wind": kt.NodalForce(node="F", force=(0, -1e3))}
    linked = kt.Model(**frame, links={"one": ("B", "F"), "two": ("F", "C")}, loads=push)
    barred = kt.Model(**frame, bars={"one": ("B", "F"), "two": ("F", "C")}, loads=push)
    one, other = kt.statics.linear(linked), kt.statics.linear(barred)
    np.testing.assert_allclose(one.displacement.values, other.displacement.values, rtol=1e-8, atol=1e-12)


@pytest.mark.parametrize("axes", ["global", "member"])
def test_a_load_along_a_link_passes_over_its_pins(axes):
    """Wind on a boom from 0.5 m to its tip, growing from q to 3 q: shear and moment by hand on both sides of the pin."""
    q, model = 200.0, boom(loads={})
    snow = kt.MemberLoad(member="boom", force=(0, -q), start=0.5, shape=(1.0, 3.0), axes=axes)
    model = model.with_(loads={"snow": snow})

    def beyond(x):
        """Moment at x >= 0.5 of the load beyond it."""
        s = np.linspace(x, 2.0, 20001)
        return np.trapezoid(q * (1 + 2 * (s - 0.5) / 1.5) * (s - x), s)

    for result in (kt.statics.linear(model), kt.runs.forces_at_rest(model)):
        ram = beyond(0.5) + 0.5 * 1.5 * 2 * q
        thrust = -result.member_force.values.reshape(-1)[0]
        assert thrust == pytest.approx(ram, rel=1e-7)
        np.testing.assert_allclose(moments(model, result, "boom", [0.5, 0.75]), [-beyond(1.0), -beyond(1.5)], rtol=1e-7)


def test_a_load_along_a_bent_link_is_global():
    bent = {"nodes": {"O": (0, 0), "M": (1, 0), "T": (2, 1), "P": (1, -1)}}
    with pytest.raises(kt.errors.ModelError, match="the link 'boom' is bent"):
        boom(**bent, loads={"snow": kt.MemberLoad(member="boom", force=(0, -1.0), axes="member")})
    model = boom(**bent, loads={"snow": kt.MemberLoad(member="boom", force=(0, -100.0))})
    rest = kt.statics.linear(model)
    long = math.sqrt(2)
    assert -rest.member_force.item() == pytest.approx(100 * (0.5 + long * 1.5), rel=1e-9)


@pytest.mark.slow
def test_a_load_along_a_link_turns_it_in_a_simulation():
    """A uniform load q on a link pinned at O: alpha = q L^2/2/(rho A (L^3/3 + r^2 L)) at the start, and its moments."""
    q, L, r = 50.0, 2.0, 0.06**2 / 12
    model = boom(
        nodes={"O": (0, 0), "M": (1, 0), "T": (2, 0), "Z": (0, 1), "Y": (1, 1)}, fixed=["O", "Z"], bars={},
        beams={"other": ("Z", "Y")}, clamped=["Z"],
        loads={"wind": kt.MemberLoad(member="boom", force=(0, -q), axes="member")},
    )  # fmt: skip
    alone = {name: at for name, at in model.nodes.items() if name in "OMT"}
    for chosen in (model, model.with_(nodes=alone, fixed=["O"], beams={}, clamped=[])):
        run = kt.dynamics.simulate(chosen, 1e-3, samples=2)
        alpha = -run.motion.acceleration.sel(node="T", axis="y")[0].item() / L
        assert alpha == pytest.approx(q * L**2 / 2 / (LINE * (L**3 / 3 + r * L)), rel=1e-9)
        s = 1.0
        swept = (L**3 - s**3) / 3 - s * (L**2 - s**2) / 2
        hand = -(q * (L - s) ** 2 / 2 - LINE * alpha * (swept + r * (L - s)))
        assert moments(chosen, run.forces, "boom", [0.5])[0] == pytest.approx(hand, rel=1e-9)


def test_loads_at_places_of_a_link_and_their_combination():
    """Pins at 0 and 2 m, 2 kN/m on all 4 m times 1.35, 1 kN at 3 m times 1.5: by hand, on both sides of the pin."""
    model = kt.Model(
        nodes={"O": (0, 0), "M": (2, 0), "T": (4, 0), "P": (2, -1)},
        fixed=["O", "P"],
        links={"boom": ("O", "M", "T")},
        bars={"strut": ("P", "M")},
        section=kt.Rectangle(width=0.06, height=0.12),
        material="steel_s235",
        loads={
            "snow": kt.MemberLoad(member="boom", force=(0, -2e3)),
            "man": kt.MemberPointForce(member="boom", force=(0, -1e3), at="75 %"),
        },
        load_cases={"G": kt.LoadCase(loads={"snow": 1.0}), "Q": kt.LoadCase(loads={"man": 1.0})},
        combinations={"uls": {"G": 1.35, "Q": 1.5}},
    )
    rest = kt.statics.linear(model, load_case="uls")
    np.testing.assert_allclose(rest.reaction.sel(support="P").values, [0.0, 13050.0], atol=1e-6)
    found = kt.strength.beams(model, rest, stations=[0.25, 0.5, 0.75, 0.875])
    expected = [-750.0 - 1350.0, -6900.0, -2700.0 * 0.5, -2700.0 * 0.125]
    np.testing.assert_allclose(found.section_M.sel(beam="boom", moment="3").values, expected, atol=1e-5)


def test_a_point_force_at_a_pin_of_a_link_is_that_on_its_node():
    def reactions(loads):
        model = kt.Model(
            nodes={"A": (0, 0), "B": (1, 1), "C": (3, 1)},
            fixed={"A": "xy", "C": "y"},
            links={"bent": ("A", "B", "C")},
            section=kt.Rectangle(width=0.06, height=0.12),
            material="steel_s235",
            loads=loads,
        )
        rest = kt.statics.linear(model)
        return rest.displacement.values, kt.strength.beams(model, rest, stations=[0.2, 0.8]).section_M.values

    place = float(np.hypot(1, 1))
    along = reactions({"F": kt.MemberPointForce(member="bent", force=(1e3, -2e3), at=place)})
    at_node = reactions({"F": kt.NodalForce(node="B", force=(1e3, -2e3))})
    for one, other in zip(along, at_node, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(
    ("load", "said"),
    [
        (kt.MemberPointForce(member="boom", force=(0, -1), at=5.0), "is 5 m along 'boom'"),
        (kt.MemberLoad(member="boom", force=(0, -1), axes="member"), "is bent"),
        (kt.MemberLoad(member="boom", force=(0, -1), per="projection"), "is bent"),
        (kt.MemberPointCouple(member="boom", moment=1.0, at=1.0), "is a couple on a link"),
    ],
)
def test_loads_that_a_bent_link_cannot_take_are_told(load, said):
    with pytest.raises(kt.errors.ModelError, match=said):
        kt.Model(
            nodes={"A": (0, 0), "B": (1, 1), "C": (3, 1)},
            fixed={"A": "xy", "C": "y"},
            links={"boom": ("A", "B", "C")},
            section=kt.Rectangle(width=0.06, height=0.12),
            material="steel_s235",
            loads={"F": load},
        )
