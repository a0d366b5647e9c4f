"""Eigenvalues at a state as results: natural frequencies, buckling factors.

Of a simple eigenvalue of (K - s M) phi + G^T m = 0, G phi = 0, with inextensible rows G,

    ds = (phi^T (dK - s dM) phi + 2 m^T dG phi)/(phi^T M phi)

(Nelson, AIAA Journal 14 (1976) 1201, without members kept inextensible), so that with fixed shapes its terms are sums over
coordinates and rows. Repeated eigenvalues have no gradients one by one; the sum of all of them has one, and so has any function
that weighs them alike (Seyranian, Lund & Olhoff, Structural Optimization 8 (1994) 207).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

    Floats = NDArray[np.float64]

TOGETHER = 1e-6
"""Eigenvalues that differ by less than this fraction are repeated."""
ALIKE = 1e-6
"""Weights of repeated eigenvalues that differ by less than this fraction are equal."""


class Eigenvalues(ABC):
    """The results of a `Point`: one variable along its modes.

    values (modes,) : all that are known, of which users read the first `shown`. terms : of each of these (shown, k) with fixed
    shapes, which have its derivative in their sum; at (k,) : their nodes.
    """

    system: System
    unknown: Floats
    name: str
    unit: str
    words: str
    values: Floats
    shown: int
    at_terms: NDArray[np.int64]

    @abstractmethod
    def terms(self, system: System, unknown: Floats) -> Floats:
        """The terms with other numbers and unknowns."""

    def data(self) -> xr.Dataset:
        """The eigenvalues as users read them."""
        own = variable(("mode",), self.values[: self.shown], self.unit, self.words)
        return xr.Dataset({self.name: own}, coords={"mode": np.arange(1, self.shown + 1)})

    def columns(self, system: System, unknown: Floats, names: Sequence[str]) -> dict[str, Floats]:
        """The terms by the name of the variable."""
        return {name: self.terms(system, unknown) for name in names}

    def sites(self, name: str) -> NDArray[np.int64]:  # noqa: ARG002
        """By the coordinate or row of each term."""
        return np.broadcast_to(self.at_terms, (self.shown, len(self.at_terms)))

    def refuse_repeated(self, seeds: Sequence[Mapping[str, Floats]]) -> None:
        """Refuse responses that weigh repeated eigenvalues differently.

        Raises
        ------
        AnalysisError : the modes.
        """
        order = np.argsort(self.values)
        values = self.values[order]
        cuts = np.flatnonzero(np.diff(values) > TOGETHER * np.abs(values[1:])) + 1
        for seed in seeds:
            weight = np.zeros(len(values))
            weight[: self.shown] = seed[self.name]
            for modes in np.split(order, cuts):
                own = weight[modes]
                if np.ptp(own) > ALIKE * np.abs(own).max():
                    named = ", ".join(str(k + 1) for k in np.sort(modes))
                    raise AnalysisError(
                        f"{self.name.capitalize().replace('_', ' ')} is the same of modes {named}, so that each alone has no "
                        f"gradient. Weigh them alike: take the mean of all of them, or with r above 0 "
                        f"-ks(-{self.name}, r), a smooth lower bound of the least, of as many modes as belong together."
                    )
