"""Model files of earlier versions, which held the inner parts of beams, bodies and hubs too: these are left out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

MARKS = {"nodes": "director", "bars": "brace", "couplings": "beam"}
"""Table -> the field that marked inner parts."""


def without_inner_parts(data: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a model without marked parts, and with members of hubs that end at the hubs again.

    >>> old = {"nodes": {"A": [0, 0], "A.d1": {"at": [1, 0], "director": True}}, "fixed": {"A": "xy", "A.d1": "xy"}}
    >>> without_inner_parts(old)
    {'nodes': {'A': [0, 0]}, 'fixed': {'A': 'xy'}}
    """
    if not any(mark in row for table, mark in MARKS.items() for row in _rows(data, table)) and not data.get("hubs"):
        return dict(data)
    found = {key: dict(table) if isinstance(table, Mapping) else table for key, table in data.items()}
    gone = {"nodes": set[str](), "bars": set[str](), "bodies": set[str](), "couplings": set[str]()}
    for table, mark in MARKS.items():
        for name, row in _table(data, table).items():
            if isinstance(row, Mapping) and mark in row:
                if row[mark] not in (False, "false", None):
                    gone[table].add(name)
                found[table][name] = {key: value for key, value in row.items() if key != mark}
    for hub in _table(data, "hubs"):
        _ideal(found, str(hub), gone)
    gone["nodes"] |= {node for name in gone["bodies"] for node in found["bodies"][name]["nodes"] if f"{name}.apex" in node}
    for table, names in {**gone, "fixed": gone["nodes"], "support_motion": gone["nodes"]}.items():
        if names and isinstance(found.get(table), dict):
            found[table] = {name: row for name, row in found[table].items() if name not in names}
    return found


def _ideal(found: dict[str, Any], hub: str, gone: dict[str, set[str]]) -> None:
    """Let the members of a hub end at it, and note what it had added."""
    nodes, bodies = _table(found, "nodes"), _table(found, "bodies")
    for table in ("bars", "active"):
        for name, row in _table(found, table).items():
            tip = f"{hub}.{name}"
            ends = row.get("ends") if isinstance(row, Mapping) else row
            if not isinstance(ends, (list, tuple)) or tip not in ends or tip not in nodes:
                continue
            ideal = [hub if end == tip else end for end in ends]
            found[table][name] = {**row, "ends": ideal} if isinstance(row, Mapping) else ideal
            gone["bars"].add(tip)
            gone["nodes"] |= {tip, f"{tip}.axis1", f"{tip}.axis2"}
            gone["couplings"].add(f"{tip}.hinge")
            gone["bodies"] |= {f"{name}.hinges", f"{hub}.hub"} & set(bodies)
    if f"{hub}.hub" in bodies and hub in bodies[f"{hub}.hub"].get("nodes", ()):
        gone["bodies"].add(f"{hub}.hub")  # of a hub that only clamps


def _table(data: Mapping[str, Any], table: str) -> Mapping[str, Any]:
    found = data.get(table)
    return found if isinstance(found, Mapping) else {}


def _rows(data: Mapping[str, Any], table: str) -> Iterator[Mapping[str, Any]]:
    return (row for row in _table(data, table).values() if isinstance(row, Mapping))
