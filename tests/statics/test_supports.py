"""Supports of every kind: closed forms of frames, limits, invariance under rotation of all, all analyses, what is refused."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.spatial.transform import Rotation

import kinetruss as kt

E, SIDE = 200e9, 0.1
AREA, I = SIDE**2, SIDE**4 / 12
EI, EA = E * I, E * AREA
POISSON = 0.25
SECTION = kt.Rectangle(width=SIDE, height=SIDE)
GJ = E / (2 * (1 + POISSON)) * SECTION.torsion_constant
MATTER = {"section": SECTION, "material": kt.Material(E=E, density=0.0, poisson=POISSON)}
P, L = 1200.0, 2.0
PIN = kt.Support(x="held", y="held")
ROLLER = kt.Support(y="held")
CLAMP = kt.Support(x="held", y="held", rotation="held")
BALL = kt.Support(x="held", y="held", z="held")
CLAMP_IN_SPACE = kt.Support(x="held", y="held", z="held", rotation="held")


def row(*places, **fields) -> kt.Model:
    """Beams along x through these places: nodes N0, N1, ... ; forces along y by node."""
    nodes = {f"N{k}": (x, 0.0) for k, x in enumerate(places)}
    beams = {f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(len(places) - 1)}
    return frame(nodes, beams, **fields)


def frame(nodes, beams, forces=(), **fields) -> kt.Model:
    loads = {f"on_{node}": kt.NodalForce(node=node, force=force) for node, force in dict(forces).items()}
    return kt.Model(nodes=nodes, beams=beams, **({"loads": loads} | MATTER | fields))


def down(found: kt.results.Result, node: str) -> float:
    return -found.displacement.sel(node=node, axis="y").item()


def up(found: kt.results.Result, node: str) -> float:
    return found.reaction.sel(support=node, axis="y").item()


def moment(found: kt.results.Result, node: str) -> float:
    return found.reaction_moment.sel(support=node, rotation="z").item()


def near(value: float, rel: float = 1e-9):
    return pytest.approx(value, rel=rel, abs=1e-9 * abs(value))


# Closed forms.


def test_propped_cantilever_whose_prop_settles():
    """R = 3 E I d/L^3."""
    d = 4e-3
    found = kt.statics.linear(row(0, L, supports={"N0": CLAMP, "N1": kt.Support(y=kt.Restraint(settlement=-d))}))
    assert up(found, "N1") == near(-3 * EI * d / L**3)
    assert moment(found, "N0") == near(3 * EI * d / L**2)
    assert down(found, "N1") == near(d)
    assert found.energy.item() == near(1.5 * EI * d**2 / L**3)
    assert found.work.item() == near(found.energy.item())


def test_propped_cantilever_whose_clamp_turns():
    """M = 3 E I a/L, R = M/L."""
    a = 2e-3
    turned = kt.Support(x="held", y="held", rotation=kt.Restraint(settlement=a))
    found = kt.statics.linear(row(0, L, supports={"N0": turned, "N1": ROLLER}))
    assert moment(found, "N0") == near(3 * EI * a / L)
    assert up(found, "N0") == near(3 * EI * a / L**2)


def test_beam_clamped_at_both_ends_of_which_one_settles():
    """M = 6 E I d/L^2, R = 12 E I d/L^3."""
    d = 3e-3
    settled = kt.Support(x="held", y=kt.Restraint(settlement=-d), rotation="held")
    found = kt.statics.linear(row(0, L, supports={"N0": CLAMP, "N1": settled}))
    assert up(found, "N0") == near(12 * EI * d / L**3)
    assert [moment(found, node) for node in ("N0", "N1")] == [near(6 * EI * d / L**2)] * 2


def test_cantilever_whose_clamp_yields():
    """P L^3/(3 E I) + P L^2/c."""
    c = 4e5
    found = kt.statics.linear(row(0, L, supports={"N0": kt.Support(x="held", y="held", rotation=c)}, forces={"N1": (0, -P)}))
    assert down(found, "N1") == near(P * L**3 / (3 * EI) + P * L**2 / c)
    assert moment(found, "N0") == near(P * L)


def test_cantilever_on_an_elastic_prop():
    """R = P k/(k + 3 E I/L^3)."""
    k = 2e5
    found = kt.statics.linear(row(0, L, supports={"N0": CLAMP, "N1": kt.Support(y=k)}, forces={"N1": (0, -P)}))
    assert up(found, "N1") == near(P * k / (k + 3 * EI / L**3))


def test_beam_on_two_springs():
    """Middle: P L^3/(48 E I) + P/(4 k1) + P/(4 k2)."""
    k1, k2 = 1e5, 3e5
    supports = {"N0": kt.Support(x="held", y=k1), "N2": kt.Support(y=k2)}
    found = kt.statics.linear(row(0, L / 2, L, supports=supports, forces={"N1": (0, -P)}))
    assert down(found, "N1") == near(P * L**3 / (48 * EI) + P / (4 * k1) + P / (4 * k2))
    assert up(found, "N0") == near(P / 2)


def test_beam_between_clamps_that_yield():
    """End moments P L/8/(1 + 2 E I/(c L)): the rotation P L^2/(16 E I) of pinned ends less M L/(2 E I) is M/c."""
    c = 5e5
    ends = kt.Support(x="held", y="held", rotation=c), kt.Support(y="held", rotation=c)
    found = kt.statics.linear(row(0, L / 2, L, supports={"N0": ends[0], "N2": ends[1]}, forces={"N1": (0, -P)}))
    M = P * L / 8 / (1 + 2 * EI / (c * L))
    assert moment(found, "N0") == near(M)
    assert moment(found, "N2") == near(-M)


def test_roller_on_a_slope():
    """P in the middle of a beam: the roller gives P/(2 cos a), square to its slope."""
    a = math.radians(35)
    supports = {"N0": PIN, "N2": kt.Support(y="held", turned=a)}
    found = kt.statics.linear(row(0, L / 2, L, supports=supports, forces={"N1": (0, -P)}))
    assert up(found, "N2") == near(P / 2)
    assert found.reaction.sel(support="N2", axis="x").item() == near(-P / 2 * math.tan(a))
    assert found.reaction_own.sel(support="N2").values == pytest.approx([0.0, P / 2 / math.cos(a)], abs=1e-6)
    x, y = found.displacement.sel(node="N2").values
    assert -x * math.sin(a) + y * math.cos(a) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("push", [1.0, -1.0])
def test_support_that_the_beam_lifts_off(push):
    """Two spans, the far support presses only: under a load down on the first span the beam is simply supported there."""
    supports = {"N0": PIN, "N2": ROLLER, "N3": kt.Support(y=kt.Restraint(stiffness=1e15, gap=(0, None)))}
    found = kt.statics.linear(row(0, L / 2, L, 2 * L, supports=supports, forces={"N1": (0, -P * push)}))
    # three moments: M = 3 P L/32 over the middle of two spans
    R = 0.0 if push > 0 else 3 * P / 32
    assert up(found, "N3") == pytest.approx(R, rel=1e-6)
    assert ("supports N3 (y)" in found.message) == (push > 0)
    assert up(found, "N0") == pytest.approx(push * P / 2 if push > 0 else -13 * P / 32, rel=1e-6)


@pytest.mark.parametrize("share", [-2.0, -0.5, 0.5, 0.99, 1.01, 20.0])
def test_gap_that_closes(share):
    """P = share k g on a tip with stiffness k = 3 E I/L^3 and a gap g on both sides: R = c (P - k g)/(k + c) beyond it."""
    k, g, c = 3 * EI / L**3, 1e-3, 4e6
    load = share * k * g
    supports = {"N0": CLAMP, "N1": kt.Support(y=kt.Restraint(stiffness=c, gap=g))}
    found = kt.statics.linear(row(0, L, supports=supports, forces={"N1": (0, -load)}))
    R = math.copysign(max(0.0, abs(load) - k * g) * c / (k + c), load)
    assert up(found, "N1") == pytest.approx(R, rel=1e-9, abs=1e-9)
    assert bool(found.message) == (abs(share) < 1)


def test_pin_with_play_in_its_rotation():
    """A clamp that turns by a before it holds with c: the tip is at P L^3/(3 E I) + L (a + P L/c)."""
    a, c = 1e-3, 1e6
    base = kt.Support(x="held", y="held", rotation=kt.Restraint(stiffness=c, gap=a))
    found = kt.statics.linear(row(0, L, supports={"N0": base}, forces={"N1": (0, -P)}))
    assert down(found, "N1") == near(P * L**3 / (3 * EI) + L * (a + P * L / c))
    assert moment(found, "N0") == near(P * L)


def test_guided_end():
    """A tip that may shift but not turn: P L^3/(12 E I)."""
    found = kt.statics.linear(row(0, L, supports={"N0": CLAMP, "N1": kt.Support(rotation="held")}, forces={"N1": (0, -P)}))
    assert down(found, "N1") == near(P * L**3 / (12 * EI))
    assert moment(found, "N1") == near(P * L / 2)


def test_two_spans_with_a_load_in_the_middle_of_each():
    """5 P/16, 11 P/8, 5 P/16 (three moments)."""
    supports = {"N0": PIN, "N2": ROLLER, "N4": ROLLER}
    forces = {"N1": (0, -P), "N3": (0, -P)}
    found = kt.statics.linear(row(0, L / 2, L, 3 * L / 2, 2 * L, supports=supports, forces=forces))
    assert [up(found, node) for node in supports] == [near(5 * P / 16), near(11 * P / 8), near(5 * P / 16)]


def portal(foot: kt.Support, other: kt.Support, h: float = 3.0, span: float = 4.0, push: float = P) -> kt.Model:
    nodes = {"A": (0, 0), "B": (0, h), "C": (span, h), "D": (span, 0)}
    beams = {"left": ("A", "B"), "top": ("B", "C"), "right": ("D", "C")}
    stiff = kt.General(area=1e6 * AREA, I2=I, I3=I, c2=SIDE, c3=SIDE)
    return frame(nodes, beams, {"B": (push / 2, 0), "C": (push / 2, 0)}, supports={"A": foot, "D": other}, section=stiff)


def test_portal_on_pins_sways():
    """H h^3/(6 E I) + H h^2 s/(12 E I), without axial strains; H/2 and H h/s at each foot."""
    h, s = 3.0, 4.0
    found = kt.statics.linear(portal(PIN, PIN))
    assert -found.displacement.sel(node="B", axis="x").item() == near(-P * h**3 / (6 * EI) - P * h**2 * s / (12 * EI), 1e-5)
    assert found.reaction.values == pytest.approx(np.array([[-P / 2, -P * h / s], [-P / 2, P * h / s]]), rel=1e-9)


@pytest.mark.parametrize("c", [None, 2e6])
def test_portal_on_clamps_sways(c):
    """Slope deflection: with the stiffness 6 E I/s of the beam at its ends, and c of the feet."""
    h, s = 3.0, 4.0
    foot = CLAMP if c is None else kt.Support(x="held", y="held", rotation=c)
    found = kt.statics.linear(portal(foot, foot))
    k, big = 6 * EI / s, 1e15 if c is None else c
    # unknowns: rotation of the foot, of the top, sway; moments at both ends of a column and its shear H/2
    A = EI * np.array([[4 / h, 2 / h, 6 / h**2], [2 / h, 4 / h, 6 / h**2], [6 / h**2, 6 / h**2, 12 / h**3]])
    A += np.diag([big, k, 0.0])
    turn, _, sway = np.linalg.solve(A, [0, 0, P / 2])
    assert found.displacement.sel(node="B", axis="x").item() == near(sway, 1e-5)
    assert moment(found, "A") == near(-big * turn, 1e-5)


def test_frame_bent_out_of_its_plane():
    """An L of two equal legs: 2 P a^3/(3 E I) + P a^3/(G J)."""
    a = 1.5
    nodes = {"A": (0, 0, 0), "B": (a, 0, 0), "C": (a, a, 0)}
    model = frame(nodes, {"1": ("A", "B"), "2": ("B", "C")}, {"C": (0, 0, -P)}, supports={"A": CLAMP_IN_SPACE})
    found = kt.statics.linear(model)
    assert -found.displacement.sel(node="C", axis="z").item() == near(2 * P * a**3 / (3 * EI) + P * a**3 / GJ)
    assert found.reaction_moment.values[0] == pytest.approx([P * a, -P * a, 0.0], rel=1e-9, abs=1e-8)


def test_shaft_between_forks():
    """A torque in the middle of a shaft whose ends hold only its twist: T/2 each, turned by T L/(4 G J)."""
    T = 300.0
    fork = kt.Support(y="held", z="held", rotation_x="held")
    nodes = {"A": (0, 0, 0), "B": (L / 2, 0, 0), "C": (L, 0, 0)}
    model = frame(nodes, {"1": ("A", "B"), "2": ("B", "C")}, supports={"A": fork.with_(x="held"), "C": fork})
    model = model.with_(loads={"T": kt.BodyCouple(body="B", moment=(T, 0, 0))})
    found = kt.statics.linear(model)
    assert found.reaction_moment.sel(rotation="x").values == pytest.approx([-T / 2, -T / 2], rel=1e-9)
    assert found.energy.item() == near(T / 2 * T * L / (4 * GJ))


def test_shaft_in_an_elastic_bearing():
    """A torque at the end of a shaft whose other end is held by c about it: T (L/(G J) + 1/c)."""
    T, c = 300.0, 2e4
    base = kt.Support(x="held", y="held", z="held", rotation_x=c, rotation_y="held", rotation_z="held")
    model = frame({"A": (0, 0, 0), "B": (L, 0, 0)}, {"1": ("A", "B")}, supports={"A": base})
    found = kt.statics.linear(model.with_(loads={"T": kt.BodyCouple(body="B", moment=(T, 0, 0))}))
    assert found.energy.item() == near(0.5 * T * T * (L / GJ + 1 / c))
    assert found.reaction_moment.values[0] == pytest.approx([-T, 0, 0], abs=1e-9)


def test_three_bars_one_of_which_is_pulled_up():
    """Bars at 0 and +-a from the vertical, the middle one's support lifted by d: N = d E A/(l (1 + 1/(2 cos^3 a)))."""
    a, h, d = math.radians(40), 1.2, 1e-4
    nodes = {"O": (0, 0), "M": (0, h), "L": (-h * math.tan(a), h), "R": (h * math.tan(a), h)}
    supports = {"M": kt.Support(x="held", y=kt.Restraint(settlement=d)), "L": PIN, "R": PIN}
    bars = {name: kt.Bar(ends=("O", end), kind="elastic") for name, end in (("m", "M"), ("l", "L"), ("r", "R"))}
    found = kt.statics.linear(kt.Model(nodes=nodes, bars=bars, supports=supports, **MATTER))
    N = d * EA / h / (1 + 1 / (2 * math.cos(a) ** 3))
    assert found.member_force.sel(member="m").item() == near(N)
    assert found.member_force.sel(member="l").item() == near(-N / (2 * math.cos(a)))
    assert up(found, "M") == near(N)


