"""Reduced equations against closed forms and against the equations in all coordinates."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.library import mechanisms


def test_andrews_starts_with_its_published_acceleration():
    model = mechanisms.andrews()
    tasks = {"motor": kt.GivenForce(torque=0.033)}
    found = kt.dynamics.reduced_equations(model, "OF.angle", tasks=tasks)
    assert abs(found.acceleration.item() / 14222.4439199541138705911625887 - 1) < 1e-11
    assert abs(found.force.item() - 0.033) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("dofs", [["B.x", "C.y"], ["one.angle", "two.angle"], ["B.y", "two.angle"]])
def test_any_mix_of_coordinates_gives_the_same_accelerations(dofs):
    arms = kt.Model(
        nodes={"A": (0, 0), "B": (0.8, -0.6), "C": (1.4, 0.3)}, fixed=["A"], gravity=(0, -9.81),
        bars={"one": kt.Bar(ends=("A", "B"), mass=2.0), "two": kt.Bar(ends=("B", "C"), mass=1.0)},
    )  # fmt: skip
    w = {"one": 1.5, "two": -2.0}
    v = {"A": np.zeros(2), "B": 1.5 * np.array([0.6, 0.8])}
    v["C"] = v["B"] - 2.0 * np.array([-0.9, 0.6])
    rates = {name: w[name.split(".")[0]] if name.endswith("angle") else float(v[name[0]]["xy".index(name[2])]) for name in dofs}
    found = kt.dynamics.reduced_equations(arms, dofs, rates=rates)
    assert np.abs(found.velocity.values - np.array(list(v.values()))).max() < 1e-13
    let_go = kt.dynamics.simulate(arms.with_(velocities={name: tuple(one) for name, one in v.items()}), 0.01, samples=2)
    wanted = let_go.motion.data["acceleration"].values[0]
    assert np.abs(found.node_acceleration.values - wanted).max() < 1e-10
    mass = found.mass.values
    kinetic = 0.5 * found.rate.values @ mass @ found.rate.values
    assert abs(kinetic - float(let_go.data["kinetic_energy"][0])) < 1e-12


@pytest.mark.slow
def test_a_delta_has_its_closed_form_accelerations():
    model = mechanisms.delta()
    tasks = dict.fromkeys(model.all_drives, kt.Free())
    found = kt.dynamics.reduced_equations(model, ["Q.x", "Q.y", "Q.z"], tasks=tasks, rates={"Q.x": 0.3, "Q.z": -0.5})
    thrown = {name: tuple(found.velocity.sel(node=name).values) for name in model.nodes if name[0] != "A"}
    let_go = kt.dynamics.simulate(model.with_(velocities=thrown), 0.001, samples=2, tasks=tasks)
    assert np.abs(let_go.motion.data["acceleration"].values[0] - found.node_acceleration.values).max() < 1e-8


def test_faults_are_told():
    model = mechanisms.pendulum()
    with pytest.raises(InputError, match="no degree of freedom here"):
        kt.dynamics.reduced_equations(model, rates={"zz": 1.0})
