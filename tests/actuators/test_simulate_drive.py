"""Drive trains forwards: closed forms, conservation of energy, sticking, saturation, and back again by the inverse."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from scipy.integrate import DOP853, Radau

import kinetruss as kt
from kinetruss.actuators import motor_demand, place_poles, screw_torque, simulate_drive, train_of
from kinetruss.actuators.events import Interpolant
from kinetruss.actuators.steps import finite_rates
from kinetruss.errors import InputError, ModelError
from kinetruss.kinematics.sampling import sample_profile
from kinetruss.library.drives import MOTOR_LACY, TRAIN_LACY, TRAIN_LACY_SLEWING

SMOOTH = kt.LeadScrew(lead=2.5e-4, mean_diameter=0.0127)
FREE = TRAIN_LACY.with_(screw=SMOOTH)
COARSE = TRAIN_LACY.with_(screw=kt.LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1))
GEARED = kt.DriveTrain(
    screw=TRAIN_LACY.screw.with_(static_friction=0.15),
    gear=kt.Gear(ratio=5.2, efficiency=0.8, inertia=1e-6),
    motor=MOTOR_LACY.with_(friction_torque=2e-3, max_current=4.0, inductance=3e-3),
    amplifier=kt.Amplifier(voltage_gain=4.0, max_input=6.0),
)


def closes(run, tolerance=1e-7):
    """Electrical energy = heat + friction + stored + work."""
    size = max(np.abs(run.electrical_energy.values).max(), np.abs(run.actuator_work.values).max(), 1e-6)
    assert np.abs(run.energy_balance.values).max() < tolerance * size


def inverted(train, run):
    """What the inverse drive train says of the length history."""
    torque = screw_torque(train.screw, run.thrust.values, run.length_rate.values)
    change = np.gradient(run.current.values, run.time.values) if train.motor.inductance else 0.0
    return motor_demand(train.screw, train.gear, train.motor, torque, run.length_rate.values, run.length_acceleration.values,
                         change)  # fmt: skip


def test_step_of_voltage_has_the_time_constant_of_the_motor():
    motor = kt.Motor(time_constant=0.02, resistance=2.0, torque_constant=0.04, emf_constant=0.04)
    run = simulate_drive(FREE.with_(motor=motor), kt.StepInput(voltage=10.0), duration=0.2)
    expected = 10.0 / 0.04 * (1 - np.exp(-run.time.values / 0.02))
    np.testing.assert_allclose(run.motor_speed.values, expected, atol=1e-6 * 250)
    assert run.status is kt.Status.COMPLETED
    closes(run)


def test_steady_speed_against_a_load():
    run = simulate_drive(TRAIN_LACY, kt.StepInput(voltage=12.0), load=40.0, duration=0.3)
    torque = kt.actuators.raising_torque(TRAIN_LACY.screw, 40.0) / 5.2
    speed = (12.0 - 2.0 * torque / 0.0398) / 0.0398
    assert run.motor_speed.values[-1] == pytest.approx(speed, rel=1e-9)


def test_step_of_current_accelerates_uniformly():
    run = simulate_drive(FREE, kt.StepInput(current=0.5), load=kt.DriveLoad(thrust=10.0, mass=20.0), duration=0.1)
    k, lead = 5.2 / SMOOTH.lead, SMOOTH.lead
    a = (0.0398 * 0.5 - 10.0 * lead / 5.2) / (6.76e-6 * k + 20.0 * lead / 5.2)
    np.testing.assert_allclose(run.length.values, 1 + a * run.time.values**2 / 2, rtol=1e-11)


@pytest.mark.parametrize(
    ("order", "amplifier"),
    [(2, kt.Amplifier(voltage_gain=3.0)), (3, kt.Amplifier(voltage_gain=3.0)), (2, kt.Amplifier(current_gain=1.8))],
    ids=["voltage", "winding", "current"],
)
def test_placed_poles_give_the_closed_form(order, amplifier):
    motor = MOTOR_LACY.with_(inductance=0.01 if order == 3 else 0.0, max_voltage=None)
    train, loop = FREE.with_(motor=motor, amplifier=amplifier), kt.PositionLoop(target=1.001, settling_time=0.5)
    run = simulate_drive(train, loop, load=kt.DriveLoad(mass=5.0), duration=1.0)
    law = sample_profile(
        kt.StepResponse(moves={"x": (1.0, 1.001)}, duration=1.0, settling_time=0.5, order=order), run.time.values, {}
    )["x"]
    np.testing.assert_allclose(run.length.values, law[0], rtol=0, atol=1e-9 * 1e-3 * 10)
    np.testing.assert_allclose(run.length_rate.values, law[1], rtol=0, atol=1e-8 * np.abs(law[1]).max())
    assert place_poles(train, loop, 5.0).order == order
    closes(run)


def test_a_self_locking_screw_holds_and_another_runs_back():
    held = simulate_drive(TRAIN_LACY, kt.StepInput(voltage=0.0), load=500.0, duration=1.0)
    assert np.all(held.length.values == 1.0)
    assert held.episodes == ()
    loose = simulate_drive(COARSE, kt.StepInput(voltage=0.0), load=500.0, duration=1.0)
    assert loose.length.values[-1] < 1.0
    assert [one.kind for one in loose.episodes] == ["driven back"]
    # shorted winding brakes: K_t K_b w/R = lowering torque of the load at the motor
    lowering = -kt.actuators.lowering_torque(COARSE.screw, 500.0) / 5.2
    assert -loose.motor_speed.values[-1] == pytest.approx(lowering * 2.0 / 0.0398**2, rel=1e-8)
    assert loose.electrical_energy.values[-1] == pytest.approx(0.0, abs=1e-12)
    closes(loose)


def test_the_self_locking_limit_needs_no_torque_downwards():
    screw = kt.LeadScrew(lead=0.003, mean_diameter=0.02, friction=0.3)  # lead = mu d/2
    train = kt.DriveTrain(screw=screw, motor=MOTOR_LACY.with_(max_voltage=None))
    down = simulate_drive(train, kt.StepInput(voltage=-1.0), load=100.0, duration=0.5)
    empty = simulate_drive(train, kt.StepInput(voltage=-1.0), load=0.0, duration=0.5)
    np.testing.assert_allclose(down.length.values, empty.length.values, rtol=1e-12)


def test_break_away_waits_for_the_static_friction():
    screw = TRAIN_LACY.screw.with_(static_friction=0.2)
    ramp = kt.TableInput(times=(0.0, 1.0), currents=(0.0, 1.0))
    run = simulate_drive(TRAIN_LACY.with_(screw=screw), ramp, load=100.0, duration=1.0)
    start = float(kt.actuators.breakaway_torque(screw, 100.0, 1)) / 5.2 / 0.0398
    stuck, starved = run.episodes  # then 25 V no longer drive the current asked for
    assert (stuck.kind, stuck.start) == ("stuck", 0.0)
    assert starved.kind == "voltage saturated"
    assert stuck.end == pytest.approx(start, rel=1e-9)
    moving = run.time.values > start
    assert np.all(run.length_rate.values[~moving] == 0)
    assert np.all(run.length_rate.values[moving] > 0)


def test_too_weak_a_drive_says_when_and_by_how_much():
    run = simulate_drive(TRAIN_LACY_SLEWING, kt.StepInput(voltage=3.0), load=40.0, duration=1.0)
    assert run.status is kt.Status.STALLED
    (stuck,) = run.episodes
    needed = 0.6 + kt.actuators.raising_torque(TRAIN_LACY_SLEWING.screw, 40.0) / 5.1
    assert (stuck.wanted, stuck.possible) == (pytest.approx(needed), pytest.approx(3.0 * 1.8 * 0.1))
    assert "from 0 s to 1 s" in run.message
    assert "68.2 mN m less" in run.message


def test_saturation_is_found_to_the_instant():
    ramp = kt.TableInput(times=(0.0, 1.0, 2.0), voltages=(0.0, 10.0, 0.0))
    run = simulate_drive(TRAIN_LACY_SLEWING, ramp, load=40.0, duration=2.0)
    saturated = next(one for one in run.episodes if one.kind == "input saturated")
    assert (saturated.start, saturated.end) == (pytest.approx(0.5, abs=1e-8), pytest.approx(1.5, abs=1e-8))
    assert (saturated.time, saturated.wanted) == (pytest.approx(1.0), pytest.approx(10.0))
    assert run.status is kt.Status.SPEED_LIMIT
    fast = next(one for one in run.episodes if one.kind == "speed limit")
    assert np.abs(run.motor_speed.values).max() == pytest.approx(400.0)
    inside = (run.time.values > fast.start) & (run.time.values < fast.end)
    assert np.all(run.length_acceleration.values[inside] == 0)
    closes(run)


@pytest.mark.parametrize(
    ("train", "history"),
    [
        (GEARED, kt.SineInput(voltage=6.5, period=0.3)),
        (TRAIN_LACY_SLEWING, kt.TableInput(times=(0.0, 0.2, 0.5), voltages=(0.0, 10.0, -2.0))),
    ],
    ids=["inductive", "speed limit"],
)
def test_the_equations_of_a_drive_alone_are_those_of_many(monkeypatch, train, history):
    load = kt.DriveLoad(thrust=100.0, mass=5.0)
    alone = simulate_drive(train, history, load=load, duration=0.5)
    monkeypatch.setattr("kinetruss.actuators.modes.Coordinate", type("NoBody", (), {}))
    many = simulate_drive(train, history, load=load, duration=0.5)
    for name, column in alone.data.items():
        np.testing.assert_array_equal(column.values, many.data[name].values, err_msg=name)


def test_scipys_interpolant_is_one_product():
    for method in (DOP853, Radau):
        solver = method(lambda t, y: np.array([y[1], -y[0]]), 0.5, [1.0, 0.3], 3.0, rtol=1e-6)
        solver.step()
        dense = solver.dense_output()
        quick = Interpolant(dense)
        for t in np.linspace(dense.t_min, dense.t_max, 7):
            np.testing.assert_allclose(quick(t), dense(t), rtol=0, atol=1e-15)
        s = np.linspace(0, 1, 9)
        basis = np.array([math.comb(12, j) * s**j * (1 - s) ** (12 - j) for j in range(13)])
        expected = dense(dense.t_min + s * (dense.t_max - dense.t_min))
        np.testing.assert_allclose(basis.T @ quick.bernstein(), expected.T, rtol=0, atol=1e-12)


def test_the_end_of_the_stroke_ends_the_run():
    run = simulate_drive(TRAIN_LACY, kt.StepInput(voltage=12.0), load=40.0, duration=1.0, limits=(0.9, 1.01))
    assert run.status is kt.Status.END_OF_STROKE
    assert run.time.values[-1] < 1.0
    assert run.episodes[-1].kind == "end of stroke"
    assert run.length.values.max() <= 1.01


INPUTS = st.one_of(
    st.builds(kt.StepInput, voltage=st.floats(-8, 8), start=st.floats(0, 0.3)),
    st.builds(kt.SineInput, voltage=st.floats(0.5, 8), period=st.floats(0.1, 1.0)),
    st.builds(kt.ExponentialInput, voltage=st.tuples(st.floats(-5, 5), st.floats(-8, 8)), time_constant=st.floats(0.02, 1.0)),
)
LOADS = st.builds(kt.DriveLoad, thrust=st.floats(-500, 500), mass=st.just(0.0) | st.floats(1e-6, 30))


@pytest.mark.slow
@given(st.sampled_from([GEARED, TRAIN_LACY, COARSE, TRAIN_LACY_SLEWING]), INPUTS, LOADS)
@example(TRAIN_LACY, kt.StepInput(voltage=1.0, start=5e-324), kt.DriveLoad(thrust=1.0))  # an interval without a middle
@settings(max_examples=20)
def test_power_closes_and_losses_only_grow(train, history, load):
    run = simulate_drive(train, history, load=load, duration=0.5, samples=101)
    closes(run, 1e-6)
    for name in ("copper_energy", "motor_loss", "gear_loss", "screw_loss"):
        values = run.data[name].values
        assert np.all(np.diff(values) >= -1e-9 * max(1.0, np.abs(values).max())), name


@given(st.sampled_from([TRAIN_LACY, COARSE, TRAIN_LACY_SLEWING]), INPUTS, LOADS)
@settings(max_examples=20)
def test_the_inverse_gives_back_voltage_and_current(train, history, load):
    run = simulate_drive(train, history, load=load, duration=0.5, samples=101)
    moving = (run.direction.values != 0) & (run.length_rate.values != 0)
    found = inverted(train, run)
    for name in ("voltage", "current"):
        np.testing.assert_allclose(found[name][moving], run.data[name].values[moving], rtol=1e-9, atol=1e-9)


def test_through_a_whole_model_and_back():
    train = TRAIN_LACY.with_(motor=MOTOR_LACY.with_(inductance=2e-3))
    mass = 12.0
    active = kt.Active(ends=("A", "B"), base=kt.Part(length=0.6, mass=2.0), tube=kt.Part(length=0.4, mass=0.5),
                       screw=train.screw, gear=train.gear, motor=train.motor)  # fmt: skip
    model = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": mass}}, fixed={"A": "xy", "B": "y"}, active={"M": active},
        loads={"push": {"node": "B", "force": (-300.0, 0.0)}},
    )  # fmt: skip
    assert train_of(model, "M") == train
    history = kt.ExponentialInput(voltage=(0.0, 12.0), time_constant=0.3)
    load = kt.DriveLoad(thrust=300.0, mass=mass + 0.5)
    run = simulate_drive(train, history, load=load, duration=1.0, samples=1001)
    motion = kt.kinematics.follow(model, run.trajectory("M"), times=run.time.values)
    demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    (stuck,) = run.episodes
    away = run.time.values > stuck.end + 0.02  # the spline rounds the start off
    for name, tolerance in (("current", 1e-5), ("voltage", 1e-5)):
        expected = run.data[name].values[away]
        assert np.abs(demand.data[name].values[away, 0] - expected).max() < tolerance * np.abs(expected).max(), name
    flow = kt.actuators.power_flow(model, motion, demand)
    assert np.abs(flow.balance).max() < 1e-12 * np.abs(flow.electrical).max()


def test_a_current_at_its_limit_with_inductance():
    train = TRAIN_LACY.with_(motor=MOTOR_LACY.with_(inductance=2e-3, max_current=2.0, friction_torque=0.005))
    run = simulate_drive(
        train, kt.SineInput(voltage=24.0, period=0.5), load=kt.DriveLoad(thrust=100.0, mass=10.0), duration=1.0
    )
    assert np.abs(run.current.values).max() <= 2.0 * (1 + 1e-12)
    closes(run)


def test_a_quick_winding_is_integrated_implicitly():
    history, load = kt.SineInput(voltage=20.0, period=0.4), 60.0
    quick = TRAIN_LACY.with_(motor=MOTOR_LACY.with_(inductance=1e-5))
    run = simulate_drive(quick, history, load=load, duration=0.3, rtol=1e-6)
    without = simulate_drive(TRAIN_LACY, history, load=load, duration=0.3)
    assert run.length.values[-1] == pytest.approx(without.length.values[-1], rel=1e-6)


def test_a_loop_follows_a_table_of_targets():
    loop = kt.PositionLoop(times=(0.0, 1.0, 2.0), targets=(1.0, 1.005, 1.005), settling_time=0.1)
    run = simulate_drive(TRAIN_LACY, loop, load=40.0, duration=2.0)
    assert abs(run.length.values[-1] - 1.005) < 2e-5
    late = run.with_(episodes=()).trajectory("M7")
    assert late.duration == 2.0


def test_loads_over_the_length_and_over_time():
    spring = kt.DriveLoad(lengths=(1.0, 1.1), thrusts=(0.0, 1e4))
    run = simulate_drive(TRAIN_LACY, kt.StepInput(voltage=12.0), load=spring, duration=0.5)
    np.testing.assert_allclose(run.thrust.values, 1e5 * (run.length.values - 1.0), rtol=1e-9, atol=1e-9)
    run = simulate_drive(
        TRAIN_LACY, kt.StepInput(voltage=12.0), load=kt.DriveLoad(times=(0, 1), thrusts=(0, 100)), duration=0.5
    )
    np.testing.assert_allclose(run.thrust.values, 100 * run.time.values, atol=1e-9)


@pytest.mark.parametrize(
    ("train", "history", "options", "message"),
    [
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 0.0}, "cannot run for 0 s"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "samples": 1}, "at least 2"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "times": [0.5, 0.2]}, "must increase"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "limits": (1.1, 1.2)}, "outside its limits"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "limits": (0.9, 1.0), "rate": 0.01}, "moves beyond it"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "length": math.nan}, "not finite"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "rtol": 1.0}, "no tolerance"),
        (TRAIN_LACY, kt.StepInput(voltage=1.0), {"duration": 1.0, "load": kt.DriveLoad(mass=1e6)}, "jams the self-locking"),
        (TRAIN_LACY, "12 V", {"duration": 1.0}, "no input of a drive"),
        (TRAIN_LACY_SLEWING, kt.StepInput(current=1.0), {"duration": 1.0}, "has an amplifier"),
        (
            TRAIN_LACY.with_(motor=MOTOR_LACY.with_(resistance=0.0)),
            kt.StepInput(voltage=1.0),
            {"duration": 1.0},
            "winding resist",
        ),
        (
            TRAIN_LACY.with_(motor=MOTOR_LACY.with_(inertia=0.0)),
            kt.StepInput(voltage=1.0),
            {"duration": 1.0},
            "without inertia",
        ),
    ],
)
def test_what_cannot_run_is_refused(train, history, options, message):
    with pytest.raises(InputError, match=message):
        simulate_drive(train, history, **options)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: kt.StepInput(), "either a voltage"),
        (lambda: kt.StepInput(voltage=1, current=1), r"either a voltage .V"),
        (lambda: kt.StepInput(voltage=1, start=2, end=1), "before it starts"),
        (lambda: kt.TableInput(times=(0, 1), voltages=(1, 2, 3)), "2 times but 3 values"),
        (lambda: kt.TableInput(times=(0, 0), voltages=(1, 2)), "goes back or stands still"),
        (lambda: kt.PositionLoop(settling_time=1), "one target"),
        (lambda: kt.DriveLoad(thrust=1, thrusts=(1, 2), times=(0, 1)), "one thrust, or a table"),
        (lambda: kt.DriveLoad(thrusts=(1, 2), lengths=(1, 0)), "must increase"),
        (lambda: kt.Amplifier(), "one gain"),
        (lambda: kt.Amplifier(voltage_gain=-1), "greater than 0"),
        (lambda: kt.LeadScrew(lead=1e-3, mean_diameter=0.01, friction=0.2, static_friction=0.1), "static friction 0.1"),
        (lambda: kt.Motor(inertia=1e-5, resistance=1, torque_constant=0.1, emf_constant=0.01), "would make power"),
        (
            lambda: kt.Motor(inertia=1e-5, resistance=1, torque_constant=0.1, emf_constant=0.1, time_constant=1),
            "does not fit",
        ),
        (lambda: kt.Motor(time_constant="16.4 ms", torque_constant=0.1, emf_constant=0.1), "'inertia' is missing"),
        (lambda: kt.Motor(time_constant="16.4 m", inertia=1, torque_constant=0.1, emf_constant=0.1), "not a time"),
    ],
)
def test_impossible_data_is_refused(make, message):
    with pytest.raises(ModelError, match=message):
        make()


def test_a_train_needs_its_parts():
    model = kt.library.vgt.triangular(screw="screw_lacy_planar", motor="motor_lacy")
    name = next(iter(model.active))
    assert train_of(model, name).gear.ratio == 1.0
    with pytest.raises(InputError, match="no active member 'M99'"):
        train_of(model, "M99")
    with pytest.raises(InputError, match="has no motor"):
        train_of(kt.library.vgt.triangular(screw="screw_lacy_planar"), name)


def test_rates_whose_squares_vanish_are_none():
    """They would be 0/0 in the error of a step, which then shrinks to nothing."""
    decay = DOP853(lambda t, y: finite_rates(np.array([-1e-160 * y[0], -1e-3 * y[1]])), 0.0, [1.0, 1e-150], 10.0)
    with np.errstate(invalid="raise"):
        while decay.status == "running":
            assert decay.step() is None
    assert (decay.status, decay.nfev < 100) == ("finished", True)
    assert finite_rates(np.array([1e-100, -1e-300])).tolist() == [1e-100, 0.0]
