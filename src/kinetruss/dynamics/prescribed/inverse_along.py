"""Forces of a robot along a path of its tool or platform, in one call."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kinetruss import kinematics
from kinetruss.dynamics.prescribed.inverse import inverse
from kinetruss.kinematics.path import LEAST
from kinetruss.model import Model
from kinetruss.results import Forces

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["inverse_along"]


def inverse_along(
    model: Model,
    targets: Any,
    *,
    platform: Sequence[str] | None = None,
    load_case: str | None = None,
    static: bool = True,
    samples: int = 201,
    times: ArrayLike | None = None,
    least: float = LEAST,
) -> Forces:
    """Inverse kinematics and inverse dynamics of a robot along a path: motions and forces of its drives, and all other forces.

    Parameters
    ----------
    targets, platform, samples, times, least : the prescribed node coordinates or platform pose, as in `kinematics.inverse`.
    load_case, static : as in `inverse`.

    Returns
    -------
    Forces, as of `inverse`; ``motion`` has the required ``drive_position`` and its rates; ``drive_force`` are the
    required forces and torques, N or N m.

    Raises
    ------
    InputError : as for both. AnalysisError : the path cannot be followed; `result` is the Motion up to the last good state.

    Examples
    --------
    >>> import kinetruss as kt
    >>> lift = kt.library.mechanisms.stewart(platform_mass=12.0)
    >>> up = kt.Quintic(moves={"z": (0.0, 0.1)}, duration=1.0)
    >>> forces = kt.dynamics.inverse_along(lift, up, platform=("P1", "P2", "P3", "P4", "P5", "P6"), samples=3)
    >>> forces.drive_force.sel(drive="leg1").round(2).values.tolist()
    [21.78, 21.48, 21.23]
    """
    motion = kinematics.inverse(model, targets, platform=platform, samples=samples, times=times, least=least)
    return inverse(model, motion, load_case, static=static)
