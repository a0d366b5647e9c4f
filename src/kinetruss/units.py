"""Text with units, converted where users give it: ``"36 in"`` -> 0.9144.

The grammar is strict: one number, one unit expression (units joined by space, ``*`` or ``/``, with integer powers).
No decimal commas, no arithmetic, no bare unit. A number without a unit is SI. ``lb`` is mass, ``lbf`` is force. Angles are a
dimension of their own, so an angular rate in Hz, or a length in degrees, is refused. Whatever `kinetruss.display` writes is
read, ``µN`` and ``m/s²`` too.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction
from functools import lru_cache
from numbers import Real
from typing import NamedTuple

from kinetruss.errors import UnitError, shown
from kinetruss.limits import LARGEST

__all__ = ["EITHER", "NUMBER", "QUANTITIES", "Tagged", "dimension_of", "parse", "shown", "text_of", "unit_of"]

Dimension = tuple[int, int, int, int, int]  # kg, m, s, A, rad

_KG, _M, _S, _A, _RAD = (tuple(int(i == j) for j in range(5)) for i in range(5))
_N = (1, 1, -2, 0, 0)
_PA = (1, -1, -2, 0, 0)
_W = (1, 2, -3, 0, 0)
_V = (1, 2, -3, -1, 0)

_ATOMS: dict[str, tuple[float, tuple[int, ...]]] = {
    "m": (1.0, _M),
    "km": (1e3, _M),
    "cm": (1e-2, _M),
    "in": (0.0254, _M),
    "ft": (0.3048, _M),
    "l": (1e-3, (0, 3, 0, 0, 0)),
    "kg": (1.0, _KG),
    "g": (1e-3, _KG),
    "t": (1e3, _KG),
    "lb": (0.45359237, _KG),
    "s": (1.0, _S),
    "min": (60.0, _S),
    "h": (3600.0, _S),
    "rad": (1.0, _RAD),
    "mrad": (1e-3, _RAD),
    "deg": (math.pi / 180, _RAD),
    "rev": (2 * math.pi, _RAD),
    "rpm": (2 * math.pi / 60, (0, 0, -1, 0, 1)),
    "Hz": (1.0, (0, 0, -1, 0, 0)),
    "N": (1.0, _N),
    "lbf": (4.4482216152605, _N),
    "Pa": (1.0, _PA),
    "bar": (1e5, _PA),
    "psi": (6894.757293168361, _PA),
    "ksi": (6894757.293168361, _PA),
    "A": (1.0, _A),
    "V": (1.0, _V),
    "ohm": (1.0, (1, 2, -3, -2, 0)),
    "kohm": (1e3, (1, 2, -3, -2, 0)),
    "H": (1.0, (1, 2, -2, -2, 0)),
    "mH": (1e-3, (1, 2, -2, -2, 0)),
    "%": (1e-2, (0, 0, 0, 0, 0)),
    "strain": (1.0, (0, 0, 0, 0, 0)),
    "microstrain": (1e-6, (0, 0, 0, 0, 0)),
    "W": (1.0, _W),
    "J": (1.0, (1, 2, -2, 0, 0)),
}
for _unit, _prefixes in {"m": "num", "s": "num", "Hz": "kMG", "Pa": "kMG", **dict.fromkeys("NVAWJ", "numkMG")}.items():
    for _prefix in _prefixes:  # no others: Mm beside mm, or mPa beside MPa, would be read where a letter was mistyped
        _power = {"n": -9, "u": -6, "m": -3, "k": 3, "M": 6, "G": 9}[_prefix]
        _ATOMS[_prefix + _unit] = (float(f"1e{_power}"), _ATOMS[_unit][1])


_MINUS = ("\N{MINUS SIGN}", "\N{EN DASH}", "\N{EM DASH}", "\N{NON-BREAKING HYPHEN}", "\N{HYPHEN}")
"""Characters that word processors put in place of a minus."""


class Quantity(NamedTuple):
    """The quantity of a field: its SI unit as shown in messages, and the accepted dimensions."""

    unit: str
    dimensions: tuple[Dimension, ...]


def _quantity(unit: str, *also: str) -> Quantity:
    return Quantity(unit, tuple(_expression(text)[1] for text in (unit, *also)))


class Tagged(float):
    """A float with the quantity that its text had (``length``, ``angle``), or None for a bare number."""

    quantity: str | None
    """``length``, ``angle``; of a measure of another kind its SI unit."""

    def __new__(cls, value: float, quantity: str | None = None) -> Tagged:
        """A tagged copy of `value`."""
        new = super().__new__(cls, value)
        new.quantity = quantity
        return new


NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_FACTOR = re.compile(r"([A-Za-z]+|%)(?:(?:\^|\*\*)(-?\d))?", re.ASCII)
_PLAIN = str.maketrans({"µ": "u", "μ": "u", "²": "^2", "³": "^3", "⁴": "^4"})
_NOT_FINITE = re.compile(r"[+-]?\.?(?:nan|inf(?:inity)?)\b.*", re.IGNORECASE)
_LONGEST = 80  # characters; longer text is not a quantity, and is cut in messages

# common spellings, and those used here
_SPELLINGS = {
    "inch": "in",
    "inches": "in",
    '"': "in",
    "feet": "ft",
    "foot": "ft",
    "meter": "m",
    "metre": "m",
    "micron": "um",
    "lbs": "lb",
    "pound": "lb",
    "lbm": "lb",
    "kgs": "kg",
    "sec": "s",
    "second": "s",
    "seconds": "s",
    "hr": "h",
    "hour": "h",
    "minute": "min",
    "degree": "deg",
    "degrees": "deg",
    "°": "deg",
    "radian": "rad",
    "radians": "rad",
    "rps": "rev/s",
    "turn": "rev",
    "Nm": "N m",
    "NM": "N m",
    "Nmm": "N mm",
    "lbs/in^3": "lb/in^3",
    "Ω": "ohm",
    "Ohm": "ohm",
    "kΩ": "kohm",
    "Volt": "V",
    "Amp": "A",
    "amp": "A",
    "GPA": "GPa",
    "L": "l",
}


@lru_cache(maxsize=1024)
def _expression(text: str) -> tuple[float, Dimension]:
    """Factor to SI and dimension of a unit expression; a UnitError names an unknown part."""
    scale, dimension, power = 1.0, [0] * 5, 1
    factor_due = True
    # '**' is a power, not two products
    for part in re.split(r"(\s*/\s*|\s*(?<!\*)\*(?!\*)\s*|\s*·\s*|\s+)", text.strip()):
        operator = part.strip()
        if operator in ("", "/", "*", "·"):
            if factor_due and part:
                raise UnitError(f"{part.strip()!r} stands where a unit is due.")
            power, factor_due = (-1 if operator == "/" else 1), True
            continue
        match = _FACTOR.fullmatch(part.translate(_PLAIN))
        if match is None or match[1] not in _ATOMS:
            raise UnitError(f"{part!r} is not a unit known here. {_spelling(part)}".rstrip())
        factor, base = _ATOMS[match[1]]
        exponent = power * int(match[2] or 1)
        scale *= factor**exponent
        dimension = [d + exponent * b for d, b in zip(dimension, base, strict=True)]
        factor_due = False
    if factor_due:
        raise UnitError("a unit is due at its end.")
    kg, m, s, A, rad = dimension
    return scale, (kg, m, s, A, rad)


def _spelling(part: str) -> str:
    """A suggestion for an unknown unit, or nothing."""
    name = re.split(r"[\^*]", part)[0]
    if (meant := _SPELLINGS.get(part) or _SPELLINGS.get(name)) is None:
        meant = next((atom for atom in _ATOMS if atom != name and atom.lower() == name.lower()), None)
    return f"Write {meant!r}." if meant else ""


QUANTITIES: dict[str, Quantity] = {
    "length": _quantity("m"),
    "mass": _quantity("kg"),
    "time": _quantity("s"),
    "angle": _quantity("rad"),
    "area": _quantity("m^2"),
    "second moment of area": _quantity("m^4"),
    "density": _quantity("kg/m^3"),
    "stress": _quantity("Pa", "N/m^2"),
    "pressure": _quantity("Pa", "N/m^2"),
    "volume flow": _quantity("m^3/s"),
    "flow per pressure": _quantity("m^3/s/Pa"),
    "force": _quantity("N"),
    "force per length": _quantity("N/m"),
    "torque": _quantity("N m", "N m/rad"),
    "moment per length": _quantity("N m/m"),
    "acceleration": _quantity("m/s^2"),
    "angular acceleration": _quantity("rad/s^2"),
    "speed": _quantity("m/s"),
    "velocity": _quantity("m/s"),
    "stiffness": _quantity("N/m"),
    "damping constant": _quantity("N s/m"),
    "rotary friction": _quantity("N m s", "N m s/rad"),
    "angular rate": _quantity("rad/s"),
    "moment of inertia": _quantity("kg m^2"),
    "resistance": _quantity("ohm"),
    "inductance": _quantity("H"),
    "voltage": _quantity("V"),
    "current": _quantity("A"),
    "torque constant": _quantity("N m/A"),
    "transconductance": _quantity("A/V"),
    "back-emf constant": _quantity("V s/rad", "V s"),
    "lead": _quantity("m/rad"),
    "number": Quantity("", ((0, 0, 0, 0, 0),)),
    "factor": Quantity("", ((0, 0, 0, 0, 0),)),
    "strain": _quantity("strain"),
    "coordinate": _quantity("m", "rad"),
    "rate": _quantity("m/s", "rad/s"),
    "second rate": _quantity("m/s^2", "rad/s^2"),
    "spring stiffness": _quantity("N/m", "N m/rad", "N m"),
    "spring damping": _quantity("N s/m", "N m s/rad", "N m s"),
    "force or moment": _quantity("N", "N m"),
    "contact damping": _quantity("s/m", "s/rad"),
    "measure": _quantity("m", "rad"),
}


EITHER = {
    "coordinate": "m, or rad",
    "rate": "m/s, or rad/s",
    "second rate": "m/s^2, or rad/s^2",
    "spring stiffness": "N/m, or N m/rad",
    "spring damping": "N s/m, or N m s/rad",
    "force or moment": "N, or N m",
    "contact damping": "s/m, or s/rad",
    "measure": "m, or rad, or the unit of what is measured",
}
"""Quantities of a length or of an angle: the first of their dimensions is that of a length. A measure may have any other."""


def unit_of(quantity: str) -> str:
    """SI unit of a quantity, as text (empty for a plain number).

    >>> import kinetruss as kt
    >>> kt.units.unit_of("length"), kt.units.unit_of("torque"), kt.units.unit_of("number")
    ('m', 'N m', '')
    """
    return QUANTITIES[quantity].unit


def dimension_of(text: str) -> Dimension:
    """Exponents of kg, m, s, A and rad in a unit.

    >>> dimension_of("W")
    (1, 2, -3, 0, 0)
    """
    return _expression(text)[1] if text else (0, 0, 0, 0, 0)


Power = int | Fraction
_NAMED: dict[tuple[Power, Power, Power, Power], str] = {
    (1, 2, -3, 0): "W", (1, -1, -2, 0): "Pa", (1, 0, 0, 0): "kg", (1, 2, -3, -1): "V", (1, 2, -3, -2): "ohm",
}  # fmt: skip
"""Units that have a name of their own, by exponents of kg, m, s and A."""


def text_of(mass: Power, length: Power, time: Power, current: Power = 0, turn: Power = 0) -> str:
    """The SI unit kg^mass m^length s^time A^current rad^turn as text, forces in N; empty for a plain number. Radians of a
    length or a force are none: r times an angle is in m.

    >>> text_of(1, 1, -2), text_of(1, 2, -3), text_of(0, 1, -1), text_of(0, -1, 0, turn=1), text_of(1, 2, -3, -1)
    ('N', 'W', 'm/s', 'rad/m', 'V')
    """
    turn = turn if turn < 0 or not (mass or length) or length < 0 else 0
    if not turn and (mass, length, time, current) in _NAMED:
        return _NAMED[mass, length, time, current]
    parts = [("N", mass), ("m", length - mass), ("rad", turn), ("s", time + 2 * mass), ("A", current)]
    above = [_to_power(name, p) for name, p in parts if p > 0]
    below = [_to_power(name, -p) for name, p in parts if p < 0]
    return "/".join([" ".join(above) or ("1" if below else ""), *below])


def _to_power(name: str, power: Power) -> str:
    return name if power == 1 else f"{name}^{float(power):g}"


def parse(value: object, quantity: str) -> float:
    """A number in SI from a number (already SI) or a text ``number unit``.

    Parameters
    ----------
    value : a real number, or text such as ``"2.5 kN"``, ``"1e3"``, ``"10 deg"``.
    quantity : a key of `QUANTITIES`, e.g. ``"length"``.

    Returns
    -------
    float, in the quantity's SI unit; of quantities that lengths and angles have, as ``"coordinate"``, a `Tagged` one.

    Raises
    ------
    UnitError : not a number and unit, an unknown unit, a unit of another quantity, not finite, beyond `limits.LARGEST`.

    Examples
    --------
    >>> round(parse("36 in", "length"), 6)
    0.9144
    >>> parse("5 lb", "force")
    Traceback (most recent call last):
    ...
    kinetruss.errors.UnitError: '5 lb' is not a force (N). Write lbf for a force: lb is a mass.
    """
    tagged = quantity in EITHER
    if tagged and isinstance(value, Tagged):
        return value if abs(value) <= LARGEST else _bounded(value, quantity, value)
    if isinstance(value, bool) or not isinstance(value, (Real, str)):
        raise UnitError(f"{shown(value)} is not {_a(quantity)}. {_example(quantity)}")
    if isinstance(value, str):
        return _parse_text(value, quantity)
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    number = _bounded(number, quantity, value)
    return Tagged(number) if tagged else number


def _bounded(number: float, quantity: str, given: object) -> float:
    """The number; UnitError if it is not finite, or so large that powers of it overflow."""
    if not math.isfinite(number):
        raise UnitError(f"{shown(given)} is not a finite {quantity}. Give a finite number.")
    unit = f" {unit_of(quantity)}".rstrip()
    if abs(number) > LARGEST:
        raise UnitError(f"{shown(given)} is beyond what is computed with. Give at most {LARGEST:g}{unit}.")
    return number


def _parse_text(text: str, quantity: str) -> float:
    match = NUMBER.match(text.strip()) if len(text) <= _LONGEST else None
    if match is None:
        if _NOT_FINITE.fullmatch(text.strip()):
            raise UnitError(f"{shown(text)} is not a finite {quantity}. Give a finite number.")
        if text.strip()[:1] in _MINUS and NUMBER.match(plain := "-" + text.strip()[1:]):
            raise UnitError(f"{shown(text)} is not {_a(quantity)}: its minus is another character. Write {shown(plain)}.")
        raise UnitError(f"{shown(text)} is not {_a(quantity)}: no number in front. {_example(quantity)}")
    number, unit = float(match[0]), text.strip()[match.end() :].strip()
    if unit.startswith(","):
        raise UnitError(f"{text!r} is not {_a(quantity)}: a comma in the number. {_comma(text)}")
    if not unit:
        number = _bounded(number, quantity, text)
        return Tagged(number) if quantity in EITHER else number
    try:
        factor, dimension = _expression(unit)
    except UnitError as error:
        mend = "" if "Write" in str(error) else f" {_example(quantity)}"
        raise UnitError(f"{text!r} is not {_a(quantity)}: {error}{mend}") from None
    if dimension not in (known := QUANTITIES[quantity].dimensions) and quantity != "measure":
        if quantity == "factor":
            written = f"Write it in SI units ({text_of(*dimension)}), as a bare number: '{number * factor:.12g}'."
            raise UnitError(f"{text!r} is not {_a(_named(quantity))}. {written}")
        raise UnitError(f"{text!r} is not {_a(_named(quantity))}. {_hint(unit, quantity)}")
    number = _bounded(number * factor, quantity, text)
    if quantity not in EITHER:
        return number
    if dimension in known:
        return Tagged(number, "length" if dimension == known[0] else "angle")
    return Tagged(number, text_of(*dimension))


def _comma(text: str) -> str:
    pointed = text.replace(",", ".").strip()
    if text.count(",") == 1 and "." not in text:
        return f"Write a decimal point: {pointed!r}."
    return "Write a decimal point, and no commas between thousands."


def _named(quantity: str) -> str:
    unit = EITHER.get(quantity) or unit_of(quantity)
    return f"{quantity} ({unit})" if unit else f"{quantity} without unit"


def _hint(unit: str, quantity: str) -> str:
    for given, meant, what in (("lb", "lbf", "mass"), ("lbf", "lb", "force")):
        swapped = re.sub(rf"\b{given}\b", meant, unit)
        if swapped != unit and _expression(swapped)[1] in QUANTITIES[quantity].dimensions:
            return f"Write {swapped} for {_a(quantity)}: {given} is a {what}."
    if quantity == "angular rate" and unit.endswith("Hz"):
        return "Write rad/s, deg/s, rev/s or rpm."
    return _example(quantity)


def _a(noun: str) -> str:
    return f"{'an' if noun[0] in 'aei' else 'a'} {noun}"


def _example(quantity: str) -> str:
    unit = unit_of(quantity)
    if quantity == "lead":
        return "Write for example '5 mm/rev'; a bare number is in m/rad."
    return f"Write for example '1.5 {unit}', or a bare number in SI." if unit else "Write a bare number, e.g. 1.5."
