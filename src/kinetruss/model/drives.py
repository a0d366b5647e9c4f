"""Drives, couplings, poses and springs."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, TypeGuard

from pydantic import BeforeValidator, Field, WithJsonSchema, model_validator

from kinetruss.errors import shown
from kinetruss.model.drivetrain import AmplifierOrName, GearOrName, MotorOrName
from kinetruss.model.record import (
    Angle,
    Coordinate,
    Factor,
    Name,
    Number,
    PositiveLength,
    PositiveRate,
    Record,
    Resisting,
    SpringDamping,
    SpringForce,
    SpringStiffness,
    Width,
)
from kinetruss.model.references import DriveName, MemberName, NodeName, Ref, TurningName
from kinetruss.units import Tagged, parse

if TYPE_CHECKING:
    from collections.abc import Iterator

    from kinetruss.errors import Fault
    from kinetruss.model.data import ModelData


_UNITS = {"length": "m, N and s", "angle": "rad, N m and s"}
_ARTICLES = {"length": "a length", "angle": "an angle"}
_UNIT = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def _direction(value: Any) -> Any:
    """A letter gives its axis; every direction becomes a unit vector."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, (list, tuple)) and len(value) == 3:
        numbers = [parse(one, "number") for one in value]
        if not 0 < (size := math.hypot(*numbers)) < math.inf:
            raise ValueError(f"{shown(value)} is no direction. Give three numbers, not all 0.")
        return tuple(one / size for one in numbers)
    if value not in list(_UNIT):
        raise ValueError(f"{shown(value)} is no axis. Write x, y, z, or three numbers.")
    return _UNIT[value]


def _nodes(value: Any) -> Any:
    return (value,) if isinstance(value, str) else value


_SCHEMA = {"anyOf": [{"enum": ["x", "y", "z"]}, {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}]}
Direction = Annotated[tuple[float, float, float], BeforeValidator(_direction), WithJsonSchema(_SCHEMA)]


class LengthDrive(Record):
    """Prescribes the length (m) of a bar or active member.

    bar : name of the bar or active member.

    >>> import kinetruss as kt
    >>> kt.LengthDrive("jack")
    LengthDrive(bar='jack')
    """

    _positional: ClassVar = ("bar",)
    kind: Literal["length"] = "length"
    bar: MemberName

    if TYPE_CHECKING:

        def __init__(self, bar: str) -> None: ...


class AngleDrive(Record):
    """Prescribes the angle (rad) of a bar or link about a fixed axis, unwrapped: it counts on over full turns.

    In the plane from +x counter-clockwise to its first -> second end, of a link its first -> last node; a torque on the angle
    of a link acts at its first node. In space about `axis` (x, y, z or a direction), from the
    direction `reference` to the bar, both projected onto the plane normal to the axis, right-handed about the axis; by default
    the reference of x is y, that of y is z, that of z is x, and that of other axes is the bar at the start. A `motor` turns it
    through a `gear` (motor turns per turn of the bar; by default none), fed by an `amplifier`.

    bar : name of the bar, active member or link.
    axis : in space, x, y, z or a direction.
    reference : direction from which the angle counts, in space.
    gear : between motor and bar, a record or a name.
    motor : that turns the bar, likewise.
    amplifier : that feeds the motor, likewise.

    >>> import kinetruss as kt
    >>> kt.AngleDrive("crank")
    AngleDrive(bar='crank')
    >>> kt.AngleDrive("mast", axis="z")
    AngleDrive(bar='mast', axis=(0.0, 0.0, 1.0))
    """

    _positional: ClassVar = ("bar",)
    kind: Literal["angle"] = "angle"
    bar: TurningName
    axis: Direction | None = None
    reference: Direction | None = None
    gear: GearOrName | None = None
    motor: MotorOrName | None = None
    amplifier: AmplifierOrName | None = None

    if TYPE_CHECKING:

        def __init__(
            self,
            bar: str,
            *,
            axis: Any = None,
            reference: Any = None,
            gear: Any = None,
            motor: Any = None,
            amplifier: Any = None,
        ) -> None: ...


