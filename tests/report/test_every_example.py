"""What is made of stored runs, from their folders on disk: the report of every run of every shipped example, pictures and
all else of one run of each analysis.
"""

from __future__ import annotations

import csv
import html
import json
import re

import numpy as np
import pytest
import xarray as xr
from click.testing import CliRunner

from kinetruss import report, runs, viewer
from kinetruss.cli import main
from kinetruss.report.document import writing as _print
from shipped import ONE_OF_EACH, RUNS, named, stored

every_run = pytest.mark.parametrize(("name", "run"), RUNS, ids=lambda one: one)
each_analysis = pytest.mark.parametrize(("name", "run"), ONE_OF_EACH, ids=lambda one: one)


INNER = re.compile(r"\b(?:actuators|dynamics|flexible|kinematics|statics|strength|runs)\.[a-z_]+|\b(?:[ar]tol|constant_rate)\b")
"""Names of functions and options, which a client does not know."""


def call(*arguments: object) -> str:
    done = CliRunner().invoke(main, [str(one) for one in arguments])
    assert done.exit_code == 0, done.output
    assert done.exception is None
    return done.stdout


def words_of(page: str) -> str:
    """What a reader sees of a page: no scripts, styles, views or tags."""
    kept = re.sub(r"<(script|style|svg|iframe|pre|code)\b.*?</\1>", " ", page, flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]*>", " ", kept))


@pytest.mark.slow
@every_run
def test_report(name, run, tmp_path, request):
    """Drawn for one run of each analysis."""
    if (name, run) not in ONE_OF_EACH:
        request.getfixturevalue("undrawn")
    call("report", stored(name, run), "-o", tmp_path, "--no-open", "--no-pdf")
    page = (tmp_path / "report.html").read_text("utf-8")
    words = words_of(page)
    assert named(words) == ""
    assert INNER.findall(re.sub(r"\(in the model file: [a-z_.]+\)", "", words)) == []
    assert stored_method(name, run) in page
    record = json.loads(re.search(r'id="kinetruss-report">(.*?)</script>', page, re.DOTALL)[1])
    governing = {row["rule"] for row in record["strength"] if row["utilisation"]}
    drives = [row for row in record["limits"] if row["utilisation"]]
    assert {one["rule"] for one in record["worked"]} >= governing
    assert len(record["worked"]) >= len(governing) + bool(drives)
    for one in record["worked"]:  # what a reader can follow is what the run found
        assert one["difference"] < 1e-11, one["title"]


def stored_method(name: str, run: str) -> str:
    """The method of a simulation, of which the page tells; nothing where there is none."""
    simulation = runs.load(stored(name, run)).simulation
    return "" if simulation is None else simulation.data.attrs["method"]


@pytest.mark.slow
@pytest.mark.skipif(_print.chromium() is None, reason="no chromium on this machine (apt-get install chromium)")
def test_report_on_paper(tmp_path):
    name, run = next((name, run) for name, run in RUNS if stored_method(name, run))
    call("report", stored(name, run), "-o", tmp_path, "--no-open", "--no-view")
    assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF-")


@pytest.mark.slow
@every_run
def test_info_and_the_summary(name, run):
    record = json.loads(call("info", stored(name, run), "--json"))
    assert record["whole"] is True
    assert named(call("info", stored(name, run))) == ""


@pytest.mark.slow
@each_analysis
def test_view_and_picture(name, run, tmp_path):
    folder = stored(name, run)
    call("view", folder, "-o", tmp_path / "view.html", "--no-open")
    assert (tmp_path / "view.html").stat().st_size > 100_000
    at = float(runs.load(folder).motion.time[-1])
    known = {one["id"] for one in viewer.scene(runs.load(folder)).header["channels"]}
    for colour in sorted(known & {"force", "stress", "utilisation"}):
        call("picture", folder, "-o", tmp_path / f"{colour}.svg", "--colour", colour, "--at", at, "--ghost")
    call("picture", folder, "-o", tmp_path / "kinds.pdf", "--width", "page")
    for path in tmp_path.glob("*.svg"):
        assert named(words_of(path.read_text("utf-8"))) == ""


@pytest.mark.slow
@each_analysis
def test_plots(name, run, tmp_path):
    found = runs.load(stored(name, run))
    written = report.figures(found, tmp_path)
    assert written
    quantity = "member_force" if found.forces else "position"
    call("plot", stored(name, run), "--quantity", quantity, "-o", tmp_path / "curves.svg")
    assert "nan" not in re.findall(r">([^<]*)<", (tmp_path / "curves.svg").read_text("utf-8"))


@pytest.mark.slow
@each_analysis
def test_every_export(name, run, tmp_path):
    folder = stored(name, run)
    motion = runs.load(folder).motion.data
    for ending in ("csv", "nc", "parquet"):
        call("export", folder, tmp_path / f"run.{ending}")
    with (tmp_path / "run.csv").open(newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    column = next(k for k, one in enumerate(head) if one.startswith("motion.position["))
    np.testing.assert_array_equal([float(row[column]) for row in rows], motion["position"].values[:, 0, 0])
    with xr.open_dataset(tmp_path / "run.nc", group="motion") as back:
        np.testing.assert_array_equal(back["position"], motion["position"])
    assert (tmp_path / "run.parquet").stat().st_size > 1000
    if runs.load(folder).verdict is not None:
        call("export", folder, tmp_path / "verdict.csv", "--group", "verdict")
        assert (tmp_path / "verdict.csv").read_text().startswith("part,rule,unit,value,limit,utilisation")