def braced(kind: str, push: float) -> kt.Model:
    """A square of side 1 between pins with two diagonals."""
    nodes = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    sides = {"left": ("A", "D"), "top": ("D", "C"), "right": ("B", "C")}
    bars = {name: kt.Bar(ends=ends, kind="elastic") for name, ends in sides.items()}
    bars |= {name: kt.Bar(ends=ends, kind=kind) for name, ends in (("up", ("A", "C")), ("down", ("D", "B")))}
    fields = {"nodes": nodes, "fixed": ["A", "B"], "bars": bars, "loads": {"H": kt.NodalForce(node="D", force=(push, 0))}}
    if kind == "free":
        k = EA / math.sqrt(2)
        fields["stops"] = {
            f"{name}.press": kt.Stop(coordinate=kt.LengthDrive(name), lower=math.sqrt(2), stiffness=k)
            for name in ("up", "down")
        }
    return kt.Model(**fields, **MATTER)


@pytest.mark.parametrize("push", [P, -P])
@pytest.mark.parametrize("kind", ["cable", "free"])
def test_frame_with_crossed_ties_or_struts(kind, push):
    """One diagonal carries sqrt(2) H, pulled if it is a tie, pressed if it is a strut; the other is slack."""
    found = kt.statics.linear(braced(kind, push))
    works, rests = ("up", "down") if (push > 0) == (kind == "cable") else ("down", "up")
    assert found.member_force.sel(member=works).item() == near(math.sqrt(2) * P * (1 if kind == "cable" else -1))
    assert found.member_force.sel(member=rests).item() == 0.0
    assert rests in found.message
    assert works not in found.message
    # energy: the diagonal, and the side that it presses or pulls with H; at A the tie, at D the strut
    top = abs(found.member_force.sel(member="top").item())
    side = np.abs(found.member_force.sel(member=["left", "right"]).values).sum()
    work = (2 * P**2 * math.sqrt(2) + top**2 + side**2) / (2 * EA)
    assert found.work.item() == near(work)


