"""The report of a mission: its envelope, the governing pair with its figure, and worked calculations."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss import runs
from kinetruss.display import Markup, element
from kinetruss.errors import KinetrussError
from kinetruss.report.document._envelopes import envelopes
from kinetruss.report.document._record import document_record, model_text
from kinetruss.report.document.figure import loaded_figure
from kinetruss.report.document.frame import Part, framed
from kinetruss.report.document.frame.title_block import filled
from kinetruss.report.document.parts.constants import section_constants
from kinetruss.report.document.parts.inputs import inputs
from kinetruss.report.document.parts.methods import methods
from kinetruss.report.document.parts.recompute import recompute
from kinetruss.report.document.result.assumptions import assumptions
from kinetruss.report.document.result.lines import governing_entry, result_lines
from kinetruss.report.document.worked import shown, worked, worked_record
from kinetruss.report.missions import TRAIN_UNITS, mission_head, mission_record

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.model import TitleBlock
    from kinetruss.report.document.worked import Sheet
    from kinetruss.runs import MissionRun, RunResult

__all__ = ["mission_html", "mission_lines"]


def mission_html(run: MissionRun, view: str = "", block: TitleBlock | None = None, paper: str = "a4") -> str:
    """The report as HTML with its record; view : a page in three dimensions of the governing pair."""
    record = mission_record(run)
    told = lined(run, record)
    title = run.model.title or f"Mission {run.name}"
    pair = _governing(run, told)
    sheets = [] if pair is None else worked(pair)
    record |= {
        "out": None if run.path is None else run.path.resolve().name,
        "worked": worked_record(sheets),
        "result": list(result_lines(told)),
    }
    mark = "" if run.whole else " (not complete)"
    given = filled(block, run.model.report)
    return framed(
        title,
        given,
        result_lines(told),
        list(_parts(run, pair, sheets, told, view)),
        kicker="Report of a mission",
        quiet=" · ".join(word for word in (mission_head(run).splitlines()[1], given.date) if word),
        record=record,
        foot=f"{title}, mission {run.name}{mark.upper()}",
        paper=paper,
        mark=mark,
    )


def mission_lines(run: MissionRun) -> tuple[str, str, str]:
    """The result of a mission in three lines."""
    return result_lines(lined(run, mission_record(run)))


def lined(run: MissionRun, record: dict[str, Any]) -> dict[str, Any]:
    """What the lines of a result need: entries of members and drives, as in the record of a run."""
    trains = [
        {
            "part": one["active"],
            "rule": one["quantity"],
            "unit": TRAIN_UNITS[one["quantity"]],
            "value": one["value"],
            "limit": one["limit"],
            "utilisation": one["utilisation"],
            "time": one["time_of"],
            "load_case": one["label"],
            "pair": one["pair"],
        }
        for one in record["trains"]
    ]
    return {
        "whole": record["whole"],
        "samples": {"good": record["pairs_done"], "asked": record["pairs_asked"], "what": "pairs"},
        "strength": record["envelope"],
        "limits": trains,
        "not_checked": {} if run.verdict is None else run.verdict.not_checked(),
        "units": _units(run.extremes, "quantity"),
        "largest_forces": [],
        "drive_loads": [],
    }


def _units(data: xr.Dataset, axis: str) -> dict[str, str]:
    """Units by the names along an axis."""
    return dict(zip(map(str, data[axis].values), map(str, data["unit"].values), strict=True)) if axis in data else {}


def _governing(run: MissionRun, told: dict[str, Any]) -> RunResult | None:
    """The pair of the governing entry as a run; None if it cannot be done again."""
    worst = governing_entry(told)
    labels = [str(label) for label in run.pairs["label"].values]
    number = labels.index(worst["load_case"]) if worst is not None and worst["load_case"] in labels else None
    try:
        return runs.governing(run, number)
    except KinetrussError:
        return None


def _parts(run: MissionRun, pair: RunResult | None, sheets: list[Sheet], told: dict[str, Any], view: str) -> Iterator[Part]:
    yield Part("result", "Result", "", list(_state(run)))
    if pair is not None:
        found = assumptions(pair, told)
        yield Part("assumed", "Assumptions, and what was not checked", "What the results rest on", found)
        frame = element("iframe", title="the governing pair", sandbox="allow-scripts", srcdoc=view, loading="lazy")
        seen = [element("div", frame, class_="screen")] if view else []
        words = f"Motion, condition and load case: {_label(run, told)}"
        yield Part("pair", "The governing pair", words, [*seen, *loaded_figure(pair, document_record(pair, []))])
        calculations = "The checks that govern this pair, with the numbers of their instants"
        yield Part("worked", "Worked calculations", calculations, shown(sheets))
    yield from envelopes(told, mission_record(run))
    if pair is not None:
        basis = [*inputs(pair), *section_constants(pair.model)]
        yield Part("inputs", "Basis of the analysis", "The governing pair, and the data of the structure", basis)
        yield Part("method", "Method and sources", "", _methods(pair))
    yield Part("again", "How to repeat the computation", "Versions and the model itself", recompute(run, _provenance(run)))


def _label(run: MissionRun, told: dict[str, Any]) -> str:
    worst = governing_entry(told)
    return str(run.pairs["label"].values[0]) if worst is None else str(worst["load_case"])


def _state(run: MissionRun) -> Iterator[Markup]:
    count = f"{run.good} of {run.samples} pairs of a motion, a condition and a load case are done."
    yield element("p", " ".join(word for word in (count, run.message) if word))
    if run.findings:
        told = [f"{label}: {words}" for label, words in run.findings.items()]
        yield element("div", element("h3", "Findings"), element("ul", [element("li", one) for one in told]), class_="warnings")


def _methods(pair: RunResult) -> list[Markup]:
    return [
        element("p", element("b", f"{name}. "), words, element("cite", f" {source}.") if source else None)
        for name, words, source in methods(pair)
    ]


def _provenance(run: MissionRun) -> dict[str, Any]:
    """What the section on repeating takes from a record."""
    text = model_text(run)
    return {
        "provenance": dict(run.provenance),
        "out": None if run.path is None else run.path.resolve().name,
        "model": text,
        "model_sha256": hashlib.sha256(text.encode()).hexdigest(),
    }
