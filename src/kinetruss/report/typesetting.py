"""The last pass over the text of a page: true minus signs, powers of ten, raised exponents, dashes for empty cells."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from kinetruss.display import element, html_page
from kinetruss.report.entries import Numbers

if TYPE_CHECKING:
    from kinetruss.report.entries import Entry


STYLE = Path(__file__).with_name("style.css")

KEPT = re.compile(r"(<(script|style|pre|code)\b.*?</\2>|<[^>]*>)", re.DOTALL)
"""Parts of a page that are not prose: elements whose text is data, and tags with their attributes."""
MINUS = re.compile(r"(?:(?<![\w.)\]-])|(?<=\d[eE]))-(?=[\d∞.])")
"""A hyphen before a number, and not within a word, a date or a name; or in the exponent of a number."""

TEN = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e(−?\d{1,3})(?![\w…]|\.\d)")
"""A number with an exponent."""
SQUARE = re.compile(r"(?<=[A-Za-z])\^(-?\d)(?!\d)")
"""A unit with an exponent."""
OHM = re.compile(r"(?<=\d)([ \u00a0][nµmkM]?)ohm\b")
RAISED = str.maketrans("−-0123456789", "⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def typeset(page: str) -> str:
    """The page with minus signs in place of hyphens before numbers, powers of ten, raised exponents of units, and Ω; model text
    and data stay as they are.

    >>> typeset("<td>-3 N</td><td>-</td><p>7e-15, EN 1999-1-1, 2026-11-21</p><code>-3</code>")
    '<td>−3 N</td><td>–</td><p>7·10⁻¹⁵, EN 1999-1-1, 2026-11-21</p><code>-3</code>'
    >>> typeset("<p>1e6 kN/m^3, 2 ohm</p>")
    '<p>1·10⁶ kN/m³, 2 Ω</p>'
    """
    parts = KEPT.split(page)
    # the pattern has two groups: text, an element or tag, its name, text, ..
    for k in range(0, len(parts), 3):
        parts[k] = "–" if parts[k] == "-" else _prose(parts[k])
    return "".join(text for k, text in enumerate(parts) if k % 3 != 2 and text is not None)


def _prose(text: str) -> str:
    text = MINUS.sub("−", text)
    text = TEN.sub(lambda found: f"{found[1]}·10{found[2].translate(RAISED)}", text)
    return OHM.sub(r"\1Ω", SQUARE.sub(lambda found: found[1].translate(RAISED), text))


def bare_page(entries: Sequence[Entry]) -> str:
    """A page of entries alone; its title is the first line of the first one."""
    title = next((one.partition("\n")[0] for one in entries if isinstance(one, str)), "kinetruss")
    main = element("main", Numbers().html(entries)[0])
    return html_page(title, f"<style>{STYLE.read_text('utf-8')}</style>\n", typeset(main))
