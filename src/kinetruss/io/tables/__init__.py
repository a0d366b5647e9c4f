"""Tables in files: histories, strains, exports."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.io.tables.history import history_faults
    from kinetruss.io.tables.parts import read_parts

__all__ = ["history_faults", "read_parts"]

__getattr__, __dir__ = late(__name__, {"history": "history_faults", "parts": "read_parts"})
