"""Whose an inner part of a model is: one that represents a beam, link, body, hub or support."""

from typing import Literal, NamedTuple

WORDS = {"beams": "beam", "links": "link", "bodies": "body", "hubs": "hub", "supports": "support"}


class Owner(NamedTuple):
    """To what an inner part belongs: the table of the model (``nodes``, ``beams``, ``links``, ``bodies``, ``hubs``,
    ``supports``), the name there, and the node at which it is (empty for bars).
    """

    table: Literal["nodes", "beams", "links", "bodies", "hubs", "supports"]
    name: str
    at: str = ""

    @property
    def text(self) -> str:
        """The user's part in words; the frame of a node carries its rotation."""
        return f"rotation of {self.name}" if self.table == "nodes" else f"{WORDS[self.table]} {self.name}"
