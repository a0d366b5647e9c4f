"""The figure as part of a page."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from kinetruss.report.document.figure.contents import loaded
from kinetruss.report.document.figure.drawing import drawn
from kinetruss.report.document.parts.pictures import embedded, lines_of

if TYPE_CHECKING:
    from kinetruss.display import Markup
    from kinetruss.runs import RunResult

__all__ = ["loaded_figure"]


def loaded_figure(run: RunResult, record: Mapping[str, Any]) -> list[Markup]:
    """The figure as part of a page; nothing for a run without a good sample."""
    if not run.good:
        return []
    found = loaded(run, record)
    return [embedded([lines_of(drawn(found), "loaded", found.caption)], found.caption)]