class HingeDrive(Record):
    """Prescribes the angle (rad) between two bodies at a hinge, unwrapped: it counts on over full turns.

    In space from the half-plane of the axis and the node `start` to that of the axis and `end`, right-handed about the axis
    from its first to its second node; all these nodes may move. In the plane the axis is one node, and the angle goes
    counter-clockwise from the direction of `start` to that of `end`. A torque on it acts on `end`, and its opposite on `start`.
    A `motor` gives it through a `gear`, as on an `AngleDrive`.

    axis : the node of the hinge in the plane; in space two nodes on its axis.
    start : node from which the angle counts.
    end : node to which it counts.
    gear, motor, amplifier : as of an `AngleDrive`.

    >>> import kinetruss as kt
    >>> kt.HingeDrive(axis=("E", "F"), start="B", end="G")
    HingeDrive(axis=('E', 'F'), start='B', end='G')
    """

    kind: Literal["hinge"] = "hinge"
    axis: Annotated[tuple[NodeName, ...], Field(min_length=1, max_length=2), BeforeValidator(_nodes)]
    start: NodeName
    end: NodeName
    gear: GearOrName | None = None
    motor: MotorOrName | None = None
    amplifier: AmplifierOrName | None = None

    if TYPE_CHECKING:

        def __init__(
            self, *, axis: Any, start: str, end: str, gear: Any = None, motor: Any = None, amplifier: Any = None
        ) -> None: ...


class CoordinateDrive(Record):
    """Prescribes one coordinate (m) of a node.

    node : whose coordinate it prescribes.
    axis : which one.

    >>> import kinetruss as kt
    >>> kt.CoordinateDrive(node="S", axis="x")
    CoordinateDrive(node='S', axis='x')
    """

    kind: Literal["coordinate"] = "coordinate"
    node: NodeName
    axis: Literal["x", "y", "z"]


Drive = Annotated[LengthDrive | AngleDrive | HingeDrive | CoordinateDrive, Field(discriminator="kind")]


class OffsetCoordinate(Record):
    """Distance (m) of a node from the line of two others, positive to the left of first -> second.

    In space it counts in one direction across the line, which `axis` or `along` gives, and is for couplings that keep it 0. A
    node on the line has both distances 0, that of an `axis` and that `along` it; neither is defined where the line points along
    that direction.

    line : two nodes on the line. point : the node whose distance it is.
    axis : in space, x, y, z or a direction: the distance to the left of the line as seen against it, as in the plane against z.
    along : in space, likewise: the distance towards it.
    """

    kind: Literal["offset"] = "offset"
    line: tuple[NodeName, NodeName]
    point: NodeName
    axis: Direction | None = None
    along: Direction | None = None

    if TYPE_CHECKING:

        def __init__(self, *, line: tuple[str, str], point: str, axis: Any = None, along: Any = None) -> None: ...


class DistanceCoordinate(Record):
    """Distance (m) of two nodes; no bar need join them.

    nodes : the two nodes, which are apart in the model. The distance has no direction while they meet, so what acts on it must
    keep them apart.

    >>> import kinetruss as kt
    >>> kt.DistanceCoordinate(("A", "B"))
    DistanceCoordinate(nodes=('A', 'B'))
    """

    _positional: ClassVar = ("nodes",)
    kind: Literal["distance"] = "distance"
    nodes: tuple[NodeName, NodeName]

    if TYPE_CHECKING:

        def __init__(self, nodes: tuple[str, str]) -> None: ...


class CosineCoordinate(Record):
    """Cosine of the angle that a scalar node holds, with a phase (rad) added: cos(x + phase); a number.

    With -90 degrees of phase it is the sine.

    node : the scalar node.
    """

    kind: Literal["cosine"] = "cosine"
    node: NodeName
    phase: Angle = 0.0


Measured = Annotated[
    LengthDrive | AngleDrive | HingeDrive | CoordinateDrive | DistanceCoordinate | OffsetCoordinate | CosineCoordinate,
    Field(discriminator="kind"),
]


