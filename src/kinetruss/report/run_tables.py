"""Drives, springs and drive trains of a run in tables; the variants of a run, one line each."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators
from kinetruss.display import Table, instant, number, quantity
from kinetruss.model import turns
from kinetruss.report.page import Page
from kinetruss.runs.doubts import moment as moment, poses_of as poses_of

if TYPE_CHECKING:
    from kinetruss.actuators import Exceeded
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult, VariantRuns


IDLE = {"load case": "all", "of it by motion": "-"}
"""Column -> the cell that says nothing, if all are equal to it."""


def telling(head: Sequence[str], rows: Sequence[Sequence[str]], idle: Mapping[str, str] = IDLE) -> str:
    """The table as text, without columns whose cells are all idle.

    >>> print(telling(("member", "force", "load case"), [("M1", "58.3 N", "all")]))
    member   force
    M1      58.3 N
    """
    kept = [k for k, name in enumerate(head) if name not in idle or any(row[k] != idle[name] for row in rows)]
    return Table([head[k] for k in kept], [[row[k] for k in kept] for row in rows]).text


# Drives of a run without a motor in the tables: largest forces and torques, rates and powers.

DRIVES_HEAD = ("drive", "force or torque", "at", "rate", "power", "load case")
MOST = 12
"""Largest number of printed drives."""


def drive_loads(run: RunResult, shown: Sequence[Mapping[str, Any]] = ()) -> list[dict[str, Any]]:
    """Largest force (N) or torque (N m), its time (s), rate (m/s, rad/s) and power (W) of every drive and load case.

    shown : rows of the table of motors, whose drives are omitted.
    """
    found, elsewhere = [], {(row["active"], row["load_case"]) for row in shown}
    for case, forces in run.forces.items():
        if not forces.data.sizes["time"]:
            continue
        time, rates = forces.data["time"].values, run.motion.data["drive_velocity"].values
        for k, name in enumerate(map(str, forces.data["drive"].values)):
            drive, push, rate = run.model.all_drives[name], forces.data["drive_force"].values[:, k], rates[:, k]
            if (getattr(drive, "bar", name) if drive.kind == "length" else name, case) in elsewhere or np.isnan(push).all():
                continue
            at = int(np.nanargmax(np.abs(push)))
            found.append(
                {
                    "drive": name,
                    "kind": drive.kind,
                    "unit": "N m" if turns(drive) else "N",
                    "load": float(push[at]),
                    "time": float(time[at]),
                    "pose": pose_at(forces, at),
                    "rate": _peak(rate),
                    "power": _peak(push * rate),
                    "load_case": case,
                }
            )
    return found


def pose_at(forces: Forces, at: int) -> str:
    """Name of the pose of a sample; empty for instants of a motion."""
    return str(forces.data["pose"].values[at]) if "pose" in forces.data.coords else ""


def drives_text(found: Sequence[Mapping[str, Any]], *, timed: bool = True) -> list[str]:
    """The table as text, for drives with a force; of one pose at rest (`timed` False) without times, rates and powers."""
    rows = [drive_cells(one) for one in found if one["load"]]
    if not rows:
        return []
    more = f"\nand {len(rows) - MOST} more" if len(rows) > MOST else ""
    if timed and any(one["pose"] for one in found):
        posed = [(name, load, pose, case) for name, load, pose, _, _, case in rows[:MOST]]
        return [
            f"Drives, held (largest values of the poses)\n{telling((*DRIVES_HEAD[:2], 'pose', DRIVES_HEAD[-1]), posed)}{more}"
        ]
    if timed:
        return [f"Drives (largest values of the motion)\n{telling(DRIVES_HEAD, rows[:MOST])}{more}"]
    still = [(name, load, case) for name, load, _, _, _, case in rows[:MOST]]
    return [f"Drives, held\n{telling((*DRIVES_HEAD[:2], DRIVES_HEAD[-1]), still)}{more}"]


def drive_cells(one: Mapping[str, Any]) -> tuple[str, ...]:
    """A row of the table; numbers that are none may be None."""
    load, rate, power = (math.nan if one[key] is None else one[key] for key in ("load", "rate", "power"))
    per = "rad/s" if one["unit"] == "N m" else "m/s"
    return (
        one["drive"],
        quantity(load, one["unit"]),
        one["pose"] or instant(one["time"]),
        quantity(rate, per),
        quantity(power, "W"),
        one["load_case"],
    )


def _peak(values: np.ndarray) -> float:
    """The value of largest magnitude, with its sign."""
    return math.nan if np.isnan(values).all() else float(values[int(np.nanargmax(np.abs(values)))])


# Springs of a run in the tables: largest forces and moments, and where they act.

SPRINGS_HEAD = ("spring", "force or moment", "at value", "time", "load case")


def spring_loads(run: RunResult) -> list[dict[str, Any]]:
    """Largest force (N) or moment (N m) of every spring and load case, its time (s) and the coordinate there (m or rad)."""
    found = []
    for case, forces in run.forces.items():
        if "spring_force" not in forces.data or not forces.data.sizes["time"]:
            continue
        time, push, value = (forces.data[name].values for name in ("time", "spring_force", "spring_value"))
        for k, name in enumerate(map(str, forces.data["spring"].values)):
            at = int(np.argmax(np.abs(push[:, k])))
            found.append(
                {
                    "spring": name,
                    "angle": turns(run.model.springs[name].parts[0][0]),
                    "load": float(push[at, k]),
                    "value": float(value[at, k]),
                    "time": float(time[at]),
                    "load_case": case,
                }
            )
    return found


def springs_text(found: Sequence[Mapping[str, Any]]) -> list[str]:
    """The table as text, the largest forces first."""
    rows = sorted((one for one in found if one["load"]), key=lambda one: -abs(one["load"]))
    if not rows:
        return []
    more = f"\nand {len(rows) - MOST} more" if len(rows) > MOST else ""
    return [f"Springs (largest values of the motion)\n{Table(SPRINGS_HEAD, map(_spring_cells, rows[:MOST])).text}{more}"]


def _spring_cells(one: Mapping[str, Any]) -> tuple[str, ...]:
    units = ("N m", "rad") if one["angle"] else ("N", "m")
    return (
        one["spring"],
        quantity(one["load"], units[0]),
        quantity(one["value"], units[1]),
        instant(one["time"]),
        one["load_case"],
    )


# Drive trains of a run: torques, permitted data, all exceeded limits.

TRAINS_HEAD = (
    "motor of",
    "moving",
    "without friction",
    "break-away",
    "holding",
    "rms",
    "drawn",
    "fed back",
    "gear for top speed",
    "lead",
    "self-locking up to",
    "load case",
)

PEAKS = {
    "motor_torque": "motor_torque",
    "motor_torque_frictionless": "motor_torque_frictionless",
    "breakaway_torque": "breakaway_torque",
    "holding_torque": "holding_torque",
}
TOTALS = (
    "rms_torque",
    "rms_current",
    "drawn_energy",
    "returned_energy",
    "electrical_energy",
    "gear_ratio",
    "largest_self_locking_lead",
)


def trains(run: RunResult) -> list[dict[str, Any]]:
    """Data of every motor and load case: largest torques (N m), root mean squares, energies (J), gear ratio, self-locking
    lead.
    """
    found = []
    for case, demand in run.demand.items():
        data = demand.data
        if not data.sizes["time"] or "gear_ratio" not in data:
            continue
        for k, name in enumerate(data["active"].values):
            if np.isnan(data["motor_torque"].values[:, k]).all():
                continue
            peaks = {key: float(np.nanmax(np.abs(data[history].values[:, k]))) for key, history in PEAKS.items()}
            totals = {key: float(data[key].values[k]) for key in TOTALS}
            screw = actuators.train_of(run.model, str(name)).screw
            lead = math.nan if screw is None else screw.lead
            found.append({"active": str(name), "load_case": case, **peaks, **totals, "lead": lead})
    return found


def exceeded(run: RunResult) -> list[dict[str, Any]]:
    """Every limit of a drive that the run exceeds, with its times: the worst of each quantity, then the rest, worst first."""
    return [
        {"load_case": case, **{key: getattr(one, key) for key in one.__slots__}, "sentence": str(one)}
        for case, one in _exceeded(run)
    ]


def trains_text(run: RunResult) -> list[str]:
    """The same as text: a table, and a list of exceeded limits."""
    parts = []
    if found := trains(run):
        more = f"\nand {len(found) - MOST} more, with less torque" if len(found) > MOST else ""
        shown = sorted(found, key=lambda one: -float(one["motor_torque"]))[:MOST] if more else found
        parts.append(f"Drive trains (largest torques at the motor)\n{Table(TRAINS_HEAD, map(_train_cells, shown)).text}{more}")
    if over := _exceeded(run):
        lines = [f"{one} ({case})" for case, one in over[:MOST]]
        if len(over) > MOST:
            counts = Counter(one.quantity for _, one in over[MOST:])
            lines.append(f"and {len(over) - MOST} more: {', '.join(f'{what} {count}' for what, count in counts.items())}")
        parts.append("Limits of drives exceeded\n" + "\n".join(lines))
    return parts


def _exceeded(run: RunResult) -> list[tuple[str, Exceeded]]:
    every = [
        (case, one)
        for case, demand in run.demand.items()
        if demand.data.sizes["time"] and "limit" in demand.data
        for one in actuators.exceeded(demand)
    ]
    every.sort(key=lambda entry: -entry[1].value / entry[1].limit)
    # strokes are exceeded by a few percent, torques by multiples: show the worst of each quantity first
    first = {one.quantity: k for k, (_, one) in reversed(list(enumerate(every)))}
    return [every[k] for k in sorted(range(len(every)), key=lambda k: (first[every[k][1].quantity] != k, k))]


def _train_cells(train: dict[str, Any]) -> tuple[str, ...]:
    ratio = number(train["gear_ratio"])
    return (
        train["active"],
        *(quantity(train[key], "N m") for key in (*PEAKS, "rms_torque")),
        quantity(train["drawn_energy"], "J"),
        quantity(train["returned_energy"], "J"),
        ratio,
        *(_lead(train[key]) for key in ("lead", "largest_self_locking_lead")),
        train["load_case"],
    )


def _lead(lead: float) -> str:
    """In mm/rad; an angle has no screw."""
    return f"{number(1e3 * lead)} mm/rad" if math.isfinite(lead) else "-"


# The outcome of the variants of a run, one line each.

VARIANTS_HEAD = ("variant", "status", "worst part", "rule", "utilisation", "time", "verdict")


def variants(found: VariantRuns) -> Page:
    """The outcome of each variant, in the order of the combinations, and the folders of the runs.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.variants(kt.runs.run_variants(model, {"nodes.C.mass": [0.5, 1.0]}))
    >>> [line.split()[0] for line in page.text.splitlines()[1:]]
    ['mass=0.5', 'mass=1.0']
    """
    return Page(found=found, as_record=_records, as_text=_text)


def _records(found: VariantRuns) -> list[dict[str, Any]]:
    """One entry per variant, plain data, in the order of the combinations."""
    records = []
    for name, settings in found.settings.items():
        worst = found.worst.get(name)
        highest = None if worst is None else dict(zip(("part", "rule", "utilisation", "time"), worst, strict=True))
        if worst is not None and highest is not None and math.isinf(worst[2]):  # JSON has no infinity
            highest["utilisation"] = None
        path, status = found.paths.get(name), found.status.get(name)
        records.append(
            {
                "name": name,
                "settings": dict(settings),
                "path": None if path is None else str(path),
                "status": None if status is None else status.name,
                "whole": found.whole.get(name, False),
                "worst": highest,
                "verdict": found.said.get(name, ""),
                "refused": found.refused.get(name),
            }
        )
    return records


def _text(found: VariantRuns) -> str:
    """The same as a table, with the folders of the runs."""
    rows = []
    for record in _records(found):
        status = "refused" if record["refused"] else "done" if record["whole"] else record["status"].lower().replace("_", " ")
        worst = record["worst"]
        cells = ("-",) * 4
        if worst is not None:
            value = quantity(math.inf if worst["utilisation"] is None else worst["utilisation"], "%")
            cells = (worst["part"], worst["rule"], value, instant(worst["time"]))
        rows.append((record["name"], status, *cells, record["verdict"] or "-"))
    text = Table(VARIANTS_HEAD, rows).text
    folders = {path.parent if len(found.paths) > 1 else path for path in found.paths.values()}
    return f"{text}\n\n{len(found)} runs in {', '.join(map(str, sorted(folders)))}" if folders else text
