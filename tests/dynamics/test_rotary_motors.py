"""Motors on angles: closed forms of a disc, the drive train alone, energy, loops, robots, what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.integrate
from numpy.testing import assert_allclose

import kinetruss as kt
from kinetruss import actuators, dynamics
from kinetruss.errors import InputError, ModelError
from kinetruss.mechanics import compile
from kinetruss.model import (
    DOP853,
    Amplifier,
    AngleDrive,
    Bar,
    DriveLoad,
    DriveTrain,
    EnergyMomentum,
    ExponentialInput,
    Gear,
    GivenForce,
    HingeDrive,
    Model,
    Motor,
    Node,
    PositionLoop,
    Run,
    SineInput,
    StepInput,
    TableInput,
)

EXACT = DOP853(rtol=1e-11, atol=1e-12)
IDEAL = Gear(ratio=12.0, inertia=3e-6)
GEAR = Gear(ratio=12.0, efficiency=0.85, inertia=3e-6)
MOTOR = Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06)
RUBBING = MOTOR.with_(friction_torque=0.004)
WORM = Gear(ratio=40.0, efficiency=0.4, back_efficiency=-0.1, inertia=1e-5)
MASS, ARM, G = 1.7, 0.4, 9.81
J = MASS * ARM**2


def planar(**train):
    """A mass on a crank of the plane, driven at its angle to x."""
    return Model(
        nodes={"O": (0, 0), "A": Node(at=(ARM, 0), mass=MASS)}, fixed=["O"], bars={"crank": Bar(ends=("O", "A"), mass=0)},
        drives={"turn": AngleDrive("crank", **train)},
    )  # fmt: skip


def between(**train):
    """The same, driven at the angle between the crank and a fixed node."""
    drive = HingeDrive(axis="O", start="F", end="A", **train)
    return planar().with_(nodes={**planar().nodes, "F": (1.0, 0)}, fixed=["O", "F"], drives={"turn": drive})


def spatial(**train):
    """The same about a slanted axis in space, held by two bars."""
    e = np.array([1.0, 2.0, 2.0]) / 3
    r = ARM * np.cross(e, [0.0, 0.0, 1.0]) / np.linalg.norm(np.cross(e, [0.0, 0.0, 1.0]))
    return Model(
        nodes={"O": (0, 0, 0), "E": tuple(e), "F": tuple(2 * r), "A": Node(at=tuple(r), mass=MASS)}, fixed=["O", "E", "F"],
        bars={"near": Bar(ends=("O", "A"), mass=0), "far": Bar(ends=("E", "A"), mass=0)},
        drives={"turn": HingeDrive(axis=("O", "E"), start="F", end="A", **train)},
    )  # fmt: skip


def about_axis(**train):
    """The same about z, by the angle of a bar."""
    return Model(
        nodes={"O": (0, 0, 0), "E": (0, 0, 1), "A": Node(at=(ARM, 0, 0), mass=MASS)}, fixed=["O", "E"],
        bars={"near": Bar(ends=("O", "A"), mass=0), "far": Bar(ends=("E", "A"), mass=0)},
        drives={"turn": AngleDrive("near", axis="z", **train)},
    )  # fmt: skip


MODELS = {"angle of a bar": planar, "hinge in the plane": between, "hinge in space": spatial, "axis in space": about_axis}


def hanging(gear=GEAR, motor=RUBBING, **more):
    """The crank in the vertical plane."""
    return planar(gear=gear, motor=motor, **more).with_(gravity=(0.0, -G))


def driven(model, duration, task, *, samples=26, method=EXACT, **more):
    return dynamics.simulate(model, duration, samples=samples, tasks={"turn": task}, method=method, **more)


@pytest.mark.slow
@pytest.mark.parametrize("name", MODELS)
def test_run_up_of_a_disc_in_closed_form(name):
    run = driven(MODELS[name](gear=IDEAL, motor=MOTOR), 0.6, StepInput(voltage=12.0))
    n, R, K = IDEAL.ratio, MOTOR.resistance, MOTOR.torque_constant
    inertia = J + (MOTOR.inertia + IDEAL.inertia) * n**2
    tau, last = R * inertia / (K * K * n**2), 12.0 / (K * n)
    t = run.motion.time.values
    angle, rate, second = (
        last * (t - tau * (1 - np.exp(-t / tau))),
        last * (1 - np.exp(-t / tau)),
        last / tau * np.exp(-t / tau),
    )
    assert_allclose(run.motion.drive_position.values[:, 0], angle, rtol=0, atol=1e-8)
    assert_allclose(run.motion.drive_velocity.values[:, 0], rate, rtol=0, atol=1e-8)
    assert_allclose(run.data.motor_angle.values[:, 0], n * angle, rtol=0, atol=1e-7)
    assert_allclose(run.data.motor_speed.values[:, 0], n * rate, rtol=0, atol=1e-7)
    # balance of torques: that of the motor less its rotor turns the mass
    assert_allclose(run.forces.drive_force.values[:, 0], J * second, rtol=0, atol=1e-8)
    assert_allclose(run.data.motor_torque.values[:, 0], inertia / n * second, rtol=0, atol=1e-9)
    assert_allclose(np.linalg.norm(run.motion.position.sel(node="A"), axis=1), ARM, atol=1e-13)


@pytest.mark.slow
def test_several_turns_are_counted_whatever_is_told():
    fast = driven(planar(gear=Gear(ratio=1.0), motor=MOTOR), 20.0, StepInput(voltage=12.0), samples=3, method=None)
    K = MOTOR.torque_constant
    tau, last = MOTOR.resistance * (J + MOTOR.inertia) / K**2, 12.0 / K
    t = fast.motion.time.values
    angle = last * (t - tau * (1 - np.exp(-t / tau)))
    assert angle[-1] > 6 * 2 * np.pi
    assert_allclose(fast.motion.drive_position.values[:, 0], angle, rtol=1e-7)
    assert_allclose(fast.data.motor_angle.values[:, 0], angle, rtol=1e-7)
    for make in (planar, spatial):
        # from rest to rest: the rates at the two samples tell nothing of the turns
        run = driven(make(gear=IDEAL, motor=MOTOR), 1.0, PositionLoop(target=40.0, settling_time=0.1), samples=2)
        assert_allclose(run.motion.drive_position.values[:, 0], [0.0, 40.0], rtol=0, atol=1e-6)


AMPLIFIER = Amplifier(voltage_gain=2.0, max_voltage=9.0)
ALONE = {
    "voltage step": (GEAR, RUBBING, None, StepInput(voltage=12.0, start=0.1, end=0.5), 0.8),
    "current": (GEAR, RUBBING, None, StepInput(current=1.5), 0.5),
    "torque": (GEAR, RUBBING, None, SineInput(torque=0.2, period=0.5), 0.8),
    "table of torques": (GEAR, RUBBING, AMPLIFIER, TableInput(times=(0.0, 0.3, 0.8), torques=(0.2, -0.2, 0.1)), 0.8),
    "exponential torque": (GEAR, RUBBING, None, ExponentialInput(torque=(0.2, 0.0), time_constant=0.1), 0.5),
    "reversals, with a winding": (GEAR, RUBBING.with_(inductance=2e-3), None, SineInput(voltage=20.0, period=0.25), 0.5),
    "no gear": (Gear(ratio=1.0), MOTOR.with_(max_current=8.0), None, StepInput(voltage=24.0), 0.5),
    "worm": (WORM, RUBBING, None, SineInput(voltage=15.0, period=0.6), 0.8),
    "voltage saturates": (GEAR, RUBBING, AMPLIFIER, SineInput(voltage=8.0, period=0.4, phase=0.3), 0.8),
    "position loop": (GEAR, RUBBING, None, PositionLoop(target="25 deg", settling_time=0.3), 0.6),
    "loop along a table": (
        GEAR, RUBBING, AMPLIFIER, PositionLoop(times=(0.0, 0.3), targets=(0.0, "400 deg"), settling_time=0.1), 1.0,
    ),
    "held at its largest speed": (GEAR, RUBBING.with_(max_speed=60.0), None, SineInput(voltage=15.0, period=0.5), 0.6),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", ALONE)
def test_one_motor_turns_as_its_drive_train_alone(name):
    gear, motor, amplifier, history, duration = ALONE[name]
    model = between(gear=gear, motor=motor, amplifier=amplifier)
    run = driven(model, duration, history, samples=51)
    train = actuators.train_of(model, "turn")
    assert train.screw is None
    alone = actuators.simulate_drive(train, history, load=DriveLoad(inertia=J), duration=duration, samples=51, rtol=1e-11)
    way = np.ptp(alone.angle.values)
    assert way > 1e-2  # it does move
    assert_allclose(run.motion.drive_position.values[:, 0], alone.angle, rtol=0, atol=2e-8 * way)
    most = np.abs(alone.drive_torque.values).max()
    assert_allclose(run.forces.drive_force.values[:, 0], alone.drive_torque, rtol=0, atol=1e-7 * most)
    for ours, theirs in (
        ("motor_current", "current"), ("motor_voltage", "voltage"), ("motor_torque", "motor_torque"),
        ("motor_speed", "motor_speed"),
    ):  # fmt: skip
        values = alone.data[theirs].values
        assert_allclose(run.data[ours].values[:, 0], values, rtol=0, atol=1e-7 * np.abs(values).max())
    assert_allclose(run.data.motor_direction.values[:, 0], alone.direction)
    assert_allclose(run.data.gear_loss.values[:, 0], alone.gear_loss, rtol=0, atol=1e-8)
    assert np.isnan(run.data.screw_torque).all()
    assert not run.data.screw_loss.values.any()
    for told in (run.data.motor_energy_balance, alone.energy_balance):
        assert np.abs(told).max() < 1e-8 * np.abs(alone.electrical_energy).max() + 1e-10


def test_a_load_over_the_angle_and_limits_of_a_train_alone():
    train = DriveTrain(gear=IDEAL, motor=MOTOR)
    spring = DriveLoad(angles=(-10.0, 10.0), torques=(-20.0, 20.0), inertia=J)
    run = actuators.simulate_drive(train, StepInput(torque=0.1), load=spring, duration=0.4, samples=41)
    w = np.sqrt(2.0 / (J + (MOTOR.inertia + IDEAL.inertia) * 144))
    assert_allclose(run.angle, 0.1 * 12 / 2.0 * (1 - np.cos(w * run.time)), rtol=0, atol=1e-8)
    history = run.trajectory("turn")
    assert history.values["turn"][-1] == pytest.approx(float(run.angle[-1]))
    ended = actuators.simulate_drive(train, StepInput(voltage=12.0), duration=1.0, limits=(-1.0, 0.5))
    assert ended.status is kt.results.Status.END_OF_STROKE
    assert "angle 28.6479 deg" in ended.message
    for wrong, words in (
        ({"length": 1.0}, "Give angle"), ({"load": DriveLoad(thrust=1.0)}, "Give its load as torque"),
        ({"load": DriveLoad(inertia=1e9)}, "jams the self-locking gear"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=words):
            actuators.simulate_drive(train.with_(gear=WORM), StepInput(voltage=1.0), duration=0.1, **wrong)
    with pytest.raises(InputError, match="Give length"):
        actuators.simulate_drive(kt.library.drives.TRAIN_LACY, StepInput(voltage=1.0), angle=0.0, duration=0.1)
    with pytest.raises(ModelError, match="Give one kind"):
        DriveLoad(thrust=1.0, inertia=1.0)
    with pytest.raises(ModelError, match="Give torque; or torques with times; or torques with angles"):
        DriveLoad(torque=1.0, torques=(1.0, 2.0), times=(0.0, 1.0))


@pytest.mark.slow
def test_a_geared_pendulum_against_its_own_equation():
    """(J + J_r n^2) q'' = n K i - m g l cos q, R i = U - K n q', integrated by other means."""
    n, K, R, U = IDEAL.ratio, MOTOR.torque_constant, MOTOR.resistance, 16.0
    inertia = J + (MOTOR.inertia + IDEAL.inertia) * n**2

    def right(_, y):
        return [y[1], (n * K * (U - K * n * y[1]) / R - MASS * G * ARM * np.cos(y[0])) / inertia]

    run = driven(hanging(IDEAL, MOTOR), 2.0, StepInput(voltage=U), samples=81)
    t = run.motion.time.values
    exact = scipy.integrate.solve_ivp(right, (0, 2.0), [0.0, 0.0], "DOP853", t, rtol=1e-12, atol=1e-13).y
    assert np.ptp(exact[0]) > 2 * np.pi
    assert_allclose(run.motion.drive_position.values[:, 0], exact[0], rtol=0, atol=1e-8)
    assert_allclose(run.data.motor_current.values[:, 0], (U - K * n * exact[1]) / R, rtol=0, atol=1e-7)


