"""Parts of a demand beside each other: with and without friction, holding, break-away, limits in time, moves, power."""

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st

from kinetruss.actuators import (
    breakaway_torque,
    evaluate,
    exceeded,
    holding_torque,
    lowering_torque,
    merge_summaries,
    moves,
    power_flow,
    raising_torque,
    screw_torque,
    summarise,
)  # fmt: skip
from kinetruss.model import Active, Amplifier, Gear, LeadScrew, Model, Motor, Part
from kinetruss.results import Forces, Motion

SCREW = LeadScrew(lead=2.5266e-4, mean_diameter=0.0127, friction=0.1, static_friction=0.15)
GEAR = Gear(ratio=5.2, efficiency=0.8, inertia=1e-6)
MOTOR = Motor(
    inertia=6.76e-6, resistance=2.0, torque_constant=0.0398, emf_constant=0.0398, friction_torque=1e-3, inductance=2e-3,
    max_voltage=25.0, max_current=3.0, max_speed=4000.0, max_torque=0.1, rated_torque=0.01,
)  # fmt: skip
T = np.linspace(0.0, 2.0, 4001)


def model_with(**changes):
    active = Active(
        ends=("A", "B"), base=Part(length=0.7, mass=3.0), tube=Part(length=0.254, mass=0.2), screw=SCREW, gear=GEAR,
        motor=MOTOR, limits=(1.0, 1.3),
    )  # fmt: skip
    return Model(nodes={"A": (0, 0), "B": (1.15, 0)}, active={"M7": active.with_(**changes)}, fixed=["A"])


def records(thrust, times=T, amplitude=0.05, **attrs):
    """A swing of period 2 s: out, in, and out again."""
    member = {"time": times, "member": ["M7"]}
    w = np.pi
    rate = amplitude * w * np.cos(w * times)
    column = {
        "length": 1.15 + amplitude * np.sin(w * times),
        "length_rate": np.where(np.abs(rate) < 1e-12, 0.0, rate),
        "length_acceleration": -amplitude * w**2 * np.sin(w * times),
    }
    motion = Motion(data=xr.Dataset({k: (("time", "member"), v[:, None]) for k, v in column.items()}, coords=member))
    force = xr.Dataset({"member_force": (("time", "member"), -np.broadcast_to(thrust, times.shape)[:, None])}, coords=member,
                       attrs=attrs)  # fmt: skip
    return motion, Forces(data=force, motion=motion, load_case="all")


screws = st.builds(LeadScrew, lead=st.floats(1e-5, 4e-3), mean_diameter=st.floats(5e-3, 5e-2), friction=st.floats(0, 0.3))
thrusts = st.floats(-1e4, 1e4, allow_subnormal=False)


@given(screws, thrusts, st.floats(0, 0.1), st.sampled_from([-1.0, 1.0]))
def test_break_away_takes_no_less_than_running(screw, thrust, more, direction):
    sticky = screw.with_(static_friction=screw.friction + more)
    assert direction * breakaway_torque(sticky, thrust, direction) >= direction * screw_torque(screw, thrust, direction) * (
        1 - 1e-12 * np.sign(direction * thrust)
    ) - 1e-12 * abs(thrust)


@given(screws, thrusts)
def test_break_away_without_a_direction_is_against_the_load(screw, thrust):
    assert abs(breakaway_torque(screw, thrust, 0)) == pytest.approx(raising_torque(screw, abs(thrust)))


def test_holding_is_zero_where_self_locking_else_what_lowering_gives_back():
    assert np.all(holding_torque(SCREW, [100.0, -100.0]) == 0)
    loose = SCREW.with_(friction=0.01)
    assert np.allclose(holding_torque(loose, [100.0, -100.0]), np.array([1, -1]) * -lowering_torque(loose, 100.0))


def test_torques_side_by_side():
    demand = evaluate(model_with(), *records(80.0))
    assert np.allclose(demand.screw_torque_frictionless, 80.0 * SCREW.lead)
    friction = demand.motor_torque - demand.motor_torque_frictionless
    moving = np.abs(demand.length_rate.values) > 0
    # screw friction costs torque along the motion whichever way it goes
    assert np.all((friction.values * np.sign(demand.length_rate.values))[moving] > 0)
    assert np.all(demand.holding_torque == 0)
    up = raising_torque(SCREW.with_(friction=0.15), 80.0) / 5.2 / 0.8 + 1e-3
    assert np.allclose(demand.breakaway_torque.values[demand.length_rate.values > 0], up)
    assert {row.rule for row in demand.table()} >= {"break-away", "rms torque"}
    assert {row.rule for row in demand.table()}.isdisjoint({"input", "rms current"})


def test_voltage_of_the_inductance():
    demand = evaluate(model_with(), *records(80.0 + 10 * np.sin(T)))
    bare = evaluate(model_with(motor=MOTOR.with_(inductance=0.0)), *records(80.0 + 10 * np.sin(T)))
    inside = np.abs(demand.length_rate.values[:, 0]) > 1e-3
    change = np.gradient(demand.current.values[:, 0], T)
    extra = (demand.voltage - bare.voltage).values[:, 0]
    jump = np.abs(np.diff(np.sign(demand.length_rate.values[:, 0]), prepend=1)) > 0
    clear = inside & ~np.convolve(jump, np.ones(5), "same").astype(bool)
    clear[[0, 1, -2, -1]] = False
    assert np.allclose(extra[clear], 2e-3 * change[clear], rtol=1e-3, atol=1e-9)
    assert np.abs(extra).max() < 1.0  # no spike where the current jumps


