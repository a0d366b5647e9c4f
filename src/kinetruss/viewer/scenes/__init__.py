"""Scenes of a model, a motion or a run, as plain data."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.viewer.scenes.histories import moving

__all__ = ["moving"]

__getattr__, __dir__ = late(__name__, {"histories": "moving"})
