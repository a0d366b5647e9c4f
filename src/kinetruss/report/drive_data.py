"""What a run asks of its drives, springs and motors: plain rows, SI, NaN for what is not known."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators
from kinetruss.display.ranks import largest_first, place_of_largest
from kinetruss.model import turns
from kinetruss.model.data import FORCE_ELEMENTS
from kinetruss.report.run_data import entry, peak, pose_at
from kinetruss.strength.findings import demands

if TYPE_CHECKING:
    from kinetruss.runs import RunResult


def drive_loads(run: RunResult, shown: Sequence[Mapping[str, Any]] = ()) -> list[dict[str, Any]]:
    """Largest force (N) or torque (N m), its time (s) and root mean square, rate (m/s, rad/s), largest power (W) and its time
    of every drive and load case.

    shown : rows of the table of motors, whose drives are omitted.
    """
    found, elsewhere = [], {(row["active"], row["load_case"]) for row in shown}
    for case, forces in run.forces.items():
        if not forces.whole.sizes["time"]:
            continue
        time, rates = forces.whole["time"].values, run.motion.whole["drive_velocity"].values
        for k, name in enumerate(map(str, forces.whole["drive"].values)):
            drive, push, rate = run.model.all_drives[name], forces.whole["drive_force"].values[:, k], rates[:, k]
            if (getattr(drive, "bar", name) if drive.kind == "length" else name, case) in elsewhere or np.isnan(push).all():
                continue
            at, power = place_of_largest(np.abs(push)), push * rate
            most = place_of_largest(np.abs(np.nan_to_num(power)))
            found.append(
                {
                    "drive": name,
                    "kind": drive.kind,
                    "unit": "N m" if turns(drive) else "N",
                    "load": float(push[at]),
                    "rms": root_mean_square(time, push),
                    "time": float(time[at]),
                    "pose": pose_at(forces, at),
                    "rate": peak(rate),
                    "power": peak(power),
                    "power_time": float(time[most]),
                    "load_case": case,
                }
            )
    return found


def root_mean_square(time: Any, values: Any) -> float:
    """Over the time, by the trapezoidal rule; NaN of fewer than two instants, or where a value is not known."""
    if len(time) < 2 or not time[-1] > time[0]:
        return math.nan
    return math.sqrt(float(np.trapezoid(values**2, time)) / float(time[-1] - time[0]))


def element_loads(run: RunResult, kind: str) -> list[dict[str, Any]]:
    """Largest force (N) or moment (N m) of every element of a kind and load case, its time (s), the coordinate (m or rad); of
    elements that are not on a coordinate the largest values of all their results, in the unit of each.
    """
    if kind not in FORCE_ELEMENTS:
        return _largest_results(run, kind)
    found = []
    for case, forces in run.forces.items():
        data = forces.data  # without the springs and stops of supports, which reactions have
        if f"{kind}_force" not in data or not data.sizes["time"]:
            continue
        time, push, value = (data[name].values for name in ("time", f"{kind}_force", f"{kind}_value"))
        for k, name in enumerate(map(str, data[kind].values)):
            at = place_of_largest(np.abs(push[:, k]))
            found.append(
                {
                    kind: name,
                    "angle": turns(run.model.force_elements[name][1].parts[0][0]),
                    "load": float(push[at, k]),
                    "value": float(value[at, k]),
                    "time": float(time[at]),
                    "load_case": case,
                }
            )
    return found


def _largest_results(run: RunResult, kind: str) -> list[dict[str, Any]]:
    found = []
    for case, forces in run.forces.items():
        for values in forces.whole.data_vars.values():
            if kind not in values.dims or not forces.whole.sizes["time"]:
                continue
            along = values.transpose("time", kind, ...).values
            size = np.linalg.norm(along, axis=2) if along.ndim == 3 else np.abs(along)
            for k, name in enumerate(map(str, forces.whole[kind].values)):
                at = place_of_largest(size[:, k])
                load = size[at, k] if along.ndim == 3 else along[at, k]
                words = {"what": values.attrs["long_name"], "unit": values.attrs["units"], "load_case": case}
                found.append({kind: name, **words, "load": float(load), "time": float(forces.whole["time"].values[at])})
    return found


def drive_spans(run: RunResult) -> list[dict[str, Any]]:
    """Smallest and largest position, largest rate and acceleration of every drive; m or rad, s; limits of travel."""
    data = run.motion.whole
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
                "rate": peak(rate),
                "acceleration": peak(acceleration),
                "travel": None if member is None or member.limits is None else [float(one) for one in member.limits],
            }
        )
    return found


# Motors and drive trains.

HISTORIES = "thrust", "motor_speed", "motor_torque", "current", "voltage", "electrical_power"
PEAKS = "motor_torque", "motor_torque_frictionless", "breakaway_torque", "holding_torque"
TOTALS = (
    "rms_torque", "rms_current", "drawn_energy", "returned_energy", "electrical_energy", "gear_ratio",
    "largest_self_locking_lead",
)  # fmt: skip


def motors(run: RunResult) -> list[dict[str, Any]]:
    """Peaks of every active member that has a screw, and of every angle that has a motor, by load case."""
    found = []
    for case, demand in run.demand.items():
        if not demand.data.sizes["time"]:
            continue
        data = demand.data
        nearest: dict[str, Any] = {}  # of each part its entry of highest utilisation
        for row in demand.table() if "utilisation" in data else ():
            if row.checked:
                nearest.setdefault(row.part, {"quantity": row.rule, "utilisation": row.utilisation, "time": row.time})
        for k, name in enumerate(map(str, data["active"].values)):
            if all(np.isnan(data[history].values[:, k]).all() for history in ("screw_torque", "motor_torque")):
                continue
            turning = peak(data["drive_torque"].values[:, k]) if "drive_torque" in data else math.nan
            found.append(
                {
                    "active": name,
                    "load_case": case,
                    **{key: peak(data[key].values[:, k]) for key in HISTORIES},
                    "drive_torque": turning,
                    "drawn_energy": float(data["drawn_energy"].values[k]) if "drawn_energy" in data else math.nan,
                    "self_locking": bool(data["self_locking"].values[k]) if "self_locking" in data else None,
                    "nearest_limit": nearest.get(name),
                }
            )
    return found


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
            peaks = {key: float(np.nanmax(np.abs(data[key].values[:, k]))) for key in PEAKS}
            totals = {key: float(data[key].values[k]) for key in TOTALS}
            screw = actuators.train_of(run.model, str(name)).screw
            lead = math.nan if screw is None else screw.lead
            found.append({"active": str(name), "load_case": case, **peaks, **totals, "lead": lead})
    return found


# Limits.


def limits(run: RunResult) -> list[dict[str, Any]]:
    """Largest demands on the drives compared with their limits, over all load cases, worst first."""
    rows = demands(run.demand)
    return [entry(row) for row in largest_first(rows, lambda row: row.utilisation if row.checked else -math.inf)]


def exceeded(run: RunResult) -> list[dict[str, Any]]:
    """Every limit of a drive that the run exceeds, with its times: the worst of each quantity, then the rest, worst first."""
    every = [
        {"load_case": case, **{key: getattr(one, key) for key in one.__slots__}, "sentence": str(one)}
        for case, demand in run.demand.items()
        if demand.data.sizes["time"] and "limit" in demand.data
        for one in actuators.exceeded(demand)
    ]
    every = largest_first(every, lambda one: one["value"] / one["limit"])
    # strokes are exceeded by a few percent, torques by multiples: show the worst of each quantity first
    first = {one["quantity"]: k for k, one in reversed(list(enumerate(every)))}
    return [every[k] for k in sorted(range(len(every)), key=lambda k: (first[every[k]["quantity"]] != k, k))]
