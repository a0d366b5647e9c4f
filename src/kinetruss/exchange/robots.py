"""A robot as other programs describe it: links, joints between them, and closures of its loops."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.library.bodies import MassProperties


JointKind = Literal["revolute", "prismatic", "ball", "weld", "free"]

COLUMNS = {"revolute": 1, "prismatic": 1, "ball": 3, "weld": 0, "free": 6}
"""Freedoms of a joint."""


@dataclass(frozen=True, slots=True)
class LeftOut:
    """One thing of a file that the result does not have.

    what : the thing, e.g. ``limit``. where : its place, ``FILE:LINE`` and the name of the element. why : the reason.
    """

    what: str
    where: str
    why: str

    def __str__(self) -> str:
        return f"{self.where}: {self.what}: {self.why}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Link:
    """A rigid link. properties : mass, centre and inertia in its own frame, None without mass. points : named places of it, m.

    where : its place in the file, for messages.
    """

    name: str
    properties: MassProperties | None = None
    points: Mapping[str, Any] = field(default_factory=dict)
    where: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Pivot:
    """A joint: child frame = parent frame . origin . motion . after, each (4, 4); the motion is about or along `axis` (3,).

    home : value of a revolute or prismatic joint where the file draws the robot, rad or m; start : that at which the search
    for a closed pose starts, `home` if None. spring : stiffness, value without force, damping and friction of a revolute
    (N m/rad, rad, N m s/rad, N m) or prismatic joint (N/m, m, N s/m, N). armature : inertia that its rate adds, kg m^2 or kg.
    drive : the name of its drive, if it has one; ratio : of the gear before it. limits : of its value.
    """

    name: str
    kind: JointKind
    parent: str
    child: str
    origin: NDArray[np.float64]
    axis: NDArray[np.float64] = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    after: NDArray[np.float64] = field(default_factory=lambda: np.eye(4))
    home: float = 0.0
    start: float | None = None
    drive: str | None = None
    ratio: float | None = None
    limits: tuple[float, float] | None = None
    spring: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    armature: float = 0.0
    where: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Closure:
    """Two frames of two links that stay together: their origins (``ball``), or the whole frames (``weld``).

    frames : (4, 4) of each in its link. The second is None where the pose of the file defines it.
    """

    name: str
    kind: Literal["ball", "weld"]
    links: tuple[str, str]
    frames: tuple[NDArray[np.float64], NDArray[np.float64] | None]
    where: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class JointCoupling:
    """Revolute and prismatic joints that move together: the sum of factor times value, rad or m, stays at `value`."""

    name: str
    factors: Mapping[str, float]
    value: float = 0.0
    where: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Span:
    """The straight distance of two named points of links: a drive of a length, or a spring, or both.

    spring : stiffness, N/m, length without force, m (None: that where no spring of a joint has a force), damping, N s/m, and
        friction, N.
    """

    name: str
    points: tuple[str, str]
    driven: bool = False
    spring: tuple[float, float | None, float, float] | None = None
    where: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Robot:
    """Links by name, joints from `root` outwards, closures, couplings, spans; gravity (3,) m/s^2; what was left out.

    root : the link that the ground holds. notes : what was assumed while the file was read.
    """

    title: str
    root: str
    links: Mapping[str, Link]
    pivots: Sequence[Pivot]
    closures: Sequence[Closure] = ()
    couplings: Sequence[JointCoupling] = ()
    spans: Sequence[Span] = ()
    gravity: tuple[float, float, float] = (0.0, 0.0, -9.81)
    left_out: Sequence[LeftOut] = ()
    notes: Sequence[str] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class DrivenLength:
    """A length with a force: along the line between points of two links, (3,) m in their frames.

    properties : of the rods at both ends, None without mass. driven : it is a drive. spring : as of a `Span`.
    """

    name: str
    links: tuple[str, str]
    points: tuple[NDArray[np.float64], NDArray[np.float64]]
    length: float
    properties: tuple[MassProperties | None, MassProperties | None] | None = None
    driven: bool = True
    spring: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, kw_only=True, eq=False)
class RobotOfModel:
    """The robot of a model in a pose: frames of all links are the global axes there, and all joint values 0.

    lengths : driven lengths. offsets : drive -> its value in that pose, rad or m: what to add to the joint's value.
    lines : link -> pairs of points (2, 3), m, of its bars.
    """

    robot: Robot
    lines: Mapping[str, Sequence[NDArray[np.float64]]] = field(default_factory=dict)
    lengths: Sequence[DrivenLength] = ()
    offsets: Mapping[str, float] = field(default_factory=dict)


def placement(rotation: Any = None, place: Any = (0.0, 0.0, 0.0)) -> NDArray[np.float64]:
    """(4, 4) of a rotation (3, 3) and a place (3,) m."""
    found = np.eye(4)
    if rotation is not None:
        found[:3, :3] = rotation
    found[:3, 3] = place
    return found


def turn_about(axis: Any, angle: float) -> NDArray[np.float64]:
    """Rotation matrix about a unit vector: 1 + sin(t) K + (1 - cos(t)) K K, K the cross product with it (Rodrigues)."""
    x, y, z = axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def quaternion_matrix(quaternion: Any) -> NDArray[np.float64]:
    """Rotation matrix of a quaternion (w, x, y, z), which need not have unit length."""
    w, x, y, z = np.asarray(quaternion, float) / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def matrix_quaternion(R: Any) -> NDArray[np.float64]:
    """The quaternion (w, x, y, z) of a rotation matrix, from its largest component (S. W. Shepperd, 1978)."""
    trace = float(np.trace(R))
    squares = np.array([trace, R[0, 0], R[1, 1], R[2, 2]])
    k = int(np.argmax(squares))
    found = np.array([1.0 + trace, R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    if k:
        i = k - 1
        found = np.array([found[k], *(R[i, j] + R[j, i] for j in range(3))])
        found[k] = 1.0 + 2.0 * R[i, i] - trace
    return np.asarray(found / np.linalg.norm(found))