class Coupling(Record):
    """Keeps the sum of factor times coordinate at its start value, or at `value`.

    A coordinate is given as the drive that would move it: the length or the angle of a bar, a hinge, a coordinate of a node;
    or the distance of two nodes, the offset of a node from a line, or the cosine of a scalar. Angles count on over full turns;
    so the factors of two or more angles must be in a ratio of whole numbers. A screw pair couples a length and an angle, a gear
    pair two angles; the offsets of two points of one body from a line of another are the two conditions of a slider in the
    plane, and both offsets of a node those of a block on a line in space.

    terms : pairs of coordinate and factor, a number: where it stands for a length, or for a length per angle, in m or m/rad.
    value : of the sum, m or rad; by default that in the model. Of coordinates of both kinds the factors say which it is.
    """

    terms: Annotated[tuple[tuple[Measured, Factor], ...], Field(min_length=1)]
    value: Coordinate | None = None

    @model_validator(mode="after")
    def _sound(self) -> Coupling:
        kinds = {"angle" if turns(one) else "number" if one.kind == "cosine" else "length" for one, _ in self.terms}
        if isinstance(self.value, Tagged) and self.value.quantity and self.value.quantity not in kinds:
            wanted = {"angle": "rad or deg", "length": "m or mm"}.get(kinds.pop(), "a plain number")
            raise ValueError(f"value has the unit of {_ARTICLES[self.value.quantity]}. Use {wanted}.")
        return self


def turns(drive: Any) -> bool:
    """True if a drive prescribes an angle.

    >>> import kinetruss as kt
    >>> kt.model.turns(kt.AngleDrive("crank")), kt.model.turns(kt.LengthDrive("strut"))
    (True, False)
    """
    return drive.kind in ("angle", "hinge")


def geared(drive: Any) -> TypeGuard[AngleDrive | HingeDrive]:
    """True if a drive prescribes an angle and has a gear, a motor or an amplifier.

    >>> import kinetruss as kt
    >>> kt.model.geared(kt.AngleDrive("crank")), kt.model.geared(kt.AngleDrive("crank", gear=kt.Gear(ratio=10)))
    (False, True)
    """
    return turns(drive) and any(part is not None for part in (drive.gear, drive.motor, drive.amplifier))


def coordinate_kinds(model: ModelData) -> dict[str, str]:
    """Coordinates that a trajectory may move: name -> ``length`` or ``angle``."""
    kinds = {name: "angle" if turns(drive) else "length" for name, drive in model.all_drives.items()}
    for pose in model.poses:
        kinds |= {f"{pose}.beta": "angle", f"{pose}.gamma": "angle", f"{pose}.height": "length"}
    return kinds


CoordinateName = Annotated[Name, Ref("drive or pose coordinate", "drives", "bars", "active", "poses", known=coordinate_kinds)]


class GimbalPose(Record):
    """Pose of a double-octahedral bay: gimbal angles beta, gamma (rad) and the centroid distance `height` (m).

    Coordinates ``NAME.beta``, ``NAME.gamma``, ``NAME.height`` move the three lengths of `drives`, in the order
    M7, M9, M11 of Lacy (1991, chapter 4): of middle nodes 4 and 5, 5 and 6, 4 and 6. A pose of a bay
    with other lengths than `base` and `longeron` is refused.

    base : side of the base and top triangles, m.
    longeron : length of the cross longerons, m.
    drives : names of the drives of the three lengths, in the order above.
    """

    kind: Literal["gimbal"] = "gimbal"
    base: PositiveLength
    longeron: PositiveLength
    drives: tuple[DriveName, DriveName, DriveName]


Pose = GimbalPose


# Springs: laws on a coordinate, with stiffness, damping, friction and play.

Points = Annotated[tuple[tuple[Number, Number], ...], Field(min_length=2)]


