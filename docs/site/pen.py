"""A pen that writes SVG, and signs of machine elements between places, as textbooks draw them.

A sign has one size on paper. Places are (2,) arrays, y down.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from kinetruss.display import DRIVEN, ELASTIC

INK, FAINT, BODY = "#1d242b", "#5d6873", "#d3dbe4"


def unit(way: Any) -> Any:
    """Of length 1; along x if it has none."""
    size = float(np.linalg.norm(way))
    return np.asarray(way, float) / size if size else np.array([1.0, 0.0])


def across(way: Any) -> Any:
    """A quarter of a turn on."""
    return np.array([-way[1], way[0]])


def by(x: float, y: float) -> Any:
    """A way on paper."""
    return np.array([x, y], float)


class Pen:
    """Marks in four layers: 0 behind members, 1 members, 2 joints, 3 in front."""

    def __init__(self) -> None:
        self.marks: tuple[list[str], ...] = ([], [], [], [])
        self.box = np.array([[np.inf, np.inf], [-np.inf, -np.inf]])

    def text(self) -> str:
        """The file."""
        left, top = np.floor(self.box[0] - 4)
        wide, high = np.ceil(self.box[1] + 4) - (left, top)
        style = (
            f"path,line,circle,polygon{{stroke:{INK};stroke-width:1.6;fill:none;stroke-linecap:round;stroke-linejoin:round}}"
            f"text{{font:italic 13px 'DejaVu Sans',Verdana,sans-serif;fill:{INK};text-anchor:middle}}"
        )
        body = "\n".join(mark for layer in self.marks for mark in layer)
        frame = f'viewBox="{left:g} {top:g} {wide:g} {high:g}" width="{wide:g}" height="{high:g}"'
        return f'<svg xmlns="http://www.w3.org/2000/svg" {frame}>\n<style>{style}</style>\n{body}\n</svg>\n'

    def _seen(self, points: Any) -> None:
        self.box = np.array([np.minimum(self.box[0], np.min(points, axis=0)), np.maximum(self.box[1], np.max(points, axis=0))])

    def path(self, points: Iterable[Any], layer: int = 1, closed: bool = False, **style: Any) -> None:
        """A line through points."""
        points = [np.asarray(point, float) for point in points]
        self._seen(points)
        words = " L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self.marks[layer].append(f'<path d="M{words}{"Z" if closed else ""}"{self._style(style)}/>')

    def circle(self, at: Any, radius: float, layer: int = 1, **style: Any) -> None:
        """A circle."""
        self._seen([np.subtract(at, radius), np.add(at, radius)])
        self.marks[layer].append(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:.1f}"{self._style(style)}/>')

    def words(self, at: Any, text: str, **style: Any) -> None:
        """Words about a place."""
        reach = np.array([4.0 * len(text) + 2, 7.0])
        self._seen([at - reach, at + reach])
        self.marks[3].append(f'<text x="{at[0]:.1f}" y="{at[1] + 4.5:.1f}"{self._style(style)}>{text}</text>')

    def arrow(self, start: Any, end: Any, layer: int = 3, **style: Any) -> None:
        """An arrow with a full head."""
        way = unit(np.subtract(end, start))
        back, side = end - 9 * way, 3.6 * across(way)
        colour = style.get("stroke", INK)
        self.path([start, back], layer, **style)
        self.path([end, back + side, back - side], layer, closed=True, fill=colour, stroke=colour, stroke_width=0.8)

    def turning(self, centre: Any, radius: float, start: float, span: float, **style: Any) -> None:
        """An arc with a head, counter-clockwise on paper from an angle, rad."""
        turn = [centre + radius * np.array([math.cos(a), -math.sin(a)]) for a in np.linspace(start, start + span, 24)]
        self.path(turn[:-3], 3, **style)
        self.arrow(turn[-5], turn[-1], **style)

    def teeth(self, centre: Any, radius: float, colour: str = FAINT) -> None:
        """A gear wheel: its rim and its teeth."""
        count = max(10, round(radius / 1.6))
        step = math.pi * radius / count
        self.circle(centre, radius, 0, stroke=colour, stroke_width=5, stroke_linecap="butt", stroke_dasharray=f"{step:.2f}")
        self.circle(centre, radius - 2.5, 0, stroke=colour)

    @staticmethod
    def _style(style: dict[str, Any]) -> str:
        if not style:
            return ""
        return ' style="' + ";".join(f"{key.replace('_', '-')}:{value}" for key, value in style.items()) + '"'

    def ground(self, at: Any, out: Any, half: float = 13.0) -> None:
        """Hatched ground at a place; out : into it."""
        side = across(out)
        self.path([at - half * side, at + half * side], 2)
        for k in np.linspace(-half + 2, half - 3, 5):
            self.path([at + k * side, at + (k + 5) * side + 6 * out], 2, stroke_width=0.9)

    def coil(self, a: Any, b: Any, layer: int = 1, **style: Any) -> None:
        """A spring."""
        way, long = unit(b - a), float(np.linalg.norm(b - a))
        body = min(0.7 * long, 90.0)
        first, count = (long - body) / 2, max(4, int(body / 9))
        points = [a, a + first * way]
        points += [a + (first + body * (k + 0.5) / count) * way + (6 if k % 2 else -6) * across(way) for k in range(count)]
        self.path([*points, a + (first + body) * way, b], layer, **({"stroke": ELASTIC} | style))

    def dashpot(self, a: Any, b: Any, layer: int = 1) -> None:
        """A damper: a cup and a plate."""
        way, long = unit(b - a), float(np.linalg.norm(b - a))
        side, middle = 7 * across(way), a + 0.5 * (b - a)
        back, front = middle - min(14, 0.2 * long) * way, middle + min(14, 0.2 * long) * way
        self.path([a, back], layer, stroke=ELASTIC)
        self.path([front + side, back + side, back - side, front - side], layer, stroke=ELASTIC)
        self.path([middle + 0.7 * side, middle - 0.7 * side], layer, stroke=ELASTIC, stroke_width=2.4)
        self.path([middle, b], layer, stroke=ELASTIC)

    def cylinder(self, a: Any, b: Any, colour: str = INK) -> None:
        """A barrel at a, its piston and rod at b."""
        way, side = unit(b - a), 8 * across(unit(b - a))
        back, front, piston = (a + part * (b - a) for part in (0.12, 0.6, 0.42))
        self.path([a, back], 1, stroke_width=2.4)
        self.path([piston, b], 1, stroke=colour, stroke_width=3)
        self.path([back + side, front + side, front - side, back - side], 1, closed=True, fill="#ffffff", stroke_width=1.8)
        self.path([piston + 0.8 * side, piston - 0.8 * side], 1, stroke=colour, stroke_width=4)
        self.path([piston, front + 2 * way], 1, stroke=colour, stroke_width=3)

    def screw(self, a: Any, b: Any, colour: str = DRIVEN) -> None:
        """A thread."""
        way, side = unit(b - a), 5 * across(unit(b - a))
        self.path([a, b], 1, stroke=colour, stroke_width=2)
        for k in np.arange(12, float(np.linalg.norm(b - a)) - 6, 6):
            self.path([a + k * way - side, a + (k + 4) * way + side], 1, stroke=colour, stroke_width=1.2)
