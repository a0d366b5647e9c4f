"""The page on models: its file and its Python code make one model, and the file runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main

PAGE = (Path(__file__).parents[2] / "docs" / "model.md").read_text(encoding="utf-8")


def block(language: str, text: str) -> str:
    found = re.findall(rf"^```{language}\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    (one,) = (code for code in found if text in code)
    return one


def test_the_file_and_the_code_make_the_same_model(tmp_path):
    (tmp_path / "boom.yaml").write_text(block("yaml", "kinetruss: 1"), encoding="utf-8")
    names: dict[str, object] = {}
    exec(compile(block("python", "kt.Active"), "model.md", "exec"), names)
    made, read = names["boom"], kt.read(tmp_path / "boom.yaml")
    assert isinstance(made, kt.Model)
    for field in kt.Model.model_fields:
        assert getattr(read, field) == getattr(made, field), field


def test_the_file_runs_without_faults(tmp_path):
    (tmp_path / "boom.yaml").write_text(block("yaml", "kinetruss: 1"), encoding="utf-8")
    assert not kt.check(tmp_path / "boom.yaml")
    run = kt.run(kt.read(tmp_path / "boom.yaml"), out=tmp_path / "run")
    assert run.motion.status == kt.Status.COMPLETED
    assert set(run.forces) == {"lift", "storm"}


def test_what_the_page_names_has_a_row():
    for word in (
        "kt.Active",
        "kt.Part",
        "kt.LeadScrew",
        "active:",
        "fixed: {A: xy",
        "load_cases:",
        "safety:",
        "sections:",
        "kt.NodalForce",
    ):
        assert word in PAGE


STILL = """kinetruss: 1
nodes: {A: [0, 0], B: [2, 0], C: [1, 1.5]}
fixed: {A: xy, B: y}
bars: {left: [A, C], right: [B, C], tie: [A, B]}
"""


@pytest.mark.parametrize(
    ("runs", "said"),
    [
        ("", "No run to compute: the model has none. Add one to its runs"),
        ("runs: {stand: {samples: 3}}", "has neither trajectory nor motion"),
    ],
)
def test_who_runs_what_stands_still_without_saying_how_is_told_how(runs, said, tmp_path):
    (tmp_path / "still.yaml").write_text(STILL + runs)
    done = CliRunner().invoke(main, ["run", str(tmp_path / "still.yaml"), "-o", str(tmp_path / "run")])
    assert done.exit_code != 0
    assert said in done.output
    assert "the analysis is statics.linear" in done.output
    assert not (tmp_path / "run").exists()