# Limits and invariants.


@pytest.mark.parametrize("k", [1e12, 1e14])
def test_stiff_springs_are_held(k):
    """The difference from rigid supports falls as 1/k."""
    held = kt.statics.linear(row(0, 1, 2, supports={"N0": CLAMP, "N2": CLAMP}, forces={"N1": (300.0, -P)}))
    soft = kt.Support(x=k, y=k, rotation=k)
    found = kt.statics.linear(row(0, 1, 2, supports={"N0": soft, "N2": soft}, forces={"N1": (300.0, -P)}))
    assert found.reaction.values == pytest.approx(held.reaction.values, abs=P * 1e10 / k)
    assert found.reaction_moment.values == pytest.approx(held.reaction_moment.values, abs=P * 1e10 / k)


def test_long_and_short_forms_are_one():
    """`fixed` and `clamped` say what supports say."""
    nodes = {"A": (0, 0), "B": (1.0, 0.5), "C": (2, 0)}
    beams, forces = {"1": ("A", "B"), "2": ("B", "C")}, {"B": (200.0, -P)}
    short = kt.statics.linear(frame(nodes, beams, forces, clamped=["A"], fixed={"C": "y"}))
    long = kt.statics.linear(frame(nodes, beams, forces, supports={"A": CLAMP, "C": ROLLER}))
    for name in ("displacement", "reaction", "reaction_moment"):
        assert np.array_equal(short.data[name].values, long.data[name].values), name


