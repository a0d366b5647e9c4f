"""Motion and forces where rows all but depend on each other: right as far as numbers can be; the message names what is lost."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import kinetruss as kt
from kinetruss import Model
from kinetruss.dynamics import simulate
from kinetruss.errors import AnalysisError
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


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize(("sag", "light"), [(1e-3, 1e-3), (1e-4, 1.0), (2e-5, 1e3), (1e-5, 1e-4), (1e-3, 1e-8)])
@pytest.mark.parametrize("solver", ["dense", "sparse"])
@pytest.mark.parametrize("kind", [DOP853, Taylor])
def test_motion_and_steps_are_those_of_the_pendulum(sag, light, kind, solver):
    run = simulate(hung(sag, light), 0.5, samples=6, method=kind(solver=solver))
    begin = [np.arctan2(0.6, 0.8), 0.0]
    exact = solve_ivp(
        lambda _, y: [y[1], -GRAVITY * np.sin(y[0])], (0, 0.5), begin, "DOP853", rtol=1e-13, atol=1e-13, t_eval=run.time.values
    ).y[0]
    rod = run.motion.position.sel(node="D").values - run.motion.position.sel(node="C").values
    np.testing.assert_allclose(np.arctan2(rod[:, 0], -rod[:, 1]), exact, rtol=0, atol=2e-10)
    assert run.steps.values[-1] < 30  # round-off of the equations is no reason for short steps


def test_digits_that_no_solver_finds_are_named():
    with pytest.raises(AnalysisError, match="keep no digits.*smallest pivot"):
        simulate(hung(1e-5, 1e-8), 0.5, samples=6)


def test_usual_runs_are_not_warned():
    run = simulate(hung(0.3, 1.0), 0.5, samples=6)
    assert run.message == ""


def test_a_singular_position_whose_free_motion_is_loaded_has_no_forces():
    """Two links on one line hold nothing across it: no number of theirs is a force."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (0, 2)}, fixed=["A", "C"], bars={"a": ("A", "B"), "b": ("B", "C")},
        loads={"F": kt.NodalForce(node="B", force=(1.0, 0.0))},
    )  # fmt: skip
    still = np.zeros((1, 3, 2))
    motion = kt.kinematics.from_arrays(model, [0.0], np.array([[(0, 0), (0, 1), (0, 2)]], float), still, still)
    with pytest.raises(kt.AnalysisError, match="Position 0 of 1 is singular: drives and bars leave a motion free there"):
        kt.dynamics.inverse(model, motion)
