"""Straight links as columns: critical load over their whole length, and compression with bending."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from kinetruss.mechanics import System, cached
from kinetruss.model import Link
from kinetruss.model.links import column_ends, is_straight
from kinetruss.strength.beam_spans import spans_of
from kinetruss.strength.critical_loads import amplification, critical_load, euler_load

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model


@dataclass(frozen=True, kw_only=True, eq=False)
class Columns:
    """Of the beams and links of a verdict: ends (names), the end condition, empty of what is no column; critical (n,) N, with
    Johnson's load where `johnson` (n,); euler (n, 2) N, Euler's loads and moment (n, 2) N m, allowed, about axes 2 and 3; round
    (n,) sections, which bend about the resultant.
    """

    ends: tuple[str, ...]
    critical: NDArray[np.float64]
    johnson: NDArray[np.bool_]
    euler: NDArray[np.float64]
    moment: NDArray[np.float64]
    round: NDArray[np.bool_]

    def combined(self, k: int, push: NDArray[np.float64], moments: NDArray[np.float64], safety: float) -> NDArray[np.float64]:
        """n P/P_cr + sum M/((1 - n P/P_e) M_allow) of column k under its largest compression (times,), N, with the moments
        (times, stations, axes), N m, of its sections; (times, stations), 0 without compression.
        """
        P = np.where(push < 0, 0.0, push)[:, None]
        euler, allowed = (one[k, -moments.shape[-1] :] for one in (self.euler, self.moment))
        bent = np.abs(moments)
        if self.round[k]:
            bent, euler, allowed = np.linalg.norm(bent, axis=-1, keepdims=True), euler[-1:], allowed[-1:]
        more = amplification(P[..., None], euler, safety=safety)
        # beyond Euler's load the moments that any imbalance makes have no bound, and none need act yet
        bending = np.where(np.isinf(more), np.inf, np.where(np.isinf(more), 0.0, more) * bent / allowed)
        found = safety * P / self.critical[k] + bending.sum(axis=-1)
        return np.where(P > 0, found, np.where(np.isnan(P) | ~np.isfinite(self.critical[k]), np.nan, 0.0))


@cached()
def columns_of(system: System) -> Columns:
    """The columns among the beams and links of a model."""
    model: Model = system.given
    spans = spans_of(system)
    rows = [_column(model, name, one, total) for name, one, total in zip(spans.names, spans.records, spans.total, strict=True)]
    rows += [NONE] * len(spans.bare)
    ends, *values = zip(*rows, strict=True) if rows else ((),) * 6
    critical, johnson, euler, moment, round_ = (np.array(one, float) for one in values)
    return Columns(
        ends=cast("tuple[str, ...]", ends),
        critical=critical,
        johnson=johnson > 0,
        euler=euler.reshape(-1, 2),
        moment=moment.reshape(-1, 2),
        round=round_ > 0,
    )


Numbers = tuple[float, float]
NONE = ("", np.nan, 0.0, (np.nan, np.nan), (np.nan, np.nan), 0.0)


def _column(model: Model, name: str, one: object, length: float) -> tuple[str, float, float, Numbers, Numbers, float]:
    """End condition, critical load, whether it is Johnson's; of axes 2 and 3 Euler's loads and allowed moments; whether the
    section is round. Nothing of beams and bent links.
    """
    if not isinstance(one, Link):
        return NONE
    if not is_straight(model, one):
        return NONE
    ends, section, material = column_ends(model, name), model.section_of(one), model.material_of(one)
    assert material is not None  # noqa: S101 - it has a section and a material
    (I2, I3), (c2, c3) = section.second_moments, section.extreme_fibres
    strength, weak = material.yield_strength, min(I2, I3)
    critical = float(critical_load(material.E, weak, section.area, length, strength, ends))
    johnson = critical != float(euler_load(material.E, weak, length, ends))
    stress = math.nan if strength is None else strength / model.safety.yielding
    euler = [float(euler_load(material.E, I, length, ends)) for I in (I2, I3)]
    return (
        str(ends), critical, float(johnson), (euler[0], euler[1]), (stress * I2 / c3, stress * I3 / c2), float(section.round)
    )  # fmt: skip
