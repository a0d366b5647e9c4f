"""The summary of a run: status, worst members, motors, and checks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.display import Table, instant, number, quantity
from kinetruss.errors import one_line
from kinetruss.model.data import ELEMENT_FIELDS
from kinetruss.report import mechanism_tables, tables
from kinetruss.report.contents import counted_parts, counts
from kinetruss.report.drive_data import drive_loads, element_loads, exceeded, motors, trains
from kinetruss.report.mechanism_data import deflection_records, quantity_rows
from kinetruss.report.mission_tables import mission_entries, mission_record
from kinetruss.report.page import Page
from kinetruss.report.run_data import WORST, checks, closure, largest_forces, plain, worst
from kinetruss.report.run_lines import simulation_record, statics_lines, statics_record, statics_title
from kinetruss.runs import MissionRun
from kinetruss.runs.doubts import poses_of, remarks

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult


def summary(run: RunResult) -> Page:
    """The summary of a run as a page; of a mission, its envelope.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.summary(kt.run(model))
    >>> page.text.splitlines()[:3]
    ['Four-bar linkage', 'run turn: Completed.', 'verdict: OK; crank, yield: 3.6 % at 0.6083 s']
    """
    if isinstance(run, MissionRun):
        return Page(found=run, as_record=mission_record, as_entries=mission_entries)
    return Page(found=run, as_record=summary_record, as_entries=entries)


def summary_record(run: RunResult) -> dict[str, Any]:
    """The page as plain data (NaN and infinity become None)."""
    found: dict[str, Any] = plain(known(run), None)
    return found


def known(run: RunResult) -> dict[str, Any]:
    """What the page tells, with all numbers as they are."""
    time, engines = run.motion.whole["time"].values, motors(run)
    return {
        "run": run.name,
        "out": None if run.path is None else str(run.path),
        "title": run.model.title,
        "state": run.state,
        "status": run.status.name,
        "sentence": run.status.value,
        "message": run.message,
        "whole": run.whole,
        "samples": {"asked": run.samples, "good": run.good},
        "time": [float(time[0]), float(time[-1])] if len(time) else [],
        "poses": poses_of(run),
        **counts(run.model),
        "verdict": run.finding.record,
        "largest_forces": largest_forces(run),
        "worst": worst(run)[:WORST],
        "not_checked": {} if run.verdict is None else run.verdict.not_checked(),
        "drive_loads": drive_loads(run, engines),
        **{f"{kind}_loads": element_loads(run, kind) for kind in ELEMENT_FIELDS},
        "quantities": quantity_rows(run),
        "deflections": deflection_records(run),
        "motors": engines,
        "trains": trains(run),
        "exceeded": exceeded(run),
        "simulation": simulation_record(run),
        "statics": statics_record(run),
        "checks": checks(run),
        "wall_time": run.wall_time,
        "provenance": dict(run.provenance),
    }


def entries(run: RunResult) -> Iterator[Entry]:
    """What the page says, in its order."""
    timed, engines = run.timed, motors(run)
    yield _head(run)
    yield from tables.simulation(simulation_record(run))
    yield Table(("", ""), statics_lines(run), statics_title(run))
    yield tables.largest_forces(largest_forces(run), timed=timed)
    yield tables.strength(worst(run), "\n".join(_beyond(run)), timed=timed)
    yield tables.not_checked(() if run.verdict is None else run.verdict.not_checked().items())
    yield mechanism_tables.quantities(quantity_rows(run), timed=timed)
    yield mechanism_tables.deflections(deflection_records(run))
    yield tables.drives(drive_loads(run, engines), timed=timed)
    for kind in ELEMENT_FIELDS:
        yield tables.elements(kind, element_loads(run, kind))
    yield tables.motors(engines)
    yield from tables.trains(trains(run))
    yield tables.exceeded(exceeded(run))
    found = checks(run)
    held = (("strength", "not included", words) for words in found["not_held"])
    yield tables.checks(found, closure(run), poses_of(run), *held, forces=bool(run.forces))


def _head(run: RunResult) -> str:
    time = run.motion.whole["time"].values
    poses = poses_of(run)
    span = f", t = {number(time[0])} to {instant(time[-1])}" if len(time) > 1 else ""
    span = f", poses {', '.join(poses)}" if poses else span
    count = "1 sample" if run.samples == 1 else f"{run.samples} samples"
    count = count if run.whole else f"{run.good} of {run.samples} samples are good"
    state = {
        "finished": run.status.value,
        "running": "Still running: this is only a part of the run.",
        "incomplete": f"Incomplete: it was interrupted. Continue with: kinetruss run --resume {run.path}",
    }[run.state]
    lines = [one_line(run.model.title, 200) or "(no title)", f"run {run.name}: {state}"]
    if run.verdict is not None or run.demand:
        lines.append(f"verdict: {run.finding.sentence}")
    lines += [f"warning: {one}" for one in run.finding.doubts]
    if said := remarks(run):
        lines.append(said)
    lines.append(f"{count}{span}; {counted_parts(run.model)}; {quantity(run.wall_time, 's', 3)}")
    return "\n".join(lines)


def _beyond(run: RunResult) -> Iterable[str]:
    """Beam-columns without a finite value: the parts by their reason."""
    found: dict[str, list[str]] = {}
    for row in () if run.verdict is None else run.verdict.table():
        if math.isinf(row.utilisation):
            case = "" if row.load_case == "all" else f", {row.load_case}"
            found.setdefault(f"{row.note.partition(';')[0]}, so beam-column has no finite value{case}", []).append(row.part)
    return (f"{', '.join(parts)}: {words}" for words, parts in found.items())
