"""Trajectories that reach a length of zero or less."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault
from kinetruss.kernels.motion import profiles as profiles
from kinetruss.model.motion.drives import LengthDrive
from kinetruss.model.motion.trajectories import ConstantRate, Sine, StepResponse, moved_by

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData

__all__ = ["length_faults"]

LEAST = 1e-9
"""Lengths up to this fraction of the length in the model count as zero."""
PLACES = 2001


def length_faults(model: ModelData, trajectory: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """A fault for every member whose length becomes zero or negative along a trajectory."""
    field, table = moved_by(trajectory)
    for name, given in table.items():
        drive = model.all_drives.get(name)
        if not isinstance(drive, LengthDrive) or drive.bar not in model.members:
            continue
        now = _length(model, drive.bar)
        if now is None:
            continue
        least, when = _least(trajectory, given, now)
        if not least > LEAST * now:
            at = f" at t = {when:.4g} s" if when is not None else ""
            yield Fault(
                (*path, field, name),
                f"takes the length of {drive.bar!r} to {least:.6g} m{at}.",
                f"A length must stay above 0 m; in the model it is {now:.6g} m.",
            )


def _length(model: ModelData, name: str) -> float | None:
    """The length of a member in the model, m; None if its nodes are unknown, which is reported by another check."""
    member = model.members[name]
    if member.length is not None:
        return float(member.length)
    ends = [model.nodes.get(end) for end in member.ends]
    places = [one.at for one in ends if one is not None]
    return dist(*places) if len(places) == 2 and len(places[0]) == len(places[1]) else None


def _least(trajectory: Any, given: Any, now: float) -> tuple[float, float | None]:
    """The smallest value of a coordinate along a trajectory (m), and its time (s) if that is neither start nor end."""
    if isinstance(trajectory, ConstantRate):
        return min(now, now + float(given) * trajectory.duration), None
    if isinstance(trajectory, Sine):
        t = np.linspace(0.0, min(trajectory.duration, trajectory.period), PLACES)
        value = now + float(given) * profiles.sine(t, trajectory.period, trajectory.phase)[0]
    elif isinstance(trajectory, StepResponse):
        t = np.linspace(0.0, trajectory.duration, PLACES)
        law = profiles.step_response(t, trajectory.frequency, trajectory.damping, trajectory.pole)[0]
        value = given[0] + (given[1] - given[0]) * law
    elif isinstance(given, tuple) and len(given) == 2:
        return float(min(given)), None
    else:
        t, value = np.array(trajectory.times) - trajectory.times[0], np.array(given, float)
    k = int(np.argmin(value))
    return float(value[k]), float(t[k])
