"""The summary of a run: status, worst members, motors, and checks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, counted, instant, margin, number, quantity
from kinetruss.errors import one_line
from kinetruss.model import inner_parts
from kinetruss.report.mission_tables import mission_record, mission_text
from kinetruss.report.page import Page
from kinetruss.report.run_lines import simulation_lines, simulation_record, statics_lines, statics_record, statics_title
from kinetruss.report.run_tables import (
    IDLE,
    MOST,
    drive_loads,
    drives_text,
    exceeded,
    moment,
    pose_at,
    poses_of,
    spring_loads,
    springs_text,
    telling,
    trains,
    trains_text,
)
from kinetruss.results.records import MOTORS_UNCHECKED
from kinetruss.runs import MissionRun
from kinetruss.runs.doubts import energy_balance, not_unique, remarks, singularity

if TYPE_CHECKING:
    from kinetruss.results import Demand, Row
    from kinetruss.runs import RunResult


WORST = 8

FORCE_HEAD = ("member", "force", "of it by motion", "time", "load case")
WORST_HEAD = ("part", "rule", "utilisation", "value", "limit", "margin", "time", "at", "load case")
MOTOR_HEAD = ("motor of", "load", "speed", "torque", "current", "voltage", "power", "energy", "nearest limit", "load case")


def summary(run: RunResult) -> Page:
    """The summary of a run as a page; of a mission, its envelope.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.summary(kt.run(model))
    >>> page.text.splitlines()[:3]
    ['Four-bar linkage', 'run turn: Completed.', 'verdict: OK; crank, yield: 3.6 % at 0.6083 s']
    """
    if isinstance(run, MissionRun):
        return Page(found=run, as_record=mission_record, as_text=mission_text)
    return Page(found=run, as_record=summary_record, as_text=_text)


def summary_record(run: RunResult) -> dict[str, Any]:
    """The page as plain data (NaN becomes None)."""
    time, inner = run.motion.data["time"].values, inner_parts(run.model)
    record = {
        "run": run.name,
        "out": None if run.path is None else str(run.path),
        "title": run.model.title,
        "state": run.state,
        "status": run.status.name,
        "sentence": run.status.value,
        "message": run.message,
        "whole": run.whole,
        "samples": {"asked": run.samples, "good": run.good},
        "time": [float(time[0]), float(time[-1])] if len(time) else [],
        "poses": poses_of(run),
        "nodes": sum(name not in inner.nodes for name in run.model.nodes),
        "bars": sum(name not in inner.bars for name in run.model.bars),
        "beams": len(run.model.beams),
        "active_members": len(run.model.active),
        "verdict": run.finding.record,
        "largest_forces": largest_forces(run),
        "worst": [{name: getattr(row, name) for name in row.__slots__} for row in worst_rows(run)],
        "not_checked": {} if run.verdict is None else run.verdict.not_checked(),
        "drive_loads": drive_loads(run, motors(run)),
        "spring_loads": spring_loads(run),
        "motors": motors(run),
        "trains": trains(run),
        "exceeded": exceeded(run),
        "simulation": simulation_record(run),
        "statics": statics_record(run),
        "checks": checks(run),
        "wall_time": run.wall_time,
        "provenance": dict(run.provenance),
    }
    plain: dict[str, Any] = _plain(record)
    return plain


def _text(run: RunResult) -> str:
    """The page as text."""
    parts = [_head(run)]
    if given := list(simulation_lines(run)):
        parts.append(Table(("", ""), given, "Simulation").text)
    if given := list(statics_lines(run)):
        parts.append(Table(("", ""), given, statics_title(run)).text)
    if forces := largest_forces(run):
        parts.append(f"Largest member forces (tension positive)\n{_columns(run, FORCE_HEAD, [*map(_force_cells, forces)])}")
    if rows := worst_rows(run):
        beyond = "".join(f"\n{words}" for words in _beyond(run))
        parts.append(
            f"Worst members (utilisation: 100 % is the limit)\n{_columns(run, WORST_HEAD, [*map(_cells, rows)])}{beyond}"
        )
    if run.verdict is not None and (missing := run.verdict.not_checked()):
        parts.append("Not checked\n" + "\n".join(f"{what} ({', '.join(names)})" for what, names in missing.items()))
    found = motors(run)
    parts += drives_text(drive_loads(run, found), timed=run.timed)
    parts += springs_text(spring_loads(run))
    if found:
        parts.append(_motors_text(found))
    parts += trains_text(run)
    if lines := list(_check_lines(run)):
        parts.append(Table(("", ""), lines, "Checks").text)
    return "\n\n".join(parts)


def _motors_text(found: list[dict[str, Any]]) -> str:
    """The table of motors; of many those nearest to a limit."""
    shown, more = found, ""
    if len(found) > MOST:
        shown = sorted(found, key=_near, reverse=True)[:MOST]
        more = f"\nand {len(found) - MOST} more, farther from their limits"
    return f"Motors (largest values of the motion)\n{telling(MOTOR_HEAD, [*map(_motor_cells, shown)])}{more}"


def _near(motor: Mapping[str, Any]) -> tuple[float, float]:
    """How near a motor is to its limits, then its torque: strokes of equal cells are equal."""
    limit = motor["nearest_limit"]
    return (round(limit["utilisation"], 6) if limit else 0.0, abs(motor["motor_torque"]))


def _head(run: RunResult) -> str:
    time = run.motion.data["time"].values
    poses = poses_of(run)
    span = f", t = {number(time[0])} to {instant(time[-1])}" if len(time) > 1 else ""
    span = f", poses {', '.join(poses)}" if poses else span
    count = "1 sample" if run.samples == 1 else f"{run.samples} samples"
    count = count if run.whole else f"{run.good} of {run.samples} samples are good"
    state = {
        "finished": run.status.value,
        "running": "Still running: this is only a part of the run.",
        "incomplete": f"Incomplete: it was interrupted. Continue with: kinetruss run --resume {run.path}",
    }[run.state]
    lines = [one_line(run.model.title, 200) or "(no title)", f"run {run.name}: {state}"]
    if run.verdict is not None or run.demand:
        lines.append(f"verdict: {run.finding.sentence}")
    lines += [f"warning: {one}" for one in run.finding.doubts]
    if said := remarks(run):
        lines.append(said)
    active = f", {counted(len(run.model.active), 'active member')}" if run.model.active else ""
    active += f", {counted(len(run.model.beams), 'beam')}" if run.model.beams else ""
    inner = inner_parts(run.model)
    nodes, bars = (
        sum(name not in inner.nodes for name in run.model.nodes),
        sum(name not in inner.bars for name in run.model.bars),
    )
    parts = f"{counted(nodes, 'node')}, {counted(bars, 'bar')}{active}"
    lines.append(f"{count}{span}; {parts}; {quantity(run.wall_time, 's', 3)}")
    return "\n".join(lines)


def _columns(run: RunResult, head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A table of the run; of one pose at rest without its time, of several with their names."""
    at = rows[0][head.index("time")]
    if poses_of(run):
        return telling([{"time": "pose"}.get(name, name) for name in head], rows)
    return telling(head, rows, IDLE if run.timed else IDLE | {"time": at})


