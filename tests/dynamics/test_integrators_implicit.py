"""Energy-momentum midpoint rule, generalised alpha, RATTLE: order, what they keep, stiff bars, chunks."""

from __future__ import annotations

import numba
import numpy as np
import pytest

import kinetruss as kt
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.fixed_steps import secant
from kinetruss.kernels.structure.laws import bar_tension, law_energy
from kinetruss.library import mechanisms
from kinetruss.mechanics import CABLE, ENGINEERING, GREEN
from kinetruss.model import DOP853, EnergyMomentum, GeneralizedAlpha, Rattle
from reference.marching import march
from spring_models import elastic

G = 9.81


@pytest.mark.slow
def test_energy_of_a_chaotic_double_pendulum():
    run = march(mechanisms.double_pendulum(), np.linspace(0, 200, 401), EnergyMomentum(2e-3))
    assert run.count("steps") == 100000
    assert np.abs(run.energy - run.energy[0]).max() < 1e-10 * run.kinetic.max()


@pytest.mark.slow
@pytest.mark.parametrize("kind, strain", [("elastic", "engineering"), ("elastic", "green"), ("cable", "engineering")])
def test_energy_with_springs(kind, strain):
    run = march(elastic(kind, strain), np.linspace(0, 20, 201), EnergyMomentum(5e-3))
    assert run.code == m.DONE
    assert np.abs(run.energy - run.energy[0]).max() < 1e-9 * run.kinetic.max()


@pytest.mark.slow
def test_momenta_of_a_free_triangle():
    """No support, no gravity: linear and angular momentum to round-off."""
    model = kt.Model(
        nodes={"A": kt.Node(at=(0, 0, 0), mass=1.0), "B": kt.Node(at=(1, 0, 0), mass=2.0),
               "C": kt.Node(at=(0.3, 0.8, 0.2), mass=1.5)},
        bars={"ab": kt.Bar(ends=("A", "B"), mass=1.0), "bc": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=500.0, mass=0.5),
              "ca": kt.Bar(ends=("C", "A"), mass=0.7)},
        velocities={"A": (0.1, -0.4, 0.8), "B": (0.1, 1.0, -0.5), "C": (-0.3, 0.2, 1.2)},
    )  # fmt: skip
    run = march(model, np.linspace(0, 10, 101), EnergyMomentum(5e-3))
    mass = np.zeros((3, 3))
    for (i, j), bar in (((0, 1), 1.0), ((1, 2), 0.5), ((2, 0), 0.7)):
        mass[np.ix_([i, j], [i, j])] += bar / 6 * np.array([[2, 1], [1, 2]])
    mass += np.diag([1.0, 2.0, 1.5])
    p = np.einsum("ij,tjc->tic", mass, run.v)
    np.testing.assert_allclose(p.sum(1) - p[0].sum(0), 0.0, atol=1e-11)
    spin = np.cross(run.x, p).sum(1)
    np.testing.assert_allclose(spin - spin[0], 0.0, atol=1e-10)
    assert np.ptp(run.energy) < 1e-10 * run.kinetic.max()


@pytest.mark.slow
def test_secant_does_exactly_the_work_that_is_stored():
    rng = np.random.default_rng(1)

    @numba.njit
    def found(law, k, l0, L0, L1):
        work = secant(law, k, l0, 0.0, L0, L1, 0.1) * (L1**2 - L0**2) / 2
        stored = law_energy(law, k, l0, L1) - law_energy(law, k, l0, L0)
        still = secant(law, k, l0, 0.0, L0, L0, 0.1), bar_tension(law, k, l0, 0.0, L0, 0.0) / L0
        return work, stored, still, secant(law, k, l0, 2.0, L0, L1, 0.1) * (L1 - L0), 2 * work / (L0 + L1)

    for law in (ENGINEERING, GREEN, CABLE):
        for _ in range(200):
            k, l0, L0, L1 = rng.uniform(1, 5), 1.0, rng.uniform(0.8, 1.3), rng.uniform(0.8, 1.3)
            work, stored, still, damped, undamped = found(law, k, l0, L0, L1)
            assert work == pytest.approx(stored, abs=1e-14)
            assert still[0] == pytest.approx(still[1], abs=1e-12)
            assert damped >= undamped - 1e-12


@pytest.mark.slow
def test_rattle_keeps_energy_near_for_long():
    run = march(mechanisms.pendulum(angle=2.0), np.linspace(0, 200, 2001), Rattle(5e-3), isolated=False)
    assert np.abs(run.energy - run.energy[0]).max() < 1e-3 * run.kinetic.max()
    first, last = run.energy[:200].mean(), run.energy[-200:].mean()
    assert abs(last - first) < 2e-5 * run.kinetic.max()


def stiff(stiffness):
    """A swinging rod of two halves on a stiff spring."""
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1, 0), mass=1.0), "Q": kt.Node(at=(2, 0), mass=1.0)}, fixed=["O"], gravity=(0, -G),
        bars={"a": kt.Bar(ends=("O", "P"), kind="elastic", stiffness=stiffness), "b": kt.Bar(ends=("P", "Q"), mass=0.2)},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("method", [EnergyMomentum(2e-3), GeneralizedAlpha(2e-3, rho=0.8)])
def test_a_stiff_bar_costs_nothing(method):
    """E A/l of a steel bar: 1e8 N/m on 1 kg; its motion is that of a rigid one."""
    run = march(stiff(1e8), np.linspace(0, 2, 21), method, isolated=False)
    assert run.code == m.DONE
    assert run.count("newtons") < 12 * run.count("steps")
    rigid = stiff(1e8)
    rigid = rigid.with_(bars={**rigid.bars, "a": kt.Bar(ends=("O", "P"))})
    exact = march(rigid, np.linspace(0, 2, 21), DOP853())
    np.testing.assert_allclose(run.x, exact.x, atol=1e-3)


def test_generalised_alpha_damps_what_is_fast():
    """A bar that rings at 1e4 rad/s, stretched at the start by 1 mm: alpha has quietened it, the midpoint rule keeps it."""
    model = stiff(1e8)
    spring = kt.Bar(ends=("O", "P"), kind="elastic", stiffness=1e8, natural_length=1.0)
    nodes = {"O": model.nodes["O"], "P": kt.Node(at=(1.001, 0), mass=1.0), "Q": kt.Node(at=(2.001, 0), mass=1.0)}
    model = model.with_(nodes=nodes, bars={**model.bars, "a": spring})
    stretch = {}
    for method in (GeneralizedAlpha(1e-3, rho=0.7), EnergyMomentum(1e-3)):
        run = march(model, np.linspace(0, 0.2, 201), method, isolated=False)
        stretch[method.kind] = np.abs(np.linalg.norm(run.node("P"), axis=1)[-50:] - 1.0).max()
    assert stretch["generalized_alpha"] < 1e-5 < 5e-4 < stretch["energy_momentum"]


def test_a_step_that_does_not_settle_is_said():
    run = march(elastic(), [0, 10.0], EnergyMomentum(5.0), isolated=False)
    assert run.code in (m.NOT_CONVERGED, m.NOT_FINITE)
