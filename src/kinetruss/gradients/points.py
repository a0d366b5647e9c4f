"""What an analysis tells of itself at its solution, so that any of its results has gradients.

An analysis solves r(y; p) = 0 for its unknowns y, and its results are d(y; p). Of a response s(d) with weights w = ds/dd

    ds/dp = w . dd/dp - z . dr/dp,    (dr/dy)^T z = (dd/dy)^T w

with both derivatives by p at fixed y (the adjoint method; Haug & Arora, Applied Optimal Design, 1979). They are differences of
what the elements compute anyway, so an element needs no derivatives for it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from kinetruss.gradients.differences import FOUR, TWO, Weighed, differences
from kinetruss.gradients.nearness import parts_of
from kinetruss.gradients.varied import STEP, Varied

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

    Floats = NDArray[np.float64]
    Columns = Mapping[str, Any]


class Point(Protocol):
    """An analysis at its solution.

    system : where it was solved. unknown (m,) : y. size (m,) : what changes of y are compared with. at (m,), row (m,) : the
    node of the user at which each unknown, and each residual, is; -1 none. linear : results are quadratic in y at most.
    """

    system: System
    unknown: Floats
    size: Floats
    at: NDArray[np.int64]
    row: NDArray[np.int64]
    linear: bool

    def data(self) -> xr.Dataset:
        """The results as users read them, with what responses may read beside."""

    def residual(self, system: System) -> Floats:
        """r (m,) with the numbers of another system, at the unknowns y."""

    def columns(self, system: System, unknown: Floats, names: Sequence[str]) -> dict[str, Floats]:
        """The named results with other numbers and unknowns, in the shape of `data`. A sum has its terms along an axis more."""

    def sites(self, name: str) -> NDArray[np.int64]:
        """The node at which each value of a result is, in the shape of `columns`; -1 none."""

    def transposed(self, right: Floats) -> Floats:
        """z (k, m) of (dr/dy)^T z = right (k, m)."""


def gradients_at(point: Point, by: Varied, seeds: Sequence[Mapping[str, Floats]]) -> Floats:
    """Derivatives (k, numbers) of k responses with seeds ds/dd by the variables that they read."""
    names = list(dict.fromkeys(name for one in seeds for name in one))
    here = point.columns(point.system, point.unknown, names)
    weight = np.concatenate([_weights(seeds, name, here[name]) for name in names], axis=1)
    site = np.concatenate([point.sites(name).reshape(-1) for name in names])
    count = len(parts_of(point.system).index)

    def results(system: System, unknown: Floats) -> Floats:
        found = point.columns(system, unknown, names)
        return np.concatenate([found[name].reshape(-1) for name in names])

    z = point.transposed(_by_unknowns(point, weight, site, results))
    every = Weighed(
        lambda change: _both(point, by.changed(change), results),
        np.concatenate([-z, weight], axis=1),
        np.concatenate([point.row, site]),
    )
    return differences(every, by.near, STEP * by.scale, count)


def _both(point: Point, system: System, results: Any) -> Floats:
    return np.concatenate([point.residual(system), results(system, point.unknown)])


def _weights(seeds: Sequence[Mapping[str, Floats]], name: str, here: Floats) -> Floats:
    """Weights (k, values) of a variable; those of a sum on each of its terms."""
    found = np.zeros((len(seeds), *here.shape))
    for k, one in enumerate(seeds):
        if name in one:
            found[k] = one[name] if one[name].shape == here.shape else one[name][..., None]
    return found.reshape(len(seeds), -1)


def _by_unknowns(point: Point, weight: Floats, site: NDArray[np.int64], results: Any) -> Floats:
    """(dd/dy)^T w, (k, m): by the unknowns near to what is weighed."""
    parts = parts_of(point.system)
    names = list(parts.index)
    around = {i: parts.around(("nodes", names[i])) for i in np.unique(point.at[point.at >= 0]).tolist()}
    used = set(site[np.abs(weight).max(axis=0) > 0].tolist())
    touching = {i: -1 in used or bool(own & used) for i, own in around.items()}
    near = [around.get(i) for i in point.at.tolist()]
    step = STEP * point.size * np.array([touching.get(i, True) for i in point.at.tolist()], float)
    given = Weighed(lambda change: results(point.system, point.unknown + change), weight, site)
    return differences(given, near, step, len(names), TWO if point.linear else FOUR)
