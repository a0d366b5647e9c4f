"""The envelope of many motions and load cases, kept while they pass, and its verdict."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.display.ranks import place_of_largest
from kinetruss.kernels.sections.envelope import BEAM_COLUMN, BUCKLING, COLUMNS, YIELD, Kept, Rules, envelope
from kinetruss.mechanics import System, cached, compile
from kinetruss.model import Model
from kinetruss.results import Arrays, Forces, Status, Verdict, provenance, variable
from kinetruss.strength.beam_verdict import BEAM_QUANTITIES, beam_histories, beam_limits, beam_parts
from kinetruss.strength.critical_loads import end_condition
from kinetruss.strength.link_columns import columns_of
from kinetruss.strength.parts import histories, parts_of
from kinetruss.strength.utilisations import RULES, axes_of_verdict, subjects, twisting, utilised
from kinetruss.strength.verdict import NOTHING, told

if TYPE_CHECKING:
    from numpy.typing import NDArray


JUDGED = {"stress": YIELD, "compression": BUCKLING, "combined": BEAM_COLUMN}
"""Quantities of beams and links that have limits, and the rules of these."""


class Gathering:
    """The envelope of a model over pairs; ``rods`` (tension, compression, bending, stress; parts; columns) and
    ``members`` (buckling, beam-column; members; columns), see `kernels.sections.envelope`; ``beams`` (quantities of
    `beam_histories`; beams; columns). In ``top``, which tells parts by their number, beams follow the parts.
    """

    def __init__(self, model: Model) -> None:
        parts = parts_of(model)
        self._parts = {name: k for k, name in enumerate(parts.names)}
        self._members = {name: k for k, name in enumerate(model.whole.real_members)}
        self.rods = np.full((4, len(self._parts), COLUMNS), np.nan)
        self.members = np.full((2, len(self._members), COLUMNS), np.nan)
        self._beams = {name: k for k, name in enumerate(beam_parts(model))}
        self.part_names, self.member_names = (*parts.names, *self._beams), (*self._members, *self._beams)
        self.beams = np.full((len(BEAM_QUANTITIES), len(self._beams), COLUMNS), np.nan)
        self.beams[:, :, 0] = -math.inf
        self.rods[:3, :, 0] = -math.inf  # a tension may be negative, a bending moment zero
        self.rods[3, :, 0] = self.members[:, :, 0] = -1.0
        self.top = np.zeros(4)

    def begin(self) -> None:
        """A new pair begins: its highest utilisation is not known."""
        self.top[:] = -1.0, -1, YIELD, np.nan

    def add(self, model: Model, forces: Forces, pair: int) -> None:
        """Take forces of a pair into account; model : the same, or with members taken out."""
        given, times = histories(model, forces), forces.arrays["time"].values
        if not len(times):
            return
        twist, before = twisting(model, forces), self.top.copy()
        ends = np.ascontiguousarray(forces.arrays["end_force"].values[:, : len(model.whole.real_members)])
        tension, compression, bending, stress = self.rods
        buckling, combined = self.members
        found = Kept(tension, compression, bending, stress, buckling, combined, self.top)
        envelope(self._rules(model), given.members, given.histories, ends, times, given.allocate(1), found, float(pair))
        if twist is not None:
            self.top[:] = before
            self._twist(model, forces, np.flatnonzero(twist.any(axis=0)), float(pair))
        if self._beams:
            self._bend(model, forces, times, float(pair))

    def _twist(self, model: Model, forces: Forces, twisted: NDArray[np.int64], pair: float) -> None:
        """Take the torsion of parts into account, which the kernel does not know, by the rules of `utilisation` themselves."""
        found, parts, times = utilised(model, forces).columns, parts_of(model), forces.arrays["time"].values
        names, members, rod, _ = subjects(parts)
        value, limit, used, place = (found[name].values for name in ("value", "limit", "utilisation", "position"))
        used = np.where(np.isinf(used), np.nan, used)  # a beam-column beyond Euler's load: its buckling is the number
        for r in twisted:
            i, row = int(np.flatnonzero(rod == r)[0]), self.rods[3, self._parts[parts.names[r]]]
            if np.isnan(value[:, i, 0]).any():  # a section that does not know this stress: no number of any pair will do
                row[:] = math.inf, *[math.nan] * (COLUMNS - 1)
                continue
            score = value[:, i, 0] if math.isnan(limit[0, i, 0]) else used[:, i, 0]
            at = place_of_largest(score)
            if score[at] > row[0]:
                row[:] = score[at], value[at, i, 0], limit[at, i, 0], times[at], place[at, i, 0], pair, 0.0
        for i, (name, member) in enumerate(zip(names, members, strict=True)):
            for column, rule in enumerate((YIELD, BUCKLING, BEAM_COLUMN)):
                if np.isnan(used[:, i, column]).all():
                    continue
                at = place_of_largest(used[:, i, column])
                if used[at, i, column] > self.top[0]:
                    own = self._parts[name] if rule == YIELD else self._members[member]
                    self.top[:] = used[at, i, column], own, rule, times[at]

    def _bend(self, model: Model, forces: Forces, times: NDArray[np.float64], pair: float) -> None:
        """Take beams into account."""
        allowed, length = beam_limits(model)
        column = columns_of(compile(model)).critical / model.safety.buckling
        limits = {"stress": allowed, "compression": column, "combined": np.ones(len(column))}
        found = beam_histories(model, forces)
        for row, (what, (values, place)) in zip(self.beams, found.items(), strict=True):
            for k, name in enumerate(beam_parts(model)):
                if np.isnan(values[:, k]).all():
                    continue
                at, own = place_of_largest(values[:, k]), self._beams[name]
                limit = float(limits[what][k]) if what in limits else math.nan
                score = values[at, k] if math.isnan(limit) else values[at, k] / limit
                if score > row[own, 0]:
                    row[own] = score, values[at, k], limit, times[at], place[at, k] * length[k], pair, 0.0
                # beyond Euler's load the buckling is the number
                if not math.isnan(limit) and math.isfinite(score) and score > self.top[0]:
                    before = self._parts if JUDGED[what] == YIELD else self._members
                    self.top[:] = score, len(before) + own, JUDGED[what], times[at]

    def _rules(self, model: Model) -> Rules:
        parts = parts_of(model)
        own_part = np.array([self._parts[name] for name in parts.names], np.int64)
        own_member = np.array([self._members[name] for name in model.whole.real_members], np.int64)
        return _rules(compile(model)).with_(own_part=own_part, own_member=own_member)


@cached()
def _rules(system: System) -> Rules:
    """What sections and materials of a model allow; the places where it is kept are those of the model itself."""
    model, parts = system.model, parts_of(system.given)
    C = np.array([end_condition(member.buckling) for member in model.real_members.values()])[parts.member]
    stiff = math.pi**2 * C * parts.E
    return Rules.of(
        {
            "n_buckling": model.safety.buckling,
            "moment_factor": 1.0,
            "shape": parts.shape,
            "first": parts.first,
            "two": parts.two,
            "cable": parts.cable,
            "own_part": np.arange(len(parts.names)),
            "own_member": np.arange(len(parts.first)),
            "scale": parts.scale,
            "strength": parts.yield_strength / model.safety.yielding,
            "fibre": np.stack([parts.c3 / parts.I2, parts.c2 / parts.I3], axis=1),
            "stiff": np.stack([stiff * parts.I2, stiff * parts.I3], axis=1),
            "squash": parts.area * parts.yield_strength,
            "span": parts.length,
        }
    )


# What was gathered, as a verdict and as extremes of section forces, with the pair that governs each.

_COLUMNS = {
    "value": ("", "demand, in the rule's unit"),
    "limit": ("", "allowed, in the rule's unit"),
    "utilisation": ("", "demand over capacity"),
    "margin": ("", "1/utilisation - 1"),
    "time_of": ("s", "time of the worst, in the motion of its pair"),
    "position": ("m", "governing section, distance from end A"),
    "pair": ("", "number of the governing pair"),
    "load_case": ("", "governing pair: motion, condition, load case"),
}

EXTREMES = {"tension": "N", "compression": "N", "bending": "N m"}
"""Extremes along a part: the largest axial force and its opposite, and the largest bending moment."""


def verdict_of(model: Model, found: Gathering, labels: Sequence[str], cases: Sequence[str] = ("all",)) -> Verdict:
    """The verdict of `strength.check` over all pairs; ``load_case`` is the label of the governing pair, ``pair`` its number.

    cases : their load cases. An infinite score of a stress without value is that of torsion which its section does not know.
    """
    _, _, rod, whole = subjects(parts_of(model))
    bars, has_rod, has_whole = len(rod), rod >= 0, whole >= 0
    table = np.full((bars + found.beams.shape[1], len(RULES), found.rods.shape[2]), np.nan)
    table[:bars][has_rod, 0] = found.rods[3, rod[has_rod]]
    table[:bars][has_whole, 1:] = found.members[:, whole[has_whole]].swapaxes(0, 1)
    for rule, quantity in enumerate((3, 1, 4)):
        table[bars:, rule] = found.beams[quantity]
    table[bars:, 1, 1] = np.where(table[bars:, 1, 1] < 0, 0.0, table[bars:, 1, 1])
    worst = np.full(table.shape[:2], NOTHING)
    for key, column in (("value", 1), ("limit", 2), ("time_of", 3), ("position", 4), ("factored", 1), ("euler", 6)):
        worst[key] = table[:, :, column]
    worst["factored"][bars:, 2] = model.safety.buckling * table[bars:, 1, 1]
    worst["euler"][bars:, 2] = columns_of(compile(model)).euler.min(axis=1)
    worst["value"][np.isposinf(table[:, 2, 0]), 2] = np.inf
    worst["utilisation"] = worst["value"] / worst["limit"]
    worst["johnson"] = np.nan_to_num(table[:, :, 6]) > 0
    worst["case"] = np.nan_to_num(table[:, :, 5], nan=-1)
    untold = np.isposinf(found.rods[3, :, 0])
    data, missing = told(model, worst, _COLUMNS, labels, list(dict.fromkeys(cases)), untold)
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
