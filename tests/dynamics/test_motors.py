"""Motors behind lead screws: alone as a drive train simulated by itself; together as inverse dynamics has it; energy, modes."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kinetruss as kt
from kinetruss import actuators, dynamics
from kinetruss.actuators.drive_model import drive_model_of
from kinetruss.actuators.slip import slipping
from kinetruss.dynamics.simulation import stepper_for
from kinetruss.dynamics.simulation_setup import Options, problem_of
from kinetruss.errors import InputError, ModelError
from kinetruss.library import drives, vgt
from kinetruss.model import (
    DOP853,
    Active,
    Amplifier,
    DriveLoad,
    EnergyMomentum,
    Event,
    ExponentialInput,
    Gear,
    GivenForce,
    LeadScrew,
    Model,
    Node,
    Part,
    PositionLoop,
    SineInput,
    StepInput,
    TableInput,
)
from kinetruss.results import Status

LACY = drives.TRAIN_LACY
LOSSY = LACY.with_(
    gear=Gear(ratio=5.2, efficiency=0.8, inertia=1e-6), motor=drives.MOTOR_LACY.with_(friction_torque=1e-3, inductance=2e-2)
)
STEEP = LOSSY.with_(screw=LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1))
STICKY = LACY.with_(screw=drives.SCREW_LACY_SPATIAL.with_(static_friction=0.35))
EXACT = DOP853(rtol=1e-11, atol=1e-12)
MASS = 12.5


def line(train, push=0.0, mass=12.0):
    """An active member on a line pushes a mass against a force; tube and node move, together `mass` + 0.5 kg."""
    member = Active(
        ends=("A", "B"), base=Part(length=0.6, mass=2.0), tube=Part(length=0.4, mass=0.5), screw=train.screw, gear=train.gear,
        motor=train.motor, amplifier=train.amplifier,
    )  # fmt: skip
    return Model(
        nodes={"A": (0.0, 0.0), "B": Node(at=(1.0, 0.0), mass=mass)}, fixed={"A": "xy", "B": "y"}, active={"M": member},
        loads={"push": {"node": "B", "force": (-push, 0.0)}} if push else {},
    )  # fmt: skip


def bay():
    return vgt.double_octahedral(
        tip_force=(0.0, 0.0, -46.0), screw=drives.SCREW_LACY_SPATIAL, gear=drives.GEAR_LACY, motor=drives.MOTOR_LACY
    )


def slower(train, speed):
    return train.with_(motor=train.motor.with_(max_speed=speed))


AMPLIFIED = LACY.with_(amplifier=Amplifier(voltage_gain=3.0, max_voltage=9.0))
LIMITED = LACY.with_(motor=LACY.motor.with_(inductance=2e-3, max_current=0.8, friction_torque=5e-3, max_speed=120.0))
ALONE = {
    "voltage step": (LACY, StepInput(voltage=12.0, start=0.1, end=0.5), 100.0, 0.8),
    "voltage settles": (STEEP, ExponentialInput(voltage=(0.0, 20.0), time_constant=0.05), 150.0, 0.3),
    "reversals, with a winding": (LOSSY, SineInput(voltage=20.0, period=0.25), 100.0, 0.3),
    "sticks between reversals": (STICKY, SineInput(voltage=8.0, period=0.4), 250.0, 0.8),
    "voltage saturates": (AMPLIFIED, SineInput(voltage=8.0, period=0.7, phase=0.3), 100.0, 0.8),
    "table of currents": (LACY, TableInput(times=(0.0, 0.2, 0.25, 0.8), currents=(0.0, 2.0, -3.0, 0.5)), 100.0, 0.8),
    "current limited": (LOSSY.with_(motor=LOSSY.motor.with_(max_current=2.5)), StepInput(voltage=12.0), 100.0, 0.1),
    "position loop": (LACY, PositionLoop(target=1.002, settling_time=0.3), 100.0, 0.5),
    "loop along a table": (
        AMPLIFIED, PositionLoop(times=(0.0, 0.2, 0.4), targets=(1.0, 1.002, 1.002), settling_time=0.1), 100.0, 0.6,
    ),
    "held at its largest speed": (slower(LACY, 150.0), SineInput(voltage=15.0, period=0.5), 100.0, 0.6),
    "held, with a winding": (slower(LOSSY, 150.0), SineInput(voltage=15.0, period=0.25), 60.0, 0.2),
    "limited, then held, then released": (LIMITED, SineInput(voltage=24.0, period=0.5), 100.0, 0.5),
    "driven beyond its largest speed": (slower(STEEP, 20.0), SineInput(voltage=5.0, period=0.3), 600.0, 0.3),
    "driven back by its load": (STEEP, StepInput(voltage=0.0), 300.0, 0.2),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", ALONE)
def test_one_motor_pushes_as_its_drive_train_alone(name):
    train, history, push, duration = ALONE[name]
    run = dynamics.simulate(line(train, push), duration, samples=51, tasks={"M": history}, method=EXACT)
    alone = actuators.simulate_drive(
        train, history, load=DriveLoad(thrust=push, mass=MASS), length=1.0, duration=duration, samples=51, rtol=1e-11
    )
    stroke = np.ptp(alone.length.values)
    assert stroke > 1e-5  # it does move
    assert_allclose(run.motion.length.sel(member="M"), alone.length, rtol=0, atol=1e-8 * stroke)
    for ours, theirs in (("motor_current", "current"), ("motor_voltage", "voltage"), ("motor_torque", "motor_torque")):
        values = alone.data[theirs].values
        assert_allclose(run.data[ours].values[:, 0], values, rtol=0, atol=1e-8 * np.abs(values).max())
    assert_allclose(run.data.motor_direction.values[:, 0], alone.direction)
    assert_allclose(run.data.screw_loss.values[:, 0], alone.screw_loss, rtol=0, atol=1e-9)
    assert np.abs(run.data.motor_energy_balance).max() < 1e-8 * np.abs(run.data.electrical_energy).max() + 1e-9


@pytest.mark.slow
def test_a_current_goes_on_by_its_winding_behind_both_limits():
    """Limited, then held at the largest speed, then released: L i' = U - R i - K w, with the slope of the samples."""
    train, U = LIMITED, SineInput(voltage=24.0, period=0.5)
    run = dynamics.simulate(line(train, 100.0), 0.5, samples=5001, tasks={"M": U}, method=EXACT)
    t, current, speed = run.time.values, run.data.motor_current.values[:, 0], run.data.motor_speed.values[:, 0]
    motor, command = train.motor, run.data.motor_command.values[:, 0]
    slope = (command - motor.resistance * current - motor.emf_constant * speed) / motor.inductance
    inside = (np.abs(current) < 0.79) & (np.abs(speed) < 119.0) & (run.data.motor_direction.values[:, 0] != 0)
    inside = inside & np.roll(inside, 1) & np.roll(inside, -1)
    falling = inside & (t > t[np.argmax(np.abs(speed) > 119.9)])
    assert falling.sum() > 20
    assert_allclose(np.gradient(current, t)[falling], slope[falling], atol=2e-3 * np.abs(slope).max())


