"""Numbers of figures and tables, and the sentence of a section that refers to them."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kinetruss.display import Markup, element, joined

__all__ = ["Numbers", "referred"]

FIGURE = re.compile(r'<figure class="(table|picture)([^"]*)">(.*?)</figure>', re.DOTALL)
WORDS = {"table": "Table", "picture": "Figure"}


class Numbers:
    """Counts the figures and tables of a document in their order."""

    def __init__(self) -> None:
        self.count = {"table": 0, "picture": 0}

    def numbered(self, inside: Markup) -> tuple[Markup, list[tuple[str, int]]]:
        """The content with numbers before its captions, and the kinds and numbers in it."""
        found: list[tuple[str, int]] = []

        def marked(match: re.Match[str]) -> str:
            kind, more, body = match.groups()
            self.count[kind] += 1
            found.append((kind, self.count[kind]))
            label = f'<span class="label">{WORDS[kind]} {self.count[kind]}. </span>'
            body = body.replace("<figcaption>", f"<figcaption>{label}", 1)
            return f'<figure class="{kind}{more}" id="{kind}-{self.count[kind]}">{body}</figure>'

        return Markup(FIGURE.sub(marked, inside)), found


def referred(found: Sequence[tuple[str, int]]) -> Markup:
    """Links to the figures and tables of a section: "Tables 2 to 4; Figure 1"; empty if there are none."""
    groups = []
    for kind, word in WORDS.items():
        numbers = [number for one, number in found if one == kind]
        if not numbers:
            continue
        first, last = (element("a", str(number), href=f"#{kind}-{number}") for number in (numbers[0], numbers[-1]))
        if len(numbers) == 1:
            groups.append(joined([f"{word} ", first]))
        else:
            groups.append(joined([f"{word}s ", first, " and " if len(numbers) == 2 else " to ", last]))
    return Markup("; ".join(groups))
