"""Files of other programs: robots, drawings, meshes in; models and runs out. What cannot be carried is listed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.exchange._imported import Imported
    from kinetruss.exchange._read import read
    from kinetruss.exchange._write import FORMATS, Written, write
    from kinetruss.exchange.robots import LeftOut

__all__ = ["FORMATS", "Imported", "LeftOut", "Written", "read", "write"]

__getattr__, __dir__ = late(
    __name__, {"_imported": "Imported", "_read": "read", "_write": "FORMATS Written write", "robots": "LeftOut"}
)
