"""Loops with more rows than rank through a full turn: no set of independent rows serves all the way round."""

import numpy as np
import pytest

import kinetruss as kt
import loop_models

TURN = 2 * np.pi


def made(name):
    data = getattr(loop_models, name)()
    angles = loop_models.angles_at(data, 1.0, np.array(loop_models.STARTS[name]))
    return data, angles, loop_models.loop(data, angles)


def turned(model, samples, **options):
    return kt.kinematics.follow(model, kt.ConstantRate(rates={"crank": TURN}, duration=1.0), samples=samples, **options)


@pytest.mark.slow
@pytest.mark.parametrize("name", loop_models.STARTS)
def test_full_turn_against_the_closure_of_the_hinges(name):
    data, angles, model = made(name)
    motion, worst = turned(model, 181), 0.0
    for i, position in enumerate(motion.position.values):
        angles = loop_models.angles_at(data, 1.0 + TURN * i / 180, angles)
        for k, (point, _) in enumerate(loop_models.hinges(*data, angles)[0]):
            worst = max(worst, np.abs(position[2 * k] - point).max())
    assert motion.status is kt.Status.COMPLETED
    assert worst < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("name", loop_models.STARTS)
def test_power_of_the_crank_closes_all_the_way_round(name):
    *_, model = made(name)
    forces = kt.dynamics.inverse(model, turned(model, 181))
    assert np.abs(forces.energy_balance).max() < 1e-9 * np.abs(forces.power).max()


@pytest.mark.slow
@pytest.mark.parametrize("name", loop_models.STARTS)
@pytest.mark.parametrize("samples", [5, 13, 61])
def test_spacing_of_samples_changes_nothing(name, samples):
    *_, model = made(name)
    fine = turned(model, 181).position.values[:: 180 // (samples - 1)]
    np.testing.assert_allclose(turned(model, samples).position.values, fine, rtol=0, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.25, 0.6, 0.95])
@pytest.mark.parametrize("name", loop_models.STARTS)
def test_assembled_and_posed_where_the_motion_goes(name, share):
    *_, model = made(name)
    motion = turned(model, 181)
    there, value = motion.position.values[int(180 * share)], motion.drive_position.values[int(180 * share), 0]
    np.testing.assert_allclose(kt.kinematics.assemble(model, {"crank": value}), there, rtol=0, atol=1e-12)
    posed = kt.statics.at_poses(model, [{"crank": value}])
    assert posed.status is kt.Status.COMPLETED


@pytest.mark.slow
def test_the_reach_of_a_redundant_loop_is_no_fight_of_drives():
    # the threefold Bricard linkage cannot turn its first hinge all round
    model = kt.library.mechanisms.bricard(twist=1.2, angle=0.8)
    model = model.with_(drives={"crank": kt.HingeDrive(axis=("P1", "A1"), start="P6", end="P2")}, runs={})
    motion = turned(model, 721, raise_on_failure=False)
    assert motion.status is kt.Status.OUT_OF_REACH
    assert 1 < len(motion.data.time) < 721
    lengths = motion.data.length.values
    assert np.abs(lengths - lengths[0]).max() < 1e-9


def test_lengths_that_contradict_each_other_are_told():
    square = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}, fixed=["A", "B"],
        bars={"b": ("B", "C"), "c": ("C", "D"), "d": ("D", "A"), "e": ("A", "C"), "f": ("B", "D")},
    )  # fmt: skip
    with pytest.raises(kt.InputError, match="contradict each other.*off by"):
        kt.kinematics.assemble(square, {"e": 1.5})
