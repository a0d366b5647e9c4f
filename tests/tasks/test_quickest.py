"""The quickest motion along a path: one limit is just reached, none is exceeded."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

TOP = ("B2.N7", "B2.N9", "B2.N8")
MODEL = kt.library.vgt.double_octahedral(bays=2, gravity=(0, 0, -9.81), tip_force=(0, 0, "-100 N"))
MOTION = kt.kinematics.inverse(MODEL, kt.Positioning(nodes=TOP, moves={"x": 0.15}, duration=2.0), samples=101)


@pytest.mark.slow
@pytest.mark.parametrize(
    "limits",
    [{"rate": 0.05}, {"acceleration": {"B1.M7": 0.2}}, {"force": 1500.0}, {"rate": 0.2, "acceleration": 1.0, "force": 2500.0}],
)
def test_one_limit_is_used_in_full_and_none_exceeded(limits):
    found = kt.dynamics.quickest(MODEL, MOTION, **limits)
    assert found.use == pytest.approx(1, abs=1e-12)
    forces = kt.dynamics.inverse(MODEL, found.motion)
    data = {"rate": found.motion.drive_velocity, "acceleration": found.motion.drive_acceleration, "force": forces.drive_force}
    for what, limit in limits.items():
        table = limit if isinstance(limit, dict) else dict.fromkeys(MODEL.all_drives, limit)
        for name, most in table.items():
            assert np.abs(data[what].sel(drive=name).values).max() <= most * (1 + 1e-12)
    assert found.duration == pytest.approx(2 * found.factor, rel=1e-14)


def test_the_scaled_motion_is_that_of_the_task_with_the_other_duration():
    found = kt.dynamics.quickest(MODEL, MOTION, rate=0.05)
    task = kt.Positioning(nodes=TOP, moves={"x": 0.15}, duration=found.duration)
    again = kt.kinematics.inverse(MODEL, task, samples=101)
    assert again.drive_velocity.values == pytest.approx(found.motion.drive_velocity.values, abs=1e-11)
    assert again.drive_acceleration.values == pytest.approx(found.motion.drive_acceleration.values, abs=1e-10)


@pytest.mark.slow
def test_motor_limits_are_kept():
    trains = {"screw": "screw_lacy_spatial", "gear": "gear_lacy", "motor": "motor_lacy"}
    model = kt.library.vgt.double_octahedral(tip_force=(0, 0, "-20 N"), gravity=(0, 0, -9.81), **trains)
    motion = kt.kinematics.inverse(model, kt.Positioning(node="N8", moves={"z": 1.0}, free=["x", "y"]), samples=51)
    limits = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion)).data["limit"].drop_sel(quantity="stroke")
    if not np.isfinite(limits.values).any():
        name, motor = next(iter(model.motors.items()))
        model = model.with_(motors={name: motor.with_(max_voltage="20 V")})
    found = kt.dynamics.quickest(model, motion)
    assert found.use == pytest.approx(1, abs=1e-9)
    demand = kt.actuators.evaluate(model, found.motion, kt.dynamics.inverse(model, found.motion)).data
    share = demand["utilisation"].drop_sel(quantity="stroke").values
    assert np.nanmax(share) == pytest.approx(1, abs=1e-9)


def test_a_load_at_rest_beyond_the_limit_and_no_limit_at_all_are_refused():
    with pytest.raises(kt.InputError, match="no time is long enough"):
        kt.dynamics.quickest(MODEL, MOTION, force=1e-3)
    with pytest.raises(kt.InputError, match="no limit to keep"):
        kt.dynamics.quickest(MODEL, MOTION)
    with pytest.raises(kt.InputError, match="No drive called"):
        kt.dynamics.quickest(MODEL, MOTION, rate={"no": 1.0})


ARM, MASS, TURN, WALL = 0.4, 1.7, np.radians(120), np.array([1.0, 0.0])
TIMES, PUSHES = np.array([0.0, 0.3, 0.7, 1.5]), np.array([[5.0, -8.0], [9.0, 2.0], [-4.0, 6.0], [0.0, 0.0]])
HINGE = kt.AngleDrive("crank")
RESISTING = {
    "weight": {},
    "bar that damps": {"bars": {"d": kt.Bar(ends=("A", "W"), kind="elastic", stiffness=1e-6, damping=30.0)}},
    "damped spring": {"springs": {"s": kt.Spring(coordinate=HINGE, stiffness=4.0, damping=2.5)}},
    "friction": {"springs": {"s": kt.Spring(coordinate=HINGE, friction=5.0, slip=0.05, damping=0.5)}},
    "load in time": {"loads": {"f": kt.NodalForce(node="A", times=list(TIMES), forces=[tuple(f) for f in PUSHES])}},
}


def crank(bars=None, **parts):
    """A mass on a crank, and what resists it."""
    nodes = {"O": (0, 0), "A": kt.Node(at=(ARM, 0), mass=MASS), "W": tuple(WALL)}
    bars = {"crank": kt.Bar(ends=("O", "A"), mass=0)} | (bars or {})
    return kt.Model(nodes=nodes, fixed=["O", "W"], gravity=(0, -9.81), bars=bars, drives={"turn": HINGE}, **parts)


def torque(kind, duration, s):
    """The torque of the crank along a quintic, from Newton's law, at parts s of its duration."""
    at = TURN * (10 * s**3 - 15 * s**4 + 6 * s**5)
    rate, second = TURN * 30 * (s * (1 - s)) ** 2 / duration, TURN * 60 * s * (1 - s) * (1 - 2 * s) / duration**2
    place, aside = ARM * np.array([np.cos(at), np.sin(at)]), ARM * np.array([-np.sin(at), np.cos(at)])
    found = MASS * ARM**2 * second + MASS * 9.81 * place[0]
    if kind == "bar that damps":
        along = WALL[:, None] - place
        along /= np.linalg.norm(along, axis=0)
        found += 30.0 * (along * aside).sum(axis=0) ** 2 * rate
    if kind == "damped spring":
        found += 4.0 * at + 2.5 * rate
    if kind == "friction":
        found += 5.0 * np.tanh(rate / 0.05) + 0.5 * rate
    if kind == "load in time":
        found -= sum(np.interp(s * duration, TIMES, PUSHES[:, c]) * aside[c] for c in range(2))
    return np.abs(found)


