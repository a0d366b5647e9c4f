"""Cross-checks of a whole model: every fault with its fix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.model.checks.bodies import impossible
    from kinetruss.model.checks.places import FLAT, beside, lying

__all__ = ["FLAT", "beside", "impossible", "lying"]

__getattr__, __dir__ = late(
    __name__,
    {
        "bodies": "impossible",
        "places": "FLAT beside lying",
    },
)
