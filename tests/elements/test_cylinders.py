"""Hydraulic cylinders: closed forms of pressure, limited supply and given flow; in all analyses."""

from __future__ import annotations

import math

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli.commands import main

BORE, ROD, MASS = 0.04, 0.02, 50.0
A, B = math.pi / 4 * BORE**2, math.pi / 4 * (BORE**2 - ROD**2)
METHODS = (kt.DOP853(), kt.Radau(), kt.EnergyMomentum(1e-3), kt.GeneralizedAlpha(1e-3), kt.Rattle(1e-3))


def press(load=0.0, damping=0.0, **cylinder):
    """A mass on a guide, pushed along x."""
    x = kt.CoordinateDrive(node="P", axis="x")
    springs = {"brake": kt.Spring(coordinate=x, damping=damping)} if damping else {}
    return kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1, 0), mass=MASS)},
        fixed={"O": "xy", "P": "y"},
        bars={"guide": kt.Bar(ends=("O", "P"), kind="free")},
        loads={"F": kt.NodalForce(node="P", force=(-load, 0.0))} if load else {},
        cylinders={"ram": kt.Cylinder(**({"member": "guide", "bore": BORE, "rod": ROD} | cylinder))},
        springs=springs,
    )


def ran(model, t_end, method=None, samples=201):
    return kt.dynamics.simulate(model, t_end, samples=samples, **({"method": method} if method else {}))


@pytest.mark.parametrize("method", METHODS, ids=lambda one: one.kind)
def test_constant_pressures_accelerate(method):
    run = ran(press(pressure_A="2 MPa", pressure_B="0.5 MPa"), 0.2, method)
    a = (2e6 * A - 0.5e6 * B) / MASS
    assert run.motion.velocity.sel(node="P", axis="x").values[-1] == pytest.approx(a * 0.2, rel=1e-6)
    data = run.forces.data
    assert data.cylinder_thrust.values == pytest.approx(a * MASS)
    assert data.cylinder_flow_A.values[-1, 0] == pytest.approx(A * a * 0.2, rel=1e-6)
    assert data.cylinder_power.values[-1, 0] == pytest.approx(a * MASS * a * 0.2, rel=1e-6)


def test_pressure_along_a_table():
    """p = 10 MPa/s t up to 0.1 s, then constant."""
    run = ran(press(times=(0.0, 0.1), pressures_A=(0.0, 1e6)), 0.2)
    t = run.time.values
    assert run.forces.data.cylinder_pressure_A.values[:, 0] == pytest.approx(np.minimum(1e7 * t, 1e6), abs=1e-3)
    v = run.motion.velocity.sel(node="P", axis="x").values[-1]
    assert v == pytest.approx(A * 1e6 * (0.05 + 0.1) / MASS, rel=1e-9)


def test_speed_under_a_load_is_limited_by_the_supply():
    """p (1 - (A v/Q)^2) A = F."""
    run = ran(press(load=1000.0, pressure_A="2 MPa", flow_limit=1e-3), 1.5, kt.Radau())
    v = 1e-3 / A * math.sqrt(1 - 1000.0 / (2e6 * A))
    assert run.motion.velocity.sel(node="P", axis="x").values[-1] == pytest.approx(v, rel=1e-6)
    assert run.forces.data.cylinder_pressure_A.values[-1, 0] == pytest.approx(1000.0 / A, rel=1e-6)


@pytest.mark.parametrize("flow", [1e-3, -1e-3])
def test_a_given_flow_gives_the_speed(flow):
    """v -> (Q - leak F/A)/A with the time constant m leak/A^2; the other way on the side of the rod."""
    leak, load = 1e-10, 500.0 * np.sign(flow)
    run = ran(press(load=load, flow=flow, leak=leak), 0.2, kt.Radau())
    area = A if flow > 0 else B
    end = (flow - leak * load / area) / area
    t, v = run.time.values, run.motion.velocity.sel(node="P", axis="x").values
    assert v == pytest.approx(end * (1 - np.exp(-t * area**2 / (MASS * leak))), abs=1e-6)


