"""All numbers of a report as plain data at full precision; they are included in the page for programs."""

from __future__ import annotations

import hashlib
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.report.document.checks import closure, mobility_record
from kinetruss.report.document.demands import drive_spans, envelopes, reactions
from kinetruss.report.document.result import result_lines, warnings
from kinetruss.report.run_summary import checks, largest_forces, motors, summary_record, worst_rows
from kinetruss.report.run_tables import drive_loads, exceeded, trains
from kinetruss.strength import elements
from kinetruss.strength.findings import demands

if TYPE_CHECKING:
    from kinetruss.results import Row
    from kinetruss.runs import RunResult


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
        "skins": skins(run),
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
    whole["result"] = list(result_lines(run, whole))
    return whole


def model_text(run: RunResult) -> str:
    """The model as in the run folder, byte by byte; its hash is computed from this text."""
    stored = None if run.path is None else run.path / "model.json"
    return stored.read_text("utf-8") if stored is not None and stored.is_file() else run.origin.model_dump_json()


def strength(run: RunResult) -> list[dict[str, Any]]:
    """All entries of the verdict, worst first; entries not checked are last, with the missing data."""
    return [] if run.verdict is None else [_row(row) for row in run.verdict.table()]


def skins(run: RunResult) -> list[dict[str, Any]]:
    """Highest von Mises stress (Pa) of each membrane and solid and load case, its element (from 0) and nodes, its time (s), and
    the yield strength of the material, highest first. They are not part of the verdict. Only of positions that loads deform.
    """
    found = []
    for name, record in (run.model.membranes | run.model.solids).items() if run.good else ():
        material = run.model.material_of(record)
        for case, result in _deformed(run).items():
            data = elements(run.model, result, name)["von_mises"]
            stress = data.max([one for one in data.dims if one not in ("time", "element")]).transpose("element", ...)
            at = np.unravel_index(int(np.nanargmax(stress.values)), stress.shape)
            entry = {
                "part": name,
                "load_case": case,
                "von_mises": float(stress.values[at]),
                "element": int(at[0]),
                "nodes": [str(record.nodes[k]) for k in np.asarray(record.elements)[at[0]]],
                "time": float(run.motion.data["time"].values[at[1]]) if stress.ndim > 1 else 0.0,
                "yield_strength": None if material is None else getattr(material, "yield_strength", None),
            }
            found.append(entry)
    return sorted(found, key=lambda one: -one["von_mises"])


def _deformed(run: RunResult) -> dict[str, Any]:
    """Results by load case whose positions or displacements are those under load."""
    if run.simulation is not None:
        return {next(iter(run.forces), ""): run.simulation}
    return {case: one for case, one in run.statics.items() if {"displacement", "position"} & set(one.data)}


def limits(run: RunResult) -> list[dict[str, Any]]:
    """Largest demands on the drives compared with their limits, over all load cases, worst first."""
    rows = demands(run.demand)
    return [_row(row) for row in sorted(rows, key=lambda row: -row.utilisation if row.checked else math.inf)]


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