class ElementRecord(Record):
    """What the records of elements have in common: the word for the kind, which names its results, and rules of its own."""

    element: ClassVar[str]

    def faults(self, model: ModelData, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: ARG002
        """Faults that need the model; path : the place of the record in it. It is asked only if the names in it are known."""
        return iter(())


class ForceElement(ElementRecord):
    """What elements with a law on a coordinate have in common.

    coordinate : on which it acts, as a drive that would move it.
    terms : a sum of coordinates in its place: pairs of coordinate and factor.
    """

    plain: ClassVar[tuple[str, ...]]
    """Fields whose unit is that of a length or an angle, as the coordinate is."""
    coordinate: Measured | None = None
    terms: Annotated[tuple[tuple[Measured, Factor], ...], Field(min_length=1)] | None = None

    @property
    def parts(self) -> tuple[tuple[Any, float], ...]:
        """Coordinates and their factors."""
        return self.terms if self.terms is not None else ((self.coordinate, 1.0),)

    def check_coordinate(self) -> None:
        """There is one coordinate or a sum; units that were written must be those of it: the numbers then are plain ones."""
        if (self.coordinate is None) == (self.terms is None):
            raise ValueError(f"a {self.element} acts on one coordinate or on a sum of them. Give coordinate, or terms.")
        kinds = {"angle" if turns(one) else "length" for one, _ in self.parts}
        for name in self.plain:
            value = getattr(self, name)
            if isinstance(value, Tagged):
                if value.quantity and self.coordinate is not None and value.quantity not in kinds:
                    kind = kinds.pop()
                    raise ValueError(f"{name} has the unit of {_ARTICLES[value.quantity]}. Use {_UNITS[kind]}.")
                self.__dict__[name] = float(value)


class Spring(ForceElement):
    """A law on a coordinate: what resists the angle of a hinge, a length, an offset from a line, or a sum of such.

    The coordinate c is given as the drive that would move it (`coordinate`), or as a sum of factor times coordinate (`terms`,
    as of a `Coupling`). The generalised force on it, N or N m, with e = c - rest, is

        -(preload + stiffness s) - damping c' - friction tanh(c'/slip),    s = e outside the play, 0 within it.

    `play` is the half-width of a dead band: s = e - play for e > play, s = e + play for e < -play. `table` replaces the
    stiffness by points (s, force), both ascending, in SI units: between them a monotone cubic (Fritsch & Carlson, SIAM J.
    Numer. Anal. 17 (1980) 238), beyond them straight on. `rest` is by default the value of the coordinate in the model.
    `friction` is Coulomb's, of a given size; `slip` is the rate at which it has 76 % of it. It creeps below, it does not stick.

    Units: stiffness N/m or N m/rad, damping N s/m or N m s/rad, friction and preload N or N m, slip m/s or rad/s. An angle must
    stay within half a turn of `rest`; the moment of a spring wound up by more turns is given as its preload.

    coordinate : on which it acts, as a drive that would move it.
    terms : a sum of coordinates in its place: pairs of coordinate and factor.
    stiffness : N/m or N m/rad.
    rest : value of the coordinate without force, m or rad; by default that in the model.
    damping : N s/m or N m s/rad.
    friction : size of Coulomb's friction, N or N m.
    slip : rate at which the friction has 76 % of its size, m/s or rad/s.
    play : half-width of the dead band, m or rad.
    preload : force at rest, N or N m.
    table : points (deflection, force) in place of the stiffness.
    """

    element: ClassVar[str] = "spring"
    plain: ClassVar[tuple[str, ...]] = ("stiffness", "rest", "damping", "friction", "slip", "play", "preload")
    stiffness: SpringStiffness = 0.0
    rest: Coordinate | None = None
    damping: SpringDamping = 0.0
    friction: Resisting = 0.0
    slip: PositiveRate = 1e-3
    play: Width = 0.0
    preload: SpringForce = 0.0
    table: Points | None = None

    @model_validator(mode="after")
    def _sound(self) -> Spring:
        if not (self.stiffness or self.damping or self.friction or self.preload or self.table):
            raise ValueError("the spring has no force. Give stiffness, damping, friction, preload or table.")
        if self.table and self.stiffness:
            raise ValueError("stiffness and table both state the force. Leave one out.")
        if self.play and not (self.stiffness or self.table):
            raise ValueError("play is the dead band of a stiffness. Give stiffness, or leave play out.")
        if self.play and self.preload:
            raise ValueError("a preload closes the play: the force within it is 0. Leave one out.")
        for before, after in pairwise(self.table or ()):
            if after[0] <= before[0] or after[1] < before[1]:
                raise ValueError(f"table: {after} follows {before}. Give ascending deflections, and forces that do not fall.")
        self.check_coordinate()
        return self

    if TYPE_CHECKING:

        def __init__(self, *, coordinate: Any = None, terms: Any = None, table: Any = None, **numbers: Any) -> None: ...
