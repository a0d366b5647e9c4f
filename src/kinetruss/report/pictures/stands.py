"""A scene on paper: its parts at one sample as lines, faces, marks, arrows and names in parallel projection."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import LOAD, quantity
from kinetruss.report.pictures.labels import APART, FREE, Label, point_of
from kinetruss.report.pictures.specs import INK, QUIET, Area, Drawing, Stand
from kinetruss.viewer.loads_along import points_of
from kinetruss.viewer.places import Places

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.viewer import Scene

    Array = NDArray[np.float64]


VIEWS = {"iso": (-62.0, 16.0), "front": (-90.0, 0.0), "side": (0.0, 0.0), "top": (-90.0, 90.0)}
"""Azimuth and elevation of the views, degrees."""
NODES, MEMBERS = 24, 40
"""Number of nodes, and of members, up to which their names are shown by default."""
LONGEST, LEAST = 0.15, 0.06
"""Length of the longest arrow of all times, of the structure; share of the largest load below which none is drawn."""
EDGE = 1e-9
"""Size of a direction on paper up to which it points to the eye."""
BESIDE = 0.95
"""Cosine of the angle between an arrow and a member from which on they cover each other."""


def eye(view: str) -> NDArray[np.float64]:
    """Unit vector (3,) from the structure to the eye."""
    azimuth, elevation = np.radians(VIEWS[view])
    return np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)])


def projected(points: NDArray[np.float64], view: str = "iso") -> NDArray[np.float64]:
    """Points (.., 2) or (.., 3), m, on paper (.., 2): the plane as it is, space in parallel projection with z upright."""
    if points.shape[-1] == 2:
        return points
    toward = eye(view)
    right = np.array([-np.sin(np.radians(VIEWS[view][0])), np.cos(np.radians(VIEWS[view][0])), 0.0])
    seen: NDArray[np.float64] = points @ np.column_stack([right, np.cross(toward, right)])
    return seen


def stand(places: Places, view: str = "iso", *, sample: int | None = None, caption: str = "", **more: Any) -> Stand:
    """What is seen of a scene. sample : whose values of its channel colour members and faces. more : further fields."""
    corners, light, order = _lit(places.faces, view)
    values = faces = None
    if sample is not None and places.scene.header["channels"]:
        (channel,) = places.scene.header["channels"]
        values = places.scene.arrays[channel["array"]][sample][places.members]
        if channel.get("faces") in places.scene.arrays:
            faces = places.scene.arrays[channel["faces"]][sample][order]
    return Stand(
        caption=caption,
        lines=[projected(line, view) for line in places.lines],
        dots=projected(places.x[places.joined], view),
        bodies=projected(places.bodies, view),
        faces=corners,
        light=light,
        motors=projected(places.motors, view),
        supports=[(kind, projected(at, view), _upright(kind, projected(axes, view))) for kind, at, axes in places.supports],
        values=values,
        face_values=faces,
        **more,
    )


def shown_at(
    scene: Scene,
    captions: Sequence[str],
    view: str,
    *,
    loads: bool = True,
    names: bool | None = None,
    over: Sequence[tuple[Sequence[Area], Sequence[Label]]] = (),
) -> list[Stand]:
    """All samples of a scene with their loads and names. names : by default where there are not too many. over : of each sample
    the curves over the structure, and their values, which are written first.
    """
    found = []
    for k, caption in enumerate(captions):
        places = Places(scene, k)
        pairs = [pair for *pair, _ in arrows(places, k, view)] if loads else []
        drawn, values = over[k] if over else ((), ())
        labels = [*values, *named(places, view, names)]
        found.append(stand(places, view, sample=k, caption=caption, arrows=pairs, labels=labels, areas=drawn))
    return found


def drawing(scene: Scene, stands: Sequence[Stand], *, width: float, name: str = "", title: str = "", **more: Any) -> Drawing:
    """A drawing of a scene, `width` mm wide. more : further fields."""
    return Drawing(name=name, title=title, width=width, kinds=Places(scene).kinds, stands=stands, **more)


def arrows(places: Places, sample: int, view: str = "iso", least: float = LEAST) -> list[tuple[Array, Array, str]]:
    """Start and end on paper of the arrow of each load of more than a share of the largest of all times, and its value. It
    begins at its node, or ends there where it would else lie on a member; of pressures those that the scene has chosen.
    """
    header, forces = places.scene.header, places.scene.arrays["load_force"][sample]
    largest, found = header["largest_load"], []
    for one, force, point in zip(header["loads"], forces, points_of(header, places.x), strict=True):
        size = float(np.linalg.norm(force))
        if not one.get("drawn", True) or not size > least * largest:
            continue
        way = force * (LONGEST * header["extent"] / largest)
        # the tip of what acts between the ends of a member is on it
        ends = "node" not in one or _on_member(places, one["node"], way, view)
        start = point - (way if ends else 0.0)
        words = "" if one.get("pressure") or not one.get("words", True) else quantity(size, "N")
        if one.get("words") and "span" in one:
            words = quantity(size / one["span"], "N/m")
        found.append((projected(start, view), projected(start + way, view), words))
    return found


def values_of(drawn: Iterable[tuple[Array, Array, str]]) -> list[Label]:
    """The values of arrows, beside their middles."""
    return [Label(words=words, at=(start + end) / 2, colour=LOAD) for start, end, words in drawn if words]


def named(places: Places, view: str = "iso", names: bool | None = None) -> list[Label]:
    """Names of nodes, and of members where nothing crosses them."""
    header, found = places.scene.header, []
    if len(places.nodes) <= NODES if names is None else names:
        found += [
            Label(words=header["nodes"][k], at=projected(places.x[k], view), colour=INK, most=APART) for k in places.nodes
        ]
    if len(places.members) <= MEMBERS if names is None else names:
        lines, words = dict(zip(places.members, places.lines, strict=True)), dict(enumerate(header["members"]))
        for link in header["links"]:  # one name for all parts of a link, at the longest
            long = max(link["members"], key=lambda k: float(np.ptp(lines[k], axis=0).max()))
            words |= dict.fromkeys(link["members"], "") | {long: link["name"]}
        found += [
            Label(words=words[k], at=projected(line, view), colour=QUIET, most=FREE) for k, line in lines.items() if words[k]
        ]
    return found


def middle(places: Places, member: int, view: str = "iso") -> Array:
    """The point on paper halfway along a member, by its place among those shown."""
    return point_of(projected(places.lines[member], view))


def _upright(kind: str, axes: Array) -> Array:
    """Axes x, y (2, 2) of a symbol on paper: of a direction as it is seen, not shorter than half; of a rotation as they are."""
    if kind.startswith("turn"):
        return axes if axes.any() else np.eye(2)
    size = float(np.linalg.norm(axes[1]))
    y = axes[1] / size if size > EDGE else np.array([0.0, 1.0])
    return np.array([[y[1], -y[0]], y * max(size, 0.5)])


def _on_member(places: Places, node: int, way: Array, view: str) -> bool:
    """True if a member leaves a node in a direction on paper, and none in the opposite one."""
    x, ends = places.x, places.scene.arrays["ends"][places.members]
    sides = [projected(x[b if a == node else a] - x[node], view) for a, b in ends[(ends == node).any(axis=1)]]
    pointed = projected(way, view)
    size = np.linalg.norm(pointed) or 1.0
    cosines = [float(one @ pointed) / (float(np.linalg.norm(one)) or 1.0) / size for one in sides]
    return any(one > BESIDE for one in cosines) and not any(one < -BESIDE for one in cosines)


def _lit(corners: Array, view: str) -> tuple[Array, Array, NDArray[np.int64]]:
    """Faces (f, 3, 2) on paper, from back to front; their brightness (f,), 0 to 1; and their order."""
    if corners.shape[2] == 2 or not len(corners):
        return projected(corners, view), np.ones(len(corners)), np.arange(len(corners))
    toward = eye(view)
    order = np.argsort(corners.mean(axis=1) @ toward)
    corners = corners[order]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normal, axis=1)
    return projected(corners, view), np.abs(normal @ toward) / np.where(size > 0, size, 1.0), order
