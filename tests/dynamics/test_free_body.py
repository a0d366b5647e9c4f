"""Free bodies close, and hold what the results hold."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from samples import fourbar, tripod

G = 9.81


def solved(model, trajectory, times):
    motion = kt.kinematics.follow(model, trajectory, times=times)
    return motion, kt.dynamics.inverse(model, motion)


def bay(**changes):
    return kt.library.vgt.double_octahedral(tip_force=(3.0, -5.0, 46.0), payload_mass=2.0, rotary_inertia=True, **changes)


@pytest.fixture(scope="module")
def slewed():
    model = bay(gravity=(1.0, -2.0, 9.81))
    trajectory = kt.Quintic(moves={"bay.beta": (0, 0.17), "bay.gamma": (0, -0.1), "bay.height": (1.12, 1.05)}, duration=1)
    return model, *solved(model, trajectory, [0.0, 0.3, 0.55])


@pytest.mark.slow
def test_a_hanging_rod_by_hand():
    """A vertical rod under its weight and an end load: T = P + m g (L - s)/L, nothing across."""
    model = kt.Model(
        nodes={"top": (0, 0), "tip": (0, -2), "aside": (1, -2)}, fixed=["top", "aside"],
        bars={"rod": kt.Bar(ends=("top", "tip"), mass=3.0), "stay": ("aside", "tip")},
        loads={"pull": kt.NodalForce(node="tip", force=(0, -50.0))}, gravity=(0, -G),
    )  # fmt: skip
    position = kt.kinematics.assemble(model)
    still = np.zeros((1, 3, 2))
    motion = kt.kinematics.from_arrays(model, [0.0], position[None], still, still)
    found = kt.dynamics.free_body(model, motion, kt.dynamics.inverse(model, motion), member="rod")
    assert found.tension == pytest.approx((50 + 3 * G, 50 + 1.5 * G, 50))
    (body,) = found.bodies
    assert [term.symbol for term in body.terms] == ["F_A", "F_B", "m g"]
    assert body.terms[0].force == pytest.approx((0, 50 + 3 * G))
    assert body.terms[2].force == pytest.approx((0, -3 * G))
    assert body.centre == pytest.approx((0, -1))
    assert body.inertia.force == pytest.approx((0, 0))
    assert [e.name for e in body.equations] == ["force x", "force y", "moment 3"]


@pytest.mark.slow
def test_a_swinging_rod_by_hand():
    """A rod turned about one end at a constant rate w: m w^2 L/2 pulls it in, its motor bears the moment of the weight."""
    w, L, m = 3.0, 2.0, 1.5
    model = kt.Model(
        nodes={"O": (0, 0), "P": (L, 0)}, fixed=["O"], bars={"rod": kt.Bar(ends=("O", "P"), mass=m)}, gravity=(0, -G),
        drives={"motor": kt.AngleDrive("rod")},
    )  # fmt: skip
    motion, forces = solved(model, kt.ConstantRate(rates={"motor": w}, duration=1), [0.0])
    (body,) = kt.dynamics.free_body(model, motion, forces, member="rod", time=0).bodies
    terms = {term.symbol: term for term in body.terms}
    assert body.inertia.force == pytest.approx((-m * w**2 * L / 2, 0))
    assert terms["F_A"].force == pytest.approx((-m * w**2 * L / 2, m * G))
    assert terms["T"].moment == pytest.approx([m * G * L / 2])
    assert body.inertia.moment == pytest.approx([0], abs=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("time", [0.0, 0.3, 0.55])
@pytest.mark.parametrize("rest", [False, True])
def test_every_free_body_of_a_bay_closes(slewed, time, rest):
    model, motion, forces = slewed
    forces = forces.static if rest else forces
    for member in model.members:
        found = kt.dynamics.free_body(model, motion, forces, member=member, time=time)
        assert found.residual < 1e-12 * found.largest
    for node in model.nodes:
        found = kt.dynamics.free_body(model, motion, forces, node=node, time=time)
        assert found.residual < 1e-12 * found.largest


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(st.floats(0.0, 1.0), st.floats(-0.2, 0.2), st.floats(-0.2, 0.2))
def test_free_bodies_close_wherever_the_truss_goes(time, beta, gamma):
    model = bay()
    motion, forces = solved(model, kt.library.vgt.slew(beta=(0, beta), gamma=(0, gamma)), [time])
    for member in ("M6", "M9", "M19"):
        found = kt.dynamics.free_body(model, motion, forces, member=member)
        assert found.residual < 1e-12 * found.largest


@pytest.mark.slow
def test_free_body_repeats_what_the_results_say(slewed):
    model, motion, forces = slewed
    base, tube = kt.dynamics.free_body(model, motion, forces, member="M7", time=0.3).bodies
    on_base = {term.symbol: term for term in base.terms}
    at = {"time": 0.3, "active": "M7"}
    assert on_base["S"].local == pytest.approx(forces.interface_force.sel(at).values)
    assert on_base["M"].moment == pytest.approx(forces.interface_moment.sel(at).values)
    on_tube = {term.symbol: term for term in tube.terms}
    assert on_tube["-S"].force == pytest.approx(-on_base["S"].force)
    assert tube.mass == pytest.approx(0.0577911, rel=1e-5)
    node = kt.dynamics.free_body(model, motion, forces, node="N1", time=0.3).bodies[0]
    (support,) = (term.force for term in node.terms if term.symbol == "R")
    assert support == pytest.approx(forces.reaction.sel(time=0.3, support="N1").values)
    tip = kt.dynamics.free_body(model, motion, forces, node="N8", time=0.3).bodies[0]
    assert [term.source for term in tip.terms if term.symbol == "P"] == ["load tip_N8"]
    assert tip.inertia.force == pytest.approx(2.0 * motion.acceleration.sel(time=0.3, node="N8").values)


def test_driven_bars_motors_and_pushed_nodes_close():
    crank = fourbar()
    motion, forces = solved(crank, kt.Quintic(moves={"motor": (math.pi / 2, 2.0)}, duration=0.4), [0.1, 0.2])
    for member in crank.bars:
        assert kt.dynamics.free_body(crank, motion, forces, member=member, time=0.2).residual < 1e-12
    slider = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0.5), "C": (2, 0)}, fixed={"A": "xy", "C": "y"}, gravity=(0, -G),
        bars={"a": {"ends": ("A", "B"), "mass": 2.0, "kind": "driven"}, "b": {"ends": ("B", "C"), "mass": 1.0}},
        drives={"push": kt.CoordinateDrive(node="C", axis="x")},
    )  # fmt: skip
    moves = {"push": (2.0, 1.8), "a": (math.hypot(1, 0.5), 1.2)}
    motion, forces = solved(slider, kt.Quintic(moves=moves, duration=0.5), [0.2])
    for member in slider.bars:
        found = kt.dynamics.free_body(slider, motion, forces, member=member)
        assert found.residual < 1e-12 * found.largest
    symbols = [term.symbol for term in kt.dynamics.free_body(slider, motion, forces, node="C").bodies[0].terms]
    assert symbols == ["-F_B", "R", "D"]


@pytest.mark.slow
def test_faults_are_clear(slewed):
    model, motion, forces = slewed
    with pytest.raises(kt.InputError, match=r"No member called 'M66'\. Did you mean 'M6'"):
        kt.dynamics.free_body(model, motion, forces, member="M66", time=0)
    with pytest.raises(kt.InputError, match="No node called"):
        kt.dynamics.free_body(model, motion, forces, node="N0", time=0)
    with pytest.raises(kt.InputError, match="Name one thing"):
        kt.dynamics.free_body(model, motion, forces, node="N1", member="M1", time=0)
    with pytest.raises(kt.InputError, match=r"outside the motion, 0 s to 0\.55 s"):
        kt.dynamics.free_body(model, motion, forces, member="M1", time=2)
    with pytest.raises(kt.InputError, match="there are 3 samples"):
        kt.dynamics.free_body(model, motion, forces, member="M1")
    with pytest.raises(kt.InputError, match="another model|other nodes"):
        kt.dynamics.free_body(tripod(), motion, forces, member="LA", time=0)
    with pytest.raises(kt.InputError, match="different instants"):
        kt.dynamics.free_body(model, motion.with_(data=motion.data.isel(time=[0])), forces, member="M1", time=0)
