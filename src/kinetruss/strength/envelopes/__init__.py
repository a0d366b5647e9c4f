"""The envelope of many motions and load cases, kept while they pass."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.strength.envelopes.gathering import Gathering
    from kinetruss.strength.envelopes.verdicts import extremes_of, verdict_of

__all__ = ["Gathering", "extremes_of", "verdict_of"]

__getattr__, __dir__ = late(__name__, {"gathering": "Gathering", "verdicts": "extremes_of verdict_of"})
