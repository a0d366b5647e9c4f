"""Text tables, and numbers a person can read."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

__all__ = ["number", "quantity", "table"]

PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
SCALED = ("N", "Pa", "N m", "V", "A", "W", "J", "s", "m")


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Columns of text: words to the left, numbers (judged by the first row) to the right.

    >>> print(table(("member", "force"), [("M1", "58.3 N"), ("M19", "-12.5 N")]))
    member    force
    M1       58.3 N
    M19     -12.5 N
    """
    lines = [tuple(map(str, head)), *(tuple(map(str, row)) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    right = [len(lines) > 1 and _numeric([line[i] for line in lines[1:]]) for i in range(len(head))]
    return "\n".join(
        "  ".join(cell.rjust(w) if r else cell.ljust(w) for cell, w, r in zip(line, widths, right, strict=True)).rstrip()
        for line in lines
    )


def _numeric(cells: list[str]) -> bool:
    filled = [cell for cell in cells if cell not in ("", "-")]
    return bool(filled) and all(cell[0].isdigit() or cell[0] in "+-." for cell in filled)


def number(value: float, digits: int = 4) -> str:
    """A number with some significant digits; ``-`` where there is none.

    >>> number(1234567.0), number(0.00012346), number(float("nan"))
    ('1.235e+06', '0.0001235', '-')
    """
    return f"{value:.{digits}g}" if math.isfinite(value) else "-"


def scale(largest: float, unit: str) -> tuple[float, str]:
    """Factor and unit with prefix that put `largest` between 1 and 1000.

    >>> scale(25300.0, "N")
    (0.001, 'kN')
    """
    if unit not in SCALED or not largest or not math.isfinite(largest) or abs(largest) < 1e-9:
        return 1.0, unit
    # 1e-9 keeps 999.9999999 and 1000 on the same side
    power = 3 * math.floor(math.log10(abs(largest) * (1 + 1e-9)) / 3)
    if unit in ("m", "s"):
        power = min(0, power)
    power = min(9, max(-9, power))
    return 10.0**-power, PREFIXES[power] + unit


def quantity(value: float, unit: str, digits: int = 4) -> str:
    """A value with its unit, prefixed where that reads better.

    >>> quantity(58.251, "N"), quantity(1.29414e6, "Pa"), quantity(0.0284, "N m")
    ('58.25 N', '1.294 MPa', '28.4 mN m')
    """
    if not math.isfinite(value):
        return "-"
    if abs(value) < 1e-12:  # round-off of zero
        value = 0.0
    factor, named = scale(value, unit)
    return f"{value * factor:.{digits}g} {named}".rstrip()
