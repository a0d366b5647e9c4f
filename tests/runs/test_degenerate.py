"""Models that lack nearly everything: each analysis and each output works or refuses in words."""

import pytest

import kinetruss as kt
from campaigns import degenerate

MODELS = dict(degenerate.models())
SHOWN = ("statics.at_poses", "mission")
"""Analyses whose outputs are all made here; the campaign makes those of all."""
CHOSEN = ("no drives 2", "all fixed 2", "no bars 2", "no bars, fixed 3", "one bar 3", "one active 2", "only beams 2", "body 3")


@pytest.mark.slow
@pytest.mark.parametrize("name", CHOSEN)
@pytest.mark.usefixtures("undrawn")
def test_a_model_that_lacks_nearly_everything(name, tmp_path):
    assert degenerate.walked(name, MODELS[name], tmp_path, SHOWN) == []


def test_a_fault_is_found(tmp_path):
    walk = degenerate.Walk("planted", tmp_path)
    assert walk.tried("index", lambda: [][0]) is None
    assert walk.faults[0].startswith("planted: index: IndexError")


def test_a_single_point_has_tables_and_no_member_forces():
    model = MODELS["no bars, fixed 3"].with_(runs={"here": kt.Run(analysis="statics.at_poses", poses={"here": {}})})
    run = kt.run(model)
    assert run.forces["all"].reaction.values.tolist() == [[[0.0, 0.0, 9.81]]]
    with pytest.raises(kt.InputError, match="the model has no member"):
        kt.report.curves(run, "member_force")
