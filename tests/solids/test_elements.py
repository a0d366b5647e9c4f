"""Elements against the total-Lagrangian formulas, invariants, stress, and the same structure made otherwise."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.elements.continua_matrices import continua_forces, continua_stiffness, densities
from kinetruss.mechanics import compile
from kinetruss.mechanics.elements import element_energy
from kinetruss.verification import solids as cases
from kinetruss.verification.cases import model as model_of
from reference.total_lagrange import KINDS, tangent

STEEL = cases.STEEL


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_force_and_tangent_are_those_of_the_formulas(kind):
    found = cases.element(kind)
    assert found["force"] < 1e-13
    assert found["tangent"] < 1e-13
    assert found["rotation"] < 1e-14


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_the_whole_tangent_is_that_of_the_formulas(kind):
    model = model_of(f"element.{kind}")
    start = np.array([node.at for node in model.nodes.values()], float)
    x = start + 0.4 * np.random.default_rng(3).standard_normal(start.shape)
    dofs = [f"{name}.{axis}" for name in model.nodes for axis in "xyz"[: start.shape[1]]]
    K, exact = kt.dynamics.linearise(model, x, dofs=dofs).stiffness.values, tangent(kind, start, x)
    assert np.abs(K - exact).max() < 1e-13 * np.abs(exact).max()


@pytest.mark.parametrize("kind", KINDS)
def test_small_stretches_have_all_digits(kind):
    """Forces where nodes move by a billionth, against the same formula with more digits: differences of squares lose seven."""
    system = compile(model_of(f"element.{kind}"))
    moved = 1e-9 * np.random.default_rng(1).standard_normal((len(system.x0), system.dim))
    x = system.x0.copy()
    x[:, : system.dim] += moved
    found = system.continua
    d, d0 = (y.astype(np.longdouble)[found.q] - y.astype(np.longdouble)[found.p] for y in (x, system.x0))
    q = densities(found, np.asarray((d * d - d0 * d0).sum(axis=1), float))
    exact = np.zeros_like(x)
    np.add.at(exact, found.p, q[:, None] * np.asarray(d, float))
    np.subtract.at(exact, found.q, q[:, None] * np.asarray(d, float))
    f = continua_forces(found, x.reshape(1, -1)).reshape(-1, 3)
    # of longdouble some 1e-19/1e-9 are left
    assert np.abs(f - exact).max() < 1e-9 * np.abs(exact).max()


@pytest.mark.slow
@settings(max_examples=15)
@given(kind=st.sampled_from(KINDS), seed=st.integers(0, 10_000), size=st.floats(0.01, 0.5))
def test_forces_balance_are_the_slope_of_the_energy_and_do_no_work_on_rotations(kind, seed, size):
    system = compile(model_of(f"element.{kind}"))
    random = np.random.default_rng(seed)
    x, y = system.x0.copy(), np.zeros_like(system.x0)
    x[:, : system.dim] += size * random.standard_normal((len(x), system.dim))
    y[:, : system.dim] = random.standard_normal((len(x), system.dim))
    f = continua_forces(system.continua, x.reshape(1, -1)).reshape(-1, 3)
    scale = np.abs(f).max()
    assert np.abs(f.sum(axis=0)).max() < 1e-13 * scale
    assert np.abs(np.cross(x, f).sum(axis=0)).max() < 1e-12 * scale
    h = 1e-4
    steps = [element_energy(system, x + k * h * y) for k in (-2, -1, 1, 2)]
    # the energy is of degree four along a line, so this difference is exact but for round-off
    slope = (steps[0] - 8 * steps[1] + 8 * steps[2] - steps[3]) / (12 * h)
    assert abs(slope + np.sum(f * y)) < 1e-9 * max(scale, abs(steps[1]) / h * 1e-3)
    K = continua_stiffness(system.continua, x)
    assert abs(K - K.T).max() <= 1e-15 * abs(K).max()


def test_shared_edges_are_there_once_and_diagonals_change_nothing_in_a_uniform_state():
    grid = kt.library.meshes.rectangle(width=2.0, height=1.0, columns=2, rows=1)
    model = kt.Model(nodes=grid.nodes, material=STEEL, membranes={"p": grid.membrane(thickness=0.1)})
    found = compile(model).continua
    assert len(found.p) == 9  # 6 nodes, 4 triangles: Euler
    assert found.lump.sum() + 2 * found.mass.sum() == pytest.approx(STEEL.density * 0.2, rel=1e-14)
    box = kt.library.meshes.box(size=(1.0, 1.0, 1.0), cells=(1, 1, 1))
    solid = compile(kt.Model(nodes=box.nodes, material=STEEL, solids={"p": box.solid()})).continua
    assert len(solid.p) == 19
    assert solid.lump.sum() + 2 * solid.mass.sum() == pytest.approx(STEEL.density, rel=1e-14)


def test_a_triangle_with_the_stress_along_one_edge_is_a_bar_under_greens_strain():
    # without Poisson's ratio and sheared to nothing: only the edge along x is stretched
    thin = kt.Material(E=1e9, density=0.0, poisson=0.0)
    nodes = {"A": (0.0, 0.0), "B": (1.0, 0.0), "C": (0.0, 1.0)}
    model = kt.Model(nodes=nodes, membranes={"m": kt.Membrane(elements=[("A", "B", "C")], thickness=0.01, material=thin)})
    x = np.array([[0.0, 0.0], [1.3, 0.0], [0.0, 1.0]])
    found = kt.strength.elements(model, x, "m")
    green = (1.3**2 - 1) / 2
    assert found.strain.values[0] == pytest.approx([green, 0, 0], abs=1e-15)
    assert found.true_stress.sel(true_component="xx").item() == pytest.approx(1e9 * green * 1.3, rel=1e-14)
    assert found.von_mises.item() == pytest.approx(1e9 * green * 1.3, rel=1e-14)
    assert found.energy.item() == pytest.approx(0.5 * 1e9 * green**2 * 0.005, rel=1e-14)
    full = np.pad(x, ((0, 0), (0, 1)))
    assert element_energy(compile(model), full) == pytest.approx(found.energy.item(), rel=1e-14)


@pytest.mark.parametrize("strain", ["constant", "linear"])
def test_energy_of_the_elements_is_that_of_the_structure(strain):
    grid = kt.library.meshes.rectangle(width=2.0, height=1.0, columns=2, rows=2, six_nodes=True)
    model = kt.Model(nodes=grid.nodes, material=STEEL, membranes={"p": grid.membrane(thickness=0.1, strain=strain)})
    system = compile(model)
    x = system.x0.copy()
    x[:, :2] += 0.02 * np.random.default_rng(2).standard_normal((len(x), 2))
    found = kt.strength.elements(model, x[:, :2], "p")
    assert found.energy.dims == ("element", "point")
    assert float(found.energy.sum()) == pytest.approx(element_energy(system, x), rel=1e-12)
    assert float(found.volume.sum()) == pytest.approx(0.2, rel=1e-13)


def test_plane_strain_is_a_solid_held_on_both_sides():
    block = kt.library.meshes.box(size=(1.0, 1.0, 1.0), cells=(1, 1, 1))
    stretch = np.array([1.1, 0.95, 1.0])
    solid = kt.Model(nodes=block.nodes, material=STEEL, solids={"s": block.solid()})
    flat = kt.library.meshes.rectangle(width=1.0, height=1.0, columns=1, rows=1)
    plate = kt.Model(nodes=flat.nodes, material=STEEL, membranes={"p": flat.membrane(thickness=1.0, plane="strain")})
    one = kt.strength.elements(solid, block.points * stretch, "s").isel(element=0)
    two = kt.strength.elements(plate, flat.points * stretch[:2], "p").isel(element=0)
    assert two.true_stress.values == pytest.approx(one.true_stress.values, rel=1e-13, abs=1e-3)
    assert two.von_mises.item() == pytest.approx(one.von_mises.item(), rel=1e-13)
