"""Planar bodies: their mass matrix in closed form, and mechanisms against the same ones made of point masses."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.mechanics.matrices import mass_matrix
from kinetruss.mechanics.tables import planar_body_mass
from kinetruss.statics.small_displacements import end_weights

lengths = st.floats(0.1, 3.0)
places = st.floats(-2.0, 2.0)
masses = st.floats(0.1, 5.0)
angles = st.floats(0.0, 2 * np.pi)

SPIN = kt.ConstantRate(rates={"motor": 10.0}, duration=0.6)
E_, F_, MASS, INERTIA = 0.12, 0.05, 1.3, 0.02


def matrix(mass, e, f, inertia, l):
    """The 4 x 4 mass matrix of [x_A, y_A, x_B, y_B]."""
    pp, pq, qq, cross = planar_body_mass(mass, e, f, inertia, l)
    return np.array([[pp, 0, pq, -cross], [0, pp, cross, pq], [pq, cross, qq, 0], [-cross, pq, 0, qq]])


def carried(xi, eta):
    """Velocity of a point at (xi, eta) l of the bar from those of its ends, (2, 4)."""
    return np.array([[1 - xi, eta, xi, -eta], [-eta, 1 - xi, eta, xi]])


@given(masses, places, places, masses, lengths, angles)
def test_same_as_any_dumb_bell(mass, e, f, inertia, l, turned):
    h = np.sqrt(inertia / mass) * np.array([np.cos(turned), np.sin(turned)])
    halves = [carried(*((np.array([e, f]) + sign * h) / l)) for sign in (1, -1)]
    wanted = sum(0.5 * mass * N.T @ N for N in halves)
    assert np.abs(matrix(mass, e, f, inertia, l) - wanted).max() < 1e-12 * np.abs(wanted).max()


@given(masses, places, places, masses, lengths)
def test_determinant(mass, e, f, inertia, l):
    found = matrix(mass, e, f, inertia, l)
    scale = np.abs(found).max() ** 4
    assert abs(np.linalg.det(found) - (mass * inertia / l**2) ** 2) < 1e-12 * scale


@given(masses, places, places, masses, lengths, angles)
def test_rotation_changes_nothing(mass, e, f, inertia, l, turned):
    c, s = np.cos(turned), np.sin(turned)
    turn = np.kron(np.eye(2), [[c, -s], [s, c]])
    found = matrix(mass, e, f, inertia, l)
    assert np.abs(turn @ found @ turn.T - found).max() < 1e-12 * np.abs(found).max()


@given(masses, places, places, masses, lengths)
def test_swapped_ends(mass, e, f, inertia, l):
    swap = [2, 3, 0, 1]
    found = matrix(mass, e, f, inertia, l)
    other = matrix(mass, l - e, -f, inertia, l)[np.ix_(swap, swap)]
    assert np.abs(other - found).max() < 1e-12 * np.abs(found).max()


def test_uniform_rod():
    m, l = 1.7, 0.8
    wanted = m / 6 * np.kron([[2, 1], [1, 2]], np.eye(2))
    assert np.abs(matrix(m, l / 2, 0.0, m * l**2 / 12, l) - wanted).max() < 1e-15


def fourbar(coupler, extra=None, **changes):
    """A four-bar whose coupler carries all mass; `extra` nodes and bars beside it."""
    nodes, bars = extra or ({}, {})
    fields = {
        "nodes": {"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)} | nodes,
        "fixed": ("A", "D"),
        "bars": {"crank": ("A", "B"), "rocker": ("C", "D"), "coupler": coupler} | bars,
        "drives": {"motor": kt.AngleDrive("crank")},
        "gravity": (0.0, -9.81),
    }
    return kt.Model(**fields | changes)


def dumb_bell(turned=0.7):
    """Nodes and bars of two point masses that stand for the body of the coupler."""
    B, C = np.array([0, 0.10]), np.array([0.30, 0.25])
    u = (C - B) / np.linalg.norm(C - B)
    n = np.array([-u[1], u[0]])
    h = np.sqrt(INERTIA / MASS) * (np.cos(turned) * u + np.sin(turned) * n)
    nodes, bars = {}, {}
    for sign, name in ((1, "P"), (-1, "Q")):
        nodes[name] = kt.Node(at=tuple(B + E_ * u + F_ * n + sign * h), mass=MASS / 2)
        bars |= {f"b{name}": ("B", name), f"c{name}": ("C", name)}
    return nodes, bars


def body(swapped=False):
    l = float(np.hypot(0.30, 0.15))
    center = (l - E_, -F_) if swapped else (E_, F_)
    return kt.Bar(ends=("C", "B") if swapped else ("B", "C"), body=kt.PlanarBody(mass=MASS, center=center, inertia=INERTIA))


def forces_of(model):
    motion = kt.kinematics.follow(model, SPIN, samples=13)
    return kt.dynamics.inverse(model, motion)


@pytest.mark.slow
@pytest.mark.parametrize("swapped", [False, True])
def test_mechanism_against_point_masses(swapped):
    found, wanted = forces_of(fourbar(body(swapped))), forces_of(fourbar(("B", "C"), dumb_bell()))
    for name in ("drive_force", "reaction", "energy", "power"):
        size = float(abs(wanted.data[name]).max())
        assert float(abs(found.data[name] - wanted.data[name]).max()) < 1e-13 * size
        if name in found.static.data:
            assert float(abs(found.static.data[name] - wanted.static.data[name]).max()) < 1e-13 * size
    assert float(abs(found.data["energy_balance"]).max()) < 1e-13 * float(abs(found.data["power"]).max())


@pytest.mark.slow
@pytest.mark.parametrize("swapped", [False, True])
@pytest.mark.parametrize("static", [False, True])
def test_newton_and_euler(swapped, static):
    model = fourbar(body(swapped))
    forces = forces_of(model)
    forces = forces.static if static else forces
    for time in (0.0, 0.2, 0.55):
        system = kt.dynamics.newton_euler(model, forces.motion, forces, time=time)
        assert system.unique
        assert system.difference < 1e-12 * system.largest * system.condition
        cut = kt.dynamics.free_body(model, forces.motion, forces, member="coupler", time=time)
        assert cut.residual < 1e-13 * cut.largest
        assert cut.bodies[0].mass == MASS


@pytest.mark.slow
def test_centre_of_mass_and_its_rates():
    model, other = fourbar(body()), fourbar(("B", "C"), dumb_bell())
    forces, wanted = forces_of(model), forces_of(other).motion.data
    rates = kt.kinematics.member_rates(model, forces.motion)
    for name, of_node in (("centre", "position"), ("centre_velocity", "velocity"), ("centre_acceleration", "acceleration")):
        middle = 0.5 * (wanted[of_node].sel(node="P") + wanted[of_node].sel(node="Q"))
        miss = rates[name].sel(member="coupler").values - middle.values
        assert np.abs(miss).max() < 1e-13 * float(abs(middle).max())
    cut = kt.dynamics.free_body(model, forces.motion, forces, member="coupler", time=0.2).bodies[0]
    at = rates.sel(member="coupler").sel(time=0.2, method="nearest")
    assert np.allclose(cut.centre, at["centre"], rtol=0, atol=1e-15)
    assert np.allclose(cut.acceleration, at["centre_acceleration"], rtol=1e-13, atol=0)


def test_weight_at_the_ends_has_the_resultant_of_the_body():
    model = fourbar(body())
    system = compile(model)
    i = system.members.index("coupler")
    g = np.array([1.0, -9.0, 0.0])
    A, B = end_weights(system, system.x0, g)[i]
    d = system.x0[system.q[i]] - system.x0[system.p[i]]
    u = d / np.linalg.norm(d)
    centre = E_ * u + F_ * np.array([-u[1], u[0], 0.0])
    assert np.abs(A + B - MASS * g).max() < 1e-14
    assert abs(np.cross(d, B)[2] - np.cross(centre, MASS * g)[2]) < 1e-14


@given(st.floats(0.5, 2.0), angles)
def test_its_weight_is_that_of_dynamics_where_it_is_drawn_at_another_length(drawn, turned):
    """The mass matrix is that of the given length; statics took the drawn one."""
    bar = kt.Bar(ends=("A", "B"), length=0.3, body=kt.PlanarBody(mass=MASS, center=(E_, F_), inertia=INERTIA))
    end = (0.3 * drawn * np.cos(turned), 0.3 * drawn * np.sin(turned))
    system = compile(kt.Model(nodes={"A": (0, 0), "B": end}, bars={"bar": bar}, fixed=["A"]))
    g = np.array([1.0, -9.0, 0.0])
    weight = end_weights(system, system.x0, g)[0]
    assert np.abs(weight.reshape(-1) - mass_matrix(system, system.x0) @ np.tile(g, 2)).max() < 1e-14
    assert np.abs(weight[1] - MASS / 0.3 * (E_ * g - F_ * np.array([-g[1], g[0], 0.0]))).max() < 1e-13


def test_linear_statics_carries_its_weight():
    steel = {"section": kt.Rod(diameter=0.02), "material": kt.Material(E=210e9, density=0.0)}
    legs = {"left": kt.Bar(ends=("A", "B"), **steel), "right": kt.Bar(ends=("D", "C"), **steel)}
    legs["diagonal"] = kt.Bar(ends=("A", "C"), **steel)
    model = fourbar(body(), drives={}).with_(bars=legs | {"coupler": body()})
    found = kt.statics.linear(model)
    assert "coupler" in found.message
    total = found.data["reaction"].sum("support").values
    assert np.abs(total - (0, 9.81 * MASS)).max() < 1e-12 * 9.81 * MASS


@pytest.mark.slow
def test_no_sections_and_the_verdict_says_why():
    model = fourbar(body(), section=kt.Rod(diameter=0.01), material=kt.Material(E=210e9, density=7850, yield_strength=240e6))
    assert compile(model).rods[compile(model).is_body].max() == 0  # the default section adds no mass to it
    forces = forces_of(model)
    sections = kt.strength.sections(model, forces).data
    assert np.isnan(sections["section_T"].sel(part="coupler")).all()
    assert not np.isnan(sections["section_T"].drop_sel(part="coupler")).any()
    verdict = kt.strength.check(model, forces)
    rows = {(row.part, row.rule): row for row in verdict.table()}
    assert rows["coupler", "yield"].note == "not checked: no section forces of a planar body"
    assert ("coupler", "buckling") not in rows
    assert rows["rocker", "yield"].checked
