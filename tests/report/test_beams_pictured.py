"""Pictures of beams: chords as members of their own kind, without the nodes and bars of frames."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report, viewer
from kinetruss.report.run_figures import specifications
from kinetruss.strength.beam_verdict import middle_forces
from kinetruss.viewer.places import Places

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


@pytest.mark.slow
def test_drawings_and_figures_have_beams_and_no_frames(tmp_path):
    run = kt.run(model(), "here")
    for what in (model(), run):
        path = report.picture(what, tmp_path / "drawn.svg", names=True)
        text = path.read_text(encoding="utf-8")
        assert ".d1" not in text
        assert ">B<" in text
    shape = next(one for one in specifications(run) if one.name == "shape")
    (stand,) = shape.stands
    words = {one.words for one in stand.labels}
    assert {"A", "B", "C", "D", "lower", "upper", "tie"} <= words
    assert not any(".d" in name for name in words)
    ends = {frozenset((tuple(line[0]), tuple(line[-1]))) for line in stand.lines}
    found = dict(zip(run.model.whole.nodes, run.motion.whole["position"].values[0], strict=True))
    assert ends == {frozenset((tuple(found[a]), tuple(found[b]))) for a, b in ("AB", "BC", "AD")}
    assert sorted(kind for kind, *_ in stand.supports) == ["clamp", "pin"]
    assert stand.dots.shape == (4, 2)


def test_scenes_name_what_is_left_out():
    one = model()
    header = viewer.scene(one).header
    kinds = dict(zip(header["members"], header["kinds"], strict=True))
    assert (kinds["lower"], kinds["upper"], kinds["tie"]) == ("beam", "rigid", "rigid")
    assert {name for name, kind in kinds.items() if kind == "frame"} == {
        name for name, bar in one.whole.bars.items() if any(".d" in end for end in bar.ends)
    }
    assert [header["nodes"][k] for k in header["directors"]] == [name for name in one.whole.nodes if ".d" in name]
    assert {header["nodes"][held["node"]] for held in header["supports"]} == {"A", "D"}


def test_the_colour_of_a_beam_is_its_own_axial_force():
    run = kt.run(model(), "here")
    found = middle_forces(run.model, run.forces["all"])
    columns = [list(run.model.whole.members).index(name) for name in ("lower.chord", "tie")]
    assert found[0, columns] == pytest.approx([-PUSH, 0.0], abs=1e-9)
    propped = model().with_(fixed={"D": "xy", "C": "x"})
    unknown = kt.run(propped, "here")
    assert np.isnan(middle_forces(propped, unknown.forces["all"])[0, list(propped.whole.members).index("lower.chord")])
    assert np.isnan(found[0, list(run.model.whole.members).index("upper.chord")])  # of a rigid beam no section force is known


def cantilever() -> tuple[kt.Model, kt.results.Result]:
    """A beam of 1 m under a small force at its tip."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)},
        clamped=["A"],
        beams={"arm": ("A", "B")},
        section=kt.Rectangle(width=0.01, height=0.02),
        material=kt.Material(E=200e9, density=0.0),
        loads={"P": kt.NodalForce(node="B", force=(0, -1e-3))},
    )
    return model, kt.statics.equilibrium(model)


def deflection(s: np.ndarray) -> np.ndarray:
    """w = -P s^2 (3 l - s)/(6 E I) of a cantilever under a force at its tip."""
    return -1e-3 * s**2 * (3 - s) / (6 * 200e9 * 0.01 * 0.02**3 / 12)


def test_a_bent_beam_is_drawn_along_its_deflection():
    model, rest = cantilever()
    one = viewer.scene(rest, model=model)
    (along,), (nodes,) = one.arrays["beam_along"], one.arrays["beam_nodes"]
    drawn = along @ one.arrays["position"][0][nodes]
    assert len(drawn) == 13
    tip = abs(deflection(np.ones(1))[0])
    np.testing.assert_allclose(drawn[:, 1], deflection(np.linspace(0, 1, 13)), atol=1e-7 * tip)
    # on paper the same points
    (curve,) = Places(one).lines
    np.testing.assert_allclose(curve, drawn, rtol=0, atol=1e-15)


def test_a_scene_has_the_section_forces_of_a_beam():
    model, rest = cantilever()
    one = viewer.scene(rest, model=model)
    assert one.header["members"][-1] == "arm"
    (along,) = one.arrays["beam_section"][0]
    s = np.linspace(0, 1, 13)
    np.testing.assert_allclose(along[:, 1], -1e-3, rtol=1e-6)
    np.testing.assert_allclose(along[:, 2], -1e-3 * (1 - s), rtol=1e-6, atol=1e-11)
    assert one.arrays["member_force"][0, -1] == pytest.approx(0.0, abs=1e-7)  # P times the slope
