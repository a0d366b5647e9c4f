"""The report of a mission: its envelope, the governing pair with its figure, and worked calculations."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, counted, element
from kinetruss.report.document.checks import recompute
from kinetruss.report.document.data import document_record, model_text
from kinetruss.report.document.figure import loaded_figure
from kinetruss.report.document.frame import framed, summary_parts
from kinetruss.report.document.inputs import inputs, lists, section_constants, worded
from kinetruss.report.document.result import assumptions, checked_words, result_lines
from kinetruss.report.document.run_pictures import diagrams_of
from kinetruss.report.document.sections import method
from kinetruss.report.document.worked import Pairs, shown, worked_pairs, worked_record
from kinetruss.report.entries import Section
from kinetruss.report.mission_tables import lined, mission_record, mission_tables
from kinetruss.report.run_data import plain

if TYPE_CHECKING:
    from kinetruss.report.document.sheets import Sheet
    from kinetruss.report.document.title_block import Front
    from kinetruss.runs import MissionRun, RunResult


ENVELOPES = {
    "members": ("Members", "Every part by its governing rule and pair"),
    "extremes": ("Extremes of members", "Largest tension, compression and bending"),
    "drives": ("Drives", "Largest loads, rates and powers"),
    "motors": ("Motors", "Largest demands, against limits"),
    "pairs": ("Pairs", "Motions, conditions and load cases, worst first"),
}
"""Sections of the tables of a mission: names, and the sentences that introduce them."""


def mission_html(run: MissionRun, front: Front) -> str:
    """The report as HTML with its record; the view of the front is that of the governing pair."""
    record = mission_record(run)
    entries = lined(run, record)
    title = run.model.title or f"Mission {run.name}"
    pairs = Pairs(run)
    # The pair of the governing entry as a run; None if it cannot be done again.
    worst = run.finding.governing
    pair = pairs.of(worst.load_case if worst is not None and worst.load_case in pairs.labels else None)
    sheets = worked_pairs(pairs, entries)
    record |= {
        "out": None if run.path is None else run.path.resolve().name,
        "worked": worked_record(sheets),
        "result": list(result_lines(run, entries)),
    }
    mark = "" if run.whole else " (not complete)"
    version = f"kinetruss {run.provenance.get('kinetruss', '')}".strip()
    return framed(
        title,
        front,
        record["result"],
        _short(run, pair, sheets, entries) if front.summary else list(_parts(run, pair, sheets, entries, front.view)),
        kicker="Report of a mission",
        quiet=" · ".join(
            word for word in (f"Mission {run.name}", counted(run.good, "pair"), version, front.block.date) if word
        ),
        record=plain(record),
        foot=f"{title}, mission {run.name}{mark.upper()}",
        mark=mark,
    )


def mission_lines(run: MissionRun) -> tuple[str, str, str]:
    """The result of a mission in three lines."""
    return result_lines(run, lined(run, mission_record(run)))


def _short(run: MissionRun, pair: RunResult | None, sheets: list[Sheet], entries: dict[str, Any]) -> list[Section]:
    """The sections of a summary: the figure is that of the governing pair."""
    figure = [] if pair is None else loaded_figure(pair, document_record(pair, []), small=True)
    assumed = [] if pair is None else assumptions(pair, entries, run.finding, condition=False)
    words = f"The governing pair of a motion, a condition and a load case: {_label(run)}"
    return summary_parts(list(_state(run)), figure, sheets, assumed, words)


def _parts(
    run: MissionRun, pair: RunResult | None, sheets: list[Sheet], entries: dict[str, Any], view: str
) -> Iterator[Section]:
    yield Section("result", "Result", "", list(_state(run)))
    if pair is not None:
        found = assumptions(pair, entries, run.finding, condition=False)
        yield Section("assumed", "Assumptions, and what was not checked", "What the results rest on", found)
        frame = element("iframe", title="the governing pair", sandbox="allow-scripts", srcdoc=view, loading="lazy")
        seen = [element("div", frame, class_="screen")] if view else []
        words = f"Motion, condition and load case: {_label(run)}"
        own = document_record(pair, [])
        yield Section("pair", "The governing pair", words, [*seen, *loaded_figure(pair, own), *diagrams_of(pair, own)])
    calculations = "The governing entry of each check over all pairs, with the numbers of its pair at its instant"
    yield Section("worked", "Worked calculations", calculations, shown(sheets))
    tables = mission_tables(run, mission_record(run), entries["limits"], findings(run))
    yield from (Section(key, *named, tables[key]) for key, named in ENVELOPES.items())
    if pair is not None:
        name = f"mission {run.name}, pair {_label(run)}"
        basis = [*inputs(pair, name), *_conditions(run), *lists(pair.model), *section_constants(pair.model)]
        yield Section("inputs", "Basis of the analysis", "The governing pair, and the data of the structure", basis)
        yield Section("method", "Method and sources", "", method(pair))
    yield Section("again", "How to repeat the computation", "Versions and the model itself", recompute(run, _provenance(run)))


def _conditions(run: MissionRun) -> list[Table]:
    """The conditions of the mission."""
    named = run.definition.conditions or ()
    rows = [
        (name, worded(run.model.conditions[name]) or "the model as it is") for name in named if name in run.model.conditions
    ]
    return [Table(("condition", "what changes"), rows, "Conditions of the mission")]


def _label(run: MissionRun) -> str:
    worst = run.finding.governing
    return str(run.pairs["label"].values[0]) if worst is None else worst.load_case


def _state(run: MissionRun) -> Iterator[Markup]:
    count = f"{run.good} of {run.samples} pairs of a motion, a condition and a load case are done."
    yield element("p", " ".join(word for word in (count, run.message) if word))
    said = [checked_words(one, run.trains is not None) for one in run.doubts]
    if items := [element("li", one) for one in said if not one.endswith(":")]:
        yield element("div", element("h3", "Findings"), element("ul", items), class_="warnings")


def findings(run: MissionRun) -> dict[str, str]:
    """Findings by pair, without what the motion alone did not check of motors, since the mission does."""
    entries = {label: checked_words(words, run.trains is not None) for label, words in run.findings.items()}
    return {label: words for label, words in entries.items() if words}


def _provenance(run: MissionRun) -> dict[str, Any]:
    """What the section on repeating takes from a record."""
    text = model_text(run)
    return {
        "provenance": dict(run.provenance),
        "out": None if run.path is None else run.path.resolve().name,
        "model": text,
        "model_sha256": hashlib.sha256(text.encode()).hexdigest(),
    }
