"""Minima and maxima over a whole run: axial forces, reactions, drives."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model import turns
from kinetruss.model.beams import FRAME, shown_kinds, shown_names
from kinetruss.strength.verdict import middle_forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]

__all__ = ["drive_spans", "envelopes", "reactions"]


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
        for name, (values, moments) in _held(run.model, forces).items():
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


def _held(model: Model, forces: Forces) -> dict[str, tuple[Array, Array | None]]:
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
