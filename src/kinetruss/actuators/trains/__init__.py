"""Screw, gear and motor of a drive."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.actuators.trains.shaft import Shaft
    from kinetruss.actuators.trains.train_of import parts_of

__all__ = ["Shaft", "parts_of"]

__getattr__, __dir__ = late(__name__, {"shaft": "Shaft", "train_of": "parts_of"})
