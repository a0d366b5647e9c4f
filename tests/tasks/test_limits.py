"""Limits of rates, accelerations, forces and motors along tasks: kept by redundant drives, or said with figures that hold."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import LinearConstraint, minimize

import kinetruss as kt
from kinetruss.mechanics.quadratic import least_quadratic

SLIDES = kt.Model(
    nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, fixed={"A": "xy", "B": "y", "C": "y"},
    bars={"a": kt.Bar(ends=("A", "B"), kind="driven"), "b": kt.Bar(ends=("B", "C"), kind="driven")},
)  # fmt: skip
"""Two drives in a row: C.x = a + b."""
PEAK = 1.875 / 2
"""Largest rate of C.x, m/s: of a quintic of 1 m in 2 s."""


def moved(**limits):
    """C goes 1 m in 2 s."""
    return kt.kinematics.inverse(SLIDES, kt.Coordinates(moves={"C.x": 3.0}, duration=2.0, **limits))


def largest(motion, name):
    """Largest magnitudes of the drives."""
    return np.abs(motion.data[name].values).max(axis=0)


def quintic(t):
    """Place of C and its two derivatives."""
    s = t / 2
    return 2 + s**3 * (10 - 15 * s + 6 * s**2), 15 * s**2 * (1 - s) ** 2, 15 * s * (1 - s) * (1 - 2 * s)


@pytest.mark.slow
@pytest.mark.parametrize("limits", [{"rate": {"a": 0.3}}, {"rate": {"a": 0.3, "b": 0.66}, "acceleration": 1.3}])
def test_a_drive_at_its_limit_stays_there_and_the_other_does_the_rest(limits):
    motion = moved(**limits)
    t, q, v, a = (motion.data[n].values for n in ("time", "drive_position", "drive_velocity", "drive_acceleration"))
    for found, exact in zip((q, v, a), quintic(t), strict=True):
        assert found.sum(axis=1) == pytest.approx(exact, abs=1e-10)
    assert motion.attrs["limits_kept"] == 1
    assert largest(motion, "drive_velocity")[0] <= 0.3
    if "acceleration" not in limits:
        assert largest(motion, "drive_velocity")[0] > 0.299
    else:
        assert largest(motion, "drive_acceleration").max() <= 1.3
    # rates and accelerations are those of the drives
    inner = slice(4, -4)
    assert np.gradient(q, t, axis=0)[inner] == pytest.approx(v[inner], abs=2e-3)
    assert np.gradient(v, t, axis=0)[inner] == pytest.approx(a[inner], abs=5e-2)


def test_limits_that_are_not_reached_change_nothing():
    assert np.array_equal(moved(rate=0.47, acceleration=0.8).drive_position, moved().drive_position)


@pytest.mark.slow
def test_limits_that_cannot_be_kept_are_said_with_the_factor_that_keeps_them():
    """a + b has a peak of 0.9375 m/s, the limits sum up to 0.9: both are exceeded by 0.9375/0.9 at the least."""
    motion = moved(rate={"a": 0.3, "b": 0.6})
    factor = PEAK / 0.9
    assert motion.attrs["limits_kept"] == 0
    assert motion.attrs["worst_ratio"] == pytest.approx(factor, rel=1e-4)
    middle = motion.drive_velocity.sel(time=1.0, method="nearest").values
    assert np.abs(middle) == pytest.approx(factor * np.array([0.3, 0.6]), rel=1e-3)
    assert "no choice of the redundant drives was found" in motion.message
    assert f"Slowed down by the factor {motion.attrs['worst_ratio']:.6g}" in motion.message
    slow = kt.kinematics.inverse(SLIDES, kt.Coordinates(moves={"C.x": 3.0}, duration=2.001 * factor, rate={"a": 0.3, "b": 0.6}))
    assert slow.attrs["limits_kept"] == 1


@pytest.mark.slow
def test_without_freedom_or_against_the_choice_the_motion_says_so():
    held = moved(rate=0.5, hold=["a"])
    assert held.attrs["worst_ratio"] == pytest.approx(PEAK / 0.5, rel=1e-9)
    assert "the task leaves the drives no freedom" in held.message
    assert "rate of b 0.9375 at t = 1 s, limit 0.5 (1.875 times)" in held.message
    free = moved(rate={"a": 0.3}, within_rates=False)
    assert "redundant drives do not mind them" in free.message
    assert np.array_equal(free.drive_position, moved().drive_position)
    jump = kt.kinematics.inverse(SLIDES, kt.Coordinates(moves={"C.x": 3.0}, law="constant", acceleration=1e3, duration=2.0))
    assert jump.attrs["limits_kept"] == 1  # at one rate from start to end
    ways = kt.Coordinates(moves={"C.x": [2.0, 2.5, 2.2]}, law="constant", acceleration=1.0, duration=2.0)
    jump = kt.kinematics.inverse(SLIDES, ways)
    assert "where its rate jumps" in jump.message and "law without jumps" in jump.message
    assert "factor" not in jump.message


@pytest.mark.slow
def test_a_mast_keeps_rates_accelerations_and_strokes():
    model = kt.library.vgt.double_octahedral(bays=2, limits=("1.0 m", "1.35 m"))
    top = ("B2.N7", "B2.N9", "B2.N8")
    task = kt.Positioning(nodes=top, moves={"x": 0.2}, duration=2.0)
    without = kt.kinematics.inverse(model, task)
    rate, acceleration = 0.95 * largest(without, "drive_velocity").max(), 1.6 * largest(without, "drive_acceleration").max()
    high = 0.1 * without.drive_position.values.min() + 0.9 * without.drive_position.values.max()
    model = model.with_(active={name: one.with_(limits=(1.0, high)) for name, one in model.active.items()})
    assert "rates jump" in kt.kinematics.inverse(model, task).message
    motion = kt.kinematics.inverse(model, task.with_(rate=rate, acceleration=acceleration))
    assert motion.attrs["limits_kept"] == 1, motion.message
    assert largest(motion, "drive_velocity").max() <= rate
    assert largest(motion, "drive_acceleration").max() <= acceleration
    assert motion.drive_position.values.min() >= 1.0 and motion.drive_position.values.max() <= high + 1e-12
    centre = motion.position.sel(node=list(top)).mean("node").values
    assert centre[-1, 0] == pytest.approx(0.2, abs=1e-10)
    lengths = dict(zip(model.all_drives, motion.drive_position.values[-1].tolist(), strict=True))
    assert np.abs(kt.kinematics.assemble(model, lengths) - motion.position.values[-1]).max() < 1e-9


def test_an_equal_division_of_angles_keeps_the_limits_of_its_task():
    model = kt.library.vgt.double_octahedral(bays=2)
    top = ("B2.N7", "B2.N9", "B2.N8")
    motion = kt.kinematics.inverse(model, kt.Gimbal(platform=top, moves={"beta": "8 deg"}, division="equal", rate=0.01))
    assert motion.attrs["worst_ratio"] == pytest.approx(largest(motion, "drive_velocity").max() / 0.01, rel=1e-3)
    assert "the task leaves the drives no freedom" in motion.message


@pytest.mark.slow
def test_force_at_rest_and_speed_of_motors_are_compared_and_the_rest_is_named():
    trains = {"screw": "screw_lacy_spatial", "gear": "gear_lacy", "motor": "motor_lacy"}
    model = kt.library.vgt.double_octahedral(tip_force=(0, 0, "-20 N"), gravity=(0, 0, -9.81), **trains)
    name, motor = next(iter(model.motors.items()))
    model = model.with_(motors={name: motor.with_(max_speed=100.0, max_voltage=20.0)})
    task = kt.Coordinates(moves={"N8.z": 1.0, "N7.z": 1.0, "N9.z": 1.0})
    motion = kt.kinematics.inverse(model, task.with_(force=1.0))
    forces = kt.dynamics.inverse(model, motion)
    demand = kt.actuators.evaluate(model, motion, forces).data
    speed = demand["utilisation"].sel(quantity="speed").max().item()
    rest = np.abs(forces.static.drive_force.values).max()
    assert motion.attrs["worst_ratio"] == pytest.approx(max(speed, rest), rel=1e-9)
    assert "force at rest" in motion.message and "does not depend on time" in motion.message
    assert motion.unchecked.startswith("Not checked without forces: voltage of the motors")
    assert motion.unchecked in repr(motion) and motion.unchecked not in forces.message
    model = model.with_(runs={"up": kt.Run(targets=task, samples=5), "way": kt.Run(analysis="kinematics.follow", targets=task)})
    up, way = kt.run(model, "up"), kt.run(model, "way")
    assert "Not checked" not in up.message and kt.report.summary(up).record["checks"]["motors"] == ["voltage"]
    assert way.message.endswith(motion.unchecked) and kt.report.summary(way).record["checks"]["motors"] == []
    found = kt.dynamics.limits_kept(model, motion, forces, force=1.0)
    ratios = {(one.limit, one.drive): one.ratio for one in found.uses}
    assert ratios["voltage", "M7"] == pytest.approx(demand["utilisation"].sel(quantity="voltage", active="M7").item())
    assert ratios["force", "M9"] == pytest.approx(np.abs(forces.drive_force.sel(drive="M9").values).max())
    assert ratios["speed", "M7"] == pytest.approx(demand["utilisation"].sel(quantity="speed", active="M7").item())
    assert not found.kept and "limits are not kept" in str(found)


def test_quickest_of_a_motion_whose_limit_is_exceeded_takes_the_factor_it_says():
    motion = moved(rate={"a": 0.3}, within_rates=False)
    found = kt.dynamics.quickest(SLIDES, motion, rate={"a": 0.3})
    assert found.factor == pytest.approx(motion.attrs["worst_ratio"], rel=1e-12)
    assert "worst_ratio" not in found.motion.attrs
    assert kt.dynamics.limits_kept(SLIDES, found.motion, rate={"a": 0.3}).worst.ratio == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_quadratic_problems_against_another_method(seed):
    rng = np.random.default_rng(seed)
    n, m = 5, 9
    root = rng.normal(size=(n, n))
    H, g, G, h = root @ root.T + 0.1 * np.eye(n), rng.normal(size=n), rng.normal(size=(m, n)), rng.uniform(0.1, 1, m)
    x, good = least_quadratic(H, g, G, h)
    other = minimize(lambda y: 0.5 * y @ H @ y + g @ y, np.zeros(n), jac=lambda y: H @ y + g, method="SLSQP",
                     constraints=[LinearConstraint(G, -np.inf, h)], options={"ftol": 1e-14, "maxiter": 300})  # fmt: skip
    assert good and x == pytest.approx(other.x, abs=1e-5)
    assert (G @ x <= h + 1e-9).all()


def test_unknown_drives_and_wrong_numbers_are_refused():
    with pytest.raises(kt.ModelError, match="no drive called 'c'"):
        moved(rate={"c": 1.0})
    with pytest.raises(kt.ModelError, match="must be greater than 0"):
        moved(acceleration=-1.0)
    with pytest.raises(kt.InputError, match="no limit to compare with"):
        kt.dynamics.limits_kept(SLIDES, moved())