def test_inductance_converges_with_the_samples():
    def extra(count):
        t = np.linspace(0.05, 0.4, count)
        found = evaluate(model_with(), *records(80.0, t))
        bare = evaluate(model_with(motor=MOTOR.with_(inductance=0.0)), *records(80.0, t))
        exact = 2e-3 / 0.0398 * (6.76e-6 + 1e-6) * 5.2 / SCREW.lead * -0.05 * np.pi**3 * np.cos(np.pi * t)
        return np.abs((found.voltage - bare.voltage).values[:, 0] - exact).max()

    assert extra(41) / extra(81) > 6  # third order


@pytest.mark.parametrize("thrust", [80.0, -80.0])
@pytest.mark.parametrize("friction", [0.0, 0.01, 0.1])
def test_power_closes_both_ways(thrust, friction):
    model = model_with(screw=SCREW.with_(friction=friction))
    motion, forces = records(thrust)
    demand = evaluate(model, motion, forces)
    flow = power_flow(model, motion, demand)
    assert np.abs(flow.balance).max() < 1e-13 * np.abs(flow.electrical).max()
    for name in ("copper", "motor", "gear", "screw"):
        assert np.all(flow[name] >= -1e-12), name
    assert (flow.actuator.values < 0).any()
    assert (flow.actuator.values > 0).any()
    # over the motion to the error of the trapezoidal rule
    assert abs(demand.energy_balance.values[0]) < 1e-3 * demand.drawn_energy.values[0]
    assert demand.electrical_energy.values[0] == pytest.approx((demand.drawn_energy - demand.returned_energy).values[0])
    assert demand.actuator_work.values[0] == pytest.approx((demand.positive_work + demand.negative_work).values[0], abs=1e-9)


def test_every_exceeded_limit_is_named_with_its_times():
    demand = evaluate(model_with(motor=MOTOR.with_(max_speed=2000.0, max_voltage=None)), *records(80.0))
    found = [one for one in exceeded(demand) if one.quantity == "speed"]
    peak = 5.2 * 0.05 * np.pi / SCREW.lead
    half = np.arccos(2000.0 / peak) / np.pi
    spans = sorted((one.start, one.end) for one in found)
    assert spans[0] == (0.0, pytest.approx(half, abs=1e-6))
    assert spans[1] == (pytest.approx(1 - half, abs=1e-6), pytest.approx(1 + half, abs=1e-6))
    assert spans[2] == (pytest.approx(2 - half, abs=1e-6), 2.0)
    middle = next(one for one in found if one.start > 0.1 and one.end < 1.9)
    assert (middle.time, middle.value) == (pytest.approx(1.0), pytest.approx(peak))
    text = str(middle)
    assert text.startswith("M7: speed too high from 0.")
    assert f"{100 * (peak / 2000 - 1):.3g} % above 2000 rad/s" in text
    lasting = next(one for one in exceeded(demand) if one.quantity == "rms torque")
    assert "over the motion" in str(lasting)
    assert exceeded(evaluate(model_with(motor=MOTOR.with_(rated_torque=None)), *records(1.0, amplitude=1e-3))) == ()


def test_moves_add_up_to_the_motion():
    demand = evaluate(model_with(), *records(80.0))
    found = moves(demand)
    assert [round(one.start, 6) for one in found] == [0.0, 0.5, 1.5]
    assert [one.travel for one in found] == [
        pytest.approx(0.05, rel=1e-6),
        pytest.approx(-0.1, rel=1e-6),
        pytest.approx(0.05, rel=1e-6),
    ]
    assert sum(one.energy for one in found) == pytest.approx(demand.electrical_energy.values[0], rel=1e-9)
    assert sum(one.drawn for one in found) == pytest.approx(demand.drawn_energy.values[0], rel=1e-9)
    assert found[0].positive_work == pytest.approx(80 * 0.05, rel=1e-6)
    assert found[1].negative_work == pytest.approx(-80 * 0.1, rel=1e-6)


def test_gear_ratio_and_largest_self_locking_lead_are_in_the_result():
    demand = evaluate(model_with(), *records(80.0))
    assert demand.gear_ratio.values[0] == pytest.approx(4000.0 * SCREW.lead / (0.05 * np.pi))
    assert demand.largest_self_locking_lead.values[0] == pytest.approx(0.0127 / 2 * 0.1)
    unlimited = evaluate(model_with(motor=MOTOR.with_(max_speed=None)), *records(80.0))
    assert np.isnan(unlimited.gear_ratio.values[0])


def test_amplifier_input_and_its_limits():
    amplifier = Amplifier(current_gain=1.8, max_input=0.5, max_current=2.0)
    demand = evaluate(model_with(amplifier=amplifier), *records(80.0))
    assert np.allclose(demand.amplifier_input, demand.current / 1.8)
    rows = {row.rule: row for row in demand.table()}
    assert rows["input"].limit == 0.5
    assert rows["current"].limit == 2.0
    voltage = evaluate(model_with(amplifier=Amplifier(voltage_gain=4)), *records(80.0))
    assert np.allclose(voltage.amplifier_input, voltage.voltage / 4)


def test_summaries_of_stretches_merge_to_that_of_the_whole():
    model = model_with(amplifier=Amplifier(current_gain=1.8, max_input=5.0))
    whole = evaluate(model, *records(80.0))
    histories = whole.data[[name for name in whole.data if "time" in whole.data[name].dims]]
    cut = 1234
    parts = [
        summarise(model, whole.with_(data=histories.isel(time=span))).data.drop_dims("time")
        for span in (slice(0, cut + 1), slice(cut, None))
    ]
    merged = merge_summaries(*parts, (T[cut], 2.0 - T[cut]))
    expected = whole.data.drop_dims("time")
    xr.testing.assert_allclose(merged, expected, rtol=1e-9)