STIFFNESS = st.floats(1e3, 1e8)
PUSH = st.sampled_from([-1900.0, -140.0, 0.0, 75.0, 1300.0])


@settings(max_examples=25, deadline=None)
@given(angle=st.floats(-3, 3), k=STIFFNESS, c=STIFFNESS, push=st.tuples(PUSH, PUSH))
def test_all_turned_in_the_plane(angle, k, c, push):
    """Forces turn with the structure, its supports and its load; moments and own reactions stay. The sum of all is nil."""
    R = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    nodes = {"A": (0.0, 0.0), "B": (1.5, 0.4), "C": (2.5, -0.3)}
    beams = {"1": ("A", "B"), "2": ("B", "C")}

    def model(turn):
        supports = {
            "A": kt.Support(x="held", y=k, rotation=c, turned=0.3 + turn),
            "C": kt.Support(y=kt.Restraint(stiffness=k, gap=(1e-6, None)), x=3 * k, turned=turn),
        }
        M = R if turn else np.eye(2)
        return frame({n: (M @ at).tolist() for n, at in nodes.items()}, beams, {"B": (M @ push).tolist()}, supports=supports)

    plain, turned = (kt.statics.linear(model(turn)) for turn in (0.0, angle or 1.0))
    if not angle:
        return
    size = max(1.0, np.abs(push).max())
    own = plain.reaction_own.values
    assert turned.reaction_own.values == pytest.approx(own, abs=1e-8 * size)
    assert turned.reaction.values == pytest.approx(plain.reaction.values @ R.T, abs=1e-8 * size)
    assert turned.reaction_moment.values == pytest.approx(plain.reaction_moment.values, abs=1e-8 * size)
    assert plain.reaction.sum("support").values + push == pytest.approx([0, 0], abs=1e-9 * size)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(turn=st.tuples(*[st.floats(-2, 2)] * 3), k=STIFFNESS, c=STIFFNESS, push=st.tuples(PUSH, PUSH, PUSH))
