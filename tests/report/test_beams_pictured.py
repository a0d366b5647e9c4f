"""Pictures of beams: chords as members of their own kind, without the nodes and bars of frames."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report, viewer
from kinetruss.report.pictures.figures import specifications
from kinetruss.strength.verdict import middle_forces

PUSH = 300.0


def model() -> kt.Model:
    """A clamped column of an elastic and a rigid beam under a load along it, beside a bar."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (0, 2), "D": (1, 0)},
        clamped=["A"],
        fixed=["D"],
        bars={"tie": ("A", "D")},
        beams={"lower": ("A", "B"), "upper": kt.Beam(ends=("B", "C"), kind="rigid")},
        section=kt.Tube(outer=0.03, inner=0.026),
        material=kt.library.materials.STEEL_S235,
        loads={"push": kt.NodalForce(node="C", force=(0, -PUSH))},
        runs={"here": kt.Run(analysis="statics.at_poses", poses={"it": {}})},
    )


def test_drawings_and_figures_have_beams_and_no_frames(tmp_path):
    run = kt.run(model(), "here")
    for what in (model(), run):
        path = report.picture(what, tmp_path / "drawn.svg", names=True)
        text = path.read_text(encoding="utf-8")
        assert ".d1" not in text
        assert ">B<" in text
    shape = next(one for one in specifications(run) if one.name == "shape")
    assert shape.nodes == ("A", "B", "C", "D")
    assert {frozenset(ends) for ends in shape.ends} == {frozenset(pair) for pair in ((0, 1), (1, 2), (0, 3))}
    assert set(shape.held) == {0, 3}
    assert all(pose.position.shape == (4, 2) for pose in shape.poses)


def test_scenes_name_what_is_left_out():
    one = model()
    header = viewer.scene(one).header
    kinds = dict(zip(header["members"], header["kinds"], strict=True))
    assert (kinds["lower"], kinds["upper"], kinds["tie"]) == ("beam", "rigid", "rigid")
    assert {name for name, kind in kinds.items() if kind == "frame"} == {
        name for name, bar in one.bars.items() if any(".d" in end for end in bar.ends)
    }
    assert [header["nodes"][k] for k in header["directors"]] == [name for name in one.nodes if ".d" in name]
    assert {header["nodes"][held["node"]] for held in header["supports"]} == {"A", "D"}


def test_the_colour_of_a_beam_is_its_own_axial_force():
    run = kt.run(model(), "here")
    found = middle_forces(run.model, run.forces["all"])
    columns = [list(run.model.members).index(name) for name in ("lower.chord", "tie")]
    assert found[0, columns] == pytest.approx([-PUSH, 0.0], abs=1e-9)
    propped = model().with_(fixed={"D": "xy", "C": "x"})
    unknown = kt.run(propped, "here")
    assert np.isnan(middle_forces(propped, unknown.forces["all"])[0, list(propped.members).index("lower.chord")])
