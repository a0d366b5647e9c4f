"""Attitudes in space: platforms arrive, by the shortest turn, whatever the form in which the attitude is given."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kinetruss as kt

ROBOT = kt.library.mechanisms.stewart(turned=(0.1, -0.05, 0.2))
PLATFORM = tuple(f"P{k}" for k in range(1, 7))
NOW = Rotation.from_euler("ZYX", [0.2, -0.05, 0.1])
WANTED = Rotation.from_rotvec([0.15, -0.2, 0.1])
FRAME = kt.Frame(axes=tuple(map(tuple, NOW.as_matrix().T.tolist())))
"""The platform's own axes: they start turned by NOW."""
Z = NOW.as_matrix()[:, 2]
MAST = kt.library.vgt.double_octahedral(bays=6)
TOP = ("B6.N7", "B6.N9", "B6.N8")


def turned(task, samples=21):
    """A motion of the robot and the matrices of its platform's axes (times, 3, 3), by a fit to all nodes."""
    motion = kt.kinematics.inverse(ROBOT, task, samples=samples)
    return motion, kt.kinematics.pose(ROBOT, motion, PLATFORM, frame=FRAME).rotation_matrix.values


def docking(**given):
    return kt.Docking(platform=PLATFORM, frame=FRAME, **given)


def quintic(t):
    return t**3 * (10 - 15 * t + 6 * t**2)


@pytest.mark.parametrize("law", ["quintic", "constant", "trapezoid", "spline"])
def test_a_platform_arrives_by_the_geodesic_from_where_it_starts(law):
    motion, R = turned(docking(attitude=WANTED.as_matrix().tolist(), law=law, moves={"z": 0.62}))
    assert np.abs(R[-1] - WANTED.as_matrix()).max() < 1e-9
    since = (Rotation.from_matrix(R) * NOW.inv()).as_rotvec()
    whole = (WANTED * NOW.inv()).as_rotvec()
    share = since @ whole / (whole @ whole)
    assert np.abs(since - share[:, None] * whole).max() < 1e-9
    if law == "quintic":
        assert share == pytest.approx(quintic(motion.time.values), abs=1e-9)


def test_rates_of_the_geodesic_are_those_of_a_turn_about_a_fixed_axis():
    motion = kt.kinematics.inverse(ROBOT, docking(attitude=WANTED), samples=21)
    found, t = kt.kinematics.pose(ROBOT, motion, PLATFORM, frame=FRAME), motion.time.values
    whole = (WANTED * NOW.inv()).as_rotvec()
    assert found.angular_velocity.values == pytest.approx(np.outer(30 * t**2 * (1 - t) ** 2, whole), abs=1e-9)
    assert found.angular_acceleration.values == pytest.approx(np.outer(60 * t - 180 * t**2 + 120 * t**3, whole), abs=1e-7)


def test_forms_of_one_attitude_are_one_task():
    R = WANTED.as_matrix()
    forms = [
        WANTED.as_rotvec().tolist(), [f"{np.degrees(one)} deg" for one in WANTED.as_rotvec().tolist()],
        WANTED.as_quat(scalar_first=True).tolist(), (-3 * WANTED.as_quat(scalar_first=True)).tolist(), R.round(8), WANTED,
        *({"xyz"[i]: (2 * R[:, i]).tolist(), "xyz"[j]: (R[:, j] + 0.4 * R[:, i]).tolist()}
          for i in range(3) for j in range(3) if i != j),
    ]  # fmt: skip
    tasks = [docking(attitude=form) for form in forms]
    for form, task in zip(forms, tasks, strict=True):
        close = 1e-8 if isinstance(form, np.ndarray) else 1e-14
        assert np.array(task.attitude) == pytest.approx(R, abs=close), form
        A = np.array(task.attitude)
        assert pytest.approx(np.eye(3), abs=1e-14) == A @ A.T
        assert kt.Docking.model_validate_json(task.model_dump_json()) == task
    first, second = (kt.kinematics.inverse(ROBOT, task, samples=5).drive_position.values for task in (tasks[1], tasks[-1]))
    assert first == pytest.approx(second, abs=1e-11)


