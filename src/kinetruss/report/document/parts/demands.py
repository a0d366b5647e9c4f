"""Demand and capacity: strength of members, limits of actuators."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, number, quantity
from kinetruss.report.document.parts.words import MOST, at, bars_of, left_out, margin_of, named, share_of, station_of, value_of

if TYPE_CHECKING:
    Record = dict[str, Any]

__all__ = ["drives", "strength"]

SCALE = "Utilisation is demand over capacity, safety factors included; at 100 %, the mark, the limit is reached."
MOTOR = {
    "motor speed": ("motor_speed", "rad/s"),
    "torque": ("motor_torque", "N m"),
    "current": ("current", "A"),
    "voltage": ("voltage", "V"),
    "power": ("electrical_power", "W"),
    "energy drawn": ("drawn_energy", "J"),
}
TORQUES = {
    "moving": "motor_torque",
    "without friction": "motor_torque_frictionless",
    "break-away": "breakaway_torque",
    "holding": "holding_torque",
    "root mean square": "rms_torque",
}


def strength(record: Record) -> list[Markup]:
    """The worst entry of each part, and the entries that were not checked."""
    rows = record["strength"]
    first: dict[str, Record] = {}
    for row in rows:
        if row["utilisation"]:
            first.setdefault(row["part"], row)
    worst = list(first.values())
    heads = ("part", "rule", "", "utilisation", "value", "limit", "margin", "at", "station", "load case")
    shown = worst[:MOST]
    lines = [
        (*_held(row, drawn), at(row["time"]), station_of(row), named(row["load_case"]))
        for row, drawn in zip(shown, bars_of(shown), strict=True)
    ]
    note = f"{left_out(worst)}{SCALE} Station: distance from the member's first end."
    parts = [Table(heads, lines, "Governing rule of each part, worst first", note).html] if lines else []
    if missing := record["not_checked"]:
        told = [(reason, ", ".join(names[:MOST]) + (" .." if len(names) > MOST else "")) for reason, names in missing.items()]
        parts.append(Table(("rule, and what is missing", "parts"), told, "Not checked").html)
    return parts


def drives(record: Record) -> list[Markup]:
    """Demands on actuators and their limits; torques, energies; all exceeded limits."""
    return [*_limits(record["limits"]), *_motors(record["motors"]), *_trains(record["trains"]), *_exceeded(record["exceeded"])]


def _limits(rows: Sequence[Record]) -> list[Markup]:
    held = [row for row in rows if row["utilisation"] is not None]
    if not held:
        return []
    unlimited = sorted({row["rule"] for row in rows if row["utilisation"] is None})
    heads = ("member", "demand", "", "utilisation", "largest", "limit", "margin", "at", "load case")
    shown = held[:MOST]
    lines = [
        (*_held(row, drawn), at(row["time"]), named(row["load_case"])) for row, drawn in zip(shown, bars_of(shown), strict=True)
    ]
    note = left_out(held) + (f"No limit is given for: {', '.join(unlimited)}." if unlimited else "")
    return [Table(heads, lines, "Demands on the actuators against their limits, worst first", note).html]


def _motors(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    heads = ("motor of", "load", *MOTOR, "load case")
    lines = [
        (
            one["active"],
            _load(one),
            *(quantity(value_of(one[key]), unit) for key, unit in MOTOR.values()),
            named(one["load_case"]),
        )
        for one in found[:MOST]
    ]
    return [Table(heads, lines, "Largest demands of the motion, with their signs", left_out(found)).html]


def _load(one: Record) -> str:
    """Thrust of a member, or torque on an angle."""
    turning = one.get("drive_torque") is not None
    return quantity(value_of(one["drive_torque"]), "N m") if turning else quantity(value_of(one["thrust"]), "N")


def _trains(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    heads = ("motor of", *TORQUES, "load case")
    torques = [
        (one["active"], *(quantity(value_of(one[key]), "N m") for key in TORQUES.values()), named(one["load_case"]))
        for one in found[:MOST]
    ]
    more = ("motor of", "energy drawn", "fed back", "gear for top speed", "lead", "self-locking up to", "load case")
    return [
        Table(heads, torques, "Torques at the motor, largest magnitudes", left_out(found)).html,
        Table(more, [_energies(one) for one in found[:MOST]], "Energies, gear and lead", left_out(found)).html,
    ]


def _energies(one: Record) -> tuple[str, ...]:
    energies = (quantity(value_of(one[key]), "J") for key in ("drawn_energy", "returned_energy"))
    leads = (
        "-" if one[key] is None else f"{number(1e3 * value_of(one[key]))} mm/rad"
        for key in ("lead", "largest_self_locking_lead")
    )
    return one["active"], *energies, number(value_of(one["gear_ratio"])), *leads, named(one["load_case"])


def _exceeded(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    lines = [(one["sentence"], named(one["load_case"])) for one in found[:MOST]]
    return [Table(("limit exceeded", "load case"), lines, "Limits of drives exceeded, worst first", left_out(found)).html]


def _held(row: Record, drawn: Markup) -> tuple[Any, ...]:
    """Demand and limit as table cells."""
    used, unit = row["utilisation"], row["unit"]
    value, limit = (quantity(value_of(row[key]), unit) for key in ("value", "limit"))
    return row["part"], row["rule"], drawn, share_of(used), value, limit, margin_of(row)
