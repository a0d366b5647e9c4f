"""All configurations of a structure: known numbers of solutions, and every one closes."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kinematics.known_platform import Platform, _Way, known_platform, poses_of
from kinetruss.library import mechanisms


def closes(model, found):
    """Largest error of the rigid and driven lengths over all modes, m."""
    worst = 0.0
    for x in found.position.values:
        at = dict(zip(model.nodes, x, strict=True))
        for bar in model.bars.values():
            a, b = bar.ends
            start = np.linalg.norm(np.subtract(model.nodes[a].at, model.nodes[b].at))
            worst = max(worst, abs(np.linalg.norm(at[a] - at[b]) - start))
    return worst


def three_legs(seed):
    """A planar platform on three legs (3-RPR)."""
    rng = np.random.default_rng(seed)
    base = np.array([(0, 0), (4, 0), (2, 4)]) + rng.uniform(-0.5, 0.5, (3, 2))
    top = np.array([(1.2, 1.1), (2.6, 1.0), (2.0, 2.2)]) + rng.uniform(-0.5, 0.5, (3, 2))
    nodes = dict(zip("ABCPQR", map(tuple, np.vstack([base, top]).tolist()), strict=True))
    return kt.Model(
        nodes=nodes, fixed=["A", "B", "C"],
        bars={"1": ("P", "Q"), "2": ("Q", "R"), "3": ("R", "P"), "a": ("A", "P"), "b": ("B", "Q"), "c": ("C", "R")},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 1, 2, 3])
def test_planar_platform_has_six_complex_solutions_and_all_real_ones_are_found(seed):
    model = three_legs(seed)
    found = kt.kinematics.assembly_modes(model)
    assert found.attrs["complex_solutions"] == [6]  # Gosselin, Sefrioui & Richard (1992)
    assert found.attrs["lost"] == 0
    assert closes(model, found) < 1e-9
    assert found.distance.values[0] < 1e-9
    ours = found.position.sel(node=["P", "Q", "R"]).values.reshape(found.sizes["mode"], -1)
    theirs = searched(model)
    assert theirs
    for one in theirs:
        assert np.abs(ours - one).max(axis=1).min() < 1e-6


def searched(model):
    """The same by brute force: 6-vector of places from a scan of the platform's angle, roots of the third leg's error."""
    at = {name: np.array(node.at) for name, node in model.nodes.items()}
    length = {name: np.linalg.norm(at[bar.ends[0]] - at[bar.ends[1]]) for name, bar in model.bars.items()}
    start = np.array([at["P"], at["Q"], at["R"]])

    def error(angle, side):
        R = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        arm = (start - start[0]) @ R.T
        centre = at["B"] - arm[1]  # |P - A| = a and |P + arm_Q - B| = b: two circles
        d = centre - at["A"]
        apart = np.linalg.norm(d)
        along = (apart**2 + length["a"] ** 2 - length["b"] ** 2) / (2 * apart)
        if length["a"] ** 2 < along**2:
            return np.nan, None
        u = d / apart
        P = at["A"] + along * u + side * np.sqrt(length["a"] ** 2 - along**2) * np.array([-u[1], u[0]])
        return np.linalg.norm(P + arm[2] - at["C"]) - length["c"], (P + arm).reshape(-1)

    from scipy.optimize import brentq

    found = []
    grid = np.linspace(-np.pi, np.pi, 20001)
    for side in (1, -1):
        values = np.array([error(angle, side)[0] for angle in grid])
        for k in np.flatnonzero(values[1:] * values[:-1] < 0):
            angle = brentq(lambda y, s=side: error(y, s)[0], grid[k], grid[k + 1], xtol=1e-13)
            found.append(error(angle, side)[1])
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "count"), [("6-3", 16), ("6-6", 40)])
def test_stewart_platforms_have_their_known_numbers_of_solutions(kind, count):
    model = mechanisms.stewart(kind=kind, turned=(0.1, 0.2, 0.1))
    found = kt.kinematics.assembly_modes(model)
    assert found.attrs["complex_solutions"] == [count]
    assert found.attrs["lost"] == 0
    assert closes(model, found) < 1e-9
    assert found.distance.values[0] < 1e-9
    assert found.sizes["mode"] % 2 == 0  # real ones come in pairs
    if kind == "6-6":  # the platform is never turned inside out
        body = ["P1", "P3", "P5", "Q"]
        start = np.array([model.nodes[name].at for name in body])
        for x in found.position.sel(node=body).values:
            assert np.linalg.det(x[1:] - x[0]) * np.linalg.det(start[1:] - start[0]) > 0


@pytest.mark.slow
def test_crank_with_an_angle_has_two_ways():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (3, 2), "D": (4, 0)}, fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}, drives={"w": kt.AngleDrive("crank")},
    )  # fmt: skip
    found = kt.kinematics.assembly_modes(model, {"w": 1.0})
    assert found.sizes["mode"] == 2
    assert np.abs(found.position.sel(node="B").values - [np.cos(1.0), np.sin(1.0)]).max() < 1e-12


@pytest.mark.slow
def test_what_cannot_be_counted_is_told():
    loose = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    with pytest.raises(InputError, match="can move with its drives held"):
        kt.kinematics.assembly_modes(loose)
    with pytest.raises(AnalysisError, match="More than 1"):
        kt.kinematics.assembly_modes(three_legs(0), most=1)


def test_the_stored_platform_is_solved():
    """40 solutions that differ, each a rotation (complex, with N not 0), to round-off."""
    platform, z = known_platform()
    assert z.shape == (40, 8)
    assert np.abs(platform.at(z)[0]).max() < 1e-11
    assert np.abs(np.sum(z[:, :4] ** 2, axis=1)).min() > 1e-3
    assert min(np.abs(one - other).max() for i, one in enumerate(z) for other in z[:i]) > 1e-3
    R, t = poses_of(z[:, 1:])
    np.testing.assert_allclose(R @ R.transpose(0, 2, 1), np.broadcast_to(np.eye(3), (40, 3, 3)), atol=1e-10)
    apart = np.einsum("kij,lj->kli", R, platform.p) + t[:, None] - platform.b
    np.testing.assert_allclose(np.sum(apart**2, axis=2), np.broadcast_to(platform.squares, (40, 6)), atol=1e-9)


def test_the_way_between_platforms_has_these_derivatives():
    rng = np.random.default_rng(2)
    two = [Platform(p=rng.normal(size=(6, 3)), b=rng.normal(size=(6, 3)), squares=rng.normal(size=6)) for _ in range(2)]
    way, z, t, h = _Way(*two, rng), rng.normal(size=(5, 8)), np.linspace(0.1, 0.9, 5), 1e-5
    _, J, Ht = way.at(z, t)
    # forms are quadratic in z, cubic at most in t: central differences are exact to h^2
    assert np.abs((way.at(z, t + h)[0] - way.at(z, t - h)[0]) / (2 * h) - Ht).max() < 1e-7
    for k in range(8):
        step = h * np.eye(8)[k]
        assert np.abs((way.at(z + step, t)[0] - way.at(z - step, t)[0]) / (2 * h) - J[:, :, k]).max() < 1e-7


def random_platform(seed):
    rng = np.random.default_rng(seed)
    base, top = (tuple(map(tuple, rng.uniform(-size, size, (6, 3)).tolist())) for size in (0.5, 0.3))
    return mechanisms.stewart(base_points=base, platform_points=top, turned=(0.1, 0.2, 0.1))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_a_general_platform_has_forty_solutions_and_none_is_missed(seed):
    """The pose it was built in is among them, and every pose that Newton's method finds from 120 random starts."""
    model = random_platform(seed)
    found = kt.kinematics.assembly_modes(model)
    assert found.attrs["complex_solutions"] == [40]
    assert found.attrs["lost"] == 0
    assert closes(model, found) < 1e-10
    assert found.distance.values[0] < 1e-10
    at = {name: np.array(node.at) for name, node in model.nodes.items()}
    top, base = (np.array([at[f"{letter}{k}"] for k in range(1, 7)]) for letter in "PB")
    middle = top.mean(axis=0)
    lengths = np.linalg.norm(top - base, axis=1)
    ours = found.position.sel(node=[f"P{k}" for k in range(1, 7)]).values
    rng, seen = np.random.default_rng(100 + seed), 0
    for _ in range(120):
        start = Rotation.random(random_state=rng)

        def error(y, start=start):
            turned = (Rotation.from_rotvec(y[:3]) * start).apply(top - middle) + y[3:]
            return np.linalg.norm(turned - base, axis=1) - lengths

        pose = least_squares(error, np.r_[0, 0, 0, rng.uniform(-1, 1, 3)], xtol=1e-15, ftol=1e-15, gtol=1e-15)
        if np.abs(pose.fun).max() < 1e-11:
            there = (Rotation.from_rotvec(pose.x[:3]) * start).apply(top - middle) + pose.x[3:]
            assert np.abs(ours - there).max(axis=(1, 2)).min() < 1e-6
            seen += 1
    assert seen > 10
