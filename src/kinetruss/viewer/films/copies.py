"""Many rods, balls and cones as copies of one shape, placed and coloured as arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import rgb

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


STRIPES, SEVERAL = 25, 300
"""Number of stripes of a bar, and of striped bars above which there are a third as many."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Copies:
    """Copies of a shape: start (n, 3), end (n, 3), m; radius (n,), m; colour (n, 3), 0 to 255; second (n, 3) a direction
    across, 0 if any will do; wide (n,), m, the radius across both.
    """

    start: Array
    end: Array
    radius: Array
    colour: NDArray[np.uint8]
    second: Array
    wide: Array

    @classmethod
    def all(cls, several: Sequence[Copies]) -> Copies:
        """Several sets of copies, joined."""
        kept = [one for one in several if len(one.radius)]
        if not kept:
            return copies(np.zeros((0, 3)), np.zeros((0, 3)), 0.0, np.zeros((0, 3)))
        return cls(**{name: np.concatenate([getattr(one, name) for one in kept]) for name in cls.__slots__})


def copies(
    start: Array, end: Array, radius: Array | float, colour: Any, second: Array | None = None, wide: Array | None = None
) -> Copies:
    """Copies with one colour, or one colour each; round ones, or with a direction across and another radius across both."""
    count = len(start)
    shade = np.array(rgb(colour) if isinstance(colour, str) else colour, np.uint8)
    return Copies(
        start=start,
        end=end,
        radius=np.broadcast_to(np.asarray(radius, float), count).copy(),
        colour=np.broadcast_to(shade, (count, 3)).copy(),
        second=np.zeros((count, 3)) if second is None else second,
        wide=np.broadcast_to(np.asarray(radius if wide is None else wide, float), count).copy(),
    )


def striped(several: Copies, ever: NDArray[np.bool_], now: NDArray[np.bool_], pale: str) -> Copies:
    """Bars of which those that are `ever` striped are cut into pieces; every other piece has the pale colour if they are `now`.

    The number of copies does not change in time.
    """
    count = STRIPES if ever.sum() <= SEVERAL else STRIPES // 3
    cut = {name: getattr(several, name)[ever] for name in Copies.__slots__}
    along, light = cut["end"] - cut["start"], rgb(pale)
    found = [Copies(**{name: getattr(several, name)[~ever] for name in Copies.__slots__})]
    for k in range(count):
        start, end = (cut["start"] + (k + one) / count * along for one in (0, 1))
        colour = np.where(now[ever][:, None] & bool(k % 2), light, cut["colour"])
        found.append(copies(start, end, cut["radius"], colour, cut["second"], cut["wide"]))
    return Copies.all(found)


# Thousands of rods, balls and cones: copies of one shape of revolution, placed and coloured as arrays.


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Turned:
    """A shape about an axis: points (k, 3) and normals (k, 3), last component along the axis; quads (m, 4)."""

    points: Array
    normals: Array
    quads: NDArray[np.int64]

    def faces(self, count: int) -> NDArray[np.int64]:
        """Faces of `count` copies, flat, each preceded by its number of corners."""
        quads = (self.quads[None] + len(self.points) * np.arange(count)[:, None, None]).reshape(-1, 4)
        return np.column_stack([np.full(len(quads), 4), quads]).ravel()

    def placed(self, several: Copies) -> tuple[Array, Array]:
        """Points and normals (copies * k, 3) of copies."""
        start, along = several.start, several.end - several.start
        u, v, w = across(along, several.second)
        frame = np.stack([u * several.radius[:, None], v * several.wide[:, None], along], axis=1)
        points = start[:, None] + np.einsum("kj,cji->cki", self.points, frame)
        normals = np.einsum("kj,cji->cki", self.normals, np.stack([u, v, w], axis=1))
        return points.reshape(-1, 3), normals.reshape(-1, 3)

    def spread(self, values: NDArray[Any]) -> NDArray[Any]:
        """Values of copies (copies, ..), repeated for their points."""
        return np.repeat(values, len(self.points), axis=0)


