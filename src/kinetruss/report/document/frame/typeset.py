"""The last pass over the text of a page: true minus signs, dashes for cells without a value."""

from __future__ import annotations

import re

__all__ = ["typeset"]

KEPT = re.compile(r"(<(script|style|pre|code)\b.*?</\2>|<[^>]*>)", re.DOTALL)
"""Parts of a page that are not prose: elements whose text is data, and tags with their attributes."""
MINUS = re.compile(r"(?:(?<![\w.)\]-])|(?<=\d[eE]))-(?=[\d∞.])")
"""A hyphen before a number, and not within a word, a date or a name; or in the exponent of a number."""


def typeset(page: str) -> str:
    """The page with minus signs in place of hyphens before numbers; model text and data stay as they are.

    >>> typeset("<td>-3 N</td><td>-</td><p>7e-15, EN 1999-1-1, 2026-11-21</p><code>-3</code>")
    '<td>−3 N</td><td>–</td><p>7e−15, EN 1999-1-1, 2026-11-21</p><code>-3</code>'
    """
    parts = KEPT.split(page)
    # the pattern has two groups: text, an element or tag, its name, text, ..
    for k in range(0, len(parts), 3):
        parts[k] = "–" if parts[k] == "-" else MINUS.sub("−", parts[k])
    return "".join(text for k, text in enumerate(parts) if k % 3 != 2 and text is not None)
