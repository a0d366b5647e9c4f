"""What a text must have to be drawn: nodes with numbers, members with two ends."""

from __future__ import annotations

from typing import Any

from kinetruss.errors import Fault, UnitError
from kinetruss.studio.editor.edits import MEMBERS, Data
from kinetruss.units import parse

__all__ = ["faulty_shape"]


def faulty_shape(data: Data) -> list[Fault]:
    """Faults of nodes and members that make it impossible to draw them."""
    found = []
    nodes, counts = data.get("nodes") or {}, set()
    if not isinstance(nodes, dict):
        return [Fault(("nodes",), "is not a table of names.", "Write for example nodes: {A: [0, 0]}.")]
    for name, entry in nodes.items():
        at = entry.get("at") if isinstance(entry, dict) else entry
        if not isinstance(at, list) or not _is_place(at):
            found.append(Fault(("nodes", name), "has no place.", "Write two or three lengths, e.g. [0.1, 50 mm]."))
        else:
            counts.add(len(at))
    if len(counts) > 1:
        found.append(Fault(("nodes",), "have two and three coordinates.", "Give all of them as many."))
    for table in MEMBERS:
        entries = data.get(table) or {}
        if not isinstance(entries, dict):
            found.append(Fault((table,), "is not a table of names.", f"Write for example {table}: {{b: [A, B]}}."))
            continue
        for name, entry in entries.items():
            ends = entry.get("ends") if isinstance(entry, dict) else entry
            if not (isinstance(ends, list) and len(ends) == 2 and all(isinstance(end, str) for end in ends)):
                found.append(Fault((table, name), "has no two ends.", "Write for example [A, B]."))
    fixed = data.get("fixed") or {}
    names = list(fixed.values()) if isinstance(fixed, dict) else fixed
    if not isinstance(names, list) or not all(isinstance(one, str) for one in names):
        found.append(Fault(("fixed",), "is neither a list of nodes nor a table of axes.", "Write for example fixed: {A: xy}."))
    return found


def _is_place(at: list[Any]) -> bool:
    if len(at) not in (2, 3):
        return False
    try:
        [parse(value, "length") for value in at]
    except UnitError:
        return False
    return True
