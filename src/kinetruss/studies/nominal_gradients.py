"""How results of a study change with its variables at the model as it is: exact gradients, beside what the variants say."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from kinetruss import runs
from kinetruss.errors import KinetrussError
from kinetruss.gradients import Response, value_and_gradient
from kinetruss.model import Model

STANDARD_RESPONSES = {
    "peak_utilisation": "max(utilisation)",
    "peak_member_force": "max(abs(member_force))",
    "peak_drive_force": "max(abs(drive_force))",
    "mass": "mass",
}
"""Results that a study knows by name, as responses."""


def nominal_gradients(
    model: Model, run: str, results: Mapping[str, str], paths: Mapping[str, Sequence[str]]
) -> dict[str, dict[str, float]]:
    """Result -> variable -> derivative, SI. What has none (a text, a tie, a run that `gradients` does not cover) is left out.

    results : name -> text. paths : variable -> the paths that it sets.
    """
    found: dict[str, dict[str, float]] = {}
    for name, text in results.items():
        response = Response(STANDARD_RESPONSES.get(text, text), runs.run, model, run=run)
        slopes = _slopes(response, paths)
        if slopes is None:  # one of them has none
            slopes = {}
            for one in paths:
                slopes |= _slopes(response, {one: paths[one]}) or {}
        if slopes:
            found[name] = slopes
    return found


def _slopes(response: Response, paths: Mapping[str, Sequence[str]]) -> dict[str, float] | None:
    try:
        slopes = value_and_gradient(response, [tuple(group) for group in paths.values()])[1].values.tolist()
    except KinetrussError:
        return None
    return dict(zip(paths, slopes, strict=True)) if all(map(math.isfinite, slopes)) else None
