"""What a simulation and a static analysis found, as plain data; the lines on a static analysis."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import moment, number, quantity
from kinetruss.display.ranks import place_of_largest
from kinetruss.model.runs import FLEXIBLE
from kinetruss.report.run_data import peak
from kinetruss.results.wide_tables import units_of
from kinetruss.runs.doubts import poses_of

if TYPE_CHECKING:
    from kinetruss.results import Result, Simulation
    from kinetruss.runs import RunResult


def simulation_record(run: RunResult) -> dict[str, Any] | None:
    """The simulation of a run as plain data, or None."""
    found = run.simulation
    if found is None or not found.whole.sizes["time"]:
        return None
    data = found.whole
    return {
        "method": str(data.attrs.get("method", "")),
        "solver": str(data.attrs.get("solver", "")),
        **{name: int(data[name].values[-1]) for name in ("steps", "rejected", "evaluations")},
        "energy": _energy(found),
        "motors": _motors(found),
        **({"feedback": fed} if (fed := _feedback(found)) else {}),
        "events": [{"name": one.name, "time": one.time, "direction": one.direction} for one in found.events],
        "passages": [{"time": one.time, "pivot": one.pivot, "certain": one.certain} for one in found.passages],
    }


NOTHING = 1e-9
"""Power that elements give, as a fraction of the largest that they take: round-off."""


def _energy(found: Simulation) -> dict[str, float]:
    """Energy at start and end, its largest change, and the largest kinetic energy, J; the largest powers that drives and loads
    feed, and that dampers and friction take, W; of elements that feed what they give.
    """
    energy, kinetic = found.whole["energy"].values, found.whole["kinetic_energy"].values
    most = float(kinetic.max())
    change = float(np.abs(energy - energy[0]).max())
    powers = found.forces.whole
    power, lost = (powers[name].values if name in powers else np.zeros(1) for name in ("power", "dissipation"))
    fed, taken, given = (float(np.nanmax(one, initial=0.0)) for one in (np.abs(power), lost, -lost))
    return {
        "start": float(energy[0]),
        "end": float(energy[-1]),
        "largest_change": change,
        "largest_kinetic": most,
        "fed": fed,
        "dissipation": taken,
        **({"given": given} if given > NOTHING * float(np.nanmax(np.abs(lost), initial=0.0)) else {}),
    }


def _feedback(found: Simulation) -> list[dict[str, Any]]:
    """Of each drive that is fed back: its largest error (m or rad) and force (N or N m), with signs; the share of the samples
    at which its force is at its limit.
    """
    data = found.whole
    if "tracking_error" not in data:
        return []
    rows = []
    units = [list(units_of(data[one])) for one in ("tracking_error", "feedback_force")]
    for k, name in enumerate(map(str, data["drive"].values)):
        error, force, asked = (data[one].values[:, k] for one in ("tracking_error", "feedback_force", "feedback_asked"))
        if not np.isnan(force).all():
            limited = float(np.mean(np.abs(asked) > np.abs(force)))
            own = {"unit": units[0][k], "force_unit": units[1][k]}
            rows.append({"drive": name, "error": peak(error), "force": peak(force), "limited": limited, **own})
    return rows


def _motors(found: Simulation) -> list[dict[str, Any]]:
    """Inputs and outputs of each motor: values of largest magnitude (A, V, N m, rad/s), rad, J."""
    data = found.whole
    if "motor" not in data.sizes:
        return []
    rows = []
    for k, name in enumerate(map(str, data["motor"].values)):
        peaks = {key: peak(data[f"motor_{key}"].values[:, k]) for key in ("current", "voltage", "torque", "speed")}
        last = {key: float(data[one].values[-1, k]) for key, one in LAST.items()}
        still = float(np.mean(data["motor_direction"].values[:, k] == 0))
        rows.append({"motor": name, **peaks, **last, "still": still})
    return rows


LAST = {"turned": "motor_angle", "electrical_energy": "electrical_energy", "copper_energy": "copper_energy"}
"""Values reported at the end."""


# The lines on a static analysis in the page of a run: displacements, energies, stability, and what such a run has not.

LACKS = {
    "statics.linear": "at rest: no rates, no powers, no motor demands; nodes are drawn where they are without displacements",
    "statics.equilibrium": "at rest: no rates and no powers",
    "statics.at_poses": "at rest: no rates, no powers, no inertia forces",
    "flexible.corrected": "forces, strength and drives are those of the rigid motion, with its lengths",
    "flexible.frequencies": "small vibrations with locked actuators; forces, strength and drives are those of the rigid motion",
    "flexible.vibration": "small displacements; strength and drives are those of the rigid motion",
    "statics.deflection": "small displacements: they change neither the geometry nor the forces",
}
"""What the result of an analysis of statics or of elastic members has not."""


def statics_title(run: RunResult) -> str:
    """The title of these lines."""
    return "Elastic members along the motion" if run.definition.analysis in FLEXIBLE else "Static analysis"


def statics_record(run: RunResult) -> dict[str, Any] | None:
    """What statics or elastic members add to forces, by load case, as plain data; None for other runs."""
    analysis = run.definition.analysis
    if analysis not in LACKS:
        return None
    return {
        "analysis": analysis,
        "lacks": LACKS[analysis],
        "cases": {case: _case(run, one) for case, one in run.statics.items()},
    }


def _case(run: RunResult, found: Result) -> dict[str, Any]:
    data = found.whole
    fields: dict[str, Any] = {}
    shift = shift_of(run, found)
    if shift is not None and shift.size:
        seen = [str(name) in run.model.nodes for name in data["node"].values]
        size = np.where(seen, np.linalg.norm(shift, axis=2), 0.0)
        i, k = np.unravel_index(place_of_largest(size), size.shape)
        fields["displacement"] = {
            "node": str(data["node"].values[k]),
            "size": float(size[i, k]),
            "vector": shift[i, k].tolist(),
            "time": float(data["time"].values[i]),
        }
    if "energy" in data:
        fields["strain_energy"] = float(data["energy"].values.max(initial=0.0))
    if "stiffness" in data and data["stiffness"].size:
        fields["least_stiffness"] = float(data["stiffness"].values.min())
        fields["unstable"], fields["neutral"] = int(data.attrs["unstable"]), int(data.attrs["neutral"])
    return fields | _elastic(found)


def _elastic(found: Result) -> dict[str, Any]:
    """Lowest and highest frequency of each mode; the largest change of a length; overshoot, residual and largest difference."""
    data = found.whole
    fields: dict[str, Any] = {}
    if "frequency" in data:
        values = data["frequency"].values
        fields["frequencies"] = [{"least": float(one.min()), "largest": float(one.max())} for one in values.T]
    if "change" in data and data["change"].size:
        fields["change"] = _largest(data["change"])
        fields["error"] = float(np.abs(data["error"].values).max(initial=0.0))
    if "difference" in data and data["difference"].size:
        fields["difference"] = _largest(data["difference"])
        fields |= {name: float(data.attrs[name]) for name in ("overshoot", "residual") if np.isfinite(data.attrs[name])}
    return fields


def _largest(values: Any) -> dict[str, Any]:
    """The entry (time, name) of the largest size."""
    i, k = np.unravel_index(place_of_largest(np.abs(values.values)), values.shape)
    return {
        "of": str(values[values.dims[1]].values[k]),
        "value": float(values.values[i, k]),
        "time": float(values["time"].values[i]),
    }


def shift_of(run: RunResult, found: Result) -> Any:
    """Displacements (samples, nodes, axes), m, from the model's own place."""
    if "displacement" in found.whole:
        return found.whole["displacement"].values
    if "position" not in found.whole:
        return None
    return found.whole["position"].values - np.array([node.at for node in run.origin.whole.nodes.values()])


