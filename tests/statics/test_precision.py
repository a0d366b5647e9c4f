"""Forces of determinate trusses are those of equilibrium to round-off, whatever the stiffnesses; lost digits are said."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.mechanics.accuracy import SILENT
from kinetruss.statics.refinement import Doubled, best_of

METAL = kt.Material(E=70e9, density=0.0)


def section(area):
    return kt.General(area=float(area), I2=1e-8, I3=1e-8, c2=0.01, c3=0.01)


def henneberg(chance, dim, count, scale, flat):
    """A determinate truss: every node held by as many bars as axes; one of them nearly in the plane of its feet."""
    base = dim if dim == 2 else 3
    x = [np.array(row) for row in ([[0, 0], [1, 0.2]] if dim == 2 else [[0, 0, 0], [1, 0.1, 0], [0.2, 1, 0.1]])]
    bars = []
    for k in range(base, count):
        while True:
            feet = chance.choice(np.arange(max(0, k - 5), k), dim, replace=False)
            at = np.mean([x[i] for i in feet], axis=0) + chance.uniform(-1, 1, dim)
            if k == count // 2 and flat:
                share = chance.dirichlet(np.ones(dim))
                plane = np.array([x[i] - x[feet[0]] for i in feet[1:]])
                normal = np.linalg.svd(plane)[2][-1]
                at = share @ np.array([x[i] for i in feet]) + flat * normal
            d = np.array([at - x[i] for i in feet])
            length = np.linalg.norm(d, axis=1)
            if length.min() > 0.2 and ((k == count // 2 and flat) or abs(np.linalg.det(d / length[:, None])) > 0.1):
                break
        x.append(at)
        bars += [(int(i), k) for i in feet]
    return np.array(x) * scale, bars, base


def model_of(x, bars, base, areas, loads):
    return kt.Model(
        nodes={f"N{k}": tuple(map(float, at)) for k, at in enumerate(x)},
        fixed=[f"N{k}" for k in range(base)],
        bars={f"b{j}": kt.Bar(ends=(f"N{a}", f"N{b}"), section=section(areas[j])) for j, (a, b) in enumerate(bars)},
        material=METAL,
        loads={f"l{k}": kt.NodalForce(node=f"N{k}", force=tuple(map(float, f))) for k, f in loads.items()},
    )  # fmt: skip


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(
    st.integers(0, 2**32 - 1), st.sampled_from([2, 3]), st.integers(5, 16), st.floats(-4, 4), st.sampled_from([0, 3, 6]),
    st.sampled_from([None, -2, -4, -6]),
)  # fmt: skip
def test_linear_statics_agree_with_inverse_dynamics_on_determinate_trusses(seed, dim, count, scale, spread, flat):
    chance = np.random.default_rng(seed)
    x, bars, base = henneberg(chance, dim, count, 10.0**scale, 10.0**flat if flat else 0.0)
    loads = {k: chance.standard_normal(dim) for k in range(base, count)}
    model = model_of(x, bars, base, 1e-4 * 10.0 ** (2 * scale) * 10 ** chance.uniform(0, spread, len(bars)), loads)
    found = kt.statics.linear(model, weight=False)
    exact = kt.statics.at_poses(model, x[None], weight=False).member_force.values[0]
    worst = kt.kinematics.mobility(model).smallest_singular_value
    off = np.abs(found.member_force.values - exact).max() / np.abs(exact).max()
    assert off <= 2e-14 / worst + 1e-13  # both round the direction cosines
    assert found.work.item() == pytest.approx(found.energy.item(), rel=max(1e-12, 1e-15 / worst**2 if worst > 1e-5 else 1e-6))
    assert bool(found.message) == (max(found.data.attrs["force_error"], found.data.attrs["displacement_error"]) > SILENT)


@pytest.mark.parametrize("ratio", [1.0, 1e6])
@pytest.mark.parametrize("height", [1e-3, 1e-5, 1e-7, 1e-9])
def test_next_to_a_mechanism_forces_hold_and_lost_digits_are_said(height, ratio):
    along = np.array([np.cos(0.47), np.sin(0.47)])
    across = np.array([-along[1], along[0]])
    start = np.array([0.1, 0.2])
    x = np.array([start, start + 1.4 * along, start + 0.83 * along - height * across])
    load = np.array([0.3, -1.0])
    model = model_of(x, [(0, 2), (2, 1)], 2, [1e-3, 1e-3 * ratio], {2: load})
    exact = np.linalg.solve(np.array([(x[2] - end) / np.linalg.norm(x[2] - end) for end in x[:2]]).T, load)
    try:
        found = kt.statics.linear(model)
    except kt.InputError as error:
        assert height == 1e-9
        assert "N2 moves along" in str(error)
        return
    off = np.abs(found.member_force.values - exact).max() / np.abs(exact).max()
    assert off <= max(1e-13, found.data.attrs["force_error"]) <= 1e-15 / height * 1e3
    if height == 1e-9:
        assert "next to a mechanism: N2 moves along" in found.message
        assert "b0, b1" in found.message


def panels(count, bars=("B", "T", "D", "V")):
    """A cantilever of square panels: bottom, top, diagonal, vertical (and the other diagonal, E)."""
    nodes = {f"b{i}": (float(i), 0.0) for i in range(count + 1)} | {f"t{i}": (float(i), 1.0) for i in range(count + 1)}
    pairs = {}
    for i in range(count):
        ends = {"B": (f"b{i}", f"b{i + 1}"), "T": (f"t{i}", f"t{i + 1}"), "D": (f"b{i}", f"t{i + 1}"),
                "V": (f"b{i + 1}", f"t{i + 1}"), "E": (f"t{i}", f"b{i + 1}")}  # fmt: skip
        pairs |= {f"{name}{i}": kt.Bar(ends=ends[name], mass=0) for name in bars}
    return kt.Model(nodes=nodes, fixed=["b0", "t0"], bars=pairs, section=kt.Rod(diameter=0.1),
                    material=METAL, loads={"p": kt.NodalForce(node=f"t{count}", force=(0.0, -1.0))})  # fmt: skip


@pytest.mark.slow
def test_a_long_cantilever_has_the_forces_of_equilibrium():
    """Chords carry the moment, diagonals sqrt(2); the tip sinks by the sum of N n l/(E A) (Maxwell, Mohr)."""
    count = 5000
    found = kt.statics.linear(panels(count))
    N = found.member_force.values.reshape(count, 4)
    i = np.arange(count)
    np.testing.assert_allclose(N[:, 1], count - i, rtol=1e-13)
    np.testing.assert_allclose(N[:, 0], -(count - i - 1), rtol=1e-13, atol=1e-9)
    np.testing.assert_allclose(np.abs(N[:, 2]), np.sqrt(2), rtol=1e-12)
    sag = np.sum(N**2 * np.array([1, 1, np.sqrt(2), 1])) / (70e9 * np.pi * 0.05**2)
    assert found.displacement.sel(node=f"t{count}", axis="y").item() == pytest.approx(-sag, rel=1e-12)
    assert found.message == ""


def test_a_mechanism_is_found_whatever_is_loaded():
    """Parts that carry nothing are looked at too."""
    sound = panels(3)
    loose = sound.with_(nodes=sound.nodes | {"X": (0.0, 5.0), "Y": (1.0, 5.0)}, fixed=["b0", "t0", "X"],
                        bars=sound.bars | {"arm": kt.Bar(ends=("X", "Y"), mass=0)})  # fmt: skip
    for loads in (sound.loads, {}):
        with pytest.raises(kt.InputError, match="Y moves along y"):
            kt.statics.linear(loose.with_(loads=loads))


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 12), st.floats(0, 12))
def test_residuals_in_doubled_precision_are_exact_to_the_last_digit(seed, size, spread):
    from fractions import Fraction

    from scipy.sparse import random_array

    chance = np.random.default_rng(seed)
    matrix = random_array((size, size), density=0.6, format="csr", rng=chance)
    matrix.data *= 10 ** chance.uniform(-spread / 2, spread / 2, matrix.nnz)
    y, b = chance.standard_normal(size), chance.standard_normal(size)
    found = Doubled(matrix).residual(y, b)
    for r, row in enumerate(matrix.toarray()):
        terms = [Fraction(float(b[r]))] + [-Fraction(float(m)) * Fraction(float(v)) for m, v in zip(row, y, strict=True)]
        exact = sum(terms, Fraction(0))
        size_of = float(sum(abs(term) for term in terms))
        assert abs(found[r] - float(exact)) <= 2.3e-16 * abs(float(exact)) + 1e-30 * size_of


@pytest.mark.slow
@pytest.mark.parametrize("power", [2, 6, 9])
def test_bounds_of_errors_hold_and_are_not_far_off(power):
    """A symmetric system of condition 10^power, its entries rounded: the error stays below the bound, but not far below."""
    from scipy.sparse import csr_array

    chance = np.random.default_rng(power)
    Q = np.linalg.qr(chance.standard_normal((8, 8)))[0]
    exact = Q @ np.diag(np.logspace(0, -power, 8)) @ Q.T
    exact = 0.5 * (exact + exact.T)
    b = chance.standard_normal(8)
    found = best_of(csr_array(exact), b, [slice(0, 4), slice(4, 8)], np.arange(8))
    off = []
    for _ in range(20):
        noise = chance.uniform(-1, 1, (8, 8)) * 2.0**-52
        noise = 0.5 * (noise + noise.T)
        other = best_of(csr_array(exact * (1 + noise)), b, [slice(0, 4), slice(4, 8)], np.arange(8))
        off.append(
            [np.abs(other.y[part] - found.y[part]).max() / np.abs(found.y[part]).max() for part in (slice(0, 4), slice(4, 8))]
        )
    for worst, bound in zip(np.max(off, axis=0), found.errors, strict=True):
        assert worst <= 1.1 * bound
        assert bound <= 300 * worst


def shallow(height, kind="rigid"):
    """Two bars almost in one line, tilted, and the exact forces at the drawn positions."""
    along = np.array([np.cos(0.47), np.sin(0.47)])
    across = np.array([-along[1], along[0]])
    start = np.array([0.1, 0.2])
    x = np.array([start, start + 1.4 * along, start + 0.83 * along - height * across])
    load = np.array([0.3, -1.0])
    model = model_of(x, [(0, 2), (2, 1)], 2, [1e-3, 1e-3], {2: load})
    model = model.with_(bars={name: kt.Bar(**{**dict(bar), "kind": kind}) for name, bar in model.bars.items()})
    return model, np.linalg.solve(np.array([(x[2] - end) / np.linalg.norm(x[2] - end) for end in x[:2]]).T, load)


@pytest.mark.parametrize("height", [1e-3, 1e-5, 1e-6, 1e-7, 1e-8])
def test_equilibrium_and_poses_next_to_a_mechanism_hold_or_say_what_is_lost(height):
    model, exact = shallow(height)
    for found in (kt.statics.at_poses(model, [{}]), kt.statics.equilibrium(model)):
        off = np.abs(found.member_force.values.reshape(-1) - exact).max() / np.abs(exact).max()
        assert off <= 1e-15 / height or "sure to about" in found.message


@pytest.mark.parametrize("height", [1e-3, 1e-5, 1e-6])
def test_poses_closed_from_lengths_say_what_rounding_of_lengths_costs(height):
    """Lengths fix the height to eps/height, so forces to eps/height^2: driven to the same lengths from beside."""
    model, exact = shallow(height, kind="driven")
    higher, _ = shallow(2 * height, kind="driven")
    at = {name: np.array(node.at) for name, node in model.nodes.items()}
    lengths = {name: float(np.linalg.norm(at[bar.ends[1]] - at[bar.ends[0]])) for name, bar in model.bars.items()}
    found = kt.statics.at_poses(higher, [lengths])
    off = np.abs(found.member_force.values[0] - exact).max() / np.abs(exact).max()
    assert off <= 1e-7 or "sure to about" in found.message
    assert ("sure to about" in found.message) == (height < 1e-4)


def test_the_geometry_of_load_cases_is_found_once(monkeypatch):
    from kinetruss.statics import poses as _at_poses

    model = kt.library.vgt.double_octahedral()
    name = next(iter(model.all_drives))
    value = 1.03 * float(kt.statics.at_poses(model, [{}]).motion.drive_position.sel(drive=name).item())
    found, counted = [], _at_poses.assembled

    def counting(*arguments):
        found.append(1)
        return counted(*arguments)

    monkeypatch.setattr(_at_poses, "assembled", counting)
    for k in range(5):
        kt.statics.at_poses(model, [{name: value}, {name: value}, {}], time=float(k))
    assert len(found) == 1
