"""The quickest motion along a path: one limit is just reached, none is exceeded."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

TOP = ("B2.N7", "B2.N9", "B2.N8")
MODEL = kt.library.vgt.double_octahedral(bays=2, gravity=(0, 0, -9.81), tip_force=(0, 0, "-100 N"))
MOTION = kt.kinematics.inverse(MODEL, kt.Positioning(nodes=TOP, moves={"x": 0.15}, duration=2.0), samples=101)


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
