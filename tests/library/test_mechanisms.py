"""Mechanisms of the library: they close, move as they should at the start, have the freedom that they claim."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.errors import ModelError
from kinetruss.library import mechanisms
from reference import andrews, linkages, pendulums

ANGLES = st.floats(-7, 7)
BUILT = {
    "pendulum": (lambda a, w: mechanisms.pendulum(angle=a, rate=w), 1),
    "double": (lambda a, w: mechanisms.double_pendulum(angles=(a, -2 * a), rates=(w, 0.3)), 2),
    "chain": (lambda a, w: mechanisms.n_pendulum(links=4, angle=a, rate=w), 4),
    "slider_crank": (lambda a, w: mechanisms.slider_crank(angle=a, rate=w, offset=0.05), 1),
    "spatial": (lambda a, w: mechanisms.spatial_slider_crank(angle=a, rate=w), 1),
    "four_bars": (lambda a, w: mechanisms.n_four_bar(loops=3, angle=a, rate=w), 1),
}


def state(model: kt.Model) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Places and velocities of all nodes."""
    zero = np.zeros(model.dim)
    return (
        {name: np.array(node.at) for name, node in model.nodes.items()},
        {name: np.array(model.velocities.get(name, zero)) for name in model.nodes},
    )


@pytest.mark.slow
@pytest.mark.parametrize("name", BUILT)
@given(angle=ANGLES, rate=st.floats(-5, 5))
def test_bars_have_their_length_and_keep_it(name, angle, rate):
    model = BUILT[name][0](angle, rate)
    x, v = state(model)
    for bar in model.bars.values():
        a, b = bar.ends
        assert math.dist(x[a], x[b]) == pytest.approx(bar.length, rel=1e-13)
        assert (x[b] - x[a]) @ (v[b] - v[a]) == pytest.approx(0, abs=1e-12)
    for node, axes in model.fixed.items():
        assert all(v[node]["xyz".index(axis)] == 0 for axis in axes)


@pytest.mark.parametrize("name", BUILT)
def test_freedom(name):
    build, freedom = BUILT[name]
    model = build(0.7, 1.0)
    free = model.with_(drives={}) if model.drives else model
    assert kt.kinematics.mobility(free).undriven == freedom


def test_row_of_four_bars_gains_a_freedom_only_where_it_lies_flat():
    flat, tilted = (kt.kinematics.mobility(mechanisms.n_four_bar(loops=3, angle=a)) for a in (math.pi / 2, math.pi / 2 - 0.1))
    assert (flat.undriven, tilted.undriven) == (4, 1)


def test_andrews_stands_where_its_angles_say():
    model = mechanisms.andrews()
    for name, place in andrews.points(andrews.START).items():
        np.testing.assert_allclose(model.nodes[name].at, place, atol=1e-17)
    for name, bar in model.bars.items():
        if bar.kind == "rigid":
            assert math.dist(*(model.nodes[end].at for end in bar.ends)) == pytest.approx(bar.length, rel=1e-14), name
    assert kt.kinematics.mobility(model.with_(drives={}, runs={})).undriven == 1


def test_andrews_bodies_are_those_of_the_angles():
    """Masses, inertias and centres of the bars against the centres of the angle formulation."""
    model = mechanisms.andrews()
    x = {name: complex(*node.at) for name, node in model.nodes.items()}
    bodies = [bar for bar in model.bars.values() if bar.body]
    expected = sorted((mass, inertia, *_place(centre)) for mass, inertia, _, centre in andrews.BODIES)
    found = []
    for bar in bodies:
        p, q = (x[end] for end in bar.ends)
        z = p + complex(*bar.body.center) * (q - p) / abs(q - p)
        found.append((bar.body.mass, bar.body.inertia, z.real, z.imag))
    np.testing.assert_allclose(sorted(found), expected, rtol=1e-13, atol=1e-16)


def _place(point: andrews.Point) -> tuple[float, float]:
    z = point[0] + sum(r * np.exp(1j * (n @ andrews.START)) for r, n in point[1])
    return z.real, z.imag


def test_start_of_the_pendulums_is_that_of_the_angles():
    model = mechanisms.double_pendulum(lengths=(1.0, 0.7), angles=(0.5, 2.0), rates=(1.0, -3.0))
    chain = pendulums.Chain((1.0, 0.7), (0.0, 0.0), (1.0, 1.0))
    places, velocities, _ = chain.joints(np.array([0.5, 2.0]), np.array([1.0, -3.0]))
    x, v = state(model)
    np.testing.assert_allclose([x["P1"], x["P2"]], places, atol=1e-15)
    np.testing.assert_allclose([v["P1"], v["P2"]], velocities, atol=1e-15)


def test_spatial_slider_crank_starts_as_its_oracle():
    x, v = state(mechanisms.spatial_slider_crank(angle=0.4, rate=2.0))
    s, first, _ = linkages.SlidingCrank().slide(0.4)
    assert x["S"][0] == pytest.approx(s, rel=1e-14)
    assert v["S"][0] == pytest.approx(2.0 * first, rel=1e-14)


def test_faults_are_named():
    with pytest.raises(ModelError, match="rod: 0.05 m does not reach the slider's line"):
        mechanisms.slider_crank(rod=0.05)
    with pytest.raises(ModelError, match="rod: "):
        mechanisms.spatial_slider_crank(rod="10 cm")
    with pytest.raises(ModelError, match="loops"):
        mechanisms.n_four_bar(loops=0)


@pytest.mark.parametrize("strain", ["engineering", "green"])
def test_von_mises_truss_by_name_and_with_units(strain):
    model = kt.library.build("mechanisms.von_mises", {"rise": "30 cm", "stiffness": "2 N/mm", "strain": strain, "load": "1 N"})
    assert model.nodes["T"].at == (0.0, 0.3)
    assert {bar.stiffness for bar in model.bars.values()} == {2000.0}
    assert {bar.strain for bar in model.bars.values()} == {strain}


@pytest.mark.slow
def test_oracles_of_linkages_against_integration():
    """The closed form of the row and Lagrange's equation conserve what they must."""
    times = np.linspace(0, 10, 201)
    for loops in (1, 2, 40):
        theta, rate = linkages.row_of_four_bars(loops, times)
        mass, pull = (loops + 1) / 3 + loops, 9.81 * ((loops + 1) / 2 + loops)
        energy = mass * rate**2 / 2 + pull * np.cos(theta)
        np.testing.assert_allclose(energy, energy[0], rtol=1e-13)
        slope = np.gradient(theta, times, edge_order=2)
        np.testing.assert_allclose(slope, rate, atol=0.03 * rate.max())
    crank = linkages.SlidingCrank()
    theta, rate = crank.run(np.linspace(0, 5, 11))
    energy = [crank.energy(*pair) for pair in zip(theta, rate, strict=True)]
    np.testing.assert_allclose(energy, energy[0], rtol=1e-11)


def test_the_number_of_windows_or_links_needs_no_name():
    assert mechanisms.n_four_bar(3).bars == mechanisms.n_four_bar(loops=3).bars
    assert mechanisms.n_pendulum(4).nodes == mechanisms.n_pendulum(links=4).nodes
