"""Section forces against free bodies cut by numerical quadrature, with accelerations from differences of the motion."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kinetruss.elements.directions import start_references
from kinetruss.kernels.sections.records import Histories, Members, Polynomials
from kinetruss.kernels.sections.sections import COEFFICIENTS, member_axes, section_forces

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(8)
STEP = 2e-3
# eighth-order central difference for a second derivative, and for a first one
SECOND = np.array([-1 / 560, 8 / 315, -1 / 5, 8 / 5, -205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560]) / STEP**2
FIRST = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280]) / STEP
TIMES = STEP * np.arange(-4, 5)


def ends(x, v, a):
    """Path of two nodes (times, 2, 3) with these positions, velocities and accelerations at t = 0."""
    t = TIMES[:, None, None]
    return x + v * t + a * t**2 / 2


def unit(path):
    d = path[:, 1] - path[:, 0]
    return d / np.linalg.norm(d, axis=1, keepdims=True)


def field(path, where):
    """Acceleration of the mass point at `where`: a share of a bar, or metres along a rod from its clamp at A or B."""
    kind, s = where
    if kind == "bar":
        points = path[:, 0] + s * (path[:, 1] - path[:, 0])
    elif kind == "base":
        points = path[:, 0] + s * unit(path)
    else:
        points = path[:, 1] - s * unit(path)
    return SECOND @ points


def turning(path):
    """Angular acceleration: the rate of u x u'."""
    u = unit(path)
    return np.cross(u[4], SECOND @ u)


def pieces(lo, hi):
    half, middle = (hi - lo) / 2, (hi + lo) / 2
    return middle + half * POINTS, half * WEIGHTS


def cut(path, gravity, rod, span, about):
    """What the mass between two places of a rod needs: force, and moment about the point `about` m from A.

    rod: (kind, mass, length, rotary). span and about in metres from A; the rod lies from `first` on.
    """
    kind, mass, length, rotary = rod
    u, L = unit(path)[4], np.linalg.norm(path[4, 1] - path[4, 0])
    places, weights = pieces(*span)
    force, moment = np.zeros(3), np.zeros(3)
    for s, weight in zip(places, weights, strict=True):
        where = {"bar": ("bar", s / L), "base": ("base", s), "tube": ("tube", L - s)}[kind]
        element = weight * mass / length * (field(path, where) - gravity)
        force += element
        moment += np.cross((s - about) * u, element)
    return force, moment + rotary * (span[1] - span[0]) / length * turning(path)


def axes_by_hand(u, planar, towards):
    if planar:
        return np.array([u, [-u[1], u[0], 0], [0, 0, 1]])
    third = np.cross(u, towards)
    third /= np.linalg.norm(third)
    return np.array([u, np.cross(third, u), third])


def kernel(x, v, a, force, gravity, rods, two, xi, orient=-1, third_node=None):
    """The kernel on one member between the first two nodes."""
    dim = x.shape[1]
    stack = [x, v, a]
    if third_node is not None:
        stack = [np.vstack([x, third_node]), np.vstack([v, 0 * third_node]), np.vstack([a, 0 * third_node])]
    p, q = np.array([0], np.int32), np.array([1], np.int32)
    parts, across = (2 if two else 1), dim - 1
    T = np.empty((1, parts, len(xi)))
    V, M = np.empty((1, parts, len(xi), across)), np.empty((1, parts, len(xi), across))
    members = Members.of({
        "segments": 2, "p": p, "q": q, "orient": [orient], "two_rods": [two], "acting": np.zeros(2), "spread": np.zeros(0),
        "along": np.zeros((0, 4)),
        "clamped_ptr": np.zeros(3), "clamped": np.zeros((0, 2)),
        "rods": np.array([rods]), "reference": start_references(stack[0], p, q), "gravity": [*gravity, *[0.0] * (3 - dim)],
    })  # fmt: skip
    motion = (np.ascontiguousarray(y[None]) for y in stack)
    histories = Histories(*motion, np.ascontiguousarray(force[None, None]), np.zeros((1, 0, 2, dim)), np.zeros((1, 0)))
    scratch = Polynomials(np.empty((1, parts, 2, COEFFICIENTS)), np.empty((1, parts, 2)), np.empty((1, parts)))
    section_forces(members, histories, scratch, xi, T, V, M)
    return T[0], V[0], M[0]


def motions(dim):
    values = st.integers(0, 2**32 - 1).map(lambda seed: np.random.default_rng(seed))
    return values.map(lambda rng: draw(rng, dim))


def draw(rng, dim):
    """A member of length about 1 in any direction, moving; with z = 0 in the plane."""
    x, v, a, F = np.zeros((2, 3)), np.zeros((2, 3)), np.zeros((2, 3)), np.zeros((2, 3))
    g = np.zeros(3)
    u = rng.normal(size=dim)
    x[0, :dim] = rng.normal(size=dim)
    x[1, :dim] = x[0, :dim] + rng.uniform(0.9, 1.3) * u / np.linalg.norm(u)
    for y in (v, a, F):
        y[:, :dim] = rng.normal(size=(2, dim))
    g[:dim] = 5 * rng.normal(size=dim)
    return x, v, a, F, g, dim


