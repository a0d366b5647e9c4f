"""All numbers of a report as plain data at full precision; they are included in the page for programs."""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING, Any

from kinetruss.report.document.checks import mobility_record
from kinetruss.report.document.result import result_lines, warnings
from kinetruss.report.drive_data import drive_spans, limits
from kinetruss.report.mechanism_data import mechanism_record
from kinetruss.report.run_data import (
    closure,
    envelopes,
    plain,
    reactions,
    skins,
    strength,
)
from kinetruss.report.run_summary import known

if TYPE_CHECKING:
    from kinetruss.runs import RunResult


SCHEMA = "kinetruss.report/1"


def document_record(run: RunResult, worked: list[dict[str, Any]]) -> dict[str, Any]:
    """The contents of a report as plain data in SI units; numbers equal those of the results to the last bit.

    worked : its worked calculations as data.

    NaN becomes None, infinity the text ``Infinity``. Only the name of the run folder is included, since reports are sent out.
    """
    text = model_text(run)
    definition = run.definition
    found = known(run) | {
        "schema": SCHEMA,
        "out": None if run.path is None else run.path.resolve().name,
        "dimension": run.model.dim,
        "options": {"analysis": definition.analysis, "stations": definition.stations, "load_cases": list(run.forces)},
        "settings": dict(run.settings),
        "model_sha256": hashlib.sha256(text.encode()).hexdigest(),
        "model": text,
        "mobility": mobility_record(run.model),
        "drives": drive_spans(run),
        "mechanism": mechanism_record(run),
        "envelopes": envelopes(run),
        "reactions": reactions(run),
        "strength": strength(run),
        "skins": skins(run),
        "limits": limits(run),
        "closure": closure(run),
        "warnings": warnings(run),
        "worked": worked,
    }
    whole: dict[str, Any] = plain(found)
    whole["result"] = list(result_lines(run, whole))
    return whole


def model_text(run: RunResult) -> str:
    """The model as in the run folder, byte by byte; its hash is computed from this text."""
    stored = None if run.path is None else run.path / "model.json"
    return stored.read_text("utf-8") if stored is not None and stored.is_file() else run.origin.model_dump_json()
