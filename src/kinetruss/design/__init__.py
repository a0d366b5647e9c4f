"""Sizing: tubes, screws, gears and motors chosen from catalogues."""

from kinetruss.design._catalogue import catalogue
from kinetruss.design._size import size
from kinetruss.design._sizing import DriveRow, GroupRow, Sizing
from kinetruss.design._table import record, table
from kinetruss.late import listed

__all__ = [
    "DriveRow",
    "GroupRow",
    "Sizing",
    "catalogue",
    "record",
    "size",
    "table",
]

__dir__ = listed(__name__)
