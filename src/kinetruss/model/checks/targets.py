"""Faults of tasks of a structure: names that the model does not have, and tasks that contradict it or themselves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.checks.common import other_quantity, unknown
from kinetruss.model.motion.drives import turns
from kinetruss.model.motion.targets import TARGETS, Combined, Coordinates, Gimbal, Pointing, Way

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData

__all__ = ["target_faults"]

Place = tuple[Any, ...]
ANGLES = ("beta", "gamma", "roll", "pitch", "yaw", "angle")
"""Coordinates that are angles, by the end of their names."""
SPATIAL = ("gimbal", "pointing", "reflecting")


def target_faults(model: ModelData, target: Any, path: Place = ("targets",)) -> Iterator[Fault]:
    """Faults of a task, or of tasks that are combined, against a model.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> lift = kt.Positioning(node="C", moves={"y": 2.0})
    >>> [fault.message for fault in kt.model.target_faults(model, lift)]
    ["no node called 'C'."]
    """
    if isinstance(target, TARGETS):
        yield from _drives(model, target, path)
    if not isinstance(target, Combined):
        yield from _single(model, target, path)
        return
    asked: dict[Any, int] = {}
    for k, task in enumerate(target.tasks):
        yield from _single(model, task, (*path, "tasks", k))
        for one in _asked(model, task):
            if one in asked:
                mend = "Ask for it once; or leave it free in one of them."
                yield Fault(
                    (*path, "tasks", k), f"asks for {one[-1]!r} of {_called(one[0])}, as task {asked[one] + 1} does.", mend
                )
                break
            asked[one] = k


def _drives(model: ModelData, target: Any, path: Place) -> Iterator[Fault]:
    drives = model.all_drives
    for field in ("hold", "weights", "rate", "acceleration", "force"):
        given = getattr(target, field)
        for name in given if isinstance(given, Iterable) else ():
            if name not in drives:
                yield unknown("drive", name, drives, (*path, field, name))
    if drives and set(target.hold) >= set(drives):
        yield Fault((*path, "hold"), "holds all drives, so nothing can move.", "Hold fewer.")


def _single(model: ModelData, task: Any, path: Place) -> Iterator[Fault]:
    if not isinstance(task, TARGETS) or isinstance(task, Combined):
        return
    for field in ("node", "nodes", "platform", "base", "line"):
        given = getattr(task, field, None)
        names = (given,) if isinstance(given, str) else given or ()
        for name in names:
            if name not in model.nodes:
                yield unknown("node", name, model.nodes, (*path, field))
        yield from _group(model, task, field, names, path)
    if task.kind in SPATIAL and model.dim == 2:
        yield Fault(path, f"{task.kind} is a task in space; the model is planar.", "Use coordinates, positioning or docking.")
    if model.dim == 2 and (odd := [n for n in (*task.moves, *task.free) if n in ("z", "roll", "pitch")]):
        yield Fault((*path, "moves"), f"{odd[0]!r} is no coordinate in the plane.", "Use x, y, yaw.")
    if isinstance(task, Gimbal) and task.division != "exact" and not model.poses:
        yield Fault(
            (*path, "division"),
            "the model has no poses, so there are no bays.",
            "Give the poses of the bays, or division: exact.",
        )
    if isinstance(task, Coordinates):
        yield from _coordinates(model, task, path)
    for name, course in task.moves.items():
        yield from _course(model, task, name, course, (*path, "moves", name))


def _course(model: ModelData, task: Any, name: str, course: Any, path: Place) -> Iterator[Fault]:
    """Values in units of another kind, and way points after the end."""
    last = name.rpartition(".")[2]
    drive = model.all_drives.get(name) if isinstance(task, Coordinates) else None
    kind = "angle" if last in ANGLES or (drive is not None and turns(drive)) else "length"
    values = course.values if isinstance(course, Way) else course if isinstance(course, tuple) else (course,)
    other = [given for value in values if (given := getattr(value, "quantity", None)) not in (None, kind)]
    if other:
        yield other_quantity(path, "moves", other[0], kind)
    if not isinstance(course, Way):
        return
    last_time = course.times[-1] if course.times is not None else course.end
    if last_time is not None and last_time > task.duration * (1 + 1e-9):
        yield Fault(
            path,
            f"ends at {last_time:g} s, but the task at {task.duration:g} s, so the last way point is not reached.",
            f"Give duration: {last_time:g}, or earlier times.",
        )


def _group(model: ModelData, task: Any, field: str, names: Sequence[str], path: Place) -> Iterator[Fault]:
    """Nodes that are to carry a plane or a frame."""
    if field == "node" and names:
        yield from _held(model, task, names[0], (*path, field))
    if field in ("node", "line") or not names:
        return
    plain = task.kind == "positioning" and task.point is None
    least = 1 if plain else model.dim
    if len(set(names)) != len(names):
        yield Fault((*path, field), "names a node twice.", "Name each once.")
    elif len(names) < least:
        yield Fault((*path, field), f"has {len(names)} nodes; a platform has {least} at least.", "Name more.")
    elif field in ("platform", "nodes") and all(name in model.fixed and len(model.fixed[name]) == model.dim for name in names):
        yield Fault((*path, field), "all its nodes are fixed, so it cannot move.", "Name nodes that move.")


def _held(model: ModelData, task: Any, node: str, path: Place) -> Iterator[Fault]:
    """Coordinates of a node that supports hold."""
    axes = [axis for axis in "xyz" if axis in model.fixed.get(node, "") and axis not in task.free]
    if moved := [axis for axis in axes if axis in task.moves]:
        yield Fault(path, f"{node!r} is fixed in {moved[0]} and cannot move there.", "Name a node that moves.")
    elif axes:
        text = f"{node!r} is fixed in {axes[0]}, so there is nothing for the drives to hold."
        yield Fault(path, text, f"Give free: [{', '.join(axes)}].")


def _coordinates(model: ModelData, task: Coordinates, path: Place) -> Iterator[Fault]:
    axes = "xyz"[: model.dim]
    known = {*model.all_drives, *model.members, *(f"{member}.length" for member in model.members)}
    known |= {f"{node}.{axis}" for node in model.nodes for axis in axes}
    known |= {f"{pose}.{part}" for pose in model.poses for part in ("beta", "gamma", "height")}
    known |= {f"{member}.angle" for member in model.members} if model.dim == 2 else set()
    for name in task.moves:
        if name not in known:
            yield unknown("coordinate", name, sorted(known), (*path, "moves", name))
            continue
        node, _, axis = name.rpartition(".")
        if node in model.nodes and axis in model.fixed.get(node, ""):
            yield Fault((*path, "moves", name), "is fixed and cannot move.", "Name another coordinate, or release the support.")


def _asked(model: ModelData, task: Any) -> list[Any]:
    """What a task asks for, so that the same is not asked for twice."""
    if not isinstance(task, TARGETS):
        return []
    if isinstance(task, Coordinates):
        return [("coordinates", name) for name in task.moves]
    what = (
        task.node
        if task.kind == "positioning" and task.node
        else getattr(task, "platform", None) or getattr(task, "nodes", None)
    )
    if isinstance(task, Pointing) and task.line is not None:
        what = task.line
    names = [name for name in task.COORDINATES if name not in task.free]
    if task.kind == "positioning":
        if task.node is not None:
            return [("coordinates", f"{task.node}.{axis}") for axis in "xyz"[: model.dim] if axis in names]
        return [(what, task.point, name) for name in names]
    return [(what, task.kind if task.kind != "docking" else "", name) for name in names]


def _called(what: Any) -> str:
    return what if isinstance(what, str) else ", ".join(what)
