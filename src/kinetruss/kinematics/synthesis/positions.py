"""Linkages whose coupler passes through given positions, exactly: Burmester's theory, with its defects sorted out."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.stats import qmc

from kinetruss.arrays import array_of
from kinetruss.errors import InputError
from kinetruss.kinematics.synthesis.chains import Chains, of
from kinetruss.kinematics.synthesis.dyads import centre_curve, five, on_lines, points_for
from kinetruss.kinematics.synthesis.found import Kind, Linkage, Linkages, check_kinds, proved
from kinetruss.limits import whole
from kinetruss.mechanics.arguments import number_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.kinematics.synthesis.dyads import Complex

PIVOTS = 400
"""Fixed pivots tried for three positions."""

SLIDERS = 120
"""Points on lines tried for three positions."""

MOST = 40_000
"""Pairs of dyads that are compared at most."""

MISS = 1e-8
"""Largest error of a linkage through positions, of the size of the task."""

SHORT, LARGE = 0.1, 8.0
"""Shortest and longest link, of the size of the task: small errors of short ones become large ones of the positions."""

ALIKE = 0.4
"""Linkages whose pivots and lengths differ by less, in parts of the size of the task, resemble each other."""

CLASS = 5.0
"""Transmission angles that differ by less than about this count as equal, deg: the smaller linkage is better then."""


def through(
    positions: ArrayLike, *, kinds: tuple[Kind, ...] = ("four-bar", "slider-crank"), pivots: ArrayLike | None = None,
    region: ArrayLike | None = None, point: float = 0.0, count: int = 12, transmission: float = math.radians(15.0),
) -> Linkages:  # fmt: skip
    """Four-bars and slider-cranks whose coupler takes three to five positions one after the other, on one branch.

    Three positions leave two numbers of each dyad free, four leave one (the pivot is on Burmester's curve), five none: there
    are up to four dyads. A slider takes three or four positions.

    Parameters
    ----------
    positions : (n, 3) x and y of a point P of the coupler, m, and the angle of the coupler, rad, n = 3, 4 or 5, in order.
    kinds : which linkages.
    pivots : (2, 2) both fixed pivots A and D, m; of three positions alone, and four-bars.
    region : (2, 2) two corners of the rectangle in which fixed pivots may be, m; by default four times as large as the task,
        of five positions larger.
    point : if not 0, the distance from P along the angle of a second point Q of the coupler, m.
    count : most linkages of each kind. transmission : least transmission angle on the way, rad.

    Returns
    -------
    Linkages, of each kind the best transmission angle first, then the shortest links; of those that resemble each other one.
    All of them pass all positions in order, on one branch: each was followed by `kinematics.follow`. The message says how many
    others were left out, and why.

    Raises
    ------
    InputError : fewer than three or more than five positions; pivots of four or five; two positions that are the same.

    Source
    ------
    L. Burmester, Lehrbuch der Kinematik (1888); J. M. McCarthy, G. S. Soh, Geometric Design of Linkages (2011), chapter 5.

    Examples
    --------
    >>> import kinetruss as kt
    >>> flap = [(0.0, 0.0, 0.0), (0.3, 0.2, 0.6), (0.4, 0.6, 1.4)]
    >>> four_bar = kt.kinematics.synthesis.through(flap, kinds=("four-bar",), count=1)[0]
    >>> four_bar.error < 1e-12, four_bar.transmission > 0.5
    (True, True)
    """
    given = array_of(positions, "positions", {"positions": None, "(x, y, angle)": 3}, unit="m and rad")
    task = _Task.of(given, region)
    if not 3 <= len(given) <= 5:
        raise InputError(f"positions: {len(given)}, expected 3, 4 or 5. For more points along a way, take `along`.")
    check_kinds(kinds)
    count, limit = whole(count, "count", least=1), math.sin(number_of(transmission, "transmission", "rad"))
    chosen = None if pivots is None else array_of(pivots, "pivots", {"(A, D)": 2, "(x, y)": 2}, unit="m")
    if chosen is not None and (len(given) > 3 or "four-bar" not in kinds):
        raise InputError("pivots can be chosen for four-bars through three positions. More positions leave no choice of both.")
    found: list[Linkage] = []
    words: list[str] = []
    for kind in kinds:
        if chosen is not None and kind == "slider-crank":
            continue
        pairs = _pairs(task, kind, None if chosen is None else task.inward(chosen[:, 0] + 1j * chosen[:, 1]))
        if isinstance(pairs, str):
            words.append(f"No {kind}: {pairs}")
            continue
        own, told = _sifted(task, *pairs, kind, limit, count, point, any_size=chosen is not None)
        found += own
        words.append(told)
    return Linkages(found=tuple(found), message=" ".join(words))


@dataclass(frozen=True, eq=False)
class _Task:
    """Positions in units of the task's size about its centre: places d and directions e; low, high : the region."""

    d: Complex
    e: Complex
    centre: complex
    size: float
    low: complex
    high: complex

    @classmethod
    def of(cls, given: NDArray[np.float64], region: ArrayLike | None) -> _Task:
        """The task of positions (n, 3)."""
        places, e = given[:, 0] + 1j * given[:, 1], np.exp(1j * given[:, 2])
        low, high = complex(places.real.min(), places.imag.min()), complex(places.real.max(), places.imag.max())
        centre, size = (low + high) / 2, abs(high - low)
        if not size > 0:
            raise InputError("positions: all at one place. A pin there does it; give places that differ.")
        for j, k in zip(*np.triu_indices(len(e), 1), strict=True):
            if abs(places[j] - places[k]) < MISS * size and abs(e[j] - e[k]) < MISS:
                raise InputError(f"positions {j + 1} and {k + 1} are the same. Leave one of them out.")
        around = (LARGE if len(given) == 5 else 2.0) * (1 + 1j)
        if region is None:
            return cls((places - centre) / size, e, centre, size, -around, around)
        corners = array_of(region, "region", {"corners": 2, "(x, y)": 2}, unit="m")
        ends = [(complex(*one) - centre) / size for one in (corners.min(0), corners.max(0))]
        if not (corners[0] != corners[1]).all():
            raise InputError("region: has no area. Give two opposite corners.")
        return cls((places - centre) / size, e, centre, size, *ends)

    def inward(self, places: Complex) -> Complex:
        """Places of the user in units of the task."""
        return (places - self.centre) / self.size

    def inside(self, g: Complex) -> NDArray[np.bool_]:
        """Which pivots are in the region."""
        low, high = self.low, self.high
        return (g.real >= low.real) & (g.real <= high.real) & (g.imag >= low.imag) & (g.imag <= high.imag)


def _pairs(task: _Task, kind: Kind, chosen: Complex | None) -> tuple[Chains, Complex] | str:
    """All linkages of two dyads before their defects are known, and the direction of B -> C at first; or why there are none."""
    d, e, n = task.d, task.e, len(task.d)
    if chosen is not None:
        g, w = chosen, points_for(d, e, chosen)[0]
    elif n == 5:
        g, w = five(d, e)
        inside = task.inside(g)
        g, w = g[inside], w[inside]
        if len(g) < 2 - (kind == "slider-crank"):
            total, here = len(inside), int(inside.sum())
            return f"five positions have {total} dyad{'s' * (total != 1)}, {here} of them in the region; two are needed."
    else:
        if n == 4:
            g = centre_curve(d, e, task.low, task.high)
        else:
            unit = qmc.Halton(2, seed=1).random(PIVOTS)
            way = task.high - task.low
            g = task.low + unit[:, 0] * way.real + 1j * unit[:, 1] * way.imag
        w, left = points_for(d, e, g)
        good = (left < MISS) & np.isfinite(w) & (abs(w) < LARGE)
        g, w = g[good], w[good]
        if not len(g):
            return "no point of the body stays on a circle about a pivot in the region."
    if kind == "slider-crank":
        slides = on_lines(d, e, SLIDERS)
        slides = slides[abs(slides) < LARGE]
        if not len(slides):
            why = "five positions leave none" if n == 5 else "none of its points stays near enough"
            return f"no point of the body runs along a line through the positions ({why})."
        first, second = np.divmod(np.arange(len(g) * len(slides)), len(slides))
        at = _some(len(first))
        return _with_line(task, g[first[at]], w[first[at]], slides[second[at]])
    first, second = np.divmod(np.arange(len(g) ** 2), len(g))
    at = np.flatnonzero(first != second)
    at = at[_some(len(at))]
    return _with_circle(task, g[first[at]], w[first[at]], g[second[at]], w[second[at]])


def _some(count: int) -> NDArray[np.intp]:
    """Evenly chosen, if there are too many."""
    return np.arange(count) if count <= MOST else np.sort(np.random.default_rng(0).choice(count, MOST, replace=False))


def _with_circle(task: _Task, A: Complex, b: Complex, D: Complex, c: Complex) -> tuple[Chains, Complex]:
    d, e = task.d[0], task.e[0]
    B, C = d + e * b, d + e * c
    with np.errstate(divide="ignore", invalid="ignore"):
        side = np.sign((np.conj(D - B) * (C - B)).imag)
        way = (c - b) / abs(c - b)
    return of(A=A, D=D, a=abs(B - A), h=abs(c - b), r=abs(C - D), side=side, p=-b * np.conj(way)), e * way


def _with_line(task: _Task, A: Complex, b: Complex, c: Complex) -> tuple[Chains, Complex]:
    d, e = task.d, task.e
    B, C = d[0] + e[0] * b, d[0] + e[0] * c
    there = d[:, None] + e[:, None] * c
    far = there[abs(there - there[0]).argmax(0), np.arange(len(c))] - there[0]
    along = far / abs(far)
    side = np.sign((np.conj(along) * (C - B)).real)
    way = (c - b) / abs(c - b)
    fields = {"A": A, "D": C, "a": abs(B - A), "h": abs(c - b), "side": side, "p": -b * np.conj(way), "along": along}
    return of(**fields, r=0.0), e[0] * way


def _sifted(
    task: _Task, pairs: Chains, first: Complex, kind: Kind, limit: float, count: int, point: float, *, any_size: bool
) -> tuple[list[Linkage], str]:
    """The linkages without defects, the best of each sort, and what became of the others."""
    d, e = task.d[None], task.e[None]
    total = len(pairs)
    shortest = np.min([pairs.a, pairs.h] if pairs.along is not None else [pairs.a, pairs.h, pairs.r], axis=0)
    kept = np.isfinite(pairs.p) & (pairs.side != 0) & (any_size | ((pairs.size < LARGE) & (shortest > SHORT)))
    pairs = pairs[kept]
    fit = len(pairs)
    coupler = first[kept, None] * e / e[:, :1]
    phi = np.angle(d - pairs.p[:, None] * coupler - pairs.A[:, None])
    _, turn, P = pairs.moved(phi)
    same = (abs(P - d).max(1) < MISS) & (abs(turn - coupler).max(1) < MISS)
    pairs, phi, coupler = pairs[same], phi[same], coupler[same]
    branch = len(pairs)
    course, ordered = pairs.unwrapped(phi)
    pairs, course, coupler = pairs[ordered], course[ordered], coupler[ordered]
    order = len(pairs)
    sines = pairs.worst_transmission(course[:, 0], course[:, -1]) if order else np.zeros(0)
    classes = np.floor(np.degrees(np.arcsin(np.minimum(sines, 1.0))) / CLASS)
    ranked = np.lexsort((pairs.size, -classes))
    ranked = ranked[sines[ranked] >= limit]
    good = len(ranked)
    found: list[Linkage] = []
    outer = pairs.moved_to(task.centre, task.size)
    for at in _distinct(pairs, ranked, count):
        p = outer.p[at]
        extra = {"Q": complex(p + point * np.conj(coupler[at, 0]) * task.e[0])} if point else {}
        place = task.centre + task.size * task.d
        one = proved(outer, int(at), course[at], place, coupler[at], closed=False, extra=extra)
        if one is not None and one.error < MISS * task.size:
            found.append(one)
    told = [
        (total - fit, f"links shorter than {SHORT:g} or longer than {LARGE:g} of the task"),
        (fit - branch, "change their branch"),
        (branch - order, "meet them in another order or part on the way"),
        (order - good, f"transmission angles below {math.degrees(math.asin(limit)):.0f} deg"),
    ]
    left = ", ".join(f"{number:,}: {why}" for number, why in told if number)
    of_all = f"{kind}s: of {total:,} through the positions {good:,} are good" + (f" (left out: {left})" if left else "")
    return found, f"{of_all[0].upper()}{of_all[1:]}."


def _distinct(pairs: Chains, ranked: NDArray[np.intp], count: int) -> list[int]:
    """The first of the ranked that differ in a pivot, or a length."""
    chosen: list[int] = []
    marks = np.stack([pairs.A, pairs.D, pairs.a + 1j * pairs.r, pairs.h + 1j * abs(pairs.p)], -1)
    for at in ranked:
        if all(abs(marks[at] - marks[other]).max() > ALIKE for other in chosen):
            chosen.append(int(at))
            if len(chosen) == count:
                break
    return chosen