@pytest.mark.slow
def test_electrical_power_goes_to_copper_friction_gear_and_the_mass():
    run = driven(hanging(motor=RUBBING.with_(inductance=1e-3)), 2.0, SineInput(voltage=14.0, period=0.9), samples=401)
    data = run.data.sel(motor="turn")
    taken = float(data.electrical_energy.max())
    assert np.abs(data.motor_energy_balance).max() < 1e-8 * taken
    for loss in ("copper_energy", "motor_loss", "gear_loss"):
        assert (np.diff(data[loss]) >= -1e-12).all()
        assert float(data[loss][-1]) > 0.002 * taken
    # what the torque works is what the crank gains
    energy = run.data.energy.values
    assert_allclose(energy - energy[0], data.actuator_work, rtol=0, atol=1e-8 * np.ptp(energy))
    # energies are integrals of what is told at the samples, to the error of the trapezoidal rule
    power, copper = data.motor_voltage * data.motor_current, 1.3 * data.motor_current**2
    assert_allclose(np.trapezoid(power, run.data.time), float(data.electrical_energy[-1]), rtol=2e-3)
    assert_allclose(np.trapezoid(copper, run.data.time), float(data.copper_energy[-1]), rtol=2e-3)


@pytest.mark.slow
def test_a_loop_brings_a_hinge_to_an_angle_by_the_poles_asked_for():
    """Without friction the loop is w^2/(s^2 + 2 zeta w s + w^2) of the angle."""
    target, loop = 1.2, PositionLoop(target=1.2, settling_time=0.4)
    run = driven(spatial(gear=IDEAL, motor=MOTOR), 0.8, loop, samples=41)
    w, zeta = loop.natural_frequency, loop.damping
    wd, t = w * np.sqrt(1 - zeta**2), run.motion.time.values
    exact = target * (1 - np.exp(-zeta * w * t) * (np.cos(wd * t) + zeta * w / wd * np.sin(wd * t)))
    assert_allclose(run.motion.drive_position.values[:, 0], exact, rtol=0, atol=1e-8)


