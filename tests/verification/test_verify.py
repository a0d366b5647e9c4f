"""The verification suite: what it reports, what it reads, and that it can fail."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest

import kinetruss as kt
from kinetruss.verification import cases as suite
from kinetruss.verification.cases import Case, Reference, Report, cases, numbers, relative_difference

pytestmark = pytest.mark.slow

KEYS = {
    "id", "class", "source", "note", "inferred", "expected", "computed", "product", "relative_difference", "tolerance",
    "passed",
}  # fmt: skip


known: dict[str, dict[str, float]] = {}


def made(make, arguments):
    """Numbers that are made once, whichever test asks first."""
    call = f"{make}{arguments}"
    if call not in known:
        known[call] = numbers(make, arguments)
    return known[call]


@pytest.fixture(scope="module")
def report() -> Report:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(suite, "numbers", made)
        return kt.verification.verify()


def test_everything_the_library_claims_agrees(report):
    missed = [
        f"{e.id}: {e.computed:.10g} for {e.expected:.10g}, off {e.relative_difference:.2g}"
        for e in report.entries
        if not e.passed
    ]
    assert not missed, "\n".join(missed)


def test_report_as_one_json_object(report):
    found = json.loads(json.dumps(report.as_dict(), allow_nan=False))
    assert set(found) == {"entries", "classes", "verified", "passed", "failed"}
    assert len(found["entries"]) >= 120
    assert all(set(entry) == KEYS for entry in found["entries"])
    assert (found["passed"], found["failed"]) == (len(found["entries"]), 0)
    assert all(isinstance(entry["computed"], float) and isinstance(entry["expected"], float) for entry in found["entries"])


def test_ids_are_unique_and_sources_named(report):
    assert len({entry.id for entry in report.entries}) == len(report.entries)
    assert all(entry.source for entry in report.entries)


@pytest.mark.parametrize(
    ("part", "least"), [("triangle.", 150), ("triangle.table_3_3", 5), ("bay.table_5_", 30), ("bay.T=", 280), ("chain.", 198)]
)
def test_filter_selects_by_id(report, part, least):
    chosen = [entry.id for entry in report.entries if part in entry.id]
    assert len(chosen) >= least
    if least < 10:
        assert [entry.id for entry in kt.verification.verify(filter=part.upper()).entries] == chosen


def test_filter_selects_by_source():
    found = kt.verification.verify(filter="Table 5.5")
    assert {entry.expected for entry in found.entries} == {5.8631, 5.2094, 6.8197}
    nothing = {"entries": [], "classes": {}, "verified": 0, "passed": 0, "failed": 0}
    assert kt.verification.verify(filter="no such thing").as_dict() == nothing


@pytest.mark.parametrize(
    "part",
    [
        "triangle.t=0.3",
        "bay.T=1.t=0.25",
        "chain.t=1.5",
        "bay.table_5_2",
        "pose.",
        "drive.",
        "statics.",
        "rates.",
        "equilibrium.",
        "frequencies.",
        "forward.",
    ],
)
def test_a_wrong_reference_is_seen(part):
    """Each stored value moved by three tolerances is missed: nothing compares with itself."""
    for case in cases():
        if case.id.startswith(part):
            found = made(case.make, case.arguments)
            step = 3 * (case.tolerance or 1e-9) * max(abs(case.expected), case.scale)
            moved = (replace(case, expected=case.expected + sign * step) for sign in (-1, 1))
            assert not all(one.entry(found).passed for one in moved), case.id


def test_relative_difference_is_measured_against_the_vector():
    assert relative_difference(1.0, 1.0) == 0.0
    assert relative_difference(0.0, 0.0) == 0.0
    assert relative_difference(1.1, 1.0, scale=10.0) == pytest.approx(0.01)
    assert relative_difference(30.0, 20.0, scale=10.0) == pytest.approx(0.5)
    assert relative_difference(1e-9, 0.0) == math.inf


def test_a_value_that_is_no_number_fails_and_is_null_in_json():
    entry = Case("id", Reference("closed-form", "source"), 1.0, 1e-8, "", (), "x").entry({"x": math.nan})
    assert not entry.passed
    found = Report((entry,)).as_dict()
    assert found["failed"] == 1
    assert found["entries"][0]["computed"] is None


def test_analyses_are_made_once(monkeypatch):
    calls = []
    monkeypatch.setattr(suite, "numbers", lambda *call: calls.append(call) or numbers(*call))
    found = kt.verification.verify("bay.table_5_2")
    assert len(found.entries) == 14
    assert len(calls) == len({str(call) for call in calls}) < 4
