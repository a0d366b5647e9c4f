"""Linkages whose coupler point runs along a path: least squares over all dimensions, from the curves of an atlas."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import least_squares

from kinetruss.arrays import array_of
from kinetruss.errors import InputError
from kinetruss.kinematics.synthesis.atlas import starts
from kinetruss.kinematics.synthesis.chains import Chains, of
from kinetruss.kinematics.synthesis.found import Kind, Linkage, Linkages, check_kinds, proved
from kinetruss.limits import whole
from kinetruss.mechanics.arguments import number_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.kinematics.synthesis.dyads import Complex

POINTS = 40
"""Most points of a path that are fitted."""

STARTS = 40
"""Curves of the atlas from which a fit begins, of each kind."""

FIRST, BEST, ROUNDS = 20, 14, 120
"""Steps of every fit; of these the best, and their steps."""

LARGE = 6.0
"""Longest link, of the size of the path."""

EXACT = 1e-9
"""Error, of the size of the path, that is round-off."""

LONG = 0.9
"""Part of that length from which on a fit holds links back."""

STEP = 1e-100
"""Step of complex differences: the derivatives are exact to round-off."""


def along(
    points: ArrayLike, *, closed: bool = False, kinds: tuple[Kind, ...] = ("four-bar", "slider-crank"), count: int = 12,
    enough: float = 1e-3, transmission: float = math.radians(15.0),
) -> Linkages:  # fmt: skip
    """Four-bars and slider-cranks whose coupler point P runs along a path, as nearly as they can; its timing is free.

    Parameters
    ----------
    points : (n, 2) of the path in order, m, at least 4; of more than 40 as many, equally spaced, are taken.
    closed : from the last point the path goes on to the first; then the crank makes full turns.
    kinds : which linkages. count : most linkages of each kind.
    enough : error, of the size of the path, below which linkages count as equally good and the transmission angle decides.
    transmission : least transmission angle on the way, rad.

    Returns
    -------
    Linkages of each kind, the nearest first. `error` is the largest distance of a point from P when the crank is at its angle
    for that point. All pass the points in order, on one branch: each was followed by `kinematics.follow`. The message says how
    near the path was reached, or what could not be.

    Raises
    ------
    InputError : fewer than four points; points at one place.

    Notes
    -----
    The unknowns are the fixed pivots, all lengths, the point of the coupler and one crank angle for each point. The loop is
    eliminated in closed form. The method of Levenberg and Marquardt minimises the sum of squared distances, with derivatives by
    complex steps, from those curves of an atlas that resemble the path most (Hrones and Nelson, 1951). It is a search from
    many starts: a better linkage may exist.

    Examples
    --------
    >>> import kinetruss as kt
    >>> four_bar = kt.library.mechanisms.chebyshev()
    >>> way = kt.kinematics.follow(four_bar, kt.Quintic(moves={"motor": (0.95, 1.4)}, duration=1.0), samples=9).position
    >>> best = kt.kinematics.synthesis.along(way.sel(node="P").values, kinds=("four-bar",))[0]
    >>> best.error < 1e-4
    True
    """
    given = array_of(points, "points", {"points": None, "(x, y)": 2}, unit="m")
    if len(given) < 4:
        raise InputError(f"points: {len(given)}, expected at least 4. For three positions of a body, take `through`.")
    check_kinds(kinds)
    count, limit = whole(count, "count", least=1), math.sin(number_of(transmission, "transmission", "rad"))
    enough = number_of(enough, "enough", "of the size of the path")
    path = _thinned(given[:, 0] + 1j * given[:, 1], closed)
    centre = (complex(path.real.min(), path.imag.min()) + complex(path.real.max(), path.imag.max())) / 2
    size = float(np.hypot(np.ptp(path.real), np.ptp(path.imag)))
    task = (path - centre) / size
    found: list[Linkage] = []
    words: list[str] = []
    for kind in kinds:
        own, told = _fitted(task, kind, closed, limit)
        good = _proved(own, path, centre, size, closed, count, enough)
        found += good
        words.append(_told(kind, good, told, size, limit))
    return Linkages(found=tuple(found), message=" ".join(words))


def _thinned(path: Complex, closed: bool) -> Complex:
    """The path without repeated points, or as many as are fitted."""
    if closed and path[0] == path[-1]:
        path = path[:-1]
    path = path[np.append(True, abs(np.diff(path)) > 0)]
    if len(path) < 4:
        raise InputError("points: fewer than four that differ. Give points along the path.")
    if len(path) <= POINTS:
        return path
    corners = np.append(path, path[0]) if closed else path
    lengths = np.concatenate([[0.0], np.cumsum(abs(np.diff(corners)))])
    at = np.linspace(0, lengths[-1], POINTS + closed)[:POINTS]
    return np.interp(at, lengths, corners.real) + 1j * np.interp(at, lengths, corners.imag)


# The fit. Its unknowns: A, a, h, p, then D and r of a four-bar or the angle and distance from A of a line, then crank angles.


@dataclass(frozen=True, eq=False)
class _Fit:
    """Least squares for one start: the path (k,), and the branch."""

    path: Complex
    side: float
    slides: bool

    @property
    def count(self) -> int:
        """Unknowns without crank angles."""
        return 8 if self.slides else 9

    def residuals(self, z: NDArray[Any]) -> NDArray[Any]:
        """Distances of P from the points along x and y, by how much the loop is open (..., 3 k), and links are too long.

        z (..., m) : unknowns.
        """
        Ax, Ay, a, h, px, py, *own = (z[..., k, None] for k in range(self.count))
        phi = z[..., self.count :]
        bx, by = a * np.cos(phi), a * np.sin(phi)  # B from A
        lengths = [a, h, np.sqrt(px * px + py * py)]
        if self.slides:
            angle, offset = own
            ux, uy = np.cos(angle), np.sin(angle)
            sine = (offset + uy * bx - ux * by) / h
            gap = h * _above(np.where(sine.real > 0, sine, -sine) - 1)
            sine = _inside(sine)
            cosine = self.side * np.sqrt(1 - sine * sine)
            tx, ty = ux * cosine - uy * sine, uy * cosine + ux * sine
        else:
            Dx, Dy, r = own
            x, y = Dx - Ax - bx, Dy - Ay - by
            lengths += [r, np.sqrt((Dx - Ax) ** 2 + (Dy - Ay) ** 2)]
            span = np.sqrt(x * x + y * y)
            cosine = (h * h - r * r + span * span) / (2 * h * span)
            gap = _above(span - h - r) + _above(np.where((h - r).real > 0, h - r, r - h) - span)
            cosine = _inside(cosine)
            sine = self.side * np.sqrt(1 - cosine * cosine)
            tx, ty = (cosine * x - sine * y) / span, (cosine * y + sine * x) / span
        Px, Py = Ax + bx + px * tx - py * ty, Ay + by + py * tx + px * ty
        longer = [_above(np.where(one.real > 0, one, -one) - LONG * LARGE) for one in lengths]
        return np.concatenate([Px - self.path.real, Py - self.path.imag, gap, *longer], -1)

    def jacobian(self, z: NDArray[np.float64]) -> NDArray[np.float64]:
        """Derivatives by complex steps: one for each unknown, and one for all crank angles, of which each has its own point."""
        m, k = self.count, len(self.path)
        steps = np.zeros((m + 1, len(z)), dtype=complex)
        steps[np.arange(m), np.arange(m)] = 1j * STEP
        steps[m, m:] = 1j * STEP
        slopes = self.residuals(z + steps).imag / STEP
        result = np.zeros((slopes.shape[1], len(z)))
        result[:, :m] = slopes[:m].T
        rows = np.arange(k)
        for part in range(3):
            result[part * k + rows, m + rows] = slopes[m, part * k + rows]
        return result

    def chains(self, z: NDArray[np.float64]) -> Chains:
        """The linkage of the unknowns."""
        Ax, Ay, a, h, px, py, *own = z[: self.count]
        fields = {"A": Ax + 1j * Ay, "a": a, "h": h, "p": px + 1j * py, "side": self.side}
        if not self.slides:
            Dx, Dy, r = own
            return of(**fields, D=Dx + 1j * Dy, r=r)
        along = np.exp(1j * own[0])
        return of(**fields, D=Ax + 1j * Ay + 1j * own[1] * along, r=0.0, along=along)


def _above(x: NDArray[Any]) -> NDArray[Any]:
    """max(x, 0)."""
    return np.where(x.real > 0, x, 0.0)


def _inside(x: NDArray[Any]) -> NDArray[Any]:
    """A cosine, held a little within -1 and 1, where its angle has a derivative."""
    most = 1 - 1e-12
    return np.where(abs(x.real) < most, x, np.sign(x.real) * most)


def _unknowns(chains: Chains) -> NDArray[np.float64]:
    one = chains
    common = [one.A.real, one.A.imag, one.a, one.h, one.p.real, one.p.imag]
    if one.along is None:
        return np.stack([*common, one.D.real, one.D.imag, one.r], -1)
    offset = (np.conj(1j * one.along) * (one.D - one.A)).real
    return np.stack([*common, np.angle(one.along), offset], -1)


Fitted = tuple[float, float, Chains, "NDArray[np.float64]"]
"""Mean error, sine of the transmission angle, one linkage, and its crank angles (k,)."""


def _fitted(task: Complex, kind: Kind, closed: bool, limit: float) -> tuple[list[Fitted], dict[str, float]]:
    """Fits without defects; and by the name of a defect how near those with it come."""
    chains, angles = starts(task, kind, closed=closed, count=STARTS)
    fits = [_Fit(task, float(side), kind == "slider-crank") for side in chains.side]
    first = [_least(fit, z, FIRST) for fit, z in zip(fits, np.hstack([_unknowns(chains), angles]), strict=True)]
    order = sorted((cost, k) for k, (cost, _) in enumerate(first))[:BEST]
    good: list[Fitted] = []
    told: dict[str, float] = {}
    for _, k in order:
        fit = fits[k]
        cost, z = _least(fit, first[k][1], ROUNDS)
        one, error = fit.chains(z), float(np.sqrt(2 * cost / len(task)))
        if not (np.isfinite(error) and min(one.a[0], one.h[0]) > 0 and one.r[0] >= 0):
            continue
        course, ordered = one.unwrapped(z[None, fit.count :])
        last = course[:, 0] + 2 * np.pi if closed else course[:, -1]
        sine = float(one.worst_transmission(course[:, 0], last)[0])
        defects = {
            "order": not ordered[0],
            "turn": closed and not one.turns[0],
            "large": one.size[0] > LARGE,
            "transmission": sine < limit,
        }
        name = next((name for name, there in defects.items() if there), None)
        if name is None:
            good.append((error, sine, one, course[0]))
        else:
            told[name] = min(told.get(name, np.inf), error)
    return good, told


def _least(fit: _Fit, z: NDArray[np.float64], rounds: int) -> tuple[float, NDArray[np.float64]]:
    """Least cost after some steps, and the unknowns there; an infinite cost where the fit has run away."""
    try:
        found = least_squares(fit.residuals, z, fit.jacobian, method="lm", max_nfev=rounds, xtol=1e-14, ftol=1e-13, gtol=1e-14)
    except ValueError:  # residuals that are no numbers
        return np.inf, z
    return float(found.cost), found.x


def _proved(
    fits: list[Fitted], path: Complex, centre: complex, size: float, closed: bool, count: int, enough: float
) -> list[Linkage]:
    """The best that differ, as models that were followed."""
    found: list[Linkage] = []
    seen: list[NDArray[np.complex128]] = []
    for error, _, one, course in sorted(fits, key=lambda fit: (max(fit[0], enough), -fit[1])):
        mark = np.array([one.A[0], one.D[0] if one.along is None else one.along[0], one.a[0] + 1j * one.h[0], one.p[0]])
        if any(abs(mark - other).max() < 0.15 for other in seen):
            continue
        outer = one.moved_to(centre, size)
        linkage = proved(outer, 0, course, path, None, closed=closed, extra={})
        if linkage is not None and linkage.error < 10 * (error * size * math.sqrt(len(path)) + 1e-9 * size):
            seen.append(mark)
            found.append(linkage)
            if len(found) == count:
                break
    return found


def _told(kind: Kind, found: list[Linkage], told: dict[str, float], size: float, limit: float) -> str:
    """What was reached, and what was left out though it comes nearer."""
    best = min((one.error for one in found), default=np.inf)
    plural = f"{kind[0].upper()}{kind[1:]}s"
    near = "meets the path exactly" if best < EXACT * size else f"leaves the path by {best:.3g} m"
    head = f"{plural}: the nearest {near}" if found else f"No {kind} was found along this path"
    words = {
        "order": "meets the points in another order, or parts on the way",
        "turn": "has no crank that turns fully",
        "large": f"has links longer than {LARGE:g} times the path",
        "transmission": f"has a transmission angle below {math.degrees(math.asin(limit)):.0f} deg",
    }
    better = {name: told[name] * size for name in words if told.get(name, np.inf) * size < best}
    nearer = [f"one that {words[name]} comes within {value:.2g} m" for name, value in better.items()]
    left = f" (left out: {'; '.join(nearer)}, on average)" if nearer else ""
    return f"{head}{left}."