def largest_forces(run: RunResult, count: int = 5) -> list[dict[str, Any]]:
    """The members with the largest force of all load cases, largest first, without bars that represent bodies.

    ``unique`` : False if the structure is redundant and the force of the member depends on stiffness or convention.
    """
    found: list[dict[str, Any]] = []
    for case, forces in run.forces.items():
        values = forces.data["member_force"].values
        if not len(values):
            continue
        static = None if forces.static is None else forces.static.data["member_force"].values
        unsure = set(forces.data.attrs.get("not_unique", []))
        for i, member in enumerate(map(str, forces.data["member"].values)):
            if member in run.model.bars and run.model.bars[member].brace:
                continue
            at = int(np.argmax(np.abs(values[:, i])))
            share = math.nan if static is None else float(values[at, i] - static[at, i])
            when = float(forces.data["time"].values[at])
            found.append(
                {
                    "member": member,
                    "force": float(values[at, i]),
                    "by_motion": share,
                    "time": when,
                    "pose": pose_at(forces, at),
                    "load_case": case,
                    "unique": member not in unsure,
                }
            )
    return sorted(found, key=lambda entry: -abs(entry["force"]))[:count]


def worst_rows(run: RunResult, count: int = WORST) -> list[Row]:
    """The governing entry of each part, worst part first."""
    if run.verdict is None:
        return []
    first: dict[str, Row] = {}
    for row in run.verdict.table():
        if row.checked and row.utilisation > 0:
            first.setdefault(row.part, row)
    return list(first.values())[:count]


def _beyond(run: RunResult) -> Iterable[str]:
    """Beam-columns without a finite value: the parts by their reason."""
    found: dict[str, list[str]] = {}
    for row in () if run.verdict is None else run.verdict.table():
        if math.isinf(row.utilisation):
            case = "" if row.load_case == "all" else f", {row.load_case}"
            found.setdefault(f"{row.note.partition(';')[0]}, so beam-column has no finite value{case}", []).append(row.part)
    return (f"{', '.join(parts)}: {words}" for words, parts in found.items())


