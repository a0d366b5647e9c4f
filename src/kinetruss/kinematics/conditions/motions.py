"""A commanded motion of drives, done by a structure under a condition."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kinematics.path.follow import follow_path, path_of
from kinetruss.kinematics.path.in_between import halved
from kinetruss.kinematics.path.redundant import LEAST
from kinetruss.kinematics.path.sample import Sampled, sample, start_values
from kinetruss.mechanics import compile
from kinetruss.mechanics.freedom import flat_positions
from kinetruss.model import Condition, Model
from kinetruss.results import Motion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["commanded"]


def commanded(
    model: Model,
    changed: Model,
    condition: Condition,
    trajectory: Any,
    times: NDArray[np.float64],
    *,
    start: ArrayLike | None = None,
    least: float = LEAST,
) -> Motion:
    """The motion of `changed` (the model under the condition) by the commands of the trajectory to the drives of the model.

    Drives get the values that they have without the condition; locked ones stay as in the model; those that are gone get
    none. Poses of a trajectory are thus not corrected for temperature or failures.

    Raises
    ------
    InputError : fewer drives than freedoms; samples between which something turns too far.
    """
    commands, system = sample(model, trajectory, times), compile(changed)
    column = {name: k for k, name in enumerate(commands.drives)}
    pick = [column[name] for name in system.drives]
    laws = [np.ascontiguousarray(one[:, pick]) for one in (commands.value, commands.rate, commands.acceleration)]
    standing = start_values(model)
    for name in condition.locked:
        k = system.drives.index(name)
        laws[0][:, k], laws[1][:, k], laws[2][:, k] = standing[name], 0.0, 0.0
    sampled = Sampled(
        drives=system.drives, times=commands.times, value=laws[0], rate=laws[1], acceleration=laws[2], space="lengths"
    )
    motion = follow_path(system, path_of(system, commands.times, sampled), "lengths", start=start, least=least)
    x, v = (flat_positions(system, motion.arrays[name].values) for name in ("position", "velocity"))
    if (more := len(halved(system, x, v, commands.times, sampled))) > len(commands.times):
        raise InputError(f"Something turns too far between two of {len(commands.times)} samples. Take {more} or more samples.")
    return motion
