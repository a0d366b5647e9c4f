"""Supports: how the ground holds a node in each direction, along axes of its own; and the inner parts that they become.

All that a support is made of is an element that any model can have: a fixed coordinate, a coupling, a spring or a stop.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, NamedTuple

from pydantic import BeforeValidator, Field, model_validator

from kinetruss.display import quantity
from kinetruss.errors import Fault, shown
from kinetruss.model.drives import AngleDrive, CoordinateDrive, Coupling, Spring
from kinetruss.model.inner import Owner
from kinetruss.model.joints import GROUND
from kinetruss.model.members import Brace, Node
from kinetruss.model.record import Angle, Coordinate, Number, OneForBoth, Record, Series, SpringDamping, SpringStiffness, Width
from kinetruss.model.references import NodeName
from kinetruss.model.stops import Stop
from kinetruss.units import Tagged

if TYPE_CHECKING:
    from collections.abc import Iterator

    from kinetruss.model.data import ModelData
    from kinetruss.model.whole import WholeModel

TURNS = {"rotation_x": 0, "rotation_y": 1, "rotation_z": 2}
SQUARE = 1e-6
"""Cosine of the angle of two axes up to which they are perpendicular."""
ALONG = 0.95
"""Cosine of an axis with global y from which on the other axis lies in its plane with global z."""


class Restraint(Record):
    """How a support holds one direction of a node: rigidly, by a spring, or behind a gap.

    stiffness : N/m, of a rotation N m/rad; by default it is held rigidly.
    damping : of the spring, N s/m or N m s/rad.
    gap : how far the node moves against and along the direction before the support acts: two distances, m or rad, or one for
        both sides; null where it is not held on that side, so that ``[0, null]`` only presses back. The stiffness is that of
        the contact behind it.
    settlement : displacement of the support along the direction, m or rad.

    In a model file ``held`` stands for a rigid one, and a number for that of a stiffness.

    >>> import kinetruss as kt
    >>> kt.Restraint(stiffness="2 kN/mm", gap=(0, None))
    Restraint(stiffness=2000000.0, gap=(0.0, None))
    """

    stiffness: SpringStiffness | None = None
    damping: SpringDamping = 0.0
    gap: Annotated[tuple[Width | None, Width | None], OneForBoth()] | None = None
    settlement: Coordinate = 0.0

    @model_validator(mode="after")
    def _sound(self) -> Restraint:
        if self.stiffness == 0.0:
            raise ValueError("stiffness is 0: the direction is not held. Write free, or leave it out.")
        if self.damping and self.stiffness is None:
            raise ValueError("damping is that of a spring, but the direction is held rigidly. Give a stiffness too.")
        if self.gap is None:
            return self
        if self.gap == (None, None):
            raise ValueError("the gap has no end, so that nothing is held. Give one of its two distances, or write free.")
        if self.stiffness is None:
            raise ValueError("behind the gap there is a rigid support. Give the stiffness of the contact, e.g. 1 MN/mm.")
        if self.settlement:
            raise ValueError("gap and settlement both say where the support is. Count the gap from the settled support.")
        if self.damping:
            raise ValueError("damping is that of a spring without a gap. Leave it out, or give a stop (`stops`).")
        return self

    @property
    def rigid(self) -> bool:
        """True if the direction is held at its place."""
        return self.stiffness is None and not self.settlement

    if TYPE_CHECKING:

        def __init__(self, *, gap: Any = None, **numbers: Any) -> None: ...


def _restraint(value: Any) -> Any:
    """Words and stiffnesses as records."""
    if isinstance(value, str) and value in ("held", "free"):
        return {} if value == "held" else None
    if isinstance(value, str) and not any(c.isdigit() for c in value):
        raise ValueError(f"{shown(value)} is no way to hold a node. Write held, free, a stiffness, or a record with gap.")
    if isinstance(value, (str, int, float)) and not isinstance(value, bool):
        return {"stiffness": value}
    return value


Held = Annotated[Restraint | None, BeforeValidator(_restraint)]
Vector = Annotated[tuple[Number, ...], Field(min_length=2, max_length=3), Series]


class Support(Record):
    """A support: what of the translations and rotations of a node the ground holds, and how.

    x, y, z : translations along the axes of the support: ``held``, ``free`` (by default), a stiffness (N/m), or a record
        with stiffness, gap and settlement (`Restraint`).
    rotation : in the plane; in space about all three axes. At a node whose rotation beams share.
    rotation_x, rotation_y, rotation_z : in space, about one axis.
    turned : angle from the global axes to those of the support, in the plane, counter-clockwise.
    along : the axis x of the support in place of an angle: a vector, or a node towards which it points.
    across : its axis y, perpendicular to `along`, likewise; by default in the plane of `along` and global y (global z if that
        is within 18 degrees of `along`), on its side. In space z is x cross y.

    Results have one reaction for each support, whatever it is made of, in global axes and, if it is turned, in its own. In
    large rotations a rotation about an axis is the angle, about this axis, of a direction across it that turns with the node:
    about x that of y, about y that of z, about z that of x.

    >>> import kinetruss as kt
    >>> roller = kt.Support(y="held", turned="30 deg")
    >>> spring = kt.Support(x="held", y="2 kN/mm", rotation="50 kN m/rad")
    >>> spring.rotation
    Restraint(stiffness=50000.0)
    """

    x: Held = None
    y: Held = None
    z: Held = None
    rotation: Held = None
    rotation_x: Held = None
    rotation_y: Held = None
    rotation_z: Held = None
    turned: Angle = 0.0
    along: NodeName | Vector | None = None
    across: NodeName | Vector | None = None

    units: ClassVar[dict[str, str]] = {"length": "N/m and m", "angle": "N m/rad and rad"}

    @model_validator(mode="after")
    def _sound(self) -> Support:
        if not (self.shifts or self.turns):
            raise ValueError("the support holds nothing. Give what it holds, e.g. x: held, or rotation: 50 kN m/rad.")
        if one := next((name for name in TURNS if self.rotation and getattr(self, name)), None):
            raise ValueError(f"rotation is about all axes, {one} about one of them. Give one of both.")
        if self.turned and self.along is not None:
            raise ValueError("turned and along both say how the support stands. Leave one out.")
        if self.across is not None and self.along is None:
            raise ValueError("across is the second axis of the support. Give its first one too, along.")
        for wanted, names in (("length", "xyz"), ("angle", ("rotation", *TURNS))):
            for name in names:
                if (one := getattr(self, name)) is not None:
                    self._check_units(name, one, wanted)
        return self

    def _check_units(self, name: str, one: Restraint, wanted: str) -> None:
        """Units that were written are those of a translation, or of a rotation."""
        values: list[tuple[str, Any]] = [("gap", value) for value in one.gap or ()]
        values += [("stiffness", one.stiffness), ("settlement", one.settlement), ("damping", one.damping)]
        for field, value in values:
            if isinstance(value, Tagged) and value.quantity not in ("", None, wanted):
                word = "rotation" if wanted == "angle" else "translation"
                raise ValueError(f"{name}: {field} is not that of a {word}. Use {self.units[wanted]}.")

    @property
    def shifts(self) -> dict[int, Restraint]:
        """The translations that are not free: 0, 1, 2 for x, y, z."""
        return {k: one for k, name in enumerate("xyz") if (one := getattr(self, name)) is not None}

    @property
    def turns(self) -> dict[int, Restraint]:
        """The rotations that are not free, by the axis about which they are: in the plane the third."""
        if self.rotation is not None:
            return dict.fromkeys((0, 1, 2), self.rotation)
        return {k: one for name, k in TURNS.items() if (one := getattr(self, name)) is not None}

    def turns_in(self, dim: int) -> dict[int, Restraint]:
        """Those in a model with `dim` axes."""
        return {k: one for k, one in self.turns.items() if dim == 3 or k == 2}

    if TYPE_CHECKING:

        def __init__(self, **fields: Any) -> None: ...


class Holding(NamedTuple):
    """An inner coupling, spring or stop of a support: the table and its name there; the node; which axis it is along or about,
    that axis in space; whether it is a rotation, and then the node of the frame whose direction turns.
    """

    table: str
    name: str
    node: str
    axis: int
    vector: tuple[float, float, float]
    arm: str = ""

    def text(self, dim: int) -> str:
        """The support and its direction: ``A (y)``."""
        axis = "xyz"[self.axis]
        return f"{self.node} ({(f'rotation {axis}' if dim == 3 else 'rotation') if self.arm else axis})"


def axes_of_support(model: ModelData, node: str) -> tuple[tuple[float, ...], ...]:
    """The axes of the support at a node as rows, (dim, dim). ValueError says what is wrong with them."""
    one = model.supports[node]
    dim = model.dim
    unit = tuple(tuple(float(i == k) for i in range(dim)) for k in range(dim))
    if one.along is None:
        if not one.turned:
            return unit
        c, s = math.cos(one.turned), math.sin(one.turned)
        return (c, s), (-s, c)
    x = _direction(model, node, one.along, "along")
    if dim == 2:
        return x, (-x[1], x[0])
    if one.across is not None:
        y = _direction(model, node, one.across, "across")
        if abs(_dot(x, y)) > SQUARE:
            angle = math.degrees(math.acos(max(-1.0, min(1.0, _dot(x, y)))))
            raise ValueError(f"is at {angle:.6g} degrees to along, not perpendicular.")
    else:
        y = unit[1] if abs(x[1]) < ALONG else unit[2]
    y = _sized(tuple(b - _dot(x, y) * a for a, b in zip(x, y, strict=True)))
    return x, y, (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])


def _direction(model: ModelData, node: str, given: Any, field: str) -> tuple[float, ...]:
    if isinstance(given, str):
        given = tuple(b - a for a, b in zip(model.nodes[node].at, model.nodes[given].at, strict=True))
        if not any(given):
            raise ValueError(f"{field}: the node stands where the support is, so it gives no direction.")
    if len(given) != model.dim:
        raise ValueError(f"{field}: has {len(given)} components, the model has {model.dim} axes.")
    if not any(given):
        raise ValueError(f"{field}: is the zero vector.")
    return _sized(given)


def _dot(a: Any, b: Any) -> float:
    return math.fsum(u * v for u, v in zip(a, b, strict=True))


def _sized(a: Any) -> tuple[float, ...]:
    return tuple(v / math.hypot(*a) for v in a)


def support_words(one: Support) -> str:
    """What a support holds, in words.

    >>> print(support_words(Support(x="held", y={"stiffness": "2 kN/mm", "gap": [0, None]}, turned="30 deg")))
    x held, y 2 MN/m (gap 0 m, -), turned by 30 deg
    >>> print(support_words(Support(y={"settlement": "-5 mm"}, rotation="50 kN m/rad")))
    y held (settled by -5 mm), rotation 50 kN m/rad
    """
    found = []
    for name in ("x", "y", "z", "rotation", *TURNS):
        way = getattr(one, name)
        if way is None:
            continue
        force, shift = ("N m/rad", "rad") if name.startswith("rotation") else ("N/m", "m")
        more = [f"settled by {quantity(way.settlement, shift)}"] if way.settlement else []
        more += [f"gap {', '.join('-' if v is None else str(quantity(v, shift)) for v in way.gap)}"] if way.gap else []
        how = "held" if way.stiffness is None else str(quantity(way.stiffness, force))
        found.append(f"{name} {how}{f' ({more[0]})' if more else ''}")
    if one.turned:
        found.append(f"turned by {quantity(one.turned, 'rad')}")
    axes = (("along", one.along), ("across", one.across))
    found += [f"{field} {way if isinstance(way, str) else list(way)}" for field, way in axes if way is not None]
    return ", ".join(found)


# Faults.


def support_faults(model: WholeModel, dim: int) -> Iterator[Fault]:
    """Faults of supports that need the model."""
    for node, one in model.supports.items():
        path = ("supports", node)
        if node not in model.nodes:
            continue
        if (table := model.inner.twice.get(node)) is not None:
            yield Fault(path, f"the node is also {table}.", f"Leave it out of supports or of {table}.", about=((table, node),))
        if model.nodes[node].scalar or node in model.hubs:
            what = "a scalar, which is no place" if model.nodes[node].scalar else "a hub"
            yield Fault(path, f"the node is {what}.", "Support another node, or fix this one.", about=(("nodes", node),))
            continue
        if dim == 2:
            yield from _in_the_plane(one, path)
        elif one.turned:
            mend = "Give along: [.., .., ..], its axis x."
            yield Fault((*path, "turned"), "is one angle, but the support stands in space.", mend, about=(("nodes",),))
        yield from _axes(model, node, path)
        if not model.members and any(own.node == node for own in model.inner.holdings):
            words = "yields, is turned, settles or has a gap, in a model without bars."
            yield Fault(path, words, "Fix the node, or give the model a bar, if only of kind: free.", about=(("bars",),))
        if one.turns_in(dim) and node not in model.inner.frames:
            held = [field for field in ("rotation", *TURNS) if getattr(one, field) is not None]
            mend = "Join a beam to it that is not released there, or leave the rotation free."
            yield Fault((*path, held[0]), "the node has no rotation: no beam shares one with it.", mend, about=(("beams",),))


def _in_the_plane(one: Support, path: tuple[str, str]) -> Iterator[Fault]:
    for field, mend in (("z", "Leave it out."), ("rotation_x", "Give rotation."), ("rotation_y", "Give rotation.")):
        if getattr(one, field) is not None:
            yield Fault((*path, field), "is given in a planar model.", mend, about=(("nodes",),))
    if one.across is not None:
        yield Fault((*path, "across"), "is given in a planar model.", "Leave it out: along gives both axes.")


def _axes(model: ModelData, node: str, path: tuple[str, str]) -> Iterator[Fault]:
    one = model.supports[node]
    if any(isinstance(name, str) and name not in model.nodes for name in (one.along, one.across)) or (
        model.dim == 2 and one.across
    ):
        return
    if model.dim == 3 and one.turned:
        return
    try:
        axes_of_support(model, node)
    except ValueError as error:
        field, _, words = str(error).rpartition(": ")
        mend = "Give two directions that are perpendicular, or leave across out." if not field else "Give another direction."
        yield Fault((*path, field or "across"), words, mend)
    except ZeroDivisionError:
        yield Fault((*path, "across"), "points along the other axis.", "Give a direction across it.")


# Expansion: first what fixed and clamped say, before beams have frames; then couplings, springs and stops.


def turning_supports(model: ModelData) -> set[str]:
    """The nodes whose rotation a support holds in some way."""
    return {node for node, one in model.supports.items() if one.turns_in(model.dim)}


def add_fixed(whole: WholeModel) -> None:
    """Translations that are held along global axes, and clamps, as `fixed` and `clamped` say them."""
    every = "xyz"[: whole.dim]
    given = (("clamped", whole.clamped), ("fixed", whole.fixed))
    whole.inner.twice.update({node: name for name, table in given for node in whole.supports if node in table})
    for node, one in _sound(whole):
        rigid = [k for k, way in one.shifts.items() if way.rigid]
        whole_way = len(rigid) == whole.dim
        if whole_way or (straight(whole, node) and rigid):
            whole.fixed[node] = every if whole_way else "".join(every[k] for k in rigid)
        turns = one.turns_in(whole.dim)
        if (
            whole_way
            and len(turns) == 2 * whole.dim - 3
            and all(way.rigid for way in turns.values())
            and _has_beam(whole, node)
        ):
            whole.clamped[node] = GROUND


def add_supports(whole: WholeModel) -> None:
    """All else that supports hold: couplings where it is rigid, springs, stops behind gaps."""
    for node, one in _sound(whole):
        axes = axes_of_support(whole, node)
        fixed = whole.fixed.get(node, "")
        for k, way in one.shifts.items():
            if len(fixed) == whole.dim or (straight(whole, node) and "xyz"[k] in fixed):
                continue
            terms = [(CoordinateDrive(node=node, axis="xyz"[i]), v) for i, v in enumerate(axes[k]) if abs(v) > 1e-15]
            start = _dot(axes[k], whole.nodes[node].at)
            _add(whole, node, f"{node}.support.{'xyz'[k]}", (k, axes[k], ""), terms, way, start)
        turns = one.turns_in(whole.dim)
        if turns and node in whole.inner.frames and node not in whole.clamped:
            _add_turns(whole, node, turns, axes)


def _add_turns(whole: WholeModel, node: str, turns: dict[int, Restraint], axes: tuple[tuple[float, ...], ...]) -> None:
    """Rotations, by the angles of directions that turn with the frame of the node."""
    frame = whole.inner.frames[node]
    arms = frame.nodes
    if whole.dim == 3 and not straight(whole, node):
        at, arms = whole.nodes[node].at, tuple(f"{node}.s{k + 1}" for k in range(3))
        for arm, axis in zip(arms, axes, strict=True):
            place = tuple(v + frame.size * u for v, u in zip(at, axis, strict=True))
            whole.nodes[arm], whole.inner.nodes[arm] = (
                Node.model_construct(at=place, coincident=True),
                Owner("nodes", node, node),
            )
        whole.inner.arms_of_supports[node] = arms
    for k, way in turns.items():
        first = 0 if whole.dim == 2 else (k + 1) % 3
        bar = f"{node}.support.rotation_{'xyz'[k]}"
        whole.bars[f"{bar}.arm"] = Brace.model_construct(ends=(node, arms[first]), kind="free", mass=0.0)
        whole.inner.bars[f"{bar}.arm"] = Owner("supports", node)
        axis = (0.0, 0.0, 1.0) if whole.dim == 2 else axes[k]
        about = {} if whole.dim == 2 else {"axis": axis, "reference": axes[first]}
        _add(whole, node, bar, (k, axis, arms[first]), [(AngleDrive(f"{bar}.arm", **about), 1.0)], way, 0.0)


def _add(whole: WholeModel, node: str, name: str, at: tuple[int, Any, str], terms: Any, way: Restraint, start: float) -> None:
    """One direction, whose coordinate is the sum of these terms and `start` in the model."""
    inner, place = whole.inner, start + way.settlement
    sums: dict[str, Any] = {"terms": tuple(terms)} if len(terms) > 1 or terms[0][1] != 1.0 else {"coordinate": terms[0][0]}
    if way.stiffness is None:
        table = "couplings"
        whole.couplings[name] = Coupling(terms=tuple(terms), value=place if way.settlement else None)
    elif way.gap is None:
        table = "springs"
        rest = place if way.settlement else None
        whole.springs[name] = Spring(stiffness=float(way.stiffness), damping=float(way.damping), rest=rest, **sums)
    else:
        table = "stops"
        below, above = way.gap
        lower = None if below is None else place - below
        upper = None if above is None else place + above
        if lower == upper and lower is not None:
            table = "springs"
            whole.springs[name] = Spring(stiffness=float(way.stiffness), **sums)
        else:
            whole.stops[name] = Stop(stiffness=float(way.stiffness), lower=lower, upper=upper, **sums)
    owners: Any = inner.couplings if table == "couplings" else inner.elements
    owners[name] = Owner("supports", node)
    k, vector, arm = at
    inner.holdings.append(Holding(table, name, node, k, (*vector, 0.0)[:3], arm))


def _sound(model: ModelData) -> Iterator[tuple[str, Support]]:
    """The supports whose node stands and whose axes are some; the others are faults."""
    for node, one in model.supports.items():
        if node not in model.nodes or model.nodes[node].scalar or len(model.nodes[node].at) != model.dim or node in model.hubs:
            continue
        if (model.dim == 3 and one.turned) or (model.dim == 2 and (one.z or one.across is not None)):
            continue
        try:
            axes_of_support(model, node)
        except (ValueError, KeyError, ZeroDivisionError):
            continue
        yield node, one


def straight(model: ModelData, node: str) -> bool:
    """Whether the axes of the support are the global ones."""
    one = model.supports[node]
    return one.along is None and not one.turned


def _has_beam(model: ModelData, node: str) -> bool:
    turning = any(node in beam.ends and node not in beam.release for beam in model.beams.values())
    return turning or any(node in link.weld for link in model.links.values())
