"""The analyses whose results have gradients; what each tells of itself is imported when it is asked for."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

from kinetruss.errors import InputError
from kinetruss.model import nearest

POINTS = {
    "statics.linear": "linear_point.LinearPoint",
    "statics.equilibrium": "equilibrium_point.EquilibriumPoint",
    "statics.buckling": "buckling_point.BucklingPoint",
    "flexible.frequencies": "frequencies_point.FrequenciesPoint",
    "kinematics.follow": "along.followed",
    "dynamics.inverse": "along.inverted",
    "dynamics.simulate": "run_point.RunPoint",
    "runs.run": "along.ran",
}
"""Analysis -> its `Point`, by the file and name in this package."""


def name_of(analysis: str | Callable[..., Any]) -> str:
    """The name of an analysis in `POINTS`, from its name or function.

    Raises
    ------
    InputError : its results have no gradients.

    >>> import kinetruss as kt
    >>> name_of(kt.statics.linear)
    'statics.linear'
    """
    name = analysis if isinstance(analysis, str) else _named(analysis)
    if name not in POINTS:
        raise InputError(f"Results of {name!r} have no gradients. {nearest(name, POINTS)}")
    return name


def _named(analysis: Any) -> str:
    parts = str(getattr(analysis, "__module__", "")).split(".")
    return f"{parts[1] if len(parts) > 1 else parts[0]}.{getattr(analysis, '__name__', analysis)}"


def point_of(analysis: str | Callable[..., Any]) -> Callable[..., Any]:
    """What makes the `Point` of an analysis from a system and its arguments."""
    file, _, name = POINTS[name_of(analysis)].partition(".")
    found: Callable[..., Any] = getattr(import_module(f"kinetruss.gradients.{file}"), name)
    return found
