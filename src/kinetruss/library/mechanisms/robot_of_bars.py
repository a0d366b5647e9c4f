"""A robot with five degrees of freedom, made of bars: a lift that swings, a shoulder, a Sarrus linkage as reach, a wrist."""

from __future__ import annotations

import math
from collections.abc import Container
from typing import Any, Literal

import numpy as np

from kinetruss.library.building import Turning, Velocity, builder
from kinetruss.library.mechanisms.loops import SARRUS_BARS, sarrus_places
from kinetruss.library.placing import bars_between, places, point, refuse, turned_about
from kinetruss.model import (
    Angle,
    AngleDrive,
    Beam,
    Body,
    Coupling,
    DistanceCoordinate,
    Frame,
    GravityVector,
    HingeDrive,
    LengthDrive,
    Model,
    Node,
    PositiveLength,
    Quintic,
    Run,
)
from kinetruss.model.bracing import CHORD

EDGE = 0.2
"""Length of the hinge edges of the Sarrus linkage, m."""

LEG = 1.1
"""Length of the plates of the Sarrus linkage, m."""

APEX = 0.15
"""Height of the apexes of these plates, m."""

GUIDED = {"A": "xyz", "B": "xy", "D": "xy"}
"""B and D stay on the axis z."""

FIRST = {"B": (0.0, 0.0, 0.0), "D": (0.0, 0.0, 0.4), "C": (0.0, 0.3, 0.0), "X": (0.3, 0.0, 0.0)}
BODIES = {
    "first": (200.0, (0.10, 0.20, 0.15), (60.0, 20.0, 50.0)),
    "second": (120.0, (0.05, 0.30, -0.04), (12.0, 2.0, 11.0)),
    "effector": (40.0, (0.02, 0.25, 0.10), (3.0, 1.2, 2.5)),
}
"""Mass, kg; centre from B, G, G; principal moments, kg m^2, both in the directions of the body."""
WRIST = {"U": (0.0, 0.3, 0.0), "W": (0.0, 0.0, 0.3)}
"""In the directions of the first body, from B; of the effector, from G."""

TETRAHEDRON = ("BC", "BD", "BX", "CD", "CX", "DX")
SHOULDER = ("BE", "BF", "CE", "CF", "EF")
HAND = (("J", "G"), ("J", "H"), ("J", "K"), ("U", "G"), ("U", "H"), ("W", "G"), ("W", "H"), ("U", "W"))


@builder("mechanisms.robot")
def robot(
    *,
    form: Literal["bars", "conventional"] = "bars",
    lift: PositiveLength = 1.5,
    swing: Angle = 0.4,
    shoulder: Angle = -0.2,
    reach: PositiveLength = 0.9,
    wrist: Angle = 0.5,
    rates: tuple[Velocity, Turning, Turning, Velocity, Turning] | None = None,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    title: str = "Robot of five freedoms",
) -> Model:
    """Lift z1, swing gamma1, shoulder beta2, reach y2, wrist alpha3: 53 bars, 63 coordinates, 7 fixed, 5 freedoms.

    Drives ``lift`` (bar ``A-B``), ``swing``, ``shoulder``, ``reach`` (bar ``B-G``) and ``wrist``; run ``move``. Axis z
    through A, B and D; the first body is the tetrahedron BCDX; the tetrahedron BCEF shares its edge BC, the shoulder's
    axis; a Sarrus linkage with the hinge edges BE, BF below, GH, GK above and four plates keeps GHK parallel to BEF and
    lets it move along BC; the second body is GHK with J; the effector, the tetrahedron GHUW, shares the edge GH, the
    wrist's axis. Each plate is a pyramid: its four corners lie in a plane, so the apex Q keeps it stiff. Edge HK needs no
    bar.

    Or a conventional model of finite elements: eight rigid beams with rotations at their nodes, B-D, B-X, B-E, E-F, G-H, G-K,
    G-J and G-U, hinges at B and G, and a slide in place of the linkage: five couplings of distances between the places B, E,
    F of the guide and G, H, K of the second body, which are the same places moved along BG. The masses are on the rotations.
    That is 11 places and five rotations (two at B, one at E, two at G): 53 coordinates if each rotation is four Euler
    parameters. The source has 43 and does not say which. Here three vectors (nine coordinates) carry a rotation.

    Masses: ``first`` on BCDX, ``second`` on GHKJ, ``effector`` on GHUW; bars and linkage have none.

    Parameters
    ----------
    form : ``bars`` or ``conventional``.
    lift : of B above A, m. reach : from B to G, m, less than two plates (2.2 m). swing, shoulder, wrist : rad; the axes are
        R1 = Rz(swing), R2 = R1 Ry(shoulder), R3 = R2 Rx(wrist).
    rates : of the five, in this order, at the start, m/s and rad/s.
    gravity : m/s^2; None for none.

    Raises
    ------
    ModelError : faults of the parameters; a reach beyond the plates.

    Source
    ------
    The mechanism: W. Schiehlen (ed.), Multibody Systems Handbook (1990). The handbook's data were not at hand: sizes and
    masses are an example, chosen so that counts and freedoms are those of the mechanism.

    Examples
    --------
    >>> model = robot()
    >>> len(model.bars), len(model.nodes), [round(x, 6) for x in model.nodes["G"].at]
    (53, 21, [-0.350477, 0.828955, 1.5])
    """
    if reach >= 2 * LEG:
        raise refuse("reach", f"{reach:g} m is beyond the plates.", f"Stay below {2 * LEG:g} m.")
    given = np.array([lift, swing, shoulder, reach, wrist])
    at = places(_places(given))  # C and G may coincide, and U and J
    driven = bars_between([("A", "B"), ("B", "G")], kind="driven")
    if form == "bars":
        edges = [*((edge[0], edge[1]) for edge in (*TETRAHEDRON, *SHOULDER)), *SARRUS_BARS, *HAND]
        parts: dict[str, Any] = {
            "nodes": at | {name: Node(at=at[name], coincident=True) for name in ("C", "U")},
            "fixed": GUIDED,
            "bars": bars_between(edges) | driven,
            "bodies": _bodies(given),
        }
        axis = ("B", "C")
    else:
        parts = _conventional(given, at) | {"bars": driven}
        axis = ("B", "B-E.B.axis")
    return Model(
        title=title,
        **parts,
        drives={
            "lift": LengthDrive("A-B"),
            "swing": AngleDrive("B-X" if form == "bars" else f"B-X{CHORD}", axis="z", reference="x"),
            "shoulder": HingeDrive(axis=axis, start="X", end="E"),
            "reach": LengthDrive("B-G"),
            "wrist": HingeDrive(axis=("G", "H"), start="J", end="U"),
        },
        runs={"move": Run(trajectory=Quintic(moves=_move(lift, swing, shoulder, reach, wrist), duration=1.0))},
        velocities={} if rates is None else _velocities(given, np.array(rates), parts["nodes"]),
        gravity=gravity,
    )


