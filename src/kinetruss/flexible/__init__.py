"""Structures with elastic members and actuators: drive lengths corrected for them, frequencies, vibration, active damping.

Parts are imported when first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.flexible._corrected import Corrected, corrected
    from kinetruss.flexible._damped import ActiveDamping, active_damping
    from kinetruss.flexible._frequencies import Frequencies, frequencies
    from kinetruss.flexible._simulate import simulate
    from kinetruss.flexible._vibration import Vibration, vibration

__all__ = [
    "ActiveDamping",
    "Corrected",
    "Frequencies",
    "Vibration",
    "active_damping",
    "corrected",
    "frequencies",
    "simulate",
    "vibration",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "_corrected": "Corrected corrected",
        "_damped": "ActiveDamping active_damping",
        "_frequencies": "Frequencies frequencies",
        "_simulate": "simulate",
        "_vibration": "Vibration vibration",
    },
)
