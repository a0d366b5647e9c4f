"""Blocks on lines in space: the two offsets of a node from a line, against the same mechanism in the plane."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

TURNED = np.linalg.qr([[0.6, -0.3, 0.5], [0.2, 0.9, -0.4], [-0.7, 0.1, 0.8]])[0]
"""Rows: directions in space of x and y of the plane, and of its normal."""
TURNED[2] = np.cross(TURNED[0], TURNED[1])


def quick_return(dim: int) -> kt.Model:
    """Whitworth's mechanism: the crank, longer than the distance of its pivot from that of the arm, turns the arm fully."""

    def at(x: float, y: float) -> tuple[float, ...]:
        return (x, y) if dim == 2 else tuple((x * TURNED[0] + y * TURNED[1]).tolist())

    axis = tuple(TURNED[2].tolist())

    def offset(**way: object) -> kt.Coupling:
        return kt.Coupling(terms=((kt.OffsetCoordinate(line=("O", "T"), point="P", **way), 1.0),), value=0.0)

    flat = {"T": kt.Support(along=axis, x="held")} if dim == 3 else {}
    return kt.Model(
        nodes={
            "O": at(0, 0), "C": at(0, 0.1), "P": kt.Node(at=at(0.3, 0.1), mass=0.5), "T": kt.Node(at=at(0.6, 0.2), mass=2.0),
        }, fixed=("O", "C"), supports=flat, bars={"crank": ("C", "P"), "arm": ("O", "T")}, gravity=at(0, -9.81),
        couplings={"block": offset()} if dim == 2 else {"block": offset(axis=axis), "block.along": offset(along=axis)},
        drives={"motor": kt.AngleDrive("crank", **({} if dim == 2 else {"axis": axis, "reference": at(1, 0)}))},
    )  # fmt: skip


def test_a_block_on_an_arm_that_turns_fully_moves_and_loads_as_in_the_plane():
    found = []
    for dim in (2, 3):
        model = quick_return(dim)
        assert kt.kinematics.mobility(model).degrees_of_freedom == 1
        motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": (0.0, 2 * np.pi)}, duration=2.0), samples=41)
        found.append((motion.position.values, kt.dynamics.inverse(model, motion).drive_force.values))
    (flat, torque), (space, other) = found
    np.testing.assert_allclose(space, flat @ TURNED[:2], atol=1e-12)
    np.testing.assert_allclose(other, torque, atol=1e-10 * np.abs(torque).max())


def test_the_force_on_the_line_is_that_of_the_lever():
    forces = kt.statics.at_poses(quick_return(3), [{}])
    lever = kt.statics.at_poses(quick_return(2), [{}]).drive_force.values
    # the weight of T at 0.6 m turns the arm; the block at sqrt(0.1) m of it presses square to it on the crank, 0.3 m long
    press = 2.0 * 9.81 * 0.6 / np.hypot(0.3, 0.1)
    assert lever == pytest.approx(press * np.cos(np.arctan2(0.1, 0.3)) * 0.3 + 0.5 * 9.81 * 0.3)
    np.testing.assert_allclose(forces.drive_force.values, lever, rtol=1e-10)


@pytest.mark.parametrize(
    ("way", "words"),
    [
        ({}, "Give axis or along"),
        ({"axis": "x", "along": "x"}, "Give axis or along"),
        ({"axis": (3.0, 1.0, 0.0)}, "points along its direction"),
        ({"axis": "z"}, "with value: 0"),
    ],
)
def test_an_offset_in_space_has_one_direction_across_its_line(way, words):
    nodes = {"A": (0, 0, 0), "B": (3, 1, 0), "C": (1, 1, 1)}
    with pytest.raises(kt.ModelError, match=words):
        kt.Model(
            nodes=nodes, bars={"b": ("A", "C")},
            couplings={"block": kt.Coupling(terms=((kt.OffsetCoordinate(line=("A", "B"), point="C", **way), 1.0),))},
        )  # fmt: skip


def test_an_offset_in_the_plane_has_no_direction():
    with pytest.raises(kt.ModelError, match="Leave out axis and along"):
        kt.Model(
            nodes={"A": (0, 0), "B": (3, 1), "C": (1, 1)}, bars={"b": ("A", "C")},
            couplings={"b1": kt.Coupling(terms=((kt.OffsetCoordinate(line=("A", "B"), point="C", axis="z"), 1.0),))},
        )  # fmt: skip