def test_all_turned_in_space(turn, k, c, push):
    """The same in space, with a foot that holds some rotations, yields in others, about axes of its own."""
    R = Rotation.from_rotvec(turn).as_matrix()
    nodes = {"A": (0.0, 0.0, 0.0), "B": (1.5, 0.4, 0.2), "C": (2.5, -0.3, 0.9)}
    axes = Rotation.from_rotvec((0.2, -0.5, 0.4)).as_matrix()
    across = (0.1, 0.2, 1.0)

    def model(M):
        along, other = M @ axes[0], M @ axes[1]
        own = {"along": along.tolist(), "across": other.tolist()}
        supports = {
            "A": kt.Support(x="held", y=k, z="held", rotation_x="held", rotation_y=c, rotation_z=2 * c, **own),
            "C": kt.Support(x=k, y="held", z=3 * k, **own),
        }
        beams = {
            name: kt.Beam(ends=ends, orientation=(M @ across).tolist()) for name, ends in (("1", ("A", "B")), ("2", ("B", "C")))
        }
        return frame({n: (M @ at).tolist() for n, at in nodes.items()}, beams, {"B": (M @ push).tolist()}, supports=supports)

    plain, turned = (kt.statics.linear(model(M)) for M in (np.eye(3), R))
    size = max(1.0, np.abs(push).max())
    for name in ("reaction_own", "reaction_moment_own"):
        assert turned.data[name].values == pytest.approx(plain.data[name].values, abs=1e-7 * size), name
    for name in ("reaction", "reaction_moment"):
        assert turned.data[name].values == pytest.approx(plain.data[name].values @ R.T, abs=1e-7 * size), name
    # moments of all forces about the origin, A
    total = np.cross(nodes["B"], push) + np.cross(nodes["C"], plain.reaction.sel(support="C").values)
    assert total + plain.reaction_moment.values.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-8 * size)


# All analyses.


def bent(**supports) -> kt.Model:
    return row(0, 1, 2, supports={"N0": PIN, **supports}, forces={"N1": (0, -P / 20)})


