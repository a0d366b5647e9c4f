"""Gears and motors on drives of angles: closed forms of a geared crank, power of a robot along a path, what is refused."""

import json

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.actuators import evaluate, exceeded, moves, power_flow, train_of
from kinetruss.library import mechanisms
from kinetruss.report import document_page, summary
from samples import tripod

GEAR = kt.Gear(ratio=12.0, efficiency=0.85, inertia=3e-6)
MOTOR = kt.Motor(
    inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06, friction_torque=0.004, inductance=8e-4,
    max_voltage=30.0, max_current=4.0, max_speed=500.0, rated_current=1.5,
)  # fmt: skip
MASS, ARM, G = 1.7, 0.4, 9.81
PATH = kt.Quintic(moves={"turn": (0.2, 2.6)}, duration=1.5)


def crank(**train):
    """A point mass on a crank that turns in the vertical plane."""
    at = (ARM * np.cos(0.2), ARM * np.sin(0.2))
    return kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=at, mass=MASS)}, fixed=["O"], gravity=(0, -G),
        bars={"crank": kt.Bar(ends=("O", "A"), mass=0)}, drives={"turn": kt.AngleDrive("crank", **train)},
    )  # fmt: skip


def demanded(model, path=PATH, samples=301):
    motion = kt.kinematics.follow(model, path, samples=samples)
    return motion, evaluate(model, motion, kt.dynamics.inverse(model, motion))


def quintic(s):
    """Share of the way, and its first and second derivative by the share of time."""
    return 10 * s**3 - 15 * s**4 + 6 * s**5, 30 * s**2 * (1 - s) ** 2, 60 * s - 180 * s**2 + 120 * s**3


def by_hand(t):
    """Angle, rate, torque on the crank, motor torque, from minimal coordinates."""
    shares = quintic(t / 1.5)
    q, rate, second = 0.2 + 2.4 * shares[0], 2.4 * shares[1] / 1.5, 2.4 * shares[2] / 1.5**2
    torque = MASS * ARM**2 * second + MASS * G * ARM * np.cos(q)
    loss = np.where(torque * rate > 0, 1 / 0.85, np.where(torque * rate < 0, 0.85, 1.0))
    return rate, torque, torque * loss / 12.0 + (2e-5 + 3e-6) * 12.0 * second + 0.004 * np.sign(rate)


@pytest.mark.parametrize("named", [True, False])
def test_a_geared_crank_asks_what_is_computed_by_hand(named):
    model = crank(gear=GEAR, motor=MOTOR.with_(inductance=0.0))
    if named:
        drive = kt.AngleDrive("crank", gear="g", motor="m")
        model = model.with_(gears={"g": GEAR}, motors={"m": MOTOR.with_(inductance=0.0)}, drives={"turn": drive})
    motion, found = demanded(model)
    rate, torque, at_motor = by_hand(motion.data["time"].values)
    near = {"atol": 1e-11, "rtol": 1e-10}
    np.testing.assert_allclose(found.drive_torque.values[:, 0], torque, **near)
    np.testing.assert_allclose(found.angle_rate.values[:, 0], rate, **near)
    # at the ends of the move the sign of a rate that is nothing decides, so the instants between
    inner = slice(1, -1)
    np.testing.assert_allclose(found.motor_torque.values[inner, 0], at_motor[inner], **near)
    np.testing.assert_allclose(found.current.values[inner, 0], at_motor[inner] / 0.06, **near)
    volts = 1.3 * at_motor / 0.06 + 0.06 * 12.0 * rate
    np.testing.assert_allclose(found.voltage.values[inner, 0], volts[inner], **near)
    np.testing.assert_allclose(found.electrical_power.values[inner, 0], (volts * at_motor / 0.06)[inner], **near)
    np.testing.assert_allclose(found.mechanical_power.values[inner, 0], (at_motor * 12.0 * rate)[inner], **near)
    np.testing.assert_allclose(found.actuator_power.values[:, 0], torque * rate, **near)
    assert found.drive_torque.attrs["units"] == "N m"
    for absent in ("thrust", "length_rate", "screw_torque", "stroke"):
        assert np.isnan(found.data[absent].values).all()


