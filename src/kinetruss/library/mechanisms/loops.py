"""Overconstrained loops of skew hinges: Bennett, Bricard, Sarrus; and hinges through one point."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from kinetruss.library.building import builder
from kinetruss.library.placing import bars_between, does_not_close, places, refuse, turned_about
from kinetruss.model import Angle, CoordinateDrive, Cyclic, GravityVector, Mass, Model, PositiveLength, PositiveTime, Run

Link = tuple[float, float, float]
"""Angle of the hinge before the link, length of the link, twist of the hinge after it."""


@builder("mechanisms.bennett")
def bennett(
    *,
    length: PositiveLength = 0.3,
    twist: Angle = 0.7,
    other_twist: Angle = 1.3,
    angle: Angle = 1.0,
    hinge: PositiveLength = 0.1,
    mass: Mass = 1.0,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    duration: PositiveTime = 1.0,
    title: str = "Bennett's linkage",
) -> Model:
    """Four links, four skew hinges and one degree of freedom, while the count for a loop of four hinges gives -2.

    Opposite links are equal: length a and twist alpha, length b and twist beta with a/sin alpha = b/sin beta. Hinge k has the
    nodes ``Pk``, ``Ak``; each link is the tetrahedron of two hinges; the link of hinges 4 and 1 is fixed. 14 bars hold 12
    coordinates with rank 11: 1 mechanism, 3 states of self-stress. Run ``fall`` lets it go.

    Parameters
    ----------
    length : a, m. twist, other_twist : alpha, beta, rad; b follows. angle : of hinge 1 at the start, rad.
    hinge : length of the hinges, m. mass : of each link P-P, uniform, kg. gravity : m/s^2; None for none.
    duration : of the run, s.

    Notes
    -----
    Opposite hinge angles add to a full turn; tan(t1/2) tan(t2/2) = sin((beta + alpha)/2)/sin((beta - alpha)/2).

    Raises
    ------
    ModelError : faults of the parameters; equal or vanishing twists.

    Source
    ------
    G. T. Bennett, A new mechanism, Engineering 76 (1903) 777-778.

    Examples
    --------
    >>> model = bennett()
    >>> len(model.bars), len(model.nodes), sorted(model.fixed)
    (14, 8, ['A1', 'A4', 'P1', 'P4'])
    """
    if abs(math.sin(twist)) < 1e-6 or abs(math.sin(other_twist)) < 1e-6 or abs(math.sin((other_twist - twist) / 2)) < 1e-6:
        raise refuse("other_twist", "the twists must differ, and none be 0.", "Give for example 40 deg and 75 deg.")
    other = length * math.sin(other_twist) / math.sin(twist)
    if other <= 0:
        raise refuse("other_twist", f"makes the other links {other:g} m long.", "Give both twists the same sign.")
    ratio = math.sin((other_twist + twist) / 2) / math.sin((other_twist - twist) / 2)
    second = 2 * math.atan2(ratio * math.cos(angle / 2), math.sin(angle / 2))
    links = [
        (angle, length, twist),
        (second, other, other_twist),
        (-angle, length, twist),
        (-second, other, other_twist),
    ]
    return _loop(title, links, hinge, mass, gravity, duration)


@builder("mechanisms.bricard")
def bricard(
    *,
    length: PositiveLength = 1.0,
    twist: Angle = math.pi / 2,
    angle: Angle = math.pi / 2,
    hinge: PositiveLength = 0.5,
    mass: Mass = 1.0,
    gravity: GravityVector | None = (0.0, -9.81, 0.0),
    duration: PositiveTime = 1.0,
    title: str = "Bricard's linkage",
) -> Model:
    """Six equal links, six hinges and one degree of freedom, while the count for a loop of six hinges gives 0.

    The twists of the links alternate, so the loop has a threefold symmetry. With the default twist of 90 deg it is the
    orthogonal linkage, and at its start six edges of a cube. Hinge k has the nodes ``Pk``, ``Ak``; each link is the
    tetrahedron of two hinges, with the mass of a thin rod on P-P; the link of hinges 6 and 1 is fixed. 24 bars hold 24
    coordinates with rank 23: 1 mechanism, 1 state of self-stress. Run ``fall`` lets it go.

    Parameters
    ----------
    length : of the links, m. twist : of the first link, rad; the next has its opposite.
    angle : of hinge 1 at the start, rad. hinge : length of the hinges, m. mass : of each link, kg. gravity : m/s^2; None
        for none. duration : of the run, s.

    Notes
    -----
    With t, u in turn the hinges' angles and a the twist:
    cos^2 a + sin^2 a (cos t + cos u) + (1 + cos^2 a) cos t cos u - 2 cos a sin t sin u = 0.

    Raises
    ------
    ModelError : faults of the parameters; an angle at which the loop does not close.

    Source
    ------
    R. Bricard, Lecons de cinematique II (1927); the closure equation after Y. Chen, Z. You & T. Tarnai, Threefold-symmetric
    Bricard linkages for deployable structures, Int. J. Solids and Structures 42 (2005) 2287-2301.

    Examples
    --------
    >>> model = bricard()
    >>> len(model.bars), len(model.nodes), sorted(model.fixed)
    (24, 12, ['A1', 'A6', 'P1', 'P6'])
    """
    c, s = math.cos(twist), math.sin(twist)
    if abs(s) < 1e-6:
        raise refuse("twist", f"{math.degrees(twist):.4g} deg leaves all hinges parallel.", "Give for example 90 deg.")
    A = s**2 + (1 + c**2) * math.cos(angle)
    B = -2 * c * math.sin(angle)
    C = c**2 + s**2 * math.cos(angle)
    size = math.hypot(A, B)
    if abs(C) > size:
        raise does_not_close("angle", angle, "Take one nearer to 90 deg.")
    other = math.atan2(B, A) + math.acos(-C / size)
    links = [(other if k % 2 else angle, length, -twist if k % 2 else twist) for k in range(6)]
    return _loop(title, links, hinge, mass, gravity, duration)


def _loop(title: str, links: list[Link], hinge: float, mass: float, gravity: GravityVector | None, duration: float) -> Model:
    """Hinges placed one after the other (Denavit & Hartenberg 1955); the last link is fixed."""
    count = len(links)
    R, at = np.eye(3), np.zeros(3)
    nodes: dict[str, Any] = {}
    for k, (angle, length, twist) in enumerate(links, start=1):
        nodes |= {f"P{k}": at, f"A{k}": at + hinge * R[:, 2]}
        R = R @ turned_about(2, angle)
        at = at + length * R[:, 0]
        R = R @ turned_about(0, twist)
    moving = [(k, k + 1) for k in range(1, count)]
    bars = bars_between([(f"P{k}", f"P{n}") for k, n in moving], mass=mass)
    bars |= bars_between([(f"{a}{k}", f"{b}{n}") for k, n in moving for a, b in ("AA", "PA", "AP")])
    bars |= bars_between([(f"P{k}", f"A{k}") for k in range(2, count)])
    return Model(
        title=title,
        nodes=places(nodes),
        fixed=["P1", "A1", f"P{count}", f"A{count}"],
        bars=bars,
        gravity=gravity,
        runs={"fall": Run(analysis="dynamics.simulate", t_end=duration)},
    )


@builder("mechanisms.spherical_four_bar")
def spherical_four_bar(
    *,
    ground: Angle = 1.2,
    crank: Angle = 0.45,
    coupler: Angle = 1.0,
    rocker: Angle = 1.1,
    angle: Angle = 1.0,
    radius: PositiveLength = 0.2,
    mass: Mass = 1.0,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    duration: PositiveTime = 1.0,
    title: str = "Spherical four-bar",
) -> Model:
    """Four links whose hinges meet in one point O: everything moves on spheres. With 90 deg throughout it is Hooke's joint.

    Nodes ``O``, ``A`` (on +x), ``D`` (in the plane of x and y) are fixed; ``B``, ``C`` are points of the moving hinges, all at
    `radius` from O. Five bars: ``O-B``, ``O-C``, ``A-B``, ``B-C``, ``D-C``. One degree of freedom: the count for a loop of
    four hinges gives -2; the count of these bars is right, since O is shared. Run ``fall`` releases it.

    Parameters
    ----------
    ground, crank, coupler, rocker : angles between the hinges O-A, O-B, O-C, O-D, rad.
    angle : of the crank about +x from the plane of the ground, rad. radius : m. mass : of crank, coupler and rocker each,
        on their chords, kg. gravity : m/s^2; None for none. duration : of the run, s.

    Raises
    ------
    ModelError : faults of the parameters; angles that do not close.

    Examples
    --------
    >>> len(spherical_four_bar().bars)
    5
    """
    A, D = np.array([1.0, 0.0, 0.0]), np.array([math.cos(ground), math.sin(ground), 0.0])
    B = np.array([math.cos(crank), math.sin(crank) * math.cos(angle), math.sin(crank) * math.sin(angle)])
    C = _on_sphere(B, math.cos(coupler), D, math.cos(rocker))
    if C is None:
        raise does_not_close("coupler", angle, "Widen coupler or rocker, or turn the crank.")
    bars = bars_between([("O", "B"), ("O", "C")]) | bars_between([("A", "B"), ("B", "C"), ("D", "C")], mass=mass)
    return Model(
        title=title,
        nodes=places({"O": 0 * A} | {name: radius * place for name, place in zip("ABCD", (A, B, C, D), strict=True)}),
        fixed=["O", "A", "D"],
        bars=bars,
        gravity=gravity,
        runs={"fall": Run(analysis="dynamics.simulate", t_end=duration)},
    )


def _on_sphere(first: Any, cosine: float, second: Any, other: float) -> Any:
    """The unit vector with these cosines to two others, on the side of first x second; None if there is none."""
    part = first @ second
    if not abs(part) < 1:
        return None
    inside = ((cosine - part * other) * first + (other - part * cosine) * second) / (1 - part**2)
    left = 1 - inside @ inside
    across = np.cross(first, second)
    return inside + math.sqrt(left) * across / np.linalg.norm(across) if left > 0 else None


# The Sarrus linkage: two chains of three parallel hinges each, at right angles, allow one straight motion.

CHAINS = (
    (("B", "E"), ("M1", "M2"), ("G", "H"), ("Q1", "Q2")),
    (("B", "F"), ("N1", "N2"), ("G", "K"), ("Q3", "Q4")),
)
"""Hinge edges below, between and above, apexes of the two plates."""


def chain_bars(
    below: tuple[str, str], middle: tuple[str, str], above: tuple[str, str], apexes: tuple[str, str]
) -> list[tuple[str, str]]:
    """Sixteen: the hinge edge in the middle and the one above; of each plate two sides, a diagonal, four spokes."""
    pairs = []
    for low, high, apex in ((below, middle, apexes[0]), (middle, above, apexes[1])):
        pairs += [(low[0], high[0]), (low[1], high[1]), high, (low[0], high[1])]
        pairs += [(apex, node) for node in (*low, *high)]
    return pairs


SARRUS_BARS = tuple(pair for chain in CHAINS for pair in chain_bars(*chain))
"""32 bars of both chains; those of the triangle BEF below are not among them, of GHK above HK is not."""


def sarrus_places(reach: Any, edge: float, leg: float, apex: float) -> dict[str, Any]:
    """Nodes from B = 0, slide along y, hinge edges along x (its chain bends to -z) and along z (to -x); `reach` may be complex.

    edge : length of the hinge edges. leg : of the plates. apex : distance of the plates' apexes, m.
    """
    x, y, z = np.eye(3)
    depth = np.sqrt(leg**2 - reach**2 / 4)
    found = {"B": 0.0 * y, "E": edge * x, "F": edge * z, "G": reach * y, "H": reach * y + edge * x, "K": reach * y + edge * z}
    for across, away, (_, middle, _, apexes), side in ((x, -z, CHAINS[0], 1), (z, -x, CHAINS[1], -1)):
        elbow = reach / 2 * y + depth * away
        normal = (depth * y - reach / 2 * away) / leg
        first = elbow / 2 + edge / 2 * across + side * apex * normal
        found |= {middle[0]: elbow, middle[1]: elbow + edge * across}
        found |= {apexes[0]: first, apexes[1]: first + (reach - 2 * (first @ y)) * y}
    return found


@builder("mechanisms.sarrus")
def sarrus(
    *,
    height: PositiveLength = 0.3,
    plate: PositiveLength = 0.25,
    edge: PositiveLength = 0.15,
    apex: PositiveLength = 0.1,
    title: str = "Sarrus linkage",
) -> Model:
    """A platform that moves straight along y without turning, guided by hinges alone.

    Nodes B, E, F are fixed; the platform is the triangle G, H, K above them. Each of the two chains has two plates and three
    parallel hinges; the hinges of the second chain are at right angles to those of the first. By count, six hinges in space
    leave no freedom, (6 - 1 - 6) x 6 + 6 = 0; the linkage has one. A plate is a pyramid (apexes Q1 ... Q4), since its corners
    lie in one plane. Drive ``height`` is the y coordinate of G.

    Parameters
    ----------
    height : of the platform, m, less than two plates. plate : length of the plates, m. edge : of the hinges, m. apex : of the
        plates, m.

    Raises
    ------
    ModelError : faults of the parameters; a height beyond the plates.

    Source
    ------
    P. F. Sarrus, Note sur la transformation des mouvements rectilignes alternatifs en mouvements circulaires, Comptes
    rendus de l'Academie des Sciences 36 (1853) 1036.

    Examples
    --------
    >>> model = sarrus()
    >>> len(model.bars), len(model.nodes), sorted(model.fixed)
    (32, 14, ['B', 'E', 'F'])
    """
    if height >= 2 * plate:
        raise refuse("height", f"{height:g} m is beyond the plates.", f"Stay below {2 * plate:g} m.")
    return Model(
        title=title,
        nodes=places(sarrus_places(height, edge, plate, apex)),
        fixed=["B", "E", "F"],
        bars=bars_between(SARRUS_BARS),
        drives={"height": CoordinateDrive(node="G", axis="y")},
        runs={"lift": Run(trajectory=Cyclic(moves={"height": (height, 0.7 * height)}, period=1.0))},
    )