KINDS = {
    "elastic": {"N0": kt.Support(x="held", y="held", rotation=1e5), "N2": kt.Support(y=2e5)},
    "turned": {"N2": kt.Support(y="held", turned="20 deg")},
    "settled": {"N2": kt.Support(y=kt.Restraint(settlement=-1e-4))},
    "gap": {"N0": CLAMP, "N2": kt.Support(y=kt.Restraint(stiffness=1e6, gap=1e-7))},
    "clamp that turns": {"N0": kt.Support(x="held", y="held", rotation=kt.Restraint(settlement=1e-4)), "N2": ROLLER},
}


@pytest.mark.parametrize("kind", KINDS)
def test_small_and_large_displacements_agree(kind):
    """Under a small load; and the path at the factor 1."""
    model = bent(**KINDS[kind])
    small, large = kt.statics.linear(model), kt.statics.equilibrium(model)
    for name in ("reaction", *(["reaction_moment"] if "reaction_moment" in small.data else [])):
        assert large.data[name].values == pytest.approx(small.data[name].values, abs=2e-2 * P / 20), name
    assert large.stable
    assert list(large.data.dims).count("spring") == list(large.data.dims).count("stop") == 0


def test_path_has_reactions_of_supports():
    """The reaction of a spring along a path is that of the equilibrium under this load."""
    model = bent(**KINDS["elastic"])
    found = kt.statics.path(model, "on_N1")
    for k in (1, 5):
        factor = found.load_factor.values[k]
        load = {"on_N1": kt.NodalForce(node="N1", force=(0, -P / 20 * factor))}
        there = kt.statics.equilibrium(model.with_(loads=load))
        assert found.reaction.values[k] == pytest.approx(there.reaction.values, abs=1e-5 * P)


def mass_on(**supports) -> kt.Model:
    """A rigid bar on a pin, level, with a mass at its end that a support holds; it also has a foot to its left."""
    nodes = {"A": (0.0, 0.0), "B": {"at": (1.0, 0.0), "mass": 3.0}}
    return kt.Model(nodes=nodes, bars={"b": ("A", "B")}, supports={"A": PIN, **supports}, gravity=(0, -9.81))


def test_mass_on_a_spring_vibrates():
    """w = sqrt(k/m) about the level, and its weight is the mean of the reaction."""
    k, m = 4e4, 3.0
    model = mass_on(B=kt.Support(y=k))
    rest = kt.statics.equilibrium(model)
    poles = kt.dynamics.linearise(model, rest)
    assert np.abs(poles.pole_imag.values).max() == pytest.approx(math.sqrt(k / m), rel=1e-5)
    period = 2 * math.pi / math.sqrt(k / m)
    run = kt.dynamics.simulate(model, times=np.linspace(0, period, 9))
    y = run.motion.position.sel(node="B", axis="y").values
    reaction = run.forces.reaction.sel(support="B", axis="y").values
    assert reaction == pytest.approx(-k * y, abs=1e-6)
    assert y[4] == pytest.approx(-2 * m * 9.81 / k, rel=1e-4)
    assert list(run.forces.reaction.support.values) == ["A", "B"]
    assert "spring_force" not in run.forces.data


def test_inverse_dynamics_of_a_roller_on_a_slope():
    """At rest the roller gives what statics gives, along its own axes too."""
    model = mass_on(B=kt.Support(y="held", turned="30 deg"))
    found = kt.runs.forces_at_rest(model)
    own = found.reaction_own.sel(support="B").values[0]
    assert own == pytest.approx([0.0, 3.0 * 9.81 / math.cos(math.pi / 6)], abs=1e-9)
    assert "coupling_force" not in found.data


@pytest.mark.parametrize(
    ("ends", "factor"),
    [
        ((CLAMP, None), 0.25),
        ((PIN, kt.Support(x="held")), 1.0),
        ((CLAMP, kt.Support(x="held")), 2.0457),
        ((CLAMP, kt.Support(x="held", rotation="held")), 4.0),
    ],
)
def test_four_cases_of_euler(ends, factor):
    """C pi^2 E I/l^2 with C = 1/4, 1, 2.0457, 4 (Timoshenko & Gere, Theory of Elastic Stability, 1961, section 2.1)."""
    count, h = 8, 4.0
    nodes = {f"N{k}": (0.0, h * k / count) for k in range(count + 1)}
    beams = {f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(count)}
    supports = {"N0": ends[0]} | ({f"N{count}": ends[1]} if ends[1] is not None else {})
    found = kt.statics.buckling(frame(nodes, beams, {f"N{count}": (0, -1.0)}, supports=supports), f"on_N{count}")
    assert found.load_factor.values[0] == pytest.approx(factor * math.pi**2 * EI / h**2, rel=1e-3)


