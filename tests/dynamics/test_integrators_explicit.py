"""DOP853 on equations of motion: closed forms, order, singular positions, chunks, events, what stops it."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest
from scipy.special import ellipj, ellipk

import kinetruss as kt
from kinetruss.dynamics.integrators import Watched
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.loop import integrate
from kinetruss.kernels.structure.applied import USER_FORCE
from kinetruss.library import mechanisms
from kinetruss.model import DOP853
from reference.linkages import row_of_four_bars
from reference.marching import march, prepared

G = 9.81


def swing(times, amplitude, length=1.0):
    """Angle and rate of a pendulum let go at `amplitude`: sin(theta/2) = k sn(K - w t)."""
    k = math.sin(amplitude / 2)
    w = math.sqrt(G / length)
    sn, cn, _, _ = ellipj(ellipk(k * k) - w * np.asarray(times), k * k)
    return 2 * np.arcsin(k * sn), -2 * k * w * cn


def angle(run, node="P1"):
    x = run.node(node)
    return np.arctan2(x[:, 0], -x[:, 1])


def test_pendulum_against_elliptic_functions():
    times = np.linspace(0, 10, 101)
    run = march(mechanisms.pendulum(angle=2.5), times, DOP853())
    assert run.code == m.DONE and run.done == 101
    theta, rate = swing(times, 2.5)
    np.testing.assert_allclose(angle(run), theta, atol=2e-9)
    # tension of the massless bar: centripetal force and weight of the bob
    np.testing.assert_allclose(run.N[:, 0], rate**2 + G * np.cos(theta), atol=2e-7)
    assert np.ptp(run.energy) < 1e-9 * run.kinetic.max()


@pytest.mark.parametrize("rtol", [1e-5, 1e-7, 1e-9, 1e-11])
def test_error_follows_the_tolerance(rtol):
    run = march(mechanisms.pendulum(angle=2.5), [0, 5.0], DOP853(rtol=rtol, atol=rtol / 10))
    assert abs(angle(run)[-1] - swing(5.0, 2.5)[0]) < 60 * rtol


def test_order_is_8():
    """Steps alike, on a pendulum; round-off is far below."""
    model, steps = mechanisms.pendulum(angle=2.0), np.array([1 / 6, 1 / 7, 1 / 8, 1 / 10])
    exact = march(model, [0, 1.0], DOP853(rtol=1e-13, atol=1e-15)).x[-1]
    errors = [np.abs(march(model, [0, 1.0], DOP853(step=h)).x[-1] - exact).max() for h in steps]
    assert errors[-1] > 1e-9
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(8.0, abs=0.3)


@pytest.mark.slow
@pytest.mark.parametrize("loops", [2, 40])
def test_rows_of_four_bars_through_flat_positions(loops):
    """Ten seconds, ten positions in which all loops are singular at once."""
    times = np.linspace(0, 10, 21)
    run = march(mechanisms.n_four_bar(loops=loops), times, DOP853())
    theta, _ = row_of_four_bars(loops, times)
    assert run.code == m.DONE
    for k in (0, loops):
        place = run.node(f"B{k}") - [k, 0, 0]
        np.testing.assert_allclose(place[:, 0], np.sin(theta), atol=3e-8)
        np.testing.assert_allclose(place[:, 1], np.cos(theta), atol=3e-8)
    assert np.abs(run.energy - run.energy[0]).max() < 1e-9 * run.kinetic.max()
    flat = np.flatnonzero(np.diff(np.floor(row_of_four_bars(loops, np.linspace(0, 10, 20001))[0] / math.pi + 0.5)))
    passed = run.memory.passages[: run.count("passages_met")]
    np.testing.assert_allclose(passed[:, 0], np.linspace(0, 10, 20001)[flat], atol=1e-3)
    assert np.all(passed[:, 1] < 1e-3) and np.all(passed[:, 2] == 1.0)


@pytest.mark.slow
@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-12])
def test_flat_positions_at_other_tolerances(rtol):
    run = march(mechanisms.n_four_bar(loops=2), [0, 10.0], DOP853(rtol=rtol, atol=rtol / 10))
    theta, _ = row_of_four_bars(2, np.array([10.0]))
    assert run.code == m.DONE
    assert abs(run.node("B0")[-1, 0] - np.sin(theta[0])) < 300 * rtol + 1e-10


@pytest.mark.slow
def test_samples_do_not_change_the_run_and_chunks_are_the_run():
    """Bit for bit: many samples or few, one call or many, a new workspace in between."""
    times = np.linspace(0, 4, 81)
    whole = march(mechanisms.n_four_bar(loops=2), times, DOP853())
    ends = march(mechanisms.n_four_bar(loops=2), times[[0, -1]], DOP853())
    np.testing.assert_array_equal(whole.x[-1], ends.x[-1])
    parts = march(mechanisms.n_four_bar(loops=2), times, DOP853(), budgets=(1, 7, 3, 20, 1))
    for name in ("x", "v", "a", "N", "diagnostics"):
        np.testing.assert_array_equal(getattr(whole, name), getattr(parts, name))
    np.testing.assert_array_equal(resumed(times), whole.x)


def resumed(times):
    """Positions of a run of which nothing but the memory is kept every 10 samples."""
    method, found, kept = DOP853(), [], None
    for first in range(0, times.size, 10):
        _, eq, ws, told, memory, samples = prepared(mechanisms.n_four_bar(loops=2), times, method)
        memory = kept or memory
        last = min(first + 10, times.size)
        code, filled = integrate(eq, ws, no_force(), told, memory, samples.part(first, last), 10**9)
        assert (code, filled) == (m.DONE, last - first)
        kept = m.Memory.of(memory.arrays())
        found.append(samples.x[first:last])
    return np.concatenate(found).reshape(times.size, -1, 3)


def no_force():
    from kinetruss.kernels.structure.applied import no_force as nothing

    return nothing


def test_dense_output_lies_on_the_constraints():
    run = march(mechanisms.double_pendulum(), np.linspace(0, 3, 400), DOP853(rtol=1e-6, atol=1e-7))
    assert run.count("steps") < 120
    one, two = run.node("P1"), run.node("P2")
    np.testing.assert_allclose(np.hypot(*one.T[:2]), 1.0, atol=1e-14)
    np.testing.assert_allclose(np.hypot(*(two - one).T[:2]), 1.0, atol=1e-14)
    i, j = run.system.node_index("P1"), run.system.node_index("P2")
    relative = run.v[:, j] - run.v[:, i]
    np.testing.assert_allclose(np.einsum("tc,tc->t", relative, two - one), 0.0, atol=1e-12)


def test_time_reversal():
    """Back to the start with the velocities turned round, chaos and all."""
    model = mechanisms.double_pendulum()
    there = march(model, [0, 2.0], DOP853(rtol=1e-12, atol=1e-13))
    names = [n for n in model.nodes if n.startswith("P")]
    at = {n: tuple(there.node(n)[-1, :2]) for n in names}
    turned = {n: tuple(-there.v[-1, there.system.node_index(n), :2]) for n in names}
    back = march(model.with_(nodes={**model.nodes, **{n: model.nodes[n].with_(at=at[n]) for n in names}}, velocities=turned),
                 [0, 2.0], DOP853(rtol=1e-12, atol=1e-13))  # fmt: skip
    np.testing.assert_allclose(back.x[-1], there.x[0], atol=1e-9)


def coordinate_event(run_of, node, axis, value, direction=0, stop=False):
    return Watched(m.COORDINATE, 3 * run_of.node_index(node) + axis, 0, value, direction, stop)


@pytest.mark.slow
def test_events_are_found_and_stop():
    from kinetruss.mechanics import compile

    model = mechanisms.pendulum(angle=2.5)
    system = compile(model)
    through = coordinate_event(system, "P1", 0, 0.0)
    period = 4 * ellipk(math.sin(1.25) ** 2) / math.sqrt(G)
    run = march(model, [0, 4 * period], DOP853(), events=[through])
    events = run.memory.events[: run.count("events_met")]
    np.testing.assert_allclose(events[:, 1], period * (0.25 + 0.5 * np.arange(8)), atol=3e-9)
    assert list(events[:, 2]) == [-1, 1] * 4
    rising = coordinate_event(system, "P1", 0, 0.0, 1, True)
    run = march(model, np.linspace(0, 4 * period, 101), DOP853(), events=[through, rising])
    assert run.code == m.EVENT
    assert run.times[-1] == pytest.approx(0.75 * period, abs=1e-9)
    assert run.node("P1")[-1, 0] == pytest.approx(0.0, abs=1e-12)
    assert run.count("events_met") == 3 and run.done == 20


def test_event_of_a_force():
    """The string of a pendulum let go at 2.5 rad goes slack in the language of bars: its force changes its sign."""
    model = mechanisms.pendulum(angle=2.5)
    run = march(model, [0, 3.0], DOP853(), events=[Watched(m.FORCE, 0, 0, 0.0, 1, True)])
    assert run.code == m.EVENT and run.N[-1, 0] == pytest.approx(0.0, abs=1e-9)
    # m v^2/l = -m g cos(theta) and v^2 = 2 g l (cos theta - cos 2.5): cos theta = 2/3 cos 2.5
    assert math.cos(angle(run)[-1]) == pytest.approx(2 / 3 * math.cos(2.5), abs=1e-9)


def spring(stiffness, damping=0.0, mass=1.0, stretch=0.01):
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1 + stretch, 0), mass=mass)}, fixed={"O": "xy", "P": "y"},
        bars={"s": kt.Bar(ends=("O", "P"), kind="elastic", stiffness=stiffness, damping=damping, natural_length=1.0)},
    )  # fmt: skip


def test_oscillator_with_damping():
    run = march(spring(400.0, 2.0), np.linspace(0, 2, 41), DOP853(), isolated=False)
    w = math.sqrt(400.0 - 1.0)
    exact = 0.01 * np.exp(-run.times) * (np.cos(w * run.times) + np.sin(w * run.times) / w)
    np.testing.assert_allclose(run.node("P")[:, 0] - 1.0, exact, atol=1e-10)


def test_a_stiff_damper_is_noticed():
    run = march(spring(1.0, 1e7), [0, 10.0], DOP853(max_steps=20000), isolated=False)
    assert run.code == m.STIFF
    assert run.count("steps") < 300


@pytest.mark.slow
def test_energy_that_grows_without_cause_stops_the_run():
    @numba.cfunc(USER_FORCE)
    def push(t, x, v, f):
        f[3] += 5.0 * v[3]

    run = march(spring(100.0), np.linspace(0, 10, 1001), DOP853(), user=push.address)
    assert run.code == m.ENERGY_GROWS
    assert 0 < run.done < 20


@pytest.mark.slow
def test_not_a_number_stops_the_run():
    @numba.cfunc(USER_FORCE)
    def fails(t, x, v, f):
        if t > 0.5:
            f[3] = math.nan

    run = march(spring(100.0), np.linspace(0, 1, 101), DOP853(), user=fails.address, isolated=False)
    assert run.code == m.NOT_FINITE
    assert 40 < run.done <= 51
    assert np.all(np.isfinite(run.x))


def test_too_many_steps():
    run = march(mechanisms.pendulum(), np.linspace(0, 10, 11), DOP853(max_steps=20))
    assert run.code == m.TOO_MANY_STEPS and run.count("steps") + run.count("rejected") == 20
