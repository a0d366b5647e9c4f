"""What was gathered, as a verdict and as extremes of section forces, with the pair that governs each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.mechanics import compile
from kinetruss.model import Model
from kinetruss.results import Arrays, Status, Verdict, provenance, variable
from kinetruss.strength.envelopes.gathering import Gathering
from kinetruss.strength.members.parts import parts_of
from kinetruss.strength.verdict.beams import beam_notes, beam_parts
from kinetruss.strength.verdict.not_held import add_to_notes, not_held, screws_not_held, sentences
from kinetruss.strength.verdict.notes import beyond_euler, notes
from kinetruss.strength.verdict.utilisation import RULES, axes_of_verdict, subjects

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["extremes_of", "verdict_of"]

EXTREMES = {"tension": "N", "compression": "N", "bending": "N m"}
"""Extremes along a part: the largest axial force and its opposite, and the largest bending moment."""


def verdict_of(model: Model, found: Gathering, labels: Sequence[str], cases: Sequence[str] = ("all",)) -> Verdict:
    """The verdict of `strength.check` over all pairs; ``load_case`` is the label of the governing pair, ``pair`` its number.

    cases : their load cases. An infinite score of a stress without value is that of torsion which its section does not know.
    """
    parts = parts_of(model)
    names, members, rod, whole = subjects(parts)
    table = np.full((len(names), len(RULES), found.rods.shape[2]), np.nan)
    has_rod, has_whole = rod >= 0, whole >= 0
    table[has_rod, 0] = found.rods[3, rod[has_rod]]
    table[has_whole, 1:] = found.members[:, whole[has_whole]].swapaxes(0, 1)
    bent = np.full((found.beams.shape[1], len(RULES), table.shape[2]), np.nan)
    bent[:, 0], bent[:, 1] = found.beams[3], found.beams[1]
    bent[:, 1, 1] = np.where(bent[:, 1, 1] < 0, 0.0, bent[:, 1, 1])
    table = np.concatenate([table, bent])
    value, limit, time, position, pair = (table[:, :, k] for k in (1, 2, 3, 4, 5))
    johnson = np.nan_to_num(table[:, 1, 6]) > 0
    beyond = {k: (value[k, 2], table[k, 2, 6]) for k in np.flatnonzero(np.isposinf(table[:, 2, 0])).tolist()}
    value[list(beyond), 2] = np.inf
    utilisation = value / limit
    with np.errstate(divide="ignore"):
        margin = 1 / utilisation - 1
    bars = len(names)
    said = notes(parts, rod, whole, value[:bars, 1], johnson[:bars], "weaker", np.isposinf(found.rods[3, :, 0]))
    for k, (factored, euler) in beyond.items():
        said[k, 2] = beyond_euler(float(factored), float(euler), model.safety.buckling)
    left = not_held(model, dict.fromkeys(cases))
    add_to_notes(left, members[:bars], utilisation[:bars], said)
    said[[member in model.bars and model.bars[member].brace for member in members]] = ""
    said = np.concatenate([said, beam_notes(model, value[bars:, 0], value[bars:, 1])])
    over = ("part", "rule")
    data = {
        "value": variable(over, value, "", "demand, in the rule's unit"),
        "limit": variable(over, limit, "", "allowed, in the rule's unit"),
        "utilisation": variable(over, utilisation, "", "demand over capacity"),
        "margin": variable(over, margin, "", "1/utilisation - 1"),
        "time_of": variable(over, time, "s", "time of the worst, in the motion of its pair"),
        "position": variable(over, position, "m", "governing section, distance from end A"),
        "pair": variable(over, pair, "", "number of the governing pair"),
        "load_case": variable(over, _labelled(pair, labels), "", "governing pair: motion, condition, load case"),
        "note": variable(over, said.astype(str), "", "formula used, or why it was not checked"),
    }
    missing = [*sentences(left), *screws_not_held(model, dict.fromkeys(cases))]
    attrs = {"kind": "verdict", "not_held": missing}
    return Verdict(
        data=Arrays(axes_of_verdict(compile(model)), None, data, attrs).later,
        status=Status.COMPLETED,
        message=" ".join(missing),
        provenance=provenance(model, pairs=len(labels)),
    )


def extremes_of(model: Model, found: Gathering, labels: Sequence[str]) -> xr.Dataset:
    """Over (part, quantity): ``value`` (N, N m) of `EXTREMES`, ``time_of``, ``position``, ``pair`` and its ``label``.

    A tension or compression below zero is never reached: the other sign holds throughout.
    """
    table = np.concatenate([found.rods[: len(EXTREMES)], found.beams[: len(EXTREMES)]], axis=1).swapaxes(0, 1).copy()
    table[~np.isfinite(table[:, :, 0])] = np.nan
    over = ("part", "quantity")
    return xr.Dataset(
        {
            "value": variable(over, table[:, :, 1], "", "extreme along the part, in the quantity's unit"),
            "time_of": variable(over, table[:, :, 3], "s", "time of the extreme, in the motion of its pair"),
            "position": variable(over, table[:, :, 4], "m", "distance from end A"),
            "pair": variable(over, table[:, :, 5], "", "number of the governing pair"),
            "label": variable(over, _labelled(table[:, :, 5], labels), "", "governing pair: motion, condition, load case"),
        },
        coords={
            "part": np.array((*parts_of(model).names, *beam_parts(model)), dtype=object).astype(str),
            "quantity": list(EXTREMES),
            "unit": ("quantity", list(EXTREMES.values())),
        },
        attrs={"kind": "extremes"},
    )


def _labelled(pair: NDArray[np.float64], labels: Sequence[str]) -> NDArray[np.str_]:
    """Labels of pairs; empty where there is none."""
    every = np.array([*labels, ""], dtype=object)
    return every[np.where(np.isnan(pair), len(labels), np.nan_to_num(pair)).astype(np.int64)].astype(str)
