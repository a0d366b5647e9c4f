"""Text formats: YAML and JSON with the position of every value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.formats.emit import to_yaml
    from kinetruss.io.formats.plain import plain_model
    from kinetruss.io.formats.text import read_text
    from kinetruss.io.formats.tree import Tree
    from kinetruss.io.formats.yaml import parse

__all__ = ["Tree", "parse", "plain_model", "read_text", "to_yaml"]

__getattr__, __dir__ = late(
    __name__,
    {
        "emit": "to_yaml",
        "plain": "plain_model",
        "text": "read_text",
        "tree": "Tree",
        "yaml": "parse",
    },
)
