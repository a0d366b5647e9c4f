"""The result in three lines: what governs, whether a limit is exceeded, and what was checked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinetruss.display import counted, instant, quantity
from kinetruss.report.document.parts.words import cased, is_over, is_single, used_of, value_of

__all__ = ["governing_entry", "result_lines", "unchecked"]


def result_lines(record: Mapping[str, Any]) -> tuple[str, str, str]:
    """Three lines of a report, from its record: the governing member or drive first."""
    return _governing(record), _limits(record), _checked(record)


def governing_entry(record: Mapping[str, Any]) -> dict[str, Any] | None:
    """The entry of highest utilisation of members and drives; None if no limit was checked."""
    # entries of strength are worst first, a finite number before one that has none
    held = [row for row in (*record["strength"][:1], *record["limits"]) if row["utilisation"] is not None]
    return max(held, key=lambda row: value_of(row["utilisation"]), default=None)


def _governing(record: Mapping[str, Any]) -> str:
    count = record["samples"]
    part = f"{count['good']} of {count['asked']} {count.get('what', 'samples')}"
    begin = "" if record["whole"] else f"Not complete ({part}). "
    worst = governing_entry(record)
    if worst is None:
        return f"{begin}No limit was checked. {_largest(record)}".strip()
    drive = worst in record["limits"]
    what = f"{worst['rule']} of {'the drive of ' if drive else ''}{worst['part']}"
    when = ""
    if worst.get("pose"):
        when = f"pose {worst['pose']}"
    elif worst["time"] is not None and not is_single(record):
        when = f"t = {instant(worst['time'])}"
    case = ""
    if worst["load_case"]:
        case = f"pair {worst['load_case']}" if count.get("what") == "pairs" else cased(worst["load_case"])
    place = ", ".join(words for words in (when, case) if words)
    amounts = ""
    if worst["unit"]:
        value, limit = (quantity(value_of(worst[key]), worst["unit"]) for key in ("value", "limit"))
        amounts = f": {value} of {limit}"
    return f"{begin}Governing: {what}, {used_of(worst['utilisation'])}{amounts}{f' ({place})' if place else ''}."


def _largest(record: Mapping[str, Any]) -> str:
    """The largest force of a member or drive, where nothing was checked."""
    for one in record["largest_forces"][:1]:
        kind = "tension" if one["force"] > 0 else "compression"
        return f"Largest member force: {quantity(abs(one['force']), 'N')} ({kind}, {one['member']})."
    loads = [one for one in record["drive_loads"] if one["load"]]
    if loads:
        most = max(loads, key=lambda one: abs(one["load"]))
        return f"Largest load of a drive: {quantity(abs(most['load']), most['unit'])} ({most['drive']})."
    for one in record.get("skins", [])[:1]:
        return f"Highest stress: {quantity(one['von_mises'], 'Pa')} (von Mises, {one['part']})."
    return ""


def _limits(record: Mapping[str, Any]) -> str:
    held = [row for row in (*record["strength"], *record["limits"]) if row["utilisation"] is not None]
    over = sum(map(is_over, held))
    scope = "" if record["whole"] else " in the part that was computed"
    if not held:
        return "No limit was checked: strengths of members and limits of drives are not known here."
    if over:
        return f"{over} of {counted(len(held), 'limit')} that were checked {'is' if over == 1 else 'are'} exceeded{scope}."
    return f"None of the {counted(len(held), 'limit')} that were checked is exceeded{scope}."


def unchecked(record: Mapping[str, Any]) -> tuple[list[str], int]:
    """Parts with a rule that was not checked, and the number of all parts."""
    parts = list(dict.fromkeys(row["part"] for row in record["strength"]))
    left = dict.fromkeys(part for names in record["not_checked"].values() for part in names)
    return list(left), len(parts)


def _checked(record: Mapping[str, Any]) -> str:
    left, count = unchecked(record)
    if not count:
        return "Strength was not checked: the run has no strength check."
    if left:
        return f"Strength not fully checked: {len(left)} of {counted(count, 'part')} ({', '.join(left)})."
    without = ", without every action" if record["checks"]["not_held"] else ""
    return f"Strength checked by every rule: {'all ' if count > 1 else ''}{counted(count, 'part')}{without}."
