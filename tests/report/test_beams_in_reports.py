"""Reports of beams and meshes: bent axes, clamps with their moments, no frames of beams, stresses of meshes, colours."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import pytest
from matplotlib.colors import to_hex

import kinetruss as kt
from frame_models import BEAMS, LOADS, NODES, SIDE, STEEL, G, portal
from kinetruss import report
from kinetruss.display import DRIVEN, OVER
from kinetruss.report.document.figure import loaded
from kinetruss.report.pictures.drawing import BAND, drawn
from reference.plane_frame import solve
from samples import fourbar


@pytest.mark.slow
def test_a_clamp_has_the_force_and_moment_of_the_stiffness_method():
    found = {one["support"]: one for one in report.document_page(kt.run(portal(), "load")).record["reactions"]}
    A, I = SIDE**2, SIDE**4 / 12
    _, wanted = solve(NODES, BEAMS, ["A", "D"], LOADS, EA=STEEL.E * A, EI=STEEL.E * I, weight=STEEL.density * A * G)
    assert set(found) == {"A", "D"}
    for name, (fx, fy, mz) in wanted.items():
        assert found[name]["force"]["x"] == pytest.approx(fx, rel=1e-8)
        assert found[name]["force"]["y"] == pytest.approx(fy, rel=1e-8)
        assert found[name]["moment"]["z"] == pytest.approx(mz, rel=1e-8)


def test_a_clamp_in_space_has_three_moments():
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (2, 0, 0)}, clamped=["A"], beams={"arm": ("A", "B")},
        section=kt.Tube(outer=0.1, inner=0.09),
        material=kt.Material(E=210e9, density=0.0), loads={"P": kt.NodalForce(node="B", force=(0, 30.0, -100.0))},
        runs={"load": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    (one,) = report.document_page(kt.run(model)).record["reactions"]
    assert [one["moment"][axis] for axis in "xyz"] == pytest.approx([0.0, -200.0, -60.0], abs=1e-6)


@pytest.mark.slow
def test_frames_of_beams_are_no_parts_of_the_structure():
    page = report.document_page(kt.run(portal(), "load"))
    text = re.sub(r"<(script|pre)\b.*?</\1>", "", page.html, flags=re.DOTALL)
    text = text[: text.index("How to repeat the computation</h2>")]
    checks = text.index("What was checked, and the result")
    assert not re.search(r"\b[A-D]\.d\d|\.chord", text[:checks])
    assert "Kept inextensible" not in text
    assert "Nodes are pins" not in text
    assert {one["member"] for one in page.record["envelopes"]["all"]} == set(BEAMS)
    assert "<td>5, in the plane</td>" in re.sub(r' class="[^"]*"', "", text)


def leaf(force: float) -> kt.runs.RunResult:
    names = [f"N{k}" for k in range(6)]
    model = kt.Model(
        nodes={name: (0.1 * k, 0) for k, name in enumerate(names)}, clamped=["N0"],
        beams={f"s{k}": pair for k, pair in enumerate(pairwise(names), 1)},
        section=kt.Rectangle(width=0.02, height=0.002), material=STEEL,
        loads={"tip": kt.NodalForce(node="N5", force=(0, -force))},
        runs={"bend": kt.Run(analysis="statics.equilibrium")},
    )  # fmt: skip
    return kt.run(model, "bend")


@pytest.mark.slow
def test_the_figure_draws_beams_along_their_bent_axes():
    run = leaf(6.0)
    (stand,) = loaded(run, report.document_page(run).record)[0].stands
    assert len(stand.lines) == len(run.model.beams)  # no chords
    one = stand.lines[0]
    assert len(one) > 5
    chord = one[0] + np.linspace(0, 1, len(one))[:, None] * (one[-1] - one[0])
    bow = np.abs(one - chord).max()
    # a circle of the curvature M/(E I): sagitta kappa l^2/8
    kappa = 6.0 * 0.45 / (STEEL.E * 0.02 * 0.002**3 / 12)
    assert bow == pytest.approx(kappa * 0.1**2 / 8, rel=0.05)


@pytest.mark.slow
@pytest.mark.parametrize(("force", "over"), [(3.0, False), (12.0, True)])
def test_the_governing_member_is_red_only_over_its_capacity(force, over):
    run = leaf(force)
    figure, caption = loaded(run, report.document_page(run).record)
    assert figure.stands[0].band == (0, over)  # the first segment, at the clamp
    pens = {tuple(round(255 * one) for one in pen[:3]) for ax in drawn(figure).axes for lines in ax.collections
            for pen in lines.get_edgecolor()}  # fmt: skip
    red, band = (tuple(int(colour[k : k + 2], 16) for k in (1, 3, 5)) for colour in (OVER, BAND))
    assert (red in pens) is over
    assert (band in pens) is not over
    assert ("red, over" in caption) is over


@pytest.mark.slow
def test_a_driven_member_that_governs_stays_green():
    run = kt.run(fourbar(), "turn")
    figure, caption = loaded(run, report.document_page(run).record)
    assert figure.stands[0].band == (list(run.model.members).index("crank"), False)
    assert "(crank: " in caption
    colours = [pen for ax in drawn(figure).axes for lines in ax.collections for pen in lines.get_edgecolor()
               if lines.get_linewidth()[0] > 2]  # fmt: skip
    assert {to_hex(pen) for pen in colours} == {DRIVEN, BAND}


@pytest.mark.slow
@pytest.mark.parametrize("analysis", ["statics.linear", "statics.equilibrium"])
def test_a_mesh_has_its_highest_stress(analysis):
    plate = kt.library.meshes.rectangle(width=2.0, height=0.5, columns=8, rows=2, six_nodes=True)
    right, force = plate.at(x=2.0), 1e5
    share = {0: 1 / 12, 1: 1 / 3, 2: 1 / 6, 3: 1 / 3, 4: 1 / 12}  # a uniform traction on two quadratic edges
    order = sorted(right, key=lambda name: plate.nodes[name].at[1])
    model = kt.Model(
        nodes=plate.nodes, fixed={name: "xy" if plate.nodes[name].at[1] == 0 else "x" for name in plate.at(x=0.0)},
        material=STEEL, membranes={"web": plate.membrane(thickness=0.01, strain="linear")},
        loads={name: kt.NodalForce(node=name, force=(share[k] * force, 0)) for k, name in enumerate(order)},
        runs={"pull": kt.Run(analysis=analysis)},
    )  # fmt: skip
    page = report.document_page(kt.run(model))
    (one,) = page.record["skins"]
    assert one["von_mises"] == pytest.approx(force / (0.5 * 0.01), rel=2e-3)
    assert one["yield_strength"] == 235e6
    assert page.record["result"][0].startswith("No limit was checked. Highest stress: 20")
    assert "mechanism 1" not in page.html
    assert "Not part of the checks" in page.html


def test_of_infinite_utilisations_the_part_of_the_highest_other_one_governs():
    nodes = {"A": (0, 0), "B": (2, 0), "C": (4, 0), "D": (1, 1.2), "E": (3, 1.2)}
    bars = {name: kt.Bar(ends=tuple(name), kind="elastic") for name in ("AB", "BC", "AD", "DB", "BE", "EC", "DE")}
    model = kt.Model(nodes=nodes, fixed={"A": "xy", "C": "y"}, bars=bars, section=kt.Tube(outer=0.03, inner=0.026),
                     material=STEEL, gravity=(0, -G), loads={"snow": kt.NodalForce(node="B", force=(0, -27e3))},
                     safety=kt.Safety(yielding=1.5, buckling=2), runs={"load": kt.Run(analysis="statics.linear")})  # fmt: skip
    found = report.document_page(kt.run(model)).record
    infinite = [row["part"] for row in found["strength"] if row["utilisation"] == "Infinity"]
    assert len(infinite) == 3
    most = max((row for row in found["strength"] if row["utilisation"] != "Infinity"), key=lambda row: row["utilisation"])
    assert infinite[0] == most["part"] == "DE"
    assert found["result"][0].startswith("Governing: buckling of DE")  # the finite one
