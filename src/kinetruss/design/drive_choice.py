"""The smallest motor, screw and gear of a catalogue that meet the demand."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators
from kinetruss.actuators.demands import STANDSTILL
from kinetruss.design.choices import catalogue, default_drives, with_drives
from kinetruss.design.sizing_result import DriveRow
from kinetruss.design.tube_choice import Loading
from kinetruss.errors import AnalysisError, Fault, InputError, ModelError
from kinetruss.model import Catalogue, Gear, LeadScrew, Material, Mission, Model, Motor, matched
from kinetruss.results import Forces

if TYPE_CHECKING:
    from numpy.typing import NDArray


LIMITS = {"voltage": "max_voltage", "current": "max_current", "motor_speed": "max_speed", "motor_torque": "max_torque"}

Option = tuple[str, Any]
"""A name and a record; the name "" stands for the present record of each member."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Shelves:
    """The candidates, from small to large; (("", None),) if there are none. core : core diameter of screws, m, by name.

    strength : yield strength of the screws over the safety factor, Pa, or None.
    """

    screws: tuple[Option, ...]
    gears: tuple[Option, ...]
    motors: tuple[Option, ...]
    core: dict[str, float]
    strength: float | None

    @property
    def empty(self) -> bool:
        """True if there is nothing to choose."""
        return all(shelf == (("", None),) for shelf in (self.screws, self.gears, self.motors))


@dataclass(frozen=True, kw_only=True, eq=False)
class _Histories:
    """Thrust (N), rate (m/s) and acceleration (m/s^2) of one member, all loadings one after the other."""

    member: str
    thrust: NDArray[np.float64]
    rate: NDArray[np.float64]
    acceleration: NDArray[np.float64]


@dataclass(slots=True)
class _Worst:
    """The highest utilisation so far, and its place."""

    value: float = 0.0
    quantity: str = ""
    member: str = ""

    def take(self, value: float, quantity: str, member: str) -> None:
        if value > self.value or not self.quantity:
            self.value, self.quantity, self.member = value, quantity, member


def core_stress(diameter: float, thrust: float, torque: float) -> float:
    """von Mises stress in the core of a screw under thrust and torque, Pa: sqrt((4 F/(pi d^2))^2 + 3 (16 T/(pi d^3))^2).

    Source: Shigley, Mechanical Engineering Design, power screws (body of the screw).

    >>> round(core_stress(0.01, 1000.0, 0.0) / 1e6, 3)
    12.732
    """
    return math.hypot(4 * thrust / (math.pi * diameter**2), math.sqrt(3) * 16 * torque / (math.pi * diameter**3))


def make_shelves(model: Model, mission: Mission) -> Shelves:
    """The catalogues of screws, gears and motors of a mission.

    Raises
    ------
    ModelError : an unknown or faulty catalogue, one without the requested kind.
    """
    stock: dict[str, Catalogue | None] = {}
    for kind in ("screws", "gears", "motors"):
        chosen, place = getattr(mission.catalogues, kind), ("catalogues", kind)
        stock[kind] = None if chosen is None else catalogue(chosen, place)
        if chosen is not None and not getattr(stock[kind], kind):
            raise ModelError([Fault(place, f"the catalogue has no {kind}.", f"Name one with a table [{kind}].")])
    if not model.active and any(stock.values()):
        raise ModelError([Fault(("catalogues",), "the model has no active members.", "Leave out screws, gears and motors.")])
    screws = stock["screws"].screws if stock["screws"] else {}
    material = stock["screws"].material if stock["screws"] else None
    strength = material.yield_strength if isinstance(material, Material) else None
    safety = (mission.safety or model.safety).yielding
    return Shelves(
        screws=tuple((name, one.screw) for name, one in screws.items()) or (("", None),),
        gears=_shelf(stock["gears"], "gears"),
        motors=_shelf(stock["motors"], "motors"),
        core={name: one.core_diameter for name, one in screws.items() if one.core_diameter is not None},
        strength=None if strength is None else strength / safety,
    )


def _shelf(stock: Catalogue | None, kind: str) -> tuple[Option, ...]:
    return tuple(getattr(stock, kind).items()) if stock is not None else (("", None),)


def choose_drives(
    model: Model, mission: Mission, shelves: Shelves, loadings: list[Loading], forces: dict[str, Forces]
) -> tuple[Model, list[DriveRow]]:
    """The model with the smallest motor, and with it the smallest screw and gear, that meet the demand of each group.

    Raises
    ------
    AnalysisError : no combination meets the demand of a group; the closest one is named.
    """
    rows = []
    names = list(model.active)
    for name, patterns in (mission.drives or default_drives(model)).items():
        members = tuple(dict.fromkeys(one for pattern in patterns for one in matched(names, pattern)))
        histories = [_history(model, member, loadings, forces) for member in members]
        task = _Task(
            model=model,
            mission=mission,
            shelves=shelves,
            loadings=loadings,
            forces=forces,
            name=name,
            members=members,
            histories=histories,
        )
        model, row = _first_sufficient(task)
        rows.append(row)
    return model, rows


