"""Derivatives of weighed sums by the states of samples: all changes side by side, in one evaluation.

What is weighed is found of each sample by itself, so the states with a change are further samples beside the others, and a
kernel that takes a row of samples takes all changes at once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.errors import AnalysisError
from kinetruss.gradients.differences import LEAK, THREE, uneven
from kinetruss.gradients.nearness import Near, colours

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

LARGEST = 4_000_000
"""Numbers of states and values in one evaluation, about."""
KINK = 1e-3
"""Second difference, as a fraction of a value, from which on a function has a kink there or jumps."""


class Weights(NamedTuple):
    """Weights (k, s, values) of k sums of functions at s samples, and the node (values,) at which each is, -1 unknown."""

    value: Floats
    site: NDArray[np.int64]


class Unknowns(NamedTuple):
    """Unknowns (s, m) at s samples, the nodes near each (m,), of so many, and their steps (m,), 0 where none is to be made."""

    value: Floats
    near: Sequence[Near]
    step: Floats
    nodes: int


def by_states(of: Callable[[Floats], Floats], given: Weights, by: Unknowns, *, smooth: bool = False) -> Floats:
    """Derivatives (k, s, m) of the sums by the unknowns of each sample.

    of : takes unknowns (g, s, m), and gives values (g, s, values). smooth : refuse kinks and jumps.

    Raises
    ------
    AnalysisError : a value has a kink or a jump there.
    """
    found, by = np.zeros((len(given.value), *by.value.shape)), by._replace(step=uneven(by.step))
    used = np.flatnonzero(np.abs(given.value).max(axis=(0, 1), initial=0.0))
    if not len(used):
        return found
    sites = {*given.site[used].tolist()}
    wanted = [k for k, near in enumerate(by.near) if by.step[k] and (near is None or -1 in sites or not sites.isdisjoint(near))]
    groups = [[wanted[j] for j in group] for group in colours([by.near[k] for k in wanted], by.nodes)]
    weight, site = given.value[:, :, used], given.site[used]
    here = of(by.value[None])[..., used]
    while groups:
        again: list[list[int]] = []
        size = max(1, LARGEST // max(1, by.value.size + here.size))
        for first in range(0, len(groups), size):
            own = groups[first : first + size]
            change, second = _changes(of, by, own, used, here, weight)
            if smooth:
                _refuse_kinks(here, change, second, weight)
            for group, one in zip(own, change, strict=True):
                if not _spread(found, group, one, weight, site, by):
                    again += [[k] for k in group]
        groups = again
    return found / np.where(by.step, by.step, 1.0)


def _changes(
    of: Callable[[Floats], Floats], by: Unknowns, groups: list[list[int]], used: NDArray[np.int64], here: Floats, weight: Floats
) -> tuple[Floats, Floats]:
    """Changes (groups, s, values) for a step of each group, and second differences; of those without effect the first tells."""
    label = np.zeros((len(groups), by.value.shape[1]))
    for row, group in zip(label, groups, strict=True):
        row[group] = by.step[group]
    change, second = np.zeros((2, len(groups), *here.shape[1:]))
    acting, at = np.arange(len(groups)), list[Any]()
    for share, _ in THREE:
        at.append(of(by.value + share * label[acting, None])[..., used])
        if len(at) == 1:
            moved = ((at[0] != here) & (weight != 0).any(axis=0)).any(axis=(1, 2))
            acting, at[0] = acting[moved], at[0][moved]
            if not len(acting):
                return change, second
    for (_, part), one in zip(THREE, at, strict=True):
        change[acting] += part * (one - here)
    second[acting] = at[0] + at[1] - 2 * here
    return change, second


def _refuse_kinks(here: Floats, change: Floats, second: Floats, weight: Floats) -> None:
    used = (weight != 0).any(axis=0)
    size = np.abs(here).max(axis=(0, 1), initial=0.0) + np.abs(change).max(axis=(0, 1), initial=0.0)
    if (np.abs(second) * used > KINK * size + 1e-300).any():
        raise AnalysisError(
            "A value of the response has a kink or jumps at the instant that it reads, as friction does at standstill, so it "
            "has no derivative there. Read another instant or another value."
        )


def _spread(found: Floats, group: list[int], change: Floats, weight: Floats, site: NDArray[np.int64], by: Unknowns) -> bool:
    """The changes to the unknowns that cause them, (k, s, group); False if some are not near what causes them."""
    if len(group) == 1:
        found[:, :, group[0]] = (weight * change).sum(axis=-1)
        return True
    label = np.full(by.nodes + 1, -1)  # the last is of what is nowhere
    for j, k in enumerate(group):
        label[[*(by.near[k] or ())]] = j
    own = label[site]
    size = np.abs(weight).max(axis=0) * np.abs(change)
    if size[:, own < 0].sum() > LEAK * size.sum():
        return False
    for j in np.unique(own[own >= 0]).tolist():
        found[:, :, group[j]] = (weight * change)[..., own == j].sum(axis=-1)
    return True
