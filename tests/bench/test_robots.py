"""Closed forms of the benchmark of robots against published numbers of the cases, and the form of its rows."""

import json
import subprocess
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


def test_rows():
    command = [sys.executable, str(BENCH / "robots.py"), "--json", "--rounds", "1", "--cases", "delta_path", "stewart_path"]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    rows = json.loads(done.stdout)["rows"]
    assert [row["case"] for row in rows if row["error"] is not None] == [
        "delta path: inverse_along",
        "stewart path: inverse_along",
    ]
    for row in rows:
        assert set(row) == {"case", "us_per_sample", "seconds", "error", "ratio"}
        assert row["error"] is None or row["error"] < 1e-11


def test_rows_of_the_models():
    """Each to the error wanted with a time, and again at 1e-11."""
    command = [sys.executable, str(BENCH / "robots.py"), "--json", "--rounds", "1", "--cases", "models"]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    rows = json.loads(done.stdout)["rows"]
    names = ["andrews, ten bars", "andrews, rigid beam", "robot", "delta"]
    assert [row["case"].removeprefix("models, ").split(":")[0] for row in rows] == names + names
    assert all(row["seconds"] > 0 and row["error"] <= 1e-8 for row in rows[:4])
    assert all(row["seconds"] is None and row["error"] < 1e-10 for row in rows[4:])
