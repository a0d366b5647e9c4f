"""A straight link whose compression exceeds Euler's load: its beam-column has no finite value, and the verdict says why."""

import numpy as np
import pytest

import kinetruss as kt


@pytest.fixture
def strut():
    """A bar and a link of three pins, which is pushed with three times its Euler load."""
    link = kt.Link(nodes=("A", "B", "C"), section=kt.Rod(diameter=0.02), material="steel_s235")
    euler = np.pi**2 * 210e9 * np.pi / 64 * 0.02**4 / 2.0**2
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0), "D": (1, -1)},
        fixed={"A": "xy", "C": "y", "D": "xy"},
        links={"strut": link},
        bars={"prop": kt.Bar(ends=("B", "D"), kind="elastic", stiffness=1e3, mass=0)},
        loads={"push": kt.NodalForce(node="C", force=(-3 * euler, 0)), "side": kt.NodalForce(node="B", force=(0, -1))},
        runs={"stand": kt.Run(analysis="statics.linear")},
    )


def test_the_verdict_says_that_the_link_is_beyond_its_euler_load(strut):
    rows = {(row.part, row.rule): row for row in kt.run(strut, "stand").verdict.table()}
    assert rows["strut", "buckling"].utilisation == pytest.approx(3, rel=1e-6)
    assert np.isinf(rows["strut", "beam-column"].utilisation)
    assert "exceeds Euler's load (4.07 kN)" in rows["strut", "beam-column"].note


def test_so_does_a_mission(strut):
    moving = strut.with_(
        bars={"prop": kt.Bar(ends=("B", "D"), kind="driven", mass=0)},
        fixed={"A": "xy", "D": "xy"},
        runs={
            "hold": kt.Run(trajectory=kt.Quintic(moves={"prop": (1.0, 1.0)}, duration=1.0), samples=2),
            "all": kt.Run(analysis="mission", motions=("hold",)),
        },
    )
    rows = {(row.part, row.rule): row for row in kt.run(moving, "all").verdict.table()}
    assert np.isinf(rows["strut", "beam-column"].utilisation)
    assert rows["strut", "beam-column"].note == "compression (12.21 kN) exceeds Euler's load (1.017 kN)"
