"""The numbers that a study keeps of a run."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.gradients import read_response
from kinetruss.gradients.responses import Sheet
from kinetruss.mechanics import compile
from kinetruss.mechanics.matrices import mass_by_nodes
from kinetruss.results import Column, Columns, Result
from kinetruss.results.arrays import columns_of
from kinetruss.results.user_parts import MARKS
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
    "mass": Standard(lambda run: float(mass_by_nodes(compile(run.model)).sum()), "kg", "mass of everything"),
}
"""What a study keeps if it names no results, where it is known."""


# Responses, over all that a run has.

NAME = re.compile(r"[A-Za-z_]\w*")
JUDGED = {"utilisation", "margin"}
"""Variables that need the strength check."""
CASE = "load_case"


def sheet(run: RunResult) -> Sheet:
    """All variables of a run, without inner parts. With several load cases those of forces have an axis more, ``load_case``."""
    own = Sheet(dict[str, Any](), dict[str, Any]())
    _gather(own, "forces", {case: _columns(one) for case, one in run.forces.items()})
    if run.verdict is not None:
        _gather(own, "verdict", {"": _columns(run.verdict)}, JUDGED)
    for name, group in (("statics", run.statics), ("demand", run.demand), ("sections", run.sections)):
        _gather(own, name, {case: _columns(one) for case, one in group.items()})
    _gather(own, "motion", {"": _columns(run.motion)})
    return own


def _columns(result: Result) -> Columns:
    """What users read of a result."""
    arrays = result.arrays
    return columns_of(result.data) if any(mark in arrays for mark in MARKS.values()) else arrays


def _gather(own: Sheet, kind: str, cases: Mapping[str, Columns], wanted: Container[str] | None = None) -> None:
    """Add the variables of the load cases of one kind of result to those that are there already. An axis with other names than
    one that is there is another axis.
    """
    first = next(iter(cases.values()), {})
    axes = {}
    for name, one in first.items():
        if one.dims == (name,):
            there = own.coords.setdefault(name, one)
            axes[name] = name if np.array_equal(there.values, one.values) else f"{name} of {kind}"
            own.coords.setdefault(axes[name], one)
    for name, one in first.items():
        new = name not in own.variables and name not in axes and (wanted is None or name in wanted)
        if not new or np.asarray(one.values).dtype.kind != "f":
            continue
        dims = tuple(axes.get(dim, dim) for dim in one.dims)
        every = [columns[name].values for columns in cases.values() if name in columns]
        if len(cases) == 1:
            own.variables[name] = Column(dims, one.values, one.attrs)
        elif len(every) == len(cases) and len({np.shape(values) for values in every}) == 1:
            own.variables[name] = Column((CASE, *dims), np.stack(every), one.attrs)
            own.coords.setdefault(CASE, Column((CASE,), np.array(list(cases)), {}))


class Kept:
    """The results of a study: name -> its text."""

    def __init__(self, results: Mapping[str, str]) -> None:
        self.texts = dict(results) or {name: name for name in STANDARD}
        names = {word for text in self.texts.values() for word in NAME.findall(text)}
        self.judged = bool(names & JUDGED) or any(STANDARD[one].judged for one in names & set(STANDARD))
        self.units = {name: STANDARD[text].unit for name, text in self.texts.items() if text in STANDARD}

    def __call__(self, run: RunResult, known: Mapping[str, float] | None = None) -> dict[str, float]:
        """The numbers of a run by name; NaN what is not known of it. known : of `STANDARD`, those that need not be found.

        Raises
        ------
        InputError : a result that the run does not have.
        """
        own: Sheet | None = None
        known = known or {}
        found = {}
        for name, text in self.texts.items():
            if text in STANDARD:
                found[name] = known[text] if text in known else float(STANDARD[text].of(run))
                continue
            own = own or sheet(run)
            found[name], self.units[name] = _response(run, own, known, name, text)
        return found


def _response(run: RunResult, own: Sheet, known: Mapping[str, float], name: str, text: str) -> tuple[float, str]:
    words = [word for word in dict.fromkeys(NAME.findall(text)) if word in STANDARD and word not in own.variables]
    values = {word: known[word] if word in known else STANDARD[word].of(run) for word in words}
    more = {word: Column((), np.asarray(value), {"units": STANDARD[word].unit}) for word, value in values.items()}
    try:
        read = read_response(text, own, more)
    except InputError as error:
        raise InputError(f"results.{name}: {error}") from None
    return read.value, read.unit


def scalars(run: RunResult, results: Mapping[str, str] | None = None) -> dict[str, float]:
    """The numbers that a study keeps of a run, in SI; NaN what the run does not have.

    results : name -> a response over the variables of the run, as ``max(abs(member_force[crank]))`` (`gradients.read_response`;
    with several load cases the forces have the axis ``load_case``), or one of ``peak_utilisation``, ``peak_member_force`` N,
    ``peak_drive_force`` N or N m, ``peak_drive_power`` W, ``peak_displacement`` m (of statics), ``mass`` kg; by default all
    of these.

    Raises
    ------
    InputError : a response that is none, or that names what the run does not have.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> found = kt.studies.scalars(kt.run(model, "turn"), {"peak": "peak_member_force", "crank": "max(member_force[crank])"})
    >>> round(found["peak"], 3), round(found["crank"], 3)  # N
    (9.935, 9.935)
    """
    return Kept(results or {})(run)
