"""Tasks as programs: what is to be zero, in node positions and in parameters that are given in time.

Every coordinate of a task has a reading, and a parameter that it is to be equal to. Three turns of a platform go in as a
rotation matrix R*, and 2 tan(angle/2) times the axis of R R*^T is to be zero, which has no singular orientation short of half a
turn. Angles count times a length of the structure, so that all results are in m.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np

from kinetruss.kernels.coordinates.programs import Program, Scalar, Vector, angle, cross, dot, minus, root, size, total, unit
from kinetruss.kernels.coordinates.tape import tape_of, values
from kinetruss.kinematics.poses import start_frame
from kinetruss.mechanics import System, measure_of
from kinetruss.mechanics.bays import POSE, bay_of
from kinetruss.mechanics.coordinates import Coordinate, coordinates
from kinetruss.mechanics.positions import shortest
from kinetruss.model import Combined, Coordinates, Docking, Gimbal, Pointing, Positioning, Reflecting, moved_by

TURN = 2 * math.pi
EVEN = 1e-6
"""Smallest sine of the angle between two directions that have a common normal."""
ANGLES = ("beta", "gamma", "roll", "pitch", "yaw")
DIRECTION = ("direction.x", "direction.y", "direction.z")
"""Coordinates of a direction that is asked for."""
WORDS = {
    "x": "move along x",
    "y": "move along y",
    "z": "move along z",
    "roll": "roll (turn about x)",
    "pitch": "pitch (turn about y)",
    "yaw": "yaw (turn about z)",
    "beta": "tilt by beta",
    "gamma": "tilt by gamma",
}


@dataclass(frozen=True, kw_only=True, eq=False)
class Asked:
    """One coordinate that a task gives in time. task : the record; rotation : -1, or which of roll, pitch, yaw that go in as a
    matrix together.
    """

    task: Any
    name: str
    rotation: int = -1


class Tasks:
    """The program of tasks of a structure, and what it reads.

    program : of what is to be zero. readings : of the coordinates. asked : these, in order. labels : of results, in words.
    begin : where the point of a task is at the start, (3,) m, by the id of its record; of a task with a direction, that.
    turned : of tasks that ask for three turns of a frame, the program of R, row by row, by the id of the record.
    begin_turned : R (3, 3) of these at the start.
    """

    def __init__(self, system: System) -> None:
        self.system, self.arm = system, shortest(system)
        self.program, self.readings = Program(), Program()
        self.asked: list[Asked] = []
        self.labels: list[str] = []
        self.begin: dict[int, Any] = {}
        self.turned: dict[int, Program] = {}
        self.begin_turned: dict[int, Any] = {}

    def ask(self, task: Any, name: str, read: Callable[[Program], Any]) -> None:
        """A coordinate of a task: what it reads is to be equal to a parameter."""
        turns = _turns(self.system, task, name)
        self.tell(task, name, read)
        off = read(self.program) - self.program.parameter()
        self.off(off * self.arm if turns else off, WORDS.get(name, f"change {name}"), TURN * self.arm if turns else 0.0)

    def tell(self, task: Any, name: str, read: Callable[[Program], Any], rotation: int = -1) -> None:
        """A coordinate that is given in time."""
        value = read(self.readings)
        self.readings.result(value if isinstance(value, Scalar) else self.readings.number(value))
        self.asked.append(Asked(task=task, name=name, rotation=rotation))

    def off(self, value: Any, label: str, period: float = 0.0) -> None:
        """What is to be zero, m."""
        self.program.result(value if isinstance(value, Scalar) else self.program.number(value), period)
        self.labels.append(label)

    def unit(self, asked: Asked) -> str:
        """Unit of what is asked for."""
        if asked.name in DIRECTION:
            return ""
        return "rad" if asked.rotation >= 0 or _turns(self.system, asked.task, asked.name) else "m"

    def read(self, x: Any) -> Any:
        """Values (times, asked) of what is asked for at flat positions x (times, 3 n)."""
        return values(tape_of(self.readings, 0), x, np.zeros((len(x), 1)))

    def start(self, x: Any) -> Any:
        """The same (asked,) at the start x (3 n,), from where moves and paths begin."""
        found = self.read(x[None])[0]
        for asked, value in zip(self.asked, found, strict=True):
            if asked.name in ("x", "y", "z", *DIRECTION):
                self.begin.setdefault(id(asked.task), np.zeros(3))["xyz".index(asked.name[-1])] = value
        self.begin_turned = {key: self.attitude(key, x) for key in self.turned}
        return found

    def attitude(self, key: int, x: Any) -> Any:
        """R (3, 3) of the frame of a task, by the id of its record, at flat positions x (3 n,)."""
        return values(tape_of(self.turned[key], 0), x[None], np.zeros((1, 1)))[0].reshape(3, 3)

    def node(self, program: Program, name: str) -> Vector:
        """Position of a node."""
        return program.node(self.system.node_index(name), self.system.dim)

    def centre(self, program: Program, names: Sequence[str]) -> Vector:
        """Centroid of nodes."""
        return total([self.node(program, name) for name in names], [1 / len(names)] * len(names))

    def normal(self, program: Program, names: Sequence[str]) -> Vector:
        """Vector area of the polygon of nodes: sum r_i x r_(i + 1) (Newell)."""
        centre = self.centre(program, names)
        arms = [minus(self.node(program, name), centre) for name in names]
        areas = [cross(a, b) for a, b in zip(arms, (*arms[1:], arms[0]), strict=True)]
        return total(areas, [1.0] * len(areas))

    def triad(self, names: Sequence[str]) -> tuple[str, str, str]:
        """Three of the nodes (in the plane two) that fix a frame best: those of the largest triangle at the start."""
        at = {name: self.system.x0[self.system.node_index(name)] for name in names}
        if self.system.dim == 2:
            a, b = max(combinations(names, 2), key=lambda two: float(np.linalg.norm(at[two[1]] - at[two[0]])))
            return a, b, b
        return max(
            combinations(names, 3), key=lambda t: float(np.linalg.norm(np.cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]])))
        )

    def axes(self, program: Program, names: Sequence[str]) -> tuple[Vector, Vector, Vector]:
        """Unit vectors of the frame of three nodes: along the first two, in their plane, normal to it."""
        a, b, c = (self.node(program, name) for name in self.triad(names))
        along = unit(minus(b, a))
        if self.system.dim == 2:
            return along, (-along[1], along[0], along[2]), (along[2], along[2], program.number(1.0))
        normal = unit(cross(along, minus(c, a)))
        return along, cross(normal, along), normal

    def axes_at_start(self, names: Sequence[str]) -> Any:
        """The same in the model's own configuration, (3, 3), one a row."""
        a, b, c = (self.system.x0[self.system.node_index(name)] for name in self.triad(names))
        along = (b - a) / np.linalg.norm(b - a)
        if self.system.dim == 2:
            return np.array([along, [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]])
        normal = np.cross(along, c - a)
        normal /= np.linalg.norm(normal)
        return np.array([along, np.cross(normal, along), normal])

    def carried(self, program: Program, names: Sequence[str], point: Any) -> Vector:
        """A point (3,) of the start configuration that moves with the frame of nodes."""
        first = self.triad(names)[0]
        arm = self.axes_at_start(names) @ (np.asarray(point) - self.system.x0[self.system.node_index(first)])
        return total([self.node(program, first), *self.axes(program, names)], [1.0, *(float(one) for one in arm)])

    def rotation(self, program: Program, names: Sequence[str], own: Any) -> list[list[Any]]:
        """R (3, 3): columns are the axes, rows of `own` (3, 3) in the start configuration, of a frame that moves with nodes."""
        columns = self.axes_at_start(names) @ own.T
        now = self.axes(program, names)
        return [[sum((now[k][i] * float(columns[k, j]) for k in (1, 2)), now[0][i] * float(columns[0, j])) for j in range(3)]
                for i in range(3)]  # fmt: skip


