"""Differences by numbers of one colour together, contracted with weights: what one evaluation tells of many derivatives."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array

from kinetruss.errors import AnalysisError
from kinetruss.gradients.nearness import Near, colours

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

FOUR = ((1.0, 2 / 3), (-1.0, -2 / 3), (2.0, -1 / 12), (-2.0, 1 / 12))
"""Steps and weights of the central difference of fourth order; exact for polynomials to the fourth degree."""
THREE = ((1.0, 1.0), (-1.0, -1 / 3), (2.0, -1 / 6))
"""Those of the difference of third order, of what a value changes from that without a step; exact to the third degree."""
TWO = ((1.0, 0.5), (-1.0, -0.5))
"""Those of second order; exact for quadratic functions."""
ROUGH, NOISE = 1e-4, 1e-13
"""Fractions of a change, and of a value, by which two differences of second order may differ."""
FINER = (1.0, 0.1, 0.01, 1e-3)
"""Steps for numbers that act strongly nonlinear, as fractions of the usual."""
GOLDEN = (5**0.5 - 1) / 2
LEAK = 1e-9
"""Fraction of a change beyond which it is not near what causes it."""


class Weighed(NamedTuple):
    """Functions as one array (m,), weights (k, m) of several sums of them, and the node (m,) at which each is, -1 unknown."""

    of: Callable[[Floats], Floats]
    weight: Floats
    site: NDArray[np.int64]


def differences(
    given: Weighed,
    near: Sequence[Near],
    step: Floats,
    count: int,
    points: Sequence[tuple[float, float]] = THREE,
    *,
    here: Floats | None = None,
    few_act: bool = False,
) -> Floats:
    """Derivatives (k, numbers) of weighed sums by numbers.

    given.of : takes changes (numbers,) of the numbers. near : nodes near each number, as of `near_nodes`. step (numbers,).
    count : of nodes. here : the functions without a change, if they are known. few_act : first ask whether a change has an
    effect at all. Numbers whose effects are not where they are expected are taken one by one.
    """
    found, step = np.zeros((len(given.weight), len(step))), uneven(step)
    wanted = [k for k in range(len(step)) if step[k]]
    groups = [[wanted[j] for j in group] for group in colours([near[k] for k in wanted], count)]
    if here is None and wanted and (few_act or len(points) > len(TWO)):
        here = given.of(np.zeros_like(step))
    for group in groups:
        change = _change(given, step, group, points, here, few_act=few_act)
        if len(group) == 1:
            found[:, group[0]] = given.weight @ change
            continue
        label = np.full(count + 1, -1)  # the last is of what is nowhere
        for j, k in enumerate(group):
            label[[*(near[k] or ())]] = j
        own = label[given.site]
        size = np.abs(given.weight).max(axis=0, initial=0.0) * np.abs(change)
        if size[own < 0].sum() > LEAK * size.sum():
            for k in group:
                found[:, k] = given.weight @ _change(given, step, [k], points, here, few_act=few_act)
            continue
        kept = np.flatnonzero((own >= 0) & (change != 0.0))
        onto = csr_array((change[kept], (kept, own[kept])), shape=(len(change), len(group)))
        found[:, group] = (onto.T @ given.weight.T).T
    return found / np.where(step, step, 1.0)


def uneven(step: Floats) -> Floats:
    """Steps of several sizes, so that the effects of equal parts of a model on what all share do not cancel unseen."""
    return np.asarray(step * (1.0 - 0.4 * np.modf(GOLDEN * np.arange(len(step)))[0]))


def _change(
    given: Weighed,
    step: Floats,
    group: Sequence[int],
    points: Sequence[tuple[float, float]],
    here: Any,
    *,
    few_act: bool,
) -> Any:
    """The change (m,) of the functions, without one here (m,), for a step of all numbers of a group; few_act : none where the
    first step has none.
    """
    own = np.zeros_like(step)
    own[group] = step[group]
    # where differences to one side stay unlike, those to both sides alike have the mean of two slopes
    for some in (points, FOUR) if points is THREE else (points,):
        for finer in FINER:
            found: list[Any] = []
            for share, _ in some:
                found.append(given.of(share * finer * own))
                if few_act and len(found) == 1 and finer == 1.0 and np.array_equal(found[0], here, equal_nan=True):
                    return np.zeros_like(here)
            from_here = here if some is THREE else 0.0
            change = sum(weight * (one - from_here) for (_, weight), one in zip(some, found, strict=True)) / finer
            if len(some) < len(THREE) or not _rough(given.weight, found, here):
                return change
    raise AnalysisError("A number acts with a kink or a jump, even in small steps, so there is no derivative by it.")


def _rough(weight: Floats, found: Sequence[Any], here: Floats) -> bool:
    """Whether two differences of second order are not alike, in the sums (k,), beyond round-off: over one step and over two,
    or, of three points, to both sides and to one.
    """
    up, down, farther = (one - here for one in found[:3])
    first, size = (up - down) / 2, np.abs(weight)
    other = (farther - (found[3] - here)) / 4 if len(found) == len(FOUR) else (4 * up - farther) / 2
    changes = np.abs(first) if len(found) == len(FOUR) else np.abs(up)
    off = np.abs(weight @ (first - other))
    return bool((off > ROUGH * (size @ changes) + NOISE * (size @ np.abs(found[0]))).any())
