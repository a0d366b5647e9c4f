"""Demand of a drive train on a motion given in closed form."""

import numpy as np
import pytest
import xarray as xr

from kinetruss.actuators import evaluate, motor_demand, raising_torque, screw_torque, summarise
from kinetruss.model import Active, Gear, LeadScrew, Model, Motor, Part
from kinetruss.results import Forces, Motion

SCREW = LeadScrew(lead=2.5266e-4, mean_diameter=0.0127, friction=0.1)
GEAR = Gear(ratio=5.2, efficiency=0.8)
MOTOR = Motor(
    inertia=6.76e-6, resistance=2.0, torque_constant=0.0398, emf_constant=0.0398, friction_torque=1e-3,
    max_voltage=25.0, max_current=3.0, max_speed=4000.0, max_torque=0.1,
)  # fmt: skip
T = np.linspace(0.0, 2.0, 401)


def model_with(**changes):
    active = Active(
        ends=("A", "B"), base=Part(length=0.7, mass=3.0), tube=Part(length=0.254, mass=0.2), screw=SCREW, gear=GEAR,
        motor=MOTOR, limits=(1.0, 1.3),
    )  # fmt: skip
    return Model(nodes={"A": (0, 0), "B": (1.15, 0)}, active={"M7": active.with_(**changes)}, fixed=["A"])


def records(thrust, length, rate, acceleration, **attrs):
    """Motion and forces of the one member, without the analyses that usually make them."""
    member = {"time": T, "member": ["M7"]}
    column = {"length": length, "length_rate": rate, "length_acceleration": acceleration}
    motion = Motion(data=xr.Dataset({k: (("time", "member"), v[:, None]) for k, v in column.items()}, coords=member))
    force = xr.Dataset({"member_force": (("time", "member"), -thrust[:, None])}, coords=member, attrs=attrs)
    return motion, Forces(data=force, motion=motion, load_case="all")


def swing():
    """Length 1.15 + .1 sin(pi t): out, in, and at rest for an instant at the turning point."""
    w = np.pi
    rate = 0.1 * w * np.cos(w * T)
    return 1.15 + 0.1 * np.sin(w * T), np.where(np.abs(rate) < 1e-12, 0.0, rate), -0.1 * w**2 * np.sin(w * T)


def test_histories_of_a_swing_under_a_constant_thrust():
    length, rate, acceleration = swing()
    thrust = np.full_like(T, 80.0)
    demand = evaluate(model_with(), *records(thrust, length, rate, acceleration))
    torque = screw_torque(SCREW, thrust, rate)
    expected = motor_demand(SCREW, GEAR, MOTOR, torque, rate, acceleration)
    assert np.allclose(demand.screw_torque.values[:, 0], torque)
    for name, values in expected.items():
        assert np.allclose(demand.data[name].values[:, 0], values, atol=1e-12), name
    assert np.allclose(demand.actuator_power.values[:, 0], thrust * rate)
    assert demand.current.attrs["units"] == "A"


def test_motor_torque_by_hand_raising_at_constant_rate():
    rate = 0.02
    found = motor_demand(SCREW, GEAR, MOTOR, raising_torque(SCREW, 100.0), rate, 0.0)
    speed = 5.2 * rate / 2.5266e-4
    torque = raising_torque(SCREW, 100.0) / (5.2 * 0.8) + 1e-3
    assert float(found["motor_speed"]) == pytest.approx(speed)
    assert float(found["motor_torque"]) == pytest.approx(torque)
    assert float(found["voltage"]) == pytest.approx(2.0 * torque / 0.0398 + 0.0398 * speed)
    assert float(found["electrical_power"]) == pytest.approx(
        torque * speed + 2.0 * (torque / 0.0398) ** 2
    )  # what leaves at the shaft and what heats the winding


def test_a_lossless_drive_train_passes_all_power():
    screw, gear = SCREW.with_(friction=0.0), GEAR.with_(efficiency=1.0)
    motor = MOTOR.with_(inertia=0.0, friction_torque=0.0, resistance=0.0)
    length, rate, acceleration = swing()
    model = model_with(screw=screw, gear=gear, motor=motor)
    demand = evaluate(model, *records(60 + 50 * np.sin(7 * T), length, rate, acceleration))
    assert np.allclose(demand.electrical_power, demand.actuator_power, atol=1e-10)
    assert demand.electrical_energy.values == pytest.approx(demand.actuator_work.values)