def motors(run: RunResult) -> list[dict[str, Any]]:
    """Peaks of every active member that has a screw, and of every angle that has a motor, by load case."""
    found = []
    for case, demand in run.demand.items():
        if not demand.data.sizes["time"]:
            continue
        # For each active member its entry of highest utilisation.
        first: dict[str, dict[str, Any]] = {}
        if "utilisation" in demand.data:
            for row in demand.table():
                if row.checked:
                    first.setdefault(row.part, {"quantity": row.rule, "utilisation": row.utilisation, "time": row.time})
        nearest = first
        for k, name in enumerate(demand.data["active"].values):
            known = (demand.data[history].values[:, k] for history in ("screw_torque", "motor_torque"))
            if all(np.isnan(values).all() for values in known):
                continue
            peak = {key: _peak(demand, history, k) for key, history in PEAKS.items()}
            peak["drive_torque"] = _peak(demand, "drive_torque", k) if "drive_torque" in demand.data else math.nan
            energy = float(demand.data["drawn_energy"].values[k]) if "drawn_energy" in demand.data else math.nan
            locking = bool(demand.data["self_locking"].values[k]) if "self_locking" in demand.data else None
            found.append(
                {
                    "active": str(name),
                    "load_case": case,
                    **peak,
                    "drawn_energy": energy,
                    "self_locking": locking,
                    "nearest_limit": nearest.get(str(name)),
                }
            )
    return found


PEAKS = {
    "thrust": "thrust",
    "motor_speed": "motor_speed",
    "motor_torque": "motor_torque",
    "current": "current",
    "voltage": "voltage",
    "electrical_power": "electrical_power",
}


def _peak(demand: Demand, history: str, k: int) -> float:
    """The value of largest magnitude, with its sign."""
    values = demand.data[history].values[:, k]
    return math.nan if np.isnan(values).all() else float(values[np.nanargmax(np.abs(values))])


def checks(run: RunResult) -> dict[str, Any]:
    """Energy balance, singularity measure, members whose force is not unique, limits of motors that the motion alone left
    open and the forces decided, missing strength checks.
    """
    return {
        "singularity": singularity(run),
        "energy_balance": energy_balance(run),
        "not_unique": not_unique(run),
        "not_held": list(run.finding.left_out),
        "motors": list(run.motion.attrs.get(MOTORS_UNCHECKED, ())) if run.demand else [],
    }


def _check_lines(run: RunResult) -> Iterable[tuple[str, str]]:
    found = checks(run)
    if (balance := found["energy_balance"]) is not None:
        share, power = number(balance["relative"], 2), quantity(balance["largest_power"], "W")
        yield "energy balance", f"power of drives and loads = rate of energy to {share} of the largest power ({power})"
    if (gauge := found["singularity"]) is not None:
        when = moment(gauge["time"], poses_of(run))
        yield "singularity", f"smallest measure {number(gauge['smallest'], 3)} at {when} (0 is singular)"
    if run.forces:
        unique = found["not_unique"]
        yield "unique forces", "all" if not unique else f"all but {', '.join(unique)}"
    if found["motors"]:
        yield "motors", f"checked with the forces of this run: {', '.join(found['motors'])}"
    yield from (("strength", sentence) for sentence in found["not_held"])


def _force_cells(f: Mapping[str, Any]) -> tuple[str, ...]:
    by_motion = quantity(f["by_motion"], "N")
    return (
        f["member"],
        quantity(f["force"], "N") + ("" if f["unique"] else ", not unique"),
        by_motion,
        f["pose"] or instant(f["time"]),
        f["load_case"],
    )


def _cells(row: Row) -> tuple[str, ...]:
    return (
        row.part,
        row.rule,
        quantity(row.utilisation, "%"),
        quantity(row.value, row.unit),
        quantity(row.limit, row.unit),
        margin(row.margin),
        row.pose or instant(row.time),
        quantity(row.position, "m"),
        row.load_case,
    )


def _motor_cells(motor: Mapping[str, Any]) -> tuple[str, ...]:
    nearest, turning = motor["nearest_limit"], math.isfinite(motor["drive_torque"])
    load = quantity(motor["drive_torque"], "N m") if turning else quantity(motor["thrust"], "N")
    limit = f"{nearest['quantity']} {quantity(nearest['utilisation'], '%')}" if nearest else "-"
    return (
        motor["active"],
        load,
        quantity(motor["motor_speed"], "rad/s"),
        quantity(motor["motor_torque"], "N m"),
        quantity(motor["current"], "A"),
        quantity(motor["voltage"], "V"),
        quantity(motor["electrical_power"], "W"),
        quantity(motor["drawn_energy"], "J"),
        limit,
        motor["load_case"],
    )


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key): _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(entry) for entry in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value
