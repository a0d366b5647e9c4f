"""Cross-checks of a whole model: every fault with its mend, found before any work."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model._drives import AngleDrive, CoordinateDrive, LengthDrive

if TYPE_CHECKING:
    from kinetruss.model._model import Model

__all__ = ["coordinate_kinds", "faults"]


def faults(model: Model) -> list[Fault]:
    """All faults that concern more than one field of `model`."""
    checks = (_nodes, _members, _tables, _loads, _drives, _trajectories, _runs)
    return [fault for check in checks for fault in check(model)]


def coordinate_kinds(model: Model) -> dict[str, str]:
    """Coordinates a trajectory may move, by name -> ``length`` or ``angle``."""
    kinds = {
        name: "angle" if isinstance(drive, AngleDrive) else "length" for name, drive in model.all_drives.items()
    }
    for pose in model.poses:
        kinds |= {f"{pose}.beta": "angle", f"{pose}.gamma": "angle", f"{pose}.height": "length"}
    return kinds


def unknown(what: str, name: str, known: Iterable[str], path: tuple[Any, ...]) -> Fault:
    """The fault of a name that is not there, offering the nearest ones."""
    known = [str(k) for k in known]
    near = get_close_matches(str(name), known, n=3, cutoff=0.5)
    offer = f"Did you mean {', '.join(map(repr, near))}?" if near else f"There are: {', '.join(known[:12]) or 'none'}."
    return Fault(path, f"no {what} called {name!r}.", offer)


def _nodes(model: Model) -> Iterator[Fault]:
    dim = model.dim
    places: dict[tuple[float, ...], str] = {}
    for name, node in model.nodes.items():
        if len(node.at) != dim:
            yield Fault(("nodes", name), f"has {len(node.at)} coordinates, the first node has {dim}.", f"Give {dim}.")
        if node.gravity is not None and len(node.gravity) != dim:
            yield Fault(("nodes", name, "gravity"), f"has {len(node.gravity)} components.", f"Give {dim}.")
        if node.at in places:
            other = places[node.at]
            mend = "Join the bars at one node, or move one of them."
            yield Fault(("nodes", name), f"stands where node {other!r} stands, at {node.at}.", mend)
        places.setdefault(node.at, name)
    for name, axes in model.fixed.items():
        if name not in model.nodes:
            yield unknown("node", name, model.nodes, ("fixed", name))
        elif dim == 2 and "z" in axes:
            yield Fault(("fixed", name), "fixes z in a planar model.", "Leave out z.")
    if model.gravity is not None and len(model.gravity) != dim:
        yield Fault(("gravity",), f"has {len(model.gravity)} components.", f"Give {dim}.")


def _members(model: Model) -> Iterator[Fault]:
    for name in model.active.keys() & model.bars.keys():
        yield Fault(("active", name), f"{name!r} is also the name of a bar.", "Give each member its own name.")
    for table, members in (("bars", model.bars), ("active", model.active)):
        for name, member in members.items():
            path = (table, name)
            missing = [end for end in member.ends if end not in model.nodes]
            for end in missing:
                yield unknown("node", end, model.nodes, (*path, "ends"))
            p, q = member.ends
            if p == q:
                yield Fault((*path, "ends"), f"joins node {p!r} to itself.", "Give two different nodes.")
            elif not missing and model.nodes[p].at == model.nodes[q].at:
                mend = "Give its ends two different places."
                yield Fault((*path, "ends"), f"has zero length: {p!r} and {q!r} stand at one place.", mend)
            if member.orientation is not None:
                yield from _orientation(model, member, path)
    for name, bar in model.bars.items():
        yield from _bar(model, name, bar)
    for name, active in model.active.items():
        yield from _active(model, name, active)


def _orientation(model: Model, member: Any, path: tuple[str, str]) -> Iterator[Fault]:
    if member.orientation not in model.nodes:
        yield unknown("node", member.orientation, model.nodes, (*path, "orientation"))
    elif member.orientation in member.ends:
        yield Fault((*path, "orientation"), "is one of the bar's own ends.", "Name a third node off the bar's line.")


def _bar(model: Model, name: str, bar: Any) -> Iterator[Fault]:
    path = ("bars", name)
    section, material = _resolved(model, bar)
    if bar.kind == "elastic" and (section is None or material is None):
        yield Fault(path, "is elastic but has no section or no material.", "Give both, for E A.")
    if bar.kind != "elastic" and bar.natural_length is not None:
        yield Fault((*path, "natural_length"), f"is given for a {bar.kind} bar.", "Only elastic bars have one.")
    if bar.kind in ("elastic", "free") and bar.length is not None:
        yield Fault((*path, "length"), f"is given for a {bar.kind} bar, which keeps none.", "Remove it.")
    if bar.rotary_inertia:
        yield from _rotary(model, section, path)


def _active(model: Model, name: str, active: Any) -> Iterator[Fault]:
    for side in ("base", "tube"):
        part = getattr(active, side)
        path = ("active", name, side)
        section, material = _resolved(model, part)
        if part.mass is None and (section is None or material is None):
            yield Fault(path, "has no mass, and no section and material to find it from.", "Give mass, e.g. '3 kg'.")
        if part.rotary_inertia:
            yield from _rotary(model, section, path)
    for kind, table in (("screw", model.screws), ("gear", model.gears), ("motor", model.motors)):
        chosen = getattr(active, kind)
        if isinstance(chosen, str) and chosen not in table:
            yield unknown(kind, chosen, table, ("active", name, kind))
    if active.motor is not None and active.screw is None:
        yield Fault(("active", name, "motor"), "turns nothing: there is no screw.", "Give a screw.")
    if active.length is not None and active.limits and not active.limits[0] <= active.length <= active.limits[1]:
        yield Fault(("active", name, "length"), f"{active.length:g} m is outside its limits {active.limits}.", "Move one.")


def _rotary(model: Model, section: Any, path: tuple[str, ...]) -> Iterator[Fault]:
    if section is None:
        yield Fault((*path, "rotary_inertia"), "needs a section.", "Give section, or switch it off.")
    elif model.dim == 3 and section.second_moments[0] != section.second_moments[1]:
        yield Fault((*path, "rotary_inertia"), "needs a section with I2 = I3 in space.", "Use a tube or rod, or switch it off.")


def _resolved(model: Model, part: Any) -> tuple[Any, Any]:
    """Section and material of a part; None where absent or where the name is unknown (reported elsewhere)."""
    chosen_section = part.section if part.section is not None else model.section
    chosen_material = part.material if part.material is not None else model.material
    section = model.sections.get(chosen_section) if isinstance(chosen_section, str) else chosen_section
    material = model.materials.get(chosen_material) if isinstance(chosen_material, str) else chosen_material
    return section, material


def _tables(model: Model) -> Iterator[Fault]:
    parts: list[tuple[tuple[str, ...], Any]] = [((), model)]
    parts += [(("bars", name), bar) for name, bar in model.bars.items()]
    for name, active in model.active.items():
        parts += [(("active", name, "base"), active.base), (("active", name, "tube"), active.tube)]
    for path, part in parts:
        if isinstance(part.section, str) and part.section not in model.sections:
            yield unknown("section", part.section, model.sections, (*path, "section"))
        if isinstance(part.material, str) and part.material not in model.materials:
            yield unknown("material", part.material, model.materials, (*path, "material"))


def _loads(model: Model) -> Iterator[Fault]:
    for name, load in model.loads.items():
        if load.node not in model.nodes:
            yield unknown("node", load.node, model.nodes, ("loads", name, "node"))
        for vector in [load.force] if load.forces is None else load.forces:
            if len(vector) != model.dim:
                yield Fault(("loads", name), f"has a force of {len(vector)} components.", f"Give {model.dim}.")
                break
    for name, case in model.load_cases.items():
        for load in case.loads or ():
            if load not in model.loads:
                yield unknown("load", load, model.loads, ("load_cases", name, "loads", load))
        if case.gravity is not None and len(case.gravity) != model.dim:
            yield Fault(("load_cases", name, "gravity"), f"has {len(case.gravity)} components.", f"Give {model.dim}.")
    for node, history in model.support_motion.items():
        if node not in model.fixed:
            yield Fault(("support_motion", node), "is not a fixed node.", f"Fix it first: fixed: {{{node}: xyz}}.")
        elif len(history.displacements[0]) != model.dim:
            yield Fault(("support_motion", node), "has displacements of another dimension.", f"Give {model.dim}.")


def _drives(model: Model) -> Iterator[Fault]:
    driven: dict[Any, str] = {}
    members = model.members
    for name, drive in model.all_drives.items():
        path = ("drives", name)
        target: Any
        if isinstance(drive, CoordinateDrive):
            target = (drive.node, drive.axis)
            if drive.node not in model.nodes:
                yield unknown("node", drive.node, model.nodes, (*path, "node"))
            elif drive.axis in model.fixed.get(drive.node, ""):
                yield Fault(path, f"moves {drive.node}.{drive.axis}, which is fixed.", "Free that axis, or drive another.")
            if model.dim == 2 and drive.axis == "z":
                yield Fault((*path, "axis"), "is z in a planar model.", "Choose x or y.")
        else:
            target = (drive.kind, drive.bar)
            if drive.bar not in members:
                yield unknown("member", drive.bar, members, (*path, "bar"))
            if isinstance(drive, AngleDrive) and model.dim == 3:
                yield Fault(path, "drives an angle in space.", "Angle drives are for planar models.")
            if isinstance(drive, LengthDrive) and drive.bar in model.bars and model.bars[drive.bar].kind in ("elastic", "free"):
                yield Fault(path, f"drives the length of a {model.bars[drive.bar].kind} bar.", "Make it kind: driven.")
        if target in driven:
            yield Fault(path, f"drives what {driven[target]!r} drives already.", "Keep one of them.")
        driven.setdefault(target, name)
    for name, pose in model.poses.items():
        for member in pose.drives:
            if member not in model.all_drives:
                yield unknown("drive", member, model.all_drives, ("poses", name, "drives"))


def _trajectories(model: Model) -> Iterator[Fault]:
    found = [(("trajectories", name), trajectory) for name, trajectory in model.trajectories.items()]
    found += [
        (("runs", name, "trajectory"), run.trajectory)
        for name, run in model.runs.items()
        if run.trajectory is not None and not isinstance(run.trajectory, str)
    ]
    for path, trajectory in found:
        yield from trajectory_faults(model, trajectory, path)


def trajectory_faults(model: Model, trajectory: Any, path: tuple[Any, ...] = ("trajectory",)) -> Iterator[Fault]:
    """Faults of a trajectory against the drives and poses of a model."""
    kinds = coordinate_kinds(model)
    for field in ("moves", "rates", "amplitudes", "values"):
        for name, value in (getattr(trajectory, field, None) or {}).items():
            place = (*path, field, name)
            if name not in kinds:
                yield unknown("drive or pose coordinate", name, kinds, place)
                continue
            for number in value if isinstance(value, tuple) else (value,):
                given = getattr(number, "quantity", None)
                if given is not None and given != kinds[name]:
                    yield Fault(place, f"is given as a {given}, but {name!r} is a {kinds[name]}.", "Mend the unit.")
                    break
    yield from _both_ways(model, trajectory, path)


def _both_ways(model: Model, trajectory: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """A drive may be moved by itself or by its pose, not by both."""
    named: set[str] = set()
    for field in ("moves", "rates", "amplitudes", "values"):
        named |= set(getattr(trajectory, field, None) or {})
    for name, pose in model.poses.items():
        posed = {coordinate for coordinate in named if coordinate.rpartition(".")[0] == name and coordinate not in model.all_drives}
        if posed and (twice := named & set(pose.drives)):
            yield Fault(path, f"moves {sorted(twice)} and the pose {name!r} that moves them.", "Keep lengths or pose.")


def _runs(model: Model) -> Iterator[Fault]:
    for name, run in model.runs.items():
        if isinstance(run.trajectory, str) and run.trajectory not in model.trajectories:
            yield unknown("trajectory", run.trajectory, model.trajectories, ("runs", name, "trajectory"))
        for case in run.load_cases or ():
            if case not in model.load_cases:
                yield unknown("load case", case, model.load_cases, ("runs", name, "load_cases"))
