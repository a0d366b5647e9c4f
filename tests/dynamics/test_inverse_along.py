"""Inverse kinematics and dynamics in one call, against virtual work on a platform and the two calls."""

import numpy as np
import pytest

import kinetruss as kt

HEADS = tuple(f"P{k}" for k in range(1, 7))
MOVES = {"x": (0.0, 0.1), "y": (0.0, -0.05), "z": (0.0, 0.15)}


def lift(**sizes) -> kt.Model:
    return kt.library.mechanisms.stewart(platform_mass=12.0, **sizes)


@pytest.mark.slow
def test_legs_push_what_newton_and_euler_ask_for():
    """A platform that does not turn: the legs' pushes sum to m (a - g), and so do their moments."""
    model = lift()
    forces = kt.dynamics.inverse_along(model, kt.Quintic(moves=MOVES, duration=0.4), platform=HEADS, samples=21)
    motion = forces.motion
    at = {name: motion.position.sel(node=name).values for name in model.nodes}
    push = forces.drive_force.values
    total, turning = 0.0, 0.0
    middle = sum(at[name] for name in HEADS) / 6
    for k in range(1, 7):
        foot, head = (at[end] for end in model.bars[f"leg{k}"].ends)
        along = (head - foot) / np.linalg.norm(head - foot, axis=1, keepdims=True)
        each = along * push[:, list(forces.drive_force.drive.values).index(f"leg{k}")][:, None]
        total, turning = total + each, turning + np.cross(head - middle, each)
    wanted = 12.0 * (motion.acceleration.sel(node="P1").values + np.array([0.0, 0.0, 9.81]))
    np.testing.assert_allclose(total, wanted, rtol=0, atol=1e-10)
    np.testing.assert_allclose(turning, 0.0, rtol=0, atol=1e-10)


@pytest.mark.slow
def test_it_is_the_two_calls():
    model, path = lift(leg_mass=1.0), kt.Quintic(moves=MOVES | {"yaw": (0.0, 0.2)}, duration=0.4)
    one = kt.dynamics.inverse_along(model, path, platform=HEADS, samples=5)
    motion = kt.kinematics.inverse(model, path, platform=HEADS, samples=5)
    two = kt.dynamics.inverse(model, motion)
    for name in two.data:
        np.testing.assert_array_equal(one.data[name].values, two.data[name].values)
    np.testing.assert_array_equal(one.static.drive_force.values, two.static.drive_force.values)
    np.testing.assert_array_equal(one.motion.drive_position.values, motion.drive_position.values)


@pytest.mark.slow
def test_targets_may_change_between_calls_of_one_model():
    """What is kept between calls belongs to its targets."""
    model = lift()
    for moves, nodes in ((MOVES, HEADS), ({"roll": (0.0, 0.1)}, HEADS), ({"z": (0.0, 0.1)}, HEADS[:3])):
        path = kt.Quintic(moves=moves, duration=1.0)
        kept = kt.dynamics.inverse_along(model, path, platform=nodes, samples=4, static=False)
        fresh = kt.dynamics.inverse_along(lift(), path, platform=nodes, samples=4, static=False)
        np.testing.assert_array_equal(kept.drive_force.values, fresh.drive_force.values)
        assert kept.static is None


@pytest.mark.slow
def test_out_of_reach_is_told():
    with pytest.raises(kt.AnalysisError, match="good up to") as caught:
        kt.dynamics.inverse_along(
            kt.library.mechanisms.peaucellier(), kt.Quintic(moves={"P.y": (0.0, 0.9)}, duration=1.0), samples=21
        )
    assert len(caught.value.result.data["time"]) > 2
