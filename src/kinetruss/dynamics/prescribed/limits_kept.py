"""All limits of the drives against a motion with its forces: strokes, rates, accelerations, forces, motors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinetruss import actuators
from kinetruss.dynamics.prescribed.inverse import inverse
from kinetruss.dynamics.prescribed.quickest import Given
from kinetruss.errors import InputError
from kinetruss.kinematics.limited import Limits, Use, limit_values, motion_uses
from kinetruss.model import Model
from kinetruss.results import Forces, Motion
from kinetruss.results.records import check_samples

__all__ = ["LimitsKept", "limits_kept"]


@dataclass(frozen=True, kw_only=True)
class LimitsKept:
    """How far a motion uses the limits of the drives. uses : largest use of each limit of each drive, worst first, with
    `limit`, `drive`, `time` (s), `value`, `most`, `ratio`.
    """

    uses: tuple[Use, ...]

    @property
    def kept(self) -> bool:
        """Whether all limits are kept."""
        return self.uses[0].kept

    @property
    def worst(self) -> Use:
        """The limit that is used most."""
        return self.uses[0]

    def __str__(self) -> str:
        over = [str(one) for one in self.uses if not one.kept]
        if not over:
            return f"All {len(self.uses)} limits are kept; most used: {self.worst}."
        return f"{len(over)} of {len(self.uses)} limits are not kept: {'; '.join(over[:6])}."


def limits_kept(
    model: Model,
    motion: Motion,
    forces: Forces | None = None,
    *,
    rate: Given = None,
    acceleration: Given = None,
    force: Given = None,
    load_case: str | None = None,
) -> LimitsKept:
    """Compare a motion with all limits of the drives.

    Parameters
    ----------
    motion : from `kinematics.inverse` or `kinematics.follow`.
    forces : along it, from `inverse`; by default those of `load_case`.
    rate, acceleration, force : largest magnitudes, of all drives or by name: m/s or rad/s, m/s^2 or rad/s^2, N or N m. Limits
        of strokes, motors and amplifiers are those of the model.

    Returns
    -------
    LimitsKept.

    Raises
    ------
    InputError : no limit at all; a limit that is not positive; unknown names.

    Examples
    --------
    >>> import kinetruss as kt
    >>> bay = kt.library.vgt.double_octahedral(gravity=(0, 0, -9.81))
    >>> up = kt.Coordinates(moves={"N8.z": 1.0, "N7.z": 1.0, "N9.z": 1.0}, duration=2.0)
    >>> found = kt.dynamics.limits_kept(bay, kt.kinematics.inverse(bay, up, samples=41), rate=0.2, force=1e4)
    >>> found.kept, found.worst.limit
    (True, 'rate')
    """
    check_samples(motion)
    names = [str(name) for name in motion.arrays["drive"].values]
    given = {"rate": rate, "acceleration": acceleration, "force": force}
    limits = Limits(**{what: limit_values(names, value, what) for what, value in given.items()}, others=())
    forces = inverse(model, motion, load_case, static=False) if forces is None else forces
    t = motion.arrays["time"].values
    moved = motion.arrays["drive_velocity"].values, motion.arrays["drive_acceleration"].values
    uses = motion_uses(limits, names, t, moved, forces.arrays["drive_force"].values, "force")
    if model.actuators:
        uses += _motor_uses(model, motion, forces)
    if not uses:
        raise InputError(
            "There is no limit to compare with. Give rate, acceleration or force, or strokes and motors with limits."
        )
    return LimitsKept(uses=tuple(sorted(uses, key=lambda one: -one.ratio)))


def _motor_uses(model: Model, motion: Motion, forces: Forces) -> list[Use]:
    """Use of the limits of strokes, motors and amplifiers."""
    data = actuators.evaluate(model, motion, forces).data
    value, limit, when = (data[name].values for name in ("value", "limit", "time_of"))
    return [
        Use(limit=str(what), drive=str(name), time=float(when[i, j]), value=float(value[i, j]), most=float(limit[i, j]))
        for i, name in enumerate(data["active"].values)
        for j, what in enumerate(data["quantity"].values)
        if np.isfinite(limit[i, j]) and np.isfinite(value[i, j])
    ]
