"""Closed forms of the benchmark of robots against published numbers of the cases."""

import sys
from pathlib import Path

import numpy as np
import pytest

BENCH = Path(__file__).parents[2] / "bench"
sys.path.insert(0, str(BENCH / "peers"))

import _robots  # noqa: E402

pytestmark = pytest.mark.slow


def test_delta_closed_form():
    angles, torques = _robots.delta_closed_form(
        np.array([[0.05, -0.08, -0.75]]), np.array([[1.2, -0.7, 0.5]]), np.array([[8.0, -5.0, 12.0]])
    )
    np.testing.assert_allclose(angles[0], [0.2032907176392995, 0.44966326347074936, 0.21341826311254275], rtol=0, atol=1e-14)
    np.testing.assert_allclose(torques[0], [-7.024949349790452, -0.35332027885705214, -4.538558518535321], rtol=0, atol=1e-13)


def test_robot_in_minimal_coordinates():
    start = _robots.robot_acceleration(0.0, _robots.START, _robots.RATES)
    known = [0.01034296931288097, -0.10743967315246684, 1.0686937198122766, 0.5019482865454729, 4.7241036192175745]
    np.testing.assert_allclose(start, known, rtol=0, atol=1e-13)
    end = [1.4009915808357993, 0.9580814887134403, 2.167377712192491, 1.2917929326437128, 1.9963469433491754]
    np.testing.assert_allclose(_robots.robot_end(1e-12)[0], end, rtol=0, atol=1e-10)
