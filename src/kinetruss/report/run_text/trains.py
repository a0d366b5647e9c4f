"""Drive trains of a run: torques, permitted data, all exceeded limits."""

from __future__ import annotations

import math
from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators
from kinetruss.display import Table, number, quantity

if TYPE_CHECKING:
    from kinetruss.actuators import Exceeded
    from kinetruss.runs import RunResult

__all__ = ["exceeded", "trains", "trains_text"]

HEAD = (
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
MOST = 12
"""Largest number of motors and of exceeded limits that are printed."""

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
        parts.append(f"Drive trains (largest torques at the motor)\n{Table(HEAD, map(_cells, shown)).text}{more}")
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


def _cells(train: dict[str, Any]) -> tuple[str, ...]:
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