def reduced(force, moment, x, planar, u):
    h = [1.0, 0, 0] if abs(u[2]) > 0.95 else [0, 0, 1.0]
    axes = axes_by_hand(u, planar, h)
    S, M = axes @ force, axes @ moment
    return S[0], S[1:2] if planar else S[1:], M[2:] if planar else M[1:]


@pytest.mark.slow
@pytest.mark.parametrize("dim", [2, 3])
@settings(max_examples=25, deadline=None)
@given(data=st.data())
def test_bar_against_the_free_body_of_its_a_side(dim, data):
    x, v, a, F, g, _ = data.draw(motions(dim))
    mass, rotary = 2.5, 0.03
    path, planar = ends(x, v, a), dim == 2
    u, L = unit(path)[4], np.linalg.norm(x[1] - x[0])
    xi = np.array([0.0, 0.3, 0.5, 1.0])
    T, V, M = kernel(x[:, :dim], v[:, :dim], a[:, :dim], F[:, :dim], g[:dim], [mass, L, rotary, 0, 0, 0], False, xi)
    for n, share in enumerate(xi):
        s = share * L
        force, moment = cut(path, g, ("bar", mass, L, rotary), (0.0, s), s)
        expected = reduced(force - F[0], moment + np.cross(s * u, F[0]), x, planar, u)
        for got, want in zip((T[0, n], V[0, n], M[0, n]), expected, strict=True):
            assert np.allclose(got, want, atol=2e-8 * (1 + np.abs(F).max() + np.abs(a).max())), (share, got, want)


@pytest.mark.slow
@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("overlap", [True, False])
@settings(max_examples=20, deadline=None)
@given(data=st.data())
def test_active_member_against_the_free_bodies_of_its_rods(dim, overlap, data):
    x, v, a, F, g, _ = data.draw(motions(dim))
    base = ("base", 3.0, 0.8 if overlap else 0.4, 0.02)
    tube = ("tube", 0.7, 0.6 if overlap else 0.3, 0.01)
    path, planar = ends(x, v, a), dim == 2
    u, L = unit(path)[4], np.linalg.norm(x[1] - x[0])
    nut = L - tube[2]
    xi = np.array([0.0, 0.2, 0.55, 0.97])
    T, V, M = kernel(
        x[:, :dim], v[:, :dim], a[:, :dim], F[:, :dim], g[:dim], [*base[1:], *tube[1:]], True, xi
    )  # fmt: skip
    for n, share in enumerate(xi):
        s = share * base[2]
        if s <= nut:
            force, moment = cut(path, g, base, (0.0, s), s)
            of_base = force - F[0], moment + np.cross(s * u, F[0])
        else:
            force, moment = cut(path, g, base, (s, base[2]), s)
            of_base = -force, -moment
        s = nut + share * tube[2]
        force, moment = cut(path, g, tube, (s, L), s)
        of_tube = F[1] - force, np.cross((L - s) * u, F[1]) - moment
        for part, (S, m) in enumerate((of_base, of_tube)):
            expected = reduced(S, m, x, planar, u)
            for got, want in zip((T[part, n], V[part, n], M[part, n]), expected, strict=True):
                assert np.allclose(got, want, atol=5e-8 * (1 + np.abs(F).max() + np.abs(a).max())), (part, share)


def test_orientation_node_spans_the_plane_of_axes_1_and_2():
    rng = np.random.default_rng(3)
    x, v, a, F, g, _ = draw(rng, 3)
    node = x[:1] + rng.normal(size=(1, 3))
    xi = np.array([0.0, 0.4])
    rods = [2.0, 1.0, 0, 0, 0, 0]
    _, V, M = kernel(x, v, a, F, g, rods, False, xi, orient=2, third_node=node)
    u = unit(ends(x, v, a))[4]
    axes = axes_by_hand(u, False, node[0] - x[0])
    assert np.allclose(V[0, 0], -(axes[1:] @ F[0]))
    assert abs(axes[2] @ (node[0] - x[0])) < 1e-14
    free = kernel(x, v, a, F, g, rods, False, xi)
    assert np.allclose(np.linalg.norm(free[1], axis=-1), np.linalg.norm(V, axis=-1))
    assert np.allclose(np.linalg.norm(free[2], axis=-1), np.linalg.norm(M, axis=-1))


def test_axes_stay_right_handed_where_a_member_runs_through_its_reference():
    up = np.array([[[0.0, 0, 0], [0, 0, 1.0]], [[0.0, 0, 0], [0, 1.0, 0]], [[0.0, 0, 0], [1e-12, 0, 1.0]]])
    out = np.empty((3, 1, 3, 3))
    one = np.array([0], np.int32), np.array([1], np.int32), np.array([-1], np.int32)
    member_axes(up, *one, np.array([[0.0, 0, 1.0]]), out)
    for axes in out[:, 0]:
        assert np.allclose(axes @ axes.T, np.eye(3))
        assert np.linalg.det(axes) == pytest.approx(1.0)
    assert np.allclose(out[1, 0], [[0, 1, 0], [0, 0, 1], [1, 0, 0]])


def test_reference_is_z_but_x_for_members_near_z():
    x = np.array([[0.0, 0, 0], [1, 0, 0], [0.2, 0, 1]])
    p, q = np.array([0, 0], np.int32), np.array([1, 2], np.int32)
    assert start_references(x, p, q).tolist() == [[0, 0, 1], [1, 0, 0]]
    assert not start_references(x[:, :2], p, q).any()
