"""STL of the bodies and bars of a model in a pose: bars as prisms, bodies as the convex hulls of their nodes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robots import LeftOut
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["stl_bytes"]

SIDES = 16
"""Of the prism that stands for a round bar."""
THIN = 0.005
"""Radius of a bar without section, relative to the size of the model."""
_ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def stl_bytes(model: Model, x: NDArray[np.float64]) -> tuple[bytes, list[LeftOut]]:
    """A binary STL, lengths in m, and the parts without a shape. x (n, 3), m."""
    left: list[LeftOut] = []
    triangles = [*_bodies(model, x, left), *_bars(model, x, left)]
    for table in ("beams", "membranes", "solids"):
        left += [LeftOut(table, name, "only bodies and bars have a shape") for name in getattr(model, table)]
    corners = np.concatenate(triangles) if triangles else np.zeros((0, 3, 3))
    rows = np.zeros(len(corners), _ROW)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    rows["normal"] = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    rows["corners"] = corners
    head = b"kinetruss, lengths in m".ljust(80)
    return head + len(rows).to_bytes(4, "little") + rows.tobytes(), left


def _bodies(model: Model, x: Any, left: list[LeftOut]) -> Iterator[NDArray[np.float64]]:
    from scipy.spatial import ConvexHull, QhullError

    place = {name: k for k, name in enumerate(model.nodes)}
    for name, body in model.bodies.items():
        points = x[[place[node] for node in body.nodes]]
        try:
            hull = ConvexHull(points)
        except (QhullError, ValueError):
            left.append(LeftOut("body", name, "its nodes span no volume"))
            continue
        faces = points[hull.simplices]
        outward = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
        inside = np.einsum("ij,ij->i", outward, hull.equations[:, :3]) < 0
        faces[inside] = faces[inside][:, [0, 2, 1]]
        yield faces


def _bars(model: Model, x: Any, left: list[LeftOut]) -> Iterator[NDArray[np.float64]]:
    """Prisms along bars and active members; braces are part of their body."""
    place = {name: k for k, name in enumerate(model.nodes)}
    size = float(np.ptp(x, axis=0).max()) or 1.0
    for name, member in model.members.items():
        if getattr(member, "brace", False):
            continue
        a, b = (x[place[node]] for node in member.ends)
        if not np.linalg.norm(b - a) > 0:
            left.append(LeftOut("member", name, "has no length in this pose"))
            continue
        section = model.section_of(getattr(member, "tube", member))
        radius = _radius(section) or THIN * size
        yield _prism(a, b, radius)


def _radius(section: Any) -> float:
    """Of the circle around a section, m; 0 without one of known shape."""
    if (outer := getattr(section, "outer", None) or getattr(section, "diameter", None)) is not None:
        return 0.5 * float(outer)
    if hasattr(section, "width"):
        return 0.5 * float(np.hypot(section.width, section.height))
    return 0.0


def _prism(a: Any, b: Any, radius: float) -> NDArray[np.float64]:
    """A closed prism of `SIDES` sides between two points, all triangles outwards."""
    along = (b - a) / np.linalg.norm(b - a)
    u = np.cross(along, np.eye(3)[int(np.argmin(np.abs(along)))])
    u /= np.linalg.norm(u)
    v = np.cross(along, u)
    turns = 2 * np.pi * np.arange(SIDES) / SIDES
    ring = radius * (np.cos(turns)[:, None] * u + np.sin(turns)[:, None] * v)
    low, high = a + ring, b + ring
    low_, high_ = np.roll(low, -1, axis=0), np.roll(high, -1, axis=0)
    ends = [np.broadcast_to(point, low.shape) for point in (a, b)]
    sides = [(low, low_, high_), (low, high_, high), (ends[0], low_, low), (ends[1], high, high_)]
    return np.concatenate([np.stack(one, axis=1) for one in sides])
