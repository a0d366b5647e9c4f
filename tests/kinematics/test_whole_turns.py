"""Whole turns are counted along the motion itself: as many with 2 samples as with 2,000."""

import math

import numpy as np
import pytest

import kinetruss as kt
from hinge_models import Arm
from kinetruss.dynamics import simulate
from kinetruss.errors import InputError
from kinetruss.kinematics import follow, joint, pose

COUNTS = (2, 3, 7, 40, 900)
FREE = kt.Free()


def crank_rocker():
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (3, 0), "D": (3.2, 2.5)}, fixed=["A", "C"],
        bars={"crank": ("A", "B"), "coupler": ("B", "D"), "rocker": ("C", "D")}, drives={"turn": kt.AngleDrive("crank")},
    )  # fmt: skip


def rotor(rate, drive="angle"):
    """A free rotor of two masses that a long arm carries, which turns the other way at a third of its rate."""
    nodes = {"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1.0), "B": kt.Node(at=(1.5, 0), mass=0.4), "G": (0, -1)}
    drives = {"hip": kt.HingeDrive(axis="O", start="G", end="A"), "elbow": kt.HingeDrive(axis="A", start="O", end="B")}
    if drive == "angle":
        drives = {"hip": kt.AngleDrive("arm"), "elbow": kt.AngleDrive("tip")}
    return kt.Model(
        nodes=nodes, fixed=["O", "G"], drives=drives, gravity=(0, -9.81),
        bars={"arm": kt.Bar(ends=("O", "A"), mass=0), "tip": kt.Bar(ends=("A", "B"), mass=0)},
        velocities={"A": (0, -rate / 3), "B": (0, -rate / 3 + 0.5 * rate)},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("rate", [2.0, -9.0])
def test_angles_of_a_crank_that_is_driven(rate):
    model, ends = crank_rocker(), set()
    for samples in COUNTS:
        motion = follow(model, kt.ConstantRate(rates={"turn": rate}, duration=11.0), samples=samples)
        crank, between = pose(model, motion, ("A", "B")), joint(model, motion, ("A", "B"), ("B", "D"))
        assert float(crank.angle[-1]) == pytest.approx(11.0 * rate, abs=1e-9)
        assert crank.sizes["time"] == between.sizes["time"] == samples
        assert float(motion.drive_position[-1, 0]) == pytest.approx(11.0 * rate, abs=1e-9)
        ends.add((round(float(between.angle[-1]), 8), round(float(pose(model, motion, ("C", "D")).angle[-1]), 8)))
    assert len(ends) == 1
    # the coupler of a crank-rocker turns not at all against the frame
    assert abs(next(iter(ends))[0] + 11.0 * rate) < 2 * math.pi


@pytest.mark.slow
def test_a_trajectory_that_goes_to_and_fro_between_samples():
    model = crank_rocker()
    for period in (1.0, 2.0, 0.4):
        motion = follow(model, kt.Sine(amplitudes={"turn": 9.0}, period=period, duration=4.0), samples=3)
        assert np.abs(pose(model, motion, ("A", "B")).angle.values).max() < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("method", [None, kt.DOP853(), kt.EnergyMomentum(step=0.004)])
@pytest.mark.parametrize("drive", ["angle", "hinge"])
@pytest.mark.parametrize("rate", [11.0, -7.0])
def test_angles_of_what_is_let_go(method, drive, rate):
    model, ends = rotor(rate, drive), []
    for samples in (2, 5, 31, 401):
        run = simulate(model, 6.0, samples=samples, tasks={"hip": FREE, "elbow": FREE}, method=method)
        arm, tip = (float(pose(model, run.motion, pair).angle[-1]) for pair in (("O", "A"), ("A", "B")))
        both = float(joint(model, run.motion, ("O", "A"), ("A", "B")).angle[-1])
        ends.append([*run.motion.drive_position.values[-1], arm, tip, both])
    ends = np.array(ends)
    np.testing.assert_allclose(ends, ends[-1:].repeat(len(ends), axis=0), atol=2e-5)
    assert np.abs(ends[-1]).max() > 4 * math.pi
    assert ends[-1, 4] == pytest.approx(ends[-1, 3] - ends[-1, 2], abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("method", [None, kt.DOP853(), kt.EnergyMomentum(step=0.004)])
def test_hinges_in_space(method):
    model, ends = Arm().model(), []
    speeds = {"S1": (-0.5, 4.5, 0.0), "S2": (-3.5, 4.0, 0.0), "P": (-2.5, 8.0, 0.0)}
    for samples in (2, 4, 25, 501):
        run = simulate(model, 5.0, samples=samples, tasks={"base": FREE, "elbow": FREE}, velocities=speeds, method=method)
        at = joint(model, run.motion, ("O", "T", "S1", "S2"), ("S1", "S2", "P"))
        turned = pose(model, run.motion, ("O", "T", "S1", "S2"))
        ends.append([*run.motion.drive_position.values[-1], float(at.angle[-1]), *turned.rotation_vector.values[-1],
                     *turned.quaternion.values[-1]])  # fmt: skip
    ends = np.array(ends)
    np.testing.assert_allclose(ends, ends[-1:].repeat(len(ends), axis=0), atol=1e-4)
    assert np.abs(ends[-1]).max() > 2 * math.pi


@pytest.mark.slow
def test_spatial_hinges_that_are_driven():
    model, ends = Arm().model(), []
    for samples in COUNTS:
        motion = follow(model, kt.ConstantRate(rates={"base": 3.0, "elbow": -5.0}, duration=7.0), samples=samples)
        at = joint(model, motion, ("O", "T", "S1", "S2"), ("S1", "S2", "P"))
        turned = pose(model, motion, ("O", "T", "S1", "S2"))
        assert float(at.angle[-1]) == pytest.approx(-35.0, abs=1e-8)
        assert float(turned.rotation_vector[-1, 2]) == pytest.approx(21.0, abs=1e-8)
        ends.append(turned.euler.values[-1])
    np.testing.assert_allclose(ends, ends[-1:] * len(ends), atol=1e-8)


def test_samples_from_elsewhere_that_are_too_far_apart_are_refused():
    model = crank_rocker()
    fine = follow(model, kt.ConstantRate(rates={"turn": 4.0}, duration=5.0), samples=101)
    for step, good in ((1, True), (5, True), (25, False)):
        given = [fine.data[name].values[::step] for name in ("time", "position", "velocity", "acceleration")]
        motion = kt.kinematics.from_arrays(model, *given)
        if good:
            assert float(pose(model, motion, ("A", "B")).angle[-1]) == pytest.approx(20.0, abs=1e-9)
            assert "whole turns" not in motion.message
            continue
        assert "whole turns" in motion.message and "turn" in motion.message
        with pytest.raises(InputError, match=r"whole turns cannot be counted. Give samples at most"):
            pose(model, motion, ("A", "B"))
        with pytest.raises(InputError, match="whole turns"):
            joint(model, motion, ("A", "B"), ("B", "D"))


def test_a_simulation_in_pieces_goes_on_counting():
    from kinetruss.dynamics.simulation import stepper_for
    from kinetruss.dynamics.simulation_records import simulation_of
    from kinetruss.dynamics.simulation_setup import Options, problem_of

    model = rotor(-7.0)
    work = stepper_for(problem_of(model, 6.0, Options(tasks={"hip": FREE, "elbow": FREE})), 6.0)
    whole = simulate(model, 6.0, samples=4, tasks={"hip": FREE, "elbow": FREE}).motion
    for times in ([0.0, 2.0], [4.0], [6.0]):
        part = simulation_of(work, work.advance(np.array(times))).motion
        state = work.arrays()
        work = stepper_for(problem_of(model, 6.0, Options(tasks={"hip": FREE, "elbow": FREE})), 6.0)
        work.restore(state)
    np.testing.assert_allclose(part.drive_position.values[-1], whole.drive_position.values[-1], rtol=1e-13)
    assert part.data.sizes["between"] == whole.data.sizes["between"]
