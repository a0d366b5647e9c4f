"""Where laws have kinks: there results have no gradients."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.errors import AnalysisError, few

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from kinetruss.mechanics import System


def refuse_kinks(held: System, rows: NDArray[np.int64]) -> None:
    """Refuse a state in which these rows of `stiff_rows` are at a kink.

    Raises
    ------
    AnalysisError : the parts to which they belong.
    """
    if len(rows):
        raise AnalysisError(
            f"There is no gradient here, at a kink: {few(held.parts_of(rows), 6)} just touches, without force, so that it "
            "resists one change and not the opposite one. Give it a prestress or a gap, or change the load."
        )
