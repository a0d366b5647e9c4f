"""The result of a run in three lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.report.document._mission import mission_lines
from kinetruss.report.document._record import document_record
from kinetruss.report.document.result.lines import result_lines
from kinetruss.runs import MissionRun

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["lines"]


def lines(run: RunResult) -> tuple[str, str, str]:
    r"""Three lines: the governing member or drive with its demand and limit; limits exceeded; what strength was checked.

    They are the first lines of a report (`document_page`). Of a mission they are those of all its pairs.

    >>> import kinetruss as kt
    >>> bar = kt.Bar(ends=("A", "B"), section=kt.Rod(diameter=0.01), material="steel_s235")
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed={"A": "xy", "B": "y"}, bars={"bar": bar},
    ...                  loads={"P": kt.NodalForce(node="B", force=(1e3, 0))}, runs={"pull": kt.Run(analysis="statics.linear")})
    >>> print("\n".join(kt.report.lines(kt.run(model, "pull"))))
    Governing: yield of bar, 5.42 % of what is allowed: 12.73 MPa of 235 MPa (all loads).
    None of the 3 limits that were checked is exceeded.
    Strength checked by every rule: 1 part.
    """
    return mission_lines(run) if isinstance(run, MissionRun) else result_lines(document_record(run, []))