@pytest.mark.parametrize("task", [docking(attitude=NOW), *(kt.Pointing(platform=PLATFORM, direction=tuple(Z), roll=roll)
                                                           for roll in ("held", "free"))])  # fmt: skip
def test_the_present_attitude_moves_nothing(task):
    motion = kt.kinematics.inverse(ROBOT, task, samples=5)
    assert np.ptp(motion.drive_position.values, axis=0).max() < 1e-12
    assert np.abs(motion.drive_velocity.values).max() < 1e-12


def test_a_frame_at_gimbal_lock_turns_on():
    """Euler angles of the frame say nothing about yaw and roll where its x points up; the shortest turn does not need them."""
    frame = kt.Frame(axes=((0, 0, 1), (0, 1, 0), (-1, 0, 0)))
    robot, up = kt.library.mechanisms.stewart(), Rotation.from_matrix(np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]]).T)
    wanted = WANTED * up
    motion = kt.kinematics.inverse(robot, kt.Docking(platform=PLATFORM, frame=frame, attitude=wanted), samples=11)
    R = kt.kinematics.pose(robot, motion, PLATFORM, frame=frame).rotation_matrix.values
    assert np.abs(R[-1] - wanted.as_matrix()).max() < 1e-9
    since = (Rotation.from_matrix(R) * up.inv()).as_rotvec()
    assert since == pytest.approx(np.outer(quintic(motion.time.values), WANTED.as_rotvec()), abs=1e-9)


@pytest.mark.parametrize("roll", ["free", "held"])
def test_a_direction_is_reached_on_a_great_circle(roll):
    aim = np.array([0.2, 0.1, 1.0])
    motion, R = turned(kt.Pointing(platform=PLATFORM, direction=tuple(aim), roll=roll))
    aim /= np.linalg.norm(aim)
    axis = np.cross(Z, aim)
    whole = np.arcsin(np.linalg.norm(axis))
    axis /= np.linalg.norm(axis)
    at = quintic(motion.time.values) * whole
    assert R[:, :, 2] == pytest.approx(np.outer(np.cos(at), Z) + np.outer(np.sin(at), np.cross(axis, Z)), abs=1e-9)
    since = (Rotation.from_matrix(R) * NOW.inv()).as_rotvec()
    # nothing turns about the normal if the roll is held; left free, the drives of least change turn it
    off = np.abs(since - np.outer(at, axis)).max()
    assert off < 1e-9 if roll == "held" else off > 1e-3


def test_a_mast_turns_its_tip_through_a_right_angle_and_a_line_of_its_own():
    """A quarter turn to a global axis: no choice of Euler angles is in the way."""
    motion = kt.kinematics.inverse(MAST, kt.Pointing(platform=TOP, direction="x"), samples=21)
    normal = kt.kinematics.platform(MAST, motion, TOP).normal.values
    angle = quintic(motion.time.values) * np.pi / 2
    assert normal == pytest.approx(np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1), abs=1e-9)
    motion = kt.kinematics.inverse(MAST, kt.Pointing(line=("B5.N7", "B6.N7"), direction=(0.5, 0.3, 1)), samples=5)
    along = np.subtract(*motion.position.sel(node=["B6.N7", "B5.N7"]).values[-1])
    assert along / np.linalg.norm(along) == pytest.approx(np.array([0.5, 0.3, 1]) / np.linalg.norm([0.5, 0.3, 1]), abs=1e-9)


def test_what_is_out_of_reach_is_measured_as_a_rotation_angle():
    mast, top = kt.library.vgt.double_octahedral(bays=3, limits=("1.0 m", "1.35 m")), ("B3.N7", "B3.N9", "B3.N8")
    wanted = Rotation.from_rotvec(_shortest(np.array([0, 0, 1]), np.array([1, 0, -0.5])))
    for task, whole in (
        (kt.Docking(platform=top, attitude=wanted, free=["x", "y", "z"]), True),
        (kt.Pointing(platform=top, direction=(1, 0, -0.5)), False),
        (kt.Pointing(platform=top, direction=(1, 0, -0.5), roll="held"), True),
    ):
        found = kt.kinematics.reach(mast, task, starts=4)
        assert not found.reached.values[0]
        x = found.position.values
        R = kt.kinematics.pose(mast, kt.kinematics.from_arrays(mast, [0.0], x, 0 * x, 0 * x), top).rotation_matrix.values[0]
        off = (
            Rotation.from_matrix(wanted.as_matrix().T @ R).magnitude()
            if whole
            else np.arccos(wanted.as_matrix()[:, 2] @ R[:, 2])
        )
        assert off > 0.01
        assert found.turn_miss.values == pytest.approx([off], abs=1e-8)
        assert f"an attitude {np.degrees(off):.6g} deg from the one wanted" in str(found.message.values[0])
    found = kt.kinematics.reach(ROBOT, kt.Pointing(platform=PLATFORM, direction=(0.2, 0.1, 1)))
    assert found.turn_miss.values == pytest.approx([0.0], abs=1e-9)
    assert np.isnan(kt.kinematics.reach(ROBOT, kt.Positioning(nodes=PLATFORM, moves={"z": 0.61})).turn_miss.values).all()