def test_inertia_of_motor_and_gear_acts_at_the_motor_speed():
    gear = GEAR.with_(inertia=4e-6)
    found = motor_demand(SCREW, gear, MOTOR.with_(friction_torque=0.0), 0.0, 0.0, 0.5)
    assert float(found["motor_torque"]) == pytest.approx((6.76e-6 + 4e-6) * 5.2 * 0.5 / 2.5266e-4)


def test_efficiency_divides_forward_and_multiplies_backward():
    motor = MOTOR.with_(friction_torque=0.0)
    forward = motor_demand(SCREW, GEAR, motor, 0.05, 0.02, 0.0)["motor_torque"]
    backward = motor_demand(SCREW, GEAR, motor, 0.05, -0.02, 0.0)["motor_torque"]
    assert float(forward) == pytest.approx(0.05 / 5.2 / 0.8)
    assert float(backward) == pytest.approx(0.05 / 5.2 * 0.8)


def test_a_missing_gear_is_a_direct_drive():
    direct = motor_demand(SCREW, None, MOTOR, 0.05, 0.02, 0.3)
    unit = motor_demand(SCREW, Gear(ratio=1.0), MOTOR, 0.05, 0.02, 0.3)
    assert all(direct[name] == unit[name] for name in unit)


def test_holding_a_self_locking_screw_needs_no_current():
    length, rate, acceleration = swing()
    demand = evaluate(model_with(), *records(np.full_like(T, 80.0), length, rate, acceleration, at_rest=1))
    assert bool(demand.self_locking.values[0])
    assert np.all(demand.current.values == 0)
    loose = model_with(screw=SCREW.with_(friction=0.01))
    held = evaluate(loose, *records(np.full_like(T, 80.0), length, rate, acceleration, at_rest=1))
    assert np.all(held.current.values > 0)
    assert np.all(held.mechanical_power.values == 0)


def test_summary_energy_rms_and_peaks():
    length, rate, acceleration = swing()
    demand = evaluate(model_with(), *records(np.full_like(T, 80.0), length, rate, acceleration))
    torque, power = demand.motor_torque.values[:, 0], demand.electrical_power.values[:, 0]
    assert demand.rms_torque.values[0] == pytest.approx(np.sqrt(np.trapezoid(torque**2, T) / 2.0))
    assert demand.electrical_energy.values[0] == pytest.approx(np.trapezoid(power, T))
    assert demand.actuator_work.values[0] == pytest.approx(0.0, abs=1e-9)  # the swing ends where it began
    rows = {row.rule: row for row in demand.table()}
    assert set(rows) == {"voltage", "current", "speed", "torque", "stroke", "break-away"}
    speed = rows["speed"]
    assert speed.value == pytest.approx(5.2 * 0.1 * np.pi / 2.5266e-4)
    assert speed.margin == pytest.approx(4000.0 / speed.value - 1)
    assert speed.time in (0.0, 1.0, 2.0)
    assert rows["stroke"].value == pytest.approx(0.1)
    assert rows["stroke"].utilisation == pytest.approx(0.1 / 0.15)
    utilisations = [row.utilisation for row in demand.table()]
    assert utilisations == sorted(utilisations, reverse=True)


def test_what_is_missing_is_said():
    length, rate, acceleration = swing()
    given = records(np.full_like(T, 80.0), length, rate, acceleration)
    no_motor = evaluate(model_with(motor=None, limits=None), *given).table()
    assert [(row.rule, row.note, row.checked) for row in no_motor] == [("torque", "not checked: no motor", False)]
    no_screw = evaluate(model_with(screw=None, gear=None, motor=None, limits=None), *given).table()
    assert no_screw[0].note == "not checked: no screw"
    unlimited = evaluate(model_with(motor=MOTOR.with_(max_current=None)), *given).table()
    current = next(row for row in unlimited if row.rule == "current")
    assert current.value > 0
    assert (current.note, current.checked) == ("no limit given", False)


def test_summary_of_joined_stretches_is_that_of_the_whole():
    length, rate, acceleration = swing()
    model = model_with()
    whole = evaluate(model, *records(np.full_like(T, 80.0), length, rate, acceleration))
    stretches = [whole.data.isel(time=slice(0, 150)), whole.data.isel(time=slice(150, None))]
    timed = [part[[name for name in part if "time" in part[name].dims]] for part in stretches]
    joined = summarise(model, whole.with_(data=xr.concat(timed, "time")))
    xr.testing.assert_allclose(joined.data, whole.data)
