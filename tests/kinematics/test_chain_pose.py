"""Closed form of bays in equal poses: against the general solver, its own inverse, exact shares."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.kinematics import chain_lengths, chain_pose, gimbal_lengths
from kinetruss.library import cells

BASE, LONGERON = 1.2192, 0.889
angles = st.floats(-0.6, 0.6)


@pytest.mark.slow
@settings(deadline=None, max_examples=100)
@given(st.integers(1, 8), angles, angles, st.floats(0.6, 0.9))
def test_the_pose_comes_back(bays, beta, gamma, height):
    pose = np.array([beta, gamma, height * bays])
    assert np.array(chain_pose(BASE, LONGERON, chain_lengths(BASE, LONGERON, *pose, bays))) == pytest.approx(pose, abs=1e-12)


@pytest.mark.slow
@settings(deadline=None, max_examples=15)
@given(angles, angles, st.floats(1.2, 1.8))
def test_the_cell_is_drawn_in_the_pose_that_the_solver_finds(beta, gamma, height):
    short = {"base_length": 0.1, "tube_length": 0.1}
    upright = cells.stack([cells.quadruple_octahedron(**short)])
    lengths = chain_lengths(BASE, LONGERON, beta, gamma, height)
    drawn = cells.stack([cells.quadruple_octahedron(beta=beta, gamma=gamma, height=height, **short)])
    found = kt.kinematics.assemble(upright, dict(zip(upright.active, lengths.tolist(), strict=True)))
    assert found == pytest.approx(np.array([node.at for node in drawn.nodes.values()]), abs=1e-12)


def test_lengths_that_are_not_equal():
    """The top of two bays in different poses, by the general solver."""
    model = cells.stack([cells.quadruple_octahedron()])
    lengths = np.array([1.16, 1.2, 1.12, 1.18, 1.13, 1.17])
    x = kt.kinematics.assemble(model, dict(zip(model.active, lengths.tolist(), strict=True)))
    places = dict(zip(model.nodes, x, strict=True))
    seven, nine, eight = (places[f"H2.N{k}"] for k in (7, 9, 8))
    normal = np.cross(nine - seven, eight - seven)
    normal /= np.linalg.norm(normal)
    beta, gamma, height = chain_pose(BASE, LONGERON, lengths)
    assert [beta, gamma] == pytest.approx([np.arctan2(-normal[1], normal[2]), np.arcsin(-normal[0])], abs=1e-12)
    assert height == pytest.approx(np.linalg.norm((seven + nine + eight) / 3), abs=1e-12)


def test_arrays_are_broadcast_and_one_bay_is_the_bay():
    beta = np.linspace(-0.3, 0.3, 7)
    assert chain_lengths(BASE, LONGERON, beta, 0.1, 2.0).shape == (7, 6)
    assert chain_lengths(BASE, LONGERON, beta, 0.1, 1.0, 1) == pytest.approx(
        gimbal_lengths(BASE, LONGERON, beta, 0.1, 1.0), abs=1e-15
    )
    assert np.shape(chain_pose(BASE, LONGERON, np.full((2, 3, 9), 1.1684))) == (3, 2, 3)


def test_faults():
    with pytest.raises(kt.AnalysisError, match="Each of the 2 bays: the pose beta = 50 deg.*is out of reach"):
        chain_lengths(BASE, LONGERON, np.radians(100), 0, 2.3)
    with pytest.raises(kt.InputError, match=r"lengths: shape \(4,\), expected \(\.\.\., 3 bays\)"):
        chain_pose(BASE, LONGERON, [1.1] * 4)
    with pytest.raises(kt.InputError, match="bays is 0"):
        chain_lengths(BASE, LONGERON, 0, 0, 2, 0)
