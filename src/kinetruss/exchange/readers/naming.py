"""Names that a model can have, made from names of another program."""

from __future__ import annotations

import re

from kinetruss.errors import shown
from kinetruss.exchange.robots import LeftOut

__all__ = ["Names"]

_ALLOWED = re.compile(r"[^\w.:+-]+")
LONGEST = 100


class Names:
    """Gives each name of a file one that is allowed and not in use; `renamed` lists those that had to change."""

    def __init__(self) -> None:
        self._taken: dict[str, set[str]] = {}
        self.renamed: list[LeftOut] = []

    def of(self, name: str, where: str, table: str = "link") -> str:
        """A new name in a table; ``ground`` is that of the fixed frame."""
        taken = self._taken.setdefault(table, {"ground"})
        found = base = (_ALLOWED.sub("_", name).strip("_") or table)[:LONGEST]
        count = 1
        while found in taken:
            count += 1
            found = f"{base}_{count}"
        taken.add(found)
        if found != name:
            self.renamed.append(LeftOut("name", where, f"{shown(name)} is called {found!r}"))
        return found
