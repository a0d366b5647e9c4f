"""A model as URDF, with the closures of its loops in a YAML file beside it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import numpy as np
import yaml

from kinetruss.exchange.robot_models import with_sliders
from kinetruss.exchange.robots import Closure, LeftOut, Link, Pivot, Robot, RobotOfModel

if TYPE_CHECKING:
    from numpy.typing import NDArray


Element = ET.Element
TYPES = {"revolute": "continuous", "prismatic": "prismatic", "ball": "continuous", "free": "floating", "weld": "fixed"}
FAR = "1e3"
"""Limits of sliders, which URDF asks for, m, N, m/s."""
EARTH = (0.0, 0.0, -9.81)


def urdf_texts(drawn: RobotOfModel) -> tuple[str, str, list[LeftOut]]:
    """The URDF, the YAML of its closures and motors, and what they do not have."""
    robot = with_sliders(drawn, [one for one in drawn.lengths if one.driven]).robot
    left = list(robot.left_out)
    no_springs = "URDF has no springs"
    left += [LeftOut("springs", one.name, no_springs) for one in drawn.lengths if not one.driven]
    left += [LeftOut("stiffness", one.name, no_springs) for one in robot.pivots if one.spring[0]]
    left += [LeftOut("armature", one.name, "URDF has no inertia of rotors") for one in robot.pivots if one.armature]
    left += [LeftOut("gear", str(one.drive), "URDF has no gears") for one in robot.pivots if one.ratio is not None]
    mimics = dict(_mimics(robot, left))
    if tuple(robot.gravity) != EARTH:
        left.append(LeftOut("gravity", "model", f"URDF has none; other programs take {EARTH} m/s^2"))
    root = Element("robot", name=robot.title)
    at = {robot.root: np.zeros(3)} | {one.child: one.origin[:3, 3] for one in robot.pivots}
    for link in robot.links.values():
        _link(root, link, at[link.name])
    for pivot in robot.pivots:
        _joint(root, pivot, at, mimics.get(pivot.name))
    loops = [_ends(root, one, at) for one in robot.closures]
    balls = [one.name for one in robot.pivots if one.kind == "ball"]
    beside = {
        "closed_loop": loops,
        "type": ["3d"] * len(loops),
        "name_mot": [one.name for one in robot.pivots if one.drive is not None],
        "joint_name": balls,
        "joint_type": ["SPHERICAL"] * len(balls),
    }
    ET.indent(root)
    text = '<?xml version="1.0"?>\n' + ET.tostring(root, encoding="unicode") + "\n"
    return text, yaml.safe_dump(beside, default_flow_style=None, sort_keys=False, width=120), left


def _link(root: Element, link: Link, at: NDArray[np.float64]) -> None:
    """A link; its frame has global axes in the pose and its origin at its joint."""
    element = ET.SubElement(root, "link", name=link.name)
    if link.properties is None:
        return
    inertial = ET.SubElement(element, "inertial")
    ET.SubElement(inertial, "origin", xyz=_row(link.properties.center - at), rpy="0 0 0")
    ET.SubElement(inertial, "mass", value=_row([link.properties.mass]))
    names = {f"i{'xyz'[i]}{'xyz'[j]}": _row([link.properties.inertia[i, j]]) for i in range(3) for j in range(i, 3)}
    ET.SubElement(inertial, "inertia", names)


def _mimics(robot: Robot, left: list[LeftOut]) -> Iterator[tuple[str, tuple[str, float]]]:
    """Joint without a drive -> the joint that it follows, and the factor; both are 0 in the pose."""
    driven = {one.name for one in robot.pivots if one.drive is not None}
    taken: set[str] = set()
    for one in robot.couplings:
        free = [name for name in one.factors if name not in driven | taken]
        if len(one.factors) != 2 or not free:
            left.append(LeftOut("couplings", one.name, "in URDF a joint without a drive can follow one other"))
            continue
        follower = free[-1]
        (other,) = one.factors.keys() - {follower}
        taken.add(follower)
        yield follower, (other, -one.factors[other] / one.factors[follower])


def _joint(root: Element, pivot: Pivot, at: dict[str, Any], mimic: tuple[str, float] | None = None) -> None:
    element = ET.SubElement(root, "joint", name=pivot.name, type=TYPES[pivot.kind])
    ET.SubElement(element, "parent", link=pivot.parent)
    ET.SubElement(element, "child", link=pivot.child)
    ET.SubElement(element, "origin", xyz=_row(at[pivot.child] - at[pivot.parent]), rpy="0 0 0")
    if pivot.kind in ("revolute", "prismatic", "ball"):
        ET.SubElement(element, "axis", xyz=_row(pivot.axis))
    if pivot.kind == "prismatic":
        ET.SubElement(element, "limit", lower=f"-{FAR}", upper=FAR, effort=FAR, velocity=FAR)
    damping, friction = pivot.spring[2:]
    if damping or friction:
        ET.SubElement(element, "dynamics", damping=_row([damping]), friction=_row([friction]))
    if mimic is not None:
        ET.SubElement(element, "mimic", joint=mimic[0], multiplier=_row([mimic[1]]), offset="0")


def _ends(root: Element, closure: Closure, at: dict[str, Any]) -> list[str]:
    """Two links without mass, fixed to the links of a closure at its place; their names."""
    names = []
    for end, link, frame in zip("AB", closure.links, closure.frames, strict=True):
        name = f"{closure.name}_{end}"
        ET.SubElement(root, "link", name=name)
        place = np.eye(4) if frame is None else frame
        held = Pivot(name=f"{name}_fixed", kind="weld", parent=link, child=name, origin=place)
        _joint(root, held, at | {name: place[:3, 3]})
        names.append(name)
    return names


def _row(values: Sequence[float] | Any) -> str:
    """Numbers with as many digits as it takes to read them back exactly."""
    return " ".join(repr(float(one) + 0.0) for one in values)