def test_the_rate_of_the_current_converges_to_the_third_order():
    errors = []
    for samples in (76, 151):
        motion, found = demanded(crank(gear=GEAR, motor=MOTOR), samples=samples)
        t = motion.data["time"].values
        # the torque changes its sign, and with it the side of the gear's loss: the smooth part before that
        part = (t > 0.1) & (t < 0.5)
        h = 1e-5
        change = (by_hand(t + h)[2] - by_hand(t - h)[2]) / (2 * h) / 0.06
        rate, _, at_motor = by_hand(t)
        exact = 1.3 * at_motor / 0.06 + 0.06 * 12 * rate + 8e-4 * change
        errors.append(np.abs(found.voltage.values[part, 0] - exact[part]).max())
    assert errors[1] < errors[0] / 6
    assert errors[1] < 1e-6


def test_electrical_power_goes_to_losses_stores_and_the_crank():
    model = crank(gear=GEAR, motor=MOTOR)
    motion, found = demanded(model)
    flow = power_flow(model, motion, found)
    largest = float(np.abs(flow.electrical).max())
    assert np.abs(flow.balance).max() < 1e-13 * largest
    for loss in ("copper", "motor", "gear"):
        assert (flow[loss] >= -1e-15 * largest).all()
    assert np.abs(flow.screw).max() == 0
    # to the error of the trapezoidal rule, which over the whole motion cancels itself: what is stored comes and goes alike;
    # the spike of friction's jump in an inductance is not counted
    still = crank(gear=GEAR, motor=MOTOR.with_(inductance=0.0))
    errors = []
    for count in (301, 601):
        part = kt.kinematics.follow(still, PATH, times=np.linspace(0.0, 1.1, count))
        one = evaluate(still, part, kt.dynamics.inverse(still, part))
        errors.append(abs(float(one.energy_balance[0] / one.electrical_energy[0])))
    assert errors[1] < 1e-6
    assert errors[1] < errors[0] / 3.5
    _, fine = demanded(still, samples=601)
    assert abs(float(fine.energy_balance[0])) < 1e-12
    # work of the crank from rest to rest: what its mass was lifted
    assert float(fine.actuator_work[0]) == pytest.approx(MASS * G * ARM * (np.sin(2.6) - np.sin(0.2)), rel=1e-5)
    assert float(fine.screw_loss[0]) == 0
    assert not bool(fine.self_locking[0])


def test_limits_moves_and_gear_for_the_top_speed():
    _, found = demanded(crank(gear=GEAR, motor=MOTOR.with_(max_current=1.0)))
    rows = {row.rule: row for row in found.table()}
    assert {"voltage", "current", "speed", "torque", "rms current"} <= rows.keys()
    assert "stroke" not in rows
    assert rows["current"].value == pytest.approx(float(np.abs(found.current).max()))
    assert any(one.active == "turn" and one.quantity == "current" for one in exceeded(found))
    fastest = 2.4 * 1.875 / 1.5
    assert float(found.gear_ratio[0]) == pytest.approx(500.0 / fastest, rel=1e-9)
    (one,) = moves(found)
    assert one.travel == pytest.approx(2.4, rel=1e-4)
    assert one.energy == pytest.approx(float(found.electrical_energy[0]), rel=1e-12)


def test_at_rest_the_motor_holds_without_the_losses_of_its_gear():
    model = crank(gear=GEAR, motor=MOTOR)
    motion = kt.kinematics.follow(model, PATH, samples=11)
    static = kt.dynamics.inverse(model, motion).static
    found = evaluate(model, motion, static)
    torque = MASS * G * ARM * np.cos(motion.data["drive_position"].values[:, 0])
    np.testing.assert_allclose(found.holding_torque.values[:, 0], torque / 12, atol=1e-12)
    np.testing.assert_allclose(found.motor_torque.values[:, 0], torque / 12, atol=1e-12)
    assert np.abs(found.motor_speed).max() == 0
    up = torque > 0
    np.testing.assert_allclose(found.breakaway_torque.values[up, 0], torque[up] / 12 / 0.85 + 0.004, atol=1e-12)


