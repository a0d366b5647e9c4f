"""Cross-checks of runs: what they name, and of simulations the start velocities, tasks, events."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.common_faults import components, other_quantity
from kinetruss.model.coordinate_checks import measured_faults, sum_faults
from kinetruss.model.drives import LengthDrive, coordinate_kinds, turns
from kinetruss.model.inputs import PositionLoop
from kinetruss.model.load_cases import sets_of
from kinetruss.model.members import Active
from kinetruss.model.references import unknown_names
from kinetruss.model.runs import Run
from kinetruss.model.simulation import MOTOR_TASKS, TRAJECTORY_TASKS, GivenForce
from kinetruss.model.targets import target_rules
from kinetruss.model.tracking import tracking_rules
from kinetruss.model.trajectories import moved_by
from kinetruss.model.words import nearest

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData
    from kinetruss.model.runs import BaseRotation, Condition
    from kinetruss.model.the_model import Model
    from kinetruss.model.whole import WholeModel


MOVING = (
    "dynamics.inverse",
    "dynamics.simulate",
    "kinematics.follow",
    "statics.at_poses",
    "statics.deflection",
    "statics.equilibrium",
)
"""Analyses whose motion, or poses, a mission can take."""


def task_faults(model: Model, tasks: Any, path: tuple[Any, ...] = ("tasks",)) -> Iterator[Fault]:
    """Faults of tasks against the drives of a model. Trajectories are checked separately.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> [fault.message for fault in kt.model.task_faults(model, {"motor": kt.Hold()})]
    ["no drive called 'motor'."]
    """
    yield from unknown_names(model.whole, tasks, path, (Run, "tasks"))
    yield from task_rules(model.whole, tasks, path)


def task_rules(model: ModelData, tasks: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Tasks that do not fit their drives."""
    for name, task in tasks.items():
        place = (*path, name)
        drive = model.all_drives.get(name)
        if drive is None:
            continue
        if isinstance(task, GivenForce):
            if task.turns and isinstance(drive, LengthDrive) and isinstance(model.members.get(drive.bar), Active):
                yield from _motor(model, name, drive, place)
            elif task.turns != turns(drive) and not _scalar(model, drive):
                yield _other_push(task, name, drive, place)
        elif isinstance(task, MOTOR_TASKS):
            yield from _motor(model, name, drive, place)
            if isinstance(task, PositionLoop):
                yield from _targets(task, name, drive, place)
        elif isinstance(task, TRAJECTORY_TASKS):
            yield from _alone(task, name, place)


def _scalar(model: ModelData, drive: Any) -> bool:
    """True for the coordinate of a scalar, which may be a length or an angle."""
    return drive.kind == "coordinate" and drive.node in model.nodes and model.nodes[drive.node].scalar


def _driven(drive: Any) -> str:
    return {"angle": "an angle", "hinge": "an angle", "length": "a length"}.get(drive.kind, "a coordinate")


def _other_push(task: GivenForce, name: str, drive: Any, place: tuple[Any, ...]) -> Fault:
    """A force on an angle, or a torque on a length or coordinate."""
    given, wanted, unit = ("torque", "force", "N") if task.turns else ("force", "torque", "N m")
    many = "s" if task.table is not None else ""
    mend = f"Give {wanted}{many} ({unit}) instead of {given}{many}"
    mend += ", e.g. " + (f"{wanted}s: [0, 1.5] with its times." if many else f"{wanted}: 1.5.")
    what = given + many if many else f"a {given}"
    return Fault(place, f"has {what}, but {name!r} drives {_driven(drive)}.", mend, about=(("drives", name),))


def _targets(loop: PositionLoop, name: str, drive: Any, place: tuple[Any, ...]) -> Iterator[Fault]:
    """Targets with a unit must have the unit of the driven coordinate."""
    kind = "angle" if turns(drive) else "length"
    field, values = ("target", (loop.target,)) if loop.targets is None else ("targets", loop.targets)
    for value in values:
        given = getattr(value, "quantity", None)
        if given not in (None, kind):
            what, mend = ("a length", "'30 deg'") if kind == "angle" else ("an angle", "'1.2 m'")
            yield Fault(
                (*place, field), f"is given as {what}, but {name!r} drives {_driven(drive)}.", f"Write for example {mend}."
            )
            return


