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

from kinetruss.errors import AnalysisError, ModelError
from kinetruss.gradients.differences import THREE, TWO, Weighed, differences
from kinetruss.gradients.nearness import parts_of
from kinetruss.gradients.varied import STEP, TRIED, Varied

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

    def refuse(self, seeds: Sequence[Mapping[str, Floats]]) -> None:
        """Raise an AnalysisError where responses with these seeds have no gradient."""


MISSED = 1e-5
"""Share of the effect of a trial that may be missed: a trial is a one-sided difference of the first order."""
NOISE = 1e-8
"""Round-off of the effect of a trial, as a fraction of the sum of all changes."""


def gradients_at(point: Point, by: Varied, seeds: Sequence[Mapping[str, Floats]]) -> Floats:
    """Derivatives (k, numbers) of k responses with seeds ds/dd by the variables that they read.

    A trial, with all numbers changed at once in a model that is compiled anew, shows whether the analysis reads numbers beside
    those of the system, or a number acts where no part says so. Models are then compiled for such numbers, and each is changed
    alone.
    """
    names = list(dict.fromkeys(name for one in seeds for name in one))
    point.refuse(seeds)
    here = point.columns(point.system, point.unknown, names)
    weight = np.concatenate([_weights(seeds, name, here[name]) for name in names], axis=1)
    site = np.concatenate([point.sites(name).reshape(-1) for name in names])
    count, step = len(parts_of(point.system).index), STEP * by.scale

    def results(system: System, unknown: Floats) -> Floats:
        found = point.columns(system, unknown, names)
        return np.concatenate([found[name].reshape(-1) for name in names])

    def both(system: System) -> Floats:
        return np.concatenate([point.residual(system), results(system, point.unknown)])

    told = Weighed(lambda change: results(point.system, point.unknown + change), weight, site)
    z = point.transposed(by_unknowns(point, told))
    weights, sites = np.concatenate([-z, weight], axis=1), np.concatenate([point.row, site])
    placed = Weighed(lambda change: both(by.changed(change)), weights, sites)
    anew = Weighed(lambda change: both(by.compiled(change)), weights, sites)
    first = both(point.system)
    found = differences(placed, by.near, step, count, here=first)
    expected = placed.of(by.trial)

    def missed(effect: Floats) -> bool:
        size = MISSED * (np.abs(found) @ by.trial) + NOISE * (np.abs(weights) @ np.abs(expected - first))
        return bool((np.abs(effect) > size).any())

    near = [None] * len(step) if missed(weights @ (expected - first) - found @ by.trial) else by.near
    if near is not by.near:
        found = differences(placed, near, step, count, here=first)
    trials = [by.trial] if missed(weights @ (both(by.tried) - expected)) else []
    # numbers that only records have may act on one side alone, as instants of tables
    trials += [one for one in (by.of_records * by.trial, -(by.of_records * by.trial)) if by.of_records.any()]
    for own in by.kinds if trials else ():
        for change in (np.where(own, one, 0.0) for one in trials if (one * own).any()):
            try:
                effect = weights @ (anew.of(change) - first)
            except ModelError:  # at the end of what may be given
                continue
            if missed(effect - found @ change):
                found[:, own] = differences(anew, near, np.where(own, step, 0.0), count, here=first)[:, own]
                if missed(effect - found @ change):
                    raise AnalysisError(
                        f"There is no gradient by {by.names[int(np.argmax(own))]} here, at a kink: a small change of it, or of "
                        "those of its kind, has not the opposite effect of the opposite change."
                    )
    if not np.isfinite(found).all():
        k = int(np.argwhere(~np.isfinite(found))[0, 1])
        raise AnalysisError(f"The derivative by {by.names[k]} is not finite: the response is not smooth here.")
    return found


def _weights(seeds: Sequence[Mapping[str, Floats]], name: str, here: Floats) -> Floats:
    """Weights (k, values) of a variable; those of a sum on each of its terms."""
    found = np.zeros((len(seeds), *here.shape))
    for k, one in enumerate(seeds):
        if name in one:
            found[k] = one[name] if one[name].shape == here.shape else one[name][..., None]
    return found.reshape(len(seeds), -1)


def by_unknowns(point: Point, given: Weighed) -> Floats:
    """Derivatives (k, m) of weighed sums, which take changes (m,) of the unknowns, by those near to what is weighed."""
    parts = parts_of(point.system)
    names = list(parts.index)
    around = {i: parts.around(("nodes", names[i])) for i in np.unique(point.at[point.at >= 0]).tolist()}
    used = set(given.site[np.abs(given.weight).max(axis=0) > 0].tolist())
    touching = {i: -1 in used or bool(own & used) for i, own in around.items()}
    near = [around.get(i) for i in point.at.tolist()]
    step, points = STEP * point.size, TWO if point.linear else THREE
    touched = np.array([touching.get(i, True) for i in point.at.tolist()], float)
    found = differences(given, near, step * touched, len(names), points)
    trial = TRIED * point.size * np.random.default_rng(2).uniform(0.5, 1.0, len(step))
    effect = given.of(trial) - given.of(0.0 * trial)
    size = MISSED * (np.abs(found) @ trial) + NOISE * (np.abs(given.weight) @ np.abs(effect))
    if (np.abs(given.weight @ effect - found @ trial) > size).any():  # some act elsewhere than expected
        return differences(given, [None] * len(step), step, len(names), points)
    return found
