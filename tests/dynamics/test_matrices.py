"""Mass, damping and stiffness matrices: complex steps, differences of the forces that inverse dynamics finds, energies."""

from dataclasses import replace

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.least_norm import apply_loads
from kinetruss.dynamics.linear_state import moving_forces
from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.mechanics import compile, constraint_jacobian
from kinetruss.mechanics.balance import balance_of, balanced_rows
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.matrices import bar_laws, mass_matrix, tangents

RNG = np.random.default_rng(7)
SECTION = kt.Tube(outer=0.019, inner=0.016)
METAL = kt.Material(E=71e9, density=2711.5)


def web(dim: int = 3) -> kt.Model:
    """One of each: laws, damper, rigid bar, active member, rotary inertia, planar body."""
    nodes = {"A": (0, 0, 0), "B": (1.1, 0.2, 0.1), "C": (0.3, 0.9, -0.2), "D": (0.8, 1.1, 0.7)}
    bars = {
        "green": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=300.0, natural_length=1.0, strain="green", mass=0.7),
        "spring": kt.Bar(ends=("B", "C"), kind="elastic", stiffness=200.0, natural_length=1.0, damping=3.0, mass=0.4),
        "cable": kt.Bar(ends=("A", "C"), kind="cable", stiffness=150.0, natural_length=0.8, mass=0.0),
        "slack": kt.Bar(ends=("A", "D"), kind="cable", stiffness=150.0, natural_length=2.8, mass=0.0),
        "rigid": kt.Bar(ends=("B", "D"), mass=1.3, section=SECTION, material=METAL, rotary_inertia=True),
        "damper": kt.Bar(ends=("C", "D"), kind="free", damping=2.0, mass=0.2),
    }
    active = {"M": kt.Active(ends=("C", "B"), base=kt.Part(length=0.7, mass=3.0), tube=kt.Part(length=0.5, mass=1.0))}
    if dim == 2:
        nodes = {name: at[:2] for name, at in nodes.items()}
        bars["body"] = kt.Bar(ends=("A", "B"), body=kt.PlanarBody(mass=2.0, center=(0.3, -0.2), inertia=0.4))
    return kt.Model(nodes=nodes, bars=bars, active=active, gravity=(0.3, -9.81, 0.5)[:dim],
                    loads={"l": kt.NodalForce(node="D", force=(1.0, 2.0, 3.0)[:dim])},
                    fixed={"A": "xyz"[:dim], "B": "x"})  # fmt: skip


def left_over(system, loads, x, v, a):
    """f - M a (3 n,) by the kernels of inverse dynamics."""
    joint, rest = np.empty((1, len(system.members), 2, 3)), np.empty((1, x.size))
    apply_loads(system, loads, States(*(np.ascontiguousarray(y.reshape(1, -1)) for y in (x, v, a))), EndForces(joint, rest))
    return rest[0]


def inertia(model, x, v, a):
    """M a + h by the same kernels, with nothing else acting."""
    system = compile(model)
    bare = replace(
        system,
        damping=np.zeros(len(system.members)),
        law=np.zeros(len(system.members), np.int8),
        spring=np.zeros(len(system.members)),
    )
    loads = case_loads(system, np.zeros(1), None)
    still = replace(loads, gravity=np.zeros(3), lump_gravity=0 * loads.lump_gravity, force=0 * loads.force)
    return -left_over(bare, still, x, v, a)


def random_state(system):
    x = system.x0 + 0.05 * RNG.normal(size=system.x0.shape)
    v, a = RNG.normal(size=(2, *x.shape))
    x[:, system.dim :] = v[:, system.dim :] = a[:, system.dim :] = 0
    return x, v, a


@pytest.mark.parametrize("dim", [2, 3])
def test_mass_matrix_is_that_of_inverse_dynamics(dim):
    model = web(dim)
    system = compile(model)
    x, _, a = random_state(system)
    x = system.x0.copy() if dim == 2 else x  # a body's matrix belongs to its length
    M = mass_matrix(system, x)
    np.testing.assert_allclose(M @ a.reshape(-1), inertia(model, x, 0 * a, a), atol=1e-13)
    np.testing.assert_allclose((M - M.T).toarray(), 0, atol=1e-14)
    assert np.linalg.eigvalsh(M.toarray()).min() > -1e-14
    total = system.rods[:, [0, 3]].sum() + system.body[:, 0].sum()
    lift = np.tile([1.0, 0, 0], len(system.nodes))
    assert lift @ M @ lift == pytest.approx(total, rel=1e-13)


@pytest.mark.parametrize("dim", [2, 3])
def test_stiffness_at_rest_against_complex_and_real_steps(dim):
    model = web(dim)
    system = compile(model)
    x, _, _ = random_state(system)
    x = system.x0.copy() if dim == 2 else x
    balance = balance_of(system)
    N = RNG.normal(size=len(balance.system.row_member)) * 50
    K = balance.stiffness(x, N).toarray()
    np.testing.assert_allclose(K, K.T, atol=1e-10)

    def left(y):
        return balance.applied(y) - constraint_jacobian(balance.system, y).T @ N

    h = 1e-6
    for flat in range(x.size):
        if flat % 3 >= dim:
            continue
        step = np.zeros(x.size)
        step[flat] = h
        step = step.reshape(x.shape)
        slope = (left(x + step) - left(x - step)) / (2 * h)
        np.testing.assert_allclose(-K[:, flat].reshape(-1, 3)[:, :dim], slope.reshape(-1, 3)[:, :dim], atol=2e-6)


