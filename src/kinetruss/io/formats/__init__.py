"""Text formats: YAML and JSON with the position of every value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.formats.emit import to_yaml
    from kinetruss.io.formats.plain import plain_model

__all__ = ["plain_model", "to_yaml"]

__getattr__, __dir__ = late(
    __name__,
    {
        "emit": "to_yaml",
        "plain": "plain_model",
    },
)
