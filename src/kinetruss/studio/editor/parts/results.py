"""Runs that a page has asked for, and the pages of their results."""

from __future__ import annotations

from typing import Any

from kinetruss import runs
from kinetruss.errors import InputError
from kinetruss.model import Model, nearest
from kinetruss.strength.verdict import headline
from kinetruss.viewer import page, scene

__all__ = ["Results"]

MOST = 4
"""Number of result pages that are kept; each holds a whole scene."""


MOST_VALUES = 4_000_000
"""Largest product of samples and members of a run from the page."""


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
        if model.runs[name].motion is not None or model.runs[name].analysis == "mission":
            what = "reads a file" if model.runs[name].motion is not None else "is a mission"
            raise InputError(f"{name!r} {what}. Save the model, then: kinetruss run MODEL.yaml {name}")
        if model.runs[name].samples * len(model.members) > MOST_VALUES:
            raise InputError(f"{name!r} is too long for this page: {model.runs[name].samples} samples. Take fewer samples.")
        result = runs.run(model, name)
        found = headline(result.verdict, result.demand).record
        words = [f"{len(result.motion.time)} of {result.samples} samples.", found["text"], *found["more"], result.message]
        if found["governing"] is not None:
            words.insert(2, found["governing"]["text"])
        record = {"kind": "ran", "name": name, "words": "\n".join(filter(None, words)), "number": None}
        if not len(result.motion.time):
            return record
        self.count += 1
        self.pages[self.count] = page(scene(result), title=f"{model.title or 'Drawing'}: {name}")
        for old in list(self.pages)[:-MOST]:
            del self.pages[old]
        return record | {"number": self.count}
