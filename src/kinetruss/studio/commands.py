"""The commands of a page: small records that are checked before anything is done."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter

from kinetruss.studio.messages import Message, read_message

MOST = 262_144
"""Largest size of a message from a page, bytes."""

Finite = Annotated[float, Field(allow_inf_nan=False, ge=-1e15, le=1e15)]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Values = Annotated[dict[Name, Finite], Field(max_length=10_000)]
Vector = Annotated[list[Finite], Field(min_length=2, max_length=3)]


class Move(Message):
    """Move drives to new values, m or rad. `fine`: also compute slow results (motors and mobility of large models)."""

    do: Literal["move"]
    values: Values
    fine: bool = False


class Switch(Message):
    """Make a member rigid, driven, elastic, cut, or as in the file (own)."""

    do: Literal["switch"]
    member: Name
    to: Literal["rigid", "driven", "elastic", "cut", "own"]


class Gravity(Message):
    """Gravity of the model, m/s^2."""

    do: Literal["gravity"]
    value: Vector


class Load(Message):
    """A constant force (N) on a node; zero removes it."""

    do: Literal["load"]
    name: Name
    node: Name
    force: Vector


class Mass(Message):
    """The payload of a node: its lumped mass, kg."""

    do: Literal["mass"]
    node: Name
    mass: Annotated[Finite, Field(ge=0)]


class Case(Message):
    """The load case shown; None: all loads with factor 1."""

    do: Literal["case"]
    name: Name | None = None


class KeyFrame(Message):
    """Drive values at a time, s."""

    time: Annotated[Finite, Field(ge=0, le=1e6)]
    values: Values


FrameList = Annotated[list[KeyFrame], Field(max_length=500)]


class Frames(Message):
    """The key frames of the page, to be kept."""

    do: Literal["frames"]
    frames: FrameList


class Draft(Message):
    """Go on with the changes that a page of an earlier studio has left, or remove them."""

    do: Literal["draft"]
    keep: bool


class Run(Message):
    """Follow the key frames, and find the worst instants."""

    do: Literal["run"]
    frames: FrameList
    samples: Annotated[int, Field(ge=2, le=2001)] = 201


class Live(Message):
    """Return from a run to the live model."""

    do: Literal["live"]


class Reset(Message):
    """Reset the model to the file."""

    do: Literal["reset"]


class Query(Message):
    """All numbers of the present pose, in double precision."""

    do: Literal["query"]


class Save(Message):
    """Save the model in the folder. `pose`: with the present pose as its own. `replace`: also replace another file."""

    do: Literal["save"]
    name: Name
    pose: bool = False
    replace: bool = False
    frames: FrameList = []


Command = Annotated[
    Move | Switch | Gravity | Load | Mass | Case | Frames | Draft | Run | Live | Reset | Query | Save, Field(discriminator="do")
]
_ADAPTER: TypeAdapter[Any] = TypeAdapter(Command)
_FRAMES: TypeAdapter[list[KeyFrame]] = TypeAdapter(FrameList)


def doubt(command: Any) -> str:
    """A question about a value that is allowed but unlikely; empty if there is none."""
    match command:
        case Mass() if command.mass > 1e7:
            return f"{command.mass:.6g} kg at {command.node}: more than a large ship has. Is it meant so?"
        case Gravity() if max(map(abs, command.value)) > 274.0:
            return f"{max(map(abs, command.value)):.6g} m/s^2: more than on the Sun. Is it meant so?"
        case Load() if max(map(abs, command.force)) > 1e9:
            return f"{max(map(abs, command.force)):.6g} N on {command.node}: the weight of 100,000 t. Is it meant so?"
    return ""


def command_of(text: str | bytes) -> Any:
    """The command in a message.

    Raises
    ------
    InputError : too long, not JSON, or not a known command.
    """
    return read_message(text, _ADAPTER, MOST)


def frames_of(rows: Any) -> list[KeyFrame]:
    """Key frames from plain data.

    Raises
    ------
    ValueError : they are none.
    """
    return _FRAMES.validate_python(rows)
