"""What pages see: a drawing as a record; a live model as scenes, poses and the data of its controls."""

from __future__ import annotations

import json
import math
import time
from contextlib import suppress
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from kinetruss.errors import Fault, UnitError
from kinetruss.io.writing import located
from kinetruss.mechanics import compile
from kinetruss.model import MemberLoad, MemberPointForce, NodalForce, OffsetCoordinate, turns
from kinetruss.model.links import length_along
from kinetruss.model.loads_along import fraction
from kinetruss.results.user_parts import clamps
from kinetruss.shelves import shelf, shelves
from kinetruss.strength.curves import quantities_shown
from kinetruss.studio.catalogue import weights
from kinetruss.studio.copies import CELLS
from kinetruss.studio.edits import MEMBERS, SOFT, ends_of, place_of, supports
from kinetruss.studio.judging import LISTED_NODES, loose_ends, on_members
from kinetruss.studio.member_kinds import role_of
from kinetruss.studio.new_parts import forms
from kinetruss.studio.next_steps import clicks
from kinetruss.studio.poses import number
from kinetruss.studio.requested_runs import worst_rows
from kinetruss.units import parse
from kinetruss.viewer import pack, scene
from kinetruss.viewer.support_marks import support_marks

if TYPE_CHECKING:
    import threading
    from collections.abc import Sequence
    from pathlib import Path

    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult
    from kinetruss.studio.drawing import Drawing, State
    from kinetruss.studio.files import Drafts
    from kinetruss.studio.judging import Judged
    from kinetruss.studio.motions import Motions
    from kinetruss.studio.poses import Instant, Reached
    from kinetruss.studio.requested_runs import KeyFrame, Results

Record = dict[str, Any]


class Shown(Protocol):
    """What of a session pages see."""

    file: Path | None
    folder: Path | None
    drafts: Drafts | None
    drawing: Drawing
    original: State
    case: str | None
    frames: Sequence[KeyFrame]
    key: str
    unkept: str
    offered: tuple[str, float] | None
    results: Results
    motions: Motions
    lock: threading.Lock

    @property
    def model(self) -> Model: ...  # noqa: D102

    @property
    def pose(self) -> Reached: ...  # noqa: D102

    @property
    def dirty(self) -> bool: ...  # noqa: D102

    @property
    def lost(self) -> list[str]: ...  # noqa: D102

    def instant(self, fine: bool = True) -> Instant: ...  # noqa: D102

    def limits(self, name: str) -> tuple[float, float, bool]: ...  # noqa: D102

    def closed(self) -> tuple[Model, NDArray[np.float64]]: ...  # noqa: D102


# A live model.


def scene_of(session: Shown, note: str = "") -> bytes:
    """The whole scene, and everything that can be changed."""
    now = session.instant()
    picture = scene(now.forces, model=session.model)
    header = {"kind": "scene", "setup": _setup(session), "state": _pose_record(session, now, note)}
    return framed(header, pack(picture))


def state_of(session: Shown, note: str = "", fine: bool = False) -> bytes:
    """The present pose: drive values in the header, positions and forces as float32 after it."""
    now = session.instant(fine)
    blocks = {name: np.ascontiguousarray(values, "<f4") for name, values in now.arrays.items() if name != "time"}
    table = [[name, values.size] for name, values in blocks.items()]
    header = {"kind": "state", "state": _pose_record(session, now, note), "arrays": table}
    return framed(header, *(values.tobytes() for values in blocks.values()))


def run_of(result: RunResult) -> bytes:
    """A scene of a run of key frames, and its worst instants."""
    note = "" if result.status.ok else f"{result.status.value} {result.message}"
    return framed({"kind": "run", "worst": worst_rows(result), "note": note}, pack(scene(result)))


def numbers(session: Shown) -> Record:
    """All numbers of the present pose in double precision."""
    pose, data = session.pose, session.instant().forces.whole
    names = [name for name in ("member_force", "reaction", "drive_force", "end_force", "joint_force") if name in data]
    return {
        "kind": "numbers",
        "values": pose.values,
        "position": pose.position.tolist(),
        "stopped": pose.stopped,
        "gauge": number(pose.gauge),
        "members": list(session.model.whole.members),
        "nodes": list(session.model.whole.nodes),
        **{name: data[name].values[0].tolist() for name in names},
    }


