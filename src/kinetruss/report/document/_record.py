"""All numbers of a report as plain data at full precision; they are included in the page for programs."""

from __future__ import annotations

import hashlib
import math
from typing import TYPE_CHECKING, Any

from kinetruss.report.document.parts.checks import closure, mobility_record
from kinetruss.report.document.parts.envelope import drive_spans, envelopes, reactions
from kinetruss.report.document.result.lines import result_lines
from kinetruss.report.document.result.warnings import warnings
from kinetruss.report.run_text.drives import drive_loads
from kinetruss.report.run_text.summary import checks, largest_forces, motors, summary_record, worst_rows
from kinetruss.report.run_text.trains import exceeded, trains

if TYPE_CHECKING:
    from kinetruss.results import Row
    from kinetruss.runs import RunResult

__all__ = ["document_record", "model_text", "plain"]

SCHEMA = "kinetruss.report/1"


def document_record(run: RunResult, worked: list[dict[str, Any]]) -> dict[str, Any]:
    """The contents of a report as plain data in SI units; numbers equal those of the results to the last bit.

    worked : its worked calculations as data.

    NaN becomes None, infinity the text ``Infinity``. Only the name of the run folder is included, since reports are sent out.
    """
    text = model_text(run)
    definition = run.definition
    found = summary_record(run) | {
        "schema": SCHEMA,
        "out": None if run.path is None else run.path.resolve().name,
        "dimension": run.model.dim,
        "options": {"analysis": definition.analysis, "stations": definition.stations, "load_cases": list(run.forces)},
        "settings": dict(run.settings),
        "model_sha256": hashlib.sha256(text.encode()).hexdigest(),
        "model": text,
        "mobility": mobility_record(run.model),
        "drives": drive_spans(run),
        "envelopes": envelopes(run),
        "inner": [name for name, bar in run.model.bars.items() if bar.brace],
        "reactions": reactions(run),
        "strength": strength(run),
        "limits": limits(run),
        "closure": closure(run),
        "warnings": warnings(run),
        "worked": worked,
    }
    # in the summary infinite numbers are already None
    found |= {
        "largest_forces": largest_forces(run),
        "worst": [_row(row) for row in worst_rows(run)],
        "motors": motors(run),
        "drive_loads": drive_loads(run, motors(run)),
        "trains": trains(run),
        "exceeded": exceeded(run),
        "checks": checks(run),
    }
    whole: dict[str, Any] = plain(found)
    whole["result"] = list(result_lines(whole))
    return whole


def model_text(run: RunResult) -> str:
    """The model as in the run folder, byte by byte; its hash is computed from this text."""
    stored = None if run.path is None else run.path / "model.json"
    return stored.read_text("utf-8") if stored is not None and stored.is_file() else run.origin.model_dump_json()


def strength(run: RunResult) -> list[dict[str, Any]]:
    """All entries of the verdict, worst first; entries not checked are last, with the missing data."""
    return [] if run.verdict is None else [_row(row) for row in run.verdict.table()]


def limits(run: RunResult) -> list[dict[str, Any]]:
    """Largest demands on the drives compared with their limits, over all load cases, worst first."""
    rows = [
        _row(row) | {"load_case": case}
        for case, demand in run.demand.items()
        if "utilisation" in demand.data
        for row in demand.table()
    ]
    return sorted(rows, key=lambda row: -row["utilisation"] if row["utilisation"] == row["utilisation"] else math.inf)


def _row(row: Row) -> dict[str, Any]:
    return {name: getattr(row, name) for name in row.__slots__}


def plain(value: Any) -> Any:
    """Tables, lists, texts and numbers that JSON can hold."""
    if isinstance(value, dict):
        return {str(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None if math.isnan(value) else "Infinity" if value > 0 else "-Infinity"
    return value
