"""Rods of active members that are longer than their member: refused at the start, said along a motion."""

import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(st.sampled_from(["base_length", "tube_length"]), st.floats(0.2, 2.0), st.floats(0.9, 1.3))
def test_a_rod_longer_than_its_member_is_no_model(side, rod, active):
    name = f"active.M7.{side.partition('_')[0]}.length"
    try:
        kt.library.vgt.double_octahedral(**{side: rod}, active_length=active)
    except kt.ModelError as error:
        assert rod > active and name in str(error) and "longer than the member" in str(error)
    else:
        assert rod <= active


def test_limits_count():
    with pytest.raises(kt.ModelError, match="active.M7.base.length: 0.7 m is longer than the member, 0.6 m at the least"):
        kt.library.vgt.double_octahedral(limits=(0.6, 1.5))


@pytest.mark.parametrize("side", ["base", "tube"])
def test_a_stroke_that_is_too_short_is_said(side):
    jack = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0, 1), mass=1)}, fixed={"A": "xy", "B": "x"}, gravity=(0, -9.81),
        active={"jack": kt.Active(ends=("A", "B"), base=kt.Part(length=0.5, mass=1), tube=kt.Part(length=0.5, mass=1))},
    )  # fmt: skip
    jack = jack.with_(active={"jack": jack.active["jack"].with_(**{side: kt.Part(length=0.8, mass=1)})})
    move = kt.Quintic(moves={"jack": (1.0, 0.75)}, duration=1)
    motion = kt.kinematics.follow(jack, move, samples=11)
    said = f"jack shortens to 0.75 m (t = 1 s), less than its {side} rod of 0.8 m"
    assert said in motion.message and said in kt.dynamics.inverse(jack, motion).message
    assert said in kt.dynamics.simulate(jack, 1.0, trajectory=move, samples=3).message
    assert kt.kinematics.follow(jack, kt.Quintic(moves={"jack": (1.0, 0.8)}, duration=1), samples=11).message == ""
