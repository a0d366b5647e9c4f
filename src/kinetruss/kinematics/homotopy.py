"""All solutions of small systems of quadratic equations, by following every path from a system whose solutions are known.

H(z, t) = (1 - t) F(z) + t g G(z) = 0 from t = 1 to 0 in projective coordinates z = (z_0, u), on a random plane a . z = 1, so
that paths to infinity stay bounded. G: z_i^2 = c_i z_0^2 (or z_i = c_i z_0 for a linear equation) with random c and a random
complex number g, for which no path meets another before t = 0, with probability one (A. J. Sommese & C. W. Wampler, The
Numerical Solution of Systems of Polynomials Arising in Engineering and Science, 2005, chapters 2 and 8).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


Array = Any

FAR = 1e-6
"""A path has gone to infinity if z_0 is below this fraction of z."""
SHORTEST = 1e-12
"""A path is abandoned if its step in t falls below this."""


@dataclass(frozen=True, eq=False)
class Quadratics:
    """n equations of n unknowns u: |D u + d|^2 = s, or n . (D u + d) = 0 if linear.

    D (n, 3, n), d (n, 3), s (n,), normal (n, 3), linear (n,) bool. Scaled by the caller so that u is of order 1.
    """

    D: NDArray[np.float64]
    d: Array
    s: Array
    normal: NDArray[np.float64]
    linear: NDArray[np.bool_]

    def at(self, z: Array) -> tuple[Array, Array]:
        """Homogenised values (paths, n) and gradients (paths, n, n + 1) by z = (z_0, u), z (paths, n + 1)."""
        d = np.einsum("mcn,pn->pmc", self.D, z[:, 1:]) + self.d * z[:, :1, None]
        value = np.einsum("pmc,pmc->pm", d, d) - self.s * z[:, :1] ** 2
        J = np.empty((*value.shape, z.shape[1]), complex)
        J[:, :, 1:] = 2 * np.einsum("pmc,mcn->pmn", d, self.D)
        J[:, :, 0] = 2 * np.einsum("pmc,mc->pm", d, self.d) - 2 * self.s * z[:, :1]
        if self.linear.any():
            k = self.linear
            value[:, k] = np.einsum("pmc,mc->pm", d[:, k], self.normal[k])
            J[:, k, 1:] = np.einsum("mcn,mc->mn", self.D[k], self.normal[k])
            J[:, k, 0] = np.einsum("mc,mc->m", self.d[k], self.normal[k])
        return value, J


@dataclass(frozen=True, eq=False)
class Solutions:
    """u (solutions, n), complex and finite; numbers of paths followed, gone to infinity, and lost (0: the list is complete)."""

    u: NDArray[np.complex128]
    paths: int
    infinite: int
    lost: int


@dataclass(eq=False)
class _Paths:
    """State of every path: z (paths, n + 1), t, step (paths,), and whether it is still being followed."""

    z: Array
    t: Array
    step: Array
    going: Array = field(init=False)

    def __post_init__(self) -> None:
        self.going = np.ones(len(self.t), np.bool_)


class _Powers:
    """The start system G: z_i^2 = (c_i z_0)^2, or z_i = c_i z_0 where linear."""

    def __init__(self, linear: NDArray[np.bool_], rng: np.random.Generator) -> None:
        n = len(linear)
        self.linear = linear
        self.roots = np.exp(2j * np.pi * rng.uniform(size=n)) * rng.uniform(0.5, 1.5, n)

    def solutions(self) -> Array:
        """All start solutions, (paths, n)."""
        return np.array([np.array(one) * self.roots for one in product(*[(1.0,) if k else (1.0, -1.0) for k in self.linear])])

    def at(self, z: Array) -> tuple[Array, Array]:
        """Like `Quadratics.at`."""
        own, first, n = z[:, 1:], z[:, :1], len(self.linear)
        value = np.where(self.linear, own - self.roots * first, own**2 - (self.roots * first) ** 2)
        J = np.zeros((len(z), n, n + 1), complex)
        index = np.arange(n)
        J[:, index, index + 1] = np.where(self.linear, 1.0, 2 * own)
        J[:, index, 0] = np.where(self.linear, -self.roots, -2 * self.roots**2 * first)
        return value, J


class _Homotopy:
    """H and its derivatives on the plane."""

    def __init__(self, target: Quadratics, start: Quadratics | _Powers, gamma: complex, rng: np.random.Generator) -> None:
        self.target, self.start, self.gamma = target, start, gamma
        n = len(start.linear)
        self.plane = rng.normal(size=n + 1) + 1j * rng.normal(size=n + 1)

    def at(self, z: Array, t: Array) -> tuple[Array, Array, Array]:
        """H with the plane (paths, n + 1), dH/dz (paths, n + 1, n + 1), dH/dt (paths, n + 1)."""
        F, FJ = self.target.at(z)
        G, GJ = self.start.at(z)
        G, GJ = self.gamma * G, self.gamma * GJ
        n, s = F.shape[1], t[:, None]
        H, J = np.empty((len(z), n + 1), complex), np.empty((len(z), n + 1, n + 1), complex)
        Ht = np.zeros_like(H)
        H[:, :n], H[:, n] = (1 - s) * F + s * G, z @ self.plane - 1
        J[:, :n], J[:, n] = (1 - s)[:, :, None] * FJ + s[:, :, None] * GJ, self.plane
        Ht[:, :n] = G - F
        return H, J, Ht


def solve_all(target: Quadratics, *, seed: int = 0) -> Solutions:
    """All finite solutions. If paths are lost, all are followed again with other random numbers, up to three times."""
    best = _from_powers(target, np.random.default_rng(seed))
    for again in (1, 2):
        if not best.lost:
            break
        found = _from_powers(target, np.random.default_rng(seed + again))
        best = found if found.lost < best.lost else best
    return best


def _from_powers(target: Quadratics, rng: np.random.Generator) -> Solutions:
    start = _Powers(target.linear, rng)
    return followed(_Homotopy(target, start, np.exp(2j * np.pi * rng.uniform()), rng), start.solutions())


def carry(target: Quadratics, source: Quadratics, solutions: Array) -> Solutions:
    """Solutions of a system from all those of a generic complex one with the same D.

    The straight line between the two stays in their family, so no solution is missed.
    """
    return followed(_Homotopy(target, source, 1.0, np.random.default_rng(7)), solutions)


def generic(target: Quadratics, apart: NDArray[np.bool_], *, seed: int = 0) -> Quadratics:
    """A complex system of the same family: other s, and other d of the rows `apart` (n,), at random."""
    rng = np.random.default_rng(seed)

    def moved(y: Array) -> Array:
        return y + 0.5 * (rng.normal(size=y.shape) + 1j * rng.normal(size=y.shape))

    return replace(target, d=np.where(apart[:, None], moved(target.d), target.d), s=moved(target.s))


def followed(homotopy: Any, solutions: Array) -> Solutions:
    """The ends of the paths from the solutions of the start system, given with or without their z_0 = 1.

    homotopy : has `plane`, `at` (see `_Homotopy`) and the `target`.
    """
    short = solutions.shape[1] < len(homotopy.plane)
    z = np.concatenate([np.ones((len(solutions), 1 if short else 0)), solutions], axis=1).astype(complex)
    paths = _Paths(z / (z @ homotopy.plane)[:, None], np.ones(len(z)), np.full(len(z), 0.02))
    done, infinite = np.zeros(len(z), np.bool_), np.zeros(len(z), np.bool_)
    with np.errstate(all="ignore"):  # paths that end at infinity overflow; they are recognised by their ends
        while paths.going.any():
            index = np.flatnonzero(paths.going)
            _step(homotopy, paths, index)
            t, size = paths.t[index], np.abs(paths.z[index, 0]) / np.linalg.norm(paths.z[index], axis=1)
            stuck = (paths.step[index] < SHORTEST) & (t > 0)
            done[index[t == 0]] = True
            infinite[index[((size < FAR) & (t < 0.01)) | (stuck & (size < 1e-3))]] = True
            paths.going[index[stuck]] = False
            paths.going[done | infinite] = False
        infinite |= done & (np.abs(paths.z[:, 0]) / np.linalg.norm(paths.z, axis=1) < 1e-6)
        finite = done & ~infinite
        u = _distinct(polished(homotopy.target, paths.z[finite, 1:] / paths.z[finite, :1]))
    return Solutions(u=u, paths=len(z), infinite=int(infinite.sum()), lost=int((~done & ~infinite).sum()))


def _step(homotopy: Any, paths: _Paths, index: NDArray[np.int64]) -> None:
    """One predictor-corrector step of the paths of `index`; the step size follows the convergence of Newton's method."""
    z, t = paths.z[index], paths.t[index]
    h = np.minimum(paths.step[index], t)
    h = np.where(t - h < 1e-14, t, h)
    guess = _predicted(homotopy, z, t, h)
    size = np.linalg.norm(z, axis=1)
    goal = np.where(t == h, 0.0, t - h)
    good = np.ones(len(z), np.bool_)
    for turn in range(3):
        H, J, _ = homotopy.at(guess, goal)
        change = _solve(J, H)
        guess = guess - change
        moved = np.linalg.norm(change, axis=1) / np.linalg.norm(guess, axis=1)
        good &= np.isfinite(moved) & (moved < (1e-3, 1e-5, 1e-9)[turn])
    good &= np.linalg.norm(guess - z, axis=1) < 0.3 * size
    at = index[good]
    new = guess[good]
    paths.z[at], paths.t[at] = new, goal[good]
    paths.step[at] = np.minimum(2.0 * h[good], 0.1)
    paths.step[index[~good]] = 0.25 * h[~good]


