"""Deflections along a motion under loads that act on members: as of linear statics, which shares no step with them."""

import numpy as np
import pytest

import kinetruss as kt


def redundant(load):
    """A cantilever of five bars with one state of self-stress."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "C": (2, 1), "D": (0, 1)},
        fixed={"A": "xy", "D": "xy"},
        bars={"AB": ("A", "B"), "BC": ("B", "C"), "CD": ("C", "D"), "AC": ("A", "C"), "BD": ("B", "D")},
        section=kt.Rod(diameter=0.02),
        material="steel_s235",
        loads={"w": load},
    )


def bridge(load):
    """Two links over an underslung chord whose middle is driven."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (4, 0), "C": (8, 0), "D": (12, 0), "E": (16, 0), "F": (4, -1.5), "G": (12, -1.5)},
        fixed={"A": "xy", "E": "y"},
        links={"left": ("A", "B", "C"), "right": ("C", "D", "E")},
        bars={
            **{f"{one}F": (one, "F") for one in "ABC"},
            **{f"{one}G": (one, "G") for one in "CDE"},
            "chord": kt.Bar(ends=("F", "G"), kind="driven"),
        },
        section=kt.Tube(outer=0.12, inner=0.1),
        material="steel_s355",
        loads={"w": load},
    )


@pytest.mark.parametrize(
    "model",
    [
        redundant(kt.MemberLoad(member="AB", force=(0, -1e3))),
        redundant(kt.MemberLoad(member="AC", force=(300, 200), axes="member")),
        redundant(kt.MemberPointForce(member="CD", force=(0, -2e3), at=0.5)),
        bridge(kt.MemberLoad(member="left", force=(0, -5e3))),
        bridge(kt.MemberPointForce(member="right", force=(0, -5e3), at=2.0)),
    ],
    ids=["along a bar", "in its axes", "at a place", "along a link", "at a place of a link"],
)
def test_deflection_is_that_of_linear_statics(model):
    forces = kt.statics.at_poses(model, [{}])
    found = kt.statics.deflection(model, forces)
    expected = kt.statics.linear(model).displacement.sel(node=list(model.nodes)).values
    assert np.abs(expected).max() > 1e-5
    np.testing.assert_allclose(found.displacement.sel(node=list(model.nodes)).values[0], expected, rtol=1e-9, atol=1e-14)


def test_corrected_lengths_keep_a_link_in_its_place_under_a_load_along_it():
    """To first order the chord takes the deflection over the ratio of C.y to its length, here 4/1.5."""
    model = bridge(kt.MemberLoad(member="left", force=(0, -5e3)))
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"chord": (8.0, 8.0)}, duration=1.0), samples=2)
    forces = kt.dynamics.inverse(model, motion)
    low = kt.statics.deflection(model, forces).displacement.sel(node="C", axis="y").values[0]
    assert low < -1e-3
    assert kt.flexible.corrected(model, forces, at="C.y").change.values[0, 0] == pytest.approx(low * 1.5 / 4, rel=0.02)
