"""Arrays of the members of a model: kinds, masses, constitutive laws."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.structure import CABLE, ENGINEERING, GREEN
from kinetruss.model import Active, Bar, PointMass, WholeModel, natural_length, stiffness

if TYPE_CHECKING:
    from numpy.typing import NDArray


RIGID, DRIVEN, ELASTIC, FREE = range(4)
_KINDS = {"rigid": RIGID, "driven": DRIVEN, "elastic": ELASTIC, "cable": ELASTIC, "free": FREE}


def member_arrays(model: WholeModel, distance: NDArray[np.float64]) -> dict[str, Any]:
    """Arrays of `System` that have one entry a member; `distance` (m,) of the ends at the start, m."""
    members = list(model.members.items())
    active = [(i, member) for i, (_, member) in enumerate(members) if isinstance(member, Active)]
    bars = [(i, name, member) for i, (name, member) in enumerate(members) if not isinstance(member, Active)]
    found = _empty(len(members), distance)
    for i, (_, member) in enumerate(members):
        if member.length is not None:
            found["length0"][i] = member.length
        found["friction"][i] = member.friction
    _bars(model, bars, found)
    found["own_rods"] = found["rods"].copy()
    found["clamped"] = _two_rods(model, active, found)
    # hubs are rigid bodies, with their arms and with the members clamped to them
    of_hubs = {arm.name for arms in model.inner.arms.values() for arm in arms}
    of_hubs |= {name for hub in model.hubs.values() for name in hub.clamped}
    of_hubs |= {one.member for one in model.inner.pivots if one.steady}
    found["compliance"][[i for i, (name, _) in enumerate(members) if name in of_hubs]] = np.nan
    for i, _, bar in bars:
        if bar.kind != "rigid":
            _law(model, bar, distance[i], i, found)
    return found


def _empty(count: int, distance: NDArray[np.float64]) -> dict[str, Any]:
    """The arrays of rigid members without mass, section and friction."""
    return {
        "kind": np.zeros(count, np.int8),
        "length0": distance.copy(),
        "rods": np.zeros((count, 6)),
        "two_rods": np.zeros(count, np.bool_),
        "compliance": np.full(count, np.nan),
        "yielding": np.zeros(count),
        "law": np.zeros(count, np.int8),
        "spring": np.zeros(count),
        "natural": np.ones(count),
        "damping": np.zeros(count),
        "friction": np.zeros((count, 2)),
        "body": np.zeros((count, 4)),
        "is_body": np.zeros(count, np.bool_),
    }


def _bars(model: WholeModel, bars: list[tuple[int, str, Bar]], found: dict[str, Any]) -> None:
    """Kinds, compliances, rods and rigid bodies of bars (i, name, bar)."""
    driven = {drive.bar for drive in model.all_drives.values() if drive.kind == "length"}
    known: dict[tuple[int, int, type[Bar]], tuple[float, float]] = {}
    uniform: list[int] = []
    lines: list[float] = []
    soft: list[float] = []
    for i, _, bar in bars:
        shared = id(bar.section), id(bar.material), type(bar)  # the properties that many bars have in common
        per_length = known.get(shared)
        if per_length is None:
            per_length = known[shared] = _per_length(model.section_of(bar), model.material_of(bar))
        soft.append(per_length[1] if bar.body is None else float("nan"))
        if bar.body is not None:  # a rigid body: no section of its own
            found["is_body"][i] = True
            found["body"][i] = (bar.body.mass, *bar.body.center, bar.body.inertia)
        elif bar.mass is None and not bar.rotary_inertia:
            uniform.append(i)
            lines.append(per_length[0])
        else:
            found["rods"][i, :3] = _rod(model, bar, found["length0"][i])
    places = [i for i, _, _ in bars]
    found["kind"][places] = [DRIVEN if name in driven else _KINDS[bar.kind] for _, name, bar in bars]
    found["compliance"][places] = soft
    # thin uniform rods: m = density A l
    length = found["length0"][uniform]
    found["rods"][uniform, :2] = np.stack([np.array(lines) * length, length], axis=1)


def _two_rods(model: WholeModel, active: list[tuple[int, Active]], found: dict[str, Any]) -> NDArray[np.float64]:
    """Rods and compliances of active members (i, member); returns the masses clamped on them (k, 3): rod, place in 0..1, kg.

    Rod 2 i is the base of member i, with places from end A, rod 2 i + 1 its tube, with places from end A of the tube.
    """
    clamped: list[tuple[int, float, float]] = []
    found["kind"][[i for i, _ in active]] = DRIVEN
    for i, member in active:
        base, tube = member.base, member.tube
        found["two_rods"][i] = True
        bare = np.array([*_rod(model, base, base.length), *_rod(model, tube, tube.length)])
        found["own_rods"][i] = bare
        found["rods"][i] = (*_loaded(bare[:3], base.masses), *_loaded(bare[3:], tube.masses))
        clamped += [(2 * i, one.at / base.length, one.mass) for one in sorted(base.masses, key=lambda one: one.at)]
        clamped += [(2 * i + 1, 1 - one.at / tube.length, one.mass) for one in sorted(tube.masses, key=lambda one: -one.at)]
        found["compliance"][i], found["yielding"][i] = _in_series(model, member)
    return np.array(clamped).reshape(-1, 3)


def _law(model: WholeModel, bar: Bar, distance: float, i: int, found: dict[str, Any]) -> None:
    """Law, stiffness, natural length and damping of bar i; a damped free bar is a spring without stiffness."""
    found["damping"][i] = bar.damping
    if bar.kind in ("elastic", "cable"):
        found["law"][i] = CABLE if bar.kind == "cable" else GREEN if bar.strain == "green" else ENGINEERING
        natural = natural_length(model, bar, distance)
        k = stiffness(model, bar, natural)
        found["natural"][i], found["spring"][i], found["compliance"][i] = natural, k, 1 / (k * natural)
    elif bar.kind == "free" and bar.damping > 0:
        found["law"][i], found["natural"][i] = ENGINEERING, distance


def _rod(model: WholeModel, part: Any, length: float) -> tuple[float, float, float]:
    """Mass, length and rotary inertia m I/A of one rod."""
    section, material = model.section_of(part), model.material_of(part)
    mass = part.mass
    if mass is None:
        mass = material.density * section.area * length if section is not None and material is not None else 0.0
    rotary = mass * section.second_moments[1] / section.area if part.rotary_inertia else 0.0
    return mass, length, rotary


def _loaded(rod: NDArray[np.float64], masses: tuple[PointMass, ...]) -> tuple[float, float, float]:
    """The uniform rod with the mass, first and second moment about its clamped end that a rod has with masses on it.

    m = sum of masses, m l/2 = first moment, m l^2/3 + i = second moment. Its rotary inertia i may be negative.
    """
    m, l, i = rod
    total = m + sum(one.mass for one in masses)
    if not masses or total == 0:
        return m, l, i
    first = m * l / 2 + sum(one.mass * one.at for one in masses)
    second = m * l**2 / 3 + i + sum(one.mass * one.at**2 for one in masses)
    length = 2 * first / total
    return total, length, second - total * length**2 / 3


def _in_series(model: WholeModel, member: Active) -> tuple[float, float]:
    """1/(E A), 1/N, by the length of an active member, and the part of its flexibility that does not change with it, m/N."""
    base, tube = _compliance(model, member.base), _compliance(model, member.tube)
    given = member.compliance
    if given is None:
        return _weakest([base, tube]), 0.0
    screw = base if given.screw is None else 1 / given.screw
    # (l - l_t)/E A + l_t/E A_t + 1/k_nut + 1/k_base
    springs = sum(1 / k for k in (given.nut, given.base) if k is not None)
    return screw, member.tube.length * (tube - screw) + springs


def _compliance(model: WholeModel, part: Any) -> float:
    return _per_length(model.section_of(part), model.material_of(part))[1]


def _per_length(section: Any, material: Any) -> tuple[float, float]:
    """Mass a length (kg/m) and 1/(E A) (1/N); 0 and NaN where section or material is not known."""
    if section is None or material is None:
        return 0.0, float("nan")
    return material.density * section.area, 1 / (material.E * section.area)


def _weakest(values: list[float]) -> float:
    known = [value for value in values if value == value]
    return max(known) if known else float("nan")
