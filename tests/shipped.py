"""The shipped examples, each of their runs on disk: with few samples, once a test process."""

from __future__ import annotations

import re
import tempfile
from functools import cache
from pathlib import Path

import kinetruss as kt
from kinetruss.library import example_files

SAMPLES = 21

RUNS = [(name, run) for name, paths in example_files().items() for run in kt.read(paths[0]).runs]
"""Names of examples and of their runs."""

ONE_OF_EACH = list({kt.read(example_files()[name][0]).runs[run].analysis: (name, run) for name, run in reversed(RUNS)}.values())
"""One run of each analysis."""

NO_NUMBER = re.compile(r"\b(nan|NaN|undefined|Infinity|inf|None(?! of)|null)\b|\[object")
"""What no reader should meet in place of a number."""

_place = tempfile.TemporaryDirectory(prefix="kinetruss-shipped-")


@cache
def stored(name: str, run: str) -> Path:
    """The folder of a run of an example."""
    model = kt.read(example_files()[name][0])
    few = model.runs[run]
    if few.analysis not in ("statics.linear", "statics.equilibrium"):
        few = few.with_(samples=min(SAMPLES, few.samples))
    folder = Path(_place.name) / f"{name}-{run}"
    assert kt.run(model.with_(runs={**model.runs, run: few}), run, out=folder).whole
    return folder


def named(text: str) -> str:
    """What of a text stands in place of a number, with what is around it; or nothing."""
    found = NO_NUMBER.search(text)
    return "" if found is None else text[max(0, found.start() - 80) : found.end() + 40]
