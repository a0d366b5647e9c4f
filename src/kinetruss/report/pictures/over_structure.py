"""Curves over a structure on paper: areas beside members, or the deflected shape, with the largest values written."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.display import number, quantity
from kinetruss.errors import InputError
from kinetruss.report.pictures.labels import CROWDED, Label
from kinetruss.report.pictures.specs import INK, Area
from kinetruss.report.pictures.stands import projected
from kinetruss.strength.curves import curves, only, sentence
from kinetruss.viewer.moving import in_equilibrium

if TYPE_CHECKING:
    from kinetruss.runs import RunResult
    from kinetruss.strength.curves import Curves


LABELS = 40
"""Largest number of values that are written."""


def of_run(run: RunResult, show: str, case: str | None = None, sample: int = 0) -> Curves:
    """The curves of a sample of a run under a load case, by default the first.

    Raises
    ------
    InputError : a run without forces; an unknown quantity; a deflection that is not known.
    """
    if not run.forces:
        raise InputError(
            f"There is no {show}: the run has no forces. Run dynamics.inverse, statics.linear or statics.equilibrium, and see "
            "what its message says."
        )
    forces = run.forces[case] if case is not None else next(iter(run.forces.values()))
    return curves(run.model, only(forces, sample), show, from_model=in_equilibrium(run, forces.load_case))


def areas(found: Curves, factor: float, view: str = "iso") -> list[Area]:
    """The area between each member and its curve."""
    kind = "line" if found.show == "deflection" else "signed" if found.show == "N" else "plain"
    return [
        Area(base=projected(one.base, view), tips=projected(one.tips(factor), view), values=one.values, kind=kind)
        for one in found.curves
        if one.values.any()
    ]


def written(found: Curves, factor: float, view: str = "iso") -> list[Label]:
    """The largest values, at their places, the largest of all in any case."""
    at = [(abs(float(one.values[k])), one, k) for one in found.curves for k in one.extremes]
    ranked = sorted(at, key=lambda row: -row[0])[:LABELS]
    labels = []
    for place, (_, one, k) in enumerate(ranked):
        words, tip = quantity(float(one.values[k]), found.quantity.unit), projected(one.tips(factor)[k], view)
        labels.append(Label(words=words, at=tip, colour=INK, bold=place == 0, most=np.inf if place < 2 else CROWDED))
    return labels


def note(found: Sequence[Curves], factor: float) -> str:
    """The quantity, how it is signed, and how much larger than in reality deflections are drawn."""
    text = sentence(found[0])
    if not factor:
        return f"{text}; zero everywhere"
    if found[0].show == "deflection":
        text = f"{text}, drawn {number(factor)} times as large" if factor != 1.0 else f"{text}, to scale"
    return text
