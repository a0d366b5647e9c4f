"""Energy and momenta of the equations of motion: their rates along the accelerations found are the powers and forces given."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.equations import equations
from kinetruss.dynamics.motion_tables import drive_tables
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.kkt import kinetic, momenta, potential, prepare_rows
from kinetruss.kernels.structure.applied import no_force
from kinetruss.library import mechanisms, vgt
from kinetruss.mechanics import compile
from kkt_models import consistent
from random_trusses import truss

H = 1e-4


def state(model, seed=0, t=0.0, **given):
    system = compile(model)
    eq, ws = equations(system, **given)
    x, v = consistent(system, eq, ws, seed, t)
    a, N = np.zeros_like(x), np.zeros(eq.row.size)
    evaluate(eq, ws, no_force, t, x, v, a, N)
    return system, eq, ws, x, v, a, N


def rate(quantity, x, v, a, h=H):
    """Central difference of a quantity along the motion."""
    ahead = quantity(x + h * v + 0.5 * h * h * a, v + h * a)
    behind = quantity(x - h * v + 0.5 * h * h * a, v - h * a)
    return (ahead - behind) / (2 * h)


def energy(eq, ws):
    return lambda x, v: kinetic(eq, ws, x, v) + potential(eq, x)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_two_rod_members_keep_energy_while_they_slide(seed):
    """Free actuators: masses that change with the lengths, their velocity terms and weights."""
    model = vgt.double_octahedral(bays=1)
    _, eq, ws, x, v, a, _ = state(model, seed, tasks={name: kt.Free() for name in model.all_drives})
    assert len(eq.varying_A) == 3
    size = abs(rate(lambda y, w: kinetic(eq, ws, y, w), x, v, a)) + kinetic(eq, ws, x, v)
    assert abs(rate(energy(eq, ws), x, v, a)) < 1e-6 * size


def test_rotary_bars_and_bodies_keep_energy():
    bars = {
        "a": {"ends": ("A", "B"), "section": kt.Rod(diameter=0.2), "material": kt.library.materials.STEEL_S235,
              "rotary_inertia": True},
        "b": {"ends": ("B", "C"), "body": {"mass": 2.0, "center": (0.3, -0.2), "inertia": 0.4}},
        "s": {"ends": ("A", "C"), "kind": "elastic", "stiffness": 400.0, "strain": "green", "natural_length": 1.0},
    }  # fmt: skip
    model = kt.Model(nodes={"A": (0, 0), "B": (0.9, 0.5), "C": (1.7, -0.2)}, fixed=("A",), bars=bars, gravity=(0, -9.81))
    _, eq, ws, x, v, a, _ = state(model, 3)
    assert len(eq.varying_A) == 1
    assert np.any(eq.pair[:, 3])
    assert abs(rate(energy(eq, ws), x, v, a)) < 1e-6 * (kinetic(eq, ws, x, v) + abs(potential(eq, x)))


def test_power_of_drives_and_dampers_closes_the_balance():
    model, tasks, trajectory = truss(4, 3, massless=False, driven=True)
    model = model.with_(loads={})
    _, eq, ws, x, v, a, N = state(model, 4, trajectory=trajectory, tasks=tasks)
    prepare_rows(eq, ws, 0.0, x, v)
    power = float(np.sum(-N * ws.target[1]))
    assert abs(power) > 1e-3
    assert rate(energy(eq, ws), x, v, a) == pytest.approx(power, rel=1e-5)


def test_free_structure_keeps_its_momenta():
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0.2, 0.9, 0), "D": (0.3, 0.2, 0.8)}
    bars = {f"{p}{q}": {"ends": (p, q), "mass": 0.5} for p, q in ("AB", "BC", "CA", "AD", "BD")}
    bars["CD"] = {"ends": ("C", "D"), "kind": "elastic", "stiffness": 90.0, "damping": 2.0, "natural_length": 0.7}
    model = kt.Model(nodes=nodes, bars=bars, gravity=(0, 0, 0))
    for solver in ("dense", "sparse", "sweep"):
        _, eq, ws, x, v, a, _ = state(model, 1, solver=solver)

        def both(y, w, eq=eq, ws=ws):
            out = np.zeros(6)
            momenta(eq, ws, y, w, out)
            return out

        assert np.abs(rate(both, x, v, a)).max() < 1e-6 * np.abs(both(x, v)).max()


def test_given_forces_push_as_they_say():
    model = mechanisms.andrews()
    _, eq, ws, x, v, a, _ = state(model, 2, tasks={"motor": kt.GivenForce(times=(0.0, 1.0), torques=(0.02, 0.04))})
    system = compile(model)
    i = system.members.index("OF")
    d = (x.reshape(-1, 3)[system.q[i]] - x.reshape(-1, 3)[system.p[i]])[:2]
    w = (v.reshape(-1, 3)[system.q[i]] - v.reshape(-1, 3)[system.p[i]])[:2]
    spin = (d[0] * w[1] - d[1] * w[0]) / (d @ d)
    assert rate(energy(eq, ws), x, v, a, 1e-6) == pytest.approx(0.02 * spin, rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(
    "trajectory",
    [
        kt.Quintic(moves={"d": (1.0, 1.3)}, duration=0.8), kt.Trapezoid(moves={"d": (1.0, 1.3)}, duration=0.8, ramp=0.2),
        kt.ConstantRate(rates={"d": 0.2}, duration=1.0), kt.Sine(amplitudes={"d": 0.1}, period=0.7, phase=0.4, duration=1.0),
        kt.Cyclic(moves={"d": (1.0, 1.2)}, period=0.5, cycles=2.0), kt.StepResponse(moves={"d": (1.0, 1.2)}, duration=0.9),
        kt.Spline(times=tuple(0.1 * k for k in range(11)), values={"d": tuple(1 + 0.1 * math.sin(0.3 * k) for k in range(11))}),
    ],
)  # fmt: skip
def test_motions_in_kernels_are_those_of_the_trajectories(trajectory):
    bars = {"d": {"ends": ("A", "B"), "kind": "driven", "mass": 1.0}}
    model = kt.Model(nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 1.0}}, fixed=("A",), bars=bars)
    assert set(drive_tables(model, trajectory, 1.0)) == {"d"}
    system = compile(model)
    eq, ws = equations(system, trajectory=trajectory, t_end=1.0)
    x, v = system.x0.reshape(-1).copy(), np.zeros(6)
    times = np.linspace(0.003, 0.997, 41)
    wanted = kt.kinematics.sample(model, trajectory, times)
    for i, t in enumerate(times):
        prepare_rows(eq, ws, t, x, v)
        assert ws.now[0, 0] == pytest.approx(wanted.value[i, 0], rel=1e-12)
        assert ws.now[1, 0] == pytest.approx(wanted.rate[i, 0], rel=1e-8, abs=1e-9)
        assert ws.now[2, 0] == pytest.approx(wanted.acceleration[i, 0], rel=1e-5, abs=1e-6)
