"""Units, classes of defaults, poses and masses of MJCF: what the compiler of MuJoCo derives from the elements."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.readers.robot_formats.xml import Element
from kinetruss.exchange.robots import placement, quaternion_matrix, turn_about
from kinetruss.library.bodies import MassProperties, box_properties, combined, cylinder_properties, sphere_properties

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Defaults", "Units", "pose_of", "properties_of"]

WATER = 1000.0
"""Default density of shapes, kg/m^3."""
SOLIDS = ("sphere", "capsule", "ellipsoid", "cylinder", "box")
WEIGHTLESS = ("plane", "hfield")
COMPILED = "Load it in MuJoCo, save the compiled model (mj_saveLastXML), and import that."


class Units:
    """What <compiler> says: `angle`, rad in one unit of angle; the order of Euler angles; where inertia comes from."""

    def __init__(self, root: Element) -> None:
        self.angle, self.order, self.inertia = math.pi / 180.0, "xyz", "auto"
        self.grouped: Element | None = None
        for one in root.all("compiler"):
            if "angle" in one.attributes:
                self.angle = 1.0 if one.choice("angle", ("degree", "radian")) == "radian" else math.pi / 180.0
            self.order = one.text("eulerseq", self.order)
            if len(self.order) != 3 or set(self.order) - set("xyzXYZ"):
                raise one.fault(f"eulerseq is {self.order!r}.", "Write three of x, y, z, X, Y, Z.")
            self.inertia = one.choice("inertiafromgeom", ("auto", "true", "false"), self.inertia)
            for word in ("settotalmass", "boundmass", "boundinertia", "balanceinertia"):
                if one.attributes.get(word, "false") not in ("false", "0", "-1"):
                    raise one.fault(f"changes masses by {word}, which is not carried.", COMPILED)
            if one.attributes.get("coordinate", "local") != "local":
                raise one.fault("has global coordinates, which MuJoCo no longer reads.", COMPILED)
            if "inertiagrouprange" in one.attributes:
                self.grouped = one


class Defaults:
    """Attributes of classes: tag -> attributes, each class with those of the class around it."""

    def __init__(self, root: Element) -> None:
        self._known: dict[str, dict[str, dict[str, str]]] = {"main": {}}
        for one in root.all("default"):
            self._add(one, "main", {})

    def _add(self, element: Element, name: str, above: Mapping[str, Mapping[str, str]]) -> None:
        own = {tag: dict(given) for tag, given in above.items()}
        for child in element.children:
            if child.tag != "default":
                own[child.tag] = {**own.get(child.tag, {}), **child.attributes}
        self._known[name] = {**self._known.get(name, {}), **own}
        for child in element.all("default"):
            self._add(child, child.text("class"), self._known[name])

    def of(self, element: Element, group: str, tag: str = "") -> dict[str, str]:
        """The attributes of an element with those of its class, or of the class around it. tag : that of the defaults."""
        name = element.attributes.get("class", group)
        if name not in self._known:
            raise element.fault(f"no class called {name!r}.", 'Define it: <default class="...">.')
        tag = tag or ("equality" if element.tag in ("connect", "weld") else element.tag)
        return {**self._known[name].get(tag, {}), **element.attributes}


def pose_of(element: Element, given: Mapping[str, str], units: Units) -> NDArray[np.float64]:
    """(4, 4) of pos and one of quat, axisangle, euler, xyaxes, zaxis."""
    one = Element(element.file, element.tag, element.line, given)
    ways = [word for word in ("quat", "axisangle", "euler", "xyaxes", "zaxis") if word in given]
    if len(ways) > 1:
        raise element.fault(f"has {' and '.join(ways)}.", "Give one of them.")
    R = np.eye(3) if not ways else _rotation(one, ways[0], units)
    return placement(R, one.numbers("pos", 3, (0, 0, 0)))


def _rotation(one: Element, way: str, units: Units) -> NDArray[np.float64]:
    if way == "quat":
        quat = one.numbers(way, 4)
        if not quat.any():
            raise one.fault("quat has no length.", 'Write for example quat="1 0 0 0".')
        return quaternion_matrix(quat)
    if way == "axisangle":
        x = one.numbers(way, 4)
        return turn_about(_unit(one, x[:3], way), units.angle * x[3])
    if way == "euler":
        R = np.eye(3)
        for axis, angle in zip(units.order, units.angle * one.numbers(way, 3), strict=True):
            turn = turn_about(np.eye(3)["xyz".index(axis.lower())], angle)
            R = R @ turn if axis.islower() else turn @ R
        return R
    if way == "zaxis":
        return from_z(_unit(one, one.numbers(way, 3), way))
    xy = one.numbers(way, 6)
    x = _unit(one, xy[:3], way)
    y = _unit(one, xy[3:] - (xy[3:] @ x) * x, way)
    return np.column_stack([x, y, np.cross(x, y)])


def _unit(one: Element, vector: Any, word: str) -> NDArray[np.float64]:
    size = float(np.linalg.norm(vector))
    if not size:
        raise one.fault(f"{word} has no direction.", "Give an axis other than 0 0 0.")
    return np.asarray(vector / size)


def from_z(axis: Any) -> NDArray[np.float64]:
    """The shortest rotation that takes z to a unit vector."""
    across = np.cross([0.0, 0.0, 1.0], axis)
    sine = float(np.linalg.norm(across))
    if sine < 1e-10:
        return np.eye(3) if axis[2] > 0 else turn_about((1.0, 0.0, 0.0), math.pi)
    return turn_about(across / sine, math.atan2(sine, float(axis[2])))


def properties_of(body: Element, group: str, defaults: Defaults, units: Units) -> MassProperties | None:
    """Mass, centre and inertia of a body in its frame: of <inertial>, or of its shapes."""
    given = body.one("inertial")
    if given is not None and units.inertia != "true":
        return _inertial(given, units)
    if units.inertia == "false":
        return None
    parts = [one for shape in _shapes(body, np.eye(4), group, units) if (one := _solid(*shape, defaults, units)) is not None]
    if parts and units.grouped is not None:
        raise units.grouped.fault("chooses shapes by inertiagrouprange, which is not carried.", COMPILED)
    return combined(*parts) if parts else None


def _shapes(element: Element, frame: Any, group: str, units: Units) -> list[tuple[Element, Any, str]]:
    found = [(one, frame, group) for one in element.all("geom")]
    for inner in element.all("frame"):
        at = frame @ pose_of(inner, inner.attributes, units)
        found += _shapes(inner, at, inner.attributes.get("childclass", group), units)
    return found


def _inertial(one: Element, units: Units) -> MassProperties | None:
    mass = one.number("mass")
    if mass < 0:
        raise one.fault(f"has the mass {mass:g} kg.", "Give 0 or more.")
    pose = pose_of(one, one.attributes, units)
    if "fullinertia" in one.attributes:
        xx, yy, zz, xy, xz, yz = one.numbers("fullinertia", 6)
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    else:
        tensor = np.diag(one.numbers("diaginertia", 3, (0, 0, 0)))
    if not mass:
        return None
    R = pose[:3, :3]
    return MassProperties(mass=mass, center=pose[:3, 3], inertia=R @ tensor @ R.T)


def _solid(element: Element, frame: Any, group: str, defaults: Defaults, units: Units) -> MassProperties | None:
    """Mass properties of a shape in the frame of its body."""
    given = defaults.of(element, group)
    one = Element(element.file, element.tag, element.line, given)
    kind = given.get("type", "mesh" if "mesh" in given else "sphere")
    mass = one.number("mass") if "mass" in given else None
    density = one.number("density", WATER)
    if kind in WEIGHTLESS or mass == 0 or (mass is None and density == 0):
        return None
    if (mass if mass is not None else density) < 0:
        raise element.fault("has a mass below 0.", "Give 0 or more.")
    if kind not in SOLIDS or given.get("shellinertia", "false") == "true":
        mend = f'Give the body an <inertial>, or the shape mass="0". {COMPILED}'
        raise element.fault(f"the mass of this shape ({kind}) is not computed here.", mend)
    size, pose = _sizes(one, kind, given, units)
    weight: dict[str, Any] = {"density": density} if mass is None else {"mass": mass}
    pose = frame @ pose
    return _made(kind, size, weight).moved(pose[:3, 3], pose[:3, :3].T)


def _sizes(one: Element, kind: str, given: Mapping[str, str], units: Units) -> tuple[NDArray[np.float64], Any]:
    """Sizes (three for a box or an ellipsoid; radius and half length; radius) and the pose (4, 4)."""
    count = {"sphere": 1, "capsule": 2, "cylinder": 2}.get(kind, 3)
    size = one.numbers("size", tuple(range(1, 7)))
    pose = pose_of(one, {key: text for key, text in given.items() if "fromto" not in given or key == "name"}, units)
    if "fromto" in given and kind != "sphere":
        ends = one.numbers("fromto", 6)
        along = ends[:3] - ends[3:]
        pose = placement(from_z(_unit(one, along, "fromto")), 0.5 * (ends[:3] + ends[3:]))
        half = 0.5 * float(np.linalg.norm(along))
        size = np.array([size[0], half] if count == 2 else [size[0], size[0], half])  # boxes are square across
    if len(size) < count or not (size[:count] > 0).all():
        raise one.fault(f"size has too few numbers above 0; a {kind} has {count}.", "Give half lengths and radii, m.")
    return size[:count], pose


def _made(kind: str, size: Any, weight: Mapping[str, Any]) -> MassProperties:
    if kind == "sphere":
        return sphere_properties(size[0], **weight)
    if kind == "cylinder":
        return cylinder_properties(2 * size[1], size[0], **weight)
    if kind == "box":
        return box_properties(2 * size, **weight)
    if kind == "ellipsoid":
        volume = 4.0 / 3.0 * math.pi * float(np.prod(size))
        mass = weight.get("mass", weight.get("density", 0.0) * volume)
        a, b, c = size**2
        return MassProperties(mass=mass, center=np.zeros(3), inertia=mass / 5.0 * np.array([b + c, a + c, a + b]))
    return _capsule(float(size[0]), float(size[1]), weight)


def _capsule(radius: float, half: float, weight: Mapping[str, Any]) -> MassProperties:
    """A cylinder of half length h with half a ball at each end: the balls' centres lie 3 r/8 beyond the ends."""
    ball, rod = 4.0 / 3.0 * math.pi * radius**3, 2.0 * math.pi * radius**2 * half
    density = weight["density"] if "density" in weight else weight["mass"] / (ball + rod)
    m, n = density * rod, density * ball
    around = 0.5 * m * radius**2 + 0.4 * n * radius**2
    across = m * (radius**2 / 4 + half**2 / 3) + n * (0.4 * radius**2 + half**2 + 0.75 * half * radius)
    return MassProperties(mass=m + n, center=np.zeros(3), inertia=np.array([across, across, around]))
