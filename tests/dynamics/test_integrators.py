"""What every method of integration must do: closed forms, order, tolerance, events, singular positions, calls in parts.

A method of its own adds a row to METHODS; what one method alone has (coefficients, Newton's method, series) is in the files
`test_integrators_*`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np
import pytest
from scipy.special import ellipj, ellipk

import kinetruss as kt
from kinetruss.dynamics.integrators import Watched, integrate
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.structure.applied import USER_FORCE, no_force
from kinetruss.library import mechanisms
from kinetruss.results import Status
from reference.linkages import row_of_four_bars
from reference.marching import march, prepared
from spring_models import elastic

G = 9.81
TIGHT = kt.DOP853(rtol=1e-13, atol=1e-15)


@dataclass(frozen=True)
class Method:
    """usual : as most would take it; its error at 1 m and 1 s is about `error`. fixed(h) : all steps alike, whose order is
    `order`. controlled(rtol) : None where steps are not chosen; errors are as rtol to the power `follows`.
    """

    usual: Any
    error: float
    fixed: Callable[[float], Any]
    order: int
    controlled: Callable[[float], Any] | None = None
    follows: float = 1.0


METHODS = {
    "dop853": Method(kt.DOP853(), 2e-9, lambda h: kt.DOP853(step=h), 8, lambda rtol: kt.DOP853(rtol=rtol, atol=rtol / 10)),
    "taylor": Method(
        kt.Taylor(), 2e-9, lambda h: kt.Taylor(order=6, step=h), 6, lambda rtol: kt.Taylor(rtol=rtol, atol=rtol / 10)
    ),
    "radau": Method(
        kt.Radau(rtol=1e-10, atol=1e-11), 2e-9, lambda h: kt.Radau(rtol=1e-13, atol=1e-14, step=h), 5,
        lambda rtol: kt.Radau(rtol=rtol, atol=rtol / 10), 5 / 6,
    ),
    "energy_momentum": Method(kt.EnergyMomentum(5e-4), 4e-5, kt.EnergyMomentum, 2),
    "generalized_alpha": Method(kt.GeneralizedAlpha(5e-4), 4e-5, kt.GeneralizedAlpha, 2),
    "rattle": Method(kt.Rattle(5e-4), 4e-5, kt.Rattle, 2),
}  # fmt: skip
FIXED = ["energy_momentum", "generalized_alpha", "rattle"]
every = pytest.mark.parametrize("name", METHODS)
controlled = pytest.mark.parametrize("name", [name for name, one in METHODS.items() if one.controlled])
FLEXIBLE = [name for name in METHODS if name != "taylor"]
"""Methods for any force: a series needs one that it knows."""


def spring(stiffness=400.0, damping=2.0, at=1.01):
    """1 kg on a line, with a spring and damper of 1 m to the ground."""
    bar = kt.Bar(ends=("O", "P"), kind="elastic", stiffness=stiffness, damping=damping, natural_length=1.0)
    return kt.Model(nodes={"O": (0, 0), "P": kt.Node(at=(at, 0), mass=1.0)}, bars={"s": bar}, fixed={"O": "xy", "P": "y"})


def swing(times, amplitude):
    """Angle and rate of a pendulum of 1 m let go at `amplitude`: sin(theta/2) = k sn(K - w t)."""
    k, w = math.sin(amplitude / 2), math.sqrt(G)
    sn, cn, _, _ = ellipj(ellipk(k * k) - w * np.asarray(times), k * k)
    return 2 * np.arcsin(k * sn), -2 * k * w * cn


def angle(run, node="P1"):
    x = run.node(node)
    return np.arctan2(x[:, 0], -x[:, 1])


# closed forms


@pytest.mark.slow
@every
def test_a_pendulum_is_as_elliptic_functions_say(name):
    one, times = METHODS[name], np.linspace(0, 5, 101)
    run = march(mechanisms.pendulum(angle=2.5), times, one.usual, isolated=one.controlled is not None)
    assert run.code == m.DONE and run.done == 101
    theta, rate = swing(times, 2.5)
    np.testing.assert_allclose(angle(run), theta, atol=2 * one.error)
    # tension of the massless bar: centripetal force and weight of the bob
    np.testing.assert_allclose(run.N[:, 0], rate**2 + G * np.cos(theta), atol=100 * one.error)
    if one.controlled:
        assert np.ptp(run.energy) < 1e-9 * run.kinetic.max()
        assert run.count("steps") < 1000
    else:
        assert run.count("steps") == 10000


@pytest.mark.slow
@every
def test_a_damped_oscillator_is_as_its_closed_form_says(name):
    """x = e^(-d t) (cos w t + d/w sin w t), d = c/2m, w^2 = k/m - d^2; its energy falls with it."""
    one, t = METHODS[name], np.linspace(0, 2, 41)
    run = march(spring(), t, one.usual, isolated=False)
    w = math.sqrt(400.0 - 1.0)
    x = 0.01 * np.exp(-t) * (np.cos(w * t) + np.sin(w * t) / w)
    v = -0.01 * np.exp(-t) * 400.0 / w * np.sin(w * t)
    np.testing.assert_allclose(run.node("P")[:, 0] - 1.0, x, atol=one.error)
    np.testing.assert_allclose(run.energy, 0.5 * v**2 + 200.0 * x**2, atol=10 * one.error)


# order and tolerance


def slope(model, span, method, steps, name="x", isolated=True):
    """Order in which the end converges with these steps."""
    exact = getattr(march(model, [0, span], TIGHT, isolated=False), name)[-1]
    errors = [np.abs(getattr(march(model, [0, span], method(h), isolated=isolated), name)[-1] - exact).max() for h in steps]
    assert errors[-1] > 1e-11
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


ORDERS = {
    "pendulum": (mechanisms.pendulum(angle=2.0), 1.0),
    "rigid": (mechanisms.double_pendulum(), 0.5),
    "damped": (elastic(damping=1.0), 0.5),
    "green": (elastic(strain="green"), 0.5),
}
STEPS = {
    "dop853": {"pendulum": (6, 7, 8, 10), "rigid": (5, 6, 7, 8), "elastic": (12, 14, 16, 18)},
    "taylor": {"pendulum": (16, 24, 32), "rigid": (10, 15, 20), "elastic": (20, 30, 40)},
    "radau": {"pendulum": (40, 80, 160), "rigid": (20, 40, 80), "elastic": (40, 80, 160)},
    **dict.fromkeys(FIXED, dict.fromkeys(("pendulum", "rigid", "elastic"), (125, 250, 500))),
}
"""Numbers of steps, between those that are too few for the order to be seen and round-off."""
NEAR = {"dop853": (0.3, 1.0), "taylor": (0.4, 0.6), "radau": (0.35, 0.35), **dict.fromkeys(FIXED, (0.1, 0.1))}
"""How near to the order, of a pendulum and of other models."""


@pytest.mark.slow
@pytest.mark.parametrize("which", ORDERS)
@every
def test_the_error_falls_with_the_order(name, which):
    (model, span), one = ORDERS[which], METHODS[name]
    steps = span / np.array(STEPS[name].get(which, STEPS[name]["elastic"]))
    for quantity in "xv":
        found = slope(model, span, one.fixed, steps, quantity, False)
        assert found == pytest.approx(one.order, abs=NEAR[name][which != "pendulum"])


@pytest.mark.slow
@pytest.mark.parametrize("name", FIXED)
def test_forces_converge_with_the_order_too(name):
    steps = np.array([2e-3, 1e-3])
    assert slope(mechanisms.double_pendulum(), 1.0, METHODS[name].fixed, steps, "N", False) == pytest.approx(2.0, abs=0.15)


@pytest.mark.slow
@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8, 1e-10, 1e-12])
@controlled
def test_errors_follow_the_tolerance(name, rtol):
    one, times = METHODS[name], np.linspace(0, 5, 101)
    run = march(mechanisms.pendulum(angle=2.5), times, one.controlled(rtol))
    theta, rate = swing(times, 2.5)
    assert np.abs(angle(run) - theta).max() < 60 * rtol**one.follows
    assert np.abs(run.N[:, 0] - rate**2 - G * np.cos(theta)).max() < 1000 * rtol**one.follows


@pytest.mark.slow
@every
def test_the_way_back_ends_at_the_start(name):
    """With velocities turned round, chaos and all; to round-off for RATTLE, which is symmetric."""
    one, model = METHODS[name], mechanisms.double_pendulum()
    method = one.controlled(1e-12) if one.controlled else one.fixed(2e-3)
    there = march(model, [0, 1.0], method, isolated=False)
    names = [node for node in model.nodes if node.startswith("P")]
    nodes = {node: model.nodes[node].with_(at=tuple(there.node(node)[-1, :2])) for node in names}
    turned = {node: tuple(-there.v[-1, there.system.node_index(node), :2]) for node in names}
    back = march(model.with_(nodes={**model.nodes, **nodes}, velocities=turned), [0, 1.0], method, isolated=False)
    # the start of the way back is put onto the constraints
    least = {"rattle": 1e-9, "energy_momentum": 1e-3, "generalized_alpha": 1e-3}.get(name, 1e-9)
    assert np.abs(back.x[-1] - there.x[0]).max() < least


# samples, constraints, calls in parts


@pytest.mark.slow
@pytest.mark.parametrize("model", [mechanisms.n_four_bar(loops=2), elastic(damping=0.5)], ids=["singular", "damped"])
@every
def test_samples_and_calls_do_not_change_the_run(name, model):
    """Bit for bit: many samples or few, one call or many, and of a run of which nothing but its memory is kept."""
    one, times = METHODS[name], np.linspace(0, 1, 41)
    method = one.controlled(1e-7) if one.controlled else one.fixed(3e-3)
    whole = march(model, times, method, isolated=False)
    np.testing.assert_array_equal(march(model, times[[0, -1]], method, isolated=False).x[-1], whole.x[-1])
    parts = march(model, times, method, budgets=(1, 7, 3, 20, 1), isolated=False)
    for quantity in ("x", "v", "a", "N", "diagnostics"):
        np.testing.assert_array_equal(getattr(whole, quantity), getattr(parts, quantity))
    np.testing.assert_array_equal(resumed(model, times, method), whole.x)


def resumed(model, times, method):
    """Positions of a run of which nothing but the memory is kept every 10 samples."""
    found, kept = [], None
    for first in range(0, times.size, 10):
        _, eq, ws, told, memory, samples = prepared(model, times, method, isolated=False)
        memory = kept or memory
        last = min(first + 10, times.size)
        code, filled = integrate(eq, ws, no_force, told, memory, samples.part(first, last), 10**9)
        assert (code, filled) == (m.DONE, last - first)
        kept = m.Memory.of(memory.arrays())
        found.append(samples.x[first:last])
    return np.concatenate(found).reshape(times.size, -1, 3)


@pytest.mark.slow
@every
def test_samples_lie_on_the_constraints(name):
    one = METHODS[name]
    method = one.controlled(1e-6) if one.controlled else one.fixed(1e-2)
    run = march(mechanisms.double_pendulum(), np.linspace(0, 1, 400), method, isolated=False)
    assert run.count("steps") < 120
    places, rates = run.x[:, run.system.q] - run.x[:, run.system.p], run.v[:, run.system.q] - run.v[:, run.system.p]
    np.testing.assert_allclose(np.linalg.norm(places, axis=2), 1.0, atol=1e-13)
    # the midpoint rule's own velocities at ends of steps, of which the last sample is one, keep energy and momenta instead
    within = slice(None, -1 if name == "energy_momentum" else None)
    np.testing.assert_allclose(np.einsum("tmc,tmc->tm", rates, places)[within], 0.0, atol=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("model", [mechanisms.double_pendulum(), mechanisms.n_four_bar(loops=2)], ids=["pendulum", "loops"])
@every
def test_constraints_hold_to_round_off_behind_every_step(name, model):
    one = METHODS[name]
    method = one.controlled(1e-4) if one.controlled else one.fixed(1e-2)
    system, eq, ws, told, memory, samples = prepared(model, [0.0, 1.0], method, isolated=False)
    free, nf, code, steps, first = eq.free, len(eq.free), m.PAUSED, 0, 0
    rigid = np.linalg.norm(system.x0[system.q] - system.x0[system.p], axis=1)
    while code == m.PAUSED:
        code, filled = integrate(eq, ws, no_force, told, memory, samples.part(first), 1)
        first, steps = first + filled, steps + 1
        x, v = system.x0.reshape(-1).astype(float), np.zeros(system.x0.size)
        x[free], v[free] = memory.y[0, :nf], memory.y[0, nf : 2 * nf]
        d, w = (y.reshape(-1, 3)[system.q] - y.reshape(-1, 3)[system.p] for y in (x, v))
        np.testing.assert_allclose(np.linalg.norm(d, axis=1), rigid, rtol=1e-12)
        if name not in ("energy_momentum", "generalized_alpha"):  # whose velocities at ends of steps are not on constraints
            np.testing.assert_allclose(np.einsum("ij,ij->i", d, w) / rigid, 0.0, atol=1e-11 * max(1.0, np.abs(v).max()))
    assert code == m.DONE and steps > 5


@pytest.mark.slow
@controlled
def test_samples_are_as_good_as_ends(name):
    model, many = mechanisms.double_pendulum(), np.linspace(0, 1, 401)
    exact, run = (march(model, many, method) for method in (TIGHT, METHODS[name].controlled(1e-7)))
    assert run.count("steps") < 100
    for quantity, close in (("x", 1e-6), ("v", 1e-5), ("a", 1e-4)):
        np.testing.assert_allclose(getattr(run, quantity), getattr(exact, quantity), atol=close)


# events and singular positions


def through(system, node="P1", axis=0, direction=0, stop=False):
    return Watched(m.COORDINATE, 3 * system.node_index(node) + axis, 0, 0.0, direction, stop)


@pytest.mark.slow
@every
def test_events_are_found_in_both_directions_and_stop(name):
    one, model = METHODS[name], mechanisms.pendulum(angle=2.5)
    system = kt.mechanics.compile(model)
    period = 4 * ellipk(math.sin(1.25) ** 2) / math.sqrt(G)
    run = march(model, [0, 2 * period], one.usual, events=[through(system)], isolated=False)
    events = run.memory.events[: run.count("events_met")]
    np.testing.assert_allclose(events[:, 1], period * (0.25 + 0.5 * np.arange(4)), atol=2 * one.error)
    assert list(events[:, 2]) == [-1, 1] * 2
    rising = through(system, direction=1, stop=True)
    run = march(model, np.linspace(0, 2 * period, 51), one.usual, events=[through(system), rising], isolated=False)
    assert run.code == m.EVENT
    assert run.times[-1] == pytest.approx(0.75 * period, abs=2 * one.error)
    assert run.node("P1")[-1, 0] == pytest.approx(0.0, abs=1e-9)
    assert run.count("events_met") == 3 and run.done == 20


@pytest.mark.slow
@every
def test_an_event_of_a_force(name):
    """The bar of a pendulum let go at 2.5 rad carries nothing where cos theta = 2/3 cos 2.5: m v^2/l = -m g cos(theta)."""
    run = march(
        mechanisms.pendulum(angle=2.5),
        [0, 3.0],
        METHODS[name].usual,
        events=[Watched(m.FORCE, 0, 0, 0.0, 1, True)],
        isolated=False,
    )
    assert run.code == m.EVENT and run.N[-1, 0] == pytest.approx(0.0, abs=100 * METHODS[name].error)
    assert math.cos(angle(run)[-1]) == pytest.approx(2 / 3 * math.cos(2.5), abs=10 * METHODS[name].error)


@pytest.mark.slow
@pytest.mark.parametrize("loops", [1, 2, 3])
@every
def test_singular_positions_are_passed_and_listed(name, loops):
    """All loops of a row of four-bars are singular at once where it lies flat."""
    model, one = mechanisms.n_four_bar(loops=loops), METHODS[name]
    method, close = (one.controlled(1e-8), 1e-6) if one.controlled else (one.fixed(1e-3), 2e-3)
    run = kt.dynamics.simulate(model, 3.0, samples=31, method=method)
    t = np.linspace(0, 3, 20001)
    theta = row_of_four_bars(loops, t)[0]
    flat = t[np.flatnonzero(np.diff(np.floor(theta / math.pi + 0.5)))]
    assert run.status is Status.COMPLETED and len(flat) > 1
    assert [p.time for p in run.passages] == pytest.approx(flat, abs=1e-3 if one.controlled else 5e-3)
    assert all(p.certain for p in run.passages) or not one.controlled
    for k in (0, loops):
        place = run.motion.position.sel(node=f"B{k}").values - [k, 0]
        exact = row_of_four_bars(loops, run.time.values)[0]
        np.testing.assert_allclose(place, np.stack([np.sin(exact), np.cos(exact)], axis=1), atol=close)
    if not one.controlled:
        coarse = kt.dynamics.simulate(model, 3.0, samples=4, method=one.fixed(5e-3))
        assert [p.time for p in coarse.passages] == pytest.approx(flat, abs=2.5e-2)


# what ends a run


@pytest.mark.slow
@pytest.mark.parametrize("name", FLEXIBLE)
def test_what_is_no_number_ends_the_run(name):
    @numba.cfunc(USER_FORCE)
    def fails(t, x, v, f):
        if t > 0.5:
            f[3] = math.nan

    run = march(spring(100.0, 0.0), np.linspace(0, 1, 101), METHODS[name].usual, user=fails.address, isolated=False)
    assert run.code == m.NOT_FINITE
    assert 40 < run.done <= 51
    assert np.all(np.isfinite(run.x))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["dop853", "radau"])
def test_energy_that_grows_without_cause_ends_the_run(name):
    @numba.cfunc(USER_FORCE)
    def push(t, x, v, f):
        f[3] += 5.0 * v[3]

    run = march(spring(100.0, 0.0), np.linspace(0, 10, 1001), METHODS[name].usual, user=push.address)
    assert run.code == m.ENERGY_GROWS
    assert 0 < run.done < 20


@controlled
def test_too_many_steps_end_the_run(name):
    one = METHODS[name]
    run = march(mechanisms.pendulum(), np.linspace(0, 10, 11), one.usual.with_(max_steps=20))
    assert run.code == m.TOO_MANY_STEPS and run.count("steps") + run.count("rejected") == 20


@pytest.mark.slow
@pytest.mark.parametrize("sprung", [False, True])
@every
def test_what_rests_without_energy_goes_on_resting(name, sprung):
    """A body held by its corner, without weight, motion or strain: round-off is no growth of energy."""
    model = kt.library.bodies.box(
        kt.Model(nodes={"O": (0, 0, 0), "W": (0, 0, 2)}, fixed=["O", "W"]), "b", (1, 0.5, 0.3), mass=1.0, at=(0.5, 0, 0),
        nodes=["O"],
    )  # fmt: skip
    if sprung:
        model = model.with_(bars={**model.bars, "spring": kt.Bar(ends=("W", "b.1"), kind="elastic", stiffness=10.0)})
    one = METHODS[name]
    run = kt.dynamics.simulate(model, 0.05, samples=3, method=one.usual if one.controlled else one.fixed(1e-3))
    assert run.status is Status.COMPLETED
    assert not run.message
    assert np.ptp(run.motion.position.values, axis=0).max() < 1e-12