def statics_lines(run: RunResult) -> Iterator[tuple[str, str]]:
    """The same as rows of text."""
    record = statics_record(run)
    if record is None:
        return
    yield "this run", record["lacks"]
    for case, one in record["cases"].items():
        if "displacement" in one:
            far = one["displacement"]
            vector = ", ".join(quantity(value, "m") for value in far["vector"])
            when = f" at {moment(far['time'], poses_of(run))}" if len(run.motion.whole["time"]) > 1 else ""
            yield f"displacement, {case}", f"largest {quantity(far['size'], 'm')} at {far['node']}: ({vector}){when}"
        yield from _elastic_lines(case, one, poses_of(run))
        if "strain_energy" in one:
            yield f"strain energy, {case}", quantity(one["strain_energy"], "J")
        if "least_stiffness" in one:
            state = "stable" if not (one["unstable"] or one["neutral"]) else f"{one['unstable']} unstable modes"
            state += f", {one['neutral']} without stiffness" if one["neutral"] else ""
            yield f"stability, {case}", f"{state}; least stiffness {number(one['least_stiffness'], 4)} N/m"


def _elastic_lines(case: str, one: dict[str, Any], poses: list[str]) -> Iterator[tuple[str, str]]:
    """Rows of elastic members along a motion."""
    if "frequencies" in one:
        ranges = []
        for mode in one["frequencies"]:
            least, largest = (number(mode[name], 4) for name in ("least", "largest"))
            ranges.append(least if least == largest else f"{least} to {largest}")
        yield f"frequencies, {case}", f"{', '.join(ranges)} Hz"
    for name, words, unit in (("change", "change of length", "m"), ("difference", "force less the rigid one", "N")):
        if name in one:
            most = one[name]
            where = f"largest {quantity(most['value'], unit)}, {most['of']} at {moment(most['time'], poses)}"
            yield f"{words}, {case}", where
    if "error" in one:
        yield f"remaining error, {case}", f"{one['error']:.1e} m or rad"
    if "overshoot" in one:
        yield f"overshoot, {case}", f"{number(one['overshoot'], 4)} times the largest displacement without vibration"
    if "residual" in one:
        yield f"residual, {case}", f"{quantity(one['residual'], 'm')} after the motion"
