"""Reads and writes files of models, missions and catalogues."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.models.set_value import given, resolved

__all__ = ["given", "resolved"]

__getattr__, __dir__ = late(__name__, {"set_value": "given resolved"})
