"""The prepared form of a model gives what the plain calls give, to the last bit."""

import numpy as np
import pytest

import kinetruss as kt

PLATFORM = ("P1", "P2", "P3", "P4", "P5", "P6")
FORCES = ("member_force", "end_force", "joint_force", "reaction", "drive_force")


def four_bar():
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)},
        fixed=("A", "D"),
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        section=kt.Rectangle(width=0.020, height=0.005),
        material=kt.library.materials.STEEL_S235,
        drives={"motor": kt.AngleDrive("crank")},
        gravity=(0, -9.81),
        loads={"push": kt.NodalForce(node="C", force=(30.0, -5.0))},
        load_cases={"pushed": kt.LoadCase(loads={"push": 2.0})},
    )


def bay():
    model = kt.library.vgt.double_octahedral(bays=1)
    return model, kt.Quintic(moves={"M7": (1.1684, 1.25), "M9": (1.1684, 1.2)}, duration=1.0)


def same_places(places, motion, dim):
    for name in ("position", "velocity", "acceleration"):
        np.testing.assert_array_equal(getattr(places, name)[..., :dim], motion.data[name].values)
    for name in ("drive_position", "drive_velocity", "drive_acceleration", "singularity"):
        np.testing.assert_array_equal(getattr(places, name), motion.data[name].values)
    np.testing.assert_array_equal(places.t, motion.data["time"].values)
    assert (places.status, places.message) == (motion.status, motion.message)


def same_forces(carried, forces, dim):
    for name in FORCES:
        found = getattr(carried, name)
        np.testing.assert_array_equal(
            found[..., :dim] if name in ("joint_force", "reaction") else found, forces.data[name].values
        )


@pytest.mark.slow
@pytest.mark.parametrize("case", [None, "pushed"])
def test_many_turns_of_a_four_bar(case):
    model = four_bar()
    ready = kt.prepare(model, case)
    for rate in (2.0, -10.0, 310.0):  # the last goes through instants in between
        turn = kt.ConstantRate(rates={"motor": rate}, duration=0.6283)
        motion, places = kt.kinematics.follow(model, turn), ready.follow(turn)
        same_places(places, motion, 2)
        forces = kt.dynamics.inverse(model, motion, case)
        same_forces(ready.forces(places), forces, 2)
        same_forces(ready.forces(places, static=True), forces.static, 2)


def test_a_bay_with_active_members():
    model, trajectory = bay()
    ready = kt.prepare(model)
    places = ready.follow(trajectory, samples=51)
    motion = kt.kinematics.follow(model, trajectory, samples=51)
    same_places(places, motion, 3)
    same_forces(ready.forces(places), kt.dynamics.inverse(model, motion), 3)


def test_a_pose_out_of_reach_ends_both_alike():
    model = kt.library.vgt.double_octahedral(bays=1)
    name = next(iter(model.poses))
    tilt = kt.Quintic(moves={f"{name}.beta": (0.0, 2.5)}, duration=1.0)
    motion = kt.kinematics.follow(model, tilt, raise_on_failure=False)
    assert not motion.status.ok
    same_places(kt.prepare(model).follow(tilt), motion, 3)


@pytest.mark.slow
def test_a_platform_along_a_path():
    lift = kt.library.mechanisms.stewart(platform_mass=12.0)
    ready = kt.prepare(lift)
    for height in (0.05, 0.1):
        up = kt.Quintic(moves={"z": (0.0, height)}, duration=1.0)
        motion, places = kt.kinematics.inverse(lift, up, platform=PLATFORM), ready.inverse(up, platform=PLATFORM)
        same_places(places, motion, 3)
        same_forces(ready.forces(places), kt.dynamics.inverse(lift, motion), 3)


@pytest.mark.slow
def test_drives_given_as_arrays():
    model = four_bar()
    ready = kt.prepare(model)
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 10.0}, duration=0.5))
    laws = [motion.data[f"drive_{name}"].values for name in ("position", "velocity", "acceleration")]
    same_places(ready.along(motion.data["time"].values, *laws), motion, 2)
    with pytest.raises(kt.InputError, match=r"value has shape \(201, 2\)\. Give \(201, 1\)"):
        ready.along(motion.data["time"].values, np.hstack([laws[0]] * 2), laws[1], laws[2])
    with pytest.raises(kt.InputError, match="turns by more than 0.8 rad between two of the 5 samples"):
        ready.along(motion.data["time"].values[::50], *(law[::50] for law in laws))


def test_redundant_members_are_told():
    corners = {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}
    square = {"AB": "AB", "BC": "BC", "CD": "CD", "DA": "DA", "AC": "AC", "BD": "BD"}
    frame = kt.Model(
        nodes=corners,
        fixed={"A": "xy", "B": "y"},
        bars={name: kt.Bar(ends=tuple(ends), kind="driven" if name == "AB" else "rigid") for name, ends in square.items()},
        loads={"push": kt.NodalForce(node="C", force=(1.0, 0.0))},
    )
    rest = kt.ConstantRate(rates={"AB": 0.0}, duration=1.0)
    forces = kt.dynamics.inverse(frame, kt.kinematics.follow(frame, rest, samples=3))
    ready = kt.prepare(frame)
    carried = ready.forces(ready.follow(rest, samples=3))
    same_forces(carried, forces, 2)
    named = [name for name, unsure in zip(frame.members, carried.not_unique, strict=True) if unsure]
    assert named == forces.data.attrs["not_unique"]
    assert carried.not_unique.any()


def test_a_load_case_that_is_not_there():
    with pytest.raises(kt.InputError, match="No load case called 'none'"):
        kt.prepare(four_bar(), "none")
