"""Radau IIA: its coefficients, order 5, closed forms of stiff bars, errors that follow the tolerance, constraints, events."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.kernels.integrate import radau_matrices as table, state as m
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, Radau
from reference.marching import march

G = 9.81


def tight(step):
    """Fixed steps whose stages are solved to round-off."""
    return Radau(rtol=1e-13, atol=1e-14, step=step)


def controlled(rtol):
    return Radau(rtol=rtol, atol=0.1 * rtol)


def line(stiffness, damping, *, mass=1.0, at=1.0, speed=0.0):
    """A mass on a line with a spring and damper of natural length 1 m to the ground."""
    bar = kt.Bar(ends=("O", "A"), kind="elastic", stiffness=stiffness, damping=damping, natural_length=1.0)
    nodes = {"O": (0, 0), "A": kt.Node(at=(at, 0), mass=mass)}
    return kt.Model(nodes=nodes, bars={"s": bar}, fixed={"O": "xy", "A": "y"}, velocities={"A": (speed, 0)})


def swinging(stiffness, damping=0.0):
    """A double pendulum whose first bar is elastic."""
    spring = kt.Bar(ends=("O", "P"), kind="elastic", stiffness=stiffness, damping=damping, natural_length=1.0)
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1, 0), mass=1.0), "Q": kt.Node(at=(2, 0), mass=1.0)}, fixed=["O"], gravity=(0, -G),
        bars={"a": spring, "b": kt.Bar(ends=("P", "Q"), mass=0.2)},
    )  # fmt: skip


# coefficients


def test_the_quadrature_is_of_order_5_and_the_stages_of_order_3():
    A, c = table.A, table.NODES
    for k in range(1, 6):
        assert A[2] @ c ** (k - 1) == pytest.approx(1 / k, abs=1e-15)
    for k in range(1, 4):
        np.testing.assert_allclose(A @ c ** (k - 1), c**k / k, atol=1e-15)
    for k in range(1, 3):
        np.testing.assert_allclose((A[2] * c ** (k - 1)) @ A, A[2] * (1 - c**k) / k, atol=1e-15)


def test_eigenvectors_take_the_coefficients_apart():
    z = table.TURNED
    block = np.array([[table.REAL, 0, 0], [0, z.real, -z.imag], [0, z.imag, z.real]])
    np.testing.assert_allclose(table.RIGHT @ table.LEFT, np.eye(3), atol=1e-14)
    np.testing.assert_allclose(table.RIGHT @ block @ table.LEFT, table.A, atol=1e-14)


def test_the_error_vanishes_on_polynomials_up_to_degree_3():
    for k in range(4):
        start = table.REAL * (k == 1)
        assert start + table.E @ (table.NODES**k - (k == 0)) == pytest.approx(0.0, abs=1e-14)
    assert abs(table.E @ table.NODES**4) > 1e-3


def test_it_forgets_what_is_infinitely_fast():
    """Stability at infinity: R = 1 - b A^-1 1 = 0."""
    assert 1 - table.A[2] @ np.linalg.solve(table.A, np.ones(3)) == pytest.approx(0.0, abs=1e-13)


# order, accuracy


@pytest.mark.slow
@pytest.mark.parametrize("model", [mechanisms.double_pendulum(), swinging(1e4, 50.0)], ids=["rigid", "stiff"])
def test_errors_follow_the_tolerance(model):
    """h ~ rtol^(1/6), so the error is as rtol^(5/6) where the order is 5, as rtol^(2/3) where stiff parts reduce it to 4."""
    times = np.linspace(0, 1, 21)
    exact = march(model, times, DOP853(rtol=1e-13, atol=1e-14), isolated=False)
    tolerances = np.array([1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9])
    errors = np.array([np.abs(march(model, times, controlled(rtol), isolated=False).x - exact.x).max() for rtol in tolerances])
    assert (errors < 20 * tolerances).all()
    slope = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    assert 0.65 < slope < 0.95


@pytest.mark.slow
def test_andrews_as_by_series():
    tasks = {"motor": kt.GivenForce(torque=mechanisms.ANDREWS_TORQUE)}
    one, two = (
        kt.dynamics.simulate(mechanisms.andrews(), 0.03, samples=31, tasks=tasks, method=method)
        for method in (kt.Taylor(rtol=1e-13, atol=1e-15), controlled(1e-11))
    )
    np.testing.assert_allclose(two.motion.position.values, one.motion.position.values, atol=1e-10)
    force = one.forces.member_force.values
    np.testing.assert_allclose(two.forces.member_force.values, force, atol=1e-6 * np.abs(force).max())


# stiff


@pytest.mark.slow
def test_a_damper_that_forgets_at_once_costs_nothing():
    """m x'' + c x' + k x = 0 with c >> sqrt(k m): the slow root is all that is seen after the first moment."""
    k, c, t = 1e4, 1e6, np.linspace(0, 100, 51)
    fast, slow = (-c - s * math.sqrt(c * c - 4 * k) for s in (1, -1))
    slow = 2 * k / fast  # the same root without cancellation
    fast /= 2
    x = 0.2 * (fast * np.exp(slow * t) - slow * np.exp(fast * t)) / (fast - slow)
    run = march(line(k, c, at=1.2), t, controlled(1e-8), isolated=False)
    np.testing.assert_allclose(run.node("A")[:, 0], 1 + x, atol=1e-8)
    assert run.count("steps") < 150


