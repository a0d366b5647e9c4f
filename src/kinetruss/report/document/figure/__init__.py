"""The figure of a report: the structure with its supports, drives, loads and the governing member."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.document.figure.contents import Loaded, loaded
    from kinetruss.report.document.figure.deflected import deflected_figure
    from kinetruss.report.document.figure.page_part import loaded_figure

__all__ = ["Loaded", "deflected_figure", "loaded", "loaded_figure"]

__getattr__, __dir__ = late(
    __name__, {"contents": "Loaded loaded", "deflected": "deflected_figure", "page_part": "loaded_figure"}
)
