"""The outcome of the variants of a run, one line each."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from kinetruss.display import Table, instant, quantity
from kinetruss.report._page import Page

if TYPE_CHECKING:
    from kinetruss.runs import VariantRuns

__all__ = ["variants"]

HEAD = ("variant", "status", "worst part", "rule", "utilisation", "time")


def variants(found: VariantRuns) -> Page:
    """The outcome of each variant, in the order of the combinations, and the folders of the runs.

    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.variants(kt.runs.run_variants(model, {"nodes.C.mass": [0.5, 1.0]}))
    >>> [line.split()[0] for line in page.text.splitlines()[1:]]
    ['mass=0.5', 'mass=1.0']
    """
    return Page(found=found, as_record=_records, as_text=_text)


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
                "refused": found.refused.get(name),
            }
        )
    return records


def _text(found: VariantRuns) -> str:
    """The same as a table, with the folders of the runs."""
    rows = []
    for record in _records(found):
        status = "refused" if record["refused"] else "done" if record["whole"] else record["status"].lower().replace("_", " ")
        worst = record["worst"]
        cells = ("-",) * 4
        if worst is not None:
            value = quantity(math.inf if worst["utilisation"] is None else worst["utilisation"], "%")
            cells = (worst["part"], worst["rule"], value, instant(worst["time"]))
        rows.append((record["name"], status, *cells))
    text = Table(HEAD, rows).text
    folders = {path.parent if len(found.paths) > 1 else path for path in found.paths.values()}
    return f"{text}\n\n{len(found)} runs in {', '.join(map(str, sorted(folders)))}" if folders else text