def tasks_of(system: System, targets: Any) -> Tasks:
    """The program of a task, or of several."""
    made = Tasks(system)
    for task in targets.tasks if isinstance(targets, Combined) else (targets,):
        _MAKERS.get(type(task), _named)(made, task)
    return made


def _wanted(task: Any, names: Sequence[str]) -> list[str]:
    """Those coordinates that a task does not leave free."""
    return [name for name in names if name not in task.free]


def _part(make: Callable[[Program], Any], k: int) -> Callable[[Program], Any]:
    """One part of what a function makes."""
    return lambda program: make(program)[k]


def _turns(system: System, task: Any, name: str) -> bool:
    """True if a coordinate is an angle."""
    if isinstance(task, Coordinates) or moved(task):
        return coordinates(system, name)[0].unit == "rad"
    return name in ANGLES


def moved(task: Any) -> bool:
    """True of a trajectory record, which moves coordinates by name."""
    return not hasattr(task, "free")


def _tilts(parts: Vector, order: tuple[int, int, int] = (0, 1, 2)) -> tuple[Scalar, Scalar]:
    """beta = atan2(-y, z) and gamma = atan2(-x, sqrt(y^2 + z^2)) of a direction, its parts taken in an order."""
    x, y, z = (parts[k] for k in order)
    return angle(-y, z), angle(-x, root(y * y + z * z))


def _seen(made: Tasks, program: Program, platform: Sequence[str], base: Sequence[str] | None) -> Vector:
    """Normal of a platform in the frame of its base (x from its first node to its second, z its normal)."""
    normal = made.normal(program, platform)
    if base is None:
        return normal
    up = unit(made.normal(program, base))
    ahead = unit(cross(up, minus(made.node(program, base[1]), made.node(program, base[0]))))
    return dot(normal, cross(ahead, up)), dot(normal, ahead), dot(normal, up)


