"""The built-in verification suite."""

from __future__ import annotations

from collections.abc import Iterator

from kinetruss.verification import (
    _bay,
    _bodies,
    _chain,
    _comparison,
    _drive,
    _drive_train,
    _equilibrium,
    _explain,
    _forward_andrews,
    _forward_drives,
    _forward_free,
    _forward_laws,
    _forward_linkages,
    _forward_long,
    _forward_motors,
    _forward_orders,
    _forward_pendulums,
    _forward_rotary,
    _frequencies,
    _gauges,
    _joints,
    _linearise,
    _loops,
    _loops_let_go,
    _modes,
    _poses,
    _rates,
    _robot_forward,
    _robots,
    _rotary,
    _rows,
    _sizing,
    _solids,
    _statics,
    _tables,
    _triangle,
    _triangle_printed,
    _triangle_thesis,
)
from kinetruss.verification._case import Case, Report, Workshop

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
