"""The curves of one result as SVG: for notebooks, which show a result without its run."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import scale
from kinetruss.report.pictures.specs import Histories, Panel

if TYPE_CHECKING:
    from kinetruss.results import Result

__all__ = ["histories_svg"]

SHOWN = {
    "member_force": "member force",
    "drive_force": "drive force",
    "drive_position": "drive position",
    "position": "position",
    "utilisation": "utilisation",
    "current": "current",
}
"""Histories that a result is drawn by -> their words; the first that it has, and drives below members."""
CURVES = 6


def histories_svg(result: Result) -> str | None:
    """The most important histories of a result as an SVG picture; None without histories.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.mechanisms.four_bar()
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"motor": 1.0}, duration=0.5), samples=3)
    >>> histories_svg(motion)[:5]
    '<?xml'
    """
    data = result.arrays
    time = data["time"].values if "time" in data else np.zeros(0)
    if len(time) < 2 or "pose" in data:
        return None
    panels = tuple(panel for name in SHOWN if (panel := _panel(result, name)) is not None)[:2]
    if not panels:
        return None
    from kinetruss.report.pictures.draw import draw

    held = io.StringIO()
    figure = draw(Histories(name="histories", title="", time=time, panels=panels))
    figure.savefig(held, format="svg", metadata={"Date": None})
    return held.getvalue()


def _panel(result: Result, name: str) -> Panel | None:
    """The curves with the largest values of one quantity; None if the result does not have it along time."""
    if name not in result.arrays or result.arrays[name].dims[:1] != ("time",) or not result.arrays[name].values.size:
        return None
    from kinetruss.results.records import flat, labels, units_of

    array: Any = result.data[name]
    values = np.asarray(flat(array), float)
    size = np.nan_to_num(np.abs(values)).max(axis=0)
    moving = np.ptp(np.nan_to_num(values), axis=0) > 0 if name == "position" else size > 0
    if not moving.any():
        return None
    chosen = sorted(np.argsort(-np.where(moving, size, -1))[: min(CURVES, int(moving.sum()))])
    own = list(units_of(array))
    # of drives with other units, those of the first
    chosen = [k for k in chosen if own[k] == own[chosen[0]]]
    factor, unit = scale(float(size[chosen].max()), own[chosen[0]])
    names = list(labels(array))
    return Panel(quantity=SHOWN[name], unit=unit, lines={" ".join(names[k]): factor * values[:, k] for k in chosen})