def test_no_gear_is_a_gear_of_one_and_a_gear_alone_is_told():
    _, direct = demanded(crank(motor=MOTOR))
    _, one = demanded(crank(motor=MOTOR, gear=kt.Gear(ratio=1.0)))
    np.testing.assert_array_equal(direct.voltage.values, one.voltage.values)
    _, alone = demanded(crank(gear=GEAR))
    assert alone.data.sizes["active"] == 1
    assert [row.note for row in alone.table()] == ["not checked: no motor"]
    _, none = demanded(crank())
    assert none.data.sizes["active"] == 0


def test_an_amplifier_gets_its_input():
    amplifier = kt.Amplifier(current_gain=1.8, max_input=0.5)
    _, found = demanded(crank(gear=GEAR, motor=MOTOR, amplifier=amplifier))
    np.testing.assert_allclose(found.amplifier_input.values, found.current.values / 1.8)
    assert {row.rule for row in found.table() if row.limit == 0.5} == {"input"}


def test_motors_of_a_robot_give_what_its_platform_gains_and_their_losses():
    plain = mechanisms.delta(at=(0.0, 0.0, -0.7))
    train = {"gear": GEAR, "motor": MOTOR.with_(inductance=0.0), "amplifier": None}
    drives = {name: drive.with_(**train) for name, drive in plain.drives.items()}
    model = plain.with_(drives=drives, gravity=(0, 0, -G))
    s = quintic(np.linspace(0, 1, 201))[0]
    values = {f"Q.{axis}": tuple(c + d * s) for axis, c, d in zip("xyz", (0, 0, -0.7), (0.15, -0.1, -0.12), strict=True)}
    motion = kt.kinematics.inverse(model, kt.Spline(times=tuple(np.linspace(0, 0.4, 201)), values=values), samples=201)
    forces = kt.dynamics.inverse(model, motion)
    found = evaluate(model, motion, forces)
    assert list(found.data["active"].values) == list(plain.drives)
    flow = power_flow(model, motion, found)
    spent = sum(flow[name].values for name in ("copper", "motor", "gear", "stored")).sum(axis=1)
    gained = forces.data["energy_rate"].values
    supplied = found.electrical_power.values.sum(axis=1)
    assert np.abs(supplied - spent - gained).max() < 1e-9 * np.abs(supplied).max()
    # torque and rate are those of the drives
    np.testing.assert_array_equal(found.drive_torque.values, forces.data["drive_force"].values)
    np.testing.assert_allclose(found.motor_speed.values, 12.0 * motion.data["drive_velocity"].values, rtol=1e-15, atol=1e-8)


