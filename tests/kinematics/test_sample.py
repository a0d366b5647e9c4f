"""Trajectories on a model: which drive gets what, what stands still, what is refused."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError, ModelError
from kinetruss.kinematics import gimbal_lengths, gimbal_pose, sample

TRIANGLE = kt.library.vgt.triangular()
BAY = kt.library.vgt.double_octahedral(beta=0.05, gamma=-0.08, height=1.0)
FOUR_BAR = kt.library.mechanisms.four_bar(angle=0.3)
SIDES = (1.2192, 0.889)


def test_lengths_of_a_quintic():
    moved = sample(TRIANGLE, kt.Quintic(moves={"actuator": (2.5, 3.5)}, duration=2), [0, 1, 2])
    assert moved.drives == ("actuator",)
    assert moved.space == "lengths"
    assert moved.value[:, 0].tolist() == [2.5, 3.0, 3.5]
    assert moved.rate[:, 0].tolist() == [0, 15 / 16, 0]
    assert moved.acceleration[:, 0].tolist() == [0, 0, 0]


def test_constant_rate_starts_from_the_model():
    moved = sample(FOUR_BAR, kt.ConstantRate(rates={"motor": 10.0}, duration=1), [0, 0.5])
    assert moved.value[:, 0] == pytest.approx([0.3, 5.3], abs=1e-15)
    assert moved.rate[:, 0].tolist() == [10, 10]


def test_sine_starts_from_the_model():
    sine = kt.Sine(amplitudes={"actuator": 0.1}, period=4, phase=0.5, duration=4)
    moved = sample(TRIANGLE, sine, [0, 1])
    assert moved.value[:, 0] == pytest.approx([2.5, 2.5 + 0.1 * (math.sin(math.pi / 2 + 0.5) - math.sin(0.5))])


def test_given_lengths_count_before_node_positions():
    longer = TRIANGLE.with_(active={"actuator": TRIANGLE.active["actuator"].with_(length=2.6)})
    assert sample(longer, kt.ConstantRate(rates={"actuator": 0.0}, duration=1), [0]).value[0, 0] == 2.6


def test_step_response_fills_in_the_settling_time():
    step = kt.StepResponse(moves={"actuator": (2.5, 3.7)}, duration=3, settling_factor=6)
    assert sample(TRIANGLE, step, [0.6]).rate[0, 0] == pytest.approx(1.247668662, rel=1e-9)
    assert sample(TRIANGLE, kt.library.vgt.lacy_step(), [0.6]).rate[0, 0] == pytest.approx(1.247668662, rel=1e-9)


def test_two_pole_step_response():
    step = kt.StepResponse(moves={"actuator": (2.5, 3.5)}, duration=1, order=2, damping=1.0, settling_time=1, settling_factor=5)
    assert sample(TRIANGLE, step, [0.4]).value[0, 0] == pytest.approx(3.5 - math.exp(-2) * 3, abs=1e-14)


def test_table_counts_time_from_its_first_row():
    times = tuple(np.linspace(7.0, 9.0, 21))
    table = kt.Spline(times=times, values={"actuator": tuple(2.5 + 0.1 * (t - 7) ** 2 for t in times)})
    moved = sample(TRIANGLE, table, [0, 0.5, 2.0])
    assert moved.value[:, 0] == pytest.approx([2.5, 2.525, 2.9], abs=1e-12)
    assert moved.acceleration[:, 0] == pytest.approx([0.2] * 3, abs=1e-9)
    with pytest.raises(InputError, match="counted from its first row. goes from 0 s to 2 s, the run from 0 s to 2.1 s"):
        sample(TRIANGLE, table, [0, 2.1])


def test_pose_moves_three_lengths_and_holds_what_is_not_moved():
    moved = sample(BAY, kt.Quintic(moves={"bay.beta": (0.05, 0.15)}, duration=1), [0.0, 0.5, 1.0])
    assert moved.space == "pose"
    assert moved.drives == ("M7", "M9", "M11")
    expected = gimbal_lengths(*SIDES, [0.05, 0.1, 0.15], -0.08, 1.0)
    assert moved.value == pytest.approx(expected, abs=1e-13)
    assert moved.rate[[0, 2]] == pytest.approx(0, abs=1e-14)
    assert np.abs(moved.rate[1]).min() > 1e-3


def test_mean_pose_rates_are_exact():
    t, h = np.array([0.37]), 1e-3
    trajectory = kt.Quintic(moves={"bay.beta": (-0.1, 0.15), "bay.gamma": (0.1, -0.1), "bay.height": (1.0, 1.1)}, duration=1)
    weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
    ahead = {k: (sample(BAY, trajectory, t + k * h), sample(BAY, trajectory, t - k * h)) for k in weights}
    here = sample(BAY, trajectory, t)
    for order, exact in (("value", here.rate), ("rate", here.acceleration)):
        slope = sum(w * (getattr(ahead[k][0], order) - getattr(ahead[k][1], order)) for k, w in weights.items()) / h
        assert exact == pytest.approx(slope, abs=1e-11)


def test_bays_move_by_themselves():
    chain = kt.library.vgt.double_octahedral(bays=2)
    moved = sample(chain, kt.Quintic(moves={"B2.gamma": (0.0, 0.2)}, duration=1), [1.0])
    assert moved.drives == ("B1.M7", "B1.M9", "B1.M11", "B2.M7", "B2.M9", "B2.M11")
    assert moved.value[0, :3] == pytest.approx([1.1684] * 3, abs=1e-13)
    beta, gamma, height = gimbal_pose(*SIDES, moved.value[0, 3:])
    assert (float(beta), float(gamma), float(height)) == pytest.approx((0, 0.2, 1.1218253458835146), abs=1e-12)


def test_out_of_reach_keeps_the_samples_before():
    trajectory = kt.Quintic(moves={"bay.beta": (0.0, 1.4)}, duration=1)
    with pytest.raises(AnalysisError, match=r"pose 'bay' at t = 0\.\d+ s: .*out of reach") as caught:
        sample(BAY, trajectory, np.linspace(0, 1, 11))
    kept = caught.value.result
    assert 3 < len(kept.times) < 10
    assert kept.value.shape == (len(kept.times), 3)
    assert np.isfinite(kept.acceleration).all()


def test_names_and_units_are_checked():
    with pytest.raises(ModelError, match=r"Did you mean 'bay\.beta'"):
        sample(BAY, kt.Quintic(moves={"bay.bta": (0, 0.1)}, duration=1), [0])
    with pytest.raises(ModelError, match="is given as a length"):
        sample(BAY, kt.Quintic(moves={"bay.beta": ("0 m", "0.1 m")}, duration=1), [0])
    with pytest.raises(ModelError, match="and the pose 'bay' that moves them"):
        sample(BAY, kt.Quintic(moves={"bay.beta": (0, 0.1), "M7": (1.1, 1.2)}, duration=1), [0])
