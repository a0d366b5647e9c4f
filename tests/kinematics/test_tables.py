"""Tables in time: monotone where asked for, swings said, and never a run beyond a table in silence."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.kinematics.time_tables import monotone, swings, through

STEPS = st.lists(st.sampled_from([0.0, 0.0, 1e-3, 0.1, 1.0, -0.5, -1.0, 10.0]), min_size=1, max_size=12)


LAWS = {"sine": np.sin, "quintic": lambda t: t**3 * (10 - 15 * t + 6 * t**2), "there and back": lambda t: 1 - np.cos(7 * t)}


def jack(**changes):
    """A vertical driven bar on a support, with a mass on top."""
    fields = {
        "nodes": {"A": (0, 0), "B": kt.Node(at=(0, 1), mass=2.0)}, "fixed": {"A": "xy", "B": "x"}, "gravity": (0, -9.81),
        "bars": {"jack": kt.Bar(ends=("A", "B"), kind="driven", mass=0)},
    }  # fmt: skip
    return kt.Model(**fields | changes)


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(STEPS, st.data())
def test_monotone_tables_never_leave_the_range_of_two_neighbours(steps, data):
    pauses = data.draw(st.lists(st.floats(0.05, 2.0), min_size=len(steps), max_size=len(steps)))
    times, values = np.r_[0.0, np.cumsum(pauses)], np.r_[0.3, 0.3 + np.cumsum(steps)]
    for i, (a, b) in enumerate(pairwise(times)):
        t = np.linspace(a, b, 40)
        value, rate, _ = (part[:, 0] for part in through(t, times, values[:, None], "monotone"))
        low, high = sorted(values[i : i + 2])
        size = 1e-9 * (1 + np.ptp(values))
        assert low - size <= value.min() and value.max() <= high + size
        assert np.all(rate * steps[i] >= -size / (b - a)) and (steps[i] != 0 or np.abs(rate).max() < size / (b - a))


@pytest.mark.slow
@settings(max_examples=50, deadline=None)
@given(STEPS)
def test_monotone_tables_go_through_their_points_with_continuous_acceleration(steps):
    times, values = 0.5 * np.arange(len(steps) + 1.0), np.r_[0.0, np.cumsum(steps)]
    curve = monotone(times, values[:, None])
    np.testing.assert_allclose(curve(times)[:, 0], values, atol=1e-12 * (1 + np.ptp(values)))
    for order in (1, 2):
        before, after = curve(times[1:-1] - 1e-9, order), curve(times[1:-1] + 1e-9, order)
        assert np.all(np.abs(before - after) < 1e-5 * (1 + np.abs(before)))


def test_where_nothing_is_cut_back_monotone_is_the_spline():
    times = np.linspace(0.1, 1.0, 10)
    values = np.stack([times**5 + times, np.exp(times)], axis=1)
    t = np.linspace(0.1, 1.0, 91)
    for one, other in zip(through(t, times, values, "monotone"), through(t, times, values, "spline"), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-9)


def test_a_rest_to_rest_quintic_is_kept_whatever_its_rows():
    t = np.linspace(0, 1, 101)
    for rows in (6, 7, 11, 41):
        s = np.linspace(0, 1, rows)
        wanted = LAWS["quintic"](t), 30 * (t * (1 - t)) ** 2, 60 * t * (1 - t) * (1 - 2 * t)
        for one, other in zip(through(t, s, LAWS["quintic"](s)[:, None], "monotone"), wanted, strict=True):
            np.testing.assert_allclose(one[:, 0], other, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("values", [(1, 1, 1, 1.2, 1.2, 1.2), (1, 1, 1.1, 1.2, 1.2, 1.3), (1.2, 1.2, 1.2, 1.0, 1.0, 1.0, 1.0)])
def test_a_spline_that_swings_the_other_way_says_so(values):
    times = tuple(0.2 * k for k in range(len(values)))
    table = kt.Spline(times=times, values={"jack": values})
    motion = kt.kinematics.follow(jack(), table, samples=201)
    beyond = max(motion.drive_position.values.max() - max(values), min(values) - motion.drive_position.values.min())
    assert ("swings" in motion.message) == (beyond > 2e-4) and beyond > 2e-4
    assert "'jack'" in motion.message and "shape: monotone" in motion.message
    calm = kt.kinematics.follow(jack(), table.with_(shape="monotone"), samples=201)
    assert calm.message == ""
    assert min(values) - 1e-12 <= calm.drive_position.values.min() and calm.drive_position.values.max() <= max(values) + 1e-12
    run = kt.dynamics.simulate(jack(), times[-1], trajectory=table, samples=3)
    assert "swings" in run.message


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_well_sampled_laws_are_not_accused(law):
    t = np.linspace(0, 1, 21)
    assert list(swings("", t, {"a": law(t)})) == []


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(st.lists(st.floats(0.95, 1.05), min_size=4, max_size=9), st.sampled_from(["spline", "monotone"]))
def test_simulated_and_followed_tables_are_the_same(values, shape):
    table = kt.Spline(times=tuple(0.3 * k for k in range(len(values))), values={"jack": tuple(values)}, shape=shape)
    t = np.linspace(0, table.duration, 17)
    run = kt.dynamics.simulate(jack(), times=t, trajectory=table, tasks={})
    motion = kt.kinematics.follow(jack(), table, times=t)
    np.testing.assert_allclose(run.motion.position.values, motion.position.values, atol=1e-9)
    np.testing.assert_allclose(run.motion.velocity.values, motion.velocity.values, atol=1e-7)


def moves(end, shape="spline", start=0.0):
    times = tuple(np.linspace(start, end, 6))
    return kt.History(times=times, displacements=tuple((0.0, 0.02 * t) for t in times), shape=shape)


STILL = kt.Quintic(moves={"jack": (1.0, 1.1)}, duration=1.0)


@pytest.mark.parametrize("history", [moves(0.5), moves(0.999), moves(2.0, start=0.1), moves(0.5, shape="monotone")])
def test_a_support_table_that_does_not_cover_the_run_is_refused(history):
    model = jack(support_motion={"A": history})
    with pytest.raises(kt.InputError, match="table of support 'A' goes from"):
        kt.kinematics.follow(model, STILL, samples=5)
    with pytest.raises(kt.InputError, match="table of support 'A' goes from"):
        kt.kinematics.inverse(model, kt.Quintic(moves={"B.y": (1.0, 1.1)}, duration=1.0), samples=5)
    with pytest.raises(kt.InputError, match="table of support 'A' goes from"):
        kt.dynamics.simulate(model, 1.0, trajectory=STILL)


def test_supports_that_cover_the_run_or_stand_still():
    for history in (moves(1.0), moves(3.0, start=-1.0), kt.History(times=(0, 0.1), displacements=((0, 0), (0, 0)))):
        model = jack(support_motion={"A": history})
        motion = kt.kinematics.follow(model, STILL, samples=5)
        run = kt.dynamics.simulate(model, times=motion.position.time.values, trajectory=STILL)
        np.testing.assert_allclose(run.motion.position.values, motion.position.values, atol=1e-9)


@pytest.mark.parametrize("shape", ["spline", "monotone"])
def test_a_drive_table_shorter_than_the_run_is_refused(shape):
    table = kt.Spline(times=(0, 0.1, 0.2, 0.3, 0.4), values={"jack": (1, 1.01, 1.02, 1.03, 1.02)}, shape=shape)
    with pytest.raises(kt.InputError, match="table of the trajectory"):
        kt.kinematics.follow(jack(), table, times=[0, 0.2, 0.5])
    with pytest.raises(kt.InputError, match="table of the trajectory"):
        kt.dynamics.simulate(jack(), 0.5, trajectory=table)
    with pytest.raises(kt.InputError, match="table of the trajectory"):
        kt.dynamics.simulate(jack(), 0.5, tasks={"jack": table})
