"""Degrees of freedom along a motion: they carry it exactly, and change where they would degenerate."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError
from kinetruss.library import mechanisms
from kinetruss.mechanics import compile


def crank(turns=2.0, samples=201):
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.4, 0), "C": (2, 1.5), "D": (2.5, 0)}, fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}, drives={"w": kt.AngleDrive("crank")},
    )  # fmt: skip
    turn = kt.ConstantRate(rates={"w": 2 * np.pi * turns}, duration=1.0)
    return model, kt.kinematics.follow(model, turn, samples=samples)


@pytest.mark.slow
def test_chosen_coordinates_carry_the_motion():
    model, motion = crank()
    found = kt.kinematics.freedoms(model, motion)
    assert len(found.attrs["sets"]) > 4  # no node coordinate serves for a whole turn
    assert found.grip.values.min() > 0.1
    for i in range(0, 201, 23):
        at = motion.data["position"].values[i]
        F = kt.kinematics.transfer_functions(model, [str(found.chosen.values[i, 0])], at, free=["w"])["first"].values[..., 0]
        assert np.abs(F * found.rate.values[i, 0] - motion.data["velocity"].values[i]).max() < 1e-11
        node, axis = str(found.chosen.values[i, 0]).split(".")
        assert found.value.values[i, 0] == motion.data["position"].sel(node=node, axis=axis).values[i]


@pytest.mark.slow
def test_a_hinge_drive_has_the_value_of_its_angle():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (2, 0), "F": (0, 1)}, fixed=["A", "F"], bars={"b": ("A", "B")},
        drives={"w": kt.HingeDrive(axis="A", start="F", end="B")},
    )  # fmt: skip
    turn = kt.kinematics.follow(model, kt.ConstantRate(rates={"w": 1.0}, duration=1.0), samples=3)
    found = kt.kinematics.freedoms(model, turn, among="w")
    np.testing.assert_allclose(found.value.values[:, 0], -np.pi / 2 + np.array([0.0, 0.5, 1.0]), atol=1e-12)
    np.testing.assert_allclose(found.rate.values[:, 0], 1.0, atol=1e-12)


@pytest.mark.slow
def test_an_angle_serves_for_the_whole_turn_and_a_given_set_is_kept_while_it_grips():
    model, motion = crank()
    whole = kt.kinematics.freedoms(model, motion, ["crank.angle"])
    assert whole.attrs["sets"] == ["crank.angle"]
    assert np.abs(whole.rate.values - 4 * np.pi).max() < 1e-11
    two = kt.kinematics.freedoms(model, motion, ["B"], first="B.y")
    assert two.chosen.values[0, 0] == "B.y"
    assert set(np.unique(two.chosen.values)) == {"B.x", "B.y"}
    share = np.abs(two.grip.values)
    assert share.min() > 0.2 * 0.5


def test_lengths_and_nodes_mix():
    bay = kt.library.vgt.double_octahedral()
    start = dict(zip(bay.active, compile(bay).drive_start, strict=True))
    lengths = {name: (length, length + 0.02) for name, length in start.items()}
    motion = kt.kinematics.follow(bay, kt.Quintic(moves=lengths, duration=1.0), samples=5)
    found = kt.kinematics.freedoms(bay, motion, [*bay.active, "N7.z"])
    assert found.sizes["dof"] == 3
    for i in range(5):
        for k in range(3):
            name = str(found.chosen.values[i, k])
            wanted = (
                motion.data["velocity"].sel(node="N7", axis="z").values[i]
                if name == "N7.z"
                else motion.data["length_rate"].sel(member=name).values[i]
            )
            assert abs(found.rate.values[i, k] - wanted) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"least": 0}, "between 0 and 1"),
        ({"among": ["B.x"], "first": "B.y"}, "not among"),
        ({"among": ["A.x"]}, "support"),
        ({"among": ["crank"]}, "rigid"),
        ({"held": ["w"]}, "Nothing can move"),
        ({"held": ["v"]}, "No drive called 'v'"),
        ({"among": ["B.x"]}, "do not fix the configuration at t = 0 s"),
        ({"first": ["B.y", "C.x"]}, "names 2 coordinates"),
    ],
)
def test_what_cannot_serve_is_told(options, words):
    model, motion = crank(samples=3)
    with pytest.raises(InputError, match=words):
        kt.kinematics.freedoms(model, motion, **options)


@pytest.mark.slow
def test_andrews_crank_needs_both_coordinates():
    model = mechanisms.andrews()
    found = kt.dynamics.simulate(model, 0.03, tasks={"motor": kt.GivenForce(torque=0.033)}, samples=301)
    chosen = kt.kinematics.freedoms(model, found.motion, ["F"])
    assert set(np.unique(chosen.chosen.values)) == {"F.x", "F.y"}
    assert len(chosen.attrs["sets"]) >= 9  # 2.5 turns, four changes each
