"""Worked calculations of a mission: the governing entry of each check over all pairs, each from its own pair."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from kinetruss import runs
from kinetruss.errors import KinetrussError
from kinetruss.report.document.worked.chosen import CHAINED, NEGLIGIBLE, demand_sheet, governing_rows, member_sheet

if TYPE_CHECKING:
    from kinetruss.report.document.worked.sheet import Sheet
    from kinetruss.results import Row
    from kinetruss.runs import MissionRun, RunResult

__all__ = ["Pairs", "worked_pairs"]


class Pairs:
    """Pairs of a mission as runs, each done again once; None for one that cannot be."""

    def __init__(self, mission: MissionRun) -> None:
        self.mission = mission
        self.labels = [str(label) for label in mission.pairs["label"].values]
        self._done: dict[str | None, RunResult | None] = {}

    def of(self, label: str | None) -> RunResult | None:
        """The pair with a label, or the one with the highest utilisation."""
        if label not in self._done:
            try:
                self._done[label] = runs.governing(self.mission, None if label is None else self.labels.index(label))
            except (KinetrussError, ValueError):
                self._done[label] = None
        return self._done[label]


def worked_pairs(pairs: Pairs, given: Mapping[str, Any]) -> list[Sheet]:
    """The calculations, worst first. given : rows of members and drives with the labels of their pairs (`lined`)."""
    found = list(_sheets(pairs, given))
    return sorted(found, key=lambda sheet: -sheet.rank)


def _sheets(pairs: Pairs, given: Mapping[str, Any]) -> Iterator[Sheet]:
    for row in governing_rows(pairs.mission):
        pair = pairs.of(row.load_case)
        own = None if pair is None or pair.verdict is None else _same(pair.verdict.table(), row.part, row.rule)
        sheet = None if pair is None or own is None else member_sheet(pair, own)
        if pair is not None and sheet is not None:
            yield _of_pair(sheet, pair, row.load_case)
    for one in governing_trains(given["limits"]):
        pair = pairs.of(one["load_case"])
        for case, demand in () if pair is None else pair.demand.items():
            own = _same(demand.table(), one["part"], one["rule"])
            sheet = None if pair is None or own is None else demand_sheet(pair, own, case)
            if pair is not None and sheet is not None:
                yield _of_pair(sheet, pair, one["load_case"])


def _of_pair(sheet: Sheet, pair: RunResult, label: str) -> Sheet:
    sheet.pair, sheet.timed = label, pair.good > 1
    return sheet


def governing_trains(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The worst demand on a motor, the worst one of an instant, and the worst stroke, over all pairs."""
    held = [row for row in rows if row["utilisation"] is not None and float(row["utilisation"]) > NEGLIGIBLE]
    held.sort(key=lambda row: -float(row["utilisation"]))
    kinds = (held, [row for row in held if row["rule"] in CHAINED], [row for row in held if row["rule"] == "stroke"])
    return list({(row["part"], row["rule"]): row for kind in kinds for row in kind[:1]}.values())


def _same(rows: list[Row], part: str, rule: str) -> Row | None:
    """The entry of a part by a rule, if it has a demand to work out."""
    return next((row for row in rows if (row.part, row.rule) == (part, rule) and row.utilisation > NEGLIGIBLE), None)
