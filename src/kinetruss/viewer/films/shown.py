"""The geometry of a scene at one frame: rods, balls, cones and faces, the same as in the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import DRIVEN, KINDS, LOAD, SKINS, THEMES, colours_of, rgb
from kinetruss.viewer.films.bars import Bars
from kinetruss.viewer.films.copies import Copies, across, copies, plate, rounded

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.viewer.moving import Scene

    Array = NDArray[np.float64]


PAPER = THEMES["light"]
SUPPORT, BODY, TRACE, GHOST, NODE, GRID = PAPER["support"], "#3f4a55", PAPER["ink"], "#a8b0b9", PAPER["node"], PAPER["line"]
PRESSURE = 0.3
"""Length of pressure arrows as a fraction of other arrows, since many are next to each other."""
RING = np.column_stack([np.cos(np.arange(25) * np.pi / 12), np.sin(np.arange(25) * np.pi / 12), np.zeros(25)])


@dataclass(frozen=True, slots=True, kw_only=True)
class Look:
    """What to show in addition to the bars. mode : index of a shape to animate; paths : nodes whose path is drawn."""

    ghost: bool = False
    loads: bool = True
    supports: bool = True
    faces: bool = False
    grid: bool = True
    paths: tuple[int, ...] = ()
    mode: int | None = None


@dataclass(frozen=True)
class Subject:
    """A scene with the data for drawing; sizes as in the page."""

    scene: Scene
    look: Look

    @cached_property
    def places(self) -> Array:
        """Node positions (frames, nodes, 3), m."""
        position = np.asarray(self.scene.arrays["position"], float)
        return position if position.shape[2] == 3 else np.pad(position, ((0, 0), (0, 0), (0, 1)))

    @cached_property
    def ends(self) -> NDArray[np.int64]:
        """Nodes at the two ends of each member, (members, 2)."""
        return np.asarray(self.scene.arrays["ends"], np.int64)

    @cached_property
    def dim(self) -> int:
        """Number of dimensions, 2 or 3."""
        return int(self.scene.header["dim"])

    @cached_property
    def box(self) -> tuple[Array, Array]:
        """Smallest and largest coordinates over all frames, m."""
        return self.places.min(axis=(0, 1)), self.places.max(axis=(0, 1))

    @cached_property
    def size(self) -> float:
        """Diagonal of the box, m."""
        return float(np.linalg.norm(self.box[1] - self.box[0])) or 1.0

    @cached_property
    def usual(self) -> float:
        """Median length of a member, m."""
        p, q = self.places[0][self.ends.T]
        seen = [kind != "frame" for kind in self.scene.header["kinds"]]
        lengths = np.sort(np.linalg.norm(q - p, axis=1)[seen])
        return float(lengths[len(lengths) // 2]) if len(lengths) and lengths[len(lengths) // 2] else self.size / 4

    @cached_property
    def radius(self) -> Array:
        """Radius of each drawn member: that of its section, but thick enough to be visible."""
        found: Array = np.clip(np.nan_to_num(self.scene.arrays["radius"]), 0.011 * self.usual, 0.05 * self.usual)
        return found

    @cached_property
    def ball(self) -> float:
        """Radius of the balls at the nodes, m."""
        return 1.55 * float(self.radius.min(initial=0.02 * self.usual))

    def points(self, frame: int, swing: float = 0.0) -> Array:
        """Nodes (n, 3) at a frame, displaced by the mode (phase -1 to 1)."""
        found: Array = self.places[frame].copy()
        if self.look.mode is not None:
            shape = np.asarray(self.scene.arrays[f"mode_{self.look.mode}"], float)
            found[:, : shape.shape[1]] += swing * SWING * self.size / (np.abs(shape).max() or 1.0) * shape
        return found

    def values(self, channel: dict[str, Any]) -> Array:
        """A channel's values (frames, members); for a large scene the worst values of the run at every frame."""
        if "array" in channel:
            found = np.asarray(self.scene.arrays.get(channel["array"], np.full(len(self.ends), np.nan)), float)
        else:
            velocity = np.asarray(self.scene.arrays["velocity"], float)
            found = np.linalg.norm(velocity[:, self.ends].mean(axis=2), axis=2)
        return np.broadcast_to(found, (len(self.places), len(self.ends)))

    @cached_property
    def skin(self) -> NDArray[np.int64]:
        """Nodes (f, 3) of the faces of membranes and solids."""
        return np.asarray(self.scene.arrays.get("skin", np.zeros((0, 3))), np.int64)

    def shown_values(self, channel: dict[str, Any]) -> Array:
        """All values of a channel for the members that are shown and for faces, flat."""
        faces = self.scene.arrays.get(str(channel.get("faces")), np.zeros(0))
        seen = [kind != "frame" for kind in self.scene.header["kinds"]]
        return np.concatenate([self.values(channel)[:, seen].ravel(), np.asarray(faces, float).ravel()])

    def skin_colours(self, frame: int, channel: dict[str, Any] | None, limits: Sequence[float]) -> NDArray[np.uint8]:
        """Colours of faces (f, 3), 0 to 255: by value if the channel has values of faces, else by kind."""
        values = None if channel is None else self.scene.arrays.get(str(channel.get("faces")))
        if values is not None and channel is not None:
            return colours_of(channel["scale"], np.asarray(values[frame], float), limits)
        kinds = np.array([rgb(SKINS[one["kind"]]) for one in self.scene.header["skins"]], np.uint8).reshape(-1, 3)
        return kinds[np.asarray(self.scene.arrays["skin_part"], np.int64)] if len(self.skin) else kinds[:0]

    @cached_property
    def _sizes(self) -> Array:
        """Size of each node's ball: nodes of a mesh without members are small, or omitted if there are many."""
        found: Array = np.full(len(self.scene.header["nodes"]), self.ball)
        mesh = np.unique(self.skin)
        found[np.setdiff1d(mesh, self.ends)] *= 0.0 if len(mesh) > 300 else 0.6
        found[self.scene.header.get("directors", [])] = 0.0
        return found

    def colours(self, frame: int, channel: dict[str, Any] | None, limits: Sequence[float]) -> NDArray[np.uint8]:
        """Colours of members (members, 3), 0 to 255; without a channel by kind."""
        if channel is None:
            return np.array([rgb(KINDS[kind]) for kind in self.scene.header["kinds"]], np.uint8).reshape(-1, 3)
        return colours_of(channel["scale"], self.values(channel)[frame], limits)

    def hatched(self, channel: dict[str, Any] | None) -> NDArray[np.bool_]:
        """Mask (frames, members) of members that are striped: not checked, or a force that is not unique."""
        if channel is None or channel["id"] == "speed":
            return np.zeros((len(self.places), len(self.ends)), np.bool_)
        found = np.zeros((len(self.places), len(self.ends)), np.bool_) | np.isnan(self.values(channel))
        found[:, self.unsure] = True
        return found

    @cached_property
    def unsure(self) -> list[int]:
        """Members whose force is not unique."""
        index = {name: k for k, name in enumerate(self.scene.header["members"])}
        return [index[name] for name in self.scene.header["not_unique"] if name in index]

    @cached_property
    def bars(self) -> Bars:
        """Round and rectangular bars, beams and marks."""
        return Bars(self.scene, self.usual, self.radius)

    def rods(
        self, frame: int, x: Array, colours: NDArray[np.uint8], hatched: NDArray[np.bool_] | None = None
    ) -> tuple[Copies, Copies]:
        """Round bars, marks of their kinds, shafts of arrows, rings of motors; and rectangular bars.

        hatched : over (frames, members).
        """
        stripes = hatched is not None and bool(hatched.any())
        round_, flat = (
            self.bars.striped(one, hatched, frame) if stripes and hatched is not None else [some for some, _ in one]
            for one in self.bars.drawn(x, colours)
        )
        shafts, _ = self._arrows(frame, x)
        return Copies.all([*round_, *self.bars.marks(x), shafts, self._rings(x)]), Copies.all(flat)

    def cones(self, frame: int, x: Array) -> Copies:
        """Supports and heads of arrows."""
        node, towards = self._held
        size = 0.1 * self.usual
        feet = copies(x[node] - size * towards, x[node], 0.55 * size, SUPPORT)
        return Copies.all([feet, self._arrows(frame, x)[1]])

    def balls(self, x: Array) -> Copies:
        """Nodes, and centres of planar bodies; from the centre to a pole."""
        bodies = self._centres(x)
        found = [(x, self._sizes, NODE), (bodies, np.full(len(bodies), 0.025 * self.usual), BODY)]
        up = np.array([0.0, 0.0, 1.0])
        return Copies.all([copies(at, at + size[:, None] * up, size, colour) for at, size, colour in found])

    def bodies(self, x: Array) -> Array:
        """Corners (n, 3, 3) of the faces of bodies: plates with round corners in the plane, hulls in space."""
        found = [x[np.array(self.scene.header["solids"], int).reshape(-1, 3)]]
        for k, (body, outline) in enumerate(zip(self.scene.header["bodies"], self._outlines, strict=True)):
            p, q = x[self.ends[body["member"]]]
            # plates that overlap lie above each other by less than can be seen
            found.append(plate(outline, p, q, self.ball * (0.25 + 0.01 * k)))
        return np.concatenate(found)

    def triangles(self, x: Array) -> Array:
        """Corners (n, 3, 3) of triangles of rigid bars, if requested."""
        shown = self.scene.header["triangles"] if self.look.faces else []
        found: Array = x[np.array(shown, int).reshape(-1, 3)]
        return found

    @cached_property
    def _outlines(self) -> list[Array]:
        """Outlines (k, 2) of planar bodies in the axes of their bar."""
        found = []
        for body in self.scene.header["bodies"]:
            p, q = self.places[0][self.ends[body["member"]]]
            corners = np.array([(0.0, 0.0), (np.linalg.norm(q - p), 0.0), body["center"]])
            found.append(rounded(corners, 1.9 * self.ball))
        return found

    def tips(self) -> Array:
        """Points other than nodes that must be in the picture (n, 3), over all frames."""
        found = []
        if self.look.loads and self._loads:
            node, force = self._loads
            found.append((self.places[:, node] + force).reshape(-1, 3))
        if self.look.mode is not None:
            found += [self.points(0, 1.0), self.points(0, -1.0)]
        if self.look.grid:
            found += self.grid()
        node, towards = self._held
        found.append((self.places[:, node] - 0.1 * self.usual * towards).reshape(-1, 3))
        return np.concatenate(found)

    @cached_property
    def _held(self) -> tuple[NDArray[np.int64], Array]:
        """Supported nodes, and the directions of their cones: vertical if all axes are fixed."""
        upright = 1 if self.dim == 2 else 2
        middle = (self.box[0] + self.box[1])[upright] / 2
        node, towards = [], []
        for held in self.scene.header["supports"] if self.look.supports else ():
            k, axes = int(held["node"]), sorted(held["axes"])
            if axes == sorted("xyz"[: self.dim]):
                axes = ["-xyz"[1 + upright]]
                sign = -1.0 if self.places[0, k, upright] > middle + 1e-9 else 1.0
            else:
                sign = 1.0
            for axis in axes:
                node.append(k)
                towards.append(sign * np.eye(3)["xyz".index(axis)])
        return np.array(node, int), np.array(towards, float).reshape(-1, 3)

    @cached_property
    def _loads(self) -> tuple[NDArray[np.int64], Array] | None:
        """Nodes of the loads, and arrows (frames, loads, 3), the longest 16 % of the size of the structure."""
        force = self.scene.arrays.get("load_force")
        if force is None or not len(self.scene.header["loads"]):
            return None
        force = np.pad(np.asarray(force, float), ((0, 0), (0, 0), (0, 3 - self.dim)))
        largest = float(np.linalg.norm(force, axis=2).max(initial=0.0))
        loads = self.scene.header["loads"]
        node = np.array([one["node"] for one in loads], int)
        part = np.array([one.get("drawn", True) * (PRESSURE if one.get("pressure") else 1.0) for one in loads])
        return node, part[:, None] * force * (0.16 * self.size / largest if largest else 0.0)

    def _arrows(self, frame: int, x: Array) -> tuple[Copies, Copies]:
        """Shafts and heads of loads and of prescribed coordinates; very short ones get radius 0."""
        from_, vector, radius, colour = [np.zeros((0, 3))], [np.zeros((0, 3))], [np.zeros(0)], [np.zeros((0, 3))]
        if self.look.loads and self._loads:
            node, force = self._loads
            from_, vector = [*from_, x[node]], [*vector, force[frame]]
            radius, colour = [*radius, np.full(len(node), 0.009 * self.usual)], [*colour, np.tile(rgb(LOAD), (len(node), 1))]
        for drive in self.scene.header["drives"]:
            if drive["kind"] == "coordinate":
                axis = np.eye(3)["xyz".index(drive["axis"])]
                from_, vector = [*from_, x[drive["node"]][None]], [*vector, 0.25 * self.usual * axis[None]]
                radius, colour = [*radius, np.array([0.015 * self.usual])], [*colour, rgb(DRIVEN)[None]]
        start, along, r, c = (np.concatenate(one) for one in (from_, vector, radius, colour))
        length = np.linalg.norm(along, axis=1)
        r = np.where(length > 2 * r, r, 0.0)
        head = np.minimum(5 * r, length / 2)
        neck = start + along * (1 - head / np.where(length > 0, length, 1.0))[:, None]
        return copies(start, neck, r, c), copies(neck, start + along, 2.4 * r, c)

    def _rings(self, x: Array) -> Copies:
        """A ring about the axis of each motor: at the first end of its bar, or in the middle of its hinge."""
        found = []
        for drive in self.scene.header["drives"]:
            if drive["kind"] == "angle":
                at, about = x[self.ends[drive["member"], 0]], np.array(drive.get("about", (0.0, 0.0, 1.0)))
            elif drive["kind"] == "hinge":
                axis = x[drive["axis"]]
                at, about = axis.mean(axis=0), axis[1] - axis[0] if len(axis) == 2 else np.array([0.0, 0.0, 1.0])
            else:
                continue
            found.append(at + 0.075 * self.usual * RING @ np.concatenate(across(about[None])))
        return Copies.all([copies(one[:-1], one[1:], 0.015 * self.usual, DRIVEN) for one in found])

    def _centres(self, x: Array) -> Array:
        """Centres of mass (bodies, 3) of planar bodies."""
        bodies = self.scene.header["bodies"]
        if not bodies:
            return np.zeros((0, 3))
        p, q = x[self.ends[[body["member"] for body in bodies]].T]
        u = (q - p) / np.linalg.norm(q - p, axis=1, keepdims=True)
        e, f = np.array([body["center"] for body in bodies], float).T[:, :, None]
        left = np.column_stack([-u[:, 1], u[:, 0], np.zeros(len(u))])
        found: Array = p + e * u + f * left
        return found

    def lines(self) -> Copies:
        """Lines that do not move: the start pose, paths of nodes, the grid on the ground."""
        found = []
        fine = 0.001 * self.size
        if self.look.ghost:
            edges = np.sort(self.skin[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
            start, end = self.bars.lines(self.places[0])
            p, q = self.places[0][np.unique(edges, axis=0).T]
            found.append(copies(np.concatenate([start, p]), np.concatenate([end, q]), fine, GHOST))
        for node in self.look.paths:
            way = self.places[:, node]
            found.append(copies(way[:-1], way[1:], 2 * fine, TRACE))
        if self.look.grid:
            start, end = self.grid()
            found.append(copies(start, end, fine, GRID))
        return Copies.all(found)

    @cached_property
    def step(self) -> float:
        """Spacing of the grid lines, m: 1, 2 or 5 times a power of ten."""
        power = 10.0 ** np.floor(np.log10(self.size / 8))
        return float(power * max(one for one in (1, 2, 5) if one * power <= self.size / 8 * (1 + 1e-9)))

    def grid(self) -> tuple[Array, Array]:
        """Grid lines below the structure (behind it in the plane) at round coordinates: starts and ends (n, 3)."""
        low, high = self.box
        below = max(0.03 * ((high - low)[2] or self.size), 0.1 * self.usual if len(self._held[0]) else 0.0)
        level = -0.08 * self.usual if self.dim == 2 else low[2] - below
        first, last = (np.floor(low[:2] / self.step - 0.2), np.ceil(high[:2] / self.step + 0.2))
        found = []
        for axis in (0, 1):
            rest = 1 - axis
            for at in np.arange(first[axis], last[axis] + 1):
                line = np.full((2, 3), level)
                line[:, axis] = at * self.step
                line[:, rest] = first[rest] * self.step, last[rest] * self.step
                found.append(line)
        lines = np.array(found)
        return lines[:, 0], lines[:, 1]


SWING = 0.08
"""Amplitude of a mode as a fraction of the size of the structure."""