@pytest.mark.slow
def test_run_up_of_a_frictionless_drive_in_closed_form():
    train = LACY.with_(screw=drives.SCREW_LACY_SPATIAL.with_(friction=0.0), motor=LACY.motor.with_(max_speed=None))
    motor, per_metre, U, push = train.motor, train.gear.ratio / train.screw.lead, 10.0, 60.0
    run = dynamics.simulate(line(train, push), 0.4, samples=41, tasks={"M": StepInput(voltage=U)}, method=EXACT)
    inertia = (motor.inertia + train.gear.inertia) * per_metre + MASS / per_metre
    tau = inertia * motor.resistance / (motor.torque_constant * motor.emf_constant * per_metre)
    speed = (U - push / per_metre * motor.resistance / motor.torque_constant) / (motor.emf_constant * per_metre)
    t = run.motion.time.values
    assert_allclose(run.motion.length.sel(member="M"), 1 + speed * (t - tau * (1 - np.exp(-t / tau))), rtol=0, atol=1e-11)


@pytest.mark.slow
def test_torque_of_the_motor_is_an_input():
    current = 0.012 / LACY.motor.torque_constant
    for task, same in (
        (GivenForce(torque=0.012), StepInput(current=current)),
        (GivenForce(times=(0.0, 0.3), torques=(0.0, 0.012)), TableInput(times=(0.0, 0.3), currents=(0.0, current))),
    ):
        first, second = (dynamics.simulate(line(LACY, 50.0), 0.5, samples=6, tasks={"M": one}) for one in (task, same))
        assert_allclose(first.data.motor_torque, second.data.motor_torque, rtol=1e-14)
        assert_allclose(first.motion.length, second.motion.length, rtol=1e-14)
        assert first.motion.length.values[-1, 0] > 1.0001


