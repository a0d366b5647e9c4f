"""Membranes and solids in statics, buckling, linearisation, simulation and inverse dynamics."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.verification import solids as cases

RUBBER = kt.Material(E=1e6, density=1000.0, poisson=0.3)


def block(**more):
    grid = kt.library.meshes.box(size=(1.0, 0.3, 0.3), cells=(2, 1, 1))
    return grid, kt.Model(nodes=grid.nodes, fixed=grid.at(x=0.0), material=RUBBER, solids={"b": grid.solid()}, **more)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["triangles", "four", "linear", "tetrahedra"])
def test_patches(kind):
    assert cases.patch(kind)["displacement"] < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize(("strain", "power"), [("constant", 2), ("linear", 4)])
def test_cantilever_converges_at_the_known_order(strain, power):
    found = cases.order(strain)
    assert found["order"] == pytest.approx(power, rel=0.03)
    # Timoshenko & Goodier, Theory of Elasticity, art. 21: 4 m, 1 m deep, 1 MN
    sag = 1e6 / (6 * 210e9 / 12) * (2 * 4.0**3 + (4 + 5 * 0.3) * 4.0 / 4)
    assert found["limit"] == pytest.approx(sag, rel=3e-3 if strain == "constant" else 1e-5)


@pytest.mark.slow
def test_waves_in_a_bar_of_solids():
    speed = np.sqrt(70e9 / 2700.0)
    found = cases.waves()
    assert found["first"] == pytest.approx(speed / 4, rel=1e-5)
    assert found["second"] == pytest.approx(3 * speed / 4, rel=1e-3)


@pytest.mark.slow
def test_energy_momentum_keeps_energy_and_spin():
    found = cases.vibration()
    assert found["energy"] < 1e-12
    assert found["spin"] < 1e-12


@pytest.mark.slow
def test_methods_agree_and_the_forces_of_a_simulation_balance():
    grid, model = block()
    tip = grid.nearest((1.0, 0.0, 0.0))
    model = model.with_(loads={"pull": kt.NodalForce(node=tip, force=(0.0, 2e3, 0.0))}, gravity=(0.0, 0.0, -9.81))
    fine = kt.dynamics.simulate(model, t_end=0.05, samples=6)
    steps = kt.dynamics.simulate(model, t_end=0.05, samples=6, method=kt.GeneralizedAlpha(step=1e-4))
    apart = np.abs(fine.motion.position - steps.motion.position).max().item()
    moved = np.abs(fine.motion.position - fine.motion.position[0]).max().item()
    assert moved > 1e-3
    assert apart < 2e-4 * moved
    energy = fine.forces.energy
    assert np.abs(fine.forces.energy_balance).max() < 1e-9 * np.abs(fine.forces.energy_rate).max()
    assert fine.energy.values == pytest.approx(energy.values, rel=1e-12)
    # what inverse dynamics says of the same motion
    again = kt.dynamics.inverse(model, fine.motion)
    assert again.reaction.values == pytest.approx(fine.forces.reaction.values, abs=1e-9 * np.abs(again.reaction).max().item())


def test_rest_is_where_linearisation_and_statics_meet():
    grid, model = block(gravity=(0.0, 0.0, -9.81))
    rest = kt.statics.equilibrium(model)
    assert rest.stable
    weight = 1000.0 * 0.09 * 9.81
    assert rest.reaction.sum("support").values == pytest.approx([0, 0, weight], abs=1e-9 * weight)
    small = kt.statics.linear(model, load_case=None)
    tip = {"node": grid.nearest((1.0, 0.0, 0.0)), "axis": "z"}
    sag = rest.position.sel(tip).item()
    assert sag == pytest.approx(small.displacement.sel(tip).item(), rel=0.05)
    assert small.reaction.sum("support").values == pytest.approx([0, 0, weight], abs=1e-9 * weight)
    assert small.work.item() == pytest.approx(small.energy.item(), rel=1e-12)
    found = kt.dynamics.linearise(model, rest)
    assert found.frequency.values[0] > 0
    assert kt.strength.elements(model, rest, "b").von_mises.values.max() > 0


@pytest.mark.slow
def test_a_column_of_membrane_buckles_like_eulers():
    E, length, depth, thick = 1e9, 20.0, 1.0, 0.1
    grid = kt.library.meshes.rectangle(width=length, height=depth, columns=20, rows=1, six_nodes=True)
    push = dict(
        zip(sorted(grid.at(x=length), key=lambda n: grid.points[grid.names.index(n), 1]), (1 / 6, 4 / 6, 1 / 6), strict=True)
    )
    model = kt.Model(
        nodes=grid.nodes, fixed=grid.at(x=0.0), material=kt.Material(E=E, density=0.0, poisson=0.0),
        membranes={"c": grid.membrane(thickness=thick, strain="linear")},
        loads={f"P{n}": kt.NodalForce(node=n, force=(-share, 0.0)) for n, share in push.items()},
    )  # fmt: skip
    euler = np.pi**2 * E * thick * depth**3 / 12 / (4 * length**2)
    # with the shear of Timoshenko's beam: 1/P = 1/P_E + 1.2/(G A)
    wanted = 1 / (1 / euler + 1.2 / (E / 2 * thick * depth))
    found = kt.statics.buckling(model, dict.fromkeys(model.loads, 1.0))
    assert found.load_factor.values[0] == pytest.approx(wanted, rel=2e-3)


@pytest.mark.slow
def test_elements_share_nodes_with_bars_and_drives():
    grid = kt.library.meshes.rectangle(width=1.0, height=1.0, columns=2, rows=2).renamed({"n8": "tip"})
    model = kt.Model(
        nodes=grid.nodes | {"wall": kt.Node(at=(2.0, 1.0))}, fixed=[*grid.at(x=0.0), "wall"],
        bars={"rod": kt.Bar(ends=("tip", "wall"), kind="driven", mass=1.0)}, material=RUBBER,
        membranes={"skin": grid.membrane(thickness=0.01)},
    )  # fmt: skip
    rest = kt.statics.equilibrium(model, lengths={"rod": 0.9})
    pull = rest.member_force.item()
    assert pull > 0
    assert rest.reaction.sum("support").values == pytest.approx([0, 0], abs=1e-8 * pull)
    # the work of the drive over small steps is the energy stored
    lengths = np.linspace(1.0, 0.9, 11)
    found = [kt.statics.equilibrium(model, lengths={"rod": float(one)}) for one in lengths]
    forces = np.array([one.member_force.item() for one in found])
    energy = float(kt.strength.elements(model, found[-1], "skin").energy.sum())
    work = np.sum((forces[1:] + forces[:-1]) / 2) * 0.01
    assert energy == pytest.approx(work, rel=3e-3)