def _tilted(made: Tasks, task: Any, parts: Callable[[Program], Vector]) -> None:
    for name in _wanted(task, ("beta", "gamma")):
        made.ask(task, name, _part(lambda program: _tilts(parts(program)), ("beta", "gamma").index(name)))


def _gimbal(made: Tasks, task: Gimbal) -> None:
    _tilted(made, task, lambda program: _seen(made, program, task.platform, task.base))
    if task.division == "even":
        _evenly(made, task)


def _evenly(made: Tasks, task: Gimbal) -> None:
    """Every bay at the same angles as the first, and at its own height."""
    bays = [coordinates(made.system, [f"{pose}.{part}" for part in POSE]) for pose in made.system.model.poses]
    first = bays[0]
    for k, bay in enumerate(bays):
        for one, same in zip(bay[:2], first[:2], strict=True):
            if k:
                gap = _coordinate(made, made.program, one) - _coordinate(made, made.program, same)
                made.off(gap * made.arm, f"keep {one.name} equal to {same.name}")
        made.ask(task, bay[2].name, partial(_coordinate, made, one=bay[2]))


def _placed(made: Tasks, task: Any, place: Callable[[Program], Vector]) -> None:
    for name in _wanted(task, "xyz"[: made.system.dim]):
        made.ask(task, name, _part(place, "xyz".index(name)))


def _positioning(made: Tasks, task: Positioning) -> None:
    def place(program: Program) -> Vector:
        if task.node is not None:
            return made.node(program, task.node)
        names = task.nodes or ()
        return made.centre(program, names) if task.point is None else made.carried(program, names, _in_space(task.point))

    _placed(made, task, place)


def _docking(made: Tasks, task: Docking) -> None:
    origin, own = start_frame(made.system.given, task.platform, task.frame)

    def place(program: Program) -> Vector:
        if task.frame is None or task.frame.origin is None:
            return made.centre(program, task.platform)
        return made.carried(program, task.platform, origin)

    _placed(made, task, place)
    turns = _wanted(task, ("roll", "pitch", "yaw") if made.system.dim == 3 else ("yaw",))

    _turning(made, task, turns, lambda program: made.rotation(program, task.platform, own))


def _turning(made: Tasks, task: Any, turns: list[str], frame: Callable[[Program], list[list[Any]]]) -> None:
    """Turns of a frame; if they are three, together as a matrix. frame : R (3, 3), columns are the axes."""

    def read(program: Program, name: str) -> Any:
        R = frame(program)
        if name == "yaw":
            return angle(R[1][0], R[0][0])
        return angle(-R[2][0], root(R[0][0] * R[0][0] + R[1][0] * R[1][0])) if name == "pitch" else angle(R[2][1], R[2][2])

    if len(turns) < 3:
        for name in turns:
            made.ask(task, name, partial(read, name=name))
        return
    for k, name in enumerate(turns):
        made.tell(task, name, partial(read, name=name), k)
    whole = made.turned.setdefault(id(task), Program())
    for row in frame(whole):
        for value in row:
            whole.result(value)
    R = frame(made.program)
    wanted = [[made.program.parameter() for _ in range(3)] for _ in range(3)]
    M = [[dot((R[i][0], R[i][1], R[i][2]), (w[0], w[1], w[2])) for w in wanted] for i in range(3)]
    around = (M[0][0] + M[1][1] + M[2][2] + 1.0) * (0.5 / made.arm)
    for (i, j), name in zip(((2, 1), (0, 2), (1, 0)), turns, strict=True):
        made.off((M[i][j] - M[j][i]) / around, WORDS[name])


def _aligned(made: Tasks, label: str, start: Any, direction: Vector, wanted: Vector) -> None:
    """Two directions are to be the same: their tilts, about axes whose pole is far from the direction at the start."""
    pole = int(np.argmin(np.abs(start)))
    order = (pole, (pole + 1) % 3, (pole + 2) % 3)
    for mine, other in zip(_tilts(direction, order), _tilts(wanted, order), strict=True):
        made.off((mine - other) * made.arm, label, TURN * made.arm)


def _place_of(made: Tasks, task: Any, given: Any, prefix: str = "") -> Vector:
    """A place that moves only if the task says so: three parameters."""
    found = []
    for k, axis in enumerate("xyz"):
        made.tell(task, f"{prefix}{axis}", partial(Program.number, value=float(given[k])))
        found.append(made.program.parameter())
    return (found[0], found[1], found[2])