@pytest.mark.slow
def test_a_worm_holds_its_load_and_another_gear_runs_back():
    held = driven(hanging(WORM), 0.5, StepInput(voltage=0.0), samples=6)
    assert_allclose(held.motion.drive_position, 0.0, atol=1e-15)
    assert_allclose(held.forces.drive_force, MASS * G * ARM)
    assert not held.data.motor_direction.values.any()
    loose = driven(hanging(GEAR), 0.5, StepInput(voltage=0.0), samples=6)
    assert float(loose.motion.drive_position[-1, 0]) < -0.1
    # the shorted motor brakes: at most R (m g l)/(K n)^2
    assert np.abs(loose.motion.drive_velocity).max() < MASS * G * ARM * 1.3 / (0.06 * 12) ** 2
    # a gear's losses hold what they exceed: at rest between the thresholds of both directions
    lossy = driven(hanging(GEAR), 0.2, StepInput(torque=MASS * G * ARM / 12), samples=3)
    assert not lossy.data.motor_direction.values.any()


@pytest.mark.slow
def test_a_worm_too_weak_for_what_drives_it_jams():
    heavy = 2 * (RUBBING.inertia + WORM.inertia) * WORM.ratio**2 / 0.1
    model = planar(gear=WORM, motor=RUBBING)
    model = model.with_(nodes={**model.nodes, "A": Node(at=(ARM, 0), mass=heavy / ARM**2)})
    run = driven(model, 0.8, StepInput(voltage=12.0, end=0.4), samples=41)
    rate, t = run.motion.drive_velocity.values[:, 0], run.motion.time.values
    assert rate[t < 0.399].max() > 0.1
    assert np.abs(rate[t > 0.401]).max() < 1e-15
    assert "The gear of turn jammed at t = 0.4 s" in run.message
    assert np.abs(run.data.motor_energy_balance).max() < 1e-9
    # where the voltage falls by and by, it jams as soon as the mass would have to push the gear on, at its largest speed,
    # and the motor starts it anew
    slowly = driven(model, 0.6, SineInput(voltage=12.0, period=0.8), samples=301)
    rate, t = slowly.motion.drive_velocity.values[:, 0], slowly.motion.time.values
    when = float(slowly.message.split("jammed at t = ")[1].split(" s")[0])
    before, behind = np.flatnonzero(t < when), np.flatnonzero(t > when)
    assert rate[before[-1]] == rate.max()
    assert 0 <= rate[behind[0]] < 0.02 * rate.max()
    assert (np.diff(rate[behind[:5]]) > 0).all()
    assert np.abs(slowly.forces.drive_force.values[before[-1], 0]) < 0.02 * np.abs(slowly.forces.drive_force).max()
    assert np.abs(slowly.data.motor_energy_balance).max() < 1e-9


