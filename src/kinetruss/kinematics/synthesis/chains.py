"""Many four-bars or slider-cranks at once, in closed form: where they close, their branch, their order, their transmission.

The crank A-B has the angle phi. The other end C of the coupler B-C is on a circle about D, or on a line through D. With x the
angle of the crank from a direction of reference (A to D, or the normal of the line) the loop closes where low <= cos x <= high:

    circle: |D - B|^2 = g^2 + a^2 - 2 g a cos x  between (h - r)^2 and (h + r)^2;    line: |o + a cos x| <= h.

So x is free, or in one interval about 0 or pi, or in one of two that mirror each other.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]
    Complex = NDArray[np.complex128]

WITHIN = 1e-9
"""Slack of a cosine at the end of its interval."""

PLACES = 65
"""Places of the crank at which the transmission angle is taken between the first and the last position."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Chains:
    """Linkages (m,): fixed pivots, lengths of crank, coupler and rocker, m; the point p of the coupler at B, along B -> C.

    D : fixed pivot of the rocker, or a point of the line. r : length of the rocker, m. along : unit direction of the line, or
    None for four-bars. side : +1 or -1, C on the left or right of B -> D, or beyond or before the foot of B on the line.
    """

    A: Complex
    D: Complex
    a: Array
    h: Array
    r: Array
    side: Array
    p: Complex
    along: Complex | None = None

    def __getitem__(self, at: Any) -> Self:
        """Some of them."""
        own = {one.name: getattr(self, one.name) for one in fields(self)}
        some: dict[str, Any] = {name: value if value is None else value[at] for name, value in own.items()}
        return type(self)(**some)

    def __len__(self) -> int:
        return len(self.a)

    def moved_to(self, centre: complex, size: float) -> Self:
        """The same, larger by a factor and with the origin at a place."""
        A, D, p = centre + size * self.A, centre + size * self.D, size * self.p
        return replace(self, A=A, D=D, p=p, a=size * self.a, h=size * self.h, r=size * self.r)

    @property
    def reference(self) -> Array:
        """The direction from which x counts, rad."""
        return np.angle(self.D - self.A if self.along is None else 1j * self.along)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Least and largest cos x at which the loop closes; beyond -1 and 1 it does not matter."""
        with np.errstate(divide="ignore", invalid="ignore"):
            if self.along is None:
                g = abs(self.D - self.A)
                square, least, most = g**2 + self.a**2, (self.h - self.r) ** 2, (self.h + self.r) ** 2
                return (square - most) / (2 * g * self.a), (square - least) / (2 * g * self.a)
            o = (np.conj(1j * self.along) * (self.A - self.D)).real
            return (-self.h - o) / self.a, (self.h - o) / self.a

    @property
    def turns(self) -> NDArray[np.bool_]:
        """Whether the crank makes full turns."""
        low, high = self.bounds
        return (low <= -1) & (high >= 1)

    def moved(self, phi: Array) -> tuple[Complex, Complex, Complex]:
        """B, the unit direction of B -> C, and the point P, at crank angles phi (m, k), each (m, k).

        Where the loop is open, C lies as near as it can.
        """
        A, D, a, h, r, side, p = (one[:, None] for one in (self.A, self.D, self.a, self.h, self.r, self.side, self.p))
        B = A + a * np.exp(1j * phi)
        if self.along is None:
            way = D - B
            span = abs(way)
            cosine = np.clip((h**2 - r**2 + span**2) / (2 * h * span), -1, 1)
            turn = (cosine + 1j * side * np.sqrt(1 - cosine**2)) * way / span
        else:
            u = self.along[:, None]
            sine = np.clip((np.conj(1j * u) * (D - B)).real / h, -1, 1)
            turn = u * (side * np.sqrt(1 - sine**2) + 1j * sine)
        return B, turn, B + p * turn

    def transmission(self, phi: Array) -> Array:
        """Sine of the transmission angle at crank angles phi (m, k): of coupler and rocker, or coupler and normal of the line.

        It is 0 where the coupler cannot move the rocker or the slider.
        """
        B, turn, _ = self.moved(phi)
        if self.along is not None:
            return abs((np.conj(self.along)[:, None] * turn).real)
        rocker = (B + self.h[:, None] * turn - self.D[:, None]) / self.r[:, None]
        return abs((np.conj(turn) * rocker).imag)

    def unwrapped(self, phi: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Crank angles phi (m, k) as one motion through them in their order, rad, and whether there is one (m,).

        The crank turns in one sense, at most once, and stays where the loop closes.
        """
        reference = self.reference[:, None]
        low, high = self.bounds
        x = np.angle(np.exp(1j * (phi - reference)))
        about_pi = (low <= -1) & (high < 1)
        x = np.where(about_pi[:, None], np.mod(x, 2 * np.pi), x)
        closes = ((np.cos(x) >= low[:, None] - WITHIN) & (np.cos(x) <= high[:, None] + WITHIN)).all(1)
        one_interval = about_pi | ((high >= 1) & (low > -1)) | (np.sign(x) == np.sign(x[:, :1])).all(1)
        turns, forward = self.turns, np.mod(np.diff(x, axis=1), 2 * np.pi)
        on = turns & (forward.sum(1) <= 2 * np.pi + WITHIN)
        steps = np.where(turns[:, None], np.where(on[:, None], forward, forward - 2 * np.pi), np.diff(x, axis=1))
        ordered = (steps > 0).all(1) | (steps < 0).all(1)
        whole = abs(steps.sum(1)) <= 2 * np.pi + WITHIN
        course = x[:, :1] + np.concatenate([np.zeros_like(x[:, :1]), np.cumsum(steps, 1)], 1) + reference
        return course, closes & ordered & whole & (turns | one_interval)

    def worst_transmission(self, first: Array, last: Array) -> Array:
        """Least sine of the transmission angle between crank angles (m,)."""
        sines: Array = self.transmission(np.linspace(first, last, PLACES, axis=1)).min(1)
        return sines

    @property
    def size(self) -> Array:
        """The longest of crank, coupler, rocker and ground, and of the distances of P from B and C, m."""
        own = [self.a, self.h, abs(self.p), abs(self.p - self.h)]
        longest: Array = np.max([*own, self.r, abs(self.D - self.A)] if self.along is None else own, axis=0)
        return longest

    def words(self, at: int) -> str:
        """What the linkage is, by the rule of Grashof."""
        if self.along is not None:
            return "slider-crank" if self.turns[at] else "slider-crank whose crank rocks"
        links = {"ground": abs(self.D[at] - self.A[at]), "crank": self.a[at], "coupler": self.h[at], "rocker": self.r[at]}
        shortest, *_, longest = ranked = sorted(links, key=lambda name: float(links[name]))
        if links[shortest] + links[longest] >= sum(links[name] for name in ranked[1:3]):
            return "triple rocker"
        return {"ground": "double crank", "crank": "crank-rocker", "coupler": "double rocker", "rocker": "rocker-crank"}[
            shortest
        ]


def of(**given: ArrayLike) -> Chains:
    """Linkages from scalars and arrays."""
    kinds = {"A": complex, "D": complex, "p": complex, "along": complex}
    arrays = {name: np.asarray(value, dtype=kinds.get(name, float)) for name, value in given.items()}
    shape = np.broadcast_shapes(*(one.shape for one in arrays.values())) or (1,)
    return Chains(**{name: np.broadcast_to(one, shape) for name, one in arrays.items()})