@pytest.mark.slow
@pytest.mark.parametrize("given", [0.2, 20.0])
@pytest.mark.parametrize("kind", RESISTING)
def test_whatever_resists_the_limit_is_kept_and_a_quicker_motion_would_exceed_it(kind, given):
    motion = kt.kinematics.follow(crank(**RESISTING[kind]), kt.Quintic(moves={"turn": (0, TURN)}, duration=given), samples=201)
    found = kt.dynamics.quickest(crank(**RESISTING[kind]), motion, force=24.0)
    s = np.linspace(0, 1, 201)
    assert found.use == pytest.approx(1, abs=1e-9)
    assert torque(kind, found.duration, s).max() == pytest.approx(24.0, rel=1e-6)
    assert torque(kind, found.duration, np.linspace(0, 1, 5001)).max() < 24.0 * 1.001
    quicker = [torque(kind, found.duration * k, s).max() for k in np.geomspace(0.01, 0.999, 200)]
    assert min(quicker) > 24.0


@pytest.mark.slow
def test_friction_beyond_the_limit_leaves_a_motion_that_creeps():
    """Weight and friction exceed the limit together: only below the rate of slip is there less friction."""
    model = crank(springs={"s": kt.Spring(coordinate=HINGE, friction=5.0, slip=0.05)})
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (0, TURN)}, duration=1.0), samples=101)
    found = kt.dynamics.quickest(model, motion, force=8.0)
    assert found.duration > 10
    assert found.use == pytest.approx(1, abs=1e-9)


@pytest.mark.slow
def test_a_load_that_comes_later_is_not_one_at_rest():
    late = kt.NodalForce(node="A", times=[0.0, 1.0, 1.1], forces=[(0, 0), (0, 0), (0, -60.0)])
    model = crank(loads={"late": late})
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (0, TURN)}, duration=3.0), samples=101)
    found = kt.dynamics.quickest(model, motion, force=24.0)
    assert found.duration == pytest.approx(kt.dynamics.quickest(crank(), motion, force=24.0).duration, rel=1e-9)
    assert found.duration < 1


@pytest.mark.slow
def test_what_no_pace_changes_has_no_quickest_motion():
    model = crank()
    steady = kt.kinematics.follow(model, kt.ConstantRate(rates={"turn": 1.0}, duration=1.0), samples=21)
    hung = model.with_(gravity=(0, 0))
    for one in (model, hung):
        with pytest.raises(kt.InputError, match="no quickest one"):
            kt.dynamics.quickest(one, steady, force=24.0)
    still = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (0.0, 0.0)}, duration=1.0), samples=21)
    with pytest.raises(kt.InputError, match="No drive moves"):
        kt.dynamics.quickest(model, still, force=24.0)
