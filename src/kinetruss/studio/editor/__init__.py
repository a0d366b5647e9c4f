"""The editor: a drawing that becomes a model, edit by edit.

A `Desk` holds the drawing of a studio and answers the messages of its pages; it needs no network.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.studio.editor.desk import Desk

__all__ = ["Desk"]

__getattr__, __dir__ = late(__name__, {"desk": "Desk"})