@pytest.mark.slow
def test_a_joint_takes_a_motor_at_its_hinge():
    corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    box = Model(nodes=corners, bodies={"box": kt.Body(nodes=tuple(corners), mass=2.0)}, gravity=(0, 0, -G))
    hung = kt.library.joints.revolute(box, "hinge", bodies=("ground", "box"), at=(0, 0, 0), axis="y")
    model = kt.library.joints.drive(hung, "hinge", "turn", gear=GEAR.with_(ratio=100.0), motor=RUBBING)
    start = float(compile(model).drive_start[0])
    loop = PositionLoop(times=(0.0, 0.3), targets=(start, start + 0.5), settling_time=0.1)
    run = driven(model, 0.5, loop, samples=11, method=None)
    assert float(run.motion.drive_position[-1, 0]) == pytest.approx(start + 0.5, abs=0.01)
    turned = kt.kinematics.joint(model, run.motion, "hinge").angle.values[:, 0]
    assert_allclose(np.abs(turned - turned[0]), np.abs(run.motion.drive_position.values[:, 0] - start), atol=1e-9)
    slide = kt.library.joints.prismatic(box, "slide", bodies=("ground", "box"), at=(0, 0, 0), axis="z")
    with pytest.raises(InputError, match="takes no motor: a length is driven through a screw"):
        kt.library.joints.drive(slide, "slide", "push", motor=RUBBING)


