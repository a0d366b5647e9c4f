"""The built-in verification suite."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kinetruss.verification._case import Case, Report
from kinetruss.verification._cases import cases, numbers

__all__ = ["verify"]


def verify(filter: str | None = None, progress: Callable[[int, int], None] | None = None) -> Report:
    """Compare kinetruss with all its references.

    The class of an entry says what its agreement shows; inputs that differ from the printed ones are named. Computed
    values come from the public API; those of the class "thesis-formulas" from the thesis' own formulas, along a motion
    from the public API. A case agrees if |computed - expected|/max(|expected|, scale) is within the tolerance, which is the
    accuracy of the reference itself: 1e-8 for exact values of ten digits, 1e-6 for maxima on a grid, more for
    printed tables.

    Parameters
    ----------
    filter : run only cases whose id, class or source contains this text (any case of letters).
    progress : called with the number of cases that are done, and of all.

    Returns
    -------
    Report, with one entry per scalar; `classes` counts them.

    Examples
    --------
    >>> import kinetruss as kt
    >>> report = kt.verification.verify("gauges.rosette")
    >>> report.passed, report.failed
    (3, 0)
    """
    wanted = (filter or "").casefold()
    made: dict[str, dict[str, float]] = {}
    chosen = [case for case in cases() if any(wanted in text.casefold() for text in _texts(case))]
    entries = []
    for case in chosen:
        call = f"{case.make}{case.arguments}"
        if call not in made:
            made[call] = numbers(case.make, case.arguments)
        entries.append(case.entry(made[call]))
        if progress:
            progress(len(entries), len(chosen))
    return Report(tuple(entries))


def _texts(case: Case) -> tuple[Any, ...]:
    return case.id, case.reference.kind, case.reference.source
