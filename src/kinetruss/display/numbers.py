"""Numbers and units for people. The page of the viewer follows the same rules, with the tables of this module.

A number has four significant digits, a ratio three. Zeros at the end are omitted, and ties round away from zero. Prefixes
are those that engineers use with the unit: 28.4 mA, 12 mm/s, 500 N for 0.5 kN; mass in g, kg and t, angles in degrees,
ratios in percent. A column of a table has one unit and one number of decimals. The rules for readers: docs/numbers.md.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import ROUND_HALF_UP, Context, Decimal

__all__ = [
    "FLOORS", "UNITS", "Quantity", "aligned", "counted", "instant", "margin", "number", "quantity", "round_up", "scale",
    "ticks",
]  # fmt: skip

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

ROUND_OFF = 1e-12
"""Values below this fraction of the largest value of a column are round-off and shown as 0."""

DIGIT, POINT = "\u2007", "\u2008"
"""Spaces as wide as a digit and as a decimal point: they keep a 0 without decimals in its place."""

ENDS = (1.0, 1.2, 1.6, 2.0, 2.4, 3.2, 4.0, 4.8, 6.0, 8.0, 10.0)
"""Ends of scales: their quarters have at most two significant digits."""

FAR = 100.0
"""Margin above which only this is said."""


class Quantity(str):
    """A value as text that keeps the value, so that `aligned` can give a column one unit.

    value, unit : SI. digits : wanted. note : text after the unit; ``quantity(..) + text`` adds to it.
    """

    value: float
    unit: str
    digits: int
    note: str

    def __new__(cls, text: str, value: float, unit: str, digits: int, note: str = "") -> Quantity:  # noqa: D102 - of the class
        found = super().__new__(cls, text + note)
        found.value, found.unit, found.digits, found.note = value, unit, digits, note
        return found

    def __add__(self, note: str) -> Quantity:
        return Quantity(self.removesuffix(self.note), self.value, self.unit, self.digits, self.note + note)


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


def quantity(value: float, unit: str, digits: int = 0) -> Quantity:
    """A value given in an SI unit, as text with the display unit. digits : number of significant ones; 0: the default.

    >>> print(quantity(58.251, "N"), quantity(1.29414e6, "Pa"), quantity(0.0284, "N m"), quantity(2500.0, "kg"), sep=", ")
    58.25 N, 1.294 MPa, 28.4 mN m, 2.5 t
    >>> print(quantity(0.87349, "%"), quantity(0.5, "rad"), quantity(-1e-14, "N"), quantity(float("inf"), "%"), sep=", ")
    87.3 %, 28.65 deg, 0 N, ∞
    """
    value = float(value)
    if not math.isfinite(value):
        return Quantity(number(value), value, unit, digits)
    factor, name = scale(value, unit)
    shown = 0.0 if unit in UNITS and abs(value) < FLOORS.get(unit, FLOORS[""]) else value
    text = f"{number(shown * factor, digits or DIGITS.get(unit, DIGITS['']))} {name}".rstrip()
    return Quantity(text, value, unit, digits)


def aligned(cells: Sequence[str]) -> list[str]:
    """The cells of a column with one unit and one number of decimals, by the largest value; other columns as they are.

    Round-off of the largest value is 0, without decimals but as wide as with them. Cells that are no number stay.

    >>> aligned([quantity(1234.5, "N"), quantity(-66.2, "N"), "-"])
    ['1.234 kN', '-0.066 kN', '-']
    """
    known = [one for one in cells if isinstance(one, Quantity) and math.isfinite(one.value)]
    others = any(not isinstance(one, Quantity) and any(sign.isdigit() for sign in one) for one in cells)
    if others or len({(one.unit, one.digits) for one in known}) != 1:
        return list(cells)
    unit, digits = known[0].unit, known[0].digits
    texts, name = column([one.value for one in known], unit, digits)
    found = iter(texts)
    return [
        f"{next(found)} {name}".rstrip(" ") + one.note if isinstance(one, Quantity) and math.isfinite(one.value) else one
        for one in cells
    ]


def column(values: Sequence[float], unit: str, digits: int = 0, like: Sequence[float] = ()) -> tuple[list[str], str]:
    """Texts of the values of a column in one unit with one number of decimals, and the name of that unit. like : values of
    other columns with the same unit.

    >>> column([12.5, 0.0, 118.0], "N")
    (['12.5', '0\u2008\u2007', '118.0'], 'N')
    >>> column([1.2e-9, 3.0], ""), column([0.0313, 1.1], "%")
    ((['1.2e-9', '3'], ''), (['3.1', '110.0'], '%'))
    """
    sizes = [abs(value) for value in values if math.isfinite(value)]
    largest = max(sizes, default=0.0)
    factor, name = scale(max([largest, *(abs(value) for value in like if math.isfinite(value))]), unit)
    floor = max(FLOORS.get(unit, FLOORS[""]) if unit in UNITS else 0.0, ROUND_OFF * largest)
    top = largest * factor
    power = math.floor(math.log10(top) + 1e-9) if top > 0 else 0
    if not SHORT <= power < math.log10(LONG) or (
        name == "" and min((x for x in sizes if x > floor), default=1.0) < 10.0**SHORT
    ):
        return [number(value * factor if not abs(value) < floor else 0.0, digits or DIGITS[""]) for value in values], name
    decimals = 1 if unit == "%" and not digits else max(0, (digits or DIGITS.get(unit, DIGITS[""])) - 1 - power)
    texts = [_fixed(value * factor, decimals) for value in values if math.isfinite(value) and abs(value) >= floor]
    while decimals and not (unit == "%" and not digits) and all(text.endswith("0") for text in texts):
        decimals -= 1
        texts = [text[:-1] for text in texts]
    zero = "0" + (POINT + DIGIT * decimals if decimals else "")
    shown = [
        number(value)
        if not math.isfinite(value)
        else zero
        if abs(value) < floor or not value
        else _fixed(value * factor, decimals)
        for value in values
    ]
    return shown, name


def _fixed(value: float, decimals: int) -> str:
    """A number with some decimals, ties away from zero; never a minus in front of zeros alone."""
    text = f"{Decimal(value).quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_UP):f}"
    return text.removeprefix("-") if not text.strip("-0.") else text


def margin(value: float) -> str:
    """A margin (capacity over demand, less one) as text: two decimals, and no more than that it is large.

    >>> margin(7.9134), margin(-0.86), margin(1140.0), margin(float("inf")), margin(float("nan"))
    ('7.91', '-0.86', '> 100', '∞', '-')
    """
    if math.isfinite(value) and value > FAR:
        return f"> {FAR:g}"
    return number(value) if not math.isfinite(value) else _fixed(value, 2)


def round_up(size: float) -> float:
    """The end of a scale for values up to a size: the next number whose quarters are round.

    >>> [round_up(one) for one in (9.94, 138.0, 0.0, 2.0)]
    [10.0, 160.0, 1.0, 2.0]
    """
    if not (math.isfinite(size) and size > 0):
        return 1.0
    power = math.floor(math.log10(size))
    return next(float(f"{one:g}e{power}") for one in (*ENDS, 12.0) if float(f"{one:g}e{power}") >= size * (1 - 1e-9))


def ticks(low: float, high: float, most: int = 5) -> list[float]:
    """Round numbers between two, at most so many: multiples of 1, 2 or 5 times a power of ten.

    >>> ticks(0.0, 0.157), ticks(-0.3, 98.1, 4)
    ([0.0, 0.05, 0.1, 0.15], [0.0, 50.0])
    """
    if not (math.isfinite(low) and math.isfinite(high) and high > low):
        return [low]
    power = math.floor(math.log10((high - low) / most))
    for k in range(9):
        factor, shift = (1, 2, 5)[k % 3], power + k // 3
        step = float(f"{factor}e{shift}")
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first < most:
            return [float(f"{n * factor}e{shift}") for n in range(first, last + 1)]
    return [low]


def instant(time: float | None) -> str:
    """A time of a history as text, always in seconds, as on the axes of pictures; ``-`` if there is none.

    >>> instant(0.025), instant(None)
    ('0.025 s', '-')
    """
    return "-" if time is None or not math.isfinite(time) else f"{number(time)} s"


def moment(time: float, poses: Sequence[str]) -> str:
    """When a value is found: the name of a pose, whose time is its number, or the time.

    >>> moment(1.0, ["low", "high"]), moment(0.5, [])
    ('pose high', 't = 0.5 s')
    """
    return f"pose {poses[round(time)]}" if poses and time == time else f"t = {instant(time)}"


def counted(count: int, noun: str, several: str = "") -> str:
    """A number of things with their noun. several : the plural, if it is not the noun with an s.

    >>> counted(1, "bar"), counted(1200, "bar"), counted(2, "body", "bodies")
    ('1 bar', '1,200 bars', '2 bodies')
    """
    return f"{count:,} {noun if count == 1 else several or noun + 's'}"
