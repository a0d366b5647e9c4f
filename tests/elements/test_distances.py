"""The distance of two nodes that no bar joins: springs, stops, couplings and events on it, and faults before the run."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

APART = kt.DistanceCoordinate(("B", "C"))
LAW = {"stiffness": 200.0, "damping": 1.5}
METHODS = (kt.DOP853(), kt.Radau(), kt.EnergyMomentum(1e-3), kt.GeneralizedAlpha(1e-3), kt.Rattle(1e-3), kt.Taylor())


def held(dim=2, **parts):
    """A mass on an arm, and another that only the element holds."""
    third = (0.0,) * (dim - 2)
    nodes = {
        "A": (0, 0, *third),
        "B": kt.Node(at=(1.2, 0.3, *third), mass=2.0),
        "C": kt.Node(at=(2, 1, *(0.4,) * (dim - 2)), mass=1.0),
    }
    arm = {"arm": kt.Bar(ends=("A", "B"), mass=0.0)}
    given = {"velocities": {"C": (0.3, -0.2, *third)}, "gravity": (0, -9.81, *third), "fixed": ["A"]} | parts
    return kt.Model(nodes=nodes, **(given | {"bars": arm | given.get("bars", {})}))


def by_spring(dim=2):
    return held(dim, springs={"link": kt.Spring(coordinate=APART, rest=0.9, **LAW)})


def by_bar(dim=2):
    return held(dim, bars={"link": kt.Bar(ends=("B", "C"), kind="elastic", mass=0.0, natural_length=0.9, **LAW)})


@pytest.mark.parametrize("method", METHODS, ids=lambda one: one.kind)
def test_a_spring_is_a_bar_with_the_same_law(method):
    one, two = (kt.dynamics.simulate(model, 0.5, samples=5, method=method) for model in (by_spring(3), by_bar(3)))
    within = 1e-8 if method.kind == "radau" else 1e-10
    assert np.abs(one.motion.position - two.motion.position).max() < within
    force = two.forces.member_force.sel(member="link").values
    assert one.forces.spring_force.values[:, 0] == pytest.approx(-force, abs=200 * within)


def test_statics_are_those_of_the_bar():
    pull = {"W": kt.NodalForce(node="C", force=(3.0, 1.0))}
    still = {"velocities": {}, "loads": pull, "fixed": {"A": "xy", "B": "x", "C": "x"}}
    one, two = (model.with_(**still) for model in (by_spring(), by_bar()))
    for analysis, column in ((kt.statics.equilibrium, "position"), (kt.statics.linear, "displacement")):
        found = [analysis(model).data[column].values for model in (one, two)]
        assert found[0] == pytest.approx(found[1], rel=1e-10, abs=1e-13)
        assert np.ptp(found[0]) > 1e-3


def test_forces_on_its_nodes_are_in_balance():
    model = by_spring()
    run = kt.dynamics.simulate(model, 0.4, samples=3)
    assert run.forces.energy_balance.values == pytest.approx(np.zeros(3), abs=1e-10)
    for node in "BC":
        assert kt.dynamics.free_body(model, run.motion, run.forces, node=node, time=0.4).residual < 1e-12
    assert kt.dynamics.newton_euler(model, run.motion, run.forces, time=0.4).residual < 1e-12


def test_a_coupling_holds_it_as_a_rigid_bar_does():
    coupled = held(couplings={"link": kt.Coupling(terms=((APART, 2.0),))}, velocities={})
    rigid = held(bars={"link": kt.Bar(ends=("B", "C"), mass=0.0)}, velocities={})
    one, two = (kt.dynamics.simulate(model, 0.8, samples=5) for model in (coupled, rigid))
    assert np.abs(one.motion.position - two.motion.position).max() < 1e-8


def test_a_stop_is_met_where_an_event_says():
    model = held(
        gravity=(0, 0),
        fixed=["A", "B"],
        velocities={"C": (-0.8, -0.7)},
        stops={"near": kt.Stop(coordinate=APART, lower="0.5 m", stiffness="40 kN/m")},
    )
    there = kt.Event(coordinate=APART, value="0.8 m", stop=False)
    run = kt.dynamics.simulate(model, 1.2, samples=5, events={"there": there})
    found = [(one.name, one.direction) for one in run.events]
    assert found == [("there", -1), ("near.lower", -1), ("near.lower", 1), ("there", 1)]
    speed = float(np.hypot(0.8, 0.7))
    assert run.events[0].time == pytest.approx((np.hypot(0.8, 0.7) - 0.8) / speed, abs=2e-9)


def test_faults_come_before_the_run():
    with pytest.raises(kt.ModelError, match="names 'B' twice"):
        held(springs={"s": kt.Spring(coordinate=kt.DistanceCoordinate(("B", "B")), stiffness=1.0)})
    with pytest.raises(kt.ModelError, match=r"springs\.s\.coordinate.*'Z'"):
        held(springs={"s": kt.Spring(coordinate=kt.DistanceCoordinate(("B", "Z")), stiffness=1.0)})
    nodes = {"A": (0, 0), "B": (1, 0), "C": kt.Node(at=(1, 0), coincident=True), "S": kt.Node(at=(0, 0), scalar=True)}
    bars = {"arm": ("A", "B"), "other": ("A", "C")}
    with pytest.raises(kt.ModelError, match="'B' and 'C' stand at one place"):
        kt.Model(nodes=nodes, bars=bars, fixed=["A"], springs={"s": kt.Spring(coordinate=APART, stiffness=1.0)})
    scalar = kt.Spring(coordinate=kt.DistanceCoordinate(("B", "S")), stiffness=1.0)
    with pytest.raises(kt.ModelError, match="'S' is a scalar, which is no place"):
        kt.Model(nodes=nodes, bars=bars, fixed=["A"], springs={"s": scalar})
    with pytest.raises(kt.ModelError, match="both fixed"):
        held(fixed=["A", "B", "C"], springs={"s": kt.Spring(coordinate=APART, stiffness=1.0)})
    with pytest.raises(kt.ModelError, match="unit of an angle"):
        kt.Spring(coordinate=APART, stiffness="3 N m/rad")
