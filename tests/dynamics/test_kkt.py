"""The three solvers of the equations of motion: residuals at round-off, the same answers, forces as in inverse dynamics."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

import kinetruss as kt
from kinetruss.dynamics.equations import equations
from kinetruss.dynamics.integrators import control
from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.integrate.tangent import tangent_factor, tangent_solve
from kinetruss.kernels.solve.accelerations import evaluate
from kinetruss.kernels.solve.kkt import prepare_rows, project
from kinetruss.kernels.structure.applied import applied, no_force
from kinetruss.kernels.structure.mass import mass_times
from kinetruss.library import mechanisms, vgt
from kinetruss.mechanics import compile
from kkt_models import consistent, mass_matrix, rows_matrix
from random_trusses import truss

SOLVERS = ("dense", "sparse", "sweep")
EPS = np.finfo(float).eps


def solved(model, solver, *, seed=0, t=0.0, state=None, **given_):
    """System-order forces, accelerations and the pieces of the equations at a state, by default a random consistent one."""
    system = compile(model)
    eq, ws = equations(system, solver=solver, **given_)
    x, v = consistent(system, eq, ws, seed, t) if state is None else (y.copy() for y in state)
    a, N = np.zeros_like(x), np.zeros(eq.row.size)
    pivot = evaluate(eq, ws, no_force, t, x, v, a, N)
    return system, eq, ws, x, v, a, N, pivot


def in_order(system, eq, N):
    out = np.zeros(len(system.row_member))
    out[eq.row] = N
    return out


def residuals(eq, ws, t, x, v, a, N):
    """Relative residuals of M a + J^T N = f and of J a = gamma, gamma by differences of J v along the motion."""
    f = np.zeros_like(x)
    applied(eq, no_force, t, x, v, f)
    M, J = mass_matrix(eq, x), rows_matrix(eq, ws, t, x, v)
    left = (M @ a + J.T @ N - f)[eq.free]
    size = np.abs(f).max() + np.abs(M).max() * np.abs(a).max() + np.abs(N).max(initial=0.0)
    return np.abs(left).max(initial=0.0) / size


def condition_with_rows(eq, ws, x, v):
    """Condition number of M + c J^T J, scaled to a diagonal of ones; c J^T J of the rows that hold nodes without mass."""
    M, J = mass_matrix(eq, x), rows_matrix(eq, ws, 0.0, x, v)
    J = J[eq.augmented_row][:, eq.free]
    D = M[np.ix_(eq.free, eq.free)] + eq.augmentation[0] * J.T @ J
    scale = 1.0 / np.sqrt(np.diag(D))
    return np.linalg.cond(D * scale[:, None] * scale)


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@example(8636, 3, True, False)
@given(st.integers(0, 10**6), st.sampled_from([2, 3]), st.booleans(), st.booleans())
def test_solvers_agree_on_random_trusses(seed, dim, massless, driven):
    model, tasks, trajectory = truss(seed, dim, massless=massless, driven=driven)
    found, state = {}, None
    for solver in SOLVERS:
        # at one state for all: a node without mass between bars that are nearly parallel moves by more than round-off does
        system, eq, ws, x, v, a, N, pivot = solved(model, solver, seed=seed, state=state, tasks=tasks, trajectory=trajectory)
        assert pivot > 0
        assert residuals(eq, ws, 0.0, x, v, a, N) < 1e-13 / min(1.0, pivot) ** 2
        state = (x, v) if state is None else state
        found[solver] = a, in_order(system, eq, N), pivot
    a, N, pivot = found["dense"]
    # what is lost is 1/pivot^2, the condition number of the Schur complement of scaled rows, times round-off; the dense and the
    # sparse solver also factor M + c J^T J, whose condition none of their pivots shows where the bars that hold a node without
    # mass nearly lie in a plane. A node without mass may be flung so fast that its rows, were it as heavy as others, would
    # outweigh all forces
    condition = condition_with_rows(*equations(system, solver="dense", tasks=tasks, trajectory=trajectory), x, v)
    size = np.abs(N).max(initial=0.0) + np.abs(mass_matrix(eq, x)).max() * np.abs(a).max()
    for solver in SOLVERS[1:]:
        slack = max(1e-12 / min(pivot, found[solver][2]) ** 2, EPS * condition)
        assert np.abs(found[solver][0] - a).max() < slack * np.abs(a).max()
        assert np.abs(found[solver][1] - N).max(initial=0.0) < slack * size


@pytest.mark.slow
@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("dim", [2, 3])
def test_second_derivative_of_rows_is_that_of_the_motion(solver, dim):
    """The next state along x'' = a keeps the rows to third order: residual(x + h v + h^2 a/2) falls like h^3."""
    model, tasks, trajectory = truss(3, dim, massless=False, driven=True)
    _, eq, ws, x, v, a, _, _ = solved(model, solver, seed=3, tasks=tasks, trajectory=trajectory)
    off = []
    for h in (2e-3, 1e-3):
        y, w = x + h * v + 0.5 * h * h * a, v + h * a
        prepare_rows(eq, ws, h, y, w)
        d = (y.reshape(-1, 3)[eq.B // 3] - y.reshape(-1, 3)[eq.A // 3]) ** 2
        off.append(np.abs(np.sqrt(d.sum(axis=1)) - ws.target[0]).max())
    assert off[0] > 6 * off[1] or off[0] < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize("solver", ["dense", "sparse"])
@pytest.mark.parametrize("sized", [False, True])
@pytest.mark.parametrize("seed", range(4))
def test_redundant_bars_share_as_in_inverse_dynamics(solver, sized, seed):
    model, tasks, trajectory = truss(seed, 2 + seed % 2, massless=False, driven=False, braced=True, sized=sized)
    system, eq, _, x, v, a, N, _ = solved(model, solver, seed=seed, tasks=tasks, trajectory=trajectory)
    assert eq.redundant.any()
    dim = model.dim
    shape = (1, len(system.nodes), 3)
    motion = kt.kinematics.from_arrays(
        model, [0.0], x.reshape(shape)[..., :dim], v.reshape(shape)[..., :dim], a.reshape(shape)[..., :dim]
    )
    forces = kt.dynamics.inverse(model, motion, static=False)
    expected = forces.data["member_force"].values[0]
    got = np.zeros(len(system.members))
    got[system.row_member[eq.row]] = N
    rigid = system.kind == 0
    assert np.abs(got - expected)[rigid].max() < 1e-8 * np.abs(expected).max()


@pytest.mark.slow
@pytest.mark.parametrize("solver", SOLVERS)
def test_andrews_starts_as_published(solver):
    model = mechanisms.andrews()
    system = compile(model)
    eq, ws = equations(system, tasks={"motor": kt.GivenForce(torque=0.033)}, solver=solver)
    x, v = system.x0.reshape(-1).copy(), np.zeros(system.x0.size)
    a, N = np.zeros_like(x), np.zeros(eq.row.size)
    evaluate(eq, ws, no_force, 0.0, x, v, a, N)
    i = system.members.index("OF")
    d = (system.x0[system.q[i]] - system.x0[system.p[i]])[:2]
    e = (a.reshape(-1, 3)[system.q[i]] - a.reshape(-1, 3)[system.p[i]])[:2]
    assert (d[0] * e[1] - d[1] * e[0]) / (d @ d) == pytest.approx(14222.44391995, rel=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("solver", SOLVERS)
def test_projection_closes_positions_and_velocities(solver):
    model, tasks, trajectory = truss(8, 3, massless=False, driven=True)
    system = compile(model)
    eq, ws = equations(system, tasks=tasks, trajectory=trajectory, solver=solver)
    rng = np.random.default_rng(1)
    x = system.x0.reshape(-1) + 0.02 * rng.normal(size=system.x0.size) * ~system.prescribed
    v = rng.normal(size=x.size) * ~system.prescribed
    good, moved, turned = project(eq, ws, 0.2, x, v, 1e-13)
    assert good
    assert 0 < moved < 0.2
    assert turned > 0
    J = rows_matrix(eq, ws, 0.2, x, v)
    assert np.abs(J @ v - ws.target[1]).max() < 1e-12
    d = x.reshape(-1, 3)[eq.B // 3] - x.reshape(-1, 3)[eq.A // 3]
    assert np.abs(np.linalg.norm(d, axis=1) - ws.target[0]).max() < 1e-12


def test_a_state_twice_gives_the_same_bits():
    model, tasks, trajectory = truss(5, 2, massless=True, driven=True)
    for solver in SOLVERS:
        _, eq, ws, x, v, a, N, _ = solved(model, solver, seed=5, tasks=tasks, trajectory=trajectory)
        b, P = np.zeros_like(a), np.zeros_like(N)
        evaluate(eq, ws, no_force, 0.7, x + 0.01 * v, v + 0.01 * a, b, P)
        evaluate(eq, ws, no_force, 0.0, x.copy(), v.copy(), b, P)
        assert np.array_equal(a, b)
        assert np.array_equal(N, P)


@kernel
def _step(eq, ws, record, x, v, N, beta, gamma, f, g, a, P):
    tangent_factor(eq, ws, record, x, v, N, beta, gamma)
    tangent_solve(eq, record, f, g, a, P)


@pytest.mark.slow
def test_matrix_of_an_implicit_step_is_the_tangent():
    """M + beta K + gamma C against differences of the forces."""
    bars = {"ab": ("A", "B"), "bc": ("B", "C"), "s": {"ends": ("A", "C"), "kind": "elastic", "stiffness": 300.0, "damping": 4.0,
                                                      "natural_length": 0.9},
            "c": {"ends": ("C", "D"), "kind": "cable", "stiffness": 200.0, "natural_length": 0.5}}  # fmt: skip
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.7, 0.6), "C": {"at": (1.5, -0.1), "mass": 2.0}, "D": (2.0, 0.5)}, fixed=("A", "D"),
        bars={name: {"ends": bar, "mass": 1.0} if isinstance(bar, tuple) else bar for name, bar in bars.items()},
        gravity=(0, -9.81),
    )  # fmt: skip
    system = compile(model)
    eq, ws = equations(system)
    x, v = consistent(system, eq, ws, 2, 0.0)
    N, beta, gamma = np.array([30.0, 20.0]), 0.7, 0.3
    J = rows_matrix(eq, ws, 0.0, x, v)
    rng = np.random.default_rng(0)
    f, g = rng.normal(size=x.size), rng.normal(size=eq.row.size)
    a, P = np.zeros_like(x), np.zeros_like(N)
    record = control(eq, system, kt.model.EnergyMomentum(1e-3), (0.0, 1.0))
    _step(eq, ws, record, x, v, N, beta, gamma, f, g, a, P)
    K, C = np.zeros((x.size, x.size)), np.zeros((x.size, x.size))

    def pull(y, w):
        out = np.zeros_like(x)
        applied(eq, no_force, 0.0, y, w, out)
        return out - rows_matrix(eq, ws, 0.0, y, w).T @ N

    for c in eq.free:
        step = np.zeros_like(x)
        step[c] = 1e-6
        K[:, c] = (pull(x - step, v) - pull(x + step, v)) / 2e-6
        C[:, c] = (pull(x, v - step) - pull(x, v + step)) / 2e-6
    # the stiffness of dampers on the way along the bar is left out: take the part without velocities
    K += _damper_part(eq, x, v)
    A = mass_matrix(eq, x) + beta * K + gamma * C
    left = (A @ a + J.T @ P - f)[eq.free]
    assert np.abs(left).max() < 2e-6 * np.abs(A).max() * np.abs(a).max()
    # rows give way by delta, 1e-10 of a mass
    assert np.abs(J @ a - g).max() < 1e-9 * np.abs(P).max()


def _damper_part(eq, x, v):
    """Minus the derivative of L' of dampers with respect to positions, as a matrix: c (u d(L')/dx), with N fixed."""
    out = np.zeros((x.size, x.size))
    for A, B, (_, _, c) in zip(eq.law_A, eq.law_B, eq.law, strict=True):
        d, w = x[B : B + 3] - x[A : A + 3], v[B : B + 3] - v[A : A + 3]
        L = np.linalg.norm(d)
        u = d / L
        block = -c * np.outer(u, (w - (u @ w) * u) / L)
        for p, s in ((A, -1), (B, 1)):
            for q, r in ((A, -1), (B, 1)):
                out[p : p + 3, q : q + 3] += s * r * block
    return out


@pytest.mark.slow
def test_large_structures_find_their_redundant_rows():
    """A long braced row of squares: sparse, with redundant bars found by pivots; against the dense solver."""
    model, tasks, trajectory = truss(1, 2, massless=False, driven=False, braced=True, length=105)
    _, eq, ws, x, v, a, N, _ = solved(model, "sparse", seed=1, tasks=tasks, trajectory=trajectory)
    assert len(eq.free) > 400
    assert eq.redundant.any()
    assert residuals(eq, ws, 0.0, x, v, a, N) < 1e-11


@pytest.mark.slow
def test_chain_of_bays_in_all_solvers():
    model = vgt.double_octahedral(bays=2)
    tasks = {name: kt.Free() for name in model.all_drives}
    found = []
    for solver in SOLVERS:
        system, eq, ws, x, v, a, N, _ = solved(model, solver, seed=4, tasks=tasks)
        assert residuals(eq, ws, 0.0, x, v, a, N) < 1e-12
        found.append((a, in_order(system, eq, N)))
    for a, N in found[1:]:
        assert np.abs(a - found[0][0]).max() < 1e-11 * np.abs(a).max()
        assert np.abs(N - found[0][1]).max() < 1e-11 * np.abs(N).max()


@pytest.mark.slow
def test_mass_times_is_symmetric_and_positive():
    model = vgt.double_octahedral(bays=1)
    system = compile(model)
    eq, _ = equations(system)
    M = mass_matrix(eq, system.x0.reshape(-1))
    assert np.abs(M - M.T).max() < 1e-13 * M.max()
    assert np.linalg.eigvalsh(M[np.ix_(eq.free, eq.free)])[0] > 0
    assert mass_times is not None
