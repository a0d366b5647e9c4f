"""A pose is right or refused: whatever base, longeron, order of drives or bay it is given for."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt

ACTIVE = ("M7", "M9", "M11")
SIDES = st.floats(-0.05, 0.05) | st.sampled_from([0.0, 1e-9, 1e-7, -8e-7, 9e-7, 3e-6])


def reached(model, key, value):
    """What a bay asked for one pose coordinate gets, measured from its nodes."""
    start = kt.kinematics.assemble(model)
    still = np.zeros((1, *start.shape))
    stand = kt.kinematics.from_arrays(model, [0.0], start[None], still, still)
    begin = float(kt.kinematics.platform(model, stand, ("N7", "N9", "N8"), base=("N1", "N2", "N3"))[key][0])
    motion = kt.kinematics.follow(model, kt.Quintic(moves={f"bay.{key}": (begin, value)}, duration=1.0), samples=3)
    return float(kt.kinematics.platform(model, motion, ("N7", "N9", "N8"), base=("N1", "N2", "N3"))[key][-1])


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(
    SIDES, SIDES, SIDES, SIDES, st.permutations(ACTIVE), st.sampled_from(["M1", "M6", "M13", "M18", "M19"]),
    st.sampled_from([("beta", 0.2), ("gamma", -0.15), ("height", 1.05)]),
)  # fmt: skip
def test_asked_is_got_or_refused(base, longeron, other_base, bar_change, drives, bar, asked):
    model = kt.library.vgt.double_octahedral(base=1.2192 + base, longeron=0.889 + longeron)
    ends = [np.array(model.nodes[end].at) for end in model.members[bar].ends]
    bars = dict(model.bars) | {bar: model.bars[bar].with_(length=float(np.linalg.norm(ends[1] - ends[0])) + bar_change)}
    pose = kt.GimbalPose(base=1.2192 + other_base, longeron=0.889, drives=tuple(drives))
    model = model.with_(bars=bars, poses={"bay": pose})
    off = max(abs(base - other_base), abs(longeron), abs(bar_change))  # about 1e-6 m, both answers are right
    in_order = tuple(drives) == ACTIVE
    try:
        got = reached(model, *asked)
    except kt.InputError as error:
        assert not (in_order and off < 1e-8) and "poses.bay" in str(error)
    else:
        assert in_order and off < 2e-6 and got == pytest.approx(asked[1], abs=1e-6 if off < 1e-8 else 1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("drives", [one for one in itertools.permutations(ACTIVE) if one != ACTIVE])
@pytest.mark.parametrize("bay", [1, 2, 3])
def test_drives_in_another_order_are_named_in_the_right_one(bay, drives):
    model = kt.library.vgt.double_octahedral(3)
    named = tuple(f"B{bay}.{one}" for one in drives)
    model = model.with_(poses=dict(model.poses) | {f"B{bay}": model.poses[f"B{bay}"].with_(drives=named)})
    with pytest.raises(kt.ModelError, match=rf"poses.B{bay}.drives.*Write drives: \[B{bay}.M7, B{bay}.M9, B{bay}.M11\]"):
        kt.kinematics.follow(model, kt.Quintic(moves={f"B{bay}.beta": (0, 0.1)}, duration=1.0), samples=2)


@pytest.mark.parametrize(
    ("drives", "message"),
    [
        (("M7", "M7", "M9"), "names a drive twice"),
        (("B1.M7", "B1.M9", "B2.M11"), "do not form a triangle"),
    ],
)
def test_drives_of_no_bay(drives, message):
    model = kt.library.vgt.double_octahedral(2 if drives[0].startswith("B") else 1)
    pose = kt.GimbalPose(base=1.2192, longeron=0.889, drives=drives)
    with pytest.raises(kt.ModelError, match=message):
        kt.kinematics.follow(model.with_(poses={"bay": pose}), kt.Quintic(moves={"bay.beta": (0, 0.1)}, duration=1), samples=2)


def test_a_pose_of_legs_and_of_an_angle():
    robot = kt.library.mechanisms.stewart()
    pose = kt.GimbalPose(base=1.0, longeron=1.0, drives=tuple(robot.all_drives)[:3])
    with pytest.raises(kt.ModelError, match="poses.bay.drives"):
        kt.kinematics.jacobian(robot.with_(poses={"bay": pose}), of="bay.beta")
    bay = kt.library.vgt.double_octahedral()
    turned = bay.with_(drives={"push": kt.CoordinateDrive(node="N8", axis="x")})
    with pytest.raises(kt.ModelError, match="'push' does not drive the length"):
        pose = bay.poses["bay"].with_(drives=("M7", "M9", "push"))
        kt.kinematics.jacobian(turned.with_(poses={"bay": pose}), of="bay.beta", wrt="M7")


def test_a_bay_that_is_not_upright():
    """Folded inwards: the lengths are the same, the pose is another."""
    model = kt.library.vgt.double_octahedral(base=1.2192, longeron=0.7, active_length=0.9)
    at = {name: np.array(node.at) for name, node in model.nodes.items()}
    flipped = {
        name: kt.Node(at=tuple(x * (1, 1, -1))) if name in ("N7", "N8", "N9") else kt.Node(at=tuple(x))
        for name, x in at.items()
    }
    mirrored = {name: kt.Node(at=tuple(x * (1, 1, -1))) for name, x in at.items()}
    hanging = model.with_(nodes=mirrored)
    with pytest.raises(kt.ModelError, match="poses.bay"):
        kt.kinematics.follow(hanging, kt.Quintic(moves={"bay.beta": (0, 0.1)}, duration=1), samples=2)
    with pytest.raises(kt.InputError):
        kt.kinematics.follow(model.with_(nodes=flipped), kt.Quintic(moves={"bay.beta": (0, 0.1)}, duration=1), samples=2)


def test_supports_that_spread_end_the_motion_in_pose():
    """The base grows in the run: the closed form no longer is the bay's, and the motion ends before it is wrong."""
    t = np.linspace(0.0, 1.0, 11)
    spread = kt.History(times=t, displacements=np.stack([0.02 * t**3, 0 * t, 0 * t], axis=1))
    model = kt.library.vgt.double_octahedral().with_(support_motion={"N2": spread})
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(0, 0.1)), samples=11, raise_on_failure=False)
    assert motion.status is kt.Status.NOT_CONVERGED and "stands at beta" in motion.message
    seen = kt.kinematics.platform(model, motion, ("N7", "N9", "N8"), base=("N1", "N2", "N3"))
    law = kt.kinematics.sample(model, kt.library.vgt.slew(beta=(0, 0.1)), motion.position.time.values).poses["bay"]
    np.testing.assert_allclose(seen.beta, law[:, 0], atol=1e-5)
