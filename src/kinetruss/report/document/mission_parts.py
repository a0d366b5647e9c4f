"""The parts of a mission's report: members, extremes, drives, motors and pairs, each with the pair that governs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from kinetruss.errors import one_line
from kinetruss.report.document.columns import Columns
from kinetruss.report.document.demands import bars_of, left_out, percents, value_of
from kinetruss.report.document.frame import Part
from kinetruss.report.mission_tables import LONGEST, MOST, Record


def envelopes(entries: Record, record: Record) -> Iterator[Part]:
    """The sections. entries : those of members and motors (`lined`); record : of `mission_record`."""
    yield Part("members", "Members", "Every part by its governing rule and pair", _members(entries["strength"]))
    yield Part(
        "extremes",
        "Extremes of members",
        "Largest tension, compression and bending",
        _extremes(record["extremes"], entries["units"]),
    )
    yield Part("drives", "Drives", "Largest loads, rates and powers", _drives(record["drives"]))
    yield Part("motors", "Motors", "Largest demands, against limits", _motors(entries["limits"]))
    yield Part("pairs", "Pairs", "Motions, conditions and load cases, worst first", _pairs(record["pairs"]))


def _members(rows: Sequence[Record]) -> list[Any]:
    first: dict[str, Record] = {}
    for row in rows:
        if row["utilisation"]:
            first.setdefault(row["part"], row)
    worst = list(first.values())
    return [_limits_table(worst, "part", "Governing rule of each part, worst first")] if worst else []


def _limits_table(every: Sequence[Record], what: str, caption: str) -> Any:
    rows = every[:MOST]
    table = Columns().words(what, [row["part"] for row in rows]).words("rule", [row["rule"] for row in rows])
    table.words("", bars_of(rows)).words("utilisation (%)", percents(rows))
    table.mixed(
        ["demand", "allowed"], [[row[key] for row in rows] for key in ("value", "limit")], [row["unit"] for row in rows]
    )
    table.measured("at (s)", [row["time"] for row in rows], "")
    return table.words("governing pair", [row["load_case"] for row in rows]).html(caption, left_out(every))


def _motors(rows: Sequence[Record]) -> list[Any]:
    held = sorted((row for row in rows if row["utilisation"] is not None), key=lambda row: -value_of(row["utilisation"]))
    found = [_limits_table(held, "motor of", "Demands on the motors against their limits, worst first")] if held else []
    rest = [row for row in rows if row["utilisation"] is None and row["value"]]
    if rest:
        shown = _largest(rest, "rule")
        table = Columns().words("motor of", [row["part"] for row in shown]).words("demand", [row["rule"] for row in shown])
        table.mixed(["largest"], [[row["value"] for row in shown]], [row["unit"] for row in shown])
        table.words("governing pair", [row["load_case"] for row in shown])
        found.append(table.html("Demands on the motors without a limit, the largest of each quantity", _more(shown, rest)))
    return found


def _largest(rows: Sequence[Record], key: str = "quantity") -> list[Record]:
    """The largest few rows of each quantity."""
    found: dict[str, list[Record]] = {}
    for row in sorted(rows, key=lambda row: -value_of(row["value"])):
        found.setdefault(row[key], []).append(row)
    return [row for name in sorted(found) for row in found[name][: max(1, MOST // (2 * len(found)))]]


def _more(shown: Sequence[Record], every: Sequence[Record]) -> str:
    left = len(every) - len(shown)
    return f"{left} more are in the data of this page." if left else ""


def _extremes(every: Sequence[Record], units: Mapping[str, str]) -> list[Any]:
    known = [row for row in every if row["value"] is not None and value_of(row["value"]) > 0]
    if not known:
        return []
    rows = _largest(known)
    table = Columns().words("part", [row["part"] for row in rows]).words("extreme", [row["quantity"] for row in rows])
    table.mixed(["largest"], [[row["value"] for row in rows]], [units[row["quantity"]] for row in rows])
    table.measured("at (s)", [row["time_of"] for row in rows], "").measured(
        "from end A", [row["position"] for row in rows], "m"
    )
    return [
        table.words("governing pair", [row["label"] for row in rows]).html(
            "Extremes of members, the largest of each quantity", _more(rows, known)
        )
    ]


def _drives(every: Sequence[Record]) -> list[Any]:
    known = [row for row in every if row["value"] is not None and value_of(row["value"]) > 0]
    if not known:
        return []
    rows = _largest(known)
    table = Columns().words("drive", [row["drive"] for row in rows]).words("demand", [row["quantity"] for row in rows])
    table.mixed(["largest"], [[row["value"] for row in rows]], [row["unit"] for row in rows])
    table.measured("at (s)", [row["time_of"] for row in rows], "")
    return [
        table.words("governing pair", [row["label"] for row in rows]).html(
            "Demands on the drives, the largest of each quantity", _more(rows, known)
        )
    ]


def _pairs(every: Sequence[Record]) -> list[Any]:
    rows = sorted(every, key=lambda row: -value_of(row["utilisation"]) if row["utilisation"] is not None else 1.0)[:MOST]
    table = Columns().words("pair", [row["label"] for row in rows])
    table.words("utilisation (%)", percents(rows))
    table.words("part", [row["part"] for row in rows]).words("rule", [row["rule"] for row in rows])
    table.measured("at (s)", [row["time"] for row in rows], "")
    table.measured("samples", [row["samples"] for row in rows], "")
    if any(row["finding"] for row in rows):
        table.words("note", [one_line(row["finding"], LONGEST) for row in rows])
    return [table.html("Pairs, by their highest utilisation of a member", left_out(every))]
