"""Figures and line drawings."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.pictures.quantities import (
        ALIASES as ALIASES,
        BUNDLES as BUNDLES,
        FED as FED,
        QUANTITIES as QUANTITIES,
    )

__getattr__, __dir__, __all__ = late(__name__)
