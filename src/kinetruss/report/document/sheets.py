"""Formulas as text, computed and printed from one text, and the calculation sheets made of them."""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING

from kinetruss.display import quantity

if TYPE_CHECKING:
    from kinetruss.results import Row


DIGITS = 5
"""Significant digits of the numbers that are put in; the computation itself has all."""

FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt,
    "abs": abs,
    "min": min,
    "max": max,
    "cos": math.cos,
    "sin": math.sin,
    "sec": lambda angle: 1 / math.cos(angle),
    "sign": lambda value: math.copysign(1.0, value) if value else 0.0,
}
OPERATORS: dict[type, Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}
SIGNS = {ast.Add: " + ", ast.Sub: " − ", ast.Div: "/"}
RANK = {ast.Add: 1, ast.Sub: 1, ast.Mult: 2, ast.Div: 2, ast.Pow: 4}
GREEK = {
    "alpha": "α", "eta": "η", "lambda": "λ", "mu": "μ", "omega": "ω", "psi": "ψ", "sigma": "σ", "tau": "τ",
}  # fmt: skip
POWERS = {"2": "²", "3": "³", "4": "⁴"}
GEOMETRY = {"m^2": (1e6, "mm²"), "m^3": (1e9, "mm³"), "m^4": (1e12, "mm⁴"), "m/rad": (1e3, "mm/rad")}
"""Units of section constants and leads, always in mm."""


@lru_cache(maxsize=256)
def _tree(text: str) -> ast.expr:
    return ast.parse(text, mode="eval").body


def evaluate(text: str, values: Mapping[str, float]) -> float:
    """The value of a formula. Division by zero is infinite.

    >>> evaluate("C*pi**2*E*I/l**2", {"C": 1.0, "E": 70e9, "I": 8e-9, "l": 2.0}) == 3.141592653589793**2 * 70e9 * 8e-9 / 4
    True
    """
    return _value(_tree(text), values)


def _value(node: ast.expr, values: Mapping[str, float]) -> float:
    if isinstance(node, ast.Constant):
        return float(node.value)  # type: ignore[arg-type]
    if isinstance(node, ast.Name):
        return math.pi if node.id == "pi" else values[node.id]
    if isinstance(node, ast.UnaryOp):
        return -_value(node.operand, values)
    if isinstance(node, ast.Call):
        return float(FUNCTIONS[_name(node)](*(_value(one, values) for one in node.args)))
    if isinstance(node, ast.BinOp):
        left, right = _value(node.left, values), _value(node.right, values)
        if isinstance(node.op, ast.Div) and right == 0:
            return math.copysign(math.inf, left) if left else math.nan
        return OPERATORS[type(node.op)](left, right)
    raise ValueError(f"{ast.dump(node)} is no part of a formula")


def _name(node: ast.Call) -> str:
    return ast.unparse(node.func)


def in_symbols(text: str) -> str:
    """A formula as it is printed.

    >>> in_symbols("A*S_y*(1 - A*S_y/(4*P_e))"), in_symbols("C*pi**2*E*I/l**2")
    ('A S_y (1 − A S_y/(4 P_e))', 'C π² E I/l²')
    """
    return _shown(_tree(text), plain_symbol, " ")


def in_numbers(text: str, values: Mapping[str, float], units: Mapping[str, str], digits: int = DIGITS) -> str:
    """A formula with its numbers and their units. digits : significant ones of every number.

    >>> in_numbers("P/A", {"P": -1200.0, "A": 8.2e-5}, {"P": "N", "A": "m^2"})
    '(−1.2 kN)/(82 mm²)'
    """

    def put_in(name: str) -> str:
        return valued(values[name], units.get(name, ""), digits)

    return _shown(_tree(text), put_in, " · ")


def plain_symbol(name: str) -> str:
    """A name as a symbol: Greek letters, and primes for rates.

    >>> plain_symbol("sigma_b"), plain_symbol("omega_dot"), plain_symbol("S_y")
    ('σ_b', 'ω′', 'S_y')
    """
    head, *rest = name.split("_")
    marks = "".join("′" for one in rest if one == "dot")
    kept = [one for one in rest if one != "dot"]
    return GREEK.get(head, head) + marks + ("_" + ",".join(kept) if kept else "")


def valued(value: float, unit: str, digits: int = DIGITS) -> str:
    """A number with its unit, as it is put into a formula.

    >>> valued(8.4559e-9, "m^4"), valued(2.5266e-4, "m/rad"), valued(7.1e10, "Pa"), valued(1.0, "")
    ('8455.9 mm⁴', '0.25266 mm/rad', '71 GPa', '1')
    """
    if unit in GEOMETRY and math.isfinite(value):
        factor, name = GEOMETRY[unit]
        text = f"{quantity(factor * value, '', digits)} {name}"
    else:
        text = quantity(value, unit, digits)
    return re.sub(r"e(-?\d+)", lambda found: f"·10{_raised(found[1])}", text).replace("-", "−")


def _raised(power: str) -> str:
    return power.translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def _shown(node: ast.expr, put: Callable[[str], str], times: str, rank: int = 0) -> str:
    """Text of a node; in brackets if it binds less than its surroundings."""
    if isinstance(node, ast.Constant):
        return ast.unparse(node)
    if isinstance(node, ast.Name):
        text = "π" if node.id == "pi" else put(node.id)
        spaced = rank >= RANK[ast.Pow] and " " in text
        return f"({text})" if spaced or (rank > 0 and text.startswith("−")) else text
    if isinstance(node, ast.UnaryOp):
        return f"−{_shown(node.operand, put, times, 3)}"
    if isinstance(node, ast.Call):
        inside = ", ".join(_shown(one, put, times) for one in node.args)
        bars = {"abs": f"|{inside}|", "sqrt": f"√({inside})"}
        return bars.get(_name(node), f"{_name(node)}({inside})")
    if isinstance(node, ast.BinOp):
        own = RANK[type(node.op)]
        if isinstance(node.op, ast.Pow):
            return _shown(node.left, put, times, own) + POWERS[_shown(node.right, put, times)]
        sign = times if isinstance(node.op, ast.Mult) else SIGNS[type(node.op)]
        after = own + (1 if isinstance(node.op, (ast.Div, ast.Sub)) else 0)
        left, right = _shown(node.left, put, times, own), _shown(node.right, put, times, after)
        if isinstance(node.op, ast.Div) and isinstance(node.right, ast.Name) and " " in right and right[0] != "(":
            right = f"({right})"  # a number with its unit below the line
        return f"({left}{sign}{right})" if own < rank else f"{left}{sign}{right}"
    raise ValueError(f"{ast.dump(node)} is no part of a formula")


# A calculation sheet: what is given, and steps that follow from it.

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
