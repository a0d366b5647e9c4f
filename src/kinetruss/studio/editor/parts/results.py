"""Runs that a page has asked for, and the pages of their results."""

from __future__ import annotations

from typing import Any

from kinetruss import runs
from kinetruss.errors import InputError
from kinetruss.model import Model, nearest
from kinetruss.viewer import page, scene

__all__ = ["Results"]

MOST = 4
"""Number of result pages that are kept; each holds a whole scene."""


class Results:
    """Pages of the last runs, by number."""

    def __init__(self) -> None:
        self.pages: dict[int, str] = {}
        self.count = 0

    def run(self, model: Model, name: str) -> dict[str, Any]:
        """Do a run and keep its page.

        Raises
        ------
        InputError : no such run, or it cannot start.
        """
        if name not in model.runs:
            raise InputError(f"No run called {name!r}. {nearest(name, model.runs)}")
        result = runs.run(model, name)
        words = "\n".join(str(result).splitlines()[:6])
        record = {"kind": "ran", "name": name, "words": words, "number": None}
        if getattr(result, "motion", None) is None:
            return record
        self.count += 1
        self.pages[self.count] = page(scene(result), title=f"{model.title or 'Drawing'}: {name}")
        for old in list(self.pages)[:-MOST]:
            del self.pages[old]
        return record | {"number": self.count}
