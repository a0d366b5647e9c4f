"""Forces along a given motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.dynamics.prescribed.free import applied
    from kinetruss.dynamics.prescribed.inverse import at_rest
    from kinetruss.dynamics.prescribed.prepared import prepare

__all__ = ["applied", "at_rest", "prepare"]

__getattr__, __dir__ = late(
    __name__,
    {
        "free": "applied",
        "inverse": "at_rest",
        "prepared": "prepare",
    },
)