@pytest.mark.slow
def test_a_self_locking_screw_holds_its_load_without_voltage():
    run = dynamics.simulate(line(LACY, 400.0), 1.0, samples=5, tasks={"M": StepInput(voltage=0.0)})
    assert_allclose(run.motion.length, 1.0, rtol=0, atol=1e-15)
    assert_allclose(run.forces.drive_force, 400.0)
    assert not run.data.motor_direction.values.any()


@pytest.mark.slow
def test_a_start_that_moves():
    run = dynamics.simulate(
        line(LACY, 50.0), 0.5, samples=6, velocities={"B": (0.01, 0.0)}, tasks={"M": StepInput(voltage=2.0)}, method=EXACT
    )
    alone = actuators.simulate_drive(
        LACY, StepInput(voltage=2.0), load=DriveLoad(thrust=50.0, mass=MASS), duration=0.5, samples=6, rate=0.01, rtol=1e-11
    )
    assert_allclose(run.motion.length.sel(member="M"), alone.length, rtol=0, atol=1e-11)
    assert np.abs(run.data.motor_energy_balance).max() < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("again", [False, True])
@pytest.mark.parametrize("rest", [1, 3])
def test_the_last_step_may_begin_before_the_last_block(rest, again):
    """The last samples of a run lie in its last step, and those of two blocks with them; again: each by a stepper anew."""
    tasks, end = {"M7": StepInput(voltage=2.0)}, 0.05
    times = np.concatenate([np.linspace(0.0, 0.9 * end, 8), end - 1e-6 * np.arange(3 + rest)[::-1]])

    def fresh():
        return stepper_for(problem_of(bay(), end, Options(tasks=tasks)), end)

    whole, one, parts = fresh().advance(times), fresh(), []
    for part in (times[:4], times[4:-rest], times[-rest:]):
        if again and parts:
            kept, one = {name: np.array(values) for name, values in one.arrays().items()}, fresh()
            one.restore(kept)
        parts.append(one.advance(part))
    for name in ("x", "v", "a", "N", "extra", "diagnostics"):
        joined = np.concatenate([getattr(part, name) for part in parts])
        assert np.array_equal(joined, getattr(whole, name)), name


@pytest.mark.slow
def test_a_prepared_run_starts_anew_each_time():
    ready = dynamics.prepare(line(LACY, 50.0), 0.3, tasks={"M": StepInput(voltage=8.0, end=0.1)})
    first, second, short = ready.run(0.3, samples=4), ready.run(0.3, samples=4), ready.run(0.2, samples=3)
    assert np.array_equal(first.position, second.position)
    assert_allclose(short.position[-1], first.position[2], atol=1e-12)


@pytest.mark.slow
def test_a_screw_too_heavy_for_its_rotor_stops_at_once():
    shaft = drive_model_of(LACY, "voltage").shaft
    heavy = 2 * shaft.inertia * shaft.speed / shaft.down
    run = dynamics.simulate(line(LACY, mass=heavy), 0.8, samples=81, tasks={"M": StepInput(voltage=12.0, end=0.5)})
    rate, t = run.motion.length_rate.sel(member="M").values, run.motion.time.values
    assert rate[t < 0.499].max() > 0.01
    assert not rate[t > 0.501].any()
    assert "jammed at t = 0.5 s" in run.message
    assert np.abs(run.data.motor_energy_balance).max() < 1e-9
    assert_allclose(run.data.actuator_work.values[:, 0], run.data.kinetic_energy, atol=1e-9)


