"""Natural frequencies for a design: of those that meet, each keeps the derivative along its own shape.

A certificate with multipliers of these alone is sufficient (of all shapes of the pair, a positive semidefinite one would be).
"""

from __future__ import annotations

from typing import Any

from kinetruss.gradients.frequencies_point import FrequenciesPoint


class VibrationPoint(FrequenciesPoint):
    """A `Point` of `flexible.frequencies` that does not refuse repeated ones."""

    def refuse_repeated(self, seeds: Any) -> None:
        """Nothing."""