def framed(header: Record, *blocks: bytes) -> bytes:
    """One binary message: length of the header (uint32), the header in JSON padded to four bytes, then the blocks."""
    text = json.dumps(header, ensure_ascii=False, allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    return b"".join([len(text).to_bytes(4, "little"), text, *blocks])


def _pose_record(session: Shown, now: Instant, note: str) -> Record:
    pose = session.pose
    return {
        "values": pose.values,
        "gauge": number(pose.gauge),
        "stopped": pose.stopped,
        "note": " ".join(filter(None, [note, session.unkept, pose.note, now.forces.message])),
        "demand": now.demand,
        "mobility": now.mobility,
        "alarms": now.alarms,
        "verdict": now.verdict,
    }


def _setup(session: Shown) -> Record:
    """The data for the controls of the page."""
    model, first, drafts = session.model, session.original.model or session.model, session.drafts
    drives = []
    for name, drive in model.all_drives.items():
        low, high, limited = session.limits(name)
        drives.append({"name": name, "unit": "rad" if turns(drive) else "m", "low": low, "high": high, "limited": limited})
    loads = [
        {"name": name, "node": load.node, "force": None if load.force is None else list(load.force)}
        for name, load in model.loads.items()
        if isinstance(load, NodalForce)
    ]
    return {
        "drives": drives,
        "loads": loads,
        "dim": model.dim,
        "gravity": list(model.gravity or (0.0,) * model.dim),
        "masses": {name: node.mass for name, node in model.nodes.items()},
        "nodes": list(model.nodes),
        "members": [{"name": name, "role": role_of(model, name), "own": role_of(first, name)} for name in first.members],
        "cases": list(model.cases),
        "case": session.case,
        "file": "" if session.file is None else session.file.name,
        "writable": session.folder is not None,
        "lost": session.lost,
        "page": session.key if drafts is not None else "",
        "offer": drafts.left[0][1] if drafts is not None and drafts.left else None,
        "frames": [frame.model_dump() for frame in session.frames],
        **_history(session.drawing),
    }


def _history(drawing: Drawing) -> Record:
    """What can be undone and done again, in words."""
    return {
        "undo": drawing.state.words if drawing.past else "",
        "redo": drawing.future[0].words if drawing.future else "",
    }


# A drawing.


def first(session: Shown) -> Record:
    """The record of a drawing page that has just connected."""
    offered = session.offered
    offer = offered and {"when": offered[1], "ago": time.time() - offered[1], "lines": offered[0].count("\n")}
    names = {name: sorted(shelf(name)) for name in shelves()}
    return drawing_of(session) | {
        "choices": names | {"cells": list(CELLS), "forms": forms()},
        "offer": offer,
        "picture": None if session.drafts is None else session.drafts.picture(),
        "running": session.results.running(),
    }


def drawing_of(session: Shown, light: bool = False) -> Record:
    """Everything that a drawing page shows. light : without text and records, and without the whole text of the mobility."""
    drawing = session.drawing
    data, found = drawing.state.data, drawing.found
    places = places_of(drawing)
    members = {name: ends_of(entry) for table in MEMBERS for name, entry in (data.get(table) or {}).items()}
    known = {name: ends for name, ends in members.items() if all(map(places.__contains__, ends))}
    record = {
        "kind": "moved" if light else "drawing",
        "revision": drawing.revision,
        "places": list(places.values()),
        "apart": found.apart,
        "why": found.why,
        "warnings": [{"kind": kind, "text": text} for kind, text in _warnings(found, _floats(data))],
        "missing": _missing(drawing),
        "alarms": found.alarms,
        "used": found.used,
        "mobility": _mobility(found, light),
        "drives": _drives(found),
        **_forces(
            found.forces,
            [name for name, ends in known.items() for _ in ends[1:]],
            clamps(compile(found.model)) if found.model is not None else set(),
        ),
    }
    if light:
        return record
    lines = [(name, list(pair), k > 0) for name, ends in known.items() for k, pair in enumerate(pairwise(ends))]
    text, slides = drawing.state.text, _slides(found)
    return record | {
        "dim": drawing.dim,
        "nodes": list(places),
        "members": [
            {"name": name, "ends": ends, "kind": _kind(drawing, name), **({"goes_on": True} if on else {})}
            for name, ends, on in lines
        ],
        "fixed": supports(data),
        "supports": _supports(found, data, drawing.dim),
        "loads": _loads(found),
        "weights": None if found.model is None or not found.model.nodes else weights(found.model),
        "shows": [
            {"id": name, "label": one.words[0].upper() + one.words[1:]} for name, one in quantities_shown(drawing.dim).items()
        ],
        "data": data,
        "text": text,
        "faults": fault_rows(located(text, found.faults)),
        "valid": found.model is not None,
        "hints": loose_ends(places, known, slides),
        "pins": _pins(data, places, known, slides),
        "file": "" if session.file is None else session.file.name,
        "dirty": session.dirty,
        "clicks": _clicks(drawing),
        "dimensions": [{kind: list(names)} for kind, names in drawing.state.dimensions],
        "writable": session.folder is not None,
        "offered": session.offered is not None,
        **_history(drawing),
    }


def _slides(found: Judged) -> set[str]:
    """Nodes that a coupling keeps on a line: on a bar they are where they belong."""
    couplings = () if found.model is None else found.model.couplings.values()
    return {one.point for coupling in couplings for one, _ in coupling.terms if isinstance(one, OffsetCoordinate)}


def _pins(
    data: dict[str, Any], places: dict[str, list[float]], members: dict[str, list[str]], slides: set[str]
) -> list[dict[str, str]]:
    """What one click may join: nodes that lie on a bar or link, as a pin of it."""
    takes = {*(data.get("bars") or {}), *(data.get("links") or {})}
    found = [one for one in on_members(places, members) if one[1] in takes and one[0] not in slides]
    return [{"node": node, "member": name} for node, name in found[:LISTED_NODES]]


def fault_rows(faults: list[Fault]) -> list[dict[str, Any]]:
    """Faults with their line in the text."""
    return [{"where": one.where, "text": str(one), "line": one.line, "column": one.column} for one in faults]


def _supports(found: Judged, data: dict[str, Any], dim: int) -> list[Record]:
    """The symbols of supports; of a drawing with faults those of fixed nodes."""
    if found.model is not None:
        return support_marks(found.model)
    upright = [float(k == dim - 1) for k in range(3)]
    axes = {name: given if isinstance(given, str) else "xyz"[:dim] for name, given in supports(data).items()}
    kinds = [(name, "pin", upright) if len(own) >= dim else (name, "roller", [float(one in own) for one in "xyz"])
             for name, own in axes.items()]  # fmt: skip
    return [{"node": name, "kind": kind, "along": along} for name, kind, along in kinds]


def _warnings(found: Judged, floats: bool) -> list[tuple[str, str]]:
    """Warnings; where elastic parts hold the drawing in equilibrium, what rigid bars leave free is no mechanism.

    floats : nothing holds the drawing: that is said, and its motions as a whole are no news.
    """
    return [one for one in found.warnings if one[0] != "mechanism" or (found.forces is None and not floats)]


def places_of(drawing: Drawing) -> dict[str, list[float]]:
    """Node -> place, m: the closed pose, or what is drawn if there is none."""
    found = drawing.found
    if found.model is not None and found.position is not None:
        return dict(zip(found.model.nodes, found.position.tolist(), strict=False))
    places = {}
    for name in drawing.state.data.get("nodes") or {}:
        with suppress(UnitError):
            places[name] = [float(parse(value, "length")) for value in place_of(drawing.state.data, name)]
    return places


def _kind(drawing: Drawing, name: str) -> str:
    model = drawing.found.model
    if name in (drawing.state.data.get("beams") or {}):
        return "beam"
    if name in (drawing.state.data.get("links") or {}):
        return "rigid"
    if model is not None:
        return role_of(model, name)
    return "driven" if name in (drawing.state.data.get("active") or {}) else "rigid"


def _loads(found: Judged) -> list[Record]:
    """Constant forces: on a node, N; at a share `at` of a member, N; along a member between two shares of it (`span`), N/m, by
    its `shape` there. turns : the components are along the axes of the member.
    """
    model, rows = found.model, list[Record]()
    for name, load in ({} if model is None else model.loads).items():
        if isinstance(load, NodalForce) and load.force is not None:
            rows.append({"name": name, "node": load.node, "force": list(load.force)})
        elif model is not None and isinstance(load, MemberLoad | MemberPointForce) and load.force is not None:
            row: Record = {"name": name, "member": load.member, "force": list(load.force), "turns": load.axes == "member"}
            length = _length(model, load.member)
            if isinstance(load, MemberPointForce):
                row["at"] = fraction(load.at, length)
            else:
                first, last = (fraction(one, length) for one in (load.start or 0.0, "100 %" if load.end is None else load.end))
                row |= {"span": [first, last], "shape": list(load.shape)}
            rows.append(row)
    return rows


def _length(model: Model, member: str) -> float:
    """Of a member as drawn, m: of a link from pin to pin."""
    own = model.links.get(member) or model.beams.get(member)
    if own is not None:
        return length_along(model, own)
    a, b = model.members[member].ends
    return math.dist(model.nodes[a].at, model.nodes[b].at)


def _drives(found: Judged) -> list[dict[str, Any]]:
    if found.model is None:
        return []
    held = {}
    if found.forces is not None and found.drives:
        arrays = found.forces.arrays
        names = [str(name) for name in arrays["drive"].values]
        held = dict(zip(names, map(number, arrays["drive_force"].values[0]), strict=True))
    records = found.model.all_drives
    return [
        {"name": name, "unit": "rad" if turns(records[name]) else "m", "value": value, "force": held.get(name),
         "bar": getattr(records[name], "bar", None), "node": getattr(records[name], "node", None),
         "axis": getattr(records[name], "axis", None)}
        for name, value in found.drives.items()
    ]  # fmt: skip


def _forces(forces: Forces | None, members: list[str], moments: set[str]) -> dict[str, Any]:
    """Axial forces (N) in the order of the members shown, NaN as null; reactions (N) and moments of clamps (N m) by node.

    moments : supports that have a moment.
    """
    if forces is None:
        return {"force": None, "reaction": {}, "reaction_moment": {}, "unsure": []}
    arrays = forces.arrays
    values = dict(zip(arrays["member"].values.tolist(), map(number, arrays["member_force"].values[0].tolist()), strict=True))
    on: dict[str, dict[str, Any]] = {"reaction": {}, "reaction_moment": {}}
    for what, own in on.items():
        if what in arrays:
            rows = zip(map(str, arrays["support"].values), arrays[what].values[0].tolist(), strict=True)
            own |= {name: [number(one) for one in row] for name, row in rows if what == "reaction" or name in moments}
    return {
        "force": [values.get(name) for name in members],
        **on,
        "unsure": list(forces.attrs.get("not_unique", ())),
    }


def _mobility(found: Judged, light: bool) -> dict[str, Any] | None:
    one = found.mobility
    if one is None:
        return None
    counts = {"freedoms": one.degrees_of_freedom, "undriven": one.undriven, "self_stress": one.self_stress}
    return counts if light else counts | {"text": str(one)}


def _clicks(drawing: Drawing) -> list[Record]:
    """What one click may add in space; of what elastic parts hold nothing. In the plane the page knows it."""
    found = drawing.found
    if drawing.dim != 3 or found.model is None or found.mobility is None or found.forces is not None:
        return []
    return clicks(drawing.state.data, found.model, found.mobility)


def _floats(data: dict[str, Any]) -> bool:
    """Whether nothing holds the drawing."""
    return not any(data.get(table) for table in ("fixed", "clamped", "supports"))


def _missing(drawing: Drawing) -> list[str]:
    """What the drawing still needs before it can carry anything."""
    data, found = drawing.state.data, drawing.found
    words = []
    if not data.get("nodes"):
        return ["Drag from point to point with Bar, or click with Node. The mouse wheel sets the scale."]
    if not any(data.get(table) for table in (*MEMBERS, "membranes", "solids")):
        words.append("No bar yet: drag from node to node.")
    if _floats(data):
        words.append("No support yet: pick a node and choose what holds it.")
    model = found.model
    yields = model is not None and (
        bool(model.force_elements or model.cylinders) or any(bar.kind in SOFT for bar in model.bars.values())
    )
    if model is not None and model.members and not model.loads and not yields:  # springs pull by themselves
        heavy = any(node.mass for node in model.nodes.values()) or bool(model.bodies) or any(
            getattr(bar, "mass", None) or (model.section_of(bar) is not None and model.material_of(bar) is not None)
            for bar in model.bars.values()
        ) or bool(model.active)  # fmt: skip
        if not heavy or not any(model.gravity or ()):
            words.append("No load yet: all forces are zero. Add a load, or gravity with masses or a section and a material.")
    return words
