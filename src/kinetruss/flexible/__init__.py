"""Structures with elastic members and actuators: drive lengths corrected for them, frequencies, vibration, active damping.

Parts are imported when first used.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.flexible._corrected import Corrected as Corrected, corrected as corrected
    from kinetruss.flexible._damped import ActiveDamping as ActiveDamping, active_damping as active_damping
    from kinetruss.flexible._simulate import simulate as simulate
    from kinetruss.flexible._vibration import Vibration as Vibration, vibration as vibration
    from kinetruss.flexible.natural_frequencies import Frequencies as Frequencies, frequencies as frequencies

__getattr__, __dir__, __all__ = late(__name__)