def test_column_whose_foot_yields_buckles():
    """k l tan(k l) = c l/(E I) of a free column on a spring c (Timoshenko & Gere, 1961, section 2.4)."""
    from scipy.optimize import brentq

    h, c, count = 3.0, 1.5e6, 8
    z = brentq(lambda z: z * math.tan(z) - c * h / EI, 1e-6, math.pi / 2 - 1e-9)
    nodes = {f"N{k}": (0.0, h * k / count) for k in range(count + 1)}
    beams = {f"b{k}": (f"N{k}", f"N{k + 1}") for k in range(count)}
    foot = kt.Support(x="held", y="held", rotation=c)
    found = kt.statics.buckling(frame(nodes, beams, {f"N{count}": (0, -1.0)}, supports={"N0": foot}), f"on_N{count}")
    assert found.load_factor.values[0] == pytest.approx((z / h) ** 2 * EI, rel=1e-3)


def test_portal_on_pins_buckles_sideways():
    """k h tan(k h) = 6 h/s of equal columns and beam (Timoshenko & Gere, 1961, section 2.4: a spring 6 E I/s at the top)."""
    from scipy.optimize import brentq

    h, s, count = 3.0, 4.0, 4
    z = brentq(lambda z: z * math.tan(z) - 6 * h / s, 1e-6, math.pi / 2 - 1e-9)
    nodes, beams = {}, {}
    for side, x in (("l", 0.0), ("r", s)):
        nodes |= {f"{side}{k}": (x, h * k / count) for k in range(count + 1)}
        beams |= {f"{side}{k}": (f"{side}{k}", f"{side}{k + 1}") for k in range(count)}
    nodes |= {f"t{k}": (s * k / 4, h) for k in (1, 2, 3)}
    top = [f"l{count}", "t1", "t2", "t3", f"r{count}"]
    beams |= {f"t{k}": pair for k, pair in enumerate(pairwise(top))}
    loads = {"P": kt.NodalForce(node=f"l{count}", force=(0, -1.0)), "Q": kt.NodalForce(node=f"r{count}", force=(0, -1.0))}
    model = frame(nodes, beams, supports={"l0": PIN, "r0": PIN}).with_(loads=loads)
    found = kt.statics.buckling(model, {"P": 1.0, "Q": 1.0})
    assert found.load_factor.values[0] == pytest.approx((z / h) ** 2 * EI, rel=2e-3)


# What is refused, and how it is said.

TWO = {"nodes": {"A": (0, 0), "B": (2, 0)}, "beams": {"b": ("A", "B")}} | MATTER
BARS = {"nodes": {"A": (0, 0), "B": (2, 0)}, "bars": {"b": ("A", "B")}}
IN_SPACE = {"nodes": {"A": (0, 0, 0), "B": (2, 0, 0)}, "beams": {"b": ("A", "B")}} | MATTER


@pytest.mark.parametrize(
    ("model", "support", "said"),
    [
        (TWO, {}, "the support holds nothing. Give what it holds"),
        (TWO, {"x": "free"}, "the support holds nothing"),
        (TWO, {"x": 0}, "stiffness is 0: the direction is not held. Write free"),
        (TWO, {"x": "tight"}, "'tight' is no way to hold a node. Write held, free, a stiffness"),
        (TWO, {"x": -5}, "negative"),
        (TWO, {"x": "2 kN m/rad"}, "x: stiffness is not that of a translation. Use N/m and m"),
        (TWO, {"rotation": "2 kN/mm"}, "rotation: stiffness is not that of a rotation. Use N m/rad and rad"),
        (TWO, {"rotation": {"settlement": "2 mm"}}, "rotation: settlement is not that of a rotation"),
        (TWO, {"y": {"stiffness": 1e6, "gap": "1 deg"}}, "y: gap is not that of a translation"),
        (TWO, {"y": {"gap": 1e-3}}, "behind the gap there is a rigid support. Give the stiffness of the contact"),
        (TWO, {"y": {"stiffness": 1e6, "gap": [None, None]}}, "the gap has no end"),
        (TWO, {"y": {"stiffness": 1e6, "gap": 1e-3, "settlement": 1e-3}}, "gap and settlement both say where"),
        (TWO, {"y": {"stiffness": 1e6, "gap": -1e-3}}, "negative"),
        (TWO, {"y": {"damping": 5.0}}, "damping is that of a spring, but the direction is held rigidly"),
        (TWO, {"x": "free", "y": {"stiffness": 0, "settlement": 1e-3}}, "the direction is not held"),
        (TWO, {"z": "held"}, "is given in a planar model"),
        (TWO, {"rotation_x": "held"}, "is given in a planar model. Give rotation"),
        (TWO, {"y": "held", "along": (1, 0), "across": (0, 1)}, "across: is given in a planar model"),
        (TWO, {"y": "held", "turned": 0.1, "along": (1, 0)}, "turned and along both say"),
        (TWO, {"y": "held", "along": (1, 0, 0)}, "has 3 components, the model has 2 axes"),
        (TWO, {"y": "held", "along": (0, 0)}, "along: is the zero vector"),
        (TWO, {"y": "held", "along": "A"}, "the node stands where the support is"),
        (TWO, {"y": "held", "along": "C"}, "no node called 'C'"),
        (
            BARS,
            {"y": "held", "rotation": "held"},
            "rotation: the node has no rotation: no beam shares one with it. Join a beam",
        ),
        (IN_SPACE, {"y": "held", "turned": 0.1}, "is one angle, but the support stands in space. Give along"),
        (
            IN_SPACE,
            {"y": "held", "along": (1, 0, 0), "across": (1, 1, 0)},
            "across: is at 45 degrees to along, not perpendicular",
        ),
        (IN_SPACE, {"y": "held", "across": (1, 1, 0)}, "across is the second axis of the support. Give its first one too"),
        (IN_SPACE, {"rotation": "held", "rotation_x": 5.0}, "rotation is about all axes, rotation_x about one of them"),
    ],
)
def test_faults(model, support, said):
    with pytest.raises(kt.ModelError) as error:
        kt.Model(**model, supports={"A": support, "B": {"x": "held", "y": "held"}})
    assert said in str(error.value)
    assert len(error.value.faults) == 1, error.value
    assert error.value.faults[0].path[:2] == ("supports", "A"), error.value.faults[0]


