"""Starts in a singular position, or right beside one, against the pendulum's equation that rows of four-bars obey."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import kinetruss as kt
from kinetruss.dynamics.singular_starts import _plan
from kinetruss.library import mechanisms
from kinetruss.results import Status

simulate = kt.dynamics.simulate


def row(loops: int, beside: float, rate: float) -> kt.Model:
    """A row of parallelograms, `beside` (rad) off the line in which all bars lie."""
    return mechanisms.n_four_bar(loops=loops, angle=math.pi / 2 - beside, rate=rate)


def angles(loops: int, beside: float, rate: float, t: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """Angle and rate of the posts at t (s), and the factor of angle'' = pull sin(angle)."""
    pull = 9.81 * ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)
    found = solve_ivp(
        lambda _, y: [y[1], pull * math.sin(y[0])], (0.0, t[-1]), [math.pi / 2 - beside, rate], "DOP853", t,
        rtol=1e-13, atol=1e-14,
    )  # fmt: skip
    return found.y[0], found.y[1], pull


def off(run: kt.results.Simulation, loops: int, beside: float, rate: float) -> float:
    """Largest error of the position of B0."""
    angle, _, _ = angles(loops, beside, rate, run.time.values)
    at = run.motion.position.sel(node="B0").values
    return float(np.abs(at - np.stack([np.sin(angle), np.cos(angle)], axis=1)).max())


@pytest.mark.slow
@pytest.mark.parametrize("loops", [1, 3, 10])
@pytest.mark.parametrize("beside", [0.0, 1e-8, 1e-6, -1e-6, 1e-5, 1e-4, -1e-4, 3e-4, 1e-3])
@pytest.mark.parametrize("rate", [0.0, 1e-3, 0.1, -0.1, 2.0])
def test_rows_of_four_bars_start_flat_or_nearly_flat(loops, beside, rate):
    run = simulate(row(loops, beside, rate), 3.0, samples=301)
    assert run.status is Status.COMPLETED
    assert np.ptp(run.energy.values) < 1e-8 * run.kinetic_energy.values.max()
    assert off(run, loops, beside, rate) < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize("rate", [1e-3, 0.1, -0.1, 1.0])
def test_accelerations_and_forces_are_right_from_the_first_sample_on(rate):
    run = simulate(row(1, 0.0, rate), 0.1, times=[0.0, 0.03, 0.05, 0.1])
    angle, speed, pull = angles(1, 0.0, rate, run.time.values)
    along, across = np.stack([np.cos(angle), -np.sin(angle)], axis=1), np.stack([np.sin(angle), np.cos(angle)], axis=1)
    a = pull * np.sin(angle)[:, None] * along - speed[:, None] ** 2 * across
    np.testing.assert_allclose(run.motion.acceleration.sel(node="B0"), a, atol=2e-6)
    again = kt.dynamics.inverse(row(1, 0.0, rate), run.motion, static=False).member_force.values
    np.testing.assert_allclose(run.forces.member_force[1:], again[1:], atol=1e-3)
    # at the start, where the equations give none, they go on as a polynomial
    beside = simulate(row(1, 0.0, rate), 0.1, times=np.linspace(0.02, 0.1, 9))
    on = kt.dynamics.inverse(row(1, 0.0, rate), beside.motion, static=False).member_force.values
    expected = [np.polyval(np.polyfit(beside.time.values, force, 6), 0.0) for force in on.T]
    np.testing.assert_allclose(run.forces.member_force[0], expected, atol=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("rate", [1e-3, 0.1, -0.1, 1.0])
def test_where_forces_depend_on_time_the_start_is_left_by_what_lies_behind_it(rate):
    run = simulate(row(3, 0.0, rate), 2.0, samples=41, user_force=lambda t, x, v: {})
    assert run.status is Status.COMPLETED
    assert off(run, 3, 0.0, rate) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("method", [kt.EnergyMomentum(step=2e-4), kt.GeneralizedAlpha(step=2e-4), kt.Rattle(step=2e-4)])
def test_steps_of_fixed_size_leave_a_flat_start_that_moves(method):
    run = simulate(row(3, 0.0, 1.0), 0.5, samples=6, method=method)
    assert run.status is Status.COMPLETED
    assert off(run, 3, 0.0, 1.0) < 1e-5


def test_a_run_that_ends_within_the_first_stretch():
    run = simulate(row(3, 0.0, 0.1), 1e-3, samples=11)
    assert run.status is Status.COMPLETED
    assert run.time[-1] == 1e-3
    assert off(run, 3, 0.0, 0.1) < 1e-9


@pytest.mark.slow
def test_at_rest_it_is_said_which_freedoms_meet_and_how_to_choose():
    run = simulate(row(2, 0.0, 0.0), 1.0, samples=11)
    assert run.status is Status.COMPLETED
    assert "The start is a singular position, at rest, with 3 degrees of freedom (B0 moves along y" in run.message
    assert "start 0.01 m away from it, or with velocities" in run.message
    assert "not unique" not in run.message
    assert [(p.time, p.certain) for p in run.passages[:1]] == [(0.0, False)]
    for beside, rate in ((0.0, 0.1), (1e-3, 0.0)):
        assert "The start is" not in simulate(row(2, beside, rate), 0.1, samples=3).message


def test_a_passage_within_the_first_stretch_is_recorded_where_it_is():
    """Thrown up 1e-4 rad below the line: it is met where 1e-4 = 0.1 t - pull t^2/2, twice."""
    run = simulate(row(1, -1e-4, -0.1), 0.02, samples=21)
    pull = angles(1, 0.0, 0.0, np.array([0.0, 1.0]))[2]
    first = (0.1 - math.sqrt(0.01 - 2e-4 * pull)) / pull
    assert run.passages[0].time == pytest.approx(first, rel=1e-3)


@pytest.mark.parametrize("both", [True, False])
def test_the_plan_of_the_first_stretch_integrates_polynomials(both):
    """Values of a polynomial at the instants give its integrals, its value at the start, and the interpolant of a step."""
    plan, powers = _plan(both), np.arange(6)
    c = np.array([0.3, -1.2, 0.7, 2.0, -0.4, 0.9])
    values = (plan.s[:, None] ** powers) @ c
    for at, once, twice in ((plan.s, plan.once, plan.twice), (plan.read, plan.read_once, plan.read_twice)):
        np.testing.assert_allclose(once @ values, (at[:, None] ** (powers + 1) / (powers + 1)) @ c, atol=1e-12)
        np.testing.assert_allclose(twice @ values, (at[:, None] ** (powers + 2) / (powers + 1) / (powers + 2)) @ c, atol=1e-12)
    assert plan.begin @ values == pytest.approx(c[0], abs=1e-11)
    from kinetruss.kernels.integrate.dop853 import interpolate

    F, y = plan.back @ (plan.read[:, None] ** np.arange(8)), np.zeros(8)
    interpolate(F, 0.37, y)
    np.testing.assert_allclose(y, 0.37 ** np.arange(8), atol=1e-12)


def flat(fixed: tuple[str, ...], **fields: object) -> kt.Model:
    """A square with both diagonals: stiff in its plane, to second order only across it."""
    at = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (1, 1, 0), "D": (0, 1, 0)}
    bars = {a + b: kt.Bar(ends=(a, b), mass=1.0) for i, a in enumerate(at) for b in list(at)[i + 1 :]}
    return kt.Model(nodes=at, bars=bars, fixed=fixed, **fields)


@pytest.mark.slow
@pytest.mark.parametrize("method", [None, kt.EnergyMomentum(step=1e-3), kt.Radau(), kt.Rattle(step=1e-3)])
def test_a_flat_arrangement_let_go_is_told_as_stiff_to_second_order_only(method):
    run = simulate(flat(("A",), gravity=(0.3, 0, -9.81)), 1.0, method=method, raise_on_failure=False)
    assert "Stiff to second order only" in run.message
    assert "C moves along z" in run.message
    assert "Connect a node outside the plane by bars, or add a support." in run.message


@pytest.mark.slow
def test_nothing_of_the_kind_is_said_of_loops_that_move_against_their_count():
    for model in (mechanisms.bennett(), mechanisms.bricard(), row(3, 0.3, 0.0)):
        assert "second order" not in simulate(model, 0.05, samples=3).message
