"""Reports of missions and sizings: the result in three lines, worked calculations of what governs, from files on disk."""

from __future__ import annotations

import json
import re

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss import report, runs
from kinetruss.cli import main
from kinetruss.design import GroupRow
from kinetruss.errors import InputError
from kinetruss.library import example_files
from samples import tripod


def call(*arguments: object) -> str:
    done = CliRunner().invoke(main, [str(one) for one in arguments])
    assert done.exit_code == 0, done.output
    return done.stdout


def embedded(page: str) -> dict:
    return json.loads(re.search(r'id="kinetruss-report">(.*?)</script>', page, re.DOTALL)[1])


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_mission_from_disk(tmp_path):
    model = tripod(
        samples=9,
        conditions={"as_is": {}, "laden": {"payloads": {"T": 15.0}}},
        report={"project": "Platform", "checker": "C. Hecker"},
    )
    lift = model.runs["lift"]
    model = model.with_(runs={"lift": lift, "all": kt.Run(analysis="mission", motions=["lift"], conditions=["as_is", "laden"])})
    mission = kt.run(model, "all", out=tmp_path / "run")
    lines = call("report", tmp_path / "run", "-o", tmp_path / "out", "--no-open", "--no-pdf", "--no-view").splitlines()
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    found = embedded(page)
    assert tuple(lines[:3]) == report.lines(runs.load(tmp_path / "run")) == tuple(found["result"])
    trains = mission.trains.data_vars
    assert float(trains["utilisation"].max()) > 1
    assert lines[0].startswith("Governing: voltage of the drive of ")
    assert "laden" in lines[0]
    worst = found["worked"][0]
    assert worst["utilisation"] == pytest.approx(float(trains["utilisation"].max()), rel=1e-12)  # of the pair, done again
    assert all(one["difference"] < 1e-11 for one in found["worked"])
    rules = {row.rule: row for row in reversed(mission.verdict.table()) if row.checked and row.utilisation > 1e-9}
    for rule, row in rules.items():  # the worst entry of each rule over all pairs, from its own pair
        one = next(one for one in found["worked"] if one["rule"] == rule)
        assert (one["part"], one["pair"]) == (row.part, row.load_case)
        assert one["utilisation"] == pytest.approx(row.utilisation, rel=1e-12)
    assert "Platform" in page
    assert "C. Hecker" in page
    assert str(tmp_path) not in page  # reports are mailed


@pytest.fixture(scope="module")
def sizing(tmp_path_factory):
    """The file that the sizing of the shipped example writes."""
    model, mission = (str(path) for path in example_files()["double_octahedral_slew"][:2])
    file = tmp_path_factory.mktemp("sizing") / "sizing.json"
    file.write_text(call("size", model, mission, "--json"), "utf-8")
    return file


@pytest.mark.slow
def test_a_sizing_from_disk(sizing, tmp_path):
    lines = call("report", sizing, "-o", tmp_path, "--no-open", "--no-pdf", "--no-view", "--author", "A. Uthor").splitlines()
    page = (tmp_path / "report.html").read_text("utf-8")
    found, sized = embedded(page), json.loads(sizing.read_text("utf-8"))
    most = max(row["utilisation"] for row in sized["groups"])
    assert lines[0].startswith("Governing: ")
    assert found["worked"][0]["utilisation"] == pytest.approx(most, rel=1e-9)
    assert {row["name"] for row in sized["groups"]} == {row["name"] for row in found["sizing"]["groups"]}
    for words in ("A. Uthor", "Why no smaller tube is sufficient", sized["groups"][2]["tube"], sized["drives"][0]["motor"]):
        assert words in page
    assert set(GroupRow.__slots__) == set(sized["groups"][0])


@pytest.mark.parametrize(
    ("text", "words"), [("{", "cannot be read as JSON"), ("{}", "holds no sizing"), ("[1]", "holds no sizing")]
)
def test_another_file_is_refused(tmp_path, text, words):
    (tmp_path / "x.json").write_text(text)
    with pytest.raises(InputError, match=words):
        report.read_sizing(tmp_path / "x.json")
    with pytest.raises(InputError, match="model of the sizing cannot be read"):
        report.sizing_page({"model": "{}", "runs": []})


def test_unknown_paper_is_refused(tmp_path):
    with pytest.raises(InputError, match="No paper called 'a5'"):
        report.write_document(kt.run(tripod(samples=3)), tmp_path, paper="a5")
