"""Stops: bounces, restitution and rest in closed form, contact as events, faults before the run."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import kinetruss as kt

MASS, SPEED, GAP = 2.0, 3.0, 0.6
TIGHT = kt.DOP853(rtol=1e-12, atol=1e-13)
REACH = kt.CoordinateDrive(node="P", axis="x")


def runner(gravity=0.0, speed=SPEED, **stop):
    """A mass that runs along x towards a stop at x = GAP."""
    return kt.Model(
        nodes={"O": (-1, 0), "P": kt.Node(at=(0, 0), mass=MASS)},
        fixed={"O": "xy", "P": "y"},
        bars={"eye": kt.Bar(ends=("O", "P"), kind="free")},
        gravity=(gravity, 0.0),
        velocities={"P": (speed, 0.0)},
        stops={"wall": kt.Stop(**({"coordinate": REACH, "upper": GAP, "stiffness": 800.0} | stop))},
    )


def contact(run):
    """Times at which contact begins and ends."""
    found = [(one.time, one.direction) for one in run.events if one.name == "wall.upper"]
    assert [way for _, way in found] == [1, -1] * (len(found) // 2)
    return [time for time, _ in found]


@pytest.mark.parametrize("method", [kt.DOP853(), kt.Radau(), kt.EnergyMomentum(step=1e-4)], ids=lambda one: one.kind)
def test_a_linear_bounce_lasts_half_a_period(method):
    run = kt.dynamics.simulate(runner(), 0.5, samples=3, method=method)
    begin, end = contact(run)
    assert begin == pytest.approx(GAP / SPEED, abs=1e-6)
    assert end - begin == pytest.approx(math.pi * math.sqrt(MASS / 800.0), rel=1e-5)
    assert run.motion.velocity.sel(node="P").values[-1, 0] == pytest.approx(-SPEED, rel=1e-6)


@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.0])
@pytest.mark.parametrize("damping", [0.02, 0.3])
def test_restitution_is_that_of_hunt_and_crossley(exponent, damping):
    """m d'' = -k d^n (1 + c d') gives c (v + w) = ln((1 + c v)/(1 - c w)) of the speeds before and after, whatever n."""
    run = kt.dynamics.simulate(runner(damping=damping, exponent=exponent, stiffness=5e3), 0.8, samples=3, method=TIGHT)
    after = -float(run.motion.velocity.sel(node="P").values[-1, 0])
    exact = brentq(lambda w: damping * (SPEED + w) - math.log((1 + damping * SPEED) / (1 - damping * w)), 1e-9, SPEED)
    assert after == pytest.approx(exact, rel=1e-7)


def test_the_energy_lost_is_what_the_stop_takes():
    run = kt.dynamics.simulate(runner(damping=0.3), 0.5, samples=4001, method=kt.DOP853())
    taken = np.trapezoid(run.forces.dissipation.values, run.time.values)
    assert run.kinetic_energy.values[0] - run.kinetic_energy.values[-1] == pytest.approx(taken, rel=1e-5)


def test_a_weight_rests_on_a_stop_by_its_force_over_the_stiffness():
    model = runner(gravity=9.81, speed=0.0).with_(velocities={})
    found = kt.statics.equilibrium(model)
    assert found.data.position.sel(node="P").values[0] == pytest.approx(GAP + MASS * 9.81 / 800.0, rel=1e-12)
    assert found.data.stop_force.values == pytest.approx([-MASS * 9.81], rel=1e-12)


# One-sided laws that begin to act at a gap, or just there: the body has no stiffness before, and all of it behind.
ONE_SIDED = {
    "stop": lambda gap, k: runner(9.81, 0.0, upper=gap, stiffness=k),
    "cable": lambda gap, k: runner(9.81, 0.0).with_(
        stops={}, bars={"eye": kt.Bar(ends=("O", "P"), kind="cable", stiffness=k, natural_length=1.0 + gap)}
    ),
    "play": lambda gap, k: runner(9.81, 0.0).with_(
        stops={}, springs={"wall": kt.Spring(coordinate=REACH, stiffness=k, play=max(gap, 1e-30))}
    ),
}


@pytest.mark.parametrize("kind", ONE_SIDED)
@pytest.mark.parametrize("stiffness", [1e2, 1e4, 1e6, 1e8, 1e10])
@pytest.mark.parametrize("gap", [0.0, 1e-16, 1e-12, 1e-8, 1e-4, 0.3])
def test_a_weight_rests_on_what_it_only_just_touches(kind, stiffness, gap):
    model = ONE_SIDED[kind](gap, stiffness).with_(velocities={})
    found = kt.statics.equilibrium(model)
    force = MASS * 9.81
    # places have 16 digits of the size of the structure
    assert float(found.position.sel(node="P")[0]) == pytest.approx(gap + force / stiffness, rel=1e-9, abs=4e-16)
    assert found.stable


def test_a_weight_on_a_stop_at_an_angle_that_it_has_to_round_off():
    """The angle is that of atan2, not of the model; the arm is pushed with m g cos(angle) times its length."""
    angle = math.atan2(0.6, 0.8)
    arm = kt.Model(
        nodes={"O": (0, 0), "G": (1, 0), "P": kt.Node(at=(0.8, 0.6), mass=MASS)},
        fixed=["O", "G"],
        bars={"arm": kt.Bar(ends=("O", "P"), mass=0.0)},
        gravity=(0, -9.81),
    )
    hinge, k = kt.HingeDrive(axis="O", start="G", end="P"), 5e9
    for lower in (math.nextafter(angle, 0.0), angle, math.nextafter(angle, 1.0)):
        found = kt.statics.equilibrium(arm.with_(stops={"rest": kt.Stop(coordinate=hinge, lower=lower, stiffness=k)}))
        assert found.data.stop_force.values == pytest.approx([MASS * 9.81 * 0.8], rel=1e-6)


def test_a_hinge_between_two_stops_stays_between_them():
    """A pendulum with stops on both sides of its lowest place, in three engines' terms: value and force of the stop."""
    hinge = kt.HingeDrive(axis="O", start="G", end="P")
    model = kt.Model(
        nodes={"O": (0, 0), "G": (0, -1), "P": kt.Node(at=(0.6, -0.8), mass=1.0)},
        fixed=["O", "G"],
        bars={"arm": kt.Bar(ends=("O", "P"), mass=0.0)},
        gravity=(0, -9.81),
        stops={"ends": kt.Stop(coordinate=hinge, lower="-20 deg", upper="50 deg", stiffness="4 kN m/rad", damping=0.2)},
    )
    run = kt.dynamics.simulate(model, 6.0, samples=6001, method=kt.DOP853())
    angle = run.forces.stop_value.values[:, 0]
    beyond = np.maximum(np.maximum(np.radians(-20) - angle, angle - np.radians(50)), 0.0)
    assert 0.0 < beyond.max() < np.radians(3)
    force = run.forces.stop_force.values[:, 0]
    assert np.all(force[beyond == 0.0] == 0.0)
    assert np.all(force * (angle - np.radians(15)) <= 0.0)
    assert {one.name for one in run.events} == {"ends.lower"}
    kinetic = run.kinetic_energy + run.potential_energy
    assert float(kinetic[-1]) < float(kinetic[0])


def test_faults_come_before_the_run():
    with pytest.raises(kt.InputError, match=r"stops\.wall\.upper: the coordinate is 0 in the model, beyond the stop at -0.1"):
        kt.dynamics.simulate(runner(upper=-0.1), 1.0)
    with pytest.raises(kt.ModelError, match="lower 1 is not below upper 0.6"):
        runner(lower=1.0)
    with pytest.raises(kt.ModelError, match="no end"):
        runner(upper=None)
    with pytest.raises(kt.ModelError, match="'Z'"):
        runner(coordinate=kt.CoordinateDrive(node="Z", axis="x"))
    with pytest.raises(kt.InputError, match="the stop 'wall' is met or left"):
        kt.dynamics.simulate(runner(), 1.0, method=kt.Taylor())


def test_a_stop_on_a_sum_tells_of_contact():
    """Along a wall that leans: 0.6 x + 0.8 y reaches the gap where the path crosses the line."""
    terms = ((REACH, 0.6), (kt.CoordinateDrive(node="P", axis="y"), 0.8))
    model = runner(coordinate=None, terms=terms, upper=GAP).with_(fixed={"O": "xy"}, velocities={"P": (1.0, 0.5)})
    run = kt.dynamics.simulate(model, 2.0, samples=5, method=TIGHT)
    begin, end = contact(run)
    assert begin == pytest.approx(GAP / (0.6 + 0.4), abs=1e-9)
    assert end - begin == pytest.approx(math.pi * math.sqrt(MASS / 800.0), rel=1e-9)
    there = kt.Event(terms=terms, value="0.3 m")
    found = kt.dynamics.simulate(model, 2.0, samples=5, events={"there": there})
    assert found.events[0].time == pytest.approx(0.3, abs=1e-9)
    assert "there (sum P x + P y crosses 0.3 m)" in found.message
