"""The report of an elastic truss under load cases: one unit in a table, mobility of elastic bars, arrows beside members."""

from __future__ import annotations

import re

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report
from kinetruss.report.document.figure import loaded


@pytest.fixture(scope="module")
def truss() -> kt.runs.RunResult:
    nodes = {"A": (0, 0), "B": (2, 0), "C": (4, 0), "D": (1, 1.2), "E": (3, 1.2)}
    tube = kt.Tube(outer=0.06, inner=0.052)
    bars = {name: kt.Bar(ends=tuple(name), kind="elastic") for name in ("AB", "BC", "AD", "DB", "BE", "EC", "DE")}
    loads = {"walkers": kt.NodalForce(node="B", force=(0, -20e3)), "wind": kt.NodalForce(node="D", force=(3e3, 0))}
    cases = {"wind": kt.LoadCase(loads={"wind": 1.0}), "full": kt.LoadCase(loads={"walkers": 1.0, "wind": 1.0})}
    model = kt.Model(nodes=nodes, fixed={"A": "xy", "C": "y"}, bars=bars, section=tube, material="steel_s235", loads=loads,
                     load_cases=cases, gravity=(0, -9.81), runs={"load": kt.Run(analysis="statics.linear")})  # fmt: skip
    return kt.run(model, "load")


@pytest.mark.slow
def test_load_cases_stand_beside_each_other_in_one_unit(truss):
    page = report.document_page(truss).html
    table = re.search(r"Member forces, load cases wind, full(.*?)</table>", page, re.DOTALL)[1]
    assert re.findall(r"<th[^>]*>([^<]*)</th>", table) == ["member", "largest", "wind (kN)", "full (kN)"]
    moved = re.search(r"Largest displacement of a node(.*?)</table>", page, re.DOTALL)[1]
    assert [head for head in re.findall(r"<th[^>]*>([^<]*)</th>", moved) if "µm" in head]
    assert report.lines(truss)[0].endswith("(load case full).")


@pytest.mark.slow
def test_a_load_and_a_load_case_of_one_name_are_both_listed(truss):
    cells = re.findall(r"<td[^>]*>([^<]*)</td>", report.document_page(truss).html)
    assert cells[cells.index("wind") + 1] == "node D, force [3000, 0] N"
    assert cells[cells.index("load case wind") + 1].startswith("loads wind: 1")


@pytest.mark.slow
def test_elastic_bars_are_counted_as_bars_too(truss):
    found = report.document_page(truss).record["mobility"]
    assert (found["undriven"], found["elastic"]) == (7, True)  # 10 coordinates, 3 held, no rigid bar
    assert (found["elastic_as_rigid"]["rank"], found["elastic_as_rigid"]["undriven"]) == (7, 0)
    assert "mechanism 1" not in report.document_page(truss).html


@pytest.mark.slow
def test_an_arrow_along_a_member_is_drawn_on_its_other_side(truss):
    (stand,) = loaded(truss, report.document_page(truss).record)[0].stands
    middles = {tuple(one.at): one.words for one in stand.labels}
    ends = {middles[tuple((start + end) / 2)]: (start, end) for start, end in stand.arrows}
    place = stand.dots
    assert np.allclose(ends["3 kN"][1], place[3])  # member DE leaves D along the force: the arrow ends at the node
    assert np.allclose(ends["20 kN"][0], place[1])  # nothing below B: it begins there
