"""The messages of pages: each is a function, checked and done here, for the page with sliders and for the drawing."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Annotated, Any, Literal

from pydantic import Field

from kinetruss.errors import InputError, KinetrussError, ModelError
from kinetruss.model import nearest
from kinetruss.studio import asked, beginnings, catalogue, copies, drawing, edits, sweeps
from kinetruss.studio.dimensions import renamed, toggled
from kinetruss.studio.films import fall_of, fallen, film_of, motion_of, over_of, pose_of
from kinetruss.studio.member_kinds import switched
from kinetruss.studio.new_parts import made, with_analysis
from kinetruss.studio.protocol import message, message_of
from kinetruss.studio.requested_runs import Finite, FrameList, Name, Values
from kinetruss.studio.session import LARGE, Answer, Desk
from kinetruss.studio.shown import numbers
from kinetruss.studio.taken import Form

Names = Annotated[tuple[Name, ...], Field(max_length=100_000)]
Vector = Annotated[list[Finite], Field(min_length=2, max_length=3)]
Coordinate = Annotated[float, Field(allow_inf_nan=False, ge=-1e9, le=1e9)]
Typed = Coordinate | Annotated[str, Field(max_length=100)]
Place = Annotated[list[Typed], Field(min_length=2, max_length=3)]
Places = Annotated[dict[Name, Place], Field(max_length=100_000)]
Arguments = dict[Name, Any]
Placed = Annotated[dict[Name, Any], Field(max_length=20)]
Part = Literal["active", "beam", "bar", "link", "angle_spring", "body", "run"]
Positions = Annotated[tuple[Annotated[list[Coordinate], Field(min_length=3, max_length=3)], ...], Field(max_length=5)]
PathPoints = Annotated[tuple[Annotated[list[Coordinate], Field(min_length=2, max_length=2)], ...], Field(max_length=5000)]
Kinds = Annotated[tuple[Literal["four-bar", "slider-crank"], ...], Field(min_length=1, max_length=2)]
Positive = Annotated[Finite, Field(ge=0)]
Ends = Annotated[list[Name], Field(min_length=2, max_length=2)]
Path = Annotated[list[Name], Field(min_length=1, max_length=12)]
Count = Annotated[int, Field(ge=1, le=200)]
Sample = Annotated[int, Field(ge=0)]
Samples = Annotated[int, Field(ge=2, le=2001)]
Number = Annotated[int, Field(ge=1)]
Words = Annotated[str, Field(max_length=200)]
Changes = Annotated[tuple[tuple[Path, Any], ...], Field(min_length=1, max_length=200)]
Long = Annotated[str, Field(max_length=LARGE)]


BESIDE = ("run", "running", "stop", "ask", "take", "sweep", "let_go", "motion")
"""Messages that do not wait for those before them: what takes long is computed beside what else is done."""

DRAWN = ("dimension", "sweep", "let_go", "motion", "put", "over", "sections")
"""Messages that a drawing alone has."""


class Session(Desk):
    """A model on the server: messages in, answers out."""

    def answer(self, text: str | bytes) -> Answer:
        """The answer to one message: bytes (a scene, a state) or a record for JSON; errors are records, and change nothing."""
        try:
            name, act = message_of(text, self.most)
            if name in DRAWN and not self.draw:
                raise InputError("This message is for a drawing.")
            with nullcontext() if name in BESIDE else self.lock:
                return act(self)
        except ModelError as error:
            return {"kind": "error", "message": " ".join(str(fault) for fault in error.faults[:3])}
        except KinetrussError as error:
            return {"kind": "error", "message": str(error)}


# Pose and history.


@message
def move(
    session: Session, values: Values | None = None, places: Places | None = None, fine: bool = False, drag: int | None = None,
    keep: bool = False,
) -> Answer:  # fmt: skip
    """Drives to new values (m, rad) from the last good pose, or nodes to new places (m or text with units).

    fine : also compute slow results (motors and mobility of large models). drag : those with one number are one step of undo.
    keep : of nodes of a drawing: all lengths stay, drives follow, and the nodes come as near as they can.
    """
    if (values is None) == (places is None):
        raise InputError("This message is not understood. Give values of drives, or places of nodes.")
    if values is not None:
        return session.move(values, fine)
    if keep:
        return session.carry(places or {}, drag)
    return session.take(edits.moved(session.data, places or {}), f"moving {_list(places)}", drag=drag)


@message
def show(session: Session) -> Answer:
    """The model as it is, everything computed; the end of a drag."""
    if session.draw:
        session.drawing.rest()
        session.keep()
    return session.shown()


@message
def undo(session: Session) -> Answer:
    """Back by one step."""
    return session.step(-1)


@message
def redo(session: Session) -> Answer:
    """Forward again by one step."""
    return session.step(1)


@message
def reset(session: Session) -> Answer:
    """Back to the model of the file."""
    return session.reset()


@message
def query(session: Session) -> Answer:
    """All numbers of the present pose, in double precision."""
    return numbers(session)


@message
def case(session: Session, name: Name | None = None) -> Answer:
    """The load case shown; None: all loads with factor 1."""
    if name is not None and name not in session.model.cases:
        raise InputError(f"No load case called {name!r}. {nearest(name, session.model.cases)}")
    if session.draw:
        raise InputError("The drawing shows all loads. Use the page with sliders.")
    session.case = name
    session.keep()
    return session.shown()


# Edits of the model.


@message
def switch(session: Session, member: Name, to: Literal["rigid", "driven", "elastic", "cut", "own"]) -> Answer:
    """Make a member rigid, driven, elastic, cut, or as in the file (own)."""
    data, lost = switched(session.drawing.state, session.original, session.pose.position, member, to)
    return session.take(data, f"making {member} {to}", lost=lost)


@message
def gravity(session: Session, value: Vector) -> Answer:
    """Gravity of the model, m/s^2; load cases with their own keep it."""
    most = max(map(abs, value))
    doubt = f"{most:.6g} m/s^2: more than on the Sun. Is it meant so?" if most > 274.0 else ""
    return session.take(edits.with_value(session.data, ["gravity"], value), "the change of gravity", note=doubt)


@message
def load(session: Session, name: Name, node: Name, force: Vector) -> Answer:
    """A constant force (N) on a node; zero removes it."""
    most = max(map(abs, force))
    doubt = f"{most:.6g} N on {node}: the weight of 100,000 t. Is it meant so?" if most > 1e9 else ""
    return session.take(edits.with_load(session.data, name, node, force), f"the change of {name}", note=doubt)


@message
def mass(session: Session, node: Name, mass: Positive) -> Answer:
    """The payload of a node: its lumped mass, kg."""
    doubt = f"{mass:.6g} kg at {node}: more than a large ship has. Is it meant so?" if mass > 1e7 else ""
    data = edits.with_mass(session.data, session.model, node, mass)
    return session.take(data, f"the change of the mass of {node}", note=doubt)


@message
def fresh(session: Session, dim: Literal[2, 3]) -> Answer:
    """An empty drawing of 2 or 3 dimensions."""
    session.drawing.own_dim = dim
    return session.take(drawing.fresh(dim), "the empty drawing", anew=True)


@message
def add(session: Session, at: Place, name: Name | None = None, bar_from: Name | None = None) -> Answer:
    """A node at a place, m or text with units. bar_from : also a bar from that node."""
    data, name = edits.added_node(session.data, name, at)
    picked = {"node": name}
    if bar_from is not None:
        data, picked["member"] = edits.added_bar(data, None, (bar_from, name))
    return session.take(data, f"adding {name}", picked)


@message
def bar(session: Session, ends: Ends, name: Name | None = None) -> Answer:
    """A bar between two nodes."""
    data, name = edits.added_bar(session.data, name, ends)
    return session.take(data, f"adding {name}", {"member": name})


@message
def pin(session: Session, member: Name, node: Name) -> Answer:
    """A node that lies on a bar or link becomes a pin of it; the bar becomes a link."""
    data, name = edits.pinned(session.data, member, node)
    return session.take(data, f"pinning {node} to {member}", {"member": name})


@message
def set_(session: Session, path: Path, value: Any = None, typed: bool = False) -> Answer:
    """Set the value at a path of the data, e.g. bars, b1, length; null removes it. typed : texts in it are YAML."""
    new = edits.typed(session.data, value) if typed else value
    if path[0] == "runs" and len(path) == 3 and path[2] == "analysis" and new:
        data = with_analysis(session.data, path[1], str(new))
    else:
        data = edits.with_value(session.data, path, new)
    return session.take(data, f"setting {'.'.join(path)}")


@message
def change(session: Session, changes: Changes, words: Words) -> Answer:
    """Set values at several paths of the data in one step: what a tool of the page draws. words : what the step is called."""
    data = session.data
    for path, value in changes:
        data = edits.with_value(data, path, value)
    return session.take(data, words)


@message
def make(
    session: Session,
    what: Part,
    nodes: Names = (),
    members: Names = (),
    axis: Literal["x", "y", "z"] = "z",
) -> Answer:
    """A new entry from what is picked, whole, to be changed. axis : in space, about which the angle of one member counts."""
    data, table, name = made(session.data, what, nodes, members, session.drives(), axis)
    picked = {"entry": [table, name]} | ({"member": name} if table in edits.MEMBERS else {})
    return session.take(data, f"making {name}", picked)


@message
def rename(session: Session, table: Name, old: Name, new: Name) -> Answer:
    """Another name for an entry of a table; what refers to it follows."""
    data = edits.renamed(session.data, table, old, new)
    measured = renamed(session.drawing.state.dimensions, table, old, new)
    return session.take(data, f"renaming {old}", {"renamed": [old, new]}, dimensions=measured)


@message
def delete(session: Session, nodes: Names = (), members: Names = ()) -> Answer:
    """Remove nodes and members, and what depends on them."""
    data, gone = edits.deleted(session.data, nodes, members)
    return session.take(data, f"deleting {_list([*nodes, *members])}", {"lost": gone})


@message
def dimension(session: Session, nodes: Names = (), members: Names = ()) -> Answer:
    """A distance of two nodes, a length of a member or the angle of two, to be shown; the same again removes it."""
    session.drawing.measure(toggled(session.drawing.state.dimensions, session.data, nodes, members))
    session.keep()
    return session.shown()


@message
def copy(session: Session, nodes: Names, by: Place, count: Count = 1) -> Answer:
    """Copies of nodes and of the members among them, each shifted by a vector from the last, m."""
    return session.take(copies.copied(session.data, nodes, by, count), "copying")


@message
def mirror(session: Session, nodes: Names, axis: Literal["x", "y", "z"], at: Typed = 0.0) -> Answer:
    """Mirrored copies of nodes and of the members among them; nodes in the plane are shared."""
    return session.take(copies.mirrored(session.data, nodes, axis, at), "mirroring")


@message
def stack(session: Session, cell: Name, count: Count = 1, arguments: Arguments | None = None) -> Answer:
    """A stack of cells of the library, e.g. three octahedra, added to the drawing."""
    return session.take(copies.stacked(session.data, cell, count, arguments or {}), f"stacking {cell}")


@message
def text(session: Session, text: Long, drag: int | None = None) -> Answer:
    """The model of a text. drag : texts with the same number are one step of undo."""
    return session.write(text, "the text", drag)


# Runs.


@message
def run(session: Session, name: Name | None = None, frames: FrameList | None = None, samples: Samples = 201) -> Answer:
    """Do a run of the model, or follow key frames, and find the worst instants.

    name : of a run, computed beside the messages; the page of its result is at ``result/`` and the number in the answer.
    """
    if (name is None) == (frames is None):
        raise InputError("This message is not understood. Give the name of a run, or key frames.")
    if frames is not None:
        return session.follow(frames, samples)
    with session.lock:
        model, revision = session.model, session.drawing.revision
    return session.results.start(model, name or "", revision)


@message
def running(session: Session) -> Answer:
    """How far the run is, or its result."""
    return session.results.running() or {"kind": "stopped"}


@message
def stop(session: Session) -> Answer:
    """Give up the run that is computed."""
    return session.results.stop()


@message
def curve(session: Session, node: Name, drive: Name, low: Coordinate | None = None, high: Coordinate | None = None) -> Answer:
    """The path of a node and the force of a drive along the range of that drive, m or rad."""
    return {"kind": "curve"} | sweeps.curve(*session.closed(), node, drive, low, high)


@message
def sweep(session: Session, drives: Names, rate: Typed | None = None, at_speed: bool = False, strength: bool = False) -> Answer:
    """Drives through their range, to be played: positions, forces and reactions of every sample; or a number for `motion`.

    rate : of the first, rad/s or m/s or text with a unit. at_speed : with inertia at this rate; else every pose at rest.
    strength : also how much of what is allowed every member uses.
    """
    return film_of(session, drives, rate, at_speed, strength)


@message
def let_go(session: Session, held: bool = True, strength: bool = False) -> Answer:
    """The motion of what nothing holds once it is let go, to be played: as `sweep`, with energies.

    held : the drives stay where they are; else they are free. strength : as of `sweep`.
    """
    return fall_of(session, held, strength)


@message
def motion(session: Session, number: Number) -> Answer:
    """What was asked for by `sweep` or `let_go`, once it is computed. number : of their answer."""
    return motion_of(session, number)


@message
def put(session: Session, values: Values | None = None, sample: Sample | None = None) -> Answer:
    """A drawing in the pose of other drive values, m or rad, reached continuously from the one that is drawn.

    sample : instead, of the last motion, if it was let go.
    """
    if (values is None) == (sample is None):
        raise InputError("This message is not understood. Give values of drives, or a sample of what was let go.")
    return session.put(values) if values is not None else session.take(fallen(session, sample or 0), "the pose that was let go")


@message
def over(session: Session, show: Name, sample: Sample | None = None) -> Answer:
    """Section forces or the deflection over the drawing, or over a sample of the motion that was played last."""
    return over_of(session, show, sample)


# Linkages, drawings to begin with, files to take away.


@message
def ask(
    session: Session, positions: Positions = (), path: PathPoints = (), kinds: Kinds = ("four-bar", "slider-crank"),
    closed: bool = False, point: Positive = 0.0,
) -> Answer:  # fmt: skip
    """Linkages through positions (x, y, angle; m and rad), or along a path (x, y), best first, and what cannot be reached.

    point : distance of the second point of a position along its angle, m.
    """
    found = asked.asked(positions, path, kinds, closed=closed, point=point)
    with session.lock:
        session.asked = found.found
    return {"kind": "linkages", "rows": asked.rows(found), "message": found.message}


@message
def choose(session: Session, number: Annotated[int, Field(ge=0, le=1000)]) -> Answer:
    """One of the linkages that were found, into the drawing, in place of the one put there just before."""
    if number >= len(session.asked):
        raise InputError("This linkage is not known any more. Ask again.")
    if session.drawing.state.words.startswith(asked.ADDING) and session.drawing.past:
        session.drawing.step(-1)
    data, crank = asked.with_linkage(session.data, session.asked[number])
    return session.take(data, f"{asked.ADDING} {session.asked[number].kind}", {"member": crank})


@message
def starters(session: Session) -> Answer:
    """Drawings to begin with, and their small pictures."""
    return {"kind": "starters", "rows": list(beginnings.pictures()), "empty": not session.data.get("nodes")}


@message
def sections(session: Session) -> Answer:  # noqa: ARG001  every message gets one
    """Sections to choose from, with their numbers; and densities of the materials of the library, kg/m^3."""
    return {"kind": "sections", "rows": list(catalogue.sections()), "densities": catalogue.densities()}


@message
def begin(session: Session, name: Name) -> Answer:
    """A copy of a drawing to begin with, in place of the drawing; it can be undone."""
    return session.write(beginnings.starter(name)[1], f"beginning from {name}", anew=True)


@message
def take(session: Session, form: Form, run: Words = "", sample: Sample | None = None) -> Answer:
    """Make a file of the drawing; it is at ``result/`` and the number in the answer.

    run : whose motion and result it has. sample : of the motion that was played last, whose pose a picture shows.
    """
    with session.lock:
        model, data, text, revision = session.model, session.data, session.drawing.state.text, session.drawing.revision
        pose = None if sample is None else pose_of(session, sample)
    name = model.title or ("drawing" if session.file is None else session.file.stem)
    return session.results.make(form, model, data, text, name, run, revision, pose)


# What is kept.


@message
def frames(session: Session, frames: FrameList) -> Answer:
    """The key frames of the page, to be kept."""
    if session.draw:
        raise InputError("The drawing has no key frames. Use the page with sliders.")
    session.frames = frames
    session.keep()
    return {"kind": "kept"}


@message
def draft(session: Session, keep: bool) -> Answer:
    """Go on with what an earlier studio has left, or remove it."""
    return session.draft(keep)


@message
def versions(session: Session) -> Answer:
    """The list of saved states."""
    rows = session.drafts.versions() if session.drafts is not None else []
    return {"kind": "versions", "rows": [{k: row.get(k) for k in ("number", "when", "words")} for row in rows]}


@message
def keep(session: Session, words: Words = "") -> Answer:
    """Put the present state into the list of versions."""
    session.kept_in().add(session.drawing.state.text, words or "kept")
    return versions(session)


@message
def restore(session: Session, number: Number) -> Answer:
    """Back to a saved state of the list; it can be undone."""
    return session.restore(session.kept_in().version(number), f"version {number}")


@message
def picture(session: Session, place: Placed | None, source: Long | None = None) -> Answer:
    """Keep the picture to trace beside the file. place : as the page has it. source : data URL; None: the one kept."""
    if session.drafts is not None:
        session.drafts.keep_picture(place, source, session.file)
    return {"kind": "picture", "kept": session.drafts is not None}


@message
def save(session: Session, name: Name, pose: bool = False, replace: bool = False, frames: FrameList = ()) -> Answer:
    """Save the model in the folder. pose : with the present pose as its own. replace : also replace another file."""
    return session.save(name, pose=pose, replace=replace, frames=frames)


def _list(names: Any) -> str:
    shown = list(names)
    return ", ".join(shown[:3]) + (f" and {len(shown) - 3} more" if len(shown) > 3 else "")
