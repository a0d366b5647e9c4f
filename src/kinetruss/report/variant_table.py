"""The outcome of the variants of a run, one line each."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from kinetruss.display import Table
from kinetruss.display.tables import measured, seconds, words
from kinetruss.report.page import Page

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry
    from kinetruss.runs import VariantRuns


def variants(found: VariantRuns) -> Page:
    """The outcome of each variant, in the order of the combinations, and the folders of the runs.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.variants(kt.runs.run_variants(model, {"nodes.C.mass": [0.5, 1.0]}))
    >>> [line.split()[0] for line in page.text.splitlines()[1:]]
    ['mass=0.5', 'mass=1.0']
    """
    return Page(found=found, as_record=_records, as_entries=_entries)


def _records(found: VariantRuns) -> list[dict[str, Any]]:
    """One entry per variant, plain data, in the order of the combinations."""
    records = []
    for name, settings in found.settings.items():
        worst = found.worst.get(name)
        highest = None if worst is None else dict(zip(("part", "rule", "utilisation", "time"), worst, strict=True))
        if worst is not None and highest is not None and math.isinf(worst[2]):  # JSON has no infinity
            highest["utilisation"] = None
        path, status = found.paths.get(name), found.status.get(name)
        records.append(
            {
                "name": name,
                "settings": dict(settings),
                "path": None if path is None else str(path),
                "status": None if status is None else status.name,
                "whole": found.whole.get(name, False),
                "worst": highest,
                "verdict": found.said.get(name, ""),
                "refused": found.refused.get(name),
            }
        )
    return records


def _entries(found: VariantRuns) -> list[Entry]:
    """The same as a table, with the folders of the runs."""
    columns = [
        words("variant", "name"),
        words("status", _status),
        words("worst part", lambda one: one["worst"]["part"] if one["worst"] else "-"),
        words("rule", lambda one: one["worst"]["rule"] if one["worst"] else "-"),
        measured("utilisation", _used, "%"),
        seconds("time", lambda one: one["worst"]["time"] if one["worst"] else None),
        words("verdict", lambda one: one["verdict"] or "-"),
    ]
    folders = {path.parent if len(found.paths) > 1 else path for path in found.paths.values()}
    where = f"{len(found)} runs in {', '.join(map(str, sorted(folders)))}" if folders else ""
    return [Table(columns, _records(found)), where]


def _status(one: dict[str, Any]) -> str:
    return "refused" if one["refused"] else "done" if one["whole"] else str(one["status"]).lower().replace("_", " ")


def _used(one: dict[str, Any]) -> float | None:
    if one["worst"] is None:
        return None
    return math.inf if one["worst"]["utilisation"] is None else float(one["worst"]["utilisation"])
