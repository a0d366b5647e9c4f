"""Design: tubes, screws, gears and motors chosen from catalogues; optima with a certificate."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.design.choices import catalogue as catalogue
    from kinetruss.design.optimal_design import optimise as optimise
    from kinetruss.design.optimum_folder import KeptOptimum as KeptOptimum, load_optimum as load_optimum
    from kinetruss.design.optimum_result import ActiveLimit as ActiveLimit, LimitUse as LimitUse, Optimum as Optimum
    from kinetruss.design.sizing import size as size
    from kinetruss.design.sizing_result import (
        DriveRow as DriveRow,
        GroupRow as GroupRow,
        Sizing as Sizing,
        record as record,
        table as table,
    )

__getattr__, __dir__, __all__ = late(__name__)