def _motor(model: ModelData, name: str, drive: Any, place: tuple[Any, ...]) -> Iterator[Fault]:
    """An input needs a motor, and a screw if it drives a length."""
    if turns(drive):
        if drive.motor is None:
            mend = "Give the drive a motor (and a gear), or give its torque: kind: force, torque: 1.5."
            yield Fault(place, f"feeds a motor, but {name!r} has none.", mend, about=(("drives", name),))
        return
    member = model.members.get(drive.bar) if isinstance(drive, LengthDrive) else None
    if not isinstance(member, Active):
        mend = "Give a force, or let an active member with screw and motor drive it."
        yield Fault(place, f"feeds a motor, but {name!r} has none.", mend, about=(("drives", name), ("bars", name)))
    elif member.motor is None or member.screw is None:
        lacks = " and no ".join(word for word in ("screw", "motor") if getattr(member, word) is None)
        about = tuple(("active", drive.bar, word) for word in ("screw", "motor"))
        yield Fault(place, f"feeds the motor of {drive.bar!r}, which has no {lacks}.", "Give screw and motor.", about=about)


def _alone(task: Any, name: str, place: tuple[Any, ...]) -> Iterator[Fault]:
    moved = set(moved_by(task)[1])
    if moved != {name}:
        others = ", ".join(sorted(moved - {name})) or "nothing"
        mend = f"Move {name!r} alone here; use the run's trajectory to move several."
        yield Fault(place, f"moves {others}, not {name!r} alone.", mend)


def event_faults(model: Model, events: Any, path: tuple[Any, ...] = ("events",)) -> Iterator[Fault]:
    """Faults of events against the members and nodes of a model.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> [fault.message for fault in kt.model.event_faults(model, {"low": kt.Event(coordinate="C.y", value=0.0)})]
    ["no coordinate called 'C.y'."]
    """
    yield from unknown_names(model.whole, events, path, (Run, "events"))
    yield from event_rules(model.whole, events, path)