def _shortest(a, b):
    axis = np.cross(a, b)
    return axis / np.linalg.norm(axis) * np.arctan2(np.linalg.norm(axis), a @ b)


@pytest.mark.parametrize(
    "task",
    [
        docking(attitude=Rotation.from_rotvec([np.pi, 0, 0]) * NOW),
        kt.Pointing(platform=PLATFORM, direction=tuple(-Z)),
        kt.Pointing(platform=PLATFORM, direction=tuple(-Z), roll="held"),
    ],
)
def test_half_turns_have_no_shortest_way_and_are_refused(task):
    with pytest.raises(kt.InputError, match="half a turn from the start, so there is more than one shortest way"):
        kt.kinematics.inverse(ROBOT, task)


@pytest.mark.parametrize(
    ("attitude", "words"),
    [
        ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], "is a reflection"),
        ([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]], "is no rotation matrix: R.T R differs from the unit matrix by 0.1"),
        ([[0, 0, 0], [0, 1, 0], [0, 0, 1]], "is no rotation matrix"),
        ([0, 0, 0, 0], "the quaternion is 0"),
        ({"x": [0, 0, 0], "z": [0, 0, 1]}, "x points nowhere"),
        ({"x": [0, 0, 2], "z": [0, 0, -1]}, "along one line"),
        ({"x": [0, 0, 1]}, "does not say where two axes point"),
        ({"x": [1, 0, 0], "w": [0, 0, 1]}, "does not say where two axes point"),
        ([[1, 0, 0], [0, 1, 0]], "is no attitude"),
        ([[1, 0, 0], [0, 1], [0, 0, 1]], "are not 3 numbers"),
        ([[1, 0, 0], 0, 0], "are not 3 numbers"),
        ("up", "is no attitude"),
        (["1 m", 0, 0], "m"),
        ([float("nan"), 0, 0], "finite"),
    ],
)
def test_what_is_no_attitude_is_refused_with_words(attitude, words):
    with pytest.raises(kt.ModelError, match=words):
        docking(attitude=attitude)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: docking(attitude=[0, 0, 0.1], moves={"yaw": 0.1}), "has an attitude, and 'yaw' is named too"),
        (lambda: docking(attitude=[0, 0, 0.1], free=["roll"]), "has an attitude, and 'roll' is named too"),
        (lambda: kt.Pointing(platform=PLATFORM, direction=(0, 0, 0)), "is no direction"),
        (lambda: kt.Pointing(platform=PLATFORM, direction="z", at=(0, 0, 9)), "has a direction and a place"),
        (lambda: kt.Pointing(platform=PLATFORM, direction="z", moves={"beta": 0.1}), "turns to a direction, and 'beta'"),
        (lambda: kt.Pointing(platform=PLATFORM, roll="held"), "holds its roll"),
        (lambda: kt.Pointing(line=("P1", "P2"), direction="z", roll="held"), "Give platform and direction"),
    ],
)
def test_what_contradicts_an_attitude_is_refused(make, words):
    with pytest.raises(kt.ModelError, match=words):
        make()


def test_a_plane_has_no_attitude_in_space():
    model = kt.library.vgt.triangular()
    with pytest.raises(kt.ModelError, match="is one in space; the model is planar. Move yaw"):
        kt.kinematics.inverse(model, kt.Docking(platform=("B", "C"), attitude=[0, 0, 0.1]))
