"""Parallel robots: the Delta robot and the Stewart-Gough platform."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from kinetruss.library.building import builder
from kinetruss.library.placing import bars_between, leg_angle, places, point, refuse, turned_about
from kinetruss.model import (
    Angle,
    AngleDrive,
    Bar,
    Beam,
    Free,
    GravityVector,
    Length,
    Mass,
    Model,
    Node,
    PositiveLength,
    Quintic,
    Run,
    Series,
)
from kinetruss.model.bracing import CHORD

LIFT = -0.3
"""Angles of all arms in the run ``move``, rad."""
CORNERS = ("1a", "1b", "2a", "2b", "3a", "3b")
"""Corners of the platform in order: arm and side."""
SIDES = {"a": -1, "b": 1}
"""Bars of the plane of an arm."""


@builder("mechanisms.delta")
def delta(
    *,
    form: Literal["bars", "conventional"] = "bars",
    base: PositiveLength = 0.2,
    arm: PositiveLength = 0.35,
    rod: PositiveLength = 0.8,
    platform: PositiveLength = 0.09,
    at: tuple[Length, Length, Length] = (0.0, 0.0, -0.75),
    arm_mass: Mass = 0.6,
    rod_mass: Mass = 0.08,
    platform_mass: Mass = 0.5,
    arm_apex: PositiveLength = 0.06,
    platform_apex: PositiveLength = 0.05,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    title: str = "Delta robot",
) -> Model:
    """Three arms that turn about fixed axes, each with two parallel rods to a platform: 45 bars, 66 coordinates, 18 fixed.

    Arm k is at the azimuth 0, 120, 240 deg. Its nodes: ``Aka``, ``Akb`` on the fixed axis, ``Bka``, ``Bkb`` at the
    elbow, ``Ck`` off the plane of the four (a flat rectangle would be stiff only to second order). Rods run from ``Bka``,
    ``Bkb`` to the corners ``Pka``, ``Pkb`` of the platform, a regular hexagon; ``Q`` below its centre makes it a body
    of seven nodes and 15 bars: six sides, six spokes, three short diagonals. With three long diagonals instead, the number of
    bars is the same but the rank is 14: six points on a conic, joined as two threes (Bolker & Roth 1980).

    Or a conventional model of finite elements: 15 rigid beams with rotations at their nodes, three hinges and the six rods.
    An arm is a beam from ``Ak``, where a hinge joins it to the ground, to ``Ek``, and from there two to ``Bka`` and ``Bkb``;
    the platform is six beams from ``P`` to its corners. That is 19 places and, at both ends of each arm and at ``P``, seven
    rotations: 57 + 28 = 85 coordinates if each rotation is four Euler parameters, the number of the source. Here three
    vectors (nine coordinates) carry a rotation.

    Drives ``arm1``, ``arm2``, ``arm3`` are the angles of the arms, positive below the horizontal; run ``move`` lifts the
    platform, run ``fall`` releases it.

    Parameters
    ----------
    form : ``bars`` or ``conventional``.
    base : distance of the arms' axes from the centre, m. arm, rod : lengths, m. platform : circumradius of the hexagon, m;
        the rods of a pair are half of it to either side.
    at : centre of the hexagon at the start, m, z up.
    arm_mass : of each arm, as two uniform bars A-B, kg. rod_mass : of each of the six rods, kg. platform_mass : in six equal
        parts at the corners, kg.
    arm_apex, platform_apex : distance of the nodes C and Q from their planes, m.
    gravity : m/s^2; None for none.

    Notes
    -----
    Three degrees of freedom: the platform moves along x, y and z. Angle t of an arm:
    2 L (a cos t - z sin t) = |d|^2 + L^2 - l^2 with d = (a, s, z) from the arm's axis to the middle of its side of the
    platform, in the arm's own directions.

    Raises
    ------
    ModelError : faults of the parameters; a position that a rod does not reach.

    Source
    ------
    R. Clavel, Delta, a fast robot with parallel geometry, 18th Int. Symp. on Industrial Robots (1988) 91-100. The sizes and
    masses are an example, not those of a product.

    Examples
    --------
    >>> model = delta(at=(0.05, -0.08, -0.75))
    >>> len(model.bars), len(model.nodes), [round(x, 6) for x in model.nodes["B1a"].at]
    (45, 22, [0.542793, -0.045, -0.070663])
    """
    places_of: dict[str, Any] = {}
    bars: dict[str, Bar] = {}
    beams: dict[str, Beam] = {}
    angles = [_arm_angle(_azimuth(k), at, (base, arm, rod, platform), k + 1) for k in range(3)]
    for k, angle in enumerate(angles):
        R = _azimuth(k)
        if form == "bars":
            places_of |= _arm(R, angle, base, arm, platform / 2, arm_apex, k + 1)
            bars |= _arm_bars(k + 1, arm_mass)
        else:
            places_of |= _arm_of_beams(R, angle, base, arm, platform / 2, k + 1)
            beams |= _arm_beams(R, arm_mass, k + 1)
        places_of |= {f"P{k + 1}{s}": np.array(at) + R @ _corner(platform, s) for s in SIDES}
        bars |= bars_between([(f"B{k + 1}{s}", f"P{k + 1}{s}") for s in SIDES], mass=rod_mass)
    if form == "bars":
        places_of["Q"] = np.array(at) - (0, 0, platform_apex)
        bars |= bars_between(_platform_bars())
    else:
        places_of["P"] = np.array(at)
        beams |= {f"P-P{name}": Beam(ends=("P", f"P{name}"), kind="rigid", mass=0.0) for name in CORNERS}
    drives = {
        f"arm{k + 1}": AngleDrive(
            f"A{k + 1}a-B{k + 1}a" if form == "bars" else f"arm{k + 1}{CHORD}",
            axis=point(_azimuth(k)[:, 1]),
            reference=point(_azimuth(k)[:, 0]),
        )
        for k in range(3)
    }
    corners = {f"P{name}" for name in CORNERS}
    nodes = {
        name: Node(at=place, mass=platform_mass / 6 if name in corners else 0.0) for name, place in places(places_of).items()
    }
    ground = tuple(name for name in nodes if name.startswith("A"))
    return Model(
        title=title,
        nodes=nodes,
        bars=bars,
        **({"fixed": ground} if form == "bars" else {"clamped": ground, "beams": beams}),
        gravity=gravity,
        drives=drives,
        runs={
            "move": Run(
                trajectory=Quintic(
                    moves={name: (angle, angle + LIFT) for name, angle in zip(drives, angles, strict=True)}, duration=0.5
                )
            ),
            "fall": Run(analysis="dynamics.simulate", t_end=0.15, tasks=dict.fromkeys(drives, Free())),
        },
    )


def _azimuth(k: int) -> Any:
    """The directions of arm k: outwards, along its axis, up."""
    return turned_about(2, 2 * math.pi * k / 3)


def _corner(platform: float, side: str) -> Any:
    """Corners of the hexagon, from its centre, in the directions of the arm."""
    return np.array([platform * math.sqrt(3) / 2, SIDES[side] * platform / 2, 0.0])


def _arm_angle(R: Any, at: tuple[float, float, float], sizes: tuple[float, float, float, float], arm: int) -> float:
    """Angle of an arm below the horizontal, rad."""
    base, length, rod, platform = sizes
    x, y, z = R.T @ np.array(at)
    angle = leg_angle(x + platform * math.sqrt(3) / 2 - base, -z, y, length, rod)
    if angle is None:
        raise refuse("at", f"arm {arm} does not reach {tuple(at)} m.", "Move the platform nearer, or lengthen arm or rod.")
    return angle


def _arm(R: Any, angle: float, base: float, arm: float, half: float, apex: float, k: int) -> dict[str, Any]:
    """Nodes of an arm; C is off the middle of A and B, on the upper side."""
    out = np.array([math.cos(angle), 0.0, -math.sin(angle)])
    up = np.array([math.sin(angle), 0.0, math.cos(angle)])
    a, b = np.array([base, 0.0, 0.0]), np.array([0.0, half, 0.0])
    found = {
        f"{node}{k}{s}": R @ (a + far * out + sign * b) for node, far in (("A", 0.0), ("B", arm)) for s, sign in SIDES.items()
    }
    return found | {f"C{k}": R @ (a + arm / 2 * out + apex * up)}


def _arm_bars(k: int, arm_mass: float) -> dict[str, Bar]:
    """Eight bars of an arm; its axis lies between two fixed nodes and has none."""
    a, b, c = (f"A{k}a", f"A{k}b"), (f"B{k}a", f"B{k}b"), f"C{k}"
    return bars_between(zip(a, b, strict=True), mass=arm_mass / 2) | bars_between(
        [b, (a[0], b[1]), *((c, each) for each in (*a, *b))]
    )


def _arm_of_beams(R: Any, angle: float, base: float, arm: float, half: float, k: int) -> dict[str, Any]:
    """Nodes of an arm of beams: both ends, and the joints of the rods beside the second."""
    foot = np.array([base, 0.0, 0.0])
    end = foot + arm * np.array([math.cos(angle), 0.0, -math.sin(angle)])
    rods = {f"B{k}{s}": R @ (end + sign * half * np.array([0.0, 1.0, 0.0])) for s, sign in SIDES.items()}
    return {f"A{k}": R @ foot, f"E{k}": R @ end} | rods


def _arm_beams(R: Any, mass: float, k: int) -> dict[str, Beam]:
    """Three rigid beams; all of the mass is along the first."""
    arm = Beam(ends=(f"A{k}", f"E{k}"), kind="rigid", mass=mass, hinges={f"A{k}": point(R[:, 1])})
    return {f"arm{k}": arm} | {f"E{k}-B{k}{s}": Beam(ends=(f"E{k}", f"B{k}{s}"), kind="rigid", mass=0.0) for s in SIDES}


def _platform_bars() -> list[tuple[str, str]]:
    """Sides, spokes and short diagonals."""
    corners = [f"P{name}" for name in CORNERS]
    short = [(f"P{name}", f"P{other}") for name, other in pairwise(("1a", "2a", "3a", "1a"))]
    return [*pairwise([*corners, corners[0]]), *(("Q", corner) for corner in corners), *short]


# The Stewart-Gough platform: six legs that change their length between a base and a body.

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
