"""Frozen result records with axes, units, provenance and status. Parts that need xarray are imported when first used."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.results.arrays import (
        Arrays as Arrays,
        Axes as Axes,
        Column as Column,
        Columns as Columns,
        variable as variable,
    )
    from kinetruss.results.dynamic_records import (
        DriveRun as DriveRun,
        Episode as Episode,
        Occurrence as Occurrence,
        Passage as Passage,
        Simulation as Simulation,
    )
    from kinetruss.results.records import (
        Demand as Demand,
        Forces as Forces,
        Motion as Motion,
        Result as Result,
        Sections as Sections,
        Status as Status,
        Verdict as Verdict,
        model_hash as model_hash,
        provenance as provenance,
    )
    from kinetruss.results.wide_tables import Row as Row, row_text as row_text, rows_of as rows_of

__getattr__, __dir__, __all__ = late(__name__)
