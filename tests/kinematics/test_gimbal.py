"""The closed form of the double-octahedral bay: against node positions, differences, its own inverse, stored values."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.motion.gimbal import gimbal_inverse
from kinetruss.kernels.motion.placement import place_bay, reach
from kinetruss.kinematics import gimbal_lengths, gimbal_pose
from kinetruss.library.vgt import double_octahedral

BASE, LONGERON, HEIGHT = 48 * 0.0254, 35 * 0.0254, 1.1218253458835146
PAIRS = ((4, 5), (5, 6), (4, 6))

angles = st.floats(-0.3, 0.3)
heights = st.floats(0.7, 1.05)  # reachable at every pair of these angles, with some room


def lengths_of(nodes):
    """M7, M9, M11 from node positions; also for complex ones."""
    apart = [nodes[i - 1] - nodes[j - 1] for i, j in PAIRS]
    return np.array([np.sqrt((d * d).sum()) for d in apart])


def jets(pose):
    """Lengths with rates and accelerations, (n, 3, 3)."""
    asked = np.ascontiguousarray(pose[:, None])
    out, margin = np.empty_like(asked), np.empty(asked.shape[:2])
    gimbal_inverse(np.array([BASE]), np.array([LONGERON]), asked, out, margin)
    return out[:, 0]


def test_stored_lengths():
    # independent computation: equal lengths of 46 in, and +-10 deg at the same height
    tilted = gimbal_lengths(BASE, LONGERON, np.radians([-10, 0, 10]), 0, HEIGHT)
    assert tilted[1] == pytest.approx([1.1684] * 3, abs=1e-15)
    assert tilted[0] == pytest.approx([1.248818925, 1.11651438, 1.11651438], abs=5e-10)
    assert tilted[2] == pytest.approx([1.069583, 1.205617, 1.205617], abs=5e-7)


@settings(deadline=None)
@given(angles, angles, heights)
def test_lengths_are_distances_of_nodes(beta, gamma, height):
    nodes = place_bay(BASE, LONGERON, beta, gamma, height)
    assert gimbal_lengths(BASE, LONGERON, beta, gamma, height) == pytest.approx(lengths_of(nodes), rel=1e-14)


@settings(deadline=None)
@given(angles, angles, heights)
def test_placed_bay_keeps_its_triangles_longerons_and_pose(beta, gamma, height):
    nodes = place_bay(BASE, LONGERON, beta, gamma, height)
    for i, j in ((1, 2), (2, 3), (3, 1), (7, 8), (8, 9), (9, 7)):
        assert np.linalg.norm(nodes[i - 1] - nodes[j - 1]) == pytest.approx(BASE, rel=1e-14)
    for i, j in ((6, 2), (6, 1), (4, 1), (4, 3), (5, 3), (5, 2), (6, 9), (6, 7), (4, 7), (4, 8), (5, 8), (5, 9)):
        assert np.linalg.norm(nodes[i - 1] - nodes[j - 1]) == pytest.approx(LONGERON, rel=1e-13)
    centre = nodes[6:].mean(axis=0)
    assert np.linalg.norm(centre) == pytest.approx(height, rel=1e-14)
    normal = np.cross(nodes[7] - nodes[6], nodes[8] - nodes[6])  # N7, N9, N8 go round upwards
    normal /= -np.linalg.norm(normal)
    expected = [-np.sin(gamma), -np.sin(beta) * np.cos(gamma), np.cos(beta) * np.cos(gamma)]
    assert normal == pytest.approx(expected, abs=1e-14)


@settings(deadline=None)
@given(st.lists(st.tuples(angles, angles, heights), min_size=1, max_size=4))
def test_pose_is_the_inverse_of_lengths(poses):
    beta, gamma, height = np.array(poses).T
    lengths = gimbal_lengths(BASE, LONGERON, beta, gamma, height)
    back = gimbal_pose(BASE, LONGERON, lengths)
    for found, given_ in zip(back, (beta, gamma, height), strict=True):
        assert found == pytest.approx(given_, abs=1e-11)


@settings(deadline=None)
@given(angles, angles, heights, st.lists(st.floats(-2, 2), min_size=3, max_size=3))
def test_rates_by_complex_step(beta, gamma, height, rates):
    h = 1e-30
    moved = place_bay(BASE, LONGERON, *(q + 1j * h * v for q, v in zip((beta, gamma, height), rates, strict=True)))
    pose = np.array([[[q, v, 0.0] for q, v in zip((beta, gamma, height), rates, strict=True)]])
    assert jets(pose)[0, :, 1] == pytest.approx(lengths_of(moved).imag / h, abs=1e-12)


def test_accelerations_are_the_slopes_of_rates():
    def pose(t):
        beta = np.array([0.2 * np.sin(3 * t), 0.6 * np.cos(3 * t), -1.8 * np.sin(3 * t)])
        gamma = np.array([0.1 * t * t, 0.2 * t, 0.2 + 0 * t])
        height = np.array([1 + 0.05 * np.cos(5 * t), -0.25 * np.sin(5 * t), -1.25 * np.cos(5 * t)])
        return np.array([beta, gamma, height]).transpose(2, 0, 1)

    t, h = np.linspace(0, 1, 11), 2e-3
    weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
    slope = sum(w * (jets(pose(t + k * h)) - jets(pose(t - k * h))) for k, w in weights.items()) / h
    assert jets(pose(t))[:, :, 1:] == pytest.approx(slope[:, :, :2], abs=1e-11)


def chain_of_three(beta, gamma):
    """N1, N2, N3 of the first bay, then N4..N9 of each."""
    model = double_octahedral(3, base=BASE, longeron=LONGERON, beta=beta, gamma=gamma, height=HEIGHT)
    return np.array([node.at for node in model.nodes.values()])


def test_a_second_bay_stands_on_the_first():
    nodes = chain_of_three(0.1, 0.15)
    first, second = nodes[:9], nodes[[6, 8, 7, *range(9, 15)]]
    apart = [np.linalg.norm(bay[:, None] - bay[None], axis=2) for bay in (first, second)]
    assert apart[0] == pytest.approx(apart[1], abs=1e-14)


def test_chain_of_three_ends_where_the_stored_one_does():
    # independent computation at beta = gamma = 5 deg, the middle of the two-axis motion
    nodes = chain_of_three(*np.radians([5, 5]))
    assert nodes[-2] == pytest.approx([-0.4601834246, 0.2454731604, 3.470942637], abs=1e-9)
    assert nodes[-3] == pytest.approx([-1.013350558, -0.7541668894, 3.045296618], abs=1e-9)


def test_out_of_reach_says_how_far_one_can_go():
    with pytest.raises(
        AnalysisError, match=r"beta = 80 deg, gamma = 0 deg.*out of reach.*reaches beta = (\d+\.\d+) deg"
    ) as caught:
        gimbal_lengths(BASE, LONGERON, [0, np.radians(80)], 0, HEIGHT)
    nearest = float(str(caught.value).rpartition("reaches beta = ")[2].partition(" ")[0])
    assert reach(BASE, LONGERON, np.radians(nearest - 0.01), 0, HEIGHT) > 0
    assert reach(BASE, LONGERON, np.radians(nearest + 0.01), 0, HEIGHT) < 0


@pytest.mark.parametrize("height", [-0.5, 0.0, 1.3])
def test_heights_out_of_reach(height):
    with pytest.raises(AnalysisError, match=r"height must lie above 0 and below 1\.29"):
        gimbal_lengths(BASE, LONGERON, 0, 0, height)


def test_lengths_that_cannot_close():
    with pytest.raises(AnalysisError, match=r"M7 = 0\.2 m.*cannot be closed"):
        gimbal_pose(BASE, LONGERON, [[1.1684] * 3, [0.2, 1.6, 1.6]])


def test_longerons_must_span_the_base():
    with pytest.raises(InputError, match=r"longer than 0\.6096 m"):
        gimbal_pose(BASE, 0.5, [1, 1, 1])
    with pytest.raises(InputError, match="expected .*lengths of M7, M9, M11 = 3"):
        gimbal_pose(BASE, LONGERON, [1, 1])
