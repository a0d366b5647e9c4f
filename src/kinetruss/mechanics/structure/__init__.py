"""A model compiled to arrays: its nodes, members and constraints, and the order in which these are solved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.structure.axes import local_axes, orientation
    from kinetruss.mechanics.structure.faces import TRIANGLES, Skin, body_faces, skin_of

__all__ = ["Skin", "TRIANGLES", "body_faces", "local_axes", "orientation", "skin_of"]

__getattr__, __dir__ = late(
    __name__,
    {
        "axes": "local_axes orientation",
        "faces": "Skin TRIANGLES body_faces skin_of",
    },
)
