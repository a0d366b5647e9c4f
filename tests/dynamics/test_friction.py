"""Viscous friction about pins: closed forms, balance of power and momentum, the same in every engine."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.dynamics import newton_euler
from kinetruss.library import mechanisms
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_forces, element_tangents

METHODS = [kt.DOP853(), kt.Radau(), kt.GeneralizedAlpha(step=1e-3), kt.EnergyMomentum(step=1e-3)]


def pendulum(c, **more):
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(0, -0.5), mass=2.0)}, fixed=["O"],
        bars={"rod": kt.Bar(ends=("O", "P"), mass=0.0, friction=c)}, **more,
    )  # fmt: skip


def scissors(c, heavy=1e6):
    """Two bars on one free pin, which stands still for its mass."""
    nodes = {"P": kt.Node(at=(0, 0), mass=heavy), "A": kt.Node(at=(0.5, 0), mass=2.0), "B": kt.Node(at=(0, 0.8), mass=1.0)}
    bars = {"a": kt.Bar(ends=("P", "A"), mass=0.0, friction=c), "b": kt.Bar(ends=("B", "P"), mass=0.0, friction=c)}
    return kt.Model(nodes=nodes, bars=bars, velocities={"A": (0.0, 1.0)})


def rubbing_four_bar(c=0.2):
    model = mechanisms.four_bar()
    return model.with_(bars={name: bar.with_(friction=(c, 2 * c)) for name, bar in model.bars.items()})


TURN = kt.Quintic(moves={"motor": (np.pi / 2, 3.0)}, duration=0.5)


def speed(run, node, radius):
    v = run.motion.data["velocity"].sel(node=node).values
    return np.hypot(v[:, 0], v[:, 1]) / radius


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS, ids=lambda one: one.kind)
def test_a_bar_on_the_ground_slows_down_exponentially(method):
    """w' = -c w/(m l^2)."""
    run = kt.dynamics.simulate(pendulum(0.3, velocities={"P": (1.0, 0.0)}), 2.0, method=method, samples=21)
    wanted = 2.0 * np.exp(-0.3 / (2.0 * 0.5**2) * run.motion.time.values)
    assert speed(run, "P", 0.5) == pytest.approx(wanted, abs=1e-8 if method.kind == "DOP853" else 2e-6)


@pytest.mark.slow
def test_two_bars_on_a_free_pin_share_their_bearings():
    """Two bearings of c in series are worth c/2: w_1' = -c/2 (w_1 - w_2)/I_1, and w_2 alike."""
    c, I, J = 0.3, 2.0 * 0.5**2, 1.0 * 0.8**2
    run = kt.dynamics.simulate(scissors(c), 2.0, samples=21)
    t = run.motion.time.values
    apart = 2.0 * np.exp(-c / 2 * (1 / I + 1 / J) * t)
    mean = 2.0 * I / (I + J)
    assert speed(run, "A", 0.5) == pytest.approx(mean + J / (I + J) * apart, rel=1e-5)
    assert speed(run, "B", 0.8) == pytest.approx(mean - I / (I + J) * apart, abs=2e-5)


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(st.floats(0.01, 3.0), st.floats(0.5, 50.0))
def test_momentum_is_kept_and_energy_goes_into_friction(c, heavy):
    run = kt.dynamics.simulate(scissors(c, heavy), 1.0, samples=11)
    data = run.data
    assert np.ptp(data["angular_momentum"].values, axis=0) == pytest.approx(0.0, abs=1e-8)
    assert np.ptp(data["momentum"].values, axis=0) == pytest.approx(0.0, abs=1e-8)
    assert np.abs(run.forces.data["energy_balance"].values).max() < 1e-8
    assert np.all(np.diff(data["energy"].values) < 0)


def test_a_small_swing_is_a_damped_oscillator():
    """m l^2 theta'' + c theta' + m g l theta = 0."""
    model = pendulum(0.3, gravity=(0.0, -9.81))
    inertia = 2.0 * 0.5**2
    poles = kt.dynamics.linearise(model)
    found = poles.pole_real.values + 1j * poles.pole_imag.values
    wanted = np.roots([inertia, 0.3, 2.0 * 9.81 * 0.5])
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(wanted), rel=1e-10)


