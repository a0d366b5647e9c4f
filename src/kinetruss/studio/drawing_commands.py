"""The commands of the drawing page: small records that are checked before anything is done."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter

from kinetruss.studio.messages import Message, read_message

MOST = 4_000_000
"""Largest size of a message of the drawing page, bytes; the text of a model of 20,000 bars has about a million."""

Finite = Annotated[float, Field(allow_inf_nan=False, ge=-1e9, le=1e9)]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Typed = Finite | Annotated[str, Field(max_length=100)]
Place = Annotated[list[Typed], Field(min_length=2, max_length=3)]
Names = Annotated[list[Name], Field(max_length=100_000)]


class Fresh(Message):
    """An empty drawing of 2 or 3 dimensions."""

    do: Literal["fresh"]
    dim: Literal[2, 3]


class Add(Message):
    """A node at a place, m or text with units. `bar_from`: also a bar from that node."""

    do: Literal["add"]
    at: Place
    name: Name | None = None
    bar_from: Name | None = None


class Bar(Message):
    """A bar between two nodes."""

    do: Literal["bar"]
    ends: Annotated[list[Name], Field(min_length=2, max_length=2)]
    name: Name | None = None


class Move(Message):
    """Nodes to new places. `drag`: moves with the same number are one step of undo."""

    do: Literal["move"]
    places: Annotated[dict[Name, Place], Field(max_length=100_000)]
    drag: int | None = None


class Set(Message):
    """Set the value at a path of the data, e.g. bars, b1, length; null removes it. `typed`: texts in it are YAML."""

    do: Literal["set"]
    path: Annotated[list[Name], Field(min_length=1, max_length=12)]
    value: Any = None
    typed: bool = False


class Make(Message):
    """A new entry from what is picked, whole, to be changed."""

    do: Literal["make"]
    what: Literal["active", "beam", "bar", "angle_spring", "body", "run"]
    nodes: Names = []
    members: Names = []


class Run(Message):
    """Begin a run of the model; the page of its result is at ``result/`` and the number in the answer."""

    do: Literal["run"]
    name: Name


class Running(Message):
    """How far the run is, or its result."""

    do: Literal["running"]


class Stop(Message):
    """Give up the run that is computed."""

    do: Literal["stop"]


class Rename(Message):
    """Another name for an entry of a table; what refers to it follows."""

    do: Literal["rename"]
    table: Name
    old: Name
    new: Name


class Delete(Message):
    """Remove nodes and members, and what depends on them."""

    do: Literal["delete"]
    nodes: Names = []
    members: Names = []


class Copy(Message):
    """Copies of nodes and of the members among them, each shifted by a vector from the last, m."""

    do: Literal["copy"]
    nodes: Names
    by: Place
    count: Annotated[int, Field(ge=1, le=200)] = 1


class Mirror(Message):
    """Mirrored copies of nodes and of the members among them; nodes in the plane are shared."""

    do: Literal["mirror"]
    nodes: Names
    axis: Literal["x", "y", "z"]
    at: Typed = 0.0


class Stack(Message):
    """A stack of cells of the library, e.g. three octahedra, added to the drawing."""

    do: Literal["stack"]
    cell: Name
    count: Annotated[int, Field(ge=1, le=200)] = 1
    arguments: dict[Name, Any] = {}


class Text(Message):
    """The drawing of a model text. `drag`: texts with the same number are one step of undo."""

    do: Literal["text"]
    text: Annotated[str, Field(max_length=MOST)]
    drag: int | None = None


class Undo(Message):
    """Back by one step."""

    do: Literal["undo"]


class Redo(Message):
    """Forward again by one step."""

    do: Literal["redo"]


class Show(Message):
    """The drawing as it is, everything computed."""

    do: Literal["show"]


class Curve(Message):
    """The path of a node and the force of a drive along the range of that drive, m or rad."""

    do: Literal["curve"]
    node: Name
    drive: Name
    low: Finite | None = None
    high: Finite | None = None


class Draft(Message):
    """Take up the autosaved drawing of an earlier studio, or remove it."""

    do: Literal["draft"]
    keep: bool


class Versions(Message):
    """The list of saved states."""

    do: Literal["versions"]


class Restore(Message):
    """Back to a saved state of the list; it can be undone."""

    do: Literal["restore"]
    number: Annotated[int, Field(ge=1)]


class Save(Message):
    """Write the file. `replace`: also over another file."""

    do: Literal["save"]
    name: Name
    replace: bool = False


class Picture(Message):
    """Keep the picture to trace beside the file. `place`: as the page has it. `source`: data URL; None: the one kept."""

    do: Literal["picture"]
    place: Annotated[dict[Name, Any], Field(max_length=20)] | None
    source: Annotated[str, Field(max_length=MOST)] | None = None


class Keep(Message):
    """Put the present state into the list of versions."""

    do: Literal["keep"]
    words: Annotated[str, Field(max_length=200)] = ""


Command = Annotated[
    Fresh | Add | Bar | Move | Set | Rename | Delete | Copy | Mirror | Stack | Text | Undo | Redo | Show | Curve | Draft
    | Versions | Restore | Save | Keep | Make | Run | Running | Stop | Picture,
    Field(discriminator="do"),
]  # fmt: skip
_ADAPTER: TypeAdapter[Any] = TypeAdapter(Command)


def command_of(text: str | bytes) -> Any:
    """The command in a message.

    Raises
    ------
    InputError : too long, not JSON, or not a known command.
    """
    return read_message(text, _ADAPTER, MOST)