def test_a_torque_on_the_angle_is_behind_the_gear():
    torque, geared, bare = 0.5, planar(gear=GEAR, motor=RUBBING), planar()
    first, second = (driven(one, 0.3, GivenForce(torque=torque), samples=4) for one in (geared, bare))
    assert_allclose(first.motion.drive_position, second.motion.drive_position, rtol=0, atol=1e-14)
    assert_allclose(first.motion.drive_position.values[-1, 0], 0.5 * torque / J * 0.09, rtol=1e-9)


@pytest.mark.slow
def test_a_model_file_and_a_run_keep_motors_of_angles(tmp_path):
    tasks = {"turn": {"kind": "position_loop", "target": "400 deg", "settling_time": "0.2 s"}}
    model = hanging().with_(runs={"go": Run(analysis="dynamics.simulate", t_end=0.3, samples=7, tasks=tasks)})
    for kind in ("yaml", "json"):
        read = kt.read(kt.write(model, tmp_path / f"m.{kind}"))
        assert read == model
        assert read.runs["go"].tasks["turn"].target == pytest.approx(np.radians(400.0))
        assert read.runs["go"].tasks["turn"].target.quantity == "angle"
    run = kt.run(model, "go", tmp_path / "run")
    stored = kt.runs.load(tmp_path / "run")
    assert_allclose(stored.simulation.data.motor_angle, run.simulation.data.motor_angle, rtol=1e-15)
    assert_allclose(
        stored.motion.drive_position.values[-1, 0] * 12, stored.simulation.data.motor_angle.values[-1, 0], rtol=1e-9
    )


