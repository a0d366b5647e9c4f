"""Checks if a pose satisfies all lengths and angles, and finds a pose near another one that does."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import AnalysisError
from kinetruss.kinematics.path import assembled, refuse_unmet
from kinetruss.mechanics import compile
from kinetruss.mechanics.configuration import drive_values
from kinetruss.model import turns
from kinetruss.statics.large import row_errors

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.model import Model

    Pose = NDArray[np.float64]

__all__ = ["CLOSED", "closed", "gap", "present_values"]

CLOSED = 1e-10
"""Largest error of a length in a pose that is shown, as a fraction of the size of the structure."""

EXACT = 1e-13
"""Error of a length below which a pose is not corrected, as a fraction of the size."""


def gap(model: Model, position: Pose, values: Mapping[str, float]) -> tuple[float, str]:
    """Largest error of a length, angle or coordinate at a pose (n_nodes, dim), as a fraction of the size, and its name."""
    system = compile(model)
    x = _full(system, position)
    return _gap(system, x, _wanted(system, values), values)


def closed(model: Model, position: Pose, values: Mapping[str, float]) -> Pose:
    """The pose with drives at `values`, reached from a pose (n_nodes, dim) by changing all lengths together.

    Raises
    ------
    AnalysisError : there is no continuous path to it. InputError : lengths that contradict each other.
    """
    system = compile(model)
    x, wanted = _full(system, position), _wanted(system, values)
    if _gap(system, x, wanted, values)[0] <= EXACT:
        return position
    here = replace(system, x0=x)
    found, reached = assembled(here, wanted, _pushed(system, values))
    if reached == 1:
        refuse_unmet(here, found, wanted)
    miss, what = _gap(system, found, wanted, values)
    if reached < 1 or not miss <= CLOSED:
        miss, what = _gap(system, x, wanted, values)
        raise AnalysisError(
            f"The lengths cannot be closed from the pose shown, where {what!r} is off by {miss:.2g} of the structure's size: "
            f"{reached:.1%} of the way was reached."
        )
    return found[:, : system.dim].copy()


def present_values(model: Model, position: Pose) -> dict[str, float]:
    """Drive values of a model at a pose (n_nodes, dim), m or rad; angles within half a turn of the model's own."""
    system = compile(model)
    x = _full(system, position)[None]
    now = drive_values(system, x, 0 * x, 0 * x)[0][0]
    found = {}
    for name, own, value in zip(system.drives, system.drive_start, now, strict=True):
        apart = float(value - own)
        turned = np.remainder(apart + np.pi, 2 * np.pi) - np.pi
        found[name] = float(own) + float(turned) if turns(model.all_drives[name]) else float(value)
    return found


def _gap(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64], values: Mapping[str, float]) -> tuple[float, str]:
    size = float(np.ptp(x, axis=0).max()) or 1.0
    misses = np.abs(row_errors(system, x, wanted))
    found = [(float(misses.max()), system.part_of(int(misses.argmax())))] if len(misses) else []
    flat = x.reshape(-1)
    found += [(abs(float(flat[at]) - values[system.drives[d]]), system.drives[d]) for at, d in system.coordinate_drive]
    miss, what = max(found, default=(0.0, ""))
    return miss / size, what


def _wanted(system: System, values: Mapping[str, float]) -> NDArray[np.float64]:
    """Target of every constraint with the drives at `values`."""
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = np.array([values[name] for name in system.drives])[system.row_drive[driven]]
    return wanted


def _pushed(system: System, values: Mapping[str, float]) -> NDArray[np.float64] | None:
    coordinates = system.coordinate_drive[:, 1]
    return np.array([values[system.drives[d]] for d in coordinates]) if len(coordinates) else None


def _full(system: System, position: Pose) -> NDArray[np.float64]:
    full = np.zeros_like(system.x0)
    full[:, : system.dim] = position
    return full
