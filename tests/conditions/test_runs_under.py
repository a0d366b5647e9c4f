"""Runs under a condition: locked and failed drives, heat along a motion, what is stored and read again."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235


@pytest.fixture(scope="module")
def crane():
    names = ("stuck", "hot", "laden", "broken")
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1.2, 1.3), "D": (2.4, 1.4)},
        fixed=["A", "B"],
        bars={
            "post": ("A", "C"),
            "lift": kt.Bar(ends=("B", "C"), kind="driven"),
            "boom": ("C", "D"),
            "swing": kt.Bar(ends=("B", "D"), kind="driven"),
        },
        section=kt.Tube(outer=0.03, inner=0.026),
        material=STEEL,
        gravity=(0, -9.81),
        loads={"hook": kt.NodalForce(node="D", force=(0, -200))},
        trajectories={"up": kt.Quintic(moves={"lift": (1.31529, 1.5), "swing": (1.97990, 1.9)}, duration=1.0)},
        conditions={
            "stuck": kt.Condition(locked=("swing",)),
            "hot": kt.Condition(temperature=60.0),
            "laden": kt.Condition(payloads={"D": 10.0}),
            "broken": kt.Condition(failed=("boom",)),
            "let_go": kt.Condition(released=("swing",)),
        },
        runs={
            "plain": kt.Run(trajectory="up", samples=21),
            **{name: kt.Run(trajectory="up", samples=21, condition=name) for name in names},
            "poses": kt.Run(analysis="statics.at_poses", poses={"a": {"lift": 1.4, "swing": 1.9}}, condition="stuck"),
            "fall": kt.Run(analysis="dynamics.simulate", t_end=0.05, samples=6, condition="let_go"),
        },
    )


def test_a_locked_drive_stays_and_the_others_go_on(crane):
    plain, stuck = kt.run(crane, "plain"), kt.run(crane, "stuck")
    at = kt.kinematics.sample(crane, kt.Quintic(moves={"lift": (1.4, 1.4)}, duration=1.0), [0.0]).value[0, 1]
    assert stuck.motion.drive_position.sel(drive="swing").values == pytest.approx(np.full(21, at), rel=1e-12)
    assert np.array_equal(stuck.motion.drive_position.sel(drive="lift"), plain.motion.drive_position.sel(drive="lift"))
    assert stuck.motion.length.sel(member="swing").values == pytest.approx(np.full(21, at), rel=1e-12)
    assert stuck.motion.length.sel(member="boom").values == pytest.approx(
        plain.motion.length.sel(member="boom").values, rel=1e-12
    )


def test_heat_lengthens_rigid_bars_along_the_whole_motion_and_not_the_drives(crane):
    plain, hot = kt.run(crane, "plain"), kt.run(crane, "hot")
    grown = 1 + 12e-6 * 60
    for name in ("post", "boom"):
        cold = plain.motion.length.sel(member=name).values
        assert hot.motion.length.sel(member=name).values == pytest.approx(cold * grown, rel=1e-12)
    assert np.array_equal(hot.motion.drive_position, plain.motion.drive_position)
    assert hot.status.ok


def test_a_payload_adds_its_weight_and_inertia(crane):
    laden = kt.run(crane, "laden")
    plain = kt.dynamics.inverse(crane, kt.run(crane, "plain").motion)
    a = laden.motion.acceleration.sel(node="D").values
    more = laden.forces["all"].reaction.sum("support") - plain.reaction.sum("support")
    assert more.values == pytest.approx(10.0 * (a + np.array([0, 9.81])), rel=1e-9, abs=1e-9)


def test_a_failure_that_leaves_a_mechanism_is_refused_in_words(crane):
    with pytest.raises(kt.KinetrussError, match="freedom|drive|node"):
        kt.run(crane, "broken")


def test_listed_poses_leave_locked_drives_where_they_are(crane):
    run = kt.run(crane, "poses")
    start = np.hypot(1.4, 1.4)
    assert run.motion.drive_position.values[0] == pytest.approx([1.4, start], rel=1e-12)


def test_a_simulation_lets_go_what_is_released(crane):
    run = kt.run(crane, "fall")
    assert np.abs(run.forces["all"].drive_force.sel(drive="swing").values).max() < 1e-9
    assert np.ptp(run.motion.length.sel(member="swing").values) > 1e-4
    assert np.ptp(run.motion.length.sel(member="lift").values) < 1e-9


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_stored_run_keeps_the_model_given_and_has_the_results_of_the_changed_one(crane, tmp_path):
    run = kt.run(crane, "hot", tmp_path / "hot", block=8)
    again = kt.runs.load(tmp_path / "hot")
    assert again.origin == crane
    assert again.model.nodes == kt.under(crane, "hot").nodes == run.model.nodes
    assert again.definition.condition == "hot"
    whole = kt.run(crane, "hot")
    assert again.forces["all"].member_force.values == pytest.approx(whole.forces["all"].member_force.values, rel=1e-9)
    assert "condition" in kt.report.document_page(again).html


def test_an_unknown_condition_is_a_fault(crane):
    with pytest.raises(kt.ModelError, match="no condition called 'hott'. Did you mean 'hot'"):
        crane.with_(runs={"r": kt.Run(trajectory="up", condition="hott")})
