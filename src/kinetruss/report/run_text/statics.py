"""The lines on a static analysis in the page of a run: displacements, energies, stability, and what such a run has not."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant, number, quantity
from kinetruss.model.motion import STATIC

if TYPE_CHECKING:
    from kinetruss.results import Result
    from kinetruss.runs import RunResult

__all__ = ["LACKS", "statics_lines", "statics_record"]

LACKS = {
    "statics.linear": "at rest: it has no rates, no powers and no motor demands; the place is that without displacements",
    "statics.equilibrium": "at rest: it has no rates and no powers",
    "statics.at_poses": "at rest: it has no rates, no powers and no forces of inertia",
    "statics.deflection": "small displacements: they change neither the geometry nor the forces",
}
"""What the result of a static analysis has not."""


def statics_record(run: RunResult) -> dict[str, Any] | None:
    """What a static analysis finds besides forces, by load case, as plain data; None for other runs."""
    analysis = run.told.analysis
    if analysis not in STATIC:
        return None
    return {
        "analysis": analysis,
        "lacks": LACKS[analysis],
        "cases": {case: _case(run, one) for case, one in run.statics.items()},
    }


def _case(run: RunResult, found: Result) -> dict[str, Any]:
    data = found.data
    told: dict[str, Any] = {}
    shift = _shift(run, found)
    if shift is not None and shift.size:
        size = np.linalg.norm(shift, axis=2)
        i, k = np.unravel_index(int(size.argmax()), size.shape)
        told["displacement"] = {
            "node": str(data["node"].values[k]),
            "size": float(size[i, k]),
            "vector": shift[i, k].tolist(),
            "time": float(data["time"].values[i]),
        }
    if "energy" in data:
        told["strain_energy"] = float(data["energy"].values.max(initial=0.0))
    if "stiffness" in data and data["stiffness"].size:
        told["least_stiffness"] = float(data["stiffness"].values.min())
        told["unstable"], told["neutral"] = int(data.attrs["unstable"]), int(data.attrs["neutral"])
    return told


def _shift(run: RunResult, found: Result) -> Any:
    """Displacements (samples, nodes, axes), m, from the model's own place."""
    if "displacement" in found.data:
        return found.data["displacement"].values
    if "position" not in found.data:
        return None
    return found.data["position"].values - np.array([node.at for node in run.origin.nodes.values()])


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
            when = f" at t = {instant(far['time'])}" if len(run.motion.data["time"]) > 1 else ""
            yield f"displacement, {case}", f"largest {quantity(far['size'], 'm')} at {far['node']}: ({vector}){when}"
        if "strain_energy" in one:
            yield f"strain energy, {case}", quantity(one["strain_energy"], "J")
        if "least_stiffness" in one:
            state = "stable" if not (one["unstable"] or one["neutral"]) else f"{one['unstable']} unstable modes"
            state += f", {one['neutral']} without stiffness" if one["neutral"] else ""
            yield f"stability, {case}", f"{state}; least stiffness {number(one['least_stiffness'], 4)} N/m"
