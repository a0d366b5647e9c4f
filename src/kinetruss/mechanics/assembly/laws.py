"""Constitutive laws of bars: tension, its derivatives and strain energy at given lengths."""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.kernels.structure.laws import law_values

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["BarLaws", "bar_laws"]


class BarLaws(NamedTuple):
    """tension, N; slope dN/dL, N/m; damping dN/dL', N s/m; energy, J; all (..., members), 0 for bars without a law."""

    tension: NDArray[np.float64]
    slope: NDArray[np.float64]
    damping: NDArray[np.float64]
    energy: NDArray[np.float64]


def bar_laws(
    system: System, L: NDArray[np.float64], Ld: NDArray[np.float64] | None = None, member: Any = slice(None)
) -> BarLaws:
    """The laws of members (k,), all by default, at lengths L and their rates (..., k), m and m/s; without rates, at rest."""
    kind, k, l0, c = (one[member] for one in (system.law, system.spring, system.natural, system.damping))
    flat, found = (prod(np.shape(L)[:-1]), len(kind)), np.empty((4, *np.shape(L)))
    rates = np.zeros((1, len(kind))) if Ld is None else np.asarray(Ld, float).reshape(flat)
    law_values(kind, k, l0, c, np.asarray(L, float).reshape(flat), rates, found.reshape(4, *flat))
    return BarLaws(*found)