def _history(model: Model, member: str, loadings: list[Loading], forces: dict[str, Forces]) -> _Histories:
    at = list(model.members).index(member)

    def joined(name: str) -> NDArray[np.float64]:
        return np.concatenate([one.motion.arrays[name].values[:, at] for one in loadings])

    thrust = -np.concatenate([forces[one.name].arrays["member_force"].values[:, at] for one in loadings])
    rate = joined("length_rate")
    return _Histories(
        member=member,
        thrust=thrust,
        rate=np.where(np.abs(rate) < STANDSTILL, 0.0, rate),
        acceleration=joined("length_acceleration"),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class _Task:
    """The input for the choice of one group of drives."""

    model: Model
    mission: Mission
    shelves: Shelves
    loadings: list[Loading]
    forces: dict[str, Forces]
    name: str
    members: tuple[str, ...]
    histories: list[_Histories]

    def carries(self, worst: _Worst) -> bool:
        """Demand times margin within the limits."""
        return worst.value * self.mission.margin <= 1


def _first_sufficient(task: _Task) -> tuple[Model, DriveRow]:
    """Motor by motor, screw by screw, gear by gear."""
    closest: dict[str, tuple[float, str]] = {}
    shelves, tried = task.shelves, 0
    for motor, screw, gear in itertools.product(shelves.motors, shelves.screws, shelves.gears):
        tried += 1
        worst = _judged(task, screw, gear, motor)
        if task.carries(worst):
            # the full evaluation of the drives decides: it checks more than peaks
            model, worst, where = _confirmed(task, tuple(one for one in (screw, gear, motor) if one[1] is not None))
            if task.carries(worst):
                smaller = [found for name, found in closest.items() if name != motor[0] and found[1]]
                return model, _row(task, model, worst, where, tried, min(smaller, default=(0.0, ""))[1])
        if worst.value < closest.get(motor[0], (math.inf, ""))[0]:
            what = ", ".join(one[0] for one in (motor, screw, gear) if one[0]) or "what the model has"
            text = f"{what}: {worst.quantity} of {worst.member} reaches {worst.value:.4g} times the limit"
            closest[motor[0]] = worst.value, text
    best = min(closest.values(), default=(math.inf, ""))[1]
    margin = f" with a margin of {task.mission.margin:g}" if task.mission.margin > 1 else ""
    raise AnalysisError(
        f"No drive of the catalogues carries group {task.name!r}{margin} ({tried} combinations tried). "
        + (f"Closest is {best}. " if best else "No screw holds by itself and can be turned. ")
        + "Take a catalogue with stronger motors, other gears or screws, or a slower motion."
    )


def _confirmed(task: _Task, chosen: tuple[Option, ...]) -> tuple[Model, _Worst, tuple[float, str]]:
    """The model with a combination, its worst quantity by `actuators.evaluate`, and its time and load case."""
    model = with_drives(task.model, dict.fromkeys(task.members, chosen))
    worst, where = _Worst(), (math.nan, "")
    for loading in task.loadings:
        demand = actuators.evaluate(model, loading.motion, task.forces[loading.name])
        for row in demand.table():
            if row.member in task.members and row.checked and row.rule != "stroke" and row.utilisation > worst.value:
                worst.take(row.utilisation, row.rule, row.member)
                where = row.time, loading.name
    return model, worst, where


def _judged(task: _Task, screw: Option, gear: Option, motor: Option) -> _Worst:
    """The highest utilisation of a combination by the peaks of its quantities; infinite if it is impossible."""
    worst, model = _Worst(), task.model
    for one in task.histories:
        active = model.active[one.member]
        turning = screw[1] or _own(model.screws, active.screw)
        if turning is None:
            raise ModelError([Fault(("active", one.member), "has no screw.", "Give it one, or the mission catalogues.screws.")])
        if task.mission.self_locking and not actuators.is_self_locking(turning):
            worst.take(math.inf, "self-locking", one.member)
            return worst
        driven = motor[1] or _own(model.motors, active.motor)
        stage = gear[1] or _own(model.gears, active.gear)
        for quantity, value in _demands(task.shelves, screw[0], turning, stage, driven, one):
            worst.take(value, quantity, one.member)
        if worst.value == math.inf:
            return worst
    return worst


def _demands(
    shelves: Shelves, name: str, screw: LeadScrew, gear: Gear | None, motor: Motor | None, one: _Histories
) -> Iterator[tuple[str, float]]:
    """Every quantity with a limit, over that limit."""
    try:
        torque = actuators.screw_torque(screw, one.thrust, one.rate)
        largest = float(np.abs(one.thrust).max(initial=0.0))
        raising = actuators.raising_torque(screw, largest)
    except InputError:  # the screw jams
        yield "screw", math.inf
        return
    if shelves.strength is not None and name in shelves.core:
        yield "screw stress", core_stress(shelves.core[name], largest, raising) / shelves.strength
    if motor is None:
        return
    demand = actuators.motor_demand(screw, gear, motor, torque, one.rate, one.acceleration)
    for history, field in LIMITS.items():
        limit = getattr(motor, field)
        if limit is not None:
            yield history.removeprefix("motor_"), float(np.abs(demand[history]).max(initial=0.0)) / limit


def _own(table: dict[str, Any], named: Any) -> Any:
    return table[named] if isinstance(named, str) else named


def _row(task: _Task, after: Model, worst: _Worst, where: tuple[float, str], tried: int, against: str) -> DriveRow:
    first, given = after.active[task.members[0]], task.model.active[task.members[0]]
    screws = [_own(after.screws, after.active[one].screw) for one in task.members]
    return DriveRow(
        name=task.name,
        members=task.members,
        before=(_label(given.screw), _label(given.gear), _label(given.motor)),
        screw=_label(first.screw),
        gear=_label(first.gear),
        motor=_label(first.motor),
        self_locking=all(one is not None and actuators.is_self_locking(one) for one in screws),
        utilisation=worst.value,
        quantity=worst.quantity,
        member=worst.member,
        time=where[0],
        load_case=where[1],
        tried=tried,
        against=against,
    )


def _label(named: Any) -> str:
    return named if isinstance(named, str) else "" if named is None else "(own)"
