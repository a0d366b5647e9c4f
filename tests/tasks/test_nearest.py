"""The nearest pose out of reach: the best of some starts, against closed forms of regions with several local minima."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

PART = kt.Part(length=0.3, mass=1.0)


def jib(a, b):
    """A point C on two actuators a and b (m) from (0, 0) and (1, 0), with strokes 0.9 ... 1.3 m and 0.5 ... 1.7 m."""
    x = 0.5 * (a**2 - b**2 + 1)
    rods = {"base": PART, "tube": PART}
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (x, np.sqrt(a**2 - x**2))}, fixed=["A", "B"],
        active={"a": kt.Active(ends=("A", "C"), limits=(0.9, 1.3), **rods),
                "b": kt.Active(ends=("B", "C"), limits=(0.5, 1.7), **rods)},
    )  # fmt: skip


def corner(a, b):
    """Place of C."""
    x = 0.5 * (a**2 - b**2 + 1)
    return np.array([x, np.sqrt(a**2 - x**2)])


def nearest(model, point, starts):
    """The pose nearest to a point."""
    return kt.kinematics.reach(model, kt.Positioning(node="C", moves={"x": point[0], "y": point[1]}), starts=starts)


def test_of_two_nearest_corners_the_nearer_is_found_from_anywhere():
    """Behind the point A the arc a = 0.9 about A is farthest in its middle: both its ends are local minima."""
    point, right, left = np.array([0.05, -0.2]), corner(0.9, 0.5), corner(0.9, 1.7)
    stuck = nearest(jib(1.0, 1.6), point, 1)
    assert stuck.position.sel(node="C").values[0] == pytest.approx(left, abs=1e-7)
    assert "(from one start)" in str(stuck.message.values[0])
    for model in (jib(1.0, 1.6), jib(1.1, 0.7)):
        found = nearest(model, point, 16)
        assert not found.reached.values[0]
        assert found.position.sel(node="C").values[0] == pytest.approx(right, abs=1e-7)
        assert found.miss.values[0] == pytest.approx(np.abs(right - point).max(), abs=1e-7)
        assert found.starts.values[0] == 16
        assert 1 <= found.same.values[0] < 16
        assert f"best of 16 starts, {found.same.values[0]} of them came as near" in str(found.message.values[0])


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_the_nearest_pose_of_random_points_is_that_of_a_fine_grid_of_drives(seed):
    point = np.random.default_rng(seed).uniform((-1.5, -1.5), (2.5, 2.0))
    a, b = np.meshgrid(np.linspace(0.9, 1.3, 401), np.linspace(0.5, 1.7, 1201))
    x = 0.5 * (a**2 - b**2 + 1)
    y = np.sqrt(np.maximum(a**2 - x**2, 0.0))
    open_ = a**2 > x**2
    least = np.hypot(x - point[0], y - point[1])[open_].min()
    found = nearest(jib(1.0, 1.0), point, 64)
    off = np.linalg.norm(found.position.sel(node="C").values[0] - point)
    assert off <= least + 1e-9
    assert off >= least - 2e-3


def test_an_arm_that_points_away_turns_round():
    """A straight arm that points away from a point beyond its reach stands still to first order; its reach is 1.8 m."""
    arm = kt.Model(
        nodes={"O": (0, 0), "E": (-1, 0), "T": (-1.8, 0)}, fixed=["O"], bars={"upper": ("O", "E"), "fore": ("E", "T")},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.AngleDrive("fore")},
    )  # fmt: skip
    task = kt.Positioning(node="T", moves={"x": 3.0, "y": 0.0})
    one, many = (kt.kinematics.reach(arm, task, starts=starts) for starts in (1, 16))
    assert one.position.sel(node="T").values[0] == pytest.approx([-1.8, 0], abs=1e-9)
    assert many.position.sel(node="T").values[0] == pytest.approx([1.8, 0], abs=1e-6)
    again = kt.kinematics.reach(arm, task, starts=16)
    assert np.array_equal(again.drive_position, many.drive_position)
    with pytest.raises(kt.InputError, match="starts"):
        kt.kinematics.reach(arm, task, starts=0)
