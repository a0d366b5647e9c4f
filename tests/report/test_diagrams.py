"""Diagrams along members and beams: extremes against closed forms and another program, what is chosen, what is refused."""

from __future__ import annotations

import json

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from frame_models import BEAMS, LOADS, NODES, SIDE, STEEL, G, portal
from kinetruss import report, runs
from kinetruss.cli import main
from kinetruss.errors import InputError
from kinetruss.report.document.diagram_pages import drawn, scales_of
from kinetruss.report.member_diagrams import governing_diagrams, only, section_lines
from reference.plane_frame import solve
from samples import tripod


@pytest.fixture(scope="module")
def frame() -> runs.RunResult:
    return kt.run(portal(), "load")


@pytest.fixture(scope="module")
def stiffness():
    A, I = SIDE**2, SIDE**4 / 12
    return solve(NODES, BEAMS, ["A", "D"], LOADS, EA=STEEL.E * A, EI=STEEL.E * I, weight=STEEL.density * A * G)


def test_ends_of_diagrams_are_those_of_the_stiffness_method(frame, stiffness):
    ends, _ = stiffness
    found = {one.part: one for one in section_lines(frame.model, only(frame.forces["all"], 0), list(BEAMS))}
    for name, wanted in ends.items():
        for symbol, pair in wanted.items():
            values = found[name].lines[symbol].values
            np.testing.assert_allclose(values[[0, -1]], pair, rtol=1e-9, atol=1e-5)


def test_extreme_values_lie_where_the_shear_force_vanishes(frame, stiffness):
    ends, _ = stiffness
    weight = STEEL.density * SIDE**2 * G
    rows = {(one["part"], one["symbol"]): one for one in report.diagrams_page(frame, list(BEAMS)).record}
    for name in ("top1", "top2"):
        (V0, V1), (M0, M1) = (np.array(ends[name][symbol]) for symbol in ("V2", "M3"))
        where = -V0 / weight  # V grows along a level beam by its weight
        inner = [M0 - V0 * where / 2] if 0 < where < 2 else []
        assert rows[name, "M3"]["largest"] == pytest.approx(max(M0, M1, *inner), rel=1e-9)
        assert rows[name, "M3"]["least"] == pytest.approx(min(M0, M1, *inner), rel=1e-9)
        assert rows[name, "V2"]["largest"] == pytest.approx(max(V0, V1), rel=1e-9)


def test_a_peak_between_stations_is_found():
    """Weight and a point load: the moment is largest where V crosses zero, at no station of the first scan."""
    model = kt.Model(
        nodes={"A": (0, 0), "P": (0.37, 0), "B": (1, 0)}, fixed={"A": "xy", "B": "y"},
        beams={"one": ("A", "P"), "two": ("P", "B")},
        section=kt.Rod(diameter=0.02), material=STEEL, gravity=(0, -G), loads={"P": kt.NodalForce(node="P", force=(0, -1.0))},
        runs={"load": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    w = STEEL.density * np.pi * 0.01**2 * G
    Ra = w / 2 + 0.63
    x = (Ra - 1.0) / w  # beyond the load: Ra - 1 - w x = 0
    assert 0.37 < x < 1
    rows = {(one["part"], one["symbol"]): one for one in report.diagrams_page(kt.run(model), ["two"]).record}
    peak = rows["two", "M3"]
    assert peak["largest"] == pytest.approx(Ra * x - (x - 0.37) - w * x**2 / 2, rel=1e-9)
    assert peak["largest_at"] == pytest.approx(x - 0.37, abs=1e-4)


@pytest.mark.slow
def test_governing_members_have_their_own_instants():
    run = kt.run(tripod(), "lift")
    record = report.document_page(run).record
    members, beams = governing_diagrams(run, record)
    assert beams == []
    yielding = next(row for row in record["strength"] if row["rule"] == "yield" and row["utilisation"])
    one = next(one for one in members if "yield" in one.why and one.along.part == yielding["part"])
    assert (one.load_case, one.place) == (yielding["load_case"], yielding["position"])
    worst = record["limits"][0]
    assert {f"{worst['part']}.base", f"{worst['part']}.tube"} <= {one.along.part for one in members}
    # the section forces of the worked calculation are on the curve
    sheet = next(one for one in record["worked"] if one["rule"] == "yield")
    T = next(given["value"] for given in sheet["given"] if given["symbol"] == "T")
    assert np.interp(one.place, one.along.x, one.along.lines["T"].values) == pytest.approx(T, rel=1e-9)
    assert {row["part"] for row in record["diagrams"]} == {one.along.part for one in members}


@pytest.mark.slow
def test_round_off_is_zero_and_left_out(frame):
    truss = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0.3)}, fixed=["A", "B"], bars={"s": kt.Bar(ends=("A", "C"), mass=0.0),
        "t": kt.Bar(ends=("B", "C"), mass=0.0)}, section=kt.Rod(diameter=0.02), material=STEEL,
        loads={"P": kt.NodalForce(node="C", force=(0, -1000))}, runs={"load": kt.Run(analysis="statics.linear")},
    )  # fmt: skip
    members, _ = governing_diagrams(kt.run(truss), report.document_page(kt.run(truss)).record)
    assert set(scales_of(members)) == {"T"}
    lines = members[0].along.lines
    assert not lines["V2"].values.any()
    assert len(drawn(members).axes) == len(members)


@pytest.mark.slow
def test_the_command_draws_diagrams_and_tells_their_values(frame, tmp_path):
    kt.run(portal(), "load", out=tmp_path / "run")
    asked = ["--along", "--member", "top1", "-o", str(tmp_path / "d.svg"), "--json"]
    done = CliRunner().invoke(main, ["plot", str(tmp_path / "run"), *asked])
    assert done.exit_code == 0, done.output
    found = json.loads(done.stdout)
    assert {one["symbol"] for one in found["diagrams"]} == {"T", "V2", "M3"}
    text = (tmp_path / "d.svg").read_text("utf-8")
    assert "moment M₃ (kN m)" in text
    assert ">top1<" in text
    done = CliRunner().invoke(main, ["plot", str(tmp_path / "run"), "--at", "0"])
    assert done.exit_code
    assert "Add --along" in done.output
    done = CliRunner().invoke(main, ["plot", str(tmp_path / "run"), "--along", "--quantity", "stress"])
    assert "--along takes one run" in done.output


def test_what_cannot_be_drawn_is_refused(frame, tmp_path):
    file = tmp_path / "d.svg"
    for arguments, words in (
        ({"members": ["lfet"]}, "Did you mean 'left'"),
        ({"members": ["left"], "case": "storm"}, "No load case called 'storm'"),
        ({"members": ["left"], "at": 3.0}, "the run goes from 0 to 0 s"),
        ({"at": 0.0}, "Name the members too"),
    ):
        with pytest.raises(InputError, match=words):
            report.diagrams(frame, file, **arguments)
    rigid = portal(beams=BEAMS | {"right": kt.Beam(ends=("D", "C"), kind="rigid")})
    with pytest.raises(InputError, match="No section forces of right are known"):
        report.diagrams(kt.run(rigid, "load"), file, members=["right"])
    with pytest.raises(InputError, match=r"pictures end in \.png"):
        report.diagrams(frame, tmp_path / "d.gif", members=["left"])
    assert not list(tmp_path.iterdir())
