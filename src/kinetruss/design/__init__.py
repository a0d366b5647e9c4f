"""How light can it be, and what drives it: tubes, screws, gears and motors chosen from catalogues."""

from kinetruss.design._catalogue import catalogue, catalogue_names
from kinetruss.design._drives import core_stress
from kinetruss.design._groups import default_drives, default_groups
from kinetruss.design._size import size
from kinetruss.design._sizing import DriveRow, GroupRow, Sizing
from kinetruss.design._table import record, table

__all__ = [
    "DriveRow",
    "GroupRow",
    "Sizing",
    "catalogue",
    "catalogue_names",
    "core_stress",
    "default_drives",
    "default_groups",
    "record",
    "size",
    "table",
]
