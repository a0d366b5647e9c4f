"""Histories of a platform's nodes: places by another code, rates by what holds for every rigid body."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kinetruss.kernels.motion.gimbal import platform_motion

CENTRE = np.array([0.3, -0.2, 1.1])
ARMS = np.random.default_rng(0).standard_normal((5, 3))


def _moved(jets, dim=3):
    out = np.empty((3, jets.shape[1], len(ARMS), dim))
    platform_motion(CENTRE, ARMS, jets, out)
    return out


def _jets(count=7):
    return np.random.default_rng(1).standard_normal((3, count, 6))


def test_places_are_those_of_three_turns():
    jets = _jets()
    turned = Rotation.from_euler("ZYX", jets[0, :, [5, 4, 3]].T).as_matrix()
    expected = CENTRE + jets[0, :, None, :3] + np.einsum("tij,nj->tni", turned, ARMS)
    assert np.abs(_moved(jets)[0] - expected).max() < 1e-14


def test_distances_keep_still():
    """d . d' = 0 and d . d'' + d' . d' = 0 for every pair of nodes."""
    x, v, a = _moved(_jets())
    d, dv, da = (y[:, :, None] - y[:, None] for y in (x, v, a))
    scale = np.abs(da).max() * np.abs(d).max()
    assert np.abs(np.einsum("tijc,tijc->tij", d, dv)).max() < 1e-15 * scale
    assert np.abs(np.einsum("tijc,tijc->tij", d, da) + np.einsum("tijc,tijc->tij", dv, dv)).max() < 1e-14 * scale


def test_rates_are_those_of_the_places():
    """Along jets that are cubic in time; central differences of fourth order leave h^4 times a fifth derivative."""
    coefficients = np.random.default_rng(2).uniform(-0.5, 0.5, (4, 6))
    h = 1e-2
    t = 0.4 + h * np.arange(-2, 3)[:, None]
    powers = [sum(c * t**k for k, c in enumerate(coefficients))]
    powers.append(sum(k * c * t ** (k - 1) for k, c in enumerate(coefficients) if k))
    powers.append(sum(k * (k - 1) * c * t ** (k - 2) for k, c in enumerate(coefficients) if k > 1))
    x, v, a = _moved(np.array(powers))
    for y, rate in ((x, v), (v, a)):
        slope = (y[0] - 8 * y[1] + 8 * y[3] - y[4]) / (12 * h)
        assert np.abs(slope - rate[2]).max() < 100 * h**4


@pytest.mark.parametrize("dim", [2, 3])
def test_a_turn_about_one_axis_is_a_circle(dim):
    """Yaw at w, w': velocity w k x r, acceleration w' k x r - w^2 r in the plane."""
    jets = np.zeros((3, 1, 6))
    w, second = 1.7, -0.6
    jets[:, 0, 5] = 0.8, w, second
    x, v, a = (y[0, :, :2] for y in _moved(jets, dim))
    r = x - CENTRE[:2]
    across = np.stack([-r[:, 1], r[:, 0]], axis=1)
    assert np.abs(v - w * across).max() < 1e-14
    assert np.abs(a - second * across + w**2 * r).max() < 1e-14
