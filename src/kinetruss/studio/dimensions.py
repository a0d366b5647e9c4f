"""Dimensions of a drawing: distances of nodes, lengths of members and angles between them that pages show. They are no part of
the model.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.model import nearest
from kinetruss.studio.edits import MEMBERS

if TYPE_CHECKING:
    from kinetruss.studio.edits import Data

Dimension = tuple[str, tuple[str, ...]]
"""``nodes`` and two names, or ``members`` and one or two."""

Dimensions = tuple[Dimension, ...]

COUNTS = {"nodes": (2,), "members": (1, 2)}


def _there(data: Data) -> dict[str, set[str]]:
    """Names of nodes and members of a drawing."""
    return {"nodes": set(data.get("nodes") or {}), "members": {name for table in MEMBERS for name in data.get(table) or {}}}


def toggled(found: Dimensions, data: Data, nodes: Sequence[str], members: Sequence[str]) -> Dimensions:
    """With a dimension more; or without it, if it is there.

    Raises
    ------
    InputError : unknown names, the same one twice, or not as many as a dimension has.

    >>> data = {"nodes": {"A": [0, 0], "B": [1, 0]}, "bars": {"b": ["A", "B"]}}
    >>> toggled((), data, ["B", "A"], [])
    (('nodes', ('A', 'B')),)
    >>> toggled((("nodes", ("A", "B")),), data, ["A", "B"], [])
    ()
    """
    kind, names = ("members", members) if members else ("nodes", nodes)
    if (nodes and members) or len(names) not in COUNTS[kind] or len(set(names)) < len(names):
        raise InputError("A dimension is that of two nodes, of one member, or of two members: their angle.")
    there = _there(data)[kind]
    for name in names:
        if name not in there:
            raise InputError(f"There is no {kind[:-1]} called {name!r}. {nearest(name, there)}")
    one = (kind, tuple(sorted(names)))
    return tuple(other for other in found if other != one) if one in found else (*found, one)


def standing(found: Dimensions, data: Data) -> Dimensions:
    """Those whose nodes and members are in a drawing."""
    there = _there(data)
    return tuple((kind, names) for kind, names in found if there[kind].issuperset(names))


def renamed(found: Dimensions, table: str, old: str, new: str) -> Dimensions:
    """With another name of a node or member.

    >>> renamed((("nodes", ("A", "B")),), "nodes", "A", "tip")
    (('nodes', ('B', 'tip')),)
    """
    own = "nodes" if table == "nodes" else "members" if table in MEMBERS else ""
    return tuple((kind, tuple(sorted(new if name == old and kind == own else name for name in names))) for kind, names in found)


def read(record: Any) -> Dimensions:
    """Those of a record of JSON; what is no dimension is left out.

    >>> read([["nodes", ["A", "B"]], ["nodes", ["A"]], 7])
    (('nodes', ('A', 'B')),)
    """
    pairs = [one for one in record if isinstance(one, list) and len(one) == 2] if isinstance(record, list) else []
    return tuple(
        (kind, tuple(names))
        for kind, names in pairs
        if isinstance(kind, str) and isinstance(names, list) and len(names) in COUNTS.get(kind, ())
        and all(isinstance(name, str) for name in names)
    )  # fmt: skip
