"""Robots and platforms of the library: the counts of their papers, ranks, places in closed form."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import ModelError
from kinetruss.library import mechanisms

PLACE = st.tuples(st.floats(-0.2, 0.2), st.floats(-0.2, 0.2), st.floats(-0.9, -0.6))


def counts(model: kt.Model) -> tuple[int, ...]:
    """Bars, coordinates, fixed, rank, freedoms before drives."""
    found = kt.kinematics.mobility(model)
    return len(model.bars), found.coordinates, found.fixed, found.rank, found.degrees_of_freedom


def place(model: kt.Model, name: str) -> np.ndarray:
    return np.array(model.nodes[name].at)


def lengths(model: kt.Model) -> dict[str, float]:
    return {name: math.dist(*(model.nodes[end].at for end in bar.ends)) for name, bar in model.bars.items()}


def test_counts_of_the_paper():
    assert counts(mechanisms.delta()) == (45, 66, 18, 45, 3)
    assert counts(mechanisms.robot()) == (53, 63, 7, 51, 5)


def test_conventional_models_have_the_coordinates_and_fall_as_the_bars():
    """Rotations as coordinates: a start with speed, drives free or pushed, places of the nodes that both models have."""
    rates, push = (-0.3, 0.8, 0.5, 0.2, -1.0), {"lift": kt.GivenForce(3550.0), "wrist": kt.GivenForce(torque=78.0)}
    free = {"delta": {}, "robot": {"rates": rates}}
    for name, places, rotations in (("delta", 19, 7), ("robot", 11, 5)):
        bars, beams = (getattr(mechanisms, name)(form=form, **free[name]) for form in ("bars", "conventional"))
        found = kt.kinematics.mobility(beams)
        assert (len(beams.nodes), found.coordinates) == (places, 3 * places + 3 * rotations)
        assert (found.degrees_of_freedom, found.undriven, found.self_stress) == (len(beams.all_drives), 0, 0)
        tasks = dict.fromkeys(beams.all_drives, kt.Free()) | (push if name == "robot" else {})
        method = kt.DOP853(rtol=1e-11, atol=1e-13)
        runs = [kt.dynamics.simulate(model, 0.1, samples=3, tasks=tasks, method=method).motion for model in (bars, beams)]
        common = [node for node in bars.nodes if node in beams.nodes]
        one, other = (run.position.sel(node=common).values for run in runs)
        assert np.abs(one[-1] - one[0]).max() > 0.04
        assert np.abs(other - one).max() < 1e-9


@pytest.mark.slow
@given(at=PLACE)
@settings(max_examples=20)
def test_delta_keeps_its_bars_wherever_the_platform_stands(at):
    there, home = lengths(mechanisms.delta(at=at)), lengths(mechanisms.delta())
    assert there == pytest.approx(home, rel=1e-12)


def test_delta_arms_make_the_angles_of_the_closed_form():
    model = mechanisms.delta(at=(0.05, -0.08, -0.75))
    found = []
    for k in (1, 2, 3):
        arm = place(model, f"B{k}a") - place(model, f"A{k}a")
        found.append(math.atan2(-arm[2], math.hypot(*arm[:2])))
    # own closed form, 2 L (a cos t - z sin t) = d^2 + L^2 - l^2, computed apart from the library
    assert found == pytest.approx([0.2032907176392995, 0.44966326347074936, 0.21341826311254275], rel=1e-12)


def test_three_long_diagonals_leave_the_platform_of_the_delta_loose():
    model = mechanisms.delta()
    short = ("P1a-P2a", "P2a-P3a", "P3a-P1a")
    bars = {name: bar for name, bar in model.bars.items() if name not in short}
    long = {f"{a}-{b}": kt.Bar(ends=(a, b)) for a, b in (("P1a", "P2b"), ("P1b", "P3a"), ("P2a", "P3b"))}
    loose = kt.kinematics.mobility(model.with_(bars=bars | long))
    assert (loose.bars, loose.rank, loose.self_stress) == (45, 44, 1)


def test_delta_out_of_reach():
    with pytest.raises(ModelError, match=r"arm 1 does not reach .* Move the platform nearer"):
        mechanisms.delta(at=(0, 0, -1.5))


POSE = st.tuples(st.floats(1, 2), st.floats(-3, 3), st.floats(-3, 3), st.floats(0.3, 1.8), st.floats(-3, 3))


@pytest.mark.slow
@given(pose=POSE, rates=st.tuples(*[st.floats(-2, 2)] * 5))
@settings(max_examples=20)
def test_robot_keeps_its_rigid_bars_and_their_rates(pose, rates):
    lift, swing, shoulder, reach, wrist = pose
    model = mechanisms.robot(lift=lift, swing=swing, shoulder=shoulder, reach=reach, wrist=wrist, rates=rates)
    home, here = lengths(mechanisms.robot()), lengths(model)
    speed = {name: np.array(model.velocities.get(name, (0, 0, 0))) for name in model.nodes}
    for name, bar in model.bars.items():
        a, b = bar.ends
        rate = (place(model, b) - place(model, a)) @ (speed[b] - speed[a]) / here[name]
        if bar.kind == "rigid":
            assert here[name] == pytest.approx(home[name], rel=1e-12)
            assert rate == pytest.approx(0, abs=1e-12)
        else:
            assert rate == pytest.approx(rates[0] if name == "A-B" else rates[3], abs=1e-12)


def test_robot_reach_beyond_the_plates():
    with pytest.raises(ModelError, match=r"2.3 m is beyond the plates. Stay below 2.2 m."):
        mechanisms.robot(reach=2.3)


@pytest.mark.parametrize(("kind", "bars", "nodes"), [("6-6", 21, 13), ("6-3", 9, 9), ("3-3", 9, 6)])
def test_stewart(kind, bars, nodes):
    model = mechanisms.stewart(kind=kind)
    found = kt.kinematics.mobility(model)
    assert (len(model.bars), len(model.nodes), found.degrees_of_freedom, found.undriven, found.self_stress) == (
        bars,
        nodes,
        6,
        0,
        0,
    )


@pytest.mark.parametrize("count", [3, 4, 5, 6])
def test_stewart_of_any_geometry(count):
    rng = np.random.default_rng(count)
    base, body = rng.normal(size=(6, 3)), rng.normal(size=(count, 3))[[0, 1, 2, *range(3, count), *range(6 - count)]] * 0.5
    found = kt.kinematics.mobility(mechanisms.stewart(base_points=base, platform_points=body, at=(0, 0, 3)))
    assert (found.degrees_of_freedom, found.undriven, found.self_stress) == (6, 0, 0)


def test_stewart_legs_in_closed_form():
    at, turned = (0.05, -0.02, 0.7), (0.1, -0.2, 0.3)
    cr, sr, cp, sp, cy, sy = (f(a) for a in turned for f in (math.cos, math.sin))
    R = np.array([
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ])  # fmt: skip
    home, there = mechanisms.stewart(at=(0, 0, 0.6)), mechanisms.stewart(at=at, turned=turned)
    for leg in [f"leg{k}" for k in range(1, 7)]:
        foot, head = home.bars[leg].ends
        wanted = np.linalg.norm(np.array(at) + R @ (place(home, head) - (0, 0, 0.6)) - place(home, foot))
        assert lengths(there)[leg] == pytest.approx(wanted, rel=1e-13)


def test_similar_hexagons_face_to_face_are_singular():
    model = mechanisms.stewart(base_spread=math.pi / 3, platform_spread=math.pi / 3)
    turned = kt.kinematics.mobility(model)
    assert turned.undriven > 0


def test_stewart_points_on_a_line():
    line = [(k, 0, 0) for k in range(6)]
    with pytest.raises(ModelError, match="on one line. Give three at least that do not"):
        mechanisms.stewart(platform_points=line)


def test_delta_is_driven_by_its_arms():
    model = mechanisms.delta()
    assert kt.kinematics.mobility(model).undriven == 0
    arm = {f"arm{k}": 0.1 for k in (1, 2, 3)}
    there = dict(zip(model.nodes, kt.kinematics.assemble(model, arm), strict=True))
    elbow = there["B2a"] - there["A2a"]
    assert math.atan2(-elbow[2], math.hypot(*elbow[:2])) == pytest.approx(0.1, abs=1e-12)
    corners = np.array([there[f"P{k}{side}"] for k in (1, 2, 3) for side in "ab"])
    assert np.ptp(corners[:, 2]) == pytest.approx(0, abs=1e-12)  # it does not tilt


@given(pose=st.tuples(st.floats(1.2, 1.8), st.floats(-1, 1.5), st.floats(-1, 1), st.floats(0.5, 1.5), st.floats(-1, 1.5)))
@settings(max_examples=5)
def test_robot_goes_where_its_closed_form_says(pose):
    names = ("lift", "swing", "shoulder", "reach", "wrist")
    there = kt.kinematics.assemble(mechanisms.robot(), dict(zip(names, pose, strict=True)))
    wanted = [node.at for node in mechanisms.robot(**dict(zip(names, pose, strict=True))).nodes.values()]
    assert np.abs(there - np.array(wanted)).max() < 1e-10
