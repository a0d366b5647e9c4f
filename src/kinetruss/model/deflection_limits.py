"""Limits of deflections that a model gives, as engineers state them: span/300 of a girder, 20 mm of a tip."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Field, GetCoreSchemaHandler, PlainValidator, WithJsonSchema
from pydantic_core import core_schema

from kinetruss.errors import Fault, shown
from kinetruss.model.links import Piece
from kinetruss.model.record import Name, Record, positive
from kinetruss.model.references import LoadCaseNames, Ref
from kinetruss.units import NUMBER, parse

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData

STRAIGHT = 1e-6
"""How much longer than the distance of its ends a row of members may be, as a fraction."""
_SHARE = re.compile(rf"span\s*/\s*({NUMBER.pattern})")


def _limit(value: Any) -> str | float:
    if not isinstance(value, str) or not value.strip().startswith("span"):
        return positive(parse(value, "length"))
    found = _SHARE.fullmatch(value.strip())
    if found is None:
        raise ValueError(f"{shown(value)} is no share of the span. Write for example span/300, or a length.")
    if not 0 < float(found[1]) < math.inf:
        raise ValueError(f"{shown(value)} is no limit: {found[1]} must be greater than 0. Write for example span/300.")
    return f"span/{found[1]}"


class _OneOrSeveral:
    """Annotation of a list of names: one may stand alone."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(
            lambda value: (value,) if isinstance(value, str) else value, handler(source)
        )

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        several = handler(schema)
        return {"anyOf": [several["items"], several]}


def _spans(model: Any) -> Iterator[str]:
    """Members that may be a span: not the inner bars and beams that represent beams and links."""
    inner = getattr(model, "inner", None)
    yield from (name for name in model.members if inner is None or name not in inner.bars)
    yield from (name for name, beam in model.beams.items() if not isinstance(beam, Piece))
    yield from model.links


_SCHEMA = {
    "anyOf": [{"type": "number", "exclusiveMinimum": 0}, {"type": "string"}],
    "description": "length: a number in m, or text with a unit; or a share of the span: span/300",
    "x-unit": "m",
}
SpanOrLength = Annotated[str | float, PlainValidator(_limit), WithJsonSchema(_SCHEMA)]
SpanMember = Annotated[Name, Ref("member", "bars", "active", "beams", "links", known=_spans)]
SpanMembers = Annotated[tuple[SpanMember, ...], Field(min_length=1), _OneOrSeveral()]


class DeflectionLimit(Record):
    """The largest deflection allowed of a span, which the verdict of `statics.linear` and `statics.equilibrium` checks.

    members : name of the member that is the span, or names of several that follow each other on one straight line, as of a
        girder divided into beams or of the chord of a truss.
    limit : ``span/300``, where the span is the distance of the two ends of the row in the model, or a length.
    measured_from : ``ends``: the deflection from the straight line between the displaced ends of the row, its sag. ``start``:
        the displacement from the place without loads, as of a cantilever, which with ``ends`` would have only its curvature
        counted. Its span is its own length: ``span/150`` from the clamped end to the tip.
    load_cases : names of the load cases and combinations in which the limit applies, as those of serviceability; the name of a
        standard means all of its combinations. By default all that a run computes.

    Counted is what is across the row, in any direction; stretching along it is not. Elastic beams and links count with their
    bent axis, bars and active members by the displacements of their nodes, between which they stay straight.

    >>> import kinetruss as kt
    >>> kt.DeflectionLimit(members="rafter", limit="span/300", load_cases=("sls",)).limit_of(6.0)
    0.02
    """

    _positional: ClassVar = ("members", "limit")
    members: SpanMembers
    limit: SpanOrLength
    measured_from: Literal["ends", "start"] = "ends"
    load_cases: Annotated[tuple[LoadCaseNames, ...], Field(min_length=1)] | None = None

    def limit_of(self, span: float) -> float:
        """The limit of a span (m), m."""
        return span / float(self.limit.removeprefix("span/")) if isinstance(self.limit, str) else self.limit

    if TYPE_CHECKING:

        def __init__(
            self, members: Any, limit: str | float, *, measured_from: Literal["ends", "start"] = "ends", load_cases: Any = None
        ) -> None: ...


def nodes_of(model: ModelData, name: str) -> tuple[str, ...]:
    """The nodes of a member in its order: its two ends, of a link all its pins."""
    if name in model.links:
        return model.links[name].nodes
    return model.beams[name].ends if name in model.beams else model.members[name].ends


def row_of(model: ModelData, members: tuple[str, ...]) -> list[tuple[str, bool]] | None:
    """The members in their order, each with whether it runs backwards; None if one does not begin where that before it ends.

    A single member runs forwards, and the first of several so that it ends at the second.
    """
    ends = [(own[0], own[-1]) for own in (nodes_of(model, name) for name in members)]
    at = ends[0][1] if len(ends) == 1 or ends[0][1] in ends[1] else ends[0][0]
    found = [(members[0], at != ends[0][1])]
    for name, (a, b) in zip(members[1:], ends[1:], strict=True):
        if at not in (a, b):
            return None
        found.append((name, at == b))
        at = a if at == b else b
    return found


def row_nodes(model: ModelData, row: list[tuple[str, bool]]) -> list[str]:
    """The nodes of a row, each once, from its first to its last end."""
    found = list[str]()
    for name, backwards in row:
        nodes = nodes_of(model, name)
        found += [node for node in (nodes[::-1] if backwards else nodes) if not found or node != found[-1]]
    return found


def deflection_faults(model: ModelData) -> Iterator[Fault]:
    """Faults of limits of deflections: members that are not one after the other on a straight line, a bar alone."""
    known = set(_spans(model))
    for name, one in model.deflections.items():
        path = ("deflections", name, "members")
        if not all(member in known for member in one.members):
            continue  # a fault of its own
        about = tuple((table, member) for table in ("bars", "active", "beams", "links") for member in one.members)
        row = row_of(model, one.members)
        if row is None or len(set(one.members)) < len(one.members):
            listed = ", ".join(one.members)
            mend = "Name them in the order in which they meet, from one end of the span to the other."
            said = f"{listed} are not in a row: each must begin at the node where that before it ends."
            yield Fault(path, said, mend, about=about)
            continue
        nodes = row_nodes(model, row)
        if not all(node in model.nodes and len(model.nodes[node].at) == model.dim for node in nodes):
            continue
        places = [model.nodes[node].at for node in nodes]
        length, span = sum(math.dist(a, b) for a, b in pairwise(places)), math.dist(places[0], places[-1])
        if not length <= (1 + STRAIGHT) * span:
            mend = "Give a limit to each straight part."
            yield Fault(path, f"do not lie on a straight line from {nodes[0]!r} to {nodes[-1]!r}.", mend, about=about)
        elif len(nodes) == 2 and one.measured_from == "ends" and one.members[0] not in model.bending:
            mend = "Make it a beam or a link, name several in a row, or measure from start."
            said = f"{one.members[0]!r} alone stays straight between its ends, so it has no deflection."
            yield Fault(path, said, mend, about=about)
