"""Result records: datasets with named axes and units, a status and their provenance."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.results.records.records import MOTORS_UNCHECKED, check_samples
    from kinetruss.results.records.rows import NOT_CHECKED, most_used
    from kinetruss.results.records.simulation import happened
    from kinetruss.results.records.units import drive_unit, force_units, unit_along
    from kinetruss.results.records.wide import flat, labels, units_of

__all__ = [
    "MOTORS_UNCHECKED", "NOT_CHECKED", "check_samples", "drive_unit", "flat", "force_units", "happened", "labels", "most_used",
    "unit_along", "units_of",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "records": "MOTORS_UNCHECKED check_samples",
        "rows": "NOT_CHECKED most_used",
        "simulation": "happened",
        "units": "drive_unit force_units unit_along",
        "wide": "flat labels units_of",
    },
)
