"""A calculation sheet: what is given, and steps that follow from it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from kinetruss.report.document.worked.formulas import DIGITS, evaluate, in_numbers, in_symbols, plain_symbol, valued

if TYPE_CHECKING:
    from kinetruss.results import Row

__all__ = ["Given", "Sheet", "Step"]

ROUND_OFF = 1e-9
"""Relative difference up to which a worked result agrees with the verdict."""


@dataclass(frozen=True, slots=True)
class Given:
    """A quantity that enters: symbol, meaning, SI value and unit, and where it comes from."""

    symbol: str
    meaning: str
    value: float
    unit: str
    source: str = ""


@dataclass(frozen=True, slots=True)
class Step:
    """One line: symbol, meaning, formula in symbols and in numbers, SI result and unit, source of the formula."""

    symbol: str
    meaning: str
    formula: str
    numbers: str
    value: float
    unit: str
    source: str = ""


@dataclass(kw_only=True)
class Sheet:
    """A worked calculation of one entry of a verdict or a demand.

    row : the entry. result, allowed : symbols of demand and capacity. `values` and `units` hold every symbol.
    timed : the entry belongs to an instant of a run over time. pair : label of its pair, in a mission.
    digits : significant ones of the numbers that are put in.
    samples : symbol, unit and values of the histories of which an integral is taken.
    """

    title: str
    row: Row
    given: list[Given] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    values: dict[str, float] = field(default_factory=dict)
    units: dict[str, str] = field(default_factory=dict)
    result: str = ""
    allowed: str = ""
    timed: bool = True
    pair: str = ""
    digits: int = DIGITS
    samples: list[tuple[str, str, list[float]]] = field(default_factory=list)

    def give(self, symbol: str, meaning: str, value: float, unit: str, source: str = "") -> float:
        """Enter a quantity."""
        self.values[symbol], self.units[symbol] = float(value), unit
        self.given.append(Given(plain_symbol(symbol), meaning, float(value), unit, source))
        return float(value)

    def step(self, symbol: str, meaning: str, formula: str, unit: str, source: str = "") -> float:
        """Compute a quantity from those entered or computed before, by the formula that is printed."""
        value = evaluate(formula, self.values)
        shown = in_numbers(formula, self.values, self.units, self.digits)
        self.steps.append(Step(plain_symbol(symbol), meaning, in_symbols(formula), shown, value, unit, source))
        self.values[symbol], self.units[symbol] = value, unit
        return value

    def close(self, result: str, allowed: str) -> Sheet:
        """Name demand and capacity, and add their ratio."""
        self.result, self.allowed = result, allowed
        self.step("u", "utilisation", f"abs({result})/{allowed}", "%")
        return self

    @property
    def demand(self) -> float:
        """Magnitude of the worked demand."""
        return abs(self.values[self.result])

    @property
    def capacity(self) -> float:
        """The worked capacity."""
        return self.values[self.allowed]

    @property
    def difference(self) -> float:
        """Largest relative difference of demand, capacity and utilisation from those of the entry."""
        pairs = ((self.demand, self.row.value), (self.capacity, self.row.limit), (self.values["u"], self.row.utilisation))
        return max(_apart(one, other) for one, other in pairs)

    @property
    def rank(self) -> float:
        """The utilisation by which calculations are sorted; one without a finite value follows those of exceeded limits."""
        return 1.0 if math.isinf(self.row.utilisation) else self.row.utilisation

    @property
    def agrees(self) -> bool:
        """True if the worked result equals that of the entry to round-off."""
        return self.difference <= ROUND_OFF

    def text_of(self, symbol: str) -> str:
        """A quantity with its unit."""
        return valued(self.values[symbol], self.units[symbol])


def _apart(one: float, other: float) -> float:
    if one == other:
        return 0.0
    if not (math.isfinite(one) and math.isfinite(other)):
        return math.inf
    return abs(one - other) / max(abs(one), abs(other))
