"""Reads and writes files of models, missions and catalogues."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.models.set_value import given, resolved
    from kinetruss.io.models.texts import changed_text, data_of, head_of, located, text_of, value_of

__all__ = ["changed_text", "data_of", "given", "head_of", "located", "resolved", "text_of", "value_of"]

__getattr__, __dir__ = late(
    __name__, {"set_value": "given resolved", "texts": "changed_text data_of head_of located text_of value_of"}
)
