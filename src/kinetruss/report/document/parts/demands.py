"""Demand and capacity: strength of members, limits of actuators."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table
from kinetruss.report.document.frame import Columns
from kinetruss.report.document.parts.words import MOST, bars_of, is_single, left_out, margin_of, named, percents

if TYPE_CHECKING:
    Record = dict[str, Any]

__all__ = ["drives", "skins", "strength"]

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
    """The worst entry of each part, and the rules that were not checked."""
    first: dict[str, Record] = {}
    for row in record["strength"]:
        if row["utilisation"]:
            first.setdefault(row["part"], row)
    worst = list(first.values())
    if not worst:
        return []
    table = _held(Columns(), "part", worst)
    _times(table, worst, record)
    table.measured("station", [row["position"] for row in worst], "m")
    table.words("load case", [named(row["load_case"]) for row in worst])
    note = f"{SCALE} Station: distance from the member's first end."
    return [table.html("Governing rule of each part, worst first", note)]


def skins(record: Record) -> list[Markup]:
    """The highest stresses of membranes and solids, beside the yield strength of their materials."""
    rows = record["skins"]
    if not rows:
        return []
    shown = rows[:MOST]
    table = Columns().words("part", [row["part"] for row in shown])
    table.together(
        ["highest stress", "yield strength"], [[row[key] for row in shown] for key in ("von_mises", "yield_strength")], "Pa"
    )
    _times(table, shown, record)
    table.words("load case", [named(row["load_case"]) for row in shown])
    table.words("element (from 0), and its nodes", [f"{row['element']}: {', '.join(row['nodes'])}" for row in shown])
    note = f"{left_out(rows)}Not part of the checks: no safety factor is applied, and corners and supports concentrate stress."
    return [table.html("Highest von Mises stress in membranes and solids", note)]


def drives(record: Record) -> list[Markup]:
    """Demands on actuators and their limits; torques, energies; all exceeded limits."""
    return [*_limits(record), *_motors(record["motors"]), *_trains(record["trains"]), *_exceeded(record["exceeded"])]


def _limits(record: Record) -> list[Markup]:
    rows = record["limits"]
    held = [row for row in rows if row["utilisation"] is not None]
    if not held:
        return []
    unlimited = sorted({row["rule"] for row in rows if row["utilisation"] is None})
    shown = held[:MOST]
    table = _held(Columns(), "member", shown)
    _times(table, shown, record)
    table.words("load case", [named(row["load_case"]) for row in shown])
    note = left_out(held) + (f"No limit is given for: {', '.join(unlimited)}." if unlimited else "")
    return [table.html("Demands on the actuators against their limits, worst first", note)]


def _motors(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    shown = found[:MOST]
    table = Columns().words("motor of", [one["active"] for one in shown])
    turning = [one.get("drive_torque") is not None for one in shown]
    units = ["N m" if turns else "N" for turns in turning]
    loads = [one["drive_torque" if turns else "thrust"] for one, turns in zip(shown, turning, strict=True)]
    if len(set(units)) == 1:
        table.measured("torque on the angle" if turning[0] else "thrust", loads, units[0])
    else:
        table.mixed(["load"], [loads], units)
    for head, (key, unit) in MOTOR.items():
        table.measured(head, [one[key] for one in shown], unit)
    table.words("load case", [named(one["load_case"]) for one in shown])
    return [table.html("Largest demands of the motion, with their signs", left_out(found))]


def _trains(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    shown = found[:MOST]
    names, cases = [one["active"] for one in shown], [named(one["load_case"]) for one in shown]
    torques = Columns().words("motor of", names)
    torques.together(list(TORQUES), [[one[key] for one in shown] for key in TORQUES.values()], "N m")
    more = Columns().words("motor of", names)
    energies = [[one[key] for one in shown] for key in ("drawn_energy", "returned_energy")]
    more.together(["energy drawn", "returned"], energies, "J")
    if any(one["gear_ratio"] is not None for one in shown):
        more.measured("gear ratio for top speed", [one["gear_ratio"] for one in shown], "")
    leads = [[None if one[key] is None else 1e3 * one[key] for one in shown] for key in ("lead", "largest_self_locking_lead")]
    more.together(["lead (mm/rad)", "self-locking up to (mm/rad)"], leads, "")
    return [
        torques.words("load case", cases).html("Torques at the motor, largest magnitudes", left_out(found)),
        more.words("load case", cases).html("Energies, gear and lead", left_out(found)),
    ]


def _exceeded(found: Sequence[Record]) -> list[Markup]:
    if not found:
        return []
    lines = [(one["sentence"], named(one["load_case"])) for one in found[:MOST]]
    return [Table(("limit exceeded", "load case"), lines, "Limits of drives exceeded, worst first", left_out(found)).html]


def _held(table: Columns, what: str, rows: Sequence[Record]) -> Columns:
    """Demands and limits: part, rule, bar of utilisation, value, limit, margin."""
    table.words(what, [row["part"] for row in rows]).words("rule", [row["rule"] for row in rows])
    table.words("", bars_of(rows)).words("utilisation (%)", percents(rows))
    values = [[row[key] for row in rows] for key in ("value", "limit")]
    table.mixed(["demand", "allowed"], values, [row["unit"] for row in rows])
    return table.words("margin", [margin_of(row) for row in rows])


def _times(table: Columns, rows: Sequence[Record], record: Record) -> None:
    """The poses of the entries, or their times; nothing for a single position."""
    if any(row.get("pose") for row in rows):
        table.words("pose", [row["pose"] for row in rows])
    elif not is_single(record):
        table.measured("at (s)", [row["time"] for row in rows], "")
