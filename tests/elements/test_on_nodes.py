"""Elements on nodes whose law is an expression: what is made of it is its derivatives, and steps keep energy and momenta."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics import singular_starts
from kinetruss.elements import kinds
from kinetruss.elements.on_nodes import (
    NodeElements,
    Part,
    arrays_of,
    balance,
    changes,
    element,
    energy,
    force,
    histories,
    swap,
    tangents,
    values_of,
)
from kinetruss.kernels.coordinates.node_laws import NodeLaw, Value
from kinetruss.kernels.coordinates.programs import (
    above,
    angle,
    choice,
    cosine,
    cross,
    dot,
    exponential,
    logarithm,
    minus,
    size,
    speed,
    tanh,
)

COUNT = 5
"""Nodes of the structure."""


def stored(nodes, numbers):
    """Of the two sides and the angle between them of three nodes: every operation of laws."""
    a, b = minus(nodes[1], nodes[0]), minus(nodes[2], nodes[0])
    turned = angle(size(cross(a, b)), dot(a, b))
    apart, k = size(a), numbers[0]
    return (
        k * above(apart - numbers[1], 2.5)
        + 0.3 * k * logarithm(size(b))
        + exponential(-1.0 * apart)
        + choice(size(b) - 0.4, k * (size(b) - 0.4) * (size(b) - 0.4), 0.0)
        + 0.2 * cosine(turned)
        + 0.5 * k * turned * turned / (1.0 + tanh(apart))
    )


def pushed(t, nodes, rates, numbers):
    """Resistance to the approach of two nodes, the more the nearer they are, and on the third a force in time."""
    d, w = minus(nodes[1], nodes[0]), minus(rates[1], rates[0])
    share = -1.0 * numbers[0] * tanh(dot(d, w)) / dot(d, d)
    drag = tuple(-0.3 * speed(rates[2]) * one for one in rates[2])
    return [tuple(-1.0 * share * one for one in d), tuple(share * one for one in d), (drag[0] + 2.0 * t, drag[1], drag[2])]


def apart(t, nodes, rates, numbers):
    return size(minus(nodes[1], nodes[0])) + t


LAW = NodeLaw(
    stored,
    pushed,
    {"apart": Value(apart, "m", "distance"), "middle": Value(lambda _t, n, _v, _k: minus(n[2], n[0]), "m", "way")},
)
PARTS = {
    "all": Part("trial", ("one", "two"), LAW, [[0, 2, 3], [4, 1, 2]], np.array([[3.0, 0.5], [2.0, 0.9]])),
    "energy": Part(
        "trial", ("one", "two"), LAW._replace(force=None), [[0, 2, 3], [4, 1, 2]], np.array([[3.0, 0.5], [2.0, 0.9]])
    ),
    "force": Part("trial", ("one",), LAW._replace(energy=None), [[0, 2, 3]], np.array([[3.0, 0.5]])),
}


@pytest.fixture(params=PARTS)
def case(request):
    dice = np.random.default_rng(4)
    x = np.array([(0, 0, 0), (1, 0.1, 0), (0.2, 0.9, 0.3), (0.4, 0.2, 1.1), (1.3, 0.7, 0.5)], float)
    part = PARTS[request.param]
    return part, NodeElements.of(arrays_of(part)), x.reshape(-1), dice.standard_normal(3 * COUNT)


def forces(record, x, v, t=0.4):
    found = np.zeros(x.size)
    force(record, t, x, v, found)
    return found


def slopes(of, y, step=1e-6):
    unit = step * np.eye(y.size)
    return np.array([(of(y + one) - of(y - one)) / (2 * step) for one in unit])


def test_the_force_is_the_derivative_of_the_energy(case):
    part, record, x, _ = case
    if part.law.force is not None:
        part = part._replace(law=part.law._replace(force=None))
        if part.law.energy is None:
            return
        record = NodeElements.of(arrays_of(part))
    found = forces(record, x, np.zeros_like(x))
    assert -slopes(lambda y: energy(record, y), x) == pytest.approx(found, abs=1e-8)
    assert np.abs(found).max() > 0.1


def test_the_tangents_are_those_of_the_force(case):
    _, record, x, v = case
    K, C = (one.toarray() for one in tangents(None, record, x.reshape(-1, 3), v.reshape(-1, 3), 0.4))
    assert pytest.approx(-slopes(lambda y: forces(record, y, v), x), abs=1e-7) == K.T
    assert pytest.approx(-slopes(lambda y: forces(record, x, y), v), abs=1e-7) == C.T


def test_power_is_the_change_of_the_energy_and_what_is_taken(case):
    _, record, x, v = case
    out = np.zeros(3)
    balance(record, 0.4, x, v, out)
    assert out[0] == energy(record, x)
    assert out[1] == pytest.approx((energy(record, x + 1e-6 * v) - energy(record, x - 1e-6 * v)) / 2e-6, abs=1e-7)
    assert forces(record, x, v) @ v == pytest.approx(-out[1] - out[2], abs=1e-12)


def test_at_rest_a_law_of_speeds_is_a_number(case):
    _, record, x, _ = case
    none = np.zeros_like(x)
    K, C = tangents(None, record, x.reshape(-1, 3), none.reshape(-1, 3))
    assert np.isfinite(K.toarray()).all()
    assert np.isfinite(C.toarray()).all()
    assert np.isfinite(forces(record, x, none)).all()


@pytest.mark.parametrize("grounded", [False, True])
def test_a_step_by_the_midpoint_rule_keeps_energy_and_momenta(grounded):
    part = PARTS["energy"]._replace(grounded=grounded)
    record, x0 = NodeElements.of(arrays_of(part)), np.random.default_rng(1).standard_normal(3 * COUNT)
    x1 = x0 + 0.3 * np.random.default_rng(2).standard_normal(3 * COUNT)
    middle, f = 0.5 * (x0 + x1), np.zeros(3 * COUNT)
    force(record, 0.0, middle, (x1 - x0) / 0.1, f)
    plain = f.copy()
    swap(record, 0.0, x0, x1, middle, (x1 - x0) / 0.1, 0.1, f)
    assert f @ (x1 - x0) == pytest.approx(energy(record, x0) - energy(record, x1), abs=1e-12)
    assert abs(plain @ (x1 - x0) - (energy(record, x0) - energy(record, x1))) > 1e-3
    if not grounded:
        assert f.reshape(-1, 3).sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-12)
        assert np.cross(middle.reshape(-1, 3), f.reshape(-1, 3)).sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-12)


def test_a_rigid_turn_needs_no_correction():
    part = PARTS["energy"]
    record, x0 = NodeElements.of(arrays_of(part)), np.random.default_rng(1).standard_normal((COUNT, 3))
    c, s = np.cos(0.6), np.sin(0.6)
    x1 = x0 @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + [0.3, 0.1, -0.2]
    middle, f = 0.5 * (x0 + x1), np.zeros(3 * COUNT)
    swap(record, 0.0, x0.ravel(), x1.ravel(), middle.ravel(), f, 0.1, f)
    assert np.abs(f).max() < 1e-9


def test_values_and_their_changes_are_those_of_the_expressions(case):
    part, record, x, v = case
    for name, law, size_, _ in values_of(part):
        out = np.empty((2, len(part.names), size_))
        histories(record, law, np.array([0.0, 0.5]), np.stack([x, x]), np.stack([v, v]), out)
        d = x.reshape(-1, 3)[[one[1 if name == "apart" else 2] for one in part.nodes]]
        d = d - x.reshape(-1, 3)[[one[0] for one in part.nodes]]
        if name == "middle":
            assert out[0] == pytest.approx(d)
            continue
        assert out[:, :, 0] == pytest.approx(np.linalg.norm(d, axis=1) + np.array([[0.0], [0.5]]))
        moved = np.empty((len(part.names), 2 * size_))
        changes(record, law, x, v, moved)
        w = v.reshape(-1, 3)
        rate = [d[k] @ (w[one[1]] - w[one[0]]) / np.linalg.norm(d[k]) for k, one in enumerate(part.nodes)]
        assert moved[:, 1] == pytest.approx(rate)


def test_what_feeds_is_no_growth_of_energy_and_has_an_equilibrium(monkeypatch):
    """A thrust along x that follows from no energy: it speeds a mass up, a spring holds it."""
    law = NodeLaw(force=lambda _t, _nodes, _rates, numbers: [(numbers[0], 0.0, 0.0)])

    def thrusters(system):
        return Part("thruster", ("one",), law, [[system.node_index("P")]], np.array([[30.0]]), feeds=True, grounded=True)

    every = (*kinds.ELEMENTS, element(thrusters))
    for module in (kinds, singular_starts):
        monkeypatch.setattr(module, "ELEMENTS", every)
    model = kt.Model(
        nodes={"O": (0, 0), "P": kt.Node(at=(1, 0), mass=2.0)},
        fixed={"O": "xy", "P": "y"},
        bars={"guide": kt.Bar(ends=("O", "P"), kind="free")},
    )
    run = kt.dynamics.simulate(model, 1.0, samples=3)
    assert run.motion.velocity.sel(node="P", axis="x").values[-1] == pytest.approx(15.0, rel=1e-9)
    assert run.forces.dissipation.values[-1] == pytest.approx(-450.0, rel=1e-9)
    assert "less what elements give" in run.forces.data.dissipation.attrs["long_name"]
    coordinate = kt.CoordinateDrive(node="P", axis="x")
    held = model.with_(springs={"s": kt.Spring(coordinate=coordinate, stiffness=600.0)})
    assert kt.statics.equilibrium(held).position.sel(node="P", axis="x").item() == pytest.approx(1.05, rel=1e-9)
