"""Formulas as text: one text is computed, printed in symbols, and printed with its numbers, so that the three agree."""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping
from functools import lru_cache

from kinetruss.display import quantity

__all__ = ["DIGITS", "evaluate", "in_numbers", "in_symbols", "plain_symbol", "valued"]

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
