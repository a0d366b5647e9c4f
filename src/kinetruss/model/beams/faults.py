"""Cross-checks of beams: ends, matter, directions, releases, rotations, clamps."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.beams.framing import frames
from kinetruss.model.beams.free_spins import spins
from kinetruss.model.checks.common import components, unknown
from kinetruss.model.parts.joints import GROUND

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData
    from kinetruss.model.beams.record import Beam

__all__ = ["beam_faults"]

ALONG = 1e-6
"""Sine of the angle between a beam and its orientation below which these are parallel."""
Path = tuple[Any, ...]


def beam_faults(model: ModelData, dim: int) -> Iterator[Fault]:
    """Faults of all beams and clamps of a model with `dim` axes."""
    some = dim == 3 and any(_lets_go(beam) for beam in model.beams.values())
    held = {name for one in spins(model) for name in one.beams} if some else set[str]()
    for name, beam in model.beams.items():
        path = ("beams", name)
        if name in model.members:
            yield Fault(path, f"{name!r} is also the name of a bar.", "Give each member its own name.", about=(("bars", name),))
        good = yield from _ends(model, beam, path)
        yield from _matter(model, beam, path, dim)
        yield from _release(beam, path, loose=dim == 3 and name not in held)
        yield from _hinges(model, beam, path, dim)
        if beam.kind == "rigid" and beam.damping:
            yield Fault(
                (*path, "damping"), "is given for a rigid beam, which does not deform.", "Leave it out, or kind: elastic."
            )
        yield from _rotation(model, beam, path, dim)
        if good and beam.orientation is not None:
            yield from _orientation(model, beam, path, dim)
    yield from _taken(model)
    yield from _clamps(model)


def _ends(model: ModelData, beam: Beam, path: Path) -> Any:
    """Faults of the ends; returns True if the beam has a direction."""
    p, q = beam.ends
    good = True
    for k, end in enumerate(beam.ends):
        if end not in model.nodes:
            yield unknown("node", end, model.nodes, (*path, "ends", k))
            good = False
        elif model.nodes[end].scalar or model.nodes[end].director:
            yield Fault(
                (*path, "ends", k), f"{end!r} is no place that a beam can join.", "Name a node.", about=(("nodes", end),)
            )
            good = False
    if p == q:
        yield Fault((*path, "ends"), f"joins node {p!r} to itself.", "Give two different nodes.")
        return False
    if good and model.nodes[p].at == model.nodes[q].at:
        message = f"has zero length: {p!r} and {q!r} stand at one place."
        yield Fault((*path, "ends"), message, "Move one of its ends.", about=(("nodes", p), ("nodes", q)))
        return False
    return good


def _matter(model: ModelData, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    """An elastic beam needs a section and a material, in space with a torsion constant."""
    lacks = []
    for field, table in (("section", model.sections), ("material", model.materials)):
        chosen = getattr(beam, field) if getattr(beam, field) is not None else getattr(model, field)
        if chosen is None:
            lacks.append(field)
        elif isinstance(chosen, str) and chosen not in table:
            if getattr(beam, field) is not None:
                yield unknown(field, chosen, table, (*path, field))
            return
    about = tuple((*place, field) for place in (path, ()) for field in ("section", "material"))
    if beam.kind == "elastic" and lacks:
        yield Fault(path, f"is elastic but has no {' and no '.join(lacks)}.", "Give both, or kind: rigid.", about=about)
    elif beam.kind == "elastic" and dim == 3 and model.section_of(beam).torsion_constant is None:
        message = "has a section without a torsion constant."
        yield Fault((*path, "section"), message, "Give the section J, m^4.", about=(*about, ("nodes",)))


def _lets_go(beam: Beam) -> bool:
    """Whether an elastic beam can spin about its own axis at both ends."""
    free = {*beam.release, *(end for end, about in beam.hinges.items() if about == 1)}
    return beam.kind == "elastic" and set(beam.ends) <= free


def _release(beam: Beam, path: Path, *, loose: bool) -> Iterator[Fault]:
    """Ends that are none, and in space a spin that is not held."""
    for k, end in enumerate(beam.release):
        if end not in beam.ends:
            mend = f"Name {beam.ends[0]} or {beam.ends[1]}."
            yield Fault((*path, "release", k), f"{end!r} is no end of the beam.", mend, about=((*path, "ends"),))
    if loose and _lets_go(beam):
        mend = "Make it an elastic bar, or release one end only."
        place = (*path, "release" if beam.release else "hinges")
        message = "leaves the beam free to spin about its own axis, and something drives or loads this."
        yield Fault(place, message, mend, about=(("nodes",),))


def _hinges(model: ModelData, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    """A hinge is at an end, in space, about a direction, against something that has a rotation."""
    for end, about in beam.hinges.items():
        place = (*path, "hinges", end)
        if end not in beam.ends:
            mend = f"Name {beam.ends[0]} or {beam.ends[1]}."
            yield Fault(place, f"{end!r} is no end of the beam.", mend, about=((*path, "ends"),))
        elif dim == 2:
            yield Fault(place, "is given in a planar model.", f"A pin in the plane: release: [{end}].", about=(("nodes",),))
        elif end in beam.release:
            message = f"{end!r} is released about all axes too."
            yield Fault(place, message, "Name it in one of both.", about=((*path, "release"),))
        elif not isinstance(about, int) and len(about) != dim:
            yield from components(about, dim, place)
        elif not isinstance(about, int) and not any(about):
            yield Fault(place, "is the zero vector.", "Give a direction, or 1, 2, 3 for an axis of the beam.")
        elif end in model.nodes and end not in frames(model):
            mend = "Clamp the node, or let another beam share its rotation; a ball joint is release."
            yield Fault(place, f"{end!r} has no rotation that the hinge could hold.", mend, about=(("beams",), ("clamped",)))


def _rotation(model: ModelData, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    """The rotation is a scalar node, of a rigid beam in the plane whose ends no other beam and no clamp holds."""
    if beam.rotation is None:
        return
    place = (*path, "rotation")
    if beam.kind != "rigid":
        yield Fault(place, "is given for an elastic beam, whose ends turn differently.", "Leave it out, or kind: rigid.")
    elif dim == 3:
        mend = "Leave it out: frames carry rotations in space."
        yield Fault(place, "is one angle, but the beam turns in space.", mend, about=(("nodes",),))
    elif beam.rotation not in model.nodes:
        yield unknown("node", beam.rotation, model.nodes, place)
    elif not model.nodes[beam.rotation].scalar:
        mend = f"Make it one: {beam.rotation}: {{at: [0, 0], scalar: true}}."
        yield Fault(place, f"{beam.rotation!r} is no scalar.", mend, about=(("nodes", beam.rotation),))
    elif held := [end for end in beam.ends if end not in beam.release and end in frames(model)]:
        message = f"shares its rotation at {held[0]!r}, where a frame carries it."
        yield Fault(place, message, f"Release that end (release: [{held[0]}]), or leave rotation out.", about=(("beams",),))


def _orientation(model: ModelData, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    place = (*path, "orientation")
    given: Any = beam.orientation
    if dim == 2:
        yield Fault(place, "is given in a planar model.", "Leave it out: axis 2 lies in the plane.", about=(("nodes",),))
        return
    a, b = (model.nodes[end].at for end in beam.ends)
    if isinstance(given, str):
        if given not in model.nodes:
            yield unknown("node", given, model.nodes, place)
            return
        given = tuple(v - u for u, v in zip(a, model.nodes[given].at, strict=True))
    elif len(given) != dim:
        yield from components(given, dim, place)
        return
    d = [v - u for u, v in zip(a, b, strict=True)]
    cross = (d[1] * given[2] - d[2] * given[1], d[2] * given[0] - d[0] * given[2], d[0] * given[1] - d[1] * given[0])
    if math.hypot(*cross) <= ALONG * math.hypot(*d) * math.hypot(*given):
        yield Fault(place, "points along the beam, so it spans no plane with it.", "Give a direction across the beam.")


def _taken(model: ModelData) -> Iterator[Fault]:
    """Names that frames need."""
    for name, frame in frames(model).items():
        for axis in frame.nodes:
            if axis in model.nodes and not model.nodes[axis].director:
                yield Fault(("nodes", axis), f"has the name of an axis of the frame at {name!r}.", "Give it another name.")


def _clamps(model: ModelData) -> Iterator[Fault]:
    framed = frames(model)
    for node, to in model.clamped.items():
        place = ("clamped", node)
        if node not in model.nodes:
            yield unknown("node", node, model.nodes, place)
        elif node not in framed:
            if not any(node in beam.ends for beam in model.beams.values()):  # released ones are pinned there
                mend = "Join a beam to it, or fix the node."
                yield Fault(place, "is clamped, but no beam has its rotation.", mend, about=(("beams",),))
        elif to != GROUND and to not in model.bodies:
            yield unknown("body", to, [*model.bodies, GROUND], place)
        elif to != GROUND and (model.bodies[to].kind != "rigid" or node not in model.bodies[to].nodes):
            message = f"is clamped to {to!r}, which is not a rigid body with this node."
            yield Fault(place, message, "Add the node to the nodes of a rigid body.", about=(("bodies", to),))
