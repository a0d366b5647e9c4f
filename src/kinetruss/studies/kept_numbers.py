"""The numbers that a study keeps of a run."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics.matrices import total_mass
from kinetruss.model import nearest
from kinetruss.runs.mission_results import MissionRun
from kinetruss.runs.results import RunResult
from kinetruss.strength.verdict import highest

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Standard:
    """A number that is known by its name alone. unit : SI. judged : it needs the strength check. words : what it is."""

    of: Callable[[RunResult], float]
    unit: str
    words: str
    judged: bool = False


def _largest(arrays: Iterable[NDArray[np.float64]]) -> float:
    """Largest magnitude; NaN without any number."""
    most = [float(np.abs(one).max()) for one in arrays if one.size]
    return max(most) if most else math.nan


def _utilisation(run: RunResult) -> float:
    return math.nan if run.verdict is None else highest(run.verdict.table())


def _member_force(run: RunResult) -> float:
    if isinstance(run, MissionRun):
        return _largest([np.nan_to_num(run.extremes["value"].sel(quantity=["tension", "compression"]).values)])
    return _largest(one.arrays["member_force"].values for one in run.forces.values())


def _of_drives(run: MissionRun, quantity: str) -> float:
    return _largest([run.drives["value"].sel(quantity=quantity).values])


def _drive_force(run: RunResult) -> float:
    if isinstance(run, MissionRun):
        return _of_drives(run, "force")
    return _largest(one.arrays["drive_force"].values for one in run.forces.values())


def _drive_power(run: RunResult) -> float:
    if isinstance(run, MissionRun):
        return _of_drives(run, "power")
    moving = [one for one in run.forces.values() if not one.attrs.get("at_rest", 0)]
    return _largest(one.arrays["drive_force"].values * one.motion.arrays["drive_velocity"].values for one in moving)


def _displacement(run: RunResult) -> float:
    found = [one.arrays["displacement"].values for one in run.statics.values() if "displacement" in one.arrays]
    return _largest(np.linalg.norm(one, axis=-1) for one in found)


STANDARD: Mapping[str, Standard] = {
    "peak_utilisation": Standard(_utilisation, "", "highest utilisation of the strength check", judged=True),
    "peak_member_force": Standard(_member_force, "N", "largest magnitude of a member force"),
    "peak_drive_force": Standard(_drive_force, "N or N m", "largest magnitude of a drive force or torque"),
    "peak_drive_power": Standard(_drive_power, "W", "largest magnitude of the power of a drive"),
    "peak_displacement": Standard(_displacement, "m", "largest displacement of a node, of statics"),
    "mass": Standard(lambda run: total_mass(run.model), "kg", "mass of everything"),
}
"""What a study keeps if it names no results, where it is known."""


class Kept:
    """The results of a study: name -> its text."""

    def __init__(self, results: Mapping[str, str]) -> None:
        self.texts = dict(results) or {name: name for name in STANDARD}
        self.chosen = bool(results)
        self._of: dict[str, Standard] = {name: _standard(name, text) for name, text in self.texts.items()}
        self.judged = any(one.judged for one in self._of.values())

    def unit(self, name: str) -> str:
        """The SI unit of a result."""
        return self._of[name].unit

    def __call__(self, run: RunResult) -> dict[str, float]:
        """The numbers of a run by name; NaN what is not known of it."""
        return {name: float(one.of(run)) for name, one in self._of.items()}


def _standard(name: str, text: str) -> Standard:
    if text not in STANDARD:
        raise InputError(f"results.{name}: {text!r} is not known. {nearest(text, STANDARD)}")
    return STANDARD[text]


def scalars(run: RunResult, results: Mapping[str, str] | None = None) -> dict[str, float]:
    """The numbers that a study keeps of a run, in SI; NaN what the run does not have.

    results : name -> what; by default all of ``peak_utilisation``, ``peak_member_force`` N, ``peak_drive_force`` N or N m,
    ``peak_drive_power`` W, ``peak_displacement`` m (of statics), ``mass`` kg.

    Raises
    ------
    InputError : a result that is not known.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> found = kt.studies.scalars(kt.run(model, "turn"), {"peak": "peak_member_force"})
    >>> round(found["peak"], 1)  # N
    16.4
    """
    return Kept(results or {})(run)
