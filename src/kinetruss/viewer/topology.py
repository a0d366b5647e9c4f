"""The parts of a scene that do not change in time: names, ends, kinds, sizes, supports, drives, parts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.continua_arrays import body_faces, skin_of
from kinetruss.elements.local_axes import orientation
from kinetruss.kernels.sections.peaks import UNKNOWN
from kinetruss.mechanics import compile
from kinetruss.mechanics.beam_forces import beam_curves
from kinetruss.model import Active, Bar, CoordinateDrive, HingeDrive, Model, Pressure, Rectangle, WholeModel, turns
from kinetruss.model.bodies import placed
from kinetruss.model.bracing import CHORD
from kinetruss.model.joints import GROUND
from kinetruss.model.supports import support_words
from kinetruss.strength.beam_verdict import chords_of
from kinetruss.strength.parts import parts_of
from kinetruss.viewer.support_marks import support_marks

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Beam


FRAME = "frame"
"""Kind of the bars of frames of beams, which pictures leave out."""


def shown_kinds(whole: WholeModel) -> list[str]:
    """The kind that pictures show of each member: ``active``, or the kind of the bar; of the chord of a beam ``beam``, or
    ``rigid``; ``frame`` of bars that hold the frames of beams.
    """
    inner, frames, chords = whole.inner, frame_nodes(whole), beams_by_chord(whole)
    found = []
    for name, one in whole.members.items():
        kind: str = "active" if isinstance(one, Active) else one.kind
        if name in chords:
            kind = "beam" if chords[name].kind == "elastic" else "rigid"
        found.append(FRAME if name in inner.bars and not frames.isdisjoint(one.ends) else kind)
    return found


def frame_nodes(whole: WholeModel) -> set[str]:
    """Nodes of the frames of beams, which pictures leave out."""
    return {name for name, owner in whole.inner.nodes.items() if owner.table != "hubs"}


def beams_by_chord(whole: WholeModel) -> dict[str, Beam]:
    """Chord -> its beam."""
    return {f"{name}{CHORD}": beam for name, beam in whole.beams.items()}


def _supports(model: Model, index: dict[str, int], frames: set[str]) -> Iterator[dict[str, Any]]:
    """Supported nodes: the global axes in which they are held, and whether their rotation is; what supports that yield, have a
    gap or are turned hold in words.
    """
    whole = model.whole
    for node in dict.fromkeys([*whole.fixed, *model.supports]):
        if node in frames or node not in index:
            continue
        found = {"node": index[node], "axes": whole.fixed.get(node, ""), "clamped": whole.clamped.get(node) == GROUND}
        if (one := model.supports.get(node)) is not None and any(own.node == node for own in whole.inner.holdings):
            found["words"] = support_words(one)
        yield found


def topology(model: Model) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """Header fields and arrays of a model.

    Arrays: ``ends`` (m, 2) node indices; ``rods`` (m, 6) the `own_rods` of `System`; ``reference`` (m, 3) direction that spans
    the plane 1-3 with the bar, or ``orient`` (m,) a node (-1 none); ``radius`` (m,) m, NaN without section; ``box`` (m, 2) half
    height along axis 2 and half width along axis 3 of rectangles, m, NaN for others; ``part_member`` (parts,); ``part_shape``
    (parts,); ``part_scale`` (parts, 4) nominal stresses of T, M2, M3, V; ``part_allowed`` (parts,) Pa; ``lump`` (n,) kg; with
    membranes or solids ``skin`` (f, 3), nodes of their faces, and ``skin_part`` (f,); with elastic beams ``beam_member`` (k,),
    ``beam_nodes`` (k, v), and coefficients of these nodes that give the places of their axes, ``beam_along`` (k, g, v), and
    local axis 2 there, ``beam_across`` (k, g, v).
    """
    whole, system, parts, skin = model.whole, compile(model), parts_of(model), skin_of(model.whole)
    members, (sections, rectangles) = whole.members, _sections(whole)
    index = {name: i for i, name in enumerate(whole.nodes)}
    chords, frames = beams_by_chord(whole), frame_nodes(whole)
    inner = len(members) - len(parts.first)
    links = {name: set(chords_of(model, name)) for name in model.links}
    header: dict[str, Any] = {
        "nodes": list(whole.nodes),
        "members": [name.removesuffix(CHORD) if name in chords else name for name in members],
        "kinds": shown_kinds(whole),
        "beams": [k for k, name in enumerate(members) if name in chords],
        "links": [
            {"name": name, "members": [k for k, member in enumerate(members) if member in chords]}
            for name, chords in links.items()
        ],
        "directors": [k for k, name in enumerate(whole.nodes) if name in frames],
        "supports": list(_supports(model, index, frames)),
        "support_marks": [one | {"node": index[one["node"]]} for one in support_marks(model)],
        "drives": [
            _drive(name, drive, index, list(members), [one.ends for one in members.values()], links)
            for name, drive in model.all_drives.items()
        ],
        "parts": [*parts.names, *list(members)[len(parts.first) :]],
        "bodies": [_body(k, one) for k, one in enumerate(members.values()) if isinstance(one, Bar) and one.body is not None]
        + list(_flat_bodies(whole)),
        "solids": body_faces(whole, system.x0[:, : model.dim]),
        "skins": [{"name": name, "kind": kind} for name, kind in zip(skin.names, skin.kinds, strict=True)],
        "triangles": _triangles(whole, index),
        "pressures": _pressures(model),
        "two_rods": [k for k, two in enumerate(system.two_rods) if two],
        "clamped": [{"rod": int(rod), "place": place, "mass": mass} for rod, place, mass in system.clamped.tolist()],
    }
    arrays: dict[str, NDArray[Any]] = {
        "ends": np.column_stack([system.p, system.q]),
        "rods": system.own_rods,
        "reference": orientation(system).reference,
        "orient": orientation(system).node,
        "radius": np.array([max(_fibres(one)) for one in sections]),
        "box": np.array([_fibres(one) for one in rectangles]).reshape(-1, 2),
        # what inner bars are made of is not known
        "part_member": np.append(parts.member, np.arange(len(parts.first), len(members))).astype(np.int32),
        "part_shape": np.append(parts.shape, np.full(inner, UNKNOWN)).astype(np.int32),
        "part_scale": np.concatenate([parts.scale, np.full((inner, 4), np.nan)]),
        "part_allowed": np.append(parts.yield_strength / model.safety.yielding, np.full(inner, np.nan)),
        "lump": system.lump,
    }
    if len(skin.nodes):
        arrays |= {"skin": skin.nodes.astype(np.int32), "skin_part": skin.part.astype(np.int32)}
    if (curves := beam_curves(system)) is not None:
        arrays |= {"beam_member": curves.member.astype(np.int32), "beam_nodes": curves.nodes.astype(np.int32)}
        arrays |= {"beam_along": curves.along, "beam_across": curves.across}
    return header, arrays


def _pressures(model: Model) -> dict[str, float] | None:
    """Number of faces under pressure, and the smallest and largest constant pressure, Pa."""
    found = [load.pressure for load in model.loads.values() if isinstance(load, Pressure) and load.pressure is not None]
    return {"count": len(found), "least": min(found), "largest": max(found)} if found else None


def _drive(
    name: str,
    drive: Any,
    nodes: dict[str, int],
    members: list[str],
    ends: list[tuple[str, str]],
    links: dict[str, set[str]],
) -> dict[str, Any]:
    found: dict[str, Any] = {"name": name, "kind": drive.kind, "unit": "rad" if turns(drive) else "m"}
    if isinstance(drive, HingeDrive):
        found |= {"axis": [nodes[one] for one in drive.axis], "start": nodes[drive.start], "end": nodes[drive.end]}
        # reported with a member that it turns, if one goes from the axis to `end`
        turned = [k for k, pair in enumerate(ends) if drive.end in pair and set(pair) & set(drive.axis)]
        return found | ({"member": turned[0]} if turned else {})
    if isinstance(drive, CoordinateDrive):
        return found | {"node": nodes[drive.node], "axis": drive.axis}
    if getattr(drive, "axis", None) is not None:
        found["about"] = [float(one) for one in drive.axis]
    chords: set[str] = links.get(drive.bar, {drive.bar})
    return found | {"member": next(k for k, one in enumerate(members) if one in chords)}


def _body(member: int, bar: Bar) -> dict[str, Any]:
    """The planar body that a bar represents: its centre (m) along the bar and to its left, and its mass (kg)."""
    assert bar.body is not None  # noqa: S101 - for mypy
    return {"member": member, "center": [float(x) for x in bar.body.center], "mass": float(bar.body.mass)}


def _flat_bodies(model: WholeModel) -> Iterator[dict[str, Any]]:
    """The same for planar bodies defined by two nodes."""
    if not model.bodies or model.dim == 3:
        return
    members = {frozenset(one.ends): k for k, one in enumerate(model.members.values())}
    for body in model.bodies.values():
        member = members.get(frozenset(body.nodes)) if len(body.nodes) == 2 else None
        if member is None:
            continue
        p, q = (np.array(model.nodes[end].at) for end in list(model.members.values())[member].ends)
        origin, axes = placed(body.frame, 2)
        center = (p + q) / 2 if body.center is None else origin + np.array(body.center) @ axes
        u = (q - p) / np.linalg.norm(q - p)
        across = float(np.array([-u[1], u[0]]) @ (center - p))
        yield {"member": member, "center": [float(u @ (center - p)), across], "mass": float(body.mass)}


def _triangles(model: WholeModel, index: dict[str, int]) -> list[list[int]]:
    """Nodes of all triangles of rigid bars, which move as one face."""
    near: dict[int, set[int]] = {}
    frames = frame_nodes(model)
    for bar in model.bars.values():
        if bar.kind == "rigid" and frames.isdisjoint(bar.ends):
            a, b = sorted(index[end] for end in bar.ends)
            near.setdefault(a, set()).add(b)
    return [[a, b, c] for a in sorted(near) for b in sorted(near[a]) for c in sorted(near[a] & near.get(b, set()))]


def _sections(model: WholeModel) -> tuple[list[Any], list[Any]]:
    """The section of each member or None: of an active member that of its tube, of a chord that of its beam; and the
    rectangles whose axes are known: an active member has round rods, a rigid beam in space no axis 2 among the nodes.
    """
    beams = beams_by_chord(model)
    found, flat = [], []
    for name, one in model.members.items():
        section = model.section_of(one.tube if isinstance(one, Active) else beams.get(name, one))
        turned = isinstance(one, Active) or (name in beams and beams[name].kind == "rigid" and model.dim == 3)
        found.append(section)
        flat.append(section if isinstance(section, Rectangle) and not turned else None)
    return found, flat


def _fibres(section: Any) -> tuple[float, float]:
    """Half height along axis 2 and half width along axis 3, m; NaN without a section."""
    return (np.nan, np.nan) if section is None else section.extreme_fibres
