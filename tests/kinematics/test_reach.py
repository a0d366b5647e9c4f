"""What cannot be reached, what starts in a singular position, targets that fix too little or hold too much: said as such."""

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.kinematics import follow, inverse


def apex(height):
    """Two bars from a base of 2 m; the left one is driven."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (1, height)}, fixed=["A", "B"],
        bars={"a": kt.Bar(ends=("A", "C"), kind="driven"), "b": ("B", "C")},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("height", [0.3, 0.05, 1e-3, -0.4])
@pytest.mark.parametrize("samples", [3, 11, 200])
def test_out_of_reach_says_how_far_it_goes(height, samples):
    own = math.hypot(1, height)
    nearest = 2 + own
    motion = follow(
        apex(height), kt.Quintic(moves={"a": (own, nearest + 0.5)}, duration=1.0), samples=samples, raise_on_failure=False
    )
    assert motion.status is kt.Status.OUT_OF_REACH and not motion.status.ok
    assert f"the nearest possible then is a {nearest:.6g} m of" in motion.message
    assert motion.length.sel(member="a").values.max() < nearest


@pytest.mark.parametrize("height", [1e-7, 1e-8, 3e-7])
def test_a_start_in_a_singular_position_is_called_so(height):
    own = math.hypot(1, height)
    motion = follow(apex(height), kt.Quintic(moves={"a": (own, own + 0.1)}, duration=1.0), samples=5, raise_on_failure=False)
    assert motion.status is kt.Status.SINGULAR and "starts (t = 0 s) in a singular position" in motion.message
    assert motion.sizes["time"] == 0 if hasattr(motion, "sizes") else motion.data.sizes["time"] == 0


def test_a_drive_of_a_rigid_structure_is_not_called_singular():
    rigid = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (1, 1), "D": (1, 0)}, fixed=["A", "D"],
        bars={"ab": ("A", "B"), "bc": ("B", "C"), "cd": ("C", "D"), "diagonal": ("A", "C")},
        drives={"turn": kt.AngleDrive("ab")},
    )  # fmt: skip
    with pytest.raises(InputError, match="The drives contradict each other: 'angle of ab' is fixed by the others"):
        follow(rigid, kt.Quintic(moves={"turn": ("90 deg", "100 deg")}, duration=1.0), samples=5)


def still(**moves):
    return kt.Quintic(moves={name: (0.0, value) for name, value in moves.items()}, duration=1.0)


def test_targets_of_a_platform_hold_what_is_not_named():
    bay = kt.library.vgt.double_octahedral()
    with pytest.raises(InputError, match=r"cannot .* from where it stands|roll, pitch, yaw, which are not named, stay"):
        inverse(bay, still(x=0.02, y=0.0, z=0.01), platform=("N7", "N9", "N8"), samples=5)


@pytest.mark.slow
def test_too_few_targets_are_counted_and_not_listed():
    tower = kt.library.vgt.double_octahedral(6)
    top = [name for name in tower.nodes if name.startswith("B6.")][-3:] or list(tower.nodes)[-3:]
    with pytest.raises(InputError, match=r"The targets fix 6 of the 18 freedoms|cannot yaw") as caught:
        inverse(tower, still(x=0.02, y=0.0, z=0.01, roll=0.0, pitch=0.0, yaw=0.01), platform=top, samples=5)
    assert len(str(caught.value)) < 400


def test_what_a_platform_cannot_do_to_first_order_is_named():
    two = kt.library.vgt.double_octahedral(2)
    top = list(two.nodes)[-3:]
    with pytest.raises(InputError, match=r"To first order the platform cannot .*yaw.* stands: its drives give it 5 of"):
        inverse(two, still(x=0.0, y=0.0, z=0.01, roll=0.0, pitch=0.0, yaw=0.01), platform=top, samples=5)


@pytest.mark.slow
def test_wanted_node_motions_count_turns_as_others_do():
    """A node led on a circle about a pivot by two drives: the angle of its bar counts on with 3 samples as with 300."""
    arms = kt.Model(
        nodes={"O": (0, 0), "E": (0.6, 0.8), "T": (1.2, 0.0)}, fixed=["O"], bars={"upper": ("O", "E"), "fore": ("E", "T")},
        drives={"shoulder": kt.AngleDrive("upper"), "elbow": kt.AngleDrive("fore")},
    )  # fmt: skip
    t = np.linspace(0.0, 6.0, 601)
    values = {"T.x": tuple(1.2 * np.cos(1.5 * t)), "T.y": tuple(1.2 * np.sin(1.5 * t))}
    circle = kt.Spline(times=tuple(t), values=values)
    for samples in (2, 5, 301):
        motion = inverse(arms, circle, samples=samples)
        start, end = motion.drive_position.values[[0, -1], 0]
        assert end - start == pytest.approx(9.0, abs=1e-3)