def both():
    """The tripod with a geared crank on its top."""
    more = tripod()
    nodes = {**more.nodes, "P": (2.0, 0, 0), "Q": kt.Node(at=(2.0, 0.3, 0), mass=1.0), "R": (2.0, 0, 1.0)}
    bars = {"low": kt.Bar(ends=("P", "Q"), mass=0), "high": kt.Bar(ends=("R", "Q"), mass=0)}
    moved = kt.Quintic(moves={"LA": (1.0295630, 1.15), "LB": (1.0295630, 1.05), "door": (0.0, 1.0)}, duration=1.0)
    hinge = kt.HingeDrive(axis=("P", "R"), start="D", end="Q", gear=GEAR, motor=MOTOR)
    return more.with_(
        nodes={**nodes, "D": (2.0, 1.0, 0.0)}, fixed=(*more.fixed, "P", "R", "D"), bars=bars, drives={"door": hinge},
        runs={"lift": kt.Run(trajectory=moved, samples=41)},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_members_and_angles_stand_side_by_side_in_a_run():
    run = kt.run(both())
    demand = run.demand["pushed"]
    assert list(demand.data["active"].values) == ["LA", "LB", "LC", "door"]
    assert np.isnan(demand.thrust.values[:, 3]).all()
    assert np.isnan(demand.drive_torque.values[:, :3]).all()
    alone = kt.run(tripod()).demand["pushed"]
    for name in ("motor_torque", "voltage", "thrust"):
        np.testing.assert_allclose(demand.data[name].values[:, :3], alone.data[name].values, rtol=1e-9, atol=1e-9)
    # about a vertical axis nothing but inertia: 1 kg at 0.3 m
    second = run.motion.data["drive_acceleration"].values[:, -1]
    np.testing.assert_allclose(demand.drive_torque.values[:, 3], 0.09 * second, atol=1e-9)
    told = {one["active"]: one for one in summary(run).record["motors"] if one["load_case"] == "pushed"}
    assert abs(told["door"]["drive_torque"]) == pytest.approx(0.09 * np.abs(second).max())
    assert told["door"]["thrust"] is None
    assert told["LA"]["drive_torque"] is None
    record = document_page(run).record
    json.dumps(record, allow_nan=False)
    assert {row["part"] for row in record["limits"]} == {"LA", "LB", "LC", "door"}
    page = document_page(run).html
    assert "door" in page


def test_a_file_keeps_gear_and_motor_and_takes_those_of_the_library(tmp_path):
    model = both()
    for kind in ("yaml", "json"):
        assert kt.read(kt.write(model, tmp_path / f"m.{kind}")) == model
    named = crank(gear=GEAR, motor=MOTOR).model_dump(mode="json", exclude_unset=True)
    named["drives"]["turn"] |= {"kind": "angle", "gear": "gear_lacy", "motor": "motor_lacy"}
    (tmp_path / "named.json").write_text(json.dumps(named))
    read = kt.read(tmp_path / "named.json")
    assert read.motors["motor_lacy"] == kt.library.drives.MOTOR_LACY
    assert demanded(read)[1].data.sizes["active"] == 1


@pytest.mark.parametrize(
    ("train", "place", "words"),
    [
        ({"motor": "mortor"}, "drives.turn.motor", "no motor called 'mortor'"),
        ({"gear": "none", "motor": MOTOR}, "drives.turn.gear", "no gear called 'none'"),
        ({"amplifier": kt.Amplifier(voltage_gain=2.0)}, "drives.turn.amplifier", "feeds nothing"),
    ],
)
def test_faults_of_a_train_are_told_with_their_place(train, place, words):
    with pytest.raises(kt.ModelError, match=words) as caught:
        crank(**train)
    assert place in str(caught.value)


def test_what_an_angle_cannot_have():
    with pytest.raises(kt.ModelError, match="screw"):
        kt.Model(**crank().model_dump(exclude={"drives"}, exclude_unset=True),
                 drives={"turn": {"kind": "angle", "bar": "crank", "screw": "s"}})  # fmt: skip
    model = crank(gear=GEAR, motor=MOTOR)
    with pytest.raises(kt.ModelError, match="only measures"):
        model.with_(couplings={"c": kt.Coupling(terms=((kt.AngleDrive("crank", motor=MOTOR), 1.0),))})
    with pytest.raises(kt.InputError, match="Drive 'turn' has no motor"):
        train_of(crank(), "turn")
    with pytest.raises(kt.InputError, match="Drive 'turn' has no motor"):
        train_of(crank(gear=GEAR), "turn")
    assert train_of(model, "turn") == kt.DriveTrain(gear=GEAR, motor=MOTOR)


def test_a_worm_gear_drives_back_at_its_own_efficiency_and_holds_by_itself():
    # lead angle 4 deg, friction angle 6 deg
    a, r = np.radians(4.0), np.radians(6.0)
    worm = kt.Gear(ratio=40.0, efficiency=np.tan(a) / np.tan(a + r), back_efficiency=np.tan(a - r) / np.tan(a))
    model = crank(gear=worm, motor=MOTOR.with_(inductance=0.0, friction_torque=0.0))
    motion, found = demanded(model)
    torque, rate = found.drive_torque.values[1:-1, 0], found.angle_rate.values[1:-1, 0]
    second = motion.data["drive_acceleration"].values[1:-1, 0]
    share = np.where(torque * rate > 0, 1 / worm.efficiency, worm.back_efficiency)
    np.testing.assert_allclose(found.motor_torque.values[1:-1, 0], torque * share / 40 + 2e-5 * 40 * second, atol=1e-12)
    assert (torque * rate < 0).any()
    assert not found.holding_torque.values.any()
    assert bool(found.self_locking[0])
    flow = power_flow(model, motion, found)
    assert (flow["gear"].values[1:-1] > 0).all()
    with pytest.raises(kt.ModelError, match="back_efficiency 1.2 must be finite and at most 1"):
        worm.with_(back_efficiency=1.2)
