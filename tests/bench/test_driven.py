"""The race of driven trusses runs without peers, and its own dense reference is that of the multipliers' definition."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path[:0] = [str(BENCH / "peers"), str(BENCH / "driven")]


def test_forces_of_kinetruss_are_those_of_dense_algebra():
    call = [sys.executable, BENCH / "driven.py", "--json", "--bays", "1", "--rounds", "1"]
    found = json.loads(subprocess.run(call, check=True, capture_output=True, text=True).stdout)
    (row,) = found["rows"]
    assert (row["code"], row["bays"]) == ("kinetruss", 1)
    assert row["error"] < 1e-13
    assert row["us_per_sample"] > 0


def test_the_reference_keeps_power_balance():
    from _case import changes, course, right, times, truss

    bars, (x, v, a, tension) = truss(1), right(1)
    mass = bars.lump[:, None]
    inertia = np.einsum("sij,sij->s", v, mass * (a - bars.gravity) - bars.force)
    drives = -(tension @ changes(bars)) * course(times())[1]
    assert np.abs(x[:, bars.fixed] - bars.points[bars.fixed]).max() == 0
    assert drives == pytest.approx(inertia, abs=1e-10 * np.abs(inertia).max())


def test_a_wrong_force_counts_as_an_error():
    from _case import SETTLED, error_of, right

    state = right(1)[3].copy()
    assert error_of(1, state.reshape(-1).tolist()) == 0
    state[SETTLED + 5, 3] += 0.01 * np.abs(state).max()
    assert error_of(1, state.reshape(-1).tolist()) == pytest.approx(0.01, rel=1e-9)