@pytest.mark.slow
def test_prothero_and_robinson():
    """m x'' + c x' + k (x - 1) = F with F such that x = 1 + sin(t)/10: the solution is smooth however stiff the bar is."""
    t, steps = np.linspace(0, 10, 101), []
    for k in (1e2, 1e6, 1e10):
        c = 2 * math.sqrt(k)

        def force(t, x, v, k=k, c=c):
            return {"A": (0.1 * ((k - 1) * math.sin(t) + c * math.cos(t)), 0.0)}

        run = kt.dynamics.simulate(line(k, c, speed=0.1), times=t, user_force=force, method=controlled(1e-8))
        np.testing.assert_allclose(run.motion.position.sel(node="A", axis="x").values, 1 + 0.1 * np.sin(t), atol=2e-8)
        steps.append(int(run.data.steps[-1]))
    assert max(steps) < 400


@pytest.mark.slow
def test_a_stiff_bar_that_turns_costs_nothing():
    """E A/l of a steel bar: 1e8 N/m on 1 kg, damped. Its motion is that of a rigid one but for the 1e-6 m that it gives."""
    times = np.linspace(0, 2, 21)
    run = march(swinging(1e8, 1e3), times, controlled(1e-6), isolated=False)
    rigid = swinging(1e8)
    exact = march(rigid.with_(bars={**rigid.bars, "a": kt.Bar(ends=("O", "P"))}), times, DOP853())
    np.testing.assert_allclose(run.x, exact.x, atol=1e-4)
    assert run.count("steps") + run.count("rejected") < 1000
    assert run.count("newtons") < 6 * (run.count("steps") + run.count("rejected"))


# constraints, dense output, events


# what models hold


