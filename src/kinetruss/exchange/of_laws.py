"""Angles of a model that act: drives, springs and couplings, as coordinates of joints of a robot."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robots import JointCoupling, LeftOut, Pivot, Robot
from kinetruss.mechanics import compile
from kinetruss.mechanics.positions import drive_values
from kinetruss.model import GROUND, Gear, Model, Spring

if TYPE_CHECKING:
    from numpy.typing import NDArray


LAWS = ("play", "table")
"""Parts of the law of a spring that other programs do not have."""


@dataclass(frozen=True, slots=True)
class Turn:
    """An angle between two parts about an axis through nodes; value : in the pose, rad."""

    name: str
    parts: frozenset[int]
    first: int
    axis: tuple[int, ...]
    along: Any
    value: float
    driven: bool


@dataclass(frozen=True, slots=True)
class Place:
    """A coordinate at a joint: sign times the value of the joint, plus that in the pose, rad or m."""

    pivot: str
    sign: float
    value: float


def acting(model: Model) -> dict[str, Any]:
    """Coordinates by name: of drives theirs, of springs and couplings ``NAME.k`` with the number of the term."""
    found: dict[str, Any] = {}
    for name, coupling in model.whole.couplings.items():
        found |= {f"{name}.{k}": one for k, (one, _) in enumerate(coupling.terms)}
    for name, spring in model.springs.items():
        found |= {f"{name}.{k}": one for k, (one, _) in enumerate(spring.parts)}
    return found | dict(model.drives)


def values_of(model: Model, coordinates: Mapping[str, Any], x: NDArray[np.float64]) -> dict[str, float]:
    """Values of coordinates, rad or m, at x (n, 3), m; without offsets and cosines, which joints do not have."""
    place = {name: k for k, name in enumerate(model.whole.nodes)}
    found: dict[str, float] = {}
    drives, same = dict(model.drives), {_key(one): name for name, one in model.drives.items()}
    for name, one in coordinates.items():
        if one.kind == "length":
            a, b = (x[place[node]] for node in model.whole.members[one.bar].ends)
            found[name] = float(np.linalg.norm(b - a))
        elif one.kind == "coordinate":
            found[name] = float(x[place[one.node], "xyz".index(one.axis)])
        elif one.kind in ("angle", "hinge") and _key(one) not in same:
            drives[name], same[_key(one)] = one, name
    system = compile(model.with_(drives=drives))
    values = drive_values(system, x[None], 0 * x[None], 0 * x[None])[0][0].tolist()
    of = dict(zip(system.drives, values, strict=True))
    return found | {name: of[same[_key(one)]] for name, one in coordinates.items() if _key(one) in same}


def _key(one: Any) -> str:
    """Equal for coordinates that measure the same."""
    return str(one.model_dump_json(exclude={"gear", "motor", "amplifier"}))


def sprung(
    model: Model, places: Mapping[str, Place], start: Mapping[str, float], pivots: Sequence[Pivot], left: list[LeftOut]
) -> list[Pivot]:
    """The joints with the springs of the model on them. start : values of the coordinates in the model, rad or m."""
    laws: dict[str, list[tuple[float, float, float, float]]] = {}
    for name, spring in model.springs.items():
        if len(spring.parts) == 1 and (place := places.get(f"{name}.0")) is not None:
            law = _law(name, spring, start[f"{name}.0"], left)
            laws.setdefault(place.pivot, []).append((law[0], place.sign * (law[1] - place.value), *law[2:]))
    return [replace(one, spring=_together(laws[one.name])) if one.name in laws else one for one in pivots]


def geared(model: Model, pivots: Sequence[Pivot], left: list[LeftOut]) -> list[Pivot]:
    """The joints with the ratios of the gears of their drives; what else an actuator has is listed."""
    ratios: dict[str, float] = {}
    for name, active in model.actuators.items():
        gear = active.gear if not isinstance(active.gear, str) else model.gears[active.gear]
        if name in model.drives and gear is not None:
            ratios[name] = gear.ratio
            if active.motor is None and active.amplifier is None and gear == Gear(ratio=gear.ratio):
                continue
        left.append(LeftOut("actuators", name, "of an actuator its drive is carried, and the ratio of a gear at an angle"))
    return [one if one.drive not in ratios else replace(one, ratio=ratios[one.drive]) for one in pivots]


def length_spring(name: str, spring: Spring, start: float, left: list[LeftOut]) -> tuple[float, float, float, float]:
    """Stiffness, N/m, length without force, m, damping, N s/m, and friction, N, of a spring on a length."""
    return _law(name, spring, start, left)


def _law(name: str, spring: Spring, start: float, left: list[LeftOut]) -> tuple[float, float, float, float]:
    """Stiffness, value of the coordinate without force, damping, friction. What they are not is listed."""
    factor = spring.parts[0][1]
    left += [LeftOut(f"{word} of a spring", name, "is not carried") for word in LAWS if getattr(spring, word)]
    if spring.friction and spring.slip != Spring.model_fields["slip"].default:
        left.append(LeftOut("slip of a spring", name, "is not carried: friction there is Coulomb's"))
    k, rest = spring.stiffness * factor**2, start if spring.rest is None else spring.rest / factor
    if spring.table or spring.play:
        k = 0.0
    if spring.preload and not k:
        left.append(LeftOut("preload of a spring", name, "is not carried without a stiffness"))
    elif spring.preload:
        rest -= spring.preload * factor / k
    return k, rest, spring.damping * factor**2, spring.friction * abs(factor)


def _together(laws: Sequence[tuple[float, float, float, float]]) -> tuple[float, float, float, float]:
    """Springs side by side: their sum is one about the mean of the rests, weighted by the stiffnesses."""
    k = sum(one[0] for one in laws)
    rest = sum(one[0] * one[1] for one in laws) / k if k else 0.0
    return k, rest, sum(one[2] for one in laws), sum(one[3] for one in laws)


def couplings_of(model: Model, places: Mapping[str, Place], left: list[LeftOut]) -> list[JointCoupling]:
    """The couplings whose coordinates all are values of joints; they hold in the pose, where all these are 0."""
    found = []
    for name, coupling in model.whole.couplings.items():
        own = [places.get(f"{name}.{k}") for k in range(len(coupling.terms))]
        factors: dict[str, float] = {}
        for place, (_, factor) in zip(own, coupling.terms, strict=True):
            if place is not None:
                factors[place.pivot] = factors.get(place.pivot, 0.0) + factor * place.sign
        if None in own:
            what = model.whole.inner.part_of(name)
            left.append(LeftOut("couplings", what, "it couples what is no angle of a joint: the robot has more freedoms"))
        else:
            found.append(JointCoupling(name=name, factors=factors, where=name))
    return found


def armed(robot: Robot, held: Collection[str]) -> Robot:
    """The robot with each balanced wheel on the ground that only turns with one joint as the `armature` of this joint.

    held : links that something else holds: they are no such wheels.
    """
    pivots = {one.name: one for one in robot.pivots}
    links, couplings = dict(robot.links), []
    busy = {name for one in robot.closures for name in one.links} | {one.parent for one in robot.pivots} | set(held)
    counts = Counter(name for one in robot.couplings for name in one.factors)
    for one in robot.couplings:
        wheel = next((name for name in one.factors if counts[name] == 1 and _wheel(pivots[name], links, busy)), None)
        if len(one.factors) != 2 or wheel is None:
            couplings.append(one)
            continue
        (joint,) = one.factors.keys() - {wheel}
        gone = pivots.pop(wheel)
        given = links.pop(gone.child).properties
        inertia = 0.0 if given is None else float(gone.axis @ given.inertia @ gone.axis)
        added = inertia * (one.factors[joint] / one.factors[wheel]) ** 2
        pivots[joint] = replace(pivots[joint], armature=pivots[joint].armature + added)
    return replace(robot, links=links, pivots=list(pivots.values()), couplings=couplings)


def _wheel(pivot: Pivot, links: Mapping[str, Any], busy: Collection[str]) -> bool:
    """True for a hinge without a law between the ground and a link whose centre is on its axis."""
    if (
        pivot.kind != "revolute"
        or pivot.parent != GROUND
        or pivot.drive is not None
        or any(pivot.spring)
        or pivot.child in busy
    ):
        return False
    given = links[pivot.child].properties
    if given is None:
        return True
    off = np.cross(pivot.axis, given.center - pivot.origin[:3, 3])
    return bool(float(np.linalg.norm(off)) ** 2 * given.mass <= 1e-12 * float(np.trace(given.inertia)))
