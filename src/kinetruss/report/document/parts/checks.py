"""Checks that a reviewer can repeat: mobility, and the lengths of all bars."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import KinetrussError
from kinetruss.model import Bar, LengthDrive

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.runs import RunResult

__all__ = ["closure", "mobility_record"]

LARGEST = 300
"""Number of nodes up to which a report lists mechanisms and states of self-stress."""


def mobility_record(model: Model) -> dict[str, Any] | None:
    """Degrees of freedom, mechanisms and states of self-stress of the model in its own pose; None for larger models.

    ``elastic``: True if elastic bars, beams, membranes or solids hold it besides; ``elastic_as_rigid``: the same with elastic
    bars as rigid ones.
    """
    if len(model.nodes) > LARGEST:
        return None
    elastic = [name for name, bar in model.bars.items() if bar.kind == "elastic"]
    stiff = None
    if elastic and not model.beams:
        bars = {name: Bar(ends=bar.ends, mass=0.0) if name in elastic else bar for name, bar in model.bars.items()}
        try:
            stiff = _mobility(model.with_(bars=bars))
        except (KinetrussError, ValueError):  # another record needs the bar to be elastic
            stiff = None
    return _mobility(model) | {
        "elastic": bool(elastic or model.beams or model.membranes or model.solids),
        "elastic_as_rigid": stiff,
    }


def _mobility(model: Model) -> dict[str, Any]:
    from kinetruss.kinematics import mobility

    found = mobility(model)
    names = (
        "bars",
        "coordinates",
        "fixed",
        "rank",
        "degrees_of_freedom",
        "drives",
        "undriven",
        "self_stress",
        "maxwell",
        "smallest_singular_value",
    )
    texts = {"mechanisms": found.mechanism_texts(), "self_stress_states": found.self_stress_texts()}
    return {name: getattr(found, name) for name in names} | texts


def closure(run: RunResult) -> dict[str, Any] | None:
    """Largest error of a bar length, m, recomputed from the node positions.

    Rigid bars are compared with their given or first length, driven ones with the drive. None without such bars or samples.
    """
    data = run.motion.data
    if not data.sizes["time"]:
        return None
    time, position = data["time"].values, data["position"].values
    place = {str(name): k for k, name in enumerate(data["node"].values)}
    worst: dict[str, Any] | None = None
    for name, wanted in _wanted(run):
        a, b = (position[:, place[end]] for end in run.model.members[name].ends)
        length = np.linalg.norm(b - a, axis=1)
        error = np.abs(length - (length[0] if wanted is None else wanted))
        at = int(error.argmax())
        if worst is None or error[at] > worst["error"]:
            share = float(error[at] / length[at]) if length[at] else 0.0
            worst = {"error": float(error[at]), "relative": share, "member": name, "time": float(time[at])}
    return worst


def _wanted(run: RunResult) -> list[tuple[str, NDArray[np.float64] | float | None]]:
    """Members with a required length: over time, or one for all times (None: that of the start)."""
    data = run.motion.data
    driven = {drive.bar: name for name, drive in run.model.all_drives.items() if isinstance(drive, LengthDrive)}
    columns = {str(name): k for k, name in enumerate(data["drive"].values)} if "drive" in data.coords else {}
    found: list[tuple[str, NDArray[np.float64] | float | None]] = []
    for name, member in run.model.members.items():
        if name in driven:
            if driven[name] in columns:
                found.append((name, data["drive_position"].values[:, columns[driven[name]]]))
        elif getattr(member, "kind", "") == "rigid":
            found.append((name, member.length))
    return found
