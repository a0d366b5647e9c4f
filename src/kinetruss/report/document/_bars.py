"""Bars in table cells, as small drawings."""

from __future__ import annotations

from kinetruss.display import Markup

__all__ = ["bar", "span_bar"]

THIN = 0.6
"""Smallest width of a mark; a bar has 100."""
LIMIT = 1.0
"""Utilisation at the limit."""
ROUND_OFF = 1e-9
"""Excess over the limit that counts as none."""


def bar(share: float, most: float = LIMIT) -> Markup:
    """A horizontal bar of a utilisation on an axis from 0 to `most`, with a mark at the limit; above it in another colour."""
    width = 100 * min(max(share, 0.0), most) / most
    kind = "over" if share > LIMIT + ROUND_OFF else "used"
    mark = f'<rect class="limit" x="{100 * LIMIT / most - 1:.2f}" y="0" width="1" height="10"/>'
    return _drawing(f'<rect class="{kind}" x="0" y="2" width="{width:.2f}" height="6"/>{mark}')


def span_bar(low: float, high: float, least: float, most: float) -> Markup:
    """A bar from `low` to `high` on an axis from `least` to `most`, with a mark at zero: compression and tension in two
    colours.

    A very small range is still drawn with a visible width.
    """
    reach = most - least or 1.0
    begin, zero, end = (100 * (value - least) / reach for value in (low, 0.0, high))
    parts = []
    for kind, there, left, right in (
        ("compression", low < 0, begin, min(zero, end)),
        ("tension", high > 0, max(zero, begin), end),
    ):
        if there:
            width = max(right - left, THIN)
            parts.append(f'<rect class="{kind}" x="{min(left, 100 - width):.2f}" y="2" width="{width:.2f}" height="6"/>')
    mark = min(max(zero - THIN / 2, 0.0), 100 - THIN)
    return _drawing("".join(parts) + f'<rect class="zero" x="{mark:.2f}" y="0" width="{THIN}" height="10"/>')


def _drawing(inside: str) -> Markup:
    return Markup(f'<svg class="bar" viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true">{inside}</svg>')
