"""The double octahedron of Lacy (1991), chapter 4, also tapered, and two of them as a quadruple octahedron."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Unpack

import numpy as np

from kinetruss.errors import ModelError
from kinetruss.kernels.motion.placement import base_triangle, equal_share, place_bay, reach, tilt
from kinetruss.library.building import named
from kinetruss.library.cells.fittings import Fittings, Placing, dressed, placed, ready
from kinetruss.library.cells.joining import joined
from kinetruss.library.cells.records import Cell, Face
from kinetruss.library.drives import GEARS, MOTORS, SCREWS
from kinetruss.library.placing import point, refuse
from kinetruss.library.sections import SECTIONS, TUBE_LACY_SPATIAL
from kinetruss.model import Active, Angle, Bar, Compliance, Gear, GimbalPose, LeadScrew, Mass, Motor, Name, Part, PositiveLength
from kinetruss.model.sections import Section

BARS = {
    "M1": (6, 2, 1),
    "M2": (6, 1, 2),
    "M3": (4, 1, 3),
    "M4": (4, 3, 1),
    "M5": (5, 3, 2),
    "M6": (5, 2, 3),
    "M13": (6, 9, 7),
    "M14": (6, 7, 9),
    "M15": (4, 7, 8),
    "M16": (4, 8, 7),
    "M17": (5, 8, 9),
    "M18": (5, 9, 8),
    "M19": (7, 9, 8),
    "M20": (8, 7, 9),
    "M21": (8, 9, 7),
}
"""First node, second node, third node of a face the bar bounds. Ends: Lacy (1991), table 4.1, with M19 from 7 to 9."""

ACTIVE = {"M7": (4, 5, 6), "M9": (5, 6, 4), "M11": (4, 6, 5)}
"""Node of the base rod, node of the tube, third node of the middle triangle."""

FACES = {
    "base": (1, 2, 3),
    "top": (7, 9, 8),
    "side1": (1, 2, 6),
    "side2": (2, 3, 5),
    "side3": (3, 1, 4),
    "side4": (6, 9, 7),
    "side5": (5, 8, 9),
    "side6": (4, 7, 8),
}
GROUPS = {
    "longeron": tuple(name for name in BARS if name not in ("M19", "M20", "M21")),
    "longeron_lower": ("M1", "M2", "M3", "M4", "M5", "M6"),
    "longeron_upper": ("M13", "M14", "M15", "M16", "M17", "M18"),
    "batten": ("M19", "M20", "M21"),
}
"""More names of its bars, for patterns of active members."""

Side = tuple[float, float]
"""Side of a triangle and length of the longerons from it to the middle nodes, m."""


class Rods(Fittings, total=False):
    """Of its active members: their two rods and their drive, as of `vgt.double_octahedral`."""

    base_mass: Mass
    base_length: PositiveLength
    base_section: Section | Name | None
    tube_length: PositiveLength
    tube_mass: Mass | None
    tube_section: Section | Name | None
    screw: LeadScrew | Name | None
    gear: Gear | Name | None
    motor: Motor | Name | None
    limits: tuple[PositiveLength, PositiveLength] | None
    compliance: Compliance | None


@ready("double_octahedron", Rods)
def double_octahedron(
    *,
    base: PositiveLength = 1.2192,
    longeron: PositiveLength = 0.889,
    top: PositiveLength | None = None,
    upper_longeron: PositiveLength | None = None,
    beta: Angle = 0.0,
    gamma: Angle = 0.0,
    height: PositiveLength | None = None,
    active_length: PositiveLength = 1.1684,
    **fittings: Unpack[Rods],
) -> Cell:
    """A bay of the truss of Lacy (1991): nodes N1 .. N9, bars M1 .. M6, M13 .. M21, active members M7, M9, M11.

    It has no battens at its base: it stands on a cell, or on fixed nodes. Faces ``base``, ``top``, ``side1`` .. ``side3``
    below, ``side4`` .. ``side6`` above. For `active`, its bars are also called ``longeron``, ``longeron_lower``,
    ``longeron_upper`` and ``batten``.

    Parameters
    ----------
    base, longeron, beta, gamma, height, active_length : as of `vgt.double_octahedral`, as all further ones.
    top, upper_longeron : side of the top and length of the upper longerons, m, where they differ from the lower ones. A
        tapered bay has no mirror plane, so no closed form: it is drawn upright, has no pose, and is moved by lengths.
    fittings : see `Fittings`. With `active` the bay has no pose coordinates.

    Raises
    ------
    ModelError : longerons that do not span the base, a pose out of reach, tilt or height of a tapered bay.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> cell = cells.double_octahedron(beta="10 deg")
    >>> len(cell.nodes), len(cell.bars), list(cell.active), list(cell.poses)
    (9, 15, ['M7', 'M9', 'M11'], ['bay'])
    """
    active, records = _hardware(fittings)
    above = (base if top is None else top, longeron if upper_longeron is None else upper_longeron)
    places, frames = _drawn((base, longeron), above, (beta, gamma, height), active_length)
    cell = Cell(
        nodes={f"N{k}": tuple(place) for k, place in enumerate(places.tolist(), start=1)},
        bars={name: Bar(**_ends(numbers)) for name, numbers in BARS.items()},
        active={name: Active(**_ends(numbers), **active) for name, numbers in ACTIVE.items()},
        faces={name: _face(corners, frames.get(name)) for name, corners in FACES.items()},
        poses={"bay": GimbalPose(base=base, longeron=longeron, drives=tuple(ACTIVE))} if frames else {},
        **records,
    )
    return dressed(cell, fittings, GROUPS)


@ready("quadruple_octahedron", Rods)
def quadruple_octahedron(
    *,
    base: PositiveLength = 1.2192,
    longeron: PositiveLength = 0.889,
    beta: Angle = 0.0,
    gamma: Angle = 0.0,
    height: PositiveLength | None = None,
    active_length: PositiveLength = 1.1684,
    **fittings: Unpack[Rods],
) -> Cell:
    """Two equal double octahedra, one on the other, each tilted by half of the whole tilt: halves H1 and H2.

    Nodes ``H1.N1`` .. ``H1.N9``, ``H2.N4`` .., members ``H1.M1`` .., of them ``H1.M7``, ``H1.M9``, ``H1.M11`` active; poses
    ``H1``, ``H2``. Faces ``base``, ``top``, and those of the halves, ``H1.side1`` ..

    Parameters
    ----------
    base, longeron, active_length : of both halves, m, as of `double_octahedron`.
    beta, gamma, height : gimbal angles of the top, rad, and distance of its centroid from that of the base, m; by default that
        of halves as high as upright ones of `active_length`. `kinematics.chain_lengths` is the same closed form for arrays.
    fittings : see `Fittings`.

    Raises
    ------
    ModelError : a pose out of reach; faults of the parameters.

    Examples
    --------
    >>> cell = quadruple_octahedron(beta="20 deg")
    >>> len(cell.nodes), len(cell.bars), list(cell.active), list(cell.poses)
    (15, 30, ['H1.M7', 'H1.M9', 'H1.M11', 'H2.M7', 'H2.M9', 'H2.M11'], ['H1', 'H2'])
    """
    share = equal_share(np.array(beta), np.array(gamma), np.array(1.0 if height is None else height), 2)
    half_beta, half_gamma, half_height = (float(part) for part in share)
    inner: Any = {key: value for key, value in fittings.items() if key not in Placing.__annotations__}
    outer = {key: value for key, value in fittings.items() if key in Placing.__annotations__}
    pose: Any = {"beta": half_beta, "gamma": half_gamma, "height": None if height is None else half_height}
    try:
        half = double_octahedron(base=base, longeron=longeron, active_length=active_length, **pose, **inner)
    except ModelError as error:
        raise ModelError([replace(one, message=f"in each half, {one.message}") for one in error.faults]) from None
    return placed(joined({"H1": half, "H2": half}, on={"H2": "H1.top"}).cell(), outer)


def _hardware(given: Rods) -> tuple[dict[str, Any], dict[str, Any]]:
    """Fields of the active members, and the tables of records that they name."""
    material, own = given.get("material", ""), given.get("tube_section") is not None
    tube = given["tube_section"] if own else given.get("section", TUBE_LACY_SPATIAL)
    rods = {"tube": named(SECTIONS, tube, "tube_section" if own else "section")}
    rods["base"] = named(SECTIONS, given.get("base_section"), "base_section")
    train: dict[str, Any] = {
        "screw": named(SCREWS, given.get("screw"), "screw"),
        "gear": named(GEARS, given.get("gear"), "gear"),
        "motor": named(MOTORS, given.get("motor"), "motor"),
    }
    train = {kind: record for kind, record in train.items() if record is not None}
    fields: dict[str, Any] = {
        "base": Part(
            length=given.get("base_length", 0.7),
            mass=given.get("base_mass", 3.0),
            section=None if rods["base"] is None else "base",
            material=None if rods["base"] is None or material is None else "bar",
        ),
        "tube": Part(
            length=given.get("tube_length", 0.254),
            mass=given.get("tube_mass"),
            section=None if rods["tube"] is None else "tube",
            material=None if material is None else "bar",
            rotary_inertia=given.get("rotary_inertia", False),
        ),
        "limits": given.get("limits"),
        "compliance": given.get("compliance"),
    }
    fields |= {"buckling": given["buckling"]} if "buckling" in given else {}
    sections = {name: record for name, record in rods.items() if record is not None}
    return fields | {kind: kind for kind in train}, {"sections": sections} | {f"{k}s": {k: one} for k, one in train.items()}


def _drawn(
    below: Side, above: Side, pose: tuple[float, float, float | None], active_length: float
) -> tuple[Any, dict[str, Any]]:
    """Places of N1 .. N9, (9, 3), and the frames of base and top, if the bay has a closed form."""
    (base, longeron), (beta, gamma, height) = below, pose
    if below == above:
        height = _height(base, longeron, beta, gamma, height, active_length)
        u, turn = tilt(beta, gamma)
        frames = {"base": (np.zeros(3), np.eye(3)), "top": (height * u, turn)}
        return place_bay(base, longeron, beta, gamma, height), frames
    for key, value, none in (("beta", beta, 0.0), ("gamma", gamma, 0.0), ("height", height, None)):
        if value != none:
            mend = f"Leave {key} away and give active_length; move the bay by the lengths of its active members."
            raise refuse(key, "a tapered bay has no mirror plane, so no closed form of its pose.", mend)
    return _tapered(below, above, active_length), {}


def _tapered(below: Side, above: Side, active_length: float) -> Any:
    """Places of an upright bay whose middle triangle has sides of `active_length`, (9, 3)."""
    rises = [_rise(*side, active_length, name) for side, name in ((below, "longeron"), (above, "upper_longeron"))]
    middle = -active_length / math.sqrt(3) * base_triangle(math.sqrt(3))  # a circle of radius 1, turned by 180 degrees
    middle, top = middle[[1, 0, 2]], base_triangle(above[0])[[0, 2, 1]]
    up = np.array([0.0, 0.0, 1.0])
    return np.vstack([base_triangle(below[0]), middle + rises[0] * up, top + sum(rises) * up])


def _rise(base: float, longeron: float, active_length: float, name: str) -> float:
    """Distance of a triangle from the parallel one of the middle nodes, m."""
    _spans(name, longeron, base)
    rim, inner = math.sqrt(longeron**2 - base**2 / 4), base / (2 * math.sqrt(3))
    cosine = (active_length / math.sqrt(3) - inner) / rim
    if not -1 < cosine < 1:
        least, most = math.sqrt(3) * max(inner - rim, 0.0), math.sqrt(3) * (inner + rim)
        mend = f"With this base and longeron it must lie between {least:.4g} m and {most:.4g} m."
        raise refuse("active_length", f"{active_length:g} m does not close the bay.", mend)
    return rim * math.sqrt(1.0 - cosine**2)


def _spans(name: str, longeron: float, base: float) -> None:
    if longeron <= base / 2:
        mend = f"Make it longer than half the base, {base / 2:g} m."
        raise refuse(name, f"{longeron:g} m cannot span the base edge of {base:g} m.", mend)


def _height(base: float, longeron: float, beta: float, gamma: float, height: float | None, active_length: float) -> float:
    """The height, given or for equal active lengths when upright; ModelError if the pose is impossible."""
    if height is None:
        height = 2.0 * _rise(base, longeron, active_length, "longeron")
    _spans("longeron", longeron, base)
    rim = math.sqrt(longeron**2 - base**2 / 4)
    if height >= 2.0 * rim:
        raise refuse("height", f"{height:g} m is out of reach.", f"Stay below {2 * rim:.6g} m.")
    if not reach(base, longeron, beta, gamma, height) > 0:
        text = f"the pose {math.degrees(beta):.4g} deg, {math.degrees(gamma):.4g} deg is out of reach at height {height:.6g} m."
        raise refuse("beta", text, "Tilt less, or lower the height.")
    return height


def _ends(numbers: tuple[int, int, int]) -> dict[str, Any]:
    first, second, third = (f"N{k}" for k in numbers)
    return {"ends": (first, second), "orientation": third}


def _face(corners: tuple[int, ...], frame: Any) -> Face:
    where = {} if frame is None else {"origin": point(frame[0]), "axes": frame[1].tolist()}
    return Face(nodes=tuple(f"N{k}" for k in corners), **where)
