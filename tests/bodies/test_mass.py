"""Masses of bodies at nodes: closed forms, and what does not depend on the nodes that carry them."""

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.matrices import mass_matrix
from kinetruss.model import body_mass
from kinetruss.model.bodies import carried, on_carriers, on_line, quality, second_moments, uniform

seeds = st.integers(0, 2**32 - 1)
CORNERS = {"O": (0.0, 0.0, 0.0), "X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}


def some_body(rng, dim=3):
    """Mass, centre and inertia of random point masses."""
    masses, at = rng.uniform(0.1, 2.0, 12), rng.normal(size=(12, dim))
    center = masses @ at / masses.sum()
    r = at - center
    S = r.T @ (masses[:, None] * r)
    inertia = float(np.trace(S)) if dim == 2 else np.trace(S) * np.eye(3) - S
    return float(masses.sum()), center, inertia


def some_points(rng, count, dim=3):
    """Points of a simplex that is not too flat."""
    while True:
        points = rng.normal(size=(count, dim))
        if quality(points) > 0.1:
            return points


def model_of(points, mass, center, inertia, **fields):
    names = [f"N{k}" for k in range(len(points))]
    body = kt.Body(nodes=names, mass=mass, center=center, inertia=inertia)
    return kt.Model(
        nodes={n: tuple(map(float, p)) for n, p in zip(names, points, strict=True)}, bodies={"body": body}, **fields
    )


def test_uniform_tetrahedron_is_m_10_and_m_20():
    m = uniform(1.0, 4)
    assert np.abs(6 * m[0, 1] - 3 / 10) < 1e-15
    assert np.abs(m[0, 0] - 2 * m[0, 1:].sum() + 1 / 5) < 1e-15


@given(seeds)
def test_uniform_tetrahedron_from_its_moments(seed):
    points = some_points(np.random.default_rng(seed), 4)
    r = points - points.mean(axis=0)
    m, off = on_carriers(points, 2.0, points.mean(axis=0), 2.0 * (r.T @ r) / 20)
    assert np.abs(m - uniform(2.0, 4)).max() < 1e-11
    assert off < 1e-12


@given(seeds)
def test_there_and_back(seed):
    rng = np.random.default_rng(seed)
    mass, center, inertia = some_body(rng)
    points = some_points(rng, 4)
    S = second_moments(inertia)
    m, _ = on_carriers(points, mass, center, S)
    found = carried(points, m)
    scale = np.abs(m).max()
    assert abs(found[0] - mass) < 1e-13 * scale
    assert np.abs(found[1] - center).max() < 1e-12 * scale
    assert np.abs(found[2] - S).max() < 1e-12 * scale


@given(seeds)
def test_energy_and_momentum_of_any_twist(seed):
    rng = np.random.default_rng(seed)
    mass, center, inertia = some_body(rng)
    points = some_points(rng, 4)
    M = mass_matrix(compile(model_of(points, mass, center, inertia)), points).toarray()
    v, w = rng.normal(size=(2, 3))
    nodal = v + np.cross(w, points - center)
    momentum = (M @ nodal.reshape(-1)).reshape(-1, 3)
    scale = np.abs(M).max() * np.abs(nodal).max()
    assert (
        abs(0.5 * np.sum(momentum * nodal) - 0.5 * mass * v @ v - 0.5 * w @ inertia @ w) < 1e-12 * scale * np.abs(nodal).max()
    )
    assert np.abs(momentum.sum(axis=0) - mass * v).max() < 1e-12 * scale
    assert np.abs(np.cross(points - center, momentum).sum(axis=0) - inertia @ w).max() < 1e-11 * scale


@given(seeds, st.sampled_from([2, 3]))
def test_energy_of_a_planar_body(seed, count):
    rng = np.random.default_rng(seed)
    mass, center, inertia = some_body(rng, 2)
    points = some_points(rng, count, 2)
    system = compile(model_of(points, mass, center, inertia))
    M = mass_matrix(system, system.x0).toarray().reshape(count, 3, count, 3)[:, :2, :, :2].reshape(2 * count, -1)
    v, w = rng.normal(size=2), rng.normal()
    r = points - center
    nodal = (v + w * np.stack([-r[:, 1], r[:, 0]], axis=1)).reshape(-1)
    wanted = 0.5 * mass * v @ v + 0.5 * inertia * w**2
    assert abs(0.5 * nodal @ M @ nodal - wanted) < 1e-12 * np.abs(M).max() * np.abs(nodal).max() ** 2


@given(seeds)
def test_two_nodes_of_the_plane_hold_what_a_bar_with_a_body_holds(seed):
    rng = np.random.default_rng(seed)
    mass, center, inertia = some_body(rng, 2)
    p, q = some_points(rng, 2, 2)
    u = (q - p) / np.linalg.norm(q - p)
    e, f = (center - p) @ u, u[0] * (center - p)[1] - u[1] * (center - p)[0]
    nodes = {"P": tuple(p), "Q": tuple(q)}
    bar = kt.Bar(ends=("P", "Q"), body=kt.PlanarBody(mass=mass, center=(e, f), inertia=inertia))
    one = compile(kt.Model(nodes=nodes, bars={"b": bar}))
    two = compile(kt.Model(nodes=nodes, bodies={"b": kt.Body(nodes=("P", "Q"), mass=mass, center=center, inertia=inertia)}))
    plane = [0, 1, 3, 4]
    M = mass_matrix(one, one.x0).toarray()[np.ix_(plane, plane)]
    assert np.abs(mass_matrix(two, two.x0).toarray()[np.ix_(plane, plane)] - M).max() < 1e-12 * np.abs(M).max()


def test_a_body_grows_alike_in_all_directions_on_two_nodes():
    """Its kinetic energy in a uniform dilation is half the rate squared times the polar moment."""
    mass, center, inertia = 1.5, np.array([0.2, 0.3]), 0.4
    pp, pq, qq, skew = on_line((0, 0), (1, 0.5), mass, center, inertia)
    v = np.array([[0, 0], [1, 0.5]]) - center  # rate 1/s about the centre
    M = np.block([[pp * np.eye(2), pq * np.eye(2) + skew * np.array([[0, -1], [1, 0]])],
                  [pq * np.eye(2) + skew * np.array([[0, 1], [-1, 0]]), qq * np.eye(2)]])  # fmt: skip
    assert abs(v.reshape(-1) @ M @ v.reshape(-1) - inertia) < 1e-14


def test_a_frame_turns_the_moments():
    turn = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    nodes, frame = tuple(CORNERS), kt.Frame(origin=(0.1, 0.2, 0.3), axes=turn)
    one = kt.Body(nodes=nodes, mass=2.0, center=(0.5, 0.0, 0.0), inertia=(0.3, 0.4, 0.5), frame=frame)
    two = kt.Body(nodes=nodes, mass=2.0, center=(0.1, 0.7, 0.3), inertia=(0.4, 0.3, 0.5))
    a, b = (body_mass(kt.Model(nodes=CORNERS, bodies={"b": body}), body)[0] for body in (one, two))
    assert np.abs(a - b).max() < 1e-14


@pytest.mark.parametrize("count", [2, 3, 4])
def test_weight_and_diagonals(count):
    points = some_points(np.random.default_rng(count), count)
    names = [f"N{k}" for k in range(count)]
    model = kt.Model(
        nodes={n: tuple(p) for n, p in zip(names, points, strict=True)},
        bodies={"b": kt.Body(nodes=names, mass=3.0)},
        gravity=(0, 0, -2.0),
    )
    system = compile(model)
    assert np.allclose(system.node_mass, 2 * 3.0 / (count * (count + 1)), rtol=1e-14)
    assert not system.thin.any()
    M = mass_matrix(system, system.x0).toarray()
    assert abs(np.tile([0, 0, 1.0], count) @ M @ np.tile([0, 0, 1.0], count) - 3.0) < 1e-14


def test_a_plate_on_four_nodes_is_thin():
    model = model_of(np.array(list(CORNERS.values())), 1.0, (0.5, 0, 0), (0.1, 0.2, 0.3))
    assert compile(model).thin.all()


@given(seeds)
def test_the_best_simplex_is_regular(seed):
    points = np.random.default_rng(seed).normal(size=(4, 3))
    assume(quality(points) > 0)
    assert quality(points) <= 1 + 1e-12
    regular = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
    assert abs(quality(regular) - 1) < 1e-14
    assert abs(quality(regular[:3]) - 1) < 1e-14
