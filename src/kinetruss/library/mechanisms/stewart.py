"""The Stewart-Gough platform: six legs that change their length between a base and a body."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from kinetruss.library._builder import builder
from kinetruss.library._placing import bars_between, places, refuse, turned_about
from kinetruss.model import Angle, Bar, GravityVector, Length, Mass, Model, Node, PositiveLength, Quintic, Run, Series

__all__ = ["stewart"]

Triple = tuple[Length, Length, Length]
Six = Annotated[tuple[Triple, ...], Field(min_length=6, max_length=6), Series]

CLOSE = 1e-9
"""Two points of a body nearer than this fraction of its size are the same node."""


@builder("mechanisms.stewart")
def stewart(
    *,
    kind: Literal["6-6", "6-3", "3-3"] = "6-6",
    base_radius: PositiveLength = 0.5,
    platform_radius: PositiveLength = 0.3,
    base_spread: Angle = 0.5,
    platform_spread: Angle = 0.5,
    base_points: Six | None = None,
    platform_points: Six | None = None,
    at: Triple = (0.0, 0.0, 0.6),
    turned: tuple[Angle, Angle, Angle] = (0.0, 0.0, 0.0),
    apex: PositiveLength | None = None,
    leg_mass: Mass = 0.0,
    platform_mass: Mass = 0.0,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    title: str = "Stewart-Gough platform",
) -> Model:
    """A body on six driven bars ``leg1`` ... ``leg6``, from fixed nodes ``B1`` ... to nodes ``P1`` ... of the platform.

    Parameters
    ----------
    kind : joints on the base and on the platform. ``6-6``: twelve, on two circles in pairs; ``6-3``: the legs meet in
        pairs on the platform, a triangle; ``3-3``: also on the base, the octahedron.
    base_radius, platform_radius : of the circles, m. base_spread, platform_spread : angle of a pair of joints on the circle,
        rad. The pairs of the base are at 0, 120, 240 deg, those of the platform between them; each leg goes to the
        nearer pair.
    base_points, platform_points : six points each instead of the circles (legs in this order), the platform's in its own
        frame, m; equal points make one node. Any geometry will do.
    at, turned : place of the platform's origin, m, and roll, pitch, yaw, rad, at the start; R = Rz(yaw) Ry(pitch) Rx(roll).
    apex : distance of node ``Q`` from the middle of the platform's points, m; by default half their size. A platform of more
        than three points needs it: points in one plane would be stiff only to second order.
    leg_mass : of each leg, uniform, kg. platform_mass : in equal parts at its points, kg.
    gravity : m/s^2; None for none.

    Notes
    -----
    Six degrees of freedom before the drives. Lengths for a pose need no iteration, l_i = |p + R b_i - a_i|; poses for
    lengths are up to 40. `kinematics.inverse` with ``platform=("P1", "P2", ...)`` moves it. The hexagons with equal angles
    between all joints, similar and parallel, are singular in every pose without rotation.

    Raises
    ------
    ModelError : faults of the parameters; points on one line.

    Source
    ------
    V. E. Gough & S. G. Whitehall, Universal tyre test machine, Proc. 9th FISITA (1962) 117-137; D. Stewart, A platform with
    six degrees of freedom, Proc. IMechE 180 (1965) 371-386.

    Examples
    --------
    >>> model = stewart(kind="3-3")
    >>> len(model.nodes), sorted(model.bars)
    (6, ['P1-P2', 'P1-P3', 'P2-P3', 'leg1', 'leg2', 'leg3', 'leg4', 'leg5', 'leg6'])
    """
    low = _ring(base_radius, base_spread if kind != "3-3" else 0.0, 0.0) if base_points is None else np.array(base_points)
    spread = platform_spread if kind == "6-6" else 0.0
    own = (
        np.roll(_ring(platform_radius, spread, math.pi / 3), 1, axis=0)
        if platform_points is None
        else np.array(platform_points)
    )
    R = turned_about(2, turned[2]) @ turned_about(1, turned[1]) @ turned_about(0, turned[0])
    base, feet = _named("B", low)
    body, heads = _named("P", own)
    frame, extra = _platform(body, apex)
    share = platform_mass / len(body)
    top = places({name: np.array(at) + R @ place for name, place in (body | extra).items()})
    return Model(
        title=title,
        nodes=places(base) | {name: Node(at=place, mass=share if name in body else 0.0) for name, place in top.items()},
        fixed=list(base),
        bars=bars_between(frame)
        | {f"leg{k + 1}": Bar(ends=ends, kind="driven", mass=leg_mass) for k, ends in enumerate(zip(feet, heads, strict=True))},
        gravity=gravity,
        runs={"rise": Run(trajectory=_rise(base, top, feet, heads))},
    )


def _ring(radius: float, spread: float, turn: float) -> Any:
    """Three pairs of points on a circle, counter-clockwise from the first pair's right one, (6, 3), m."""
    angles = [turn + 2 * math.pi * k / 3 + side * spread / 2 for k in range(3) for side in (-1, 1)]
    return np.array([(radius * math.cos(a), radius * math.sin(a), 0.0) for a in angles])


def _named(letter: str, points: Any) -> tuple[dict[str, Any], list[str]]:
    """Nodes by name, and the node of each of the six points."""
    size = np.ptp(points, axis=0).max()
    nodes: dict[str, Any] = {}
    used = []
    for place in points:
        same = [name for name, other in nodes.items() if np.linalg.norm(place - other) <= CLOSE * size]
        name = same[0] if same else f"{letter}{len(nodes) + 1}"
        nodes.setdefault(name, place)
        used.append(name)
    return nodes, used


def _platform(body: dict[str, Any], apex: float | None) -> tuple[list[tuple[str, str]], dict[str, Any]]:
    """Bars of the platform, and its apex: a triangle needs none."""
    names, points = list(body), np.array(list(body.values()))
    middle = points.mean(axis=0)
    sizes, axes = np.linalg.svd(points - middle)[1:]
    if len(names) < 3 or sizes[1] <= CLOSE * sizes[0]:
        raise refuse("platform_points", "the points lie on one line.", "Give three at least that do not.")
    if len(names) == 3:
        return [(names[0], names[1]), (names[0], names[2]), (names[1], names[2])], {}
    up = axes[2] * math.copysign(1.0, axes[2][2] or 1.0)
    height = apex if apex is not None else float(np.ptp(points, axis=0).max()) / 2
    ring = sorted(names, key=lambda name: math.atan2(*((body[name] - middle) @ axes[1::-1].T)))
    sides = list(pairwise([*ring, ring[0]]))
    # a ring of n and its apex: n sides, n spokes, and n - 3 more that split the ring into triangles
    short = list(pairwise(ring[::2] + ring[:1])) if len(ring) == 6 else [(ring[0], other) for other in ring[2:-1]]
    return [*sides, *(("Q", name) for name in ring), *short], {"Q": middle - height * up}


def _rise(base: dict[str, Any], top: dict[str, Any], feet: list[str], heads: list[str]) -> Quintic:
    """All legs a tenth longer, in 1 s."""
    lengths = [math.dist(base[foot], top[head]) for foot, head in zip(feet, heads, strict=True)]
    return Quintic(moves={f"leg{k}": (length, 1.1 * length) for k, length in enumerate(lengths, start=1)}, duration=1.0)
