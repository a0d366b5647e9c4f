"""A sizing as text and as plain data."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

from kinetruss.design._sizing import DriveRow, GroupRow, Sizing
from kinetruss.display import Table, instant, quantity

__all__ = ["record", "table"]

_GROUPS = (
    "group",
    "members",
    "tube before",
    "tube",
    "mass before",
    "mass",
    "before",
    "after",
    "governed by",
    "one size smaller",
)
_DRIVES = ("drives", "members", "screw", "gear", "motor", "self-locking", "utilisation", "governed by")


def table(sizing: Sizing) -> str:
    """Tubes before and after, masses, governing checks; drives; notes.

    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> text = kt.design.table(kt.design.size(kt.read(model), mission))
    >>> [line.split()[0] for line in text.splitlines()[:5]]
    ['group', 'lower_longerons', 'upper_longerons', 'battens', 'actuators']
    """
    lines = []
    if sizing.groups:
        lines += [Table(_GROUPS, map(_group, sizing.groups)).text, ""]
    if sizing.drives:
        lines += [Table(_DRIVES, map(_drive, sizing.drives)).text, ""]
    before, after, saved = sizing.mass_before, sizing.mass_after, sizing.mass_saved
    share = f" ({quantity(saved / before, '%')})" if before > 0 else ""
    masses = (quantity(one, "kg") for one in (before, after, saved))
    lines.append("Members: {} before, {} after; saved {}{}.".format(*masses, share))
    if sizing.groups:
        passes = f"{sizing.iterations} pass" + ("es" if sizing.iterations != 1 else "")
        lines.append(f"Converged after {passes}: forces of the finished model differ by {sizing.settled:.1e} of the largest.")
    return "\n".join([*lines, *sizing.notes])


def record(sizing: Sizing) -> dict[str, Any]:
    """All values as plain data; NaN and infinity become None. With the sized model, as its file has it, and what it is sized
    for: from this a report can be made (`report.sizing_page`).

    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> found = kt.design.record(kt.design.size(kt.read(model), mission))
    >>> found["groups"][0]["name"], found["mass_after"] < found["mass_before"]
    ('lower_longerons', True)
    """
    return {
        "title": sizing.mission.title,
        "runs": list(sizing.mission.runs or ()),
        "drive_margin": sizing.mission.margin,
        "model": sizing.model.model_dump_json(),
        "provenance": dict(sizing.provenance),
        "mass_before": sizing.mass_before,
        "mass_after": sizing.mass_after,
        "mass_saved": sizing.mass_saved,
        "iterations": sizing.iterations,
        "settled": sizing.settled,
        "groups": [_finite(asdict(row)) for row in sizing.groups],
        "drives": [_finite(asdict(row)) for row in sizing.drives],
        "notes": list(sizing.notes),
    }


def _group(row: GroupRow) -> tuple[str, ...]:
    smaller = "none in the catalogue"
    if row.smaller:
        smaller = f"{row.smaller}: {row.smaller_part} {row.smaller_rule} {quantity(row.smaller_utilisation, '%')}"
    return (
        row.name,
        str(len(row.members)),
        row.tube_before,
        row.tube,
        quantity(row.mass_before, "kg"),
        quantity(row.mass, "kg"),
        quantity(row.utilisation_before, "%"),
        quantity(row.utilisation, "%"),
        _where(row.part, row.rule, row.time, row.load_case),
        smaller,
    )


def _drive(row: DriveRow) -> tuple[str, ...]:
    return (
        row.name,
        str(len(row.members)),
        row.screw or "-",
        row.gear or "-",
        row.motor or "-",
        "yes" if row.self_locking else "no",
        quantity(row.utilisation, "%"),
        _where(row.member, row.quantity, row.time, row.load_case) if row.quantity else "-",
    )


def _where(part: str, rule: str, time: float, case: str) -> str:
    return f"{part} {rule} at {instant(time)} ({case})"


def _finite(row: dict[str, Any]) -> dict[str, Any]:
    """NaN and infinity are not valid JSON."""
    return {name: None if isinstance(value, float) and not math.isfinite(value) else value for name, value in row.items()}