def _conventional(q: Any, at: dict[str, Any]) -> dict[str, Any]:
    """Places, beams, masses and the slide of the conventional model."""
    R2 = turned_about(2, q[1]) @ turned_about(1, q[2])
    hinges = {"B-E": {"B": point(R2[:, 1])}, "G-U": {"G": point(R2[:, 0])}}
    beams = {
        f"{a}-{b}": Beam(ends=(a, b), kind="rigid", mass=0.0, hinges=hinges.get(f"{a}-{b}", {}))
        for a, b in ("BD", "BX", "BE", "EF", "GH", "GK", "GJ", "GU")
    }
    # |EH| = |FK| = |BG|: no turn about the axes across the slide; the diagonals are equal: no shift across it, no turn about it
    equal = {
        "EH": ("EH", "BG"),
        "FK": ("FK", "BG"),
        "EG": ("EG", "BH"),
        "FG": ("FG", "BK"),
        "EK": ("EK", "FH"),
    }
    couplings = {
        f"slide.{name}": Coupling(
            terms=tuple((DistanceCoordinate(nodes=(pair[0], pair[1])), sign) for pair, sign in zip(two, (1, -1), strict=True))
        )
        for name, two in equal.items()
    }
    carried = {"first": ("B", "B"), "second": ("G", "G"), "effector": ("G", "G-U.G")}
    bodies = {
        name: body.with_(nodes=(carried[name][0], *(f"{carried[name][1]}.d{k}" for k in (1, 2, 3))), brace=True)
        for name, body in _bodies(q).items()
    }
    nodes = {name: at[name] for name in "ABDXEFGHKJ"} | {"U": Node(at=at["U"], coincident=True)}
    return {"nodes": nodes, "fixed": GUIDED, "beams": beams, "couplings": couplings, "bodies": bodies}


def _move(lift: float, swing: float, shoulder: float, reach: float, wrist: float) -> dict[str, tuple[float, float]]:
    """A motion of all five drives, m and rad."""
    return {
        "lift": (lift, 0.9 * lift),
        "swing": (swing, swing + 1.0),
        "shoulder": (shoulder, shoulder + 0.5),
        "reach": (reach, 0.8 * reach),
        "wrist": (wrist, wrist - 1.5),
    }


def _places(q: Any) -> dict[str, Any]:
    """All nodes from the five coordinates, which may be complex."""
    lift, swing, shoulder, reach, wrist = q
    R1 = turned_about(2, swing)
    R2 = R1 @ turned_about(1, shoulder)
    R3 = R2 @ turned_about(0, wrist)
    B = np.array([0.0, 0.0, 1.0]) * lift
    G = B + R2[:, 1] * reach
    arm = {name: B + R2 @ place for name, place in sarrus_places(reach, EDGE, LEG, APEX).items()}
    return (
        {"A": 0.0 * B}
        | arm
        | {name: B + R1 @ np.array(place) for name, place in FIRST.items()}
        | {"J": G + 0.3 * R2[:, 1]}
        | {name: G + R3 @ np.array(place) for name, place in WRIST.items()}
    )


def _bodies(q: Any) -> dict[str, Body]:
    """The masses. The linkage holds the corners of the second body, so it needs no bars."""
    lift, swing, shoulder, reach, wrist = q
    R1 = turned_about(2, swing)
    R2 = R1 @ turned_about(1, shoulder)
    B = np.array([0.0, 0.0, lift])
    G = B + reach * R2[:, 1]
    stand = {"first": ("BCDX", B, R1), "second": ("GHKJ", G, R2), "effector": ("GHUW", G, R2 @ turned_about(0, wrist))}
    found = {}
    for name, (nodes, origin, R) in stand.items():
        mass, center, inertia = BODIES[name]
        frame = Frame(origin=point(origin), axes=tuple(point(axis) for axis in R.T))
        found[name] = Body(nodes=tuple(nodes), mass=mass, center=center, inertia=inertia, frame=frame, brace=name != "second")
    return found


def _velocities(q: Any, rates: Any, nodes: Container[str]) -> dict[str, Any]:
    """Velocities of these nodes, m/s: the derivative of the positions by a complex step."""
    moved = _places(q + 1e-30j * rates)
    found = {name: np.imag(place) / 1e-30 for name, place in moved.items()}
    return {name: speed for name, speed in places(found).items() if name in nodes and math.hypot(*speed) > 0}
