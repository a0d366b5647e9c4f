"""Worked calculations as part of a page, and as data."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import Any

from kinetruss.display import Markup, Table, element, instant, quantity
from kinetruss.report.document.frame import Columns
from kinetruss.report.document.parts.words import cased, exceeds
from kinetruss.report.document.worked.formulas import valued
from kinetruss.report.document.worked.sheet import Sheet

__all__ = ["shown", "worked_record"]

BESIDE = 6
"""Columns of samples beside each other."""
RESULT = 5
"""Significant digits of a result."""


GIVEN, STEP = 44, 14
"""Characters of a source up to which it stands in the table of what is given, and of steps; longer ones are listed below."""


def shown(sheets: Sequence[Sheet]) -> list[Markup]:
    """Every calculation: where and when, what is given, the steps, and the result beside what is allowed."""
    found: list[Markup] = []
    sources = _Sources()
    for k, sheet in enumerate(sheets, 1):
        name = element("h3", f"Calculation {k}. {sheet.title}")
        when = element("p", _where(sheet), class_="where")
        found += [name, when, _given(sheet, sources), *_samples(sheet), _steps(sheet, sources), *_notes(sheet), _outcome(sheet)]
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


def _given(sheet: Sheet, sources: _Sources) -> Markup:
    rows = [
        (symbol(one.symbol), symbol(one.meaning), valued(one.value, one.unit, sheet.digits), sources.mark(one.source, GIVEN))
        for one in sheet.given
    ]
    return _worked(Table(("symbol", "what is given", "value", "from"), rows, f"{sheet.title}: what is given").html, "given")


def _samples(sheet: Sheet) -> list[Markup]:
    """The samples of an integral, in columns beside each other."""
    if not sheet.samples:
        return []
    rows = -(-len(sheet.samples[0][2]) // BESIDE)
    parts = []
    for name, unit, values in sheet.samples:
        pieces = [values[k : k + rows] for k in range(0, len(values), rows)]
        full = [[*piece, *[None] * (rows - len(piece))] for piece in pieces]
        parts.append(Columns().together([name] * len(full), full, unit))
    table = Columns()
    for k in range(len(parts[0].columns)):
        for one in parts:
            table.words(one.heads[k], one.columns[k])
    return [table.html(f"{sheet.title}: the samples of the integral")]


def _steps(sheet: Sheet, sources: _Sources) -> Markup:
    rows = []
    for one in sheet.steps:
        numbers = "" if one.numbers == valued(one.value, one.unit, sheet.digits) else f" = {one.numbers}"
        line = symbol(f"{one.symbol} = {one.formula}{numbers}")
        rows.append((symbol(one.meaning), line, valued(one.value, one.unit, RESULT), sources.mark(one.source, STEP)))
    heads = ("step", "formula, and the numbers put in", "result", "source")
    return _worked(Table(heads, rows, f"{sheet.title}: calculation").html, "steps")


def _worked(table: Markup, kind: str) -> Markup:
    """The table with a class of its own, for the widths of its columns."""
    return Markup(table.replace('<figure class="table', f'<figure class="table worked {kind}', 1))


def _notes(sheet: Sheet) -> list[Markup]:
    return [element("p", words, class_="note") for words in sheet.notes]


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
