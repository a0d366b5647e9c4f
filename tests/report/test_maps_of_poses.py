"""Maps over coordinates of tasks: a bay against its closed form, its symmetry, and a chain with drives to choose."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report

SIDE, LONGERON = 1.2192, 0.889
LOW, HIGH = 0.95, 1.30
DRIVES = ("M7", "M9", "M11")
ANGLES = np.radians(np.linspace(-40, 40, 17))


@pytest.fixture(scope="module")
def bay():
    return kt.library.vgt.double_octahedral()


@pytest.fixture(scope="module")
def found(bay):
    """Angles at two heights."""
    return kt.kinematics.workspace(
        bay,
        "bay",
        ("bay.beta", ANGLES),
        ("bay.gamma", ANGLES),
        {"bay.height": [1.05, 1.12]},
        limits=dict.fromkeys(DRIVES, (LOW, HIGH)),
    )


def lengths(beta, gamma, height):
    """Closed form; NaN out of reach."""
    found = np.full((*np.broadcast(beta, gamma, height).shape, 3), np.nan)
    for at in np.ndindex(found.shape[:-1]):
        try:
            found[at] = kt.kinematics.gimbal_lengths(SIDE, LONGERON, beta[at], gamma[at], height[at])
        except kt.AnalysisError:
            continue
    return found


@pytest.fixture(scope="module")
def wanted(found):
    height, gamma, beta = np.meshgrid(*(found[name].values for name in found.reachable.dims), indexing="ij")
    return lengths(beta, gamma, height)


@pytest.mark.slow
def test_a_bay_reaches_what_its_closed_form_does(found, wanted):
    assert found.reachable.dims == ("bay.height", "bay.gamma", "bay.beta")
    assert np.array_equal(found.reachable.values, ~np.isnan(wanted[..., 0]))
    assert 0.2 < found.reachable.values.mean() < 0.8
    np.testing.assert_allclose(found.drive_position.values, wanted, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.stroke.values, (wanted - LOW) / (HIGH - LOW), rtol=0, atol=1e-11)


@pytest.mark.slow
def test_the_stroke_boundary_of_a_bay_is_that_of_its_closed_form(found, wanted):
    off = np.maximum(LOW - wanted, wanted - HIGH)
    good = ~np.isnan(wanted[..., 0])
    assert np.array_equal(found.within.values, good & (np.nan_to_num(off, nan=1.0).max(axis=-1) <= 0))
    first = np.sort(off, axis=-1)
    clear = good & (first[..., 2] - first[..., 1] > 1e-9) & (first[..., 2] > 0)
    worst = np.nan_to_num(off, nan=-1.0).argmax(axis=-1)
    for at in np.argwhere(clear):
        d = worst[tuple(at)]
        side = "short" if wanted[(*at, d)] < LOW else "long"
        assert found["limit"].values[tuple(at)] == f"{DRIVES[d]} {side}"
    assert set(found["limit"].values[~good]) == {"out of reach"}


def test_the_singular_value_of_the_angles_is_that_of_the_inverse_of_the_lengths_rates(bay):
    """Derivatives of the pose by the lengths are the inverse of those of the closed form, here by central differences."""
    at, h = np.array([0.2, -0.1, 1.1]), 1e-5
    found = kt.kinematics.workspace(bay, "bay", ("bay.beta", at[:1]), ("bay.gamma", at[1:2]), {"bay.height": at[2]})
    steps = np.stack([lengths(*(at + s * h * e)[:, None])[0] for e in np.eye(3) for s in (1, -1)]).reshape(3, 2, 3)
    slopes = ((steps[:, 0] - steps[:, 1]) / (2 * h)).T
    shortest = min(np.linalg.norm(np.subtract(bay.nodes[b.ends[1]].at, bay.nodes[b.ends[0]].at)) for b in bay.members.values())
    A = np.diag([shortest, shortest, 1.0]) @ np.linalg.inv(slopes)
    assert float(found.serial.values[0, 0]) == pytest.approx(np.linalg.svd(A, compute_uv=False)[-1], rel=1e-7)


def test_a_turn_by_120_degrees_exchanges_the_drives(bay):
    """The direction n = (-sin gamma, -sin beta cos gamma, cos beta cos gamma), turned about z."""
    beta, gamma = 0.21, -0.13
    n = np.array([-np.sin(gamma), -np.sin(beta) * np.cos(gamma), np.cos(beta) * np.cos(gamma)])
    each = []
    for k in range(3):
        c, s = np.cos(2 * np.pi * k / 3), np.sin(2 * np.pi * k / 3)
        x, y = c * n[0] - s * n[1], s * n[0] + c * n[1]
        pose = kt.kinematics.workspace(bay, "bay", ("bay.beta", [np.arctan2(-y, n[2])]), ("bay.gamma", [np.arcsin(-x)]))
        each.append((pose.drive_position.values[0, 0], pose.parallel.item(), pose.conditioning.item()))
    for values, parallel, conditioning in each[1:]:
        shifts = [np.abs(np.roll(each[0][0], j) - values).max() for j in (1, 2)]
        assert min(shifts) < 1e-12 < np.abs(each[0][0] - values).max()
        assert (parallel, conditioning) == pytest.approx(each[0][1:], rel=1e-9)


@pytest.mark.slow
def test_drives_of_a_chain_are_chosen_so_that_they_keep_their_limits():
    """Two bays, six drives, two coordinates of the centre of the top: every pose is met, and limits are kept where told."""
    chain = kt.library.vgt.double_octahedral(bays=2)
    top = list(chain.nodes)[-3:]
    low, high = 1.05, 1.28
    centre = np.mean([chain.nodes[name].at for name in top], axis=0)
    task = kt.Positioning(nodes=top, moves={"x": 0.0}, free=["y"])
    x, z = centre[0] + np.linspace(-0.8, 0.8, 7), centre[2] + np.linspace(-0.2, 0.1, 4)
    bounds = dict.fromkeys(chain.all_drives, (low, high))
    found = kt.kinematics.workspace(chain, task, ("x", x), ("z", z), limits=bounds)
    free = kt.kinematics.workspace(chain, task, ("x", x), ("z", z))
    q = found.drive_position.values
    assert np.all((q[found.within.values] >= low - 1e-9) & (q[found.within.values] <= high + 1e-9))
    least = free.drive_position.values
    alone = free.reachable.values & np.all((least >= low) & (least <= high), axis=-1)
    assert np.all(found.within.values[alone]) and found.within.values.sum() > alone.sum()
    assert np.any(free.reachable.values & ~found.within.values)
    for i, j in np.argwhere(found.reachable.values):
        at = kt.kinematics.assemble(chain, dict(zip(chain.all_drives, q[i, j], strict=True)))
        place = np.mean([at[list(chain.nodes).index(name)] for name in top], axis=0)
        assert place[[0, 2]] == pytest.approx([x[j], z[i]], abs=1e-9)


@pytest.mark.slow
def test_maps_of_angles_are_drawn_in_degrees_and_slices_only(found, tmp_path):
    text = report.map_picture(found.isel({"bay.height": 0}), tmp_path / "m.svg", "stroke").read_text("utf-8")
    assert "bay.beta, deg" in text and "bay.gamma, deg" in text
    with pytest.raises(kt.InputError, match=r"axes bay.height, bay.gamma, bay.beta. Draw one slice"):
        report.map_picture(found, tmp_path / "m.svg")


@pytest.mark.parametrize(
    ("point", "at", "words"),
    [
        ("boy", None, "No node called 'boy', nor a pose. Did you mean 'bay'"),
        (["bay.beta", "bay.gamma", "bay.hight"], None, "no coordinate called 'bay.hight'"),
        (["bay.beta", "bay.gamma", "N8.x", "N8.y"], None, r"\(rank 2\). Name fewer"),
        ("bay", {"bay.height": [1.1, 1.0]}, "increasing"),
        ("bay", {"height": 1.0}, "not different axes of bay.beta, bay.gamma, bay.height"),
        (kt.Coordinates(moves={"bay.beta": 0, "bay.gamma": 0}, objective="conditioning"), None, "A map cannot choose"),
    ],
)
def test_what_cannot_be_mapped_is_told(bay, point, at, words):
    with pytest.raises(kt.KinetrussError, match=words):
        kt.kinematics.workspace(bay, point, ("bay.beta", [0.0]), ("bay.gamma", [0.0]), at)