@pytest.mark.slow
def test_events_record_and_stop():
    events = {"far": Event(length="M", value=1.005), "near": Event(coordinate="B.x", value=1.002, stop=False)}
    run = dynamics.simulate(line(LACY, 50.0), 1.0, samples=11, tasks={"M": StepInput(voltage=12.0)}, events=events)
    assert run.status is Status.EVENT
    assert [one.name for one in run.events] == ["near", "far"]
    assert_allclose(run.motion.length.values[-1, 0], 1.005, rtol=1e-12)
    assert_allclose(run.motion.time.values[-1], run.events[-1].time)


def test_other_coordinates_are_watched_beside_motors_and_angles_refused():
    plain, same = (Event(**one, value=1.005) for one in ({"length": "M"}, {"coordinate": kt.LengthDrive("M")}))
    options = {"samples": 11, "tasks": {"M": StepInput(voltage=12.0)}}
    one, two = (dynamics.simulate(line(LACY, 50.0), 1.0, events={"far": event}, **options) for event in (plain, same))
    assert_allclose(one.events[0].time, two.events[0].time, rtol=1e-9)
    angle = Event(coordinate=kt.AngleDrive("M"), value=0.1)
    with pytest.raises(InputError, match=r"events\.far: angles are not watched beside motors"):
        dynamics.simulate(line(LACY, 50.0), 1.0, events={"far": angle}, **options)


@pytest.mark.slow
def test_beyond_the_largest_speed_is_told():
    weak = STEEP.with_(motor=STEEP.motor.with_(max_speed=20.0, max_current=0.5))
    run = dynamics.simulate(line(weak, 600.0), 0.1, samples=11, tasks={"M": StepInput(voltage=0.0)})
    assert "beyond its largest speed (20 rad/s)" in run.message


@pytest.mark.slow
def test_redundant_members_elsewhere_change_nothing():
    twin = bay().with_(bars=dict(bay().bars) | {"twin": bay().bars["M2"].with_(mass=0.0)})
    first, second = (
        dynamics.simulate(one, 0.1, samples=6, tasks={"M7": StepInput(voltage=8.0)}, load_case=None) for one in (bay(), twin)
    )
    assert "twin" in second.message
    assert_allclose(first.motion.length.sel(member="M7"), second.motion.length.sel(member="M7"), atol=1e-10)


@pytest.mark.slow
def test_slipping_screws_agree_with_the_drive_alone_and_with_their_own_equations():
    model = drive_model_of(LOSSY, "voltage")
    shaft, rng = model.shaft, np.random.default_rng(7)
    for _ in range(200):
        s = rng.choice([-1, 1], 3)
        torque, thrust = rng.normal(0, 0.05, 3), rng.normal(0, 300.0, 3)
        root = rng.normal(0, 2.0, (3, 3))
        mass = root @ root.T + np.eye(3)
        w, jammed = slipping([model] * 3, s.tolist(), torque, thrust, mass)
        assert not jammed
        pushed = thrust + mass @ w
        for j in range(3):
            against = s[j] * pushed[j]
            left = s[j] * torque[j] - shaft.friction - shaft.resistance(against)
            assert_allclose(left, shaft.inertia * shaft.speed * s[j] * w[j], atol=1e-12)
        one, _ = slipping([model] * 3, [0, int(s[1]), 0], torque, thrust, mass)
        assert_allclose(one[1], shaft.acceleration(int(s[1]), torque[1], thrust[1], mass[1, 1]), rtol=1e-12)
        assert one[0] == one[2] == 0


@pytest.mark.slow
def test_what_cannot_be_simulated_is_refused():
    step = {"M": StepInput(voltage=1.0)}
    with pytest.raises(InputError, match="DOP853"):
        dynamics.simulate(line(LACY), 0.1, tasks=step, method=EnergyMomentum(step=1e-3))
    twice = line(LACY)
    twice = twice.with_(bars={"beside": kt.Bar(ends=("A", "B"))})
    with pytest.raises(InputError, match="cannot move by itself"):
        dynamics.simulate(twice, 0.1, tasks=step)
    bare = line(LACY).with_(active={"M": line(LACY).active["M"].with_(motor=None)})
    with pytest.raises(ModelError, match="no motor"):
        dynamics.simulate(bare, 0.1, tasks={"M": GivenForce(torque=0.1)})
    with pytest.raises(InputError, match="torque of its motor"):
        kt.statics.equilibrium(line(LACY), tasks={"M": GivenForce(torque=0.1)})
