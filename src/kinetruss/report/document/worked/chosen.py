"""Which entries of a run are worked out: the governing one of each rule, and of the drives."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from kinetruss.report.along import only
from kinetruss.report.document.worked.columns import beam_column_sheet, buckling_sheet
from kinetruss.report.document.worked.drives import drive_sheet
from kinetruss.report.document.worked.place import sample_of
from kinetruss.report.document.worked.sheet import Sheet
from kinetruss.report.document.worked.stress import beam_yield_sheet, yield_sheet

if TYPE_CHECKING:
    from collections.abc import Iterator

    from kinetruss.results import Row
    from kinetruss.runs import RunResult

__all__ = ["worked"]

NEGLIGIBLE = 1e-9
"""Utilisation below which an entry has no demand to work out."""
CHAINED = ("voltage", "current", "torque", "speed", "input")
"""Demands that are worked from the load of the drive, step by step."""
WORKS = {"yield": yield_sheet, "buckling": buckling_sheet, "beam-column": beam_column_sheet}


def worked(run: RunResult) -> list[Sheet]:
    """The calculations of the governing entry of each rule and of the governing demands on drives, worst first."""
    found = [sheet for row in governing_rows(run) if (sheet := member_sheet(run, row)) is not None]
    found += [sheet for row, case in governing_demands(run) if (sheet := demand_sheet(run, row, case)) is not None]
    for sheet in found:
        sheet.timed = run.good > 1
    return sorted(found, key=lambda sheet: -sheet.rank)


def governing_rows(run: RunResult) -> Iterator[Row]:
    """The worst entry of each rule of the verdict."""
    seen: set[str] = set()
    for row in () if run.verdict is None else run.verdict.table():
        if row.checked and row.utilisation > NEGLIGIBLE and row.rule not in seen:
            seen.add(row.rule)
            yield row


def governing_demands(run: RunResult) -> Iterator[tuple[Row, str]]:
    """The worst demand on a drive over all load cases, and the worst one of an instant, with their load cases."""
    rows = [(row, case) for case, demand in run.demand.items() if "utilisation" in demand.data for row in demand.table()]
    held = sorted(
        (one for one in rows if one[0].checked and one[0].utilisation > NEGLIGIBLE), key=lambda one: -one[0].utilisation
    )
    yield from held[:1]
    # a stroke or a root mean square does not tell of the train: the worst demand of an instant does
    if held and held[0][0].rule not in CHAINED:
        yield from [one for one in held if one[0].rule in CHAINED][:1]


def member_sheet(run: RunResult, row: Row) -> Sheet | None:
    """The calculation of an entry of the verdict; None if its forces are not in the run."""
    forces = run.forces.get(row.load_case)
    sample = None if forces is None else sample_of(forces, row)
    if forces is None or sample is None:
        return None
    work = beam_yield_sheet if row.part in run.model.beams else WORKS[row.rule]
    return work(run.model, only(forces, sample), row)


def demand_sheet(run: RunResult, row: Row, case: str) -> Sheet | None:
    """The calculation of an entry of a demand table."""
    return drive_sheet(run.model, run.forces[case].motion, run.demand[case], replace(row, load_case=case))
