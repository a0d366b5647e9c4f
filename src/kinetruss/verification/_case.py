"""A verification case, its result, and the report of all cases."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from kinetruss.verification._reference import CLAIMS, INPUT_CHECK, Kind, Reference

__all__ = ["Case", "Entry", "Report", "relative_difference"]


@dataclass(frozen=True)
class Entry:
    """One scalar compared, SI.

    kind : its class, a key of `CLAIMS`, which says what agreement shows.
    source, note, inferred : source of the expected value, how to read it, and the inputs that differ from the printed ones.
    product : the product's own result, if `computed` repeats wrong formulas or inputs of the source.
    tolerance : the largest allowed `relative_difference`.
    """

    id: str
    kind: Kind
    source: str
    note: str
    inferred: tuple[str, ...]
    expected: float
    computed: float
    product: float | None
    relative_difference: float
    tolerance: float
    passed: bool

    def as_dict(self) -> dict[str, Any]:
        """Plain values by name, `kind` as ``"class"``; a number that is not finite becomes None."""
        return {
            "id": self.id,
            "class": self.kind,
            "source": self.source,
            "note": self.note,
            "inferred": list(self.inferred),
            "expected": _finite(self.expected),
            "computed": _finite(self.computed),
            "product": _finite(self.product),
            "relative_difference": _finite(self.relative_difference),
            "tolerance": self.tolerance,
            "passed": self.passed,
        }


def _finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


@dataclass(frozen=True)
class Report:
    """All entries of a verification."""

    entries: tuple[Entry, ...]

    @property
    def passed(self) -> int:
        """Number of entries that agree."""
        return sum(entry.passed for entry in self.entries)

    @property
    def failed(self) -> int:
        """Number of entries that do not agree."""
        return len(self.entries) - self.passed

    @property
    def verified(self) -> int:
        """Number of entries that agree, without checks of inputs, which are true by construction."""
        return sum(entry.passed for entry in self.entries if entry.kind != INPUT_CHECK)

    @property
    def classes(self) -> dict[Kind, tuple[int, int]]:
        """Number of entries, and of those that agree, by class."""
        found = {kind: [entry.passed for entry in self.entries if entry.kind == kind] for kind in CLAIMS}
        return {kind: (len(agrees), sum(agrees)) for kind, agrees in found.items() if agrees}

    def as_dict(self) -> dict[str, Any]:
        """``{"entries": [...], "classes": {...}, "verified": k, "passed": n, "failed": m}``, plain values."""
        classes = {
            kind: {"claim": CLAIMS[kind], "entries": number, "passed": agree} for kind, (number, agree) in self.classes.items()
        }
        return {
            "entries": [entry.as_dict() for entry in self.entries],
            "classes": classes,
            "verified": self.verified,
            "passed": self.passed,
            "failed": self.failed,
        }


@dataclass(frozen=True)
class Case:
    """An expected value and the function that computes the value to compare.

    make, arguments : function, ``"group.module.function"`` below this package, and its arguments; key : name of the number
    in its result.
    scale : 0, or the largest component of the vector of the value, so that a component that is zero by symmetry is compared
    relative to the vector instead of itself.
    """

    id: str
    reference: Reference
    expected: float
    tolerance: float
    make: str
    arguments: tuple[Any, ...]
    key: str
    scale: float = 0.0

    def entry(self, found: Mapping[str, float]) -> Entry:
        """Compare with the numbers of the function, by name; ``KEY.product`` is the product's own result, if there is one."""
        computed, ref = float(found[self.key]), self.reference
        difference = relative_difference(computed, self.expected, self.scale)
        return Entry(
            self.id,
            ref.kind,
            ref.source,
            ref.note,
            ref.inferred,
            self.expected,
            computed,
            found.get(f"{self.key}.product"),
            difference,
            self.tolerance,
            difference <= self.tolerance,
        )


def relative_difference(computed: float, expected: float, scale: float = 0.0) -> float:
    """|c - e|/max(|e|, scale); 0 if both are equal.

    >>> relative_difference(1.01, 1.0)
    0.010000000000000009
    >>> relative_difference(1e-12, 0.0, scale=10.0)
    1e-13
    """
    distance = abs(computed - expected)
    if distance == 0:
        return 0.0
    size = max(abs(expected), scale)
    return distance / size if size > 0 else math.inf
