"""Bars of a scene as copies: round and rectangular ones, bent beams, the rods of active members, marks of their kinds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import DRIVEN, ELASTIC, THEMES
from kinetruss.viewer.films.copies import Copies, copies, striped

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.viewer.moving import Scene

    Array = NDArray[np.float64]
    Colours = NDArray[np.uint8]
    Owned = list[tuple[Copies, NDArray[np.int64]]]


RIM = 0.35
"""Width of the rim of a bar over its radius; it keeps pale colours visible."""
THIN = {"frame": 0.0, "free": 0.35, "screw": 0.35, "cable": 0.35, "elastic": 0.7, "base": 0.75, "tube": 1.5}
FLAT = 0.2
"""Smallest half height or width of a rectangle over the larger one, so that thin plates can be seen."""
PAPER = THEMES["light"]


class Bars:
    """The bars of a scene. usual : m, median length of a member; radius (members,), m, as drawn."""

    def __init__(self, scene: Scene, usual: float, radius: Array) -> None:
        self.scene, self.usual, self.radius = scene, usual, radius
        arrays, header = scene.arrays, scene.header
        self.ends = np.asarray(arrays["ends"], np.int64)
        self.two = np.array(header["two_rods"], np.int64)
        self.beams = np.asarray(arrays.get("beam_member", np.zeros(0)), np.int64)
        thin = np.array([THIN.get(kind, 1.0) for kind in header["kinds"]]) * radius
        half = np.asarray(arrays["box"], float)
        flat = np.isfinite(half).all(axis=1)
        flat[self.two] = False
        factor = radius / np.where(flat, half.max(axis=1), 1.0)
        self.high, self.wide = np.where(flat, np.maximum(factor * half.T, FLAT * radius), thin)
        single = np.ones(len(radius), np.bool_)
        single[self.two] = single[self.beams] = False
        self.straight: tuple[Any, Any] = np.flatnonzero(single & ~flat), np.flatnonzero(single & flat)
        bent = np.arange(len(self.beams))
        self.bent = bent[~flat[self.beams]], bent[flat[self.beams]]

    def drawn(self, x: Array, colours: Colours) -> tuple[Owned, Owned]:
        """Round and rectangular bars, each set with the members (copies,) that its copies belong to."""
        found: list[Owned] = []
        for box in (0, 1):
            own, beams = self.straight[box], self.bent[box]
            p, q = x[self.ends[own].T]
            some = [(self._copies(p, q, own, self._second(x, own) if box else None, colours), own)]
            if len(beams):
                start, end, second = self._curves(x, beams)
                owner = np.repeat(self.beams[beams], start.shape[1])
                p, q, across = (one.reshape(-1, 3) for one in (start, end, second))
                some.append((self._copies(p, q, owner, across if box else None, colours), owner))
            found.append(some)
        if len(self.two):
            found[0] += self._rods(x, colours)
        return found[0], found[1]

    def striped(self, several: Owned, hatched: NDArray[np.bool_], frame: int) -> list[Copies]:
        """The same with stripes; hatched over (frames, members)."""
        ever: NDArray[np.bool_] = np.asarray(hatched.any(axis=0))
        return [striped(some, ever[of], hatched[frame, of], PAPER["back"]) for some, of in several]

    def rims(self, x: Array) -> tuple[Copies, Copies]:
        """Rims of round and rectangular bars: their back sides, a little thicker."""
        least, found = 0.011 * self.usual, []
        for several in self.drawn(x, np.zeros((len(self.ends), 3), np.uint8)):
            one = Copies.all([some for some, _ in several])
            more = np.where(one.radius > 0, RIM * np.maximum(one.radius, least), 0.0)
            found.append(copies(one.start, one.end, one.radius + more, PAPER["outline"], one.second, one.wide + more))
        return found[0], found[1]

    def marks(self, x: Array) -> list[Copies]:
        """Collars of actuators at the free end of the tube, of driven bars in the middle; bands of springs."""
        p, q = x[self.ends.T]
        length, two = np.linalg.norm(q - p, axis=1), set(self.two.tolist())
        found = []
        for k, kind in enumerate(self.scene.header["kinds"]):
            if k in two:
                places, half, width, colour = [max(0.0, 1 - self.scene.arrays["rods"][k, 4] / length[k])], 1.6, 2.2, DRIVEN
            elif kind == "driven":
                places, half, width, colour = [0.5], 2.2, 1.8, DRIVEN
            elif kind == "elastic":
                places, half, width, colour = [0.3, 0.4, 0.5, 0.6, 0.7], 0.3, 1.7, ELASTIC
            else:
                continue
            middle = p[k] + np.array(places)[:, None] * (q[k] - p[k])
            reach = half * self.radius[k] * (q[k] - p[k]) / (length[k] or 1.0)
            found.append(copies(middle - reach, middle + reach, width * self.radius[k], colour))
        return found

    def lines(self, x: Array) -> tuple[Array, Array]:
        """Starts and ends (n, 3) of the axes of all bars that are shown."""
        both = [some for several in self.drawn(x, np.zeros((len(self.ends), 3), np.uint8)) for some, _ in several]
        every = Copies.all(both)
        return every.start[every.radius > 0], every.end[every.radius > 0]

    def _copies(self, p: Array, q: Array, own: Any, second: Array | None, colours: Colours) -> Copies:
        return copies(p, q, self.high[own], colours[own], second, self.wide[own])

    def _rods(self, x: Array, colours: Colours) -> Owned:
        """Base, tube and screw of active members."""
        a, b = x[self.ends[self.two].T]
        base, tube = (np.asarray(self.scene.arrays["rods"], float)[self.two, k] for k in (1, 4))
        r, c = self.radius[self.two], colours[self.two]
        parts = (
            (a, _toward(a, b, base), THIN["base"]),
            (_toward(b, a, tube), b, THIN["tube"]),
            (a, b, THIN["screw"]),
        )
        return [(copies(start, end, thin * r, c), self.two) for start, end, thin in parts]

    def _curves(self, x: Array, beams: Any) -> tuple[Array, Array, Array]:
        """Starts, ends and local axis 2 (beams, pieces, 3) of the straight pieces of beams."""
        arrays = self.scene.arrays
        nodes = x[np.asarray(arrays["beam_nodes"], int)[beams]]
        points, second = (
            np.einsum("kgv,kvc->kgc", np.asarray(arrays[name], float)[beams], nodes) for name in ("beam_along", "beam_across")
        )
        return points[:, :-1], points[:, 1:], second[:, :-1]

    def _second(self, x: Array, own: Any) -> Array:
        """Local axis 2 (n, 3) of straight members."""
        p, q = x[self.ends[own].T]
        u = q - p
        if self.scene.header["dim"] == 2:
            return np.column_stack([-u[:, 1], u[:, 0], np.zeros(len(u))])
        node = np.asarray(self.scene.arrays["orient"], int)[own]
        toward = np.where((node >= 0)[:, None], x[node] - p, np.asarray(self.scene.arrays["reference"], float)[own])
        three = np.cross(u, toward)
        found: Array = np.cross(three, u)
        return found


def _toward(p: Array, q: Array, size: Array) -> Array:
    """Points at a distance from p towards q, at most q."""
    length = np.linalg.norm(q - p, axis=1)
    part = np.minimum(size / np.where(length > 0, length, 1.0), 1.0)
    found: Array = p + part[:, None] * (q - p)
    return found
