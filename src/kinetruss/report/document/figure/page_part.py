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


SMALL = 2.45
"""Height of the figure of a summary, inches."""


def loaded_figure(run: RunResult, record: Mapping[str, Any], *, small: bool = False) -> list[Markup]:
    """The figure as part of a page; nothing for a run without a good sample. small : for a summary."""
    if not run.good:
        return []
    found = loaded(run, record)
    canvas = drawn(found, SMALL) if small else drawn(found)
    return [embedded([lines_of(canvas, "loaded", found.caption)], found.caption)]