def across(along: Array, second: Array | None = None) -> tuple[Array, Array, Array]:
    """Two unit vectors normal to each direction (n, 3), and its own unit vector; arbitrary if it has no length.

    second (n, 3) : directions nearest to which the first of them are, if they are not 0 or along the axis.
    """
    size = np.linalg.norm(along, axis=1, keepdims=True)
    w = np.divide(along, size, out=np.tile([0.0, 0.0, 1.0], (len(along), 1)), where=size > 0)
    helper = np.where(np.abs(w[:, :1]) > 0.7, [[0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0]])
    u = np.cross(helper, w)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    if second is not None:
        beside = second - w * np.sum(w * second, axis=1, keepdims=True)
        far = np.linalg.norm(beside, axis=1, keepdims=True)
        u = np.divide(beside, far, out=u, where=far > 1e-9 * np.linalg.norm(second, axis=1, keepdims=True))
    return u, np.cross(w, u), w


def rod(sides: int, *, closed: bool = True) -> Turned:
    """A cylinder. closed : with its ends."""
    if not closed:
        return _turned([(1, 0), (1, 1)], [(1, 0), (1, 0)], sides)
    return _turned([(0, 0), (1, 0), (1, 0), (1, 1), (1, 1), (0, 1)], [(0, -1), (0, -1), (1, 0), (1, 0), (0, 1), (0, 1)], sides)


def box(*, closed: bool = True) -> Turned:
    """A box of half height and width 1. closed : with its ends."""
    corners = np.array([(1, -1), (1, 1), (-1, 1), (-1, -1)], float)
    points, normals = [], []
    for k in range(4):
        a, b = corners[k], corners[(k + 1) % 4]
        points += [(*a, 0), (*b, 0), (*b, 1), (*a, 1)]
        normals += [(*((a + b) / 2), 0)] * 4
    for z, order in ((0, (3, 2, 1, 0)), (1, (0, 1, 2, 3))) if closed else ():
        points += [(*corners[k], z) for k in order]
        normals += [(0, 0, 2 * z - 1)] * 4
    quads = np.arange(len(points)).reshape(-1, 4)
    return Turned(points=np.array(points, float), normals=np.array(normals, float), quads=quads)


def cone(sides: int) -> Turned:
    """A cone whose tip is its end."""
    slope = np.sqrt(0.5)
    return _turned([(0, 0), (1, 0), (1, 0), (0, 1)], [(0, -1), (0, -1), (slope, slope), (slope, slope)], sides)


def ball(sides: int) -> Turned:
    """A ball about its start; its end is one radius away, in any direction."""
    angle = np.linspace(0, np.pi, sides // 2 + 1)
    ring = np.column_stack([np.sin(angle), -np.cos(angle)])
    return _turned(ring, ring, sides)


def _turned(profile: Any, normals: Any, sides: int) -> Turned:
    """Points of a profile (r, z), rotated about z in steps."""
    turn = np.arange(sides) * 2 * np.pi / sides
    rings = np.array(profile, float), np.array(normals, float)
    points, outward = (
        np.stack(
            [one[:, None, 0] * np.cos(turn), one[:, None, 0] * np.sin(turn), np.tile(one[:, None, 1], sides)], axis=2
        ).reshape(-1, 3)
        for one in rings
    )
    k, j = np.meshgrid(np.arange(len(rings[0]) - 1), np.arange(sides), indexing="ij")
    after = (j + 1) % sides
    quads = np.stack([k * sides + j, k * sides + after, (k + 1) * sides + after, (k + 1) * sides + j], axis=2)
    return Turned(points=points, normals=outward, quads=quads.reshape(-1, 4))


def rounded(corners: Array, radius: float) -> Array:
    """The convex outline (k, 2), counterclockwise, of circles about corners (n, 2)."""
    from scipy.spatial import ConvexHull

    angle = np.arange(24) * np.pi / 12
    points = (corners[:, None] + radius * np.column_stack([np.cos(angle), np.sin(angle)])).reshape(-1, 2)
    found: Array = points[ConvexHull(points).vertices]
    return found


def plate(outline: Array, p: Array, q: Array, half: float) -> Array:
    """Triangles (m, 3, 3) of a plate in the x-y plane: outline (k, 2) in the axes of the line from p to q, half its depth."""
    u = (q - p) / np.linalg.norm(q - p)
    flat = p + outline[:, :1] * u + outline[:, 1:] * np.array([-u[1], u[0], 0.0])
    top, low = (flat + np.array([0.0, 0.0, one]) for one in (half, -half))
    after, below = np.roll(top, -1, axis=0), np.roll(low, -1, axis=0)
    fans = [np.stack([np.broadcast_to(x[0], x[2:].shape), x[1:-1], x[2:]], axis=1) for x in (top, low)]
    return np.concatenate([*fans, np.stack([top, low, after], axis=1), np.stack([low, below, after], axis=1)])