def test_laws_against_complex_steps():
    system = compile(web())
    L, Ld = np.linalg.norm(system.x0[system.q] - system.x0[system.p], axis=1), RNG.normal(size=len(system.members)) * 0.01
    pull, slope, damping, _ = bar_laws(system, L, Ld)
    h = 1e-30
    for k, name in enumerate(system.members):
        at, rate = L.astype(complex), Ld.astype(complex)
        at[k] += 1j * h
        rate[k] += 1j * h
        if name in ("green", "spring", "cable", "damper"):
            # comparisons of the law look at real parts
            def tension(length, speed, k=k):
                excess = length - system.natural[k]
                if system.law[k] == 2:
                    return 0.5 * system.spring[k] * excess * (length + system.natural[k]) * length / system.natural[k] ** 2 + (
                        system.damping[k] * speed
                    )
                return system.spring[k] * excess + system.damping[k] * speed

            assert tension(L[k], Ld[k]) == pytest.approx(pull[k], rel=1e-14)
            assert (tension(at[k], Ld[k])).imag / h == pytest.approx(slope[k], rel=1e-13)
            assert (tension(L[k], rate[k])).imag / h == pytest.approx(damping[k], rel=1e-13)
        else:
            assert pull[k] == slope[k] == damping[k] == 0


def test_tangents_of_a_moving_state_against_differences():
    """f - M a - J^T N by the kernels of inverse dynamics, differenced by x and by v."""
    model = web()
    system = compile(model)
    x, v, a = random_state(system)
    balance = balance_of(system)
    N = RNG.normal(size=len(balance.system.row_member)) * 20
    d = x[system.q] - x[system.p]
    L = np.linalg.norm(d, axis=1)
    Ld = np.einsum("mc,mc->m", d / L[:, None], (v[system.q] - v[system.p]))
    tension = bar_laws(system, L, Ld).tension
    np.add.at(tension, system.row_member, N)
    K, C = tangents(system, x, tension, np.zeros_like(L), balance.gravity, v, a)

    loads = case_loads(system, np.zeros(1), None)

    def left(y, w):
        return left_over(system, loads, y, w, a) - constraint_jacobian(system, y).T @ N

    h = 1e-6
    for flat in range(x.size):
        step = np.zeros(x.size)
        step[flat] = h
        step = step.reshape(x.shape)
        by_x = (left(x + step, v) - left(x - step, v)) / (2 * h)
        by_v = (left(x, v + step) - left(x, v - step)) / (2 * h)
        np.testing.assert_allclose(-K.toarray()[:, flat], by_x, atol=2e-6)
        np.testing.assert_allclose(-C.toarray()[:, flat], by_v, atol=2e-6)


def test_convective_forces_are_those_of_inverse_dynamics():
    model = web()
    system = compile(model)
    x, v, a = random_state(system)
    balance = balance_of(system)
    light = replace(balance, system=replace(balance.system, damping=0 * system.damping))
    found = moving_forces(light, x, v) - moving_forces(light, x, 0 * v)
    np.testing.assert_allclose(-found, inertia(model, x, v, 0 * a), atol=1e-12)


def test_potential_energy_is_that_of_the_forces():
    model = web().with_(drives={"slide": kt.CoordinateDrive(node="C", axis="x")}, fixed={"A": "xyz"})
    system = compile(model)
    balance = balance_of(system, tasks={"M": kt.GivenForce(30.0), "slide": kt.GivenForce(-4.0)})
    x, v, _ = random_state(system)
    h = 1e-5
    work = (balance.energy_change(x, x + h * v) - balance.energy_change(x, x - h * v)) / (2 * h)
    assert work == pytest.approx(-balance.applied(x) @ v.reshape(-1), rel=1e-8)


def test_torque_of_an_angle_drive():
    crank = kt.Model(nodes={"A": (0, 0), "B": (0.3, 0.4)}, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), kind="free")},
                     drives={"turn": kt.AngleDrive("b")})  # fmt: skip
    balance = balance_of(compile(crank), tasks={"turn": kt.GivenForce(torque=2.0)})
    x = compile(crank).x0
    np.testing.assert_allclose(balance.applied(x)[3:5], 2.0 / 0.5 * np.array([-0.8, 0.6]), rtol=1e-14)
    turned = np.zeros_like(x)
    turned[1, :2] = 0.5 * np.cos(1.2), 0.5 * np.sin(1.2)
    assert balance.energy_change(x, turned) == pytest.approx(-2.0 * (1.2 - np.arctan2(0.4, 0.3)), rel=1e-12)
    held = balance_of(compile(crank))
    N = balanced_rows(held, x, balance.applied(x))
    assert -N[0] * 0.5 == pytest.approx(-2.0)
