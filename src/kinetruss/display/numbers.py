"""Numbers and units for people. The page of the viewer follows the same rules, with the tables of this module.

A number has four significant digits, a ratio three. Zeros at the end are omitted, and ties round away from zero. Prefixes
are those that engineers use with the unit: 28.4 mA, 12 mm/s, 500 N for 0.5 kN; mass in g, kg and t, angles in degrees,
ratios in percent. The rules for readers: docs/numbers.md.
"""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Context, Decimal

__all__ = ["FLOORS", "UNITS", "instant", "number", "quantity", "scale"]

PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def _prefixed(unit: str, least: int, most: int) -> tuple[tuple[float, str], ...]:
    """Factors and names of a unit, the smallest name first."""
    return tuple((float(f"1e{-power}"), PREFIXES[power] + unit) for power in range(least, most + 1, 3))


UNITS: dict[str, tuple[tuple[float, str], ...]] = {
    **{unit: _prefixed(unit, -9, 9) for unit in ("N", "N m", "V", "A", "W", "J")},
    **{unit: _prefixed(unit, 0, 9) for unit in ("Pa", "N/m", "N m/rad", "N s/m", "Hz")},
    **{unit: _prefixed(unit, -9, 0) for unit in ("m", "s", "m/s", "m/s²")},
    "kg": ((1e3, "g"), (1.0, "kg"), (1e-3, "t")),
    "rad": ((180 / math.pi, "deg"),),
    "%": ((100.0, "%"),),
}
"""SI unit -> (factor, name) by size; other units are shown as they are. ``%`` is the unit of a ratio: 0.873 is 87.3 %."""

FLOORS = {"Pa": 1e-6, "N/m": 1e-6, "": 1e-12}
"""Values up to this magnitude, by unit (``""``: any other), are round-off and shown as 0."""

DIGITS = {"%": 3, "": 4}
"""Significant digits by unit (``""``: any other)."""

LONG, SHORT = 10**6, -4
"""Powers of ten from which on, and below which, a number has an exponent."""


def number(value: float, digits: int = 4) -> str:
    """A number with some significant digits; ``-`` if it is not a number.

    >>> number(1234567.0), number(123456.0), number(0.00012346), number(-0.0), number(float("nan")), number(-float("inf"))
    ('1.235e6', '123456', '0.0001235', '0', '-', '-∞')
    """
    if math.isnan(value):
        return "-"
    sign = "-" if value < 0 else ""
    if math.isinf(value):
        return f"{sign}∞"
    if value == 0:
        return "0"
    exact = Decimal(abs(float(value)))
    rounded = Context(prec=digits, rounding=ROUND_HALF_UP).create_decimal(exact)
    power = rounded.adjusted()
    if power >= SHORT and rounded < LONG:
        places = Decimal(1).scaleb(-max(0, digits - 1 - power))
        return sign + _trimmed(f"{exact.quantize(places, ROUND_HALF_UP):f}")
    return f"{sign}{_trimmed(f'{rounded.scaleb(-power):f}')}e{power}"


def _trimmed(text: str) -> str:
    return text.rstrip("0").rstrip(".") if "." in text else text


def scale(largest: float, unit: str) -> tuple[float, str]:
    """Factor and name of the unit in which the largest of some values is between 1 and 1000.

    >>> scale(25300.0, "N"), scale(2500.0, "kg"), scale(0.0284, "A"), scale(1.0, "rad/s")
    ((0.001, 'kN'), (0.001, 't'), (1000.0, 'mA'), (1.0, 'rad/s'))
    """
    unit = unit.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")
    if unit not in UNITS:
        return 1.0, unit
    names, size = UNITS[unit], abs(largest)
    if not math.isfinite(size) or size < FLOORS.get(unit, FLOORS[""]):
        return next((one for one in names if one[0] == 1.0), names[0])
    # 1e-9 keeps 999.9999999 and 1000 on the same side
    return next((one for one in reversed(names) if size * one[0] * (1 + 1e-9) >= 1), names[0])


def quantity(value: float, unit: str, digits: int = 0) -> str:
    """A value given in an SI unit, as text with the display unit. digits : number of significant ones; 0: the default.

    >>> quantity(58.251, "N"), quantity(1.29414e6, "Pa"), quantity(0.0284, "N m"), quantity(2500.0, "kg"), quantity(-1e-14, "N")
    ('58.25 N', '1.294 MPa', '28.4 mN m', '2.5 t', '0 N')
    >>> quantity(0.87349, "%"), quantity(0.5, "rad"), quantity(float("nan"), "W"), quantity(float("inf"), "%")
    ('87.3 %', '28.65 deg', '-', '∞')
    """
    if not math.isfinite(value):
        return number(value)
    factor, name = scale(value, unit)
    if unit in UNITS and abs(value) < FLOORS.get(unit, FLOORS[""]):
        value = 0.0
    return f"{number(value * factor, digits or DIGITS.get(unit, DIGITS['']))} {name}".rstrip()


def instant(time: float | None) -> str:
    """A time of a history as text, always in seconds, as on the axes of pictures; ``-`` if there is none.

    >>> instant(0.025), instant(None)
    ('0.025 s', '-')
    """
    return "-" if time is None or not math.isfinite(time) else f"{number(time)} s"