def _arrow(made: Tasks, program: Program, task: Any) -> Vector:
    """The normal of a platform, or a line from one node to another."""
    if task.kind == "pointing" and task.line is not None:
        return minus(made.node(program, task.line[1]), made.node(program, task.line[0]))
    return made.normal(program, task.platform)


def _direction(made: Tasks, task: Any) -> tuple[Vector, Vector, Any]:
    """Where a direction starts, the direction, and its value at the start (3,)."""
    program, x0 = made.program, made.system.x0
    if task.kind == "pointing" and task.line is not None:
        p, q = (x0[made.system.node_index(name)] for name in task.line)
        return made.node(program, task.line[0]), _arrow(made, program, task), (q - p) / np.linalg.norm(q - p)
    return made.centre(program, task.platform), _arrow(made, program, task), made.axes_at_start(task.platform)[2]


def _upright(made: Tasks, program: Program, names: Sequence[str]) -> list[list[Any]]:
    """R (3, 3), columns are the axes of a platform: z its normal, x as near as may be from its first node to its second."""
    up = unit(made.normal(program, names))
    ahead = unit(cross(up, minus(made.node(program, names[1]), made.node(program, names[0]))))
    axes = (cross(ahead, up), ahead, up)
    return [[axis[i] for axis in axes] for i in range(3)]


def _directed(made: Tasks, task: Pointing) -> None:
    """A direction is to be one that is given in time, three parameters: their tilts, about the axis of the turn as the pole,
    from which both are a quarter turn away.
    """
    _, direction, start = _direction(made, task)
    wanted = []
    for k, name in enumerate(DIRECTION):
        made.tell(task, name, _part(lambda program: unit(_arrow(made, program, task)), k))
        wanted.append(made.program.parameter())
    pole = np.cross(start, np.array(task.direction))
    if np.linalg.norm(pole) < EVEN:  # no turn, or half of one: any axis normal to the start
        pole = np.cross(start, np.eye(3)[int(np.argmin(np.abs(start)))])
    pole /= np.linalg.norm(pole)
    basis = [(float(x), float(y), float(z)) for x, y, z in (pole, np.cross(start, pole), start)]
    seen, aim = ([dot(of, axis) for axis in basis] for of in (direction, (wanted[0], wanted[1], wanted[2])))
    _aligned(made, "turn to the direction", np.array([0.0, 1.0, 1.0]), (seen[0], seen[1], seen[2]), (aim[0], aim[1], aim[2]))


def _pointing(made: Tasks, task: Pointing) -> None:
    if task.direction is not None:
        if task.roll == "held":
            _turning(made, task, ["roll", "pitch", "yaw"], lambda program: _upright(made, program, task.platform or ()))
        else:
            _directed(made, task)
        return
    if task.at is None:
        _tilted(made, task, lambda program: _arrow(made, program, task))
        return
    origin, direction, start = _direction(made, task)
    place = _place_of(made, task, _in_space(task.at))
    _aligned(made, "point elsewhere", start, direction, minus(place, origin))


def _reflecting(made: Tasks, task: Reflecting) -> None:
    _placed(made, task, lambda program: made.centre(program, task.platform))
    origin, normal, start = _direction(made, task)
    source = _place_of(made, task, task.source, "source.")
    target = _place_of(made, task, task.target, "target.")
    first, second = unit(minus(source, origin)), unit(minus(target, origin))
    _aligned(made, "turn its normal", start, normal, total([first, second], [1.0, 1.0]))


def _named(made: Tasks, task: Any) -> None:
    """Coordinates by name: of `Coordinates`, or of a trajectory."""
    for name in task.moves if isinstance(task, Coordinates) else moved_by(task)[1]:
        one = coordinates(made.system, name)
        if len(one) == 1:
            made.ask(task, name, partial(_coordinate, made, one=one[0]))


def _coordinate(made: Tasks, program: Program, one: Coordinate) -> Any:
    """What a coordinate of the model reads."""
    system = made.system
    if one.kind == "node":
        return program.node(one.index // 3, system.dim)[one.index % 3]
    if one.kind == "sum":
        return measure_of(system, program, one.index)
    if one.kind == "pose":
        bay = bay_of(system, one.pose)
        base, top = (tuple(system.nodes[i] for i in side) for side in (bay.base, bay.top))
        if one.index == 2:
            return size(minus(made.centre(program, top), made.centre(program, base)))
        return _tilts(_seen(made, program, top, base))[one.index]
    p, q = (program.node(int(ends[one.index]), system.dim) for ends in (system.p, system.q))
    d = minus(q, p)
    return size(d) if one.kind == "length" else angle(d[1], d[0])


def _in_space(point: Any) -> Any:
    return np.array([*point, 0.0][:3])


_MAKERS: dict[type, Any] = {
    Gimbal: _gimbal,
    Positioning: _positioning,
    Docking: _docking,
    Pointing: _pointing,
    Reflecting: _reflecting,
    Coordinates: _named,
}
