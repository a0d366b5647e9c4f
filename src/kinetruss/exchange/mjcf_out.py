"""A model as MJCF: a tree of bodies, its loops closed by `equality/connect`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import numpy as np

from kinetruss.exchange.robot_models import with_sliders
from kinetruss.exchange.robots import LeftOut, Link, Pivot, Robot, RobotOfModel, matrix_quaternion
from kinetruss.model import GROUND

if TYPE_CHECKING:
    from kinetruss.library.bodies import MassProperties


Element = ET.Element
TYPES = {"revolute": "hinge", "prismatic": "slide", "ball": "ball", "free": "free"}
LEAST_MASS = 1e-9
"""kg, of a link without mass: MuJoCo refuses moving bodies without."""
ROUND = 1e-12
"""Added to the moments of inertia, relative to their sum, so that those of rods and plates stay possible after rounding."""
LEAST_INERTIA = 1e-14
"""kg m^2; MuJoCo refuses moments below 1e-15."""
THIN = 0.004
"""Radius of the lines that show bars, relative to the size of the robot."""


def mjcf_text(drawn: RobotOfModel) -> tuple[str, list[LeftOut]]:
    """The text, and what it does not have."""
    drawn = with_sliders(drawn, [one for one in drawn.lengths if one.properties is not None])
    robot, left = drawn.robot, list(drawn.robot.left_out)
    root = Element("mujoco", model=robot.title)
    ET.SubElement(root, "compiler", angle="radian", inertiafromgeom="false")
    ET.SubElement(root, "option", gravity=_row(robot.gravity))
    _bodies(ET.SubElement(root, "worldbody"), drawn, left)
    if robot.closures or robot.couplings:
        group = ET.SubElement(root, "equality")
        _couplings(group, robot, left)
        for one in robot.closures:
            names = [name for name in one.links if name != GROUND]
            ends = {f"body{k + 1}": name for k, name in enumerate(names)}
            ET.SubElement(group, "connect", {"name": one.name, **ends, "anchor": _row(one.frames[0][:3, 3])})
    if drawn.lengths:
        group = ET.SubElement(root, "tendon")
        for driven in drawn.lengths:
            line = ET.SubElement(group, "spatial", {"name": driven.name, **_spring(driven.spring, "springlength")})
            for end in "12":
                ET.SubElement(line, "site", site=f"{driven.name}.{end}")
    drives = [one for one in robot.pivots if one.drive is not None]
    if drives or any(one.driven for one in drawn.lengths):
        group = ET.SubElement(root, "actuator")
        for pivot in drives:
            gear = {} if pivot.ratio is None else {"gear": _row([pivot.ratio])}
            ET.SubElement(group, "motor", {"name": str(pivot.drive), "joint": pivot.name, **gear})
        for driven in (one for one in drawn.lengths if one.driven):
            ET.SubElement(group, "motor", name=driven.name, tendon=driven.name)
    ET.indent(root)
    return ET.tostring(root, encoding="unicode") + "\n", left


def _couplings(group: Element, robot: Robot, left: list[LeftOut]) -> None:
    """Conditions of one or two joints: y = c1 x, both 0 in the pose."""
    for one in robot.couplings:
        if len(one.factors) > 2:
            left.append(LeftOut("couplings", one.name, "MJCF couples two joints at most: the robot has more freedoms"))
            continue
        (first, factor), *rest = one.factors.items()
        slope = -rest[0][1] / factor if rest else 0.0
        ends = {"joint1": first} | ({"joint2": rest[0][0]} if rest else {})
        ET.SubElement(group, "joint", {"name": one.name, **ends, "polycoef": _row([0.0, slope, 0.0, 0.0, 0.0])})


def _spring(law: tuple[float, float, float, float], rest: str) -> dict[str, str]:
    """Attributes of stiffness, value without force (named `rest`), damping and friction."""
    found = {"stiffness": _row(law[:1]), rest: _row(law[1:2])} if law[0] else {}
    return found | {word: _row([one]) for word, one in zip(("damping", "frictionloss"), law[2:], strict=True) if one}


def _bodies(world: Element, drawn: RobotOfModel, left: list[LeftOut]) -> None:
    """Nested bodies, all with global axes and origin in the pose; a chain of joints without links between them is one body."""
    robot = drawn.robot
    size = _size(drawn)
    elements: dict[str, Element] = {GROUND: world}
    held: dict[str, tuple[str, list[Pivot]]] = {}
    used = {name for one in robot.closures for name in one.links} | {name for one in drawn.lengths for name in one.links}
    for pivot in robot.pivots:
        parent, chain = held.pop(pivot.parent, (pivot.parent, []))
        if _between(robot, pivot.child, used):
            held[pivot.child] = parent, [*chain, pivot]
            continue
        body = ET.SubElement(elements[parent], "body", name=pivot.child)
        elements[pivot.child] = body
        _inertial(body, robot.links[pivot.child], pivot.origin[:3, 3], left)
        for one in [*chain, pivot]:
            _joint(body, one)
    for name, element in elements.items():
        for index, ends in enumerate(drawn.lines.get(name, ())):
            shape = {
                "name": f"{name}.line{index + 1}",
                "type": "capsule",
                "size": _row([THIN * size]),
                "fromto": _row(ends.ravel()),
            }
            ET.SubElement(element, "geom", {**shape, "contype": "0", "conaffinity": "0", "mass": "0"})
    for driven in drawn.lengths:
        for end, name, point in zip("12", driven.links, driven.points, strict=True):
            ET.SubElement(elements[name], "site", name=f"{driven.name}.{end}", pos=_row(point))


def _between(robot: Robot, name: str, used: set[str]) -> bool:
    """True for a link without mass that only carries the next joint."""
    return robot.links[name].properties is None and name not in used and sum(one.parent == name for one in robot.pivots) == 1


def _size(drawn: RobotOfModel) -> float:
    points = [end for lines in drawn.lines.values() for ends in lines for end in ends]
    return float(np.ptp(np.array(points), axis=0).max()) if points else 1.0


def _joint(body: Element, pivot: Pivot) -> None:
    given = {"name": pivot.name, "type": TYPES[pivot.kind]}
    if pivot.kind != "free":
        given["pos"] = _row(pivot.origin[:3, 3])
    if pivot.kind in ("revolute", "prismatic"):
        given["axis"] = _row(pivot.axis)
        given |= _spring(pivot.spring, "springref") | ({"armature": _row([pivot.armature])} if pivot.armature else {})
    ET.SubElement(body, "joint", given)


def _inertial(body: Element, link: Link, place: Any, left: list[LeftOut]) -> None:
    """place : of its joint, (3,) m."""
    if link.properties is None:
        why = f"has none; MuJoCo needs some, so {LEAST_MASS:g} kg are written"
        left.append(LeftOut("mass", link.name, why))
        given: Mapping[str, Any] = {"mass": _row([LEAST_MASS]), "pos": _row(place), "diaginertia": _row([LEAST_MASS] * 3)}
    else:
        given = _mass(link.properties)
    ET.SubElement(body, "inertial", dict(given))


def _mass(given: MassProperties) -> dict[str, str]:
    """Principal moments with their axes, no moment above the sum of the other two."""
    values, axes = np.linalg.eigh(np.asarray(given.inertia))
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    values = np.maximum(values, max(ROUND * float(values.sum()), LEAST_INERTIA))
    values[0] += max(0.0, (1.0 + ROUND) * values[2] - values[0] - values[1])
    ends = {"mass": _row([given.mass]), "pos": _row(given.center)}
    return {**ends, "diaginertia": _row(values), "quat": _row(matrix_quaternion(axes))}


def _row(values: Sequence[float] | Any) -> str:
    """Numbers with as many digits as it takes to read them back exactly."""
    return " ".join(repr(float(one) + 0.0) for one in values)
