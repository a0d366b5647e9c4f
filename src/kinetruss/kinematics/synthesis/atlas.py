"""An atlas of coupler curves, and which pieces of them resemble a path: starts for a fit.

Curves are compared as sequences of places, equally spaced along them, up to a shift, a turn and a scale: for z and p about
their means with sum |z|^2 = sum |p|^2 = 1, the least |p - c z|^2 over complex c is 1 - |sum conj(z) p|^2.

Source of the idea: J. A. Hrones, G. L. Nelson, Analysis of the Four-Bar Linkage (1951), an atlas of coupler curves.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from scipy.stats import qmc

from kinetruss.kinematics.synthesis.chains import Chains, of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.synthesis.dyads import Complex

TRIED = {True: 6000, False: 1500}
"""Linkages of which whole curves are drawn, or pieces, of each kind."""

PLACES = 96
"""Places of a curve over its whole travel."""

SHAPE = 24
"""Places of a piece by which it is compared."""

PIECES = [(start, length) for length in (0.12, 0.2, 0.35, 0.6, 0.9) for start in np.arange(0, 1, length / 2)]
"""Pieces of a curve that are compared with an open path: start and length, of its whole travel."""


@dataclass(frozen=True, eq=False)
class Pieces:
    """Pieces of curves: of which linkage (m,), over which crank angles (m, k), and their shape (m, `SHAPE`)."""

    chains: Chains
    of: NDArray[np.intp]
    angles: NDArray[np.float64]
    places: Complex
    shape: Complex


def starts(path: Complex, kind: str, *, closed: bool, count: int) -> tuple[Chains, NDArray[np.float64]]:
    """Linkages (count,), moved to where a piece of their curve is nearest to a path (k,), and crank angles there (count, k)."""
    pieces = _pieces(kind, closed)
    ways = [path, path[::-1]]
    matches = [_matches(pieces, one, closed) for one in ways]
    fit = np.concatenate([one for one, _ in matches])
    chosen: dict[int, int] = {}  # the best piece of each linkage
    for at in np.argsort(-fit):
        chosen.setdefault(int(pieces.of[at % len(pieces.of)]), int(at))
        if len(chosen) == count:
            break
    rows = []
    for at in chosen.values():
        back, piece = divmod(at, len(pieces.of))
        own = _angles(pieces, piece, int(matches[back][1][piece]), _lengths(ways[back], closed), closed)
        rows.append(own[::-1] if back else own)
    picked, angles = np.array(list(chosen.values())) % len(pieces.of), np.array(rows)
    chains = pieces.chains[pieces.of[picked]]
    drawn = chains.moved(angles)[2]
    middle, goal = drawn.mean(1), path.mean()
    change = ((drawn - middle[:, None]).conj() * (path - goal)).sum(1) / (abs(drawn - middle[:, None]) ** 2).sum(1)
    size = abs(change)
    placed = replace(
        chains.moved_to(0j, size),
        A=goal + change * (chains.A - middle),
        D=goal + change * (chains.D - middle),
        along=None if chains.along is None else chains.along * change / size,
    )
    return placed, angles + np.angle(change)[:, None]


def _matches(pieces: Pieces, path: Complex, closed: bool) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """How well each piece fits the path, 1 at best, and from which of its places on."""
    asked = _even(path, _lengths(path, closed), np.arange(SHAPE) / (SHAPE if closed else SHAPE - 1))
    asked = asked - asked.mean()
    asked /= np.linalg.norm(asked)
    if not closed:
        return abs(pieces.shape.conj() @ asked), np.zeros(len(pieces.of), dtype=int)
    match = abs(np.fft.ifft(np.fft.fft(asked)[None] * np.conj(np.fft.fft(pieces.shape, axis=1)), axis=1))
    return match.max(1), match.argmax(1)


def _angles(pieces: Pieces, at: int, shift: int, along: NDArray[np.float64], closed: bool) -> NDArray[np.float64]:
    """Crank angles (k,) at which the piece is as far along itself as the path is."""
    own = _lengths(pieces.places[at], closed)
    angles = pieces.angles[at]
    if not closed:
        return np.asarray(np.interp(along, own, angles), dtype=np.float64)
    turn = 2 * np.pi * np.sign(angles[1] - angles[0])
    wanted = along[:-1] - shift / SHAPE
    whole = np.floor(wanted)
    return np.asarray(np.interp(wanted - whole, own, [*angles, angles[0] + turn]) + turn * whole, dtype=np.float64)


def _lengths(places: Complex, closed: bool) -> NDArray[np.float64]:
    """Length along a polygon up to each of its corners, of the whole; of a closed one also the end, 1."""
    corners = np.append(places, places[0]) if closed else places
    along: NDArray[np.float64] = np.concatenate([[0.0], np.cumsum(abs(np.diff(corners)))])
    parts: NDArray[np.float64] = along / along[-1]
    return parts


def _even(places: Complex, along: NDArray[np.float64], at: NDArray[np.float64]) -> Complex:
    """Places of a polygon at parts of its length."""
    corners = np.append(places, places[0]) if len(along) > len(places) else places
    return np.interp(at, along, corners.real) + 1j * np.interp(at, along, corners.imag)


@lru_cache(maxsize=4)
def _pieces(kind: str, closed: bool) -> Pieces:
    """Pieces of the curves of many linkages of a kind; of closed paths whole curves of cranks that turn."""
    chains = _tried(kind, TRIED[closed])
    chains = chains[chains.turns] if closed else chains
    low, high = chains.bounds
    first = np.where(high >= 1, -np.arccos(np.clip(low, -1, 1)), np.arccos(np.clip(high, -1, 1)))
    last = np.where(low <= -1, 2 * np.pi - np.arccos(np.clip(high, -1, 1)), np.arccos(np.clip(low, -1, 1)))
    rim = 0.02 * (last - first)  # at the ends of its travel a linkage is stretched
    first, last = (np.where(chains.turns, value, moved) for value, moved in ((-np.pi, first + rim), (np.pi, last - rim)))
    count, members, angles = PLACES, np.arange(len(chains)), []
    if closed:
        angles = [first[:, None] + (last - first)[:, None] * np.arange(count) / count]
    else:
        own = []
        for start, length in PIECES:
            fits = chains.turns | (start + length <= 1)
            parts = start + length * np.linspace(0, 1, count // 3)
            angles.append(first[fits, None] + (last - first)[fits, None] * parts)
            own.append(members[fits])
        members = np.concatenate(own)
    every = np.concatenate(angles) + chains.reference[members][:, None]
    places = chains[members].moved(every)[2]
    at = np.arange(SHAPE) / (SHAPE if closed else SHAPE - 1)
    shape = np.array([_even(one, _lengths(one, closed), at) for one in places])
    shape -= shape.mean(1, keepdims=True)
    return Pieces(chains, members, every, places, shape / np.linalg.norm(shape, axis=1, keepdims=True))


def _tried(kind: str, count: int) -> Chains:
    """Linkages of the longest link 1 or so, evenly chosen."""
    u = qmc.Halton(6, seed=2).random(count).T
    a, h, r = (0.1 * 15**one for one in u[:3])  # 0.1 to 1.5 of the ground
    p = h * (0.5 + 1.5 * np.sqrt(u[3]) * np.exp(2j * np.pi * u[4]))
    side = np.where(u[5] < 0.5, -1.0, 1.0)
    if kind == "four-bar":
        chains = of(A=0.0, D=1.0, a=a, h=h, r=r, side=side, p=p)
    else:
        chains = of(A=0.0, D=1j * (r - 0.6) / 0.9 * h, a=a, h=h, r=0.0, side=1.0, p=p, along=1.0)
    low, high = chains.bounds
    return chains[(low < 0.95) & (high > -0.95) & (high - low > 0.1)]
