"""Forces where rows all but depend on each other: right as far as numbers can be, and the message names what is lost."""

from __future__ import annotations

import numpy as np
import pytest

from kinetruss import Model
from kinetruss.dynamics import simulate
from kinetruss.model import DOP853, Taylor

GRAVITY = 9.80665


def hung(sag, light):
    """A pendulum of 1 kg hangs from a light node, held by two bars that are all but in line."""
    return Model(
        nodes={
            "A": (-1.0, 0.0), "B": (1.0, 0.0), "C": {"at": (0.0, -sag), "mass": light},
            "D": {"at": (0.6, -sag - 0.8), "mass": 1.0},
        },
        fixed=("A", "B"), gravity=(0.0, -GRAVITY), bars={"left": ("A", "C"), "right": ("C", "B"), "rod": ("C", "D")},
    )  # fmt: skip


def expected(run, light):
    """Forces by hand: m (v^2/l + g cos) in the rod, the balance of C in the two bars that hold it."""
    x = {name: run.motion.position.sel(node=name).values for name in "ABCD"}
    length = np.linalg.norm(x["D"] - x["C"], axis=1)
    u = (x["D"] - x["C"]) / length[:, None]
    rod = (run.motion.velocity.sel(node="D").values ** 2).sum(axis=1) / length - GRAVITY * u[:, 1]
    to = [(x[end] - x["C"]) / np.linalg.norm(x[end] - x["C"], axis=1)[:, None] for end in "AB"]
    loads = rod[:, None] * u + [0.0, -light * GRAVITY]
    left, right = np.linalg.solve(np.stack(to, axis=2), -loads[:, :, None])[:, :, 0].T
    return np.stack([left, right, rod], axis=1)


@pytest.mark.parametrize(("sag", "light"), [(1e-4, 1.0), (1e-3, 1e-3), (1e-4, 1e-3), (1e-2, 1e-6), (1e-3, 1e-6), (1e-3, 1e-8)])
@pytest.mark.parametrize("method", [DOP853(), Taylor()])
def test_forces_are_right_beside_a_singular_position(sag, light, method):
    run = simulate(hung(sag, light), 0.5, samples=6, method=method)
    forces = run.forces.member_force.sel(member=["left", "right", "rod"]).values
    by_hand = expected(run, light)
    # the two bars carry 1/(2 sag) times the load: their direction is known to one part in 1e16/sag
    np.testing.assert_allclose(forces, by_hand, rtol=0, atol=1e-10 * np.abs(by_hand).max())
    np.testing.assert_allclose(forces[:, 2], by_hand[:, 2], rtol=1e-9)
    assert "digits" not in run.message


def test_forces_that_no_solver_finds_are_named():
    run = simulate(hung(1e-5, 1e-6), 0.5, samples=6)
    forces, by_hand = run.forces.member_force.sel(member="rod").values, expected(run, 1e-6)[:, 2]
    assert np.abs(forces - by_hand).max() > 1e-3 * np.abs(by_hand).max()
    assert "keep no digits" in run.message
    assert "smallest pivot 2e-05" in run.message


def test_usual_runs_are_not_warned():
    run = simulate(hung(0.3, 1.0), 0.5, samples=6)
    assert run.message == ""
