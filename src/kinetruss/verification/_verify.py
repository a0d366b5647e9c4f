"""The built-in verification suite."""

from __future__ import annotations

from collections.abc import Iterator

from kinetruss.verification._case import Case, Report, Workshop
from kinetruss.verification.drive_trains import rotary as _rotary
from kinetruss.verification.drive_trains import screws as _drive_train
from kinetruss.verification.forward import andrews as _forward_andrews
from kinetruss.verification.forward import drives as _forward_drives
from kinetruss.verification.forward import free as _forward_free
from kinetruss.verification.forward import laws as _forward_laws
from kinetruss.verification.forward import linkages as _forward_linkages
from kinetruss.verification.forward import long as _forward_long
from kinetruss.verification.forward import motors as _forward_motors
from kinetruss.verification.forward import orders as _forward_orders
from kinetruss.verification.forward import pendulums as _forward_pendulums
from kinetruss.verification.forward import rotary as _forward_rotary
from kinetruss.verification.mechanisms import joints as _joints
from kinetruss.verification.mechanisms import loops as _loops
from kinetruss.verification.mechanisms import loops_let_go as _loops_let_go
from kinetruss.verification.mechanisms import modes as _modes
from kinetruss.verification.mechanisms import rates as _rates
from kinetruss.verification.mechanisms import robot_forward as _robot_forward
from kinetruss.verification.mechanisms import robots as _robots
from kinetruss.verification.mechanisms import rows as _rows
from kinetruss.verification.solids import bodies as _bodies
from kinetruss.verification.solids import elements as _solids
from kinetruss.verification.structures import equilibrium as _equilibrium
from kinetruss.verification.structures import explain as _explain
from kinetruss.verification.structures import frequencies as _frequencies
from kinetruss.verification.structures import gauges as _gauges
from kinetruss.verification.structures import linearise as _linearise
from kinetruss.verification.structures import sizing as _sizing
from kinetruss.verification.structures import statics as _statics
from kinetruss.verification.thesis import bay as _bay
from kinetruss.verification.thesis import chain as _chain
from kinetruss.verification.thesis import comparison as _comparison
from kinetruss.verification.thesis import drive as _drive
from kinetruss.verification.thesis import poses as _poses
from kinetruss.verification.thesis import tables as _tables
from kinetruss.verification.thesis import triangle as _triangle
from kinetruss.verification.thesis import triangle_printed as _triangle_printed
from kinetruss.verification.thesis import triangle_thesis as _triangle_thesis

__all__ = ["cases", "verify"]


def verify(filter: str | None = None) -> Report:
    """Compare the product with every reference that it claims.

    Every entry says by its class what its agreement shows, and names the inputs that are not the printed ones. Computed
    values come from the public API; those of the class "thesis-formulas" from the thesis' own formulas, along a motion
    from the public API. A case agrees where |computed - expected|/max(|expected|, scale) is within the tolerance, which
    is what the reference itself is good for: 1e-8 for exact values of ten digits, 1e-6 for maxima on a grid, more for
    printed tables.

    Parameters
    ----------
    filter : run only cases whose id, class or source contains this text (any case of letters).

    Returns
    -------
    Report, one entry a scalar; `classes` counts them.
    """
    wanted = (filter or "").casefold()
    workshop = Workshop()
    chosen = (case for case in cases() if any(wanted in text.casefold() for text in _texts(case)))
    return Report(tuple(case.run(workshop) for case in chosen))


def _texts(case: Case) -> tuple[str, str, str]:
    return case.id, case.reference.kind, case.reference.source


def cases() -> Iterator[Case]:
    """All cases, nothing computed yet."""
    for part in (
        _triangle_printed,
        _triangle_thesis,
        _triangle,
        _comparison,
        _tables,
        _bay,
        _chain,
        _poses,
        _drive,
        _drive_train,
        _statics,
        _equilibrium,
        _frequencies,
        _linearise,
        _solids,
        _forward_pendulums,
        _forward_linkages,
        _forward_andrews,
        _forward_free,
        _forward_laws,
        _forward_drives,
        _forward_motors,
        _forward_rotary,
        _forward_long,
        _forward_orders,
        _rates,
        _rotary,
        _rows,
        _explain,
        _bodies,
        _gauges,
        _sizing,
        _joints,
        _loops,
        _loops_let_go,
        _modes,
        _robots,
        _robot_forward,
    ):
        yield from part.cases()
