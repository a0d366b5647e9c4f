"""Worked calculations: which entries are worked out, as part of a page and as data; those of a mission."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from kinetruss import runs
from kinetruss.display import Markup, Table, element, instant, quantity
from kinetruss.display.ranks import largest_first
from kinetruss.display.tables import Column, measured
from kinetruss.errors import KinetrussError
from kinetruss.report.document.places import sample_of
from kinetruss.report.document.sheets import Sheet, valued
from kinetruss.report.document.worked_drives import drive_sheet
from kinetruss.report.document.worked_members import (
    beam_column_sheet,
    beam_yield_sheet,
    buckling_sheet,
    link_beam_column_sheet,
    link_buckling_sheet,
    yield_sheet,
)
from kinetruss.report.tables import cased
from kinetruss.results.wide_tables import exceeds
from kinetruss.strength.curves import only

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.results import Row
    from kinetruss.runs import MissionRun, RunResult


NEGLIGIBLE = 1e-9
"""Utilisation below which an entry has no demand to work out."""
CHAINED = ("voltage", "current", "torque", "speed", "input")
"""Demands that are worked from the load of the drive, step by step."""
WORKS = {"yield": yield_sheet, "buckling": buckling_sheet, "beam-column": beam_column_sheet}
OF_BENDING = {"yield": beam_yield_sheet, "buckling": link_buckling_sheet, "beam-column": link_beam_column_sheet}
"""The same of beams and links."""


def worked(run: RunResult) -> list[Sheet]:
    """The calculations of the governing entry of each rule and of the governing demands on drives, worst first."""
    found = [sheet for row in governing_rows(run) if (sheet := member_sheet(run, row)) is not None]
    found += [sheet for row, case in governing_demands(run) if (sheet := demand_sheet(run, row, case)) is not None]
    for sheet in found:
        sheet.timed = run.good > 1
    return largest_first(found, lambda sheet: sheet.rank)


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
    work = (OF_BENDING if row.part in run.model.bending else WORKS)[row.rule]
    return work(run.model, only(forces, sample), row)


def demand_sheet(run: RunResult, row: Row, case: str) -> Sheet | None:
    """The calculation of an entry of a demand table."""
    return drive_sheet(run.model, run.forces[case].motion, run.demand[case], replace(row, load_case=case))


# Worked calculations as part of a page, and as data.

BESIDE = 6
"""Columns of samples beside each other."""
RESULT = 5
"""Significant digits of a result."""


GIVEN, STEP = 44, 14
"""Characters of a source up to which it stands in the table of what is given, and of steps; longer ones are listed below."""


def shown(sheets: Sequence[Sheet]) -> list[Entry]:
    """Every calculation: where and when, what is given, the steps, and the result beside what is allowed."""
    found: list[Entry] = []
    sources = _Sources()
    for k, sheet in enumerate(sheets, 1):
        name = element("h3", f"Calculation {k}. {sheet.title}")
        when = element("p", _where(sheet), class_="where")
        notes = [element("p", words, class_="note") for words in sheet.notes]
        found += [name, when, _given(sheet, sources), *_samples(sheet), _steps(sheet, sources), *notes, _outcome(sheet)]
    return [*found, *sources.listed()]


class _Sources:
    """Numbers of sources, in the order in which they are used."""

    def __init__(self) -> None:
        self.known: list[str] = []

    def mark(self, source: str, longest: int) -> str:
        """A short source as it is, a long one as its number."""
        if len(source) <= longest:
            return source
        if source not in self.known:
            self.known.append(source)
        return f"[{self.known.index(source) + 1}]"

    def listed(self) -> list[Markup]:
        """The list of sources; nothing without any."""
        if not self.known:
            return []
        rows = [element("li", f"[{k}] {text}") for k, text in enumerate(self.known, 1)]
        return [element("p", "Sources of the calculations:", class_="where"), element("ul", rows, class_="sources")]


def worked_record(sheets: Sequence[Sheet]) -> list[dict[str, Any]]:
    """The calculations as plain data, SI."""
    return [
        {
            "title": sheet.title,
            "part": sheet.row.part,
            "rule": sheet.row.rule,
            "load_case": sheet.row.load_case,
            "pair": sheet.pair,
            "given": [
                {"symbol": one.symbol, "meaning": one.meaning, "value": one.value, "unit": one.unit} for one in sheet.given
            ],
            "steps": [
                {"symbol": one.symbol, "formula": one.formula, "numbers": one.numbers, "value": one.value, "unit": one.unit}
                for one in sheet.steps
            ],
            "value": sheet.demand,
            "limit": sheet.capacity,
            "utilisation": sheet.values["u"],
            "difference": sheet.difference,
        }
        for sheet in sheets
    ]


def _where(sheet: Sheet) -> str:
    """Instant or pose, load case and place of an entry."""
    row = sheet.row
    words = [f"pair {sheet.pair}"] if sheet.pair else []
    if row.pose:
        words.append(f"pose {row.pose}")
    elif math.isnan(row.time):
        words.append("over the whole run")
    elif sheet.timed:
        words.append(f"at t = {instant(row.time)}")
    if row.load_case and not sheet.pair:
        words.append(cased(row.load_case))
    if not math.isnan(row.position):
        words.append(f"{quantity(row.position, 'm')} from end A of the member")
    text = ", ".join(words)
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _given(sheet: Sheet, sources: _Sources) -> Table:
    rows = [
        (symbol(one.symbol), symbol(one.meaning), valued(one.value, one.unit, sheet.digits), sources.mark(one.source, GIVEN))
        for one in sheet.given
    ]
    heads = ("symbol", "what is given", "value", "from")
    return Table(heads, rows, f"{sheet.title}: what is given", style="worked given")


def _samples(sheet: Sheet) -> list[Table]:
    """The samples of an integral, in columns beside each other."""
    if not sheet.samples:
        return []
    count = len(sheet.samples[0][2])
    rows = -(-count // BESIDE)

    def column(name: str, unit: str, values: Sequence[float], begin: int) -> Column:
        return measured(name, lambda k: values[begin + k] if begin + k < count else None, unit, group=name)

    columns = [column(*one, begin) for begin in range(0, count, rows) for one in sheet.samples]
    return [Table(columns, range(rows), f"{sheet.title}: the samples of the integral")]


def _steps(sheet: Sheet, sources: _Sources) -> Table:
    rows = []
    for one in sheet.steps:
        numbers = "" if one.numbers == valued(one.value, one.unit, sheet.digits) else f" = {one.numbers}"
        line = symbol(f"{one.symbol} = {one.formula}{numbers}")
        rows.append((symbol(one.meaning), line, valued(one.value, one.unit, RESULT), sources.mark(one.source, STEP)))
    heads = ("step", "formula, and the numbers put in", "result", "source")
    return Table(heads, rows, f"{sheet.title}: calculation", style="worked steps")


def _outcome(sheet: Sheet) -> Markup:
    """The result, and whether the run says the same."""
    row = sheet.row
    value, limit = valued(sheet.demand, row.unit), valued(sheet.capacity, row.unit)
    used = quantity(sheet.values["u"], "%")
    state = "exceeded" if exceeds(sheet.values["u"]) else "satisfied"
    words = f"Result: {value} of {limit} allowed, utilisation {used}: {state}. "
    if math.isinf(sheet.values["u"]):
        words = "Result: no finite utilisation: exceeded. "
    if sheet.agrees:
        return element("p", words, "The run has the same values.", class_="outcome")
    own = f"{valued(row.value, row.unit)} of {valued(row.limit, row.unit)}"
    apart = f"The run has {own}, utilisation {quantity(row.utilisation, '%')}."
    return element("p", words, element("strong", f"{apart} The two differ: clarify this before use."), class_="outcome alarm")


def symbol(text: str) -> Markup:
    """Text with its subscripts; numbers keep together with their units."""
    whole = re.sub(r"(?<=[\d¹²³⁴⁵⁶⁷⁸⁹⁰]) (?=[A-Za-zµ])|(?<=[NVAs]) (?=(?:m|s|m²)(?![A-Za-z]))", "\u00a0", text)
    escaped = str(element("b", whole))[3:-4]
    return Markup(re.sub(r"(\w′?)_([A-Za-z0-9,]+)", r"\1<sub>\2</sub>", escaped))


# Worked calculations of a mission: the governing entry of each check over all pairs, each from its own pair.


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
    return largest_first(found, lambda sheet: sheet.rank)


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
    held = largest_first(held, lambda row: float(row["utilisation"]))
    kinds = (held, [row for row in held if row["rule"] in CHAINED], [row for row in held if row["rule"] == "stroke"])
    return list({(row["part"], row["rule"]): row for kind in kinds for row in kind[:1]}.values())


def _same(rows: list[Row], part: str, rule: str) -> Row | None:
    """The entry of a part by a rule, if it has a demand to work out."""
    return next((row for row in rows if (row.part, row.rule) == (part, rule) and row.utilisation > NEGLIGIBLE), None)
