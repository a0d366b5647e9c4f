"""A verification case, its outcome, and the report of them all."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable
from dataclasses import asdict, dataclass, field
from typing import Any, TypeVar

__all__ = ["Case", "Entry", "Report", "Workshop", "relative_difference"]

Made = TypeVar("Made")


@dataclass(frozen=True)
class Entry:
    """One scalar compared: SI units, `tolerance` is the largest allowed `relative_difference`."""

    id: str
    source: str
    expected: float
    computed: float
    relative_difference: float
    tolerance: float
    passed: bool


@dataclass(frozen=True)
class Report:
    """All entries of a verification."""

    entries: tuple[Entry, ...]

    @property
    def passed(self) -> int:
        """How many entries agree."""
        return sum(entry.passed for entry in self.entries)

    @property
    def failed(self) -> int:
        """How many do not."""
        return len(self.entries) - self.passed

    def as_dict(self) -> dict[str, Any]:
        """``{"entries": [...], "passed": n, "failed": m}``, plain values; a difference that is no number becomes None."""
        entries = [
            {name: value if not isinstance(value, float) or math.isfinite(value) else None for name, value in asdict(e).items()}
            for e in self.entries
        ]
        return {"entries": entries, "passed": self.passed, "failed": self.failed}


class Workshop:
    """Makes each analysis of one verification once, however many cases read it."""

    def __init__(self) -> None:
        self._made: dict[Hashable, Any] = {}

    def once(self, make: Callable[..., Made], *arguments: Hashable) -> Made:
        """``make(*arguments)``, kept for the next case that asks."""
        key = (make, *arguments)
        if key not in self._made:
            self._made[key] = make(*arguments)
        return self._made[key]  # type: ignore[no-any-return]


@dataclass(frozen=True)
class Case:
    """A stored value and how the product's public API finds it.

    make, arguments : the analysis that holds the value; at : keys and indices that lead to it there.
    scale : 0, or the largest component of the vector that the value belongs to, so that a component that is zero by
        symmetry is measured against the vector rather than against itself.
    """

    id: str
    source: str
    expected: float
    tolerance: float
    make: Callable[..., Any] = field(repr=False)
    arguments: tuple[Hashable, ...] = ()
    at: tuple[Any, ...] = ()
    scale: float = 0.0

    def run(self, workshop: Workshop) -> Entry:
        """Compute and compare."""
        found = workshop.once(self.make, *self.arguments)
        for key in self.at:
            found = found[key]
        computed, expected = float(found), float(self.expected)
        difference = relative_difference(computed, expected, self.scale)
        passed = difference <= self.tolerance
        return Entry(self.id, self.source, expected, computed, difference, self.tolerance, passed)


def relative_difference(computed: float, expected: float, scale: float = 0.0) -> float:
    """|c - e|/max(|e|, scale); 0 where both are equal.

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
