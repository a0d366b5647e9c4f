"""The lines on a simulation in the page of a run: steps, energy, events."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import number, quantity

if TYPE_CHECKING:
    from kinetruss.results import Simulation
    from kinetruss.runs import RunResult

__all__ = ["simulation_lines", "simulation_record"]

SHOWN = 6
NOTHING = 1e-20
"""Kinetic energy (J), or fraction of the initial energy, that counts as zero."""


def simulation_record(run: RunResult) -> dict[str, Any] | None:
    """The simulation of a run as plain data, or None."""
    found = run.simulation
    if found is None or not found.data.sizes["time"]:
        return None
    data = found.data
    return {
        "method": str(data.attrs.get("method", "")),
        "solver": str(data.attrs.get("solver", "")),
        **{name: int(data[name].values[-1]) for name in ("steps", "rejected", "evaluations")},
        "energy": _energy(found),
        "motors": _motors(found),
        "events": [{"name": one.name, "time": one.time, "direction": one.direction} for one in found.events],
        "passages": [{"time": one.time, "pivot": one.pivot, "certain": one.certain} for one in found.passages],
    }


def _energy(found: Simulation) -> dict[str, float]:
    """Energy at start and end, its largest change, and the largest kinetic energy, J; the largest powers that drives and loads
    feed, and that dampers and friction take, W.
    """
    energy, kinetic = found.data["energy"].values, found.data["kinetic_energy"].values
    most = float(kinetic.max())
    change = float(np.abs(energy - energy[0]).max())
    powers = found.forces.data
    known = (powers[name].values if name in powers else np.zeros(1) for name in ("power", "dissipation"))
    fed, taken = (float(np.nanmax(np.abs(one), initial=0.0)) for one in known)
    return {
        "start": float(energy[0]),
        "end": float(energy[-1]),
        "largest_change": change,
        "largest_kinetic": most,
        "fed": fed,
        "dissipation": taken,
    }


def _motors(found: Simulation) -> list[dict[str, Any]]:
    """Inputs and outputs of each motor: values of largest magnitude (A, V, N m, rad/s), rad, J."""
    data = found.data
    if "motor" not in data.sizes:
        return []
    rows = []
    for k, name in enumerate(map(str, data["motor"].values)):
        peaks = {}
        for key in ("current", "voltage", "torque", "speed"):
            values = data[f"motor_{key}"].values[:, k]
            peaks[key] = float(values[int(np.argmax(np.abs(values)))])
        last = {key: float(data[one].values[-1, k]) for key, one in LAST.items()}
        still = float(np.mean(data["motor_direction"].values[:, k] == 0))
        rows.append({"motor": name, **peaks, **last, "still": still})
    return rows


LAST = {"turned": "motor_angle", "electrical_energy": "electrical_energy", "copper_energy": "copper_energy"}
"""Values reported at the end."""


def _fed(one: dict[str, Any]) -> str:
    peaks = ", ".join(quantity(one[key], unit) for key, unit in (("current", "A"), ("voltage", "V"), ("torque", "N m")))
    energy = quantity(one["electrical_energy"], "J")
    copper = quantity(one["copper_energy"], "J")
    rest = f"; at rest at {quantity(one['still'], '%')} of the samples" if one["still"] else ""
    turned = quantity(one["turned"], "rad")
    return f"{one['motor']}: up to {peaks}; turned {turned}; fed {energy}, {copper} of it heat in the winding{rest}"


def simulation_lines(run: RunResult) -> Iterator[tuple[str, str]]:
    """The same as names and texts."""
    record = simulation_record(run)
    if record is None or run.simulation is None:
        return
    steps = f"{record['steps']} steps, {record['rejected']} rejected, {record['evaluations']} evaluations"
    yield "method", f"{record['method']}, equations by {record['solver']}: {steps}"
    energy = record["energy"]
    yield "energy", f"{quantity(energy['start'], 'J')} to {quantity(energy['end'], 'J')}"
    yield "", _change(energy)
    yield from _listed("motors", [_fed(one) for one in record["motors"]])
    yield from _listed("events", run.simulation.events)
    yield from _listed("singular", run.simulation.passages)


def _change(energy: dict[str, float]) -> str:
    """Change of the energy: where nothing feeds it or takes from it the error, as a fraction of the largest kinetic energy if
    anything moves; else what does.
    """
    change, kinetic = energy["largest_change"], energy["largest_kinetic"]
    if kinetic <= NOTHING * max(1.0, abs(energy["start"])):
        return f"nothing moves; changes by at most {quantity(change, 'J')}"
    sources = [
        *([f"drives and loads feed or take up to {quantity(energy['fed'], 'W')}"] if energy["fed"] else []),
        *([f"dampers and friction take up to {quantity(energy['dissipation'], 'W')}"] if energy["dissipation"] else []),
    ]
    if sources:
        return f"{'; '.join(sources)}; largest kinetic energy {quantity(kinetic, 'J')}"
    return f"changes by at most {number(change / kinetic, 2)} of the largest kinetic energy ({quantity(kinetic, 'J')})"


def _listed(what: str, found: Any) -> Iterator[tuple[str, str]]:
    for k, one in enumerate(found[:SHOWN]):
        yield what if k == 0 else "", str(one)
    if len(found) > SHOWN:
        yield "", f"and {len(found) - SHOWN} more"