def test_relief_and_shut_ports():
    run = ran(press(flow=1e-3, leak=1e-12, relief="3 MPa", load=1e4), 0.02, kt.Radau())
    assert run.forces.data.cylinder_pressure_A.values.max() == pytest.approx(3e6, rel=1e-9)
    shut = ran(press(flow=0.0, leak=1e-12, load=1000.0), 0.5, kt.Radau())
    assert shut.motion.velocity.sel(node="P", axis="x").values[-1] == pytest.approx(-1e-12 * 1000.0 / A**2, rel=1e-5)


def test_energy_inverse_and_free_bodies():
    model = press(load=300.0, damping=200.0, times=(0.0, 0.1), pressures_A=(0.0, 1e6), pressure_B="0.1 MPa", flow_limit=2e-3)
    run = ran(model, 0.3)
    forces = kt.dynamics.inverse(model, run.motion)
    assert np.abs(forces.energy_balance.values).max() < 1e-8
    assert forces.data.cylinder_thrust.values == pytest.approx(run.forces.data.cylinder_thrust.values)
    power, brake = forces.data.cylinder_power.values[:, 0], 200.0 * run.motion.velocity.sel(node="P", axis="x").values ** 2
    assert forces.dissipation.values == pytest.approx(brake - power, abs=1e-9)
    assert kt.dynamics.free_body(model, run.motion, run.forces, node="P", time=0.3).residual < 1e-10


def test_statics():
    hold = {"s": kt.Spring(coordinate=kt.CoordinateDrive(node="P", axis="x"), stiffness=5e4)}
    model = press(pressure_A="2 MPa", pressure_B="0.5 MPa").with_(springs=hold)
    found, F = kt.statics.equilibrium(model), 2e6 * A - 0.5e6 * B
    assert found.position.sel(node="P", axis="x").item() == pytest.approx(1 + F / 5e4, rel=1e-9)
    assert found.data.cylinder_thrust.item() == pytest.approx(F)
    small = kt.statics.linear(model)
    assert small.displacement.sel(node="P", axis="x").item() == pytest.approx(F / 5e4, rel=1e-9)
    assert small.data.cylinder_thrust.item() == pytest.approx(F)


def test_faults_come_before_the_run():
    bad = {
        "not thinner": {"rod": 0.05, "pressure_A": 1e6},
        "nothing moves": {},
        "both given": {"flow": 1e-3, "leak": 1e-12, "pressure_A": 1e6},
        "Give leak": {"flow": 1e-3},
        "Give its times": {"pressures_A": (0.0, 1e6)},
        "negative": {"pressure_A": -1.0},
        "along one member": {"nodes": ("O", "P"), "pressure_A": 1e6},
        "no member called 'guid'": {"member": "guid", "pressure_A": 1e6},
        "names 'O' twice": {"member": None, "nodes": ("O", "O"), "pressure_A": 1e6},
    }
    for words, cylinder in bad.items():
        with pytest.raises(kt.ModelError, match=words):
            press(**cylinder)
    with pytest.raises(kt.InputError, match="the cylinder 'ram' has a law without one"):
        ran(press(pressure_A=1e6), 0.1, kt.Taylor())


def test_files_and_reports_have_it(tmp_path):
    run = kt.Run(analysis="dynamics.simulate", t_end=0.1, samples=11)
    model = press(pressure_A="2 MPa", member=None, nodes=("O", "P")).with_(runs={"go": run})
    kt.io.write(model, tmp_path / "model.yaml")
    said = CliRunner().invoke(main, ["run", str(tmp_path / "model.yaml"), "-o", str(tmp_path / "out")]).output
    assert "thrust of the piston" in said
    assert "elements give up to" in said