@pytest.mark.slow
def test_a_drive_pays_for_the_friction():
    """Power of the drive, with friction less without, is what friction takes; nothing changes at rest."""
    with_, without = rubbing_four_bar(), mechanisms.four_bar()
    motion = kt.kinematics.follow(with_, TURN, samples=31)
    plain = kt.kinematics.follow(without, TURN, samples=31)
    one, two = kt.dynamics.inverse(with_, motion), kt.dynamics.inverse(without, plain)
    rate = motion.data["drive_velocity"].values[:, 0]
    paid = (one.data["drive_force"] - two.data["drive_force"]).values[:, 0] * rate
    lost = one.data["dissipation"].values
    assert lost.max() > 0.1
    assert paid == pytest.approx(lost, rel=1e-10, abs=1e-12)
    assert np.abs(one.data["energy_balance"].values).max() < 1e-9 * np.abs(one.data["power"].values).max()
    assert one.static.data["reaction"].values == pytest.approx(two.static.data["reaction"].values, abs=1e-12)


def test_a_simulation_finds_the_same_forces():
    model = rubbing_four_bar()
    run = kt.dynamics.simulate(model, 0.4, trajectory=TURN, samples=5)
    same = kt.dynamics.inverse(model, run.motion)
    for name in ("joint_force", "reaction", "drive_force", "action_couple"):
        size = np.abs(same.data[name].values).max()
        assert run.forces.data[name].values == pytest.approx(same.data[name].values, abs=1e-8 * size)


def test_every_bar_and_node_is_in_balance_with_its_couples():
    model = rubbing_four_bar()
    motion = kt.kinematics.follow(model, TURN, samples=9)
    forces = kt.dynamics.inverse(model, motion)
    for time in motion.time.values[[1, 4]]:
        found = newton_euler(model, motion, forces, time=time)
        assert found.residual < 1e-9 * found.largest
        assert found.difference < 1e-9 * found.largest


@pytest.mark.slow
def test_the_bar_is_bent_by_the_couple_at_its_pin():
    """A bar without mass that swings a mass: the moment falls from c w at the pin to nothing at the mass."""
    model = pendulum(0.3, velocities={"P": (1.0, 0.0)})
    run = kt.dynamics.simulate(model, 1.0, samples=5)
    found = kt.strength.sections(model, run.forces, stations=5).section_M.sel(part="rod").values[:, :, 0]
    wanted = 0.3 * speed(run, "P", 0.5)[:, None] * np.linspace(1.0, 0.0, 5)
    assert np.abs(found) == pytest.approx(wanted, abs=1e-10)
    assert np.ptp(np.sign(found[:, :4])) == 0


def test_stiffness_and_damping_are_the_derivatives_of_the_forces():
    system = compile(rubbing_four_bar())
    rng = np.random.default_rng(3)
    x = system.x0 + 0.01 * rng.standard_normal(system.x0.shape) * [1, 1, 0]
    v = rng.standard_normal(x.shape) * [1, 1, 0]

    def force(x, v):
        return element_forces(system, x, v)

    K, C = element_tangents(system, x, v)
    for matrix, of in ((K, 0), (C, 1)):
        for k in range(x.size):
            if k % 3 == 2:
                continue
            step = np.zeros(x.size)
            step[k] = 1e-5
            ahead, behind = ([y + s * step.reshape(x.shape) * (j == of) for j, y in enumerate((x, v))] for s in (1, -1))
            slope = -(force(*ahead) - force(*behind)) / 2e-5
            assert matrix.toarray()[:, k] == pytest.approx(slope, abs=1e-7 * np.abs(matrix.toarray()).max())


def test_text_units_and_both_ends():
    bar = kt.Bar(ends=("A", "B"), friction=("20 N mm s", 0.1))
    assert bar.friction == pytest.approx((0.02, 0.1))
    assert kt.Bar(ends=("A", "B"), friction="0.1 N m s/rad").friction == pytest.approx((0.1, 0.1))


def test_space_has_no_such_friction():
    with pytest.raises(kt.ModelError, match="friction: is given in space"):
        kt.Model(nodes={"O": (0, 0, 0), "P": (1, 0, 0)}, bars={"rod": kt.Bar(ends=("O", "P"), friction=0.1)})


@pytest.mark.parametrize("kind", ["cable", "free"])
def test_what_takes_nothing_across_has_none(kind):
    law = {"stiffness": 1e3} if kind == "cable" else {}
    with pytest.raises(kt.ModelError, match="friction: is given for a (cable|free bar), which takes nothing across"):
        kt.Model(nodes={"O": (0, 0), "P": (1, 0)}, bars={"rod": kt.Bar(ends=("O", "P"), kind=kind, friction=0.1, **law)})


def test_series_and_samples_agree():
    options = {"samples": 6, "tasks": {"motor": kt.GivenForce(torque=2.0)}}
    one, two = (
        kt.dynamics.simulate(rubbing_four_bar(), 0.5, method=method(rtol=1e-12, atol=1e-13), **options)
        for method in (kt.Taylor, kt.DOP853)
    )
    np.testing.assert_allclose(one.motion.position, two.motion.position, atol=1e-10)
