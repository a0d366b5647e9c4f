"""Minima and maxima over a run, demand and capacity, and the text of table cells."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence, Sized
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Markup, Table, instant, margin, quantity
from kinetruss.model import turns
from kinetruss.model.beam_frames import FRAME, shown_kinds, shown_names
from kinetruss.report.document.columns import Columns, bar
from kinetruss.results.wide_tables import exceeds
from kinetruss.strength.beam_verdict import middle_forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]
    Record = dict[str, Any]


MOST = 40
"""Largest number of rows of a table; the data in the page have all."""
BEYOND = 1.5
ROUND_OFF = 1e-9
"""Utilisation below which it counts as zero; excess over a limit, and margin, that count as none."""


def named(case: str) -> str:
    """A load case as text."""
    return "all loads" if case == "all" else case


def cased(case: str) -> str:
    """A load case within a sentence."""
    return "all loads" if case == "all" else f"load case {case}"


def percents(rows: Iterable[dict[str, Any]], key: str = "utilisation") -> list[str]:
    """Utilisations of a column as percentages, all with one decimal."""
    shares = [value_of(row[key]) for row in rows]
    return ["-" if math.isnan(one) else "∞" if math.isinf(one) else f"{100 * one:.1f}" for one in shares]


def is_single(record: Mapping[str, Any]) -> bool:
    """True for results of one position: they have no times."""
    return bool(record["samples"]["good"] == 1 and "what" not in record["samples"])


def at(time: float | None) -> str:
    """An instant as text."""
    return instant(time)


def value_of(value: Any) -> float:
    """A number from a record: NaN for None, infinity for its text."""
    return math.nan if value is None else float(value)


def share_of(value: Any) -> str:
    """A utilisation as text."""
    share = value_of(value)
    return quantity(0.0 if abs(share) < ROUND_OFF else share, "%")


def used_of(value: Any) -> str:
    """A utilisation within a sentence."""
    return f"{share_of(value)} of what is allowed"


def margin_of(row: dict[str, Any]) -> str:
    """A margin as text, if there is a demand."""
    used = value_of(row["utilisation"])
    if used < ROUND_OFF or math.isinf(used):
        return "-"
    left = value_of(row["margin"])
    return margin(0.0 if abs(left) < ROUND_OFF else left)


def is_over(row: dict[str, Any]) -> bool:
    """True if a limit is exceeded by more than round-off."""
    return exceeds(value_of(row["utilisation"]))


def bars_of(rows: Iterable[dict[str, Any]]) -> list[Markup]:
    """Utilisations as bars on one scale: up to the limit, or 1.5 times the limit if one exceeds it."""
    shares = [value_of(row["utilisation"]) for row in rows]
    most = BEYOND if any(share > 1 for share in shares) else 1.0
    return [bar(share, most) for share in shares]


def left_out(entries: Sized) -> str:
    """The note on rows that a table does not show."""
    left = len(entries) - MOST
    return f"{left} more are in the data of this page. " if left > 0 else ""


# Minima and maxima over a whole run: axial forces, reactions, drives.


def envelopes(run: RunResult) -> dict[str, list[dict[str, Any]]]:
    """Smallest and largest mean axial force (N), with times (s), by load case and member, largest magnitude first; of elastic
    beams that in their middle. Bars of the frames of beams, and beams whose forces are not known, are left out.

    ``at_rest`` is the force in the same pose at rest at the time of the larger of the two.
    """
    found: dict[str, list[dict[str, Any]]] = {}
    kinds, names = shown_kinds(run.model), shown_names(run.model)
    for case, forces in run.forces.items():
        data = forces.data
        if not data.sizes["time"]:
            continue
        time, values = data["time"].values, middle_forces(run.model, forces)
        still = None if forces.static is None else middle_forces(run.model, forces.static)
        low, high = values.argmin(axis=0), values.argmax(axis=0)
        unsure = set(data.attrs.get("not_unique", []))
        entries = []
        for k, name in enumerate(map(str, data["member"].values)):
            if kinds[name] == FRAME or np.isnan(values[:, k]).any():
                continue
            least, largest = values[low[k], k], values[high[k], k]
            at = int(low[k] if -least > largest else high[k])
            entries.append(
                {
                    "member": names[name],
                    "least": float(least),
                    "least_time": float(time[low[k]]),
                    "largest": float(largest),
                    "largest_time": float(time[high[k]]),
                    "at_rest": None if still is None else float(still[at, k]),
                    "unique": name not in unsure,
                }
            )
        found[case] = sorted(entries, key=lambda entry: -max(-entry["least"], entry["largest"]))
    return found


def reactions(run: RunResult) -> list[dict[str, Any]]:
    """Force of largest magnitude on the structure (N), its time (s) and its components, by support and load case.

    A clamp has the forces of all nodes that beams add to its node, and ``moment`` (N m) about it at that time, by axis.
    """
    found = []
    for case, forces in run.forces.items():
        data = forces.data
        if not data.sizes["time"] or not data.sizes["support"]:
            continue
        time, axes = data["time"].values, [str(axis) for axis in data["axis"].values]
        for name, (values, moments) in _support_forces(run.model, forces).items():
            size = np.linalg.norm(np.nan_to_num(values), axis=1)
            at = int(size.argmax())
            entry = {
                "support": name,
                "load_case": case,
                "magnitude": float(size[at]),
                "time": float(time[at]),
                "force": dict(zip(axes, values[at].tolist(), strict=True)),
            }
            if moments is not None:
                entry["moment"] = dict(zip(axes if len(axes) == 3 else ["z"], moments[at].tolist(), strict=True))
            found.append(entry)
    return found


def _support_forces(model: Model, forces: Forces) -> dict[str, tuple[Array, Array | None]]:
    """Forces (times, axes), N, of supports, and moments (times, 3) or (times, 1), N m, of clamps about their nodes."""
    reaction, place = forces.data["reaction"].values, forces.motion.data["position"].values
    index = {str(name): k for k, name in enumerate(forces.motion.data["node"].values)}
    ends = {f"{name}.{end}": end for name, beam in model.beams.items() for end in beam.ends}
    sums: dict[str, Array] = {}
    moments: dict[str, Array] = {}
    for k, name in enumerate(map(str, forces.data["support"].values)):
        before = name.rpartition(".")[0]
        at = (ends.get(before) or before) if model.nodes[name].director else name
        sums[at] = sums.get(at, 0.0) + reaction[:, k]
        if at != name:
            arm = np.zeros((2, len(reaction), 3))
            arm[0, :, : model.dim], arm[1, :, : model.dim] = place[:, index[name]] - place[:, index[at]], reaction[:, k]
            turned = np.cross(arm[0], arm[1])
            moments[at] = moments.get(at, 0.0) + (turned if model.dim == 3 else turned[:, 2:])
    return {name: (values, moments.get(name)) for name, values in sums.items()}


def drive_spans(run: RunResult) -> list[dict[str, Any]]:
    """Smallest and largest position, largest rate and acceleration of every drive; m or rad, s; limits of travel."""
    data = run.motion.data
    if not data.sizes["time"] or "drive" not in data.sizes:
        return []
    found = []
    for k, name in enumerate(map(str, data["drive"].values)):
        drive = run.model.all_drives[name]
        position, rate, acceleration = (data[f"drive_{one}"].values[:, k] for one in ("position", "velocity", "acceleration"))
        member = run.model.active.get(getattr(drive, "bar", ""))
        found.append(
            {
                "drive": name,
                "kind": drive.kind,
                "unit": "rad" if turns(drive) else "m",
                "least": float(position.min()),
                "largest": float(position.max()),
                "rate": _peak(rate),
                "acceleration": _peak(acceleration),
                "travel": None if member is None or member.limits is None else [float(one) for one in member.limits],
            }
        )
    return found


def _peak(values: Any) -> float:
    """The value of largest magnitude, with its sign."""
    return float(values[int(np.argmax(np.abs(values)))])


# Demand and capacity: strength of members, limits of actuators.


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
    table = _limits_table(Columns(), "part", worst)
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
    table = _limits_table(Columns(), "member", shown)
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


def _limits_table(table: Columns, what: str, rows: Sequence[Record]) -> Columns:
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