@pytest.mark.parametrize("table", ["fixed", "clamped"])
def test_a_node_is_held_in_one_table(table):
    with pytest.raises(kt.ModelError, match=f"supports.A: the node is also {table}"):
        kt.Model(**TWO, supports={"A": PIN}, **{table: ["A"]})


def test_rotation_of_a_released_end():
    beams = {"b": kt.Beam(ends=("A", "B"), release=["A"])}
    with pytest.raises(kt.ModelError, match="no beam shares one"):
        kt.Model(**(TWO | {"beams": beams}), supports={"A": CLAMP, "B": CLAMP})


def test_a_mechanism_names_what_lifts_off():
    """A beam on supports that press only, pulled up."""
    presses = kt.Support(x="held", y=kt.Restraint(stiffness=1e9, gap=(0, None)))
    model = row(0, 1, 2, supports={"N0": presses, "N2": presses}, forces={"N1": (0, P)})
    with pytest.raises(kt.InputError, match="Slack here, so that they hold nothing: support N0, support N2"):
        kt.statics.linear(model)


def test_supports_found_by_contact():
    """Loose until two gaps close: one below, one above."""
    gap = kt.Support(x="held", y=kt.Restraint(stiffness=1e9, gap=1e-4))
    model = row(0, 1, 2, supports={"N0": gap, "N2": kt.Support(y=gap.y)}, forces={"N1": (0, -P)})
    found = kt.statics.linear(model)
    assert [up(found, node) for node in ("N0", "N2")] == [near(P / 2, 1e-6), near(P / 2, 1e-6)]
    assert down(found, "N1") == near(P * 2**3 / (48 * EI) + 1e-4 + P / 2 / 1e9)


def test_files_say_the_same(tmp_path):
    model = row(0, 1, 2, supports=KINDS["gap"] | {"N1": kt.Support(x=3e4, along=(1, 2))})
    for name in ("one.yaml", "two.json"):
        assert kt.read(kt.write(model, tmp_path / name)) == model


def test_words_of_mobility():
    model = bent(**KINDS["elastic"])
    assert "not counted, since they yield or have a gap: supports N0 (rotation), N2 (y)" in str(kt.kinematics.mobility(model))


def test_portal_vibrates_sideways():
    """w^2 = 24 E I/(h^3 m) of a stiff girder of mass m on two clamped columns without mass."""
    h, m = 3.0, 500.0
    model = portal(CLAMP, CLAMP, push=0.0)
    nodes = {name: kt.Node(at=node.at, mass=m / 2 if name in "BC" else 0.0) for name, node in model.nodes.items()}
    beams = model.beams | {"top": kt.Beam(ends=("B", "C"), kind="rigid", mass=0.0)}
    moves = kt.dynamics.linearise(model.with_(nodes=nodes, beams=beams, loads={}))
    frequencies = np.abs(moves.pole_imag.values)
    assert frequencies[frequencies > 1.0].min() == pytest.approx(math.sqrt(24 * EI / (h**3 * m)), rel=1e-6)
