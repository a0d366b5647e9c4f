"""Damping of beams: ratios of modes, work and energy under every method, derivatives, section forces, vibration."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import simpson
from scipy.signal import find_peaks
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_forces, element_tangents

STEEL = kt.Material(E=200e9, density=7800.0)
BOX = kt.Rectangle(width=0.02, height=0.03)
DELAY = 2e-4


def cantilever(dim: int = 3, delay: float = DELAY, **more) -> kt.Model:
    """Two elements along x, clamped at the left."""
    nodes = {f"N{k}": (k / 2, 0.0, 0.0)[:dim] for k in range(3)}
    beams = {f"b{k}": kt.Beam(ends=(f"N{k}", f"N{k + 1}"), damping=delay) for k in range(2)}
    return kt.Model(nodes=nodes, beams=beams, clamped=["N0"], material=STEEL, section=BOX, **more)


def kicked(dim: int = 3, delay: float = DELAY) -> kt.Model:
    model = cantilever(dim, delay)
    return model.with_(velocities={name: (0.0, 1.0, 0.5)[:dim] for name in model.whole.nodes if name.startswith("N2")})


@pytest.mark.slow
@pytest.mark.parametrize("dim", [2, 3])
def test_every_mode_has_half_its_frequency_times_the_delay(dim):
    found = kt.dynamics.linearise(cantilever(dim))
    np.testing.assert_allclose(found.modal_damping, math.pi * found.frequency * DELAY, rtol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("method", [None, kt.EnergyMomentum(step=5e-6), kt.Radau(), kt.GeneralizedAlpha(step=5e-6)])
def test_the_energy_that_is_lost_is_the_work_of_the_damping(method):
    model = kicked()
    run = kt.dynamics.simulate(model, 1e-3, samples=201, **({} if method is None else {"method": method}))
    forces = kt.dynamics.inverse(model, run.motion)
    work = simpson(forces.dissipation.values, x=run.data["time"].values)
    lost = float(run.energy[0] - run.energy[-1])
    assert lost > 0.03 * float(run.energy[0])
    assert work == pytest.approx(lost, rel=2e-4)
    assert "off by" not in run.message


def test_derivatives_of_the_forces_and_rigid_motions():
    system = compile(cantilever())
    rng = np.random.default_rng(2)
    x = system.x0 + 0.02 * rng.standard_normal(system.x0.shape)
    v, u = (rng.standard_normal(x.shape) for _ in range(2))

    def force(place, rate):
        return element_forces(system, place, rate) - element_forces(system, place)

    K, C = element_tangents(system, x, v)
    K = K - element_tangents(system, x, None)[0]
    h, f = 1e-4, {k: force(x + k * 1e-4 * u, v) for k in (-2, -1, 1, 2)}
    scale = np.abs(force(x, v)).max()
    np.testing.assert_allclose(-(C @ u.reshape(-1)), force(x, u), atol=1e-10 * scale)
    np.testing.assert_allclose(-(K @ u.reshape(-1)), (f[-2] - 8 * f[-1] + 8 * f[1] - f[2]) / (12 * h), atol=1e-9 * scale)
    turn, spin = Rotation.from_rotvec((0.4, -0.2, 0.9)), np.array([1.0, 2.0, -0.5])
    there = turn.apply(system.x0.copy()) + 0.3
    still = force(there, np.cross(spin, there) + np.array([0.1, 0.2, 0.3]))
    assert np.abs(still).max() < 1e-9 * np.abs(force(system.x0, v)).max()


@pytest.mark.slow
def test_section_forces_in_motion_are_in_balance():
    """At the free end moment and shear vanish, next to each other elements agree, at the clamp they are the reactions."""
    model = kicked()
    run = kt.dynamics.simulate(model, 5e-4, samples=11)
    forces = kt.dynamics.inverse(model, run.motion)
    along = kt.strength.beams(model, forces, stations=[0.0, 1.0])
    end = along.section_M.sel(beam="b1").values[1:]
    size = np.abs(end).max()
    # moments are exact to the square of the strains
    assert np.abs(end[:, 1]).max() < 1e-5 * size
    np.testing.assert_allclose(along.section_M.sel(beam="b0").values[1:, 1], end[:, 0], atol=1e-5 * size)
    whole = forces.reaction.sel(support="N0").values[1:]
    given = along.end_force.sel(beam="b0", end="A").values[1:]
    # in the axes of the chord, which turns by the rotations of the ends: as without damping
    np.testing.assert_allclose(given, whole, atol=5e-4 * np.abs(whole).max())


@pytest.mark.slow
def test_vibration_along_drives_decays_with_the_damping_of_its_beam():
    """A beam with damping on a driven crank, and one without that is given the ratio: the same decay to first order."""
    fields = {
        "nodes": {"O": (0, 0), "G": (0, 0.4), "C": (0.3, 0), "D": (0.3, 0.2), "T": kt.Node(at=(1.3, 0), mass=1.0)},
        "fixed": ["O", "G"],
        "bars": {
            "crank": kt.Bar(ends=("O", "C"), mass=0.0),
            "side": kt.Bar(ends=("O", "D"), mass=0.0),
            "lift": kt.Bar(ends=("G", "C"), kind="driven", mass=0.0),
        },
        "clamped": {"C": "hub"},
        "bodies": {"hub": kt.Body(nodes=("C", "D"), mass=1.0)},
        "material": STEEL,
        "section": BOX,
    }
    model = kt.Model(**fields, beams={"arm": kt.Beam(ends=("C", "T"), damping=2e-3)})
    move = kt.Quintic(moves={"lift": (0.5, 0.51)}, duration=0.02)
    motion = kt.kinematics.follow(model, move, samples=81)
    rigid = ("crank", "side", "lift")
    found = kt.flexible.vibration(model, kt.dynamics.inverse(model, motion), rigid=rigid, rest=0.2)
    plain = model.with_(beams={"arm": kt.Beam(ends=("C", "T"))})
    first = float(
        kt.flexible.frequencies(plain, kt.dynamics.inverse(plain, motion), rigid=rigid, modes=1).frequency.values[-1, 0]
    )
    given = kt.flexible.vibration(
        plain, kt.dynamics.inverse(plain, motion), rigid=rigid, rest=0.2, damping=math.pi * first * 2e-3
    )
    tip = found.displacement.sel(node="T").values
    np.testing.assert_allclose(given.displacement.sel(node="T").values, tip, atol=2e-2 * np.abs(tip).max())
    after = np.abs((found.displacement - found.settled).sel(node="T", axis="y").values[81:])
    peaks, _ = find_peaks(after)
    times = found.data["time"].values[81:][peaks]
    slope = np.polyfit(times, np.log(after[peaks]), 1)[0]
    # zeta w = w^2 b/2
    assert slope == pytest.approx(-((2 * math.pi * first) ** 2) * 1e-3, rel=0.02)
