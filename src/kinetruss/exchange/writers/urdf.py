"""A model as URDF, with the closures of its loops in a YAML file beside it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import numpy as np
import yaml

from kinetruss.exchange.robots import Closure, LeftOut, Link, Pivot, RobotOfModel, with_sliders

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["urdf_texts"]

Element = ET.Element
TYPES = {"revolute": "continuous", "prismatic": "prismatic", "ball": "continuous", "free": "floating", "weld": "fixed"}
FAR = "1e3"
"""Limits of sliders, which URDF asks for, m, N, m/s."""
EARTH = (0.0, 0.0, -9.81)


def urdf_texts(drawn: RobotOfModel) -> tuple[str, str, list[LeftOut]]:
    """The URDF, the YAML of its closures and motors, and what they do not have."""
    robot = with_sliders(drawn, drawn.lengths).robot
    left = list(robot.left_out)
    if tuple(robot.gravity) != EARTH:
        left.append(LeftOut("gravity", "model", f"URDF has none; other programs take {EARTH} m/s^2"))
    root = Element("robot", name=robot.title)
    at = {robot.root: np.zeros(3)} | {one.child: one.origin[:3, 3] for one in robot.pivots}
    for link in robot.links.values():
        _link(root, link, at[link.name])
    for pivot in robot.pivots:
        _joint(root, pivot, at)
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


def _joint(root: Element, pivot: Pivot, at: dict[str, Any]) -> None:
    element = ET.SubElement(root, "joint", name=pivot.name, type=TYPES[pivot.kind])
    ET.SubElement(element, "parent", link=pivot.parent)
    ET.SubElement(element, "child", link=pivot.child)
    ET.SubElement(element, "origin", xyz=_row(at[pivot.child] - at[pivot.parent]), rpy="0 0 0")
    if pivot.kind in ("revolute", "prismatic", "ball"):
        ET.SubElement(element, "axis", xyz=_row(pivot.axis))
    if pivot.kind == "prismatic":
        ET.SubElement(element, "limit", lower=f"-{FAR}", upper=FAR, effort=FAR, velocity=FAR)


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