def _predicted(homotopy: Any, z: Array, t: Array, h: Array) -> Array:
    """Fourth-order prediction along dz/dt = -J^-1 dH/dt, from t to t - h."""
    step = h[:, None]

    def slope(where: Array, when: Array) -> Array:
        _, J, Ht = homotopy.at(where, when)
        return _solve(J, Ht)

    k1 = slope(z, t)
    k2 = slope(z + 0.5 * step * k1, t - 0.5 * h)
    k3 = slope(z + 0.5 * step * k2, t - 0.5 * h)
    k4 = slope(z + step * k3, t - h)
    return z + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def _solve(J: Array, b: Array) -> Array:
    """J^-1 b of every path; infinite if J is singular."""
    try:
        return np.linalg.solve(J, b[..., None])[..., 0]
    except np.linalg.LinAlgError:
        return np.full_like(b, np.inf)


def polished(target: Any, u: Array) -> Array:
    """Newton's method on the finite solutions themselves."""
    z = np.concatenate([np.ones((len(u), 1), complex), u], axis=1)
    for _ in range(5):
        value, J = target.at(z)
        change = _solve(J[:, :, 1:], value)
        z[:, 1:] -= np.where(np.isfinite(change), change, 0.0)
    return z[:, 1:]


def _distinct(u: Array) -> Array:
    kept: list[Array] = []
    for one in u:
        if all(np.linalg.norm(one - other) > 1e-7 * (1 + np.linalg.norm(one)) for other in kept):
            kept.append(one)
    return np.array(kept).reshape(-1, u.shape[1])
