"""Entries of a model for the page: forms of all records, and new ones from what is picked, and pages of runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.studio.editor.parts.make import made, with_analysis
    from kinetruss.studio.editor.parts.records import forms
    from kinetruss.studio.editor.parts.results import Results

__all__ = ["Results", "forms", "made", "with_analysis"]

__getattr__, __dir__ = late(__name__, {"records": "forms", "make": "made with_analysis", "results": "Results"})