def event_rules(model: ModelData, events: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Events of coordinates that are none."""
    for name, event in events.items():
        if event.terms is not None:
            yield from sum_faults(model, event.terms, (*path, name, "terms"))
        elif event.coordinate is not None and not isinstance(event.coordinate, str):
            yield from measured_faults(model, event.coordinate, (*path, name, "coordinate"))
        elif event.coordinate is not None:
            place = (*path, name, "coordinate")
            node, _, axis = event.coordinate.rpartition(".")
            axes = "xyz"[: max((len(one.at) for one in model.nodes.values()), default=3)]
            if node not in model.nodes:
                known = [f"{one}.{letter}" for one in model.nodes for letter in axes]
                yield Fault(
                    place,
                    f"no coordinate called {event.coordinate!r}.",
                    nearest(event.coordinate, known),
                    about=(("nodes", node),),
                )
            elif axis not in axes or len(axis) != 1:
                yield Fault(
                    place, f"{axis!r} is no axis of node {node!r}.", f"Write {node}.x or {node}.y.", about=(("nodes",),)
                )


def run_faults(model: ModelData) -> Iterator[Fault]:
    """Targets, tasks, events, motions and poses of all runs that do not fit the model."""
    for name, run in model.runs.items():
        if run.targets is not None:
            yield from target_rules(model, run.targets, ("runs", name, "targets"))
        yield from task_rules(model, run.tasks, ("runs", name, "tasks"))
        yield from event_rules(model, run.events, ("runs", name, "events"))
        yield from tracking_rules(model, run, ("runs", name))
        yield from _mission_faults(model, name, run)
        yield from _case_faults(model, name, run)
        for pose, values in run.poses.items():
            yield from value_faults(model, values, ("runs", name, "poses", pose))


def _case_faults(model: ModelData, name: str, run: Run) -> Iterator[Fault]:
    """Combinations of a standard in a run that has one load case."""
    if run.analysis in ("dynamics.simulate", "statics.equilibrium") and run.load_cases:
        several = [case for case in run.load_cases if case not in model.cases and case in model.combinations]
        if several:
            count, first = len(sets_of(model)[several[0]]), next(iter(sets_of(model)[several[0]]), "")
            message = f"names {count} combinations by {several[0]!r}, and {run.analysis} has one load case."
            mend = f"Name one of them, e.g. {first}." if first else "Name a load case."
            yield Fault(("runs", name, "load_cases"), message, mend, about=(("combinations", several[0]),))


def _mission_faults(model: ModelData, name: str, run: Run) -> Iterator[Fault]:
    """Runs that a mission names must have motions or poses."""
    for index, motion in enumerate(run.motions):
        place = ("runs", name, "motions", index)
        if motion in model.runs and model.runs[motion].analysis not in MOVING:
            what = model.runs[motion].analysis
            mend = "Name runs of dynamics.inverse, dynamics.simulate, statics.at_poses or statics.equilibrium."
            yield Fault(place, f"{motion!r} is {what}, which has no motion and no poses of its own.", mend)
        elif motion in model.runs and model.runs[motion].condition is not None:
            mend = "Remove it there, and name it in the conditions of the mission."
            yield Fault(place, f"{motion!r} has a condition of its own.", mend)


def all_condition_faults(model: WholeModel) -> Iterator[Fault]:
    """Faults of all conditions of a model, and of the rotation of its base."""
    yield from base_rotation_faults(model, model.base_rotation, ("base_rotation",))
    for name, condition in model.conditions.items():
        yield from condition_rules(model, condition, ("conditions", name))


def condition_faults(model: Model, condition: Condition, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Unknown nodes, members and drives of a condition, and vectors with too few or too many components.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> [fault.message for fault in kt.model.condition_faults(model, kt.Condition(payloads={"C": 1.0}), ("laden",))]
    ["no node called 'C'."]
    """
    yield from unknown_names(model.whole, condition, path)
    yield from condition_rules(model.whole, condition, path)


def condition_rules(model: WholeModel, condition: Condition, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Vectors with too few or too many components, and changes of inner parts."""
    for field, inner in (("payloads", model.inner.nodes), ("failed", model.inner.bars)):
        for name in getattr(condition, field):
            if name in inner:
                mend = "Name a node or member of the model itself."
                yield Fault((*path, field), f"names {name!r}, which is made for {inner[name].text}.", mend)
    dim = len(next(iter(model.nodes.values())).at)
    for node, force in condition.forces.items():
        yield from components(force, dim, (*path, "forces", node))
    for field in ("gravity", "base_acceleration"):
        yield from components(getattr(condition, field), dim, (*path, field))
    yield from base_rotation_faults(model, condition.base_rotation, (*path, "base_rotation"))


def base_rotation_faults(model: ModelData, base: BaseRotation | None, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Faults of a rotation of the base: one component in the plane, three in space; which gravity turns."""
    if base is None:
        return
    dim = len(next(iter(model.nodes.values())).at)
    yield from components(base.center, dim, (*path, "center"))
    wanted, place = (1, "in the plane: about z") if dim == 2 else (3, "in space")
    for field in ("angular_velocity", "angular_acceleration"):
        vector = getattr(base, field)
        if vector is not None and len(vector) != wanted:
            yield Fault((*path, field), f"has {len(vector)} components, the model has {wanted} {place}.", f"Give {wanted}.")
    if left := [*model.bending, *(name for name, node in model.nodes.items() if node.scalar)]:
        mend = "Leave out base_rotation, or make beams of bars."
        yield Fault(
            path, f"is not taken into account by beams, links and scalar coordinates, and the model has {left[0]!r}.", mend
        )
    if base.gravity_turns and (own := [name for name, node in model.nodes.items() if node.gravity is not None]):
        mend = "Leave out gravity_turns, or the gravity of the node."
        yield Fault((*path, "gravity_turns"), f"turns one gravity, but node {own[0]!r} has one of its own.", mend)


def value_faults(model: ModelData, values: Mapping[str, Any], path: tuple[Any, ...]) -> Iterator[Fault]:
    """Values of drives and pose coordinates: lengths in place of angles."""
    kinds = coordinate_kinds(model)
    for name, value in values.items():
        if (quantity := getattr(value, "quantity", None)) not in (None, kinds.get(name, quantity)):
            yield other_quantity((*path, name), path[-1] if path[-1] == "at" else "poses", quantity, kinds[name])