def driven():
    """A crank at a given rate, with a spring and damper from its coupler, and a brace that is redundant."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.1), "C": (0.3, 0.25), "D": (0.4, 0), "E": kt.Node(at=(0.3, 0.6), mass=0.5)},
        fixed=["A", "D"], gravity=(0, -G), drives={"motor": kt.AngleDrive("crank")},
        bars={"crank": kt.Bar(ends=("A", "B"), mass=0.2), "coupler": kt.Bar(ends=("B", "C"), mass=0.5),
              "rocker": kt.Bar(ends=("C", "D"), mass=0.4), "twin": kt.Bar(ends=("C", "D"), mass=0.4),
              "hanger": kt.Bar(ends=("C", "E"), kind="elastic", stiffness=2e5, damping=50.0, mass=0.1, strain="green")},
        trajectories={"turn": kt.ConstantRate(rates={"motor": 10.0}, duration=0.6)},
    )  # fmt: skip


def tethered():
    """A weight that falls into a cable, swings on it, and pulls it tight again; a node without mass in between."""
    return kt.Model(
        nodes={"O": (0, 0), "M": (0.5, 0.3), "P": kt.Node(at=(1, 0), mass=1.0), "Q": kt.Node(at=(1.6, 0), mass=0.5)},
        fixed=["O"],
        bars={"one": kt.Bar(ends=("O", "M"), mass=0), "two": kt.Bar(ends=("M", "P"), mass=0),
              "through": kt.Bar(ends=("O", "P"), mass=0),
              "cable": kt.Bar(ends=("P", "Q"), kind="cable", stiffness=2e3, damping=5.0, natural_length=0.7)},
        gravity=(0, -G),
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("solver", ["dense", "sparse"])
def test_drives_redundant_bars_and_greens_strain(solver):
    one, two = (
        kt.dynamics.simulate(driven(), 0.6, samples=31, trajectory="turn", method=method)
        for method in (kt.DOP853(rtol=1e-12, atol=1e-13), Radau(rtol=1e-9, atol=1e-10, solver=solver))
    )
    np.testing.assert_allclose(two.motion.position.values, one.motion.position.values, atol=1e-7)
    np.testing.assert_allclose(two.motion.velocity.values, one.motion.velocity.values, atol=1e-5)


@pytest.mark.slow
def test_membranes_of_small_elements():
    """A square membrane under its weight, held at its corners: the fastest vibration asks for most of the explicit steps."""
    n = 3
    places = {f"N{i}{j}": kt.Node(at=(0.1 * i, 0.1 * j, 0.0), mass=0.01) for i in range(n) for j in range(n)}
    elements = [(f"N{i}{j}", f"N{i + 1}{j}", f"N{i}{j + 1}") for i in range(n - 1) for j in range(n - 1)]
    elements += [(f"N{i + 1}{j}", f"N{i + 1}{j + 1}", f"N{i}{j + 1}") for i in range(n - 1) for j in range(n - 1)]
    model = kt.Model(
        nodes=places,
        fixed=["N00", "N02", "N20", "N22"],
        materials={"rubber": kt.Material(E=2e6, density=1000.0, poisson=0.45)},
        membranes={"skin": kt.Membrane(elements=elements, thickness=1e-3, material="rubber")},
        gravity=(0, 0, -G),
    )
    one, two = (
        kt.dynamics.simulate(model, 0.1, samples=11, method=method)
        for method in (kt.DOP853(rtol=1e-11, atol=1e-12), controlled(1e-7))
    )
    np.testing.assert_allclose(two.motion.position.values, one.motion.position.values, atol=1e-6)
    assert int(two.data.steps[-1]) < int(one.data.steps[-1])


@pytest.mark.slow
def test_a_cable_that_tightens():
    one, two = (
        kt.dynamics.simulate(tethered(), 1.0, samples=31, method=method)
        for method in (kt.DOP853(rtol=1e-11, atol=1e-12), controlled(1e-7))
    )
    np.testing.assert_allclose(two.motion.position.values, one.motion.position.values, atol=1e-5)


@pytest.mark.slow
def test_what_is_refused_is_refused_before_any_work():
    with pytest.raises(InputError, match="Take the method DOP853 without a step"):
        kt.dynamics.simulate(
            kt.read(kt.library.example_files()["driven_bay"][0]), 0.1,
            tasks={"M7": kt.StepInput(voltage=1.0)}, method=Radau(),
        )  # fmt: skip
    for wrong in ({"rtol": 0}, {"atol": -1.0}, {"rho": 0.5}):
        with pytest.raises(kt.errors.ModelError):
            Radau(**wrong)


def test_a_step_that_does_not_settle_is_said():
    run = march(swinging(1e8, 1e3), [0, 10.0], tight(5.0), isolated=False)
    assert run.code in (m.NOT_CONVERGED, m.NOT_FINITE)