def _refused(model, task, words, error=ModelError, **more):
    with pytest.raises(error, match=words):
        dynamics.simulate(model, 0.1, tasks={"turn": task}, **more)


@pytest.mark.slow
def test_what_cannot_be_simulated_is_refused():
    whole = planar(gear=GEAR, motor=MOTOR)
    _refused(planar(), StepInput(voltage=1.0), "feeds a motor, but 'turn' has none. Give the drive a motor")
    _refused(planar(gear=GEAR), StepInput(voltage=1.0), "Give the drive a motor")
    _refused(whole, StepInput(voltage=1.0), "DOP853", InputError, method=EnergyMomentum(step=1e-3))
    _refused(whole, PositionLoop(target="1.2 m", settling_time=0.1), "target.*is given as a length, but 'turn' drives an angle")
    loop = PositionLoop(times=(0.0, 1.0), targets=(0.0, "1 m"), settling_time=0.1)
    _refused(whole, loop, "targets.*is given as a length.*30 deg")
    _refused(
        whole,
        GivenForce(1.0),
        r"has a force, but 'turn' drives an angle. Give torque \(N m\) instead of force, e.g. torque: 1.5",
    )
    table = GivenForce(times=(0.0, 1.0), forces=(0.0, 1.0))
    _refused(whole, table, r"has forces, but 'turn' drives an angle. Give torques \(N m\) instead of forces, e.g. torques:")
    amplified = planar(gear=GEAR, motor=MOTOR, amplifier=AMPLIFIER)
    _refused(amplified, StepInput(current=1.0), "Give voltage instead of current", InputError)
    with pytest.raises(ModelError, match="either a voltage .* a torque of the motor"):
        StepInput(torque=1.0, voltage=2.0)
    with pytest.raises(InputError, match="StepInput, which has no meaning at rest"):
        kt.statics.equilibrium(whole, tasks={"turn": StepInput(voltage=1.0)})


def test_an_angle_that_rigid_bars_hold_is_refused():
    nodes = {**planar().nodes, "P": (0.0, 1.0)}
    bars = {**planar().bars, "stay": Bar(ends=("P", "A"))}
    _refused(
        planar(gear=GEAR, motor=MOTOR).with_(nodes=nodes, fixed=["O", "P"], bars=bars), StepInput(voltage=1.0),
        "hold its angle", InputError,
    )  # fmt: skip
