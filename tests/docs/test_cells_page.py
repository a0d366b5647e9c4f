"""The page on cells: its table says what the cells are, its code runs."""

from __future__ import annotations

import re
from pathlib import Path

import kinetruss as kt
from kinetruss.library import cells

PAGE = (Path(__file__).parents[2] / "docs" / "cells.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)


def test_the_table_of_cells_is_true():
    rows = re.findall(r"^\| `(\w+)` \| (\d+) \| (\d+) \| (\d+) \|", PAGE, re.MULTILINE)
    assert {kind for kind, *_ in rows} == {
        "triangle", "panel", "tetrahedron", "octahedron", "decahedron", "prism", "cube", "double_octahedron",
        "quadruple_octahedron",
    }  # fmt: skip
    for kind, *counts in rows:
        model = cells.stack([getattr(cells, kind)()], fixed=())
        found = kt.kinematics.mobility(model)
        free = found.undriven - (3 if model.dim == 2 else 6)
        assert [len(model.nodes), len(model.members), free] == [int(count) for count in counts], kind
        assert found.self_stress == 0


def test_the_code_runs():
    names: dict[str, object] = {}
    for code in blocks("python"):
        exec(compile(code, "cells.md", "exec"), names)
    arm, mast, model = names["arm"], names["mast"], names["model"]
    assert isinstance(arm, kt.Model)
    assert isinstance(mast, kt.Model)
    assert isinstance(model, kt.Model)
    assert (len(arm.members), len(mast.driven_members), len(model.members)) == (108, 60, 109)


def test_the_file_is_the_stack_that_the_page_says(tmp_path):
    (code,) = blocks("yaml")
    (tmp_path / "arm.yaml").write_text(code, encoding="utf-8")
    assert not kt.check(tmp_path / "arm.yaml")
    model = kt.read(tmp_path / "arm.yaml")
    assert list(model.poses) == [f"B{k}" for k in range(1, 7)]
    assert model.loads["tip"].node == "B6.N8"


def test_the_tables_are_a_cell(tmp_path):
    (text,) = re.findall(r"^```\n(node,x.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    halves = [re.split(r" {3,}", line.strip()) for line in text.strip().splitlines()]
    for name, column in (("nodes", 0), ("members", 1)):
        (tmp_path / f"{name}.csv").write_text("\n".join(half[column] for half in halves) + "\n", encoding="utf-8")
    cell = kt.io.read_cell(tmp_path / "nodes.csv", tmp_path / "members.csv")
    assert kt.kinematics.mobility(cells.stack([cell] * 2)).undriven == 0
