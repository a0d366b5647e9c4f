"""Arrays of the members of a model: which there are and the numbers of them; from these masses and constitutive laws."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.numbers import entries
from kinetruss.kernels.structure.structure import CABLE, ENGINEERING, GREEN, NONE
from kinetruss.model import Active, Bar, PointMass, WholeModel, natural_length

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.matter import Matter
    from kinetruss.elements.numbers import Array, Numbers


RIGID, DRIVEN, ELASTIC, FREE = range(4)
_KINDS = {"rigid": RIGID, "driven": DRIVEN, "elastic": ELASTIC, "cable": ELASTIC, "free": FREE}
_GIVEN = ("length", "friction", "body", "mass", "damping", "natural", "stiffness", "pretension")
_NOWHERE, _NOTHING = np.zeros(0, np.int64), np.zeros(0)


@dataclass(frozen=True, kw_only=True, eq=False)
class Members:
    """Which members there are, and for which numbers are given.

    fields : those of `System` in which there are no numbers. at : by name indices of members: active; body, planar ones; bars,
    the others; elastic, elastic bars and cables, whose records are `laws`; length, damping, those that have one; friction
    (k, 2), ends that have some; unknown, whose compliance is that of a hub. Places in `bars` : mass, given; massless; rotary,
    with rotary inertia; matter (b, 2) : of section and material of each. Places in `elastic` : natural, stiffness, pretension.
    """

    matter: Matter
    fields: dict[str, Any]
    at: dict[str, NDArray[np.int64]]
    laws: tuple[Bar, ...]
    active: ActiveParts


@dataclass(frozen=True, kw_only=True, eq=False)
class ActiveParts:
    """Bases and tubes of active members one behind the other: matter (2 a, 2) places of section and material; mass (g,) of
    which is given; rotary (2 a,); points : of each the masses on it, in their order along it in `clamped`; springs : of each
    member the numbers given for screw, nut and base by name, or None.
    """

    matter: NDArray[np.int64]
    mass: dict[int, int]
    rotary: tuple[bool, ...]
    points: tuple[tuple[int, ...], ...]
    clamped: tuple[tuple[int, int], ...]
    springs: tuple[dict[str, int] | None, ...]


def members_of(model: WholeModel, matter: Matter) -> tuple[Members, dict[str, Any]]:
    """The members of a model, and their numbers."""
    driven = {drive.bar for drive in model.all_drives.values() if drive.kind == "length"}
    given: dict[str, list[tuple[Any, Any]]] = {name: [] for name in _GIVEN}
    at: dict[str, list[Any]] = {name: [] for name in ("bars", "matter", "massless", "rotary", "elastic", "active")}
    kind, law, laws = [], [], list[Bar]()
    for i, (name, one) in enumerate(model.members.items()):
        if one.length is not None:
            given["length"].append((i, one.length))
        if any(one.friction):
            given["friction"] += [((i, end), value) for end, value in enumerate(one.friction) if value]
        if isinstance(one, Active):
            kind.append(DRIVEN)
            law.append(NONE)
            at["active"].append(i)
            continue
        kind.append(DRIVEN if name in driven else _KINDS[one.kind])
        law.append(NONE if one.kind in ("rigid", "driven") else _law(i, one, laws, at, given))
        if one.body is not None:  # a rigid body: no section of its own
            given["body"].append((i, (one.body.mass, *one.body.center, one.body.inertia)))
            continue
        if one.mass is not None or one.rotary_inertia:
            _rod(len(at["bars"]), one, at, given)
        at["bars"].append(i)
        at["matter"].append(matter.of(one))
    at |= {name: [place for place, _ in own] for name, own in given.items()} | {"unknown": _of_hubs(model)}
    places = {name: np.array(own, np.int64) if own else _NOWHERE for name, own in at.items()}
    places |= {name: places[name].reshape(-1, 2) for name in ("friction", "matter")}
    fields: dict[str, Any] = {"kind": np.array(kind, np.int8), "law": np.array(law, np.int8)}
    for name, which in (("two_rods", "active"), ("is_body", "body")):
        fields[name] = np.zeros(len(law), np.bool_)
        fields[name][places[which]] = True
    parts, of_parts = _parts([*model.active.values()], matter)
    numbers = {f"bar_{name}": np.array([one for _, one in own], float) if own else _NOTHING for name, own in given.items()}
    numbers["bar_body"] = numbers["bar_body"].reshape(-1, 4)
    return Members(matter=matter, fields=fields, at=places, laws=tuple(laws), active=parts), numbers | of_parts


def _law(i: int, bar: Bar, laws: list[Bar], at: dict[str, list[Any]], given: dict[str, list[Any]]) -> int:
    """The law of bar i, with its numbers; a damped free bar is a spring without stiffness."""
    if bar.kind == "free":
        if bar.damping > 0:
            given["damping"].append((i, bar.damping))
        return ENGINEERING if bar.damping > 0 else NONE
    given["damping"].append((i, bar.damping))
    k = len(laws)
    if bar.natural_length is not None:
        given["natural"].append((k, bar.natural_length))
    if bar.stiffness is not None:
        given["stiffness"].append((k, bar.stiffness))
    if bar.pretension is not None:
        given["pretension"].append((k, bar.pretension))
    at["elastic"].append(i)
    laws.append(bar)
    return CABLE if bar.kind == "cable" else GREEN if bar.strain == "green" else ENGINEERING


def _rod(k: int, bar: Bar, at: dict[str, list[Any]], given: dict[str, list[Any]]) -> None:
    """The mass that is given for a bar, and its rotary inertia."""
    if bar.mass:
        given["mass"].append((k, bar.mass))
    elif bar.mass is not None:
        at["massless"].append(k)
    if bar.rotary_inertia:
        at["rotary"].append(k)


def _of_hubs(model: WholeModel) -> list[int]:
    """The members of hubs, which are rigid bodies, with their arms and with the members clamped to them."""
    names = {arm.name for arms in model.inner.arms.values() for arm in arms}
    names |= {name for hub in model.hubs.values() for name in hub.clamped}
    names |= {one.member for one in model.inner.pivots if one.steady}
    return [i for i, name in enumerate(model.members) if name in names] if names else []


def _parts(active: list[Active], matter: Matter) -> tuple[ActiveParts, dict[str, Any]]:
    """Bases and tubes of active members, and their numbers."""
    if not active:
        return _NO_PARTS, _NO_NUMBERS
    parts = [part for one in active for part in (one.base, one.tube)]
    points, clamped, every, springs, values = [], [], list[PointMass](), list[dict[str, int] | None](), list[float]()
    for r, part in enumerate(parts):
        own = range(len(every), len(every) + len(part.masses))
        every += part.masses
        points.append(tuple(own))
        # from end A of the member, also those that are given from end B
        order = sorted((-every[k].at if r % 2 else every[k].at, k) for k in own)
        clamped += [(r, k) for _, k in order]
    for one in active:
        if one.compliance is None:
            springs.append(None)
            continue
        some = {name: value for name in ("screw", "nut", "base") if (value := getattr(one.compliance, name)) is not None}
        springs.append({name: len(values) + k for k, name in enumerate(some)})
        values += some.values()
    massive = [r for r, part in enumerate(parts) if part.mass is not None]
    found = ActiveParts(
        matter=np.array([matter.of(part) for part in parts], np.int64).reshape(-1, 2),
        mass={r: k for k, r in enumerate(massive)},
        rotary=tuple(part.rotary_inertia for part in parts),
        points=tuple(points),
        clamped=tuple(clamped),
        springs=tuple(springs),
    )
    return found, {
        "part_length": np.array([part.length for part in parts], float),
        "part_mass": np.array([parts[r].mass for r in massive], float),
        "point_at": np.array([one.at for one in every], float),
        "point_mass": np.array([one.mass for one in every], float),
        "part_spring": np.array(values, float),
    }


_NO_PARTS = ActiveParts(matter=np.zeros((0, 2), np.int64), mass={}, rotary=(), points=(), clamped=(), springs=())
_NO_NUMBERS = dict.fromkeys(("part_length", "part_mass", "point_at", "point_mass", "part_spring"), _NOTHING)


def member_arrays(members: Members, numbers: Numbers, distance: Array) -> dict[str, Any]:
    """Arrays of `System` that have one entry a member and follow from numbers; `distance` (m,) of the ends at the start, m."""
    at, count = members.at, len(members.fields["kind"])
    found = {name: numbers.full(count, value=value) for name, value in _FIELDS.items()}
    found |= {"length0": distance.copy(), "rods": numbers.full(count, 6), "body": numbers.full(count, 4)}
    found["friction"] = numbers.full(count, 2)
    found["length0"][..., at["length"]] = numbers["bar_length"]
    found["damping"][..., at["damping"]] = numbers["bar_damping"]
    found["body"][..., at["body"], :] = numbers["bar_body"]
    if len(at["friction"]):
        found["friction"][..., at["friction"][:, 0], at["friction"][:, 1]] = numbers["bar_friction"]
    area = members.matter.areas(numbers)
    EA = _bars(members, numbers, area, found)
    own = at["matter"][:, 0] >= 0
    found["area"][..., at["bars"][own]] = area[..., at["matter"][own, 0]]
    found["own_rods"] = found["rods"].copy()
    found["clamped"] = _active(members, numbers, area, found)
    found["compliance"][..., at["unknown"]] = np.nan
    _laws(members, numbers, distance, EA, found)
    return members.fields | found


_FIELDS = {"area": np.nan, "compliance": np.nan, "yielding": 0.0, "spring": 0.0, "natural": 1.0, "damping": 0.0}
"""Arrays with one number a member, and what it is for a rigid one without section."""


def per_length(matter: NDArray[np.int64], numbers: Numbers, area: Array) -> tuple[Array, Array]:
    """Mass a length (kg/m) and E A (N), (copies, k), of parts by section and material; 0 and NaN where one is not known."""
    known = np.flatnonzero((matter >= 0).all(axis=1))
    section, material = matter[known].T
    line, EA = numbers.full(len(matter)), numbers.full(len(matter), value=np.nan)
    own = area[..., section]
    line[..., known], EA[..., known] = numbers["density"][..., material] * own, numbers["E"][..., material] * own
    return line, EA


def _bars(members: Members, numbers: Numbers, area: Array, found: dict[str, Any]) -> Array:
    """Compliances and rods of bars; gives their E A, N, among all members."""
    at = members.at
    bars, matter = at["bars"], at["matter"]
    line, EA = per_length(matter, numbers, area)
    length = found["length0"][..., bars]
    # thin uniform rods: m = density A l
    mass = line * length
    mass[..., at["mass"]], mass[..., at["massless"]] = numbers["bar_mass"], 0.0
    found["rods"][..., bars, 0], found["rods"][..., bars, 1] = mass, length
    shapes = members.matter.shapes(numbers) if len(at["rotary"]) else []
    for k in at["rotary"].tolist():
        section = matter[k, 0]
        found["rods"][..., bars[k], 2] = mass[..., k] * shapes[section].second_moments[1] / area[..., section]
    known = np.flatnonzero((matter >= 0).all(axis=1))
    found["compliance"][..., bars[known]] = 1 / EA[..., known]
    every: Array = np.full_like(found["compliance"], np.nan)
    every[..., bars] = EA
    return every


def _active(members: Members, numbers: Numbers, area: Array, found: dict[str, Any]) -> Array:
    """Rods and compliances of active members; returns the masses clamped on them (k, 3): rod, place in 0..1, kg.

    Rod 2 i is the base of member i, with places from end A, rod 2 i + 1 its tube, with places from end A of the tube.
    """
    parts, active = members.active, members.at["active"]
    clamped = numbers.full(len(parts.clamped), 3)
    if not len(active):
        return clamped
    line, EA = per_length(parts.matter, numbers, area)
    lines, lengths, springs = entries(line), numbers.each("part_length"), numbers.each("part_spring")
    known = np.flatnonzero((parts.matter >= 0).all(axis=1))
    soft = np.full_like(EA, np.nan)
    soft[..., known] = 1 / EA[..., known]
    soft = entries(soft)
    shapes, areas = members.matter.shapes(numbers), entries(area)
    given, places, masses = (numbers.each(name) for name in ("part_mass", "point_at", "point_mass"))
    for r, length in enumerate(lengths):
        mass = given[parts.mass[r]] if r in parts.mass else lines[r] * length
        section = parts.matter[r, 0]
        rotary = mass * shapes[section].second_moments[1] / areas[section] if parts.rotary[r] else 0.0
        bare = (mass, length, rotary)
        on = [(places[k], masses[k]) for k in parts.points[r]]
        for c, (own, loaded) in enumerate(zip(bare, _loaded(bare, on), strict=True), 3 * (r % 2)):
            found["own_rods"][..., active[r // 2], c], found["rods"][..., active[r // 2], c] = own, loaded
    for k, (i, stated) in enumerate(zip(active.tolist(), parts.springs, strict=True)):
        own = None if stated is None else {name: springs[place] for name, place in stated.items()}
        series = _in_series(soft[2 * k], soft[2 * k + 1], lengths[2 * k + 1], own)
        found["compliance"][..., i], found["yielding"][..., i] = series
    for row, (r, k) in enumerate(parts.clamped):
        share = places[k] / lengths[r]
        clamped[..., row, 0], clamped[..., row, 1] = 2 * active[r // 2] + r % 2, 1 - share if r % 2 else share
        clamped[..., row, 2] = masses[k]
    return clamped


def _laws(members: Members, numbers: Numbers, distance: Array, EA: Array, found: dict[str, Any]) -> None:
    """Stiffness and natural length of elastic bars; a damped free bar is a spring without stiffness."""
    at, lawful = members.at, members.at["damping"]
    found["natural"][..., lawful] = distance[..., lawful]
    elastic = at["elastic"]
    natural, EA = distance[..., elastic], EA[..., elastic]
    natural[..., at["natural"]] = numbers["bar_natural"]
    given = numbers.full(len(elastic), value=np.nan)
    given[..., at["stiffness"]] = numbers["bar_stiffness"]
    for k, force in zip(at["pretension"].tolist(), numbers.each("bar_pretension"), strict=True):
        known = k in at["stiffness"]
        stiff, apart = (given if known else EA)[..., k], distance[..., elastic[k]]
        natural[..., k] = _pretensioned(members.laws[k], force, stiff, apart, known)
    spring = EA / natural
    spring[..., at["stiffness"]] = numbers["bar_stiffness"]
    found["natural"][..., elastic], found["spring"][..., elastic] = natural, spring
    found["compliance"][..., elastic] = 1 / (spring * natural)


def _pretensioned(bar: Bar, force: Any, stiff: Any, distance: Any, known: bool) -> Any:
    """Natural length (m) of a bar that has a force (N) at the distance of its ends; stiff : N/m if it is `known`, else E A, N.

    Of complex numbers the length of their real parts, and one step of Newton for what the imaginary parts add.
    """
    real = np.broadcast_arrays(*(np.real(one) for one in (force, stiff, distance)))
    found = np.empty(real[0].shape)
    for place in np.ndindex(found.shape):
        N, k, l = (float(one[place]) for one in real)
        own: Any = SimpleNamespace(pretension=N, strain=bar.strain, stiffness=k if known else None)
        section, material = SimpleNamespace(area=1.0), SimpleNamespace(E=k)
        model: Any = SimpleNamespace(section_of=lambda _, one=section: one, material_of=lambda _, one=material: one)
        found[place] = natural_length(model, own, l)
    if not any(map(np.iscomplexobj, (force, stiff, distance))):
        return found
    from kinetruss.kernels.structure.laws import bar_tension  # compiled; real numbers do not need it

    law, tension = GREEN if bar.strain == "green" else ENGINEERING, bar_tension.py_func

    def excess(l0: Any, N: Any, k: Any, l: Any) -> Any:
        return tension(law, k if known else k / l0, l0, 0.0, l, 0.0) - N

    slope = excess(found + 1e-30j, *real).imag / 1e-30
    return found - (excess(found, force, stiff, distance) - excess(found, *real)) / slope


def _loaded(rod: tuple[Any, Any, Any], masses: list[tuple[Any, Any]]) -> tuple[Any, Any, Any]:
    """The uniform rod with the mass, first and second moment about its clamped end that a rod has with masses (at, mass) on it.

    m = sum of masses, m l/2 = first moment, m l^2/3 + i = second moment. Its rotary inertia i may be negative.
    """
    m, l, i = rod
    total = m + sum(mass for _, mass in masses)
    if not masses or np.all(np.real(total) == 0):
        return m, l, i
    first = m * l / 2 + sum(mass * at for at, mass in masses)
    second = m * l**2 / 3 + i + sum(mass * at**2 for at, mass in masses)
    length = 2 * first / total
    return total, length, second - total * length**2 / 3


def _in_series(base: Any, tube: Any, length: Any, given: dict[str, Any] | None) -> tuple[Any, Any]:
    """1/(E A), 1/N, by the length of an active member from those of base and tube, and the part of its flexibility that does
    not change with it, m/N; length : of the tube, m.
    """
    if given is None:
        return _weakest([base, tube]), 0.0
    screw = 1 / given["screw"] if "screw" in given else base
    # (l - l_t)/E A + l_t/E A_t + 1/k_nut + 1/k_base
    springs = sum(1 / given[name] for name in ("nut", "base") if name in given)
    return screw, length * (tube - screw) + springs


def _weakest(values: list[Any]) -> Any:
    """The largest known one; of equal ones, where there is no derivative, the first."""
    known = [value for value in values if not np.isnan(value).any()]
    return max(known, key=lambda value: float(np.ravel(value)[0].real)) if known else float("nan")
