"""Cross-checks of a whole model before any computation: every fault with its fix."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.beam_checks import beam_faults
from kinetruss.model.body_checks import body_faults, planar_body_faults
from kinetruss.model.common_faults import a_bar, components, other_quantity
from kinetruss.model.continua import continuum_faults
from kinetruss.model.coordinate_checks import (
    coupling_faults,
    element_faults,
    force_element_faults,
    joint_faults,
    measured_faults,
)
from kinetruss.model.deflection_limits import deflection_faults
from kinetruss.model.drives import AngleDrive, CoordinateDrive, HingeDrive, LengthDrive, coordinate_kinds
from kinetruss.model.gauges import gauge_faults
from kinetruss.model.hub_expansion import bearing_faults
from kinetruss.model.links import link_faults
from kinetruss.model.load_cases import case_faults
from kinetruss.model.load_checks import load_faults
from kinetruss.model.members import Active, elastic_faults
from kinetruss.model.quantities import quantity_faults
from kinetruss.model.references import unknown_names
from kinetruss.model.run_checks import all_condition_faults, run_faults, value_faults
from kinetruss.model.simulation import TRAJECTORY_TASKS
from kinetruss.model.supports import support_faults
from kinetruss.model.trajectories import length_faults, moved_by

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData
    from kinetruss.model.members import Node
    from kinetruss.model.the_model import Model
    from kinetruss.model.whole import WholeModel


def faults(model: Model) -> list[Fault]:
    """All faults of combinations of fields of `model`.

    >>> import kinetruss as kt
    >>> kt.model.faults(kt.library.vgt.triangular())  # a model that exists has none
    []
    """
    return faults_of(model.whole)


def faults_of(model: WholeModel, named: bool = False) -> list[Fault]:
    """`faults` of the model with this whole. named : all names are known to be those of entries."""
    dim = _dim(model)
    return [
        *(() if named else unknown_names(model, model, ())),
        *_nodes(model, dim),
        *_members(model),
        *planar_body_faults(model),
        *body_faults(model, dim),
        *beam_faults(model, dim),
        *link_faults(model, dim),
        *joint_faults(model),
        *(bearing_faults(model) if model.bearings else ()),
        *_loads(model, dim),
        *_drives(model),
        *coupling_faults(model),
        *force_element_faults(model),
        *element_faults(model),
        *_trajectories(model),
        *run_faults(model),
        *all_condition_faults(model),
        *_gauges(model),
        *quantity_faults(model),
        *deflection_faults(model),
        *continuum_faults(model, dim),
        *support_faults(model, dim),
    ]


def dimension(counts: Iterable[int]) -> int:
    """2 or 3: the dimension of most nodes, so that one faulty node does not make all others faulty."""
    return Counter(counts).most_common(1)[0][0]


def misfits(model: ModelData) -> tuple[list[Fault], dict[str, Node]]:
    """Faults of nodes with more or fewer coordinates than most, and the other nodes."""
    dim = _dim(model)
    if all(len(node.at) == dim for node in model.nodes.values()):
        return [], model.nodes
    fitting = {name: node for name, node in model.nodes.items() if len(node.at) == dim}
    mend = f"Give {dim}. (A decimal comma splits a number in two.)"
    odd = [
        Fault(("nodes", name, "at"), f"has {len(node.at)} coordinates, other nodes have {dim}.", mend)
        for name, node in model.nodes.items()
        if name not in fitting
    ]
    return odd, fitting


def _dim(model: ModelData) -> int:
    return dimension(len(node.at) for node in model.nodes.values())


def _nodes(model: ModelData, dim: int) -> Iterator[Fault]:
    places: dict[tuple[float, ...], str] = {}
    for name, node in model.nodes.items():
        yield from components(node.gravity, dim, ("nodes", name, "gravity"))
        other = places.setdefault(node.at, name)
        if other != name and not any(one.coincident or one.scalar for one in (node, model.nodes[other])):
            mend = f"Join the bars at one node, or move one, or say {name}: {{at: [..], coincident: true}} if it is meant."
            yield Fault(("nodes", name), f"stands where node {other!r} stands, at {node.at}.", mend)
    for name, axes in model.fixed.items():
        if dim == 2 and "z" in axes and name in model.nodes:
            yield Fault(("fixed", name), "fixes z in a planar model.", "Leave out z.")
    yield from components(model.gravity, dim, ("gravity",))
    for name, vector in model.velocities.items():
        if name in model.nodes:
            yield from components(vector, dim, ("velocities", name))


def _compliance(model: ModelData, name: str, member: Active) -> Iterator[Fault]:
    """The stiffness of every part in series must be known."""
    given = member.compliance
    if given is None:
        return
    screw = ("screw", member.base) if given.screw is None else None
    for role, part in filter(None, (screw, ("tube", member.tube))):
        if model.section_of(part) is None or model.material_of(part) is None:
            mend = "Give the tube a section and a material."
            if role == "screw":
                mend = "Give compliance: {screw: E A in N}, or the base a section and a material."
            yield Fault(("active", name, "compliance"), f"is given, but E A of its {role} is not known.", mend)


def _members(model: ModelData) -> Iterator[Fault]:
    for name in (one for one in model.active if one in model.bars):
        yield Fault(("active", name), f"{name!r} is also the name of a bar.", "Give each member its own name.")
    dim = _dim(model)
    for table, members in (("bars", model.bars), ("active", model.active)):
        for name, member in members.items():
            yield from _ends(model, member, (table, name))
            if dim == 3 and any(member.friction):
                message = "is given in space, where a bar turns about its pin in more than one way."
                yield Fault((table, name, "friction"), message, "Leave it out, or make the model planar.", about=(("nodes",),))
            if member.orientation is not None:
                yield from _orientation(model, member, (table, name))
    for name, bar in model.bars.items():
        yield from _bar(model, name, bar)
    for name, active in model.active.items():
        yield from _active(model, name, active)
        yield from _compliance(model, name, active)


def _ends(model: ModelData, member: Any, path: tuple[str, str]) -> Iterator[Fault]:
    p, q = member.ends
    a, b = model.nodes.get(p), model.nodes.get(q)
    if p == q:
        yield Fault((*path, "ends"), f"joins node {p!r} to itself.", "Give two different nodes.")
    elif (a and a.scalar) or (b and b.scalar):
        yield Fault((*path, "ends"), "joins a scalar, which is no place.", "Couple it to the bar instead (couplings).")
    elif a and b and a.at == b.at:
        yield Fault((*path, "ends"), f"has zero length: {p!r} and {q!r} stand at one place.", "Move one of its ends.")


def _orientation(model: ModelData, member: Any, path: tuple[str, str]) -> Iterator[Fault]:
    place = (*path, "orientation")
    points = [model.nodes[name].at for name in (*member.ends, member.orientation) if name in model.nodes]
    if member.orientation in member.ends:
        yield Fault(place, "is one of the bar's own ends.", "Name a third node off the bar's line.")
    elif [len(point) for point in points] == [3, 3, 3] and _on_line(*points):
        yield Fault(place, "stands on the bar's line, so it spans no plane with it.", "Name a node off that line.")


def _on_line(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...]) -> bool:
    u, v = [q - p for p, q in zip(a, b, strict=True)], [q - p for p, q in zip(a, c, strict=True)]
    cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return math.hypot(*cross) <= 1e-9 * math.hypot(*u) * math.hypot(*v)


def _bar(model: ModelData, name: str, bar: Any) -> Iterator[Fault]:
    path = ("bars", name)
    kind = ((*path, "kind"),)
    yield from elastic_faults(model, name, bar)
    if bar.kind in ("elastic", "cable", "free") and bar.length is not None:
        yield Fault((*path, "length"), f"is given for {a_bar(bar.kind)}, which keeps none.", "Remove it.", about=kind)
    if any(bar.friction) and bar.kind in ("cable", "free"):
        message = f"is given for {a_bar(bar.kind)}, which takes nothing across its axis."
        yield Fault((*path, "friction"), message, "Give it to the other bar at the pin.", about=kind)
    if bar.rotary_inertia:
        yield from _rotary(model, bar, path)


def _active(model: ModelData, name: str, active: Any) -> Iterator[Fault]:
    for side in ("base", "tube"):
        part = getattr(active, side)
        path = ("active", name, side)
        if part.mass is None and (lacks := _lacks(model, part)):
            about = ((*path, "mass"), *_parts(path))
            yield Fault(path, f"has no mass, and no {lacks} to find it from.", "Give mass, e.g. '3 kg'.", about=about)
        if part.rotary_inertia:
            yield from _rotary(model, part, path)
    yield from _rods(model, name, active)
    yield from _masses(name, active)
    yield from _train(active, ("active", name))
    if active.motor is not None and active.screw is None:
        about = (("active", name, "screw"),)
        yield Fault(("active", name, "motor"), "turns nothing: there is no screw.", "Give a screw.", about=about)
    if active.length is not None and active.limits and not active.limits[0] <= active.length <= active.limits[1]:
        least, largest = active.limits
        mend = "Change the length or the limits."
        message = f"{active.length:g} m is outside the limits, {least:g} to {largest:g} m."
        yield Fault(("active", name, "length"), message, mend)


def _rods(model: ModelData, name: str, active: Any) -> Iterator[Fault]:
    """A rod that is longer than its member at the start, or at its least length."""
    ends = [model.nodes[end].at for end in active.ends if end in model.nodes]
    start = active.length
    if start is None and len(ends) == 2 and len(ends[0]) == len(ends[1]):
        start = math.dist(*ends)
    for side in ("base", "tube"):
        rod = getattr(active, side).length
        path, mend = ("active", name, side, "length"), f"Shorten the {side}, or lengthen the member."
        about = (("active", name, "length"), ("active", name, "limits"), *(("nodes", end) for end in active.ends))
        if start is not None and rod > start * (1 + 1e-9):
            yield Fault(path, f"{rod:g} m is longer than the member, {start:g} m at the start.", mend, about=about)
        elif active.limits is not None and rod > active.limits[0] * (1 + 1e-9):
            least = f"{active.limits[0]:g} m at the least of its limits"
            yield Fault(path, f"{rod:g} m is longer than the member, {least}.", mend, about=about)


def _masses(name: str, active: Active) -> Iterator[Fault]:
    """Masses clamped beside their rod."""
    for side in ("base", "tube"):
        rod = getattr(active, side)
        for index, one in enumerate(rod.masses):
            path = ("active", name, side, "masses", index)
            if not 0 <= one.at <= rod.length * (1 + 1e-9):
                message = f"{one.at:g} m is not on the {side}, which is {rod.length:g} m long."
                yield Fault((*path, "at"), message, f"Give 0 to {rod.length:g} m from its clamped end.")


def _train(one: Any, path: tuple[str, ...]) -> Iterator[Fault]:
    """An amplifier without a motor."""
    if one.amplifier is not None and one.motor is None:
        about = ((*path, "motor"),)
        yield Fault((*path, "amplifier"), "feeds nothing: there is no motor.", "Give a motor.", about=about)


def _lacks(model: ModelData, part: Any) -> str:
    """Section and material that a bar or part lacks, in words; empty if it has both, own or from the model."""
    section = part.section is None and model.section is None
    material = part.material is None and model.material is None
    return " and no ".join(word for word, absent in (("section", section), ("material", material)) if absent)


def _parts(path: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
    return (*path, "section"), (*path, "material"), ("section",), ("material",)


def _rotary(model: ModelData, part: Any, path: tuple[str, ...]) -> Iterator[Fault]:
    chosen = part.section if part.section is not None else model.section
    section = model.sections.get(chosen) if isinstance(chosen, str) else chosen
    path = (*path, "rotary_inertia")
    if chosen is None:
        yield Fault(path, "needs a section.", "Give section, or switch it off.", about=_parts(path[:-1]))
    elif section is not None and _dim(model) == 3 and section.second_moments[0] != section.second_moments[1]:
        yield Fault(path, "needs a section with I2 = I3 in space.", "Use a tube or rod, or switch it off.")


def _loads(model: WholeModel, dim: int) -> Iterator[Fault]:
    yield from load_faults(model, dim)
    yield from case_faults(model, dim)
    for node, history in model.support_motion.items():
        path = ("support_motion", node)
        if node in model.nodes and node not in model.fixed:
            mend = f"Fix it first: fixed: {{{node}: {'xyz'[:dim]}}}."
            yield Fault(path, "is not a fixed node.", mend, about=(("fixed", node),))
        for index, vector in enumerate(history.displacements):
            yield from components(vector, dim, (*path, "displacements", index))


def _drives(model: ModelData) -> Iterator[Fault]:
    driven: dict[Any, str] = {}
    own = {name for name, bar in model.bars.items() if bar.kind == "driven"} | set(model.active)
    for name, drive in model.all_drives.items():
        path = ("drives", name)
        target = _target(drive)
        if isinstance(drive, (AngleDrive, HingeDrive)):
            yield from measured_faults(model, drive, path)
            yield from _train(drive, path)
        else:
            yield from (_node_drive if isinstance(drive, CoordinateDrive) else _bar_drive)(model, drive, path)
        if name in own and target != ("length", name, None):
            yield Fault(path, f"is also the name of the driven member {name!r}.", "Give the drive another name.")
        if target in driven:
            yield Fault(path, f"drives what {driven[target]!r} drives already.", "Keep one of them.")
        driven.setdefault(target, name)


def _target(drive: Any) -> tuple[Any, ...]:
    """A key of the coordinate that a drive prescribes: equal for drives of the same coordinate."""
    if isinstance(drive, CoordinateDrive):
        return drive.node, drive.axis
    if isinstance(drive, HingeDrive):
        return drive.kind, frozenset(drive.axis), frozenset((drive.start, drive.end))
    return drive.kind, drive.bar, drive.axis if isinstance(drive, AngleDrive) else None


def _node_drive(model: ModelData, drive: Any, path: tuple[str, ...]) -> Iterator[Fault]:
    if drive.node in model.nodes and drive.axis in model.fixed.get(drive.node, ""):
        yield Fault(path, f"moves {drive.node}.{drive.axis}, which is fixed.", "Free that axis, or drive another.")
    if _dim(model) == 2 and drive.axis == "z":
        yield Fault((*path, "axis"), "is z in a planar model.", "Choose x or y.", about=(("nodes",),))


def _bar_drive(model: ModelData, drive: Any, path: tuple[str, ...]) -> Iterator[Fault]:
    if (
        isinstance(drive, LengthDrive)
        and drive.bar in model.bars
        and model.bars[drive.bar].kind in ("elastic", "cable", "free")
    ):
        yield Fault(path, f"drives the length of {a_bar(model.bars[drive.bar].kind)}.", "Make it kind: driven.")


def _trajectories(model: ModelData) -> Iterator[Fault]:
    found: list[tuple[tuple[str, ...], Any]] = [
        (("trajectories", name), trajectory) for name, trajectory in model.trajectories.items()
    ]
    found += [
        (("runs", name, "trajectory"), run.trajectory)
        for name, run in model.runs.items()
        if run.trajectory is not None and not isinstance(run.trajectory, str)
    ]
    found += [
        (("runs", name, "tasks", drive), task)
        for name, run in model.runs.items()
        for drive, task in run.tasks.items()
        if isinstance(task, TRAJECTORY_TASKS)
    ]
    for path, trajectory in found:
        yield from _trajectory(model, trajectory, path)


def trajectory_faults(model: Model, trajectory: Any, path: tuple[Any, ...] = ("trajectory",)) -> Iterator[Fault]:
    """Faults of a trajectory against the drives and poses of a model.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> wrong = kt.Quintic(moves={"motor": (2.5, 2.6)}, duration=1.0)
    >>> [fault.message for fault in kt.model.trajectory_faults(model, wrong)]
    ["no drive or pose coordinate called 'motor'."]
    """
    moved_by(trajectory)  # refuses what is none
    yield from unknown_names(model.whole, trajectory, path)
    yield from _trajectory(model.whole, trajectory, path)


def _trajectory(model: ModelData, trajectory: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Values in units of another kind, drives that their pose moves too, members that lose their length."""
    kinds = coordinate_kinds(model)
    field, table = moved_by(trajectory)
    for name, value in table.items():
        place = (*path, field, name)
        for number in value if isinstance(value, tuple) else (value,):
            given = getattr(number, "quantity", None)
            if given is not None and given != kinds.get(name, given):
                yield other_quantity(place, field, given, kinds[name])
                break
    yield from _both_ways(model, set(table), path)
    yield from length_faults(model, trajectory, path)


def _both_ways(model: ModelData, named: set[str], path: tuple[Any, ...]) -> Iterator[Fault]:
    """A trajectory moves a drive or its pose, not both."""
    for name, pose in model.poses.items():
        posed = {
            coordinate for coordinate in named if coordinate.rpartition(".")[0] == name and coordinate not in model.all_drives
        }
        if posed and (twice := named & set(pose.drives)):
            yield Fault(path, f"moves {sorted(twice)} and the pose {name!r} that moves them.", "Keep lengths or pose.")


def _gauges(model: ModelData) -> Iterator[Fault]:
    if model.gauge_zero is not None:
        yield from value_faults(model, model.gauge_zero.at, ("gauge_zero", "at"))
    yield from gauge_faults(model)
