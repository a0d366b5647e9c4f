"""Linkages with one freedom: straight lines, six bars, Sarrus, and loops that move although their count forbids it."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import ModelError
from kinetruss.library import mechanisms

ONE_FREEDOM = {
    "peaucellier": 7, "hart": 17, "watt_line": 7, "chebyshev": 7, "roberts": 5, "watt_six_bar": 7, "stephenson_six_bar": 7,
    "sarrus": 32, "spherical_four_bar": 5,
}  # fmt: skip


@pytest.mark.parametrize("name", ONE_FREEDOM)
def test_bars_and_freedom(name):
    model = getattr(mechanisms, name)()
    found = kt.kinematics.mobility(model.with_(drives={}, runs={}))
    assert (len(model.bars), found.undriven, found.self_stress) == (ONE_FREEDOM[name], 1, 0)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "tolerance"), [("peaucellier", 1e-13), ("hart", 1e-13)])
def test_exact_straight_line(name, tolerance):
    model = getattr(mechanisms, name)()
    motion = kt.kinematics.follow(model, model.runs["swing"].trajectory, samples=51)
    x = motion.position.sel(node="P", axis="x").values
    assert np.ptp(motion.position.sel(node="P", axis="y").values) > 0.03
    assert x == pytest.approx(x[0], abs=tolerance)


@pytest.mark.parametrize(("name", "across"), [("watt_line", "x"), ("chebyshev", "y"), ("roberts", "y")])
def test_nearly_straight_line(name, across):
    model = getattr(mechanisms, name)()
    path = kt.kinematics.follow(model, model.runs["swing"].trajectory, samples=51).position.sel(node="P")
    long, off = np.ptp(path.sel(axis="yx"["yx".index(across) ^ 1]).values), np.ptp(path.sel(axis=across).values)
    assert 0 < off < 0.02 * long


def test_chebyshev_is_level_at_its_three_positions():
    angles = (math.atan2(4, 3), 0.0 + math.asin(0.8), math.pi / 2)
    # published (Chebyshev 1854): at atan(4/3) in the middle; upright crank ends the straight part, both at y = 4 units
    heights = [mechanisms.chebyshev(unit=1.0, angle=a).nodes["P"].at[1] for a in angles]
    assert heights == pytest.approx([4.0, 4.0, 4.0], rel=1e-12)


@given(angle=st.floats(-2.8, 2.8), alpha=st.floats(0.2, 1.2), beta=st.floats(1.3, 1.8))
@settings(max_examples=25)
def test_bennett_closes_with_equal_opposite_links(angle, alpha, beta):
    model = mechanisms.bennett(angle=angle, twist=alpha, other_twist=beta)
    last = np.array(model.nodes["P1"].at) - model.nodes["P4"].at
    other = 0.3 * math.sin(beta) / math.sin(alpha)
    assert np.linalg.norm(last) == pytest.approx(other, rel=1e-9)


@pytest.mark.parametrize(
    ("model", "count", "rank", "stress"),
    [(mechanisms.bennett(), -2, 11, 3), (mechanisms.bricard(), 0, 23, 1), (mechanisms.bricard(twist=1.2, angle=2.0), 0, 23, 1)],
    ids=["bennett", "orthogonal", "threefold"],
)
def test_rank_decides_not_count(model, count, rank, stress):
    found = kt.kinematics.mobility(model)
    assert (found.maxwell, found.rank, found.undriven, found.self_stress) == (count, rank, 1, stress)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["bennett", "bricard"])
def test_loops_move_and_keep_energy(name):
    run = kt.dynamics.simulate(getattr(mechanisms, name)(), 0.3, samples=4)
    energy = run.kinetic_energy.values + run.potential_energy.values
    assert run.kinetic_energy.values[-1] > 1e-3
    assert energy == pytest.approx(energy[0], abs=1e-8 * run.kinetic_energy.values.max())


def test_hooke_joint_turns_unevenly():
    """tan(out) = tan(in)/cos(bend), the joint's classical law."""
    bend, turn = 0.4, 0.7
    model = mechanisms.spherical_four_bar(
        ground=math.pi - bend, crank=math.pi / 2, coupler=math.pi / 2, rocker=math.pi / 2, angle=turn
    )
    b, c, d = (np.array(model.nodes[name].at) / 0.2 for name in "BCD")
    assert (b @ c, c @ d) == pytest.approx((0, 0), abs=1e-12)
    side, up = np.cross((0, 0, 1), d), np.array((0.0, 0.0, 1.0))
    out = math.atan2(c @ side, c @ up)
    assert abs(math.tan(out)) == pytest.approx(abs(math.tan(turn) / math.cos(bend)), rel=1e-9)


@pytest.mark.parametrize(
    ("name", "given", "words"),
    [
        ("bennett", {"other_twist": 0.7}, "must differ"),
        ("bennett", {"other_twist": -1.0}, "same sign"),
        ("bricard", {"angle": 2.2}, "does not close"),
        ("bricard", {"twist": 0.0}, "all hinges parallel"),
        ("spherical_four_bar", {"coupler": 0.1}, "coupler: the linkage does not close"),
        ("sarrus", {"height": 0.6}, "beyond the plates"),
        ("hart", {"part": 1.2}, "no part of a link"),
        ("peaucellier", {"arm": 0.2}, "does not close"),
        ("watt_six_bar", {"joint": (0.1, 0.0)}, "stiff only to second order. Move the point off the line"),
        ("stephenson_six_bar", {"link": 0.01}, "does not close"),
    ],
)
def test_faults(name, given, words):
    with pytest.raises(ModelError, match=words):
        getattr(mechanisms, name)(**given)
