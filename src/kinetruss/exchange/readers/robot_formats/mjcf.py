"""A robot from MJCF, the format of MuJoCo: bodies, joints, masses, `connect` and `weld`, actuators."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.errors import InputError
from kinetruss.exchange.readers.naming import Names
from kinetruss.exchange.readers.robot_formats.included import included
from kinetruss.exchange.readers.robot_formats.mjcf_laws import Laws
from kinetruss.exchange.readers.robot_formats.mjcf_mass import Defaults, Units, pose_of, properties_of
from kinetruss.exchange.readers.robot_formats.xml import Element, parse_xml
from kinetruss.exchange.robots import (
    Closure,
    JointKind,
    LeftOut,
    Link,
    Pivot,
    Robot,
    Span,
    placement,
    quaternion_matrix,
    turn_about,
)
from kinetruss.io import MAX_SIZE
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["read_mjcf"]

JOINTS: Mapping[str, JointKind] = {"hinge": "revolute", "slide": "prismatic", "ball": "ball", "free": "free"}
COMPILED = "Load it in MuJoCo, save the compiled model (mj_saveLastXML), and import that."
REFUSED = ("replicate", "composite", "flexcomp", "attach")
"""Elements that stand for others."""
READ = ("compiler", "option", "default", "worldbody", "equality", "actuator", "tendon")
WHY = {
    "asset": "meshes and textures are not carried",
    "contact": "contacts are not part of a model",
    "sensor": "sensors are not carried",
    "keyframe": "poses are not carried; give one with --at",
    "visual": "settings of another program",
    "statistic": "settings of another program",
    "size": "settings of another program",
    "camera": "views are not carried",
    "light": "views are not carried",
    "geom": "shapes are not carried; mass and places are",
}
JOINT_WHY = {
    "armature": "inertia of the rotors of balls and of free bodies is not carried",
    "damping": "damping of balls and of free bodies, and laws of several numbers, are not carried",
    "stiffness": "springs of balls and of free bodies, and laws of several numbers, are not carried",
    "frictionloss": "friction of balls and of free bodies is not carried",
    "range": "a model has no limits at joints; those of sliders size their guides",
}


def read_mjcf(path: Path, text: str, at: Mapping[str, float] | None = None, *, max_size: int = MAX_SIZE) -> Robot:
    """The robot of an MJCF text and the files that it includes. at : joint values, rad or m, at which the search starts.

    Raises
    ------
    ModelError : all that is wrong with an element, with its line.
    """
    return _Reader(path, included(parse_xml(path, text, "mujoco"), path.parent, max_size)).robot(at or {})


class _Reader:
    """Collects links, joints and points of the tree, then closures and drives that name them."""

    def __init__(self, path: Path, root: Element) -> None:
        self.path, self.root = path, root
        self.names = Names()
        self.units = Units(root)
        self.defaults = Defaults(root)
        self.links: dict[str, Link] = {"world": Link(name="world")}
        self.pivots: list[Pivot] = []
        self.left: list[LeftOut] = []
        self.body: dict[str, str] = {"world": "world"}
        """Name in the file -> link."""
        self.joint: dict[str, str] = {}
        self.site: dict[str, tuple[str, NDArray[np.float64]]] = {}
        self.point: dict[str, str] = {}
        """Site -> node."""
        self.ratios: dict[str, float] = {}
        """Joint -> gear of its actuator."""

    def robot(self, at: Mapping[str, float]) -> Robot:
        for one in self.root.children:
            if one.tag in REFUSED:
                raise one.fault("stands for other elements and is not read.", COMPILED)
            if one.tag not in READ:
                self.left.append(LeftOut(one.tag, one.where, WHY.get(one.tag, "is not known here")))
        worlds = list(self.root.all("worldbody"))
        if not worlds:
            raise self.root.fault("has no <worldbody>.", "Give <worldbody> with at least one <body>.")
        for world in worlds:
            self._inside(world, "world", np.eye(4), "main")
        conditions = [element for group in self.root.all("equality") for element in group.children]
        closures = [one for element in conditions if element.tag != "joint" for one in self._closure(element)]
        laws = Laws(self.defaults, self.names, self.left)
        called = {one.name: one for one in self.pivots}
        known = {given: called[name] for given, name in self.joint.items()}
        couplings = laws.couplings([one for one in conditions if one.tag == "joint"], known)
        spans = laws.spans([one for group in self.root.all("tendon") for one in group.children], self.point)
        motors = [element for group in self.root.all("actuator") for element in group.children]
        drives = {name for element in motors for name in self._drive(element, spans)}
        ratios = {name: ratio for name, ratio in self.ratios.items() if name in drives}
        if unknown := [name for name in at if name not in self.joint]:
            raise InputError(f"{self.path}: no joint called {unknown[0]!r}. {nearest(unknown[0], self.joint)}")
        values = {self.joint[name]: value for name, value in at.items()}
        pivots = [
            replace(one, drive=one.name if one.name in drives else None, ratio=ratios.get(one.name), start=values.get(one.name))
            for one in self.pivots
        ]
        x, y, z = 0.0, 0.0, -9.81
        for option in self.root.all("option"):
            x, y, z = option.numbers("gravity", 3, (x, y, z)).tolist()
        return Robot(
            title=self.root.attributes.get("model", self.path.stem),
            root="world",
            links=self.links,
            pivots=pivots,
            closures=closures,
            couplings=couplings,
            spans=laws.acting(spans, drives),
            gravity=(x, y, z),
            left_out=[*self.left, *self.names.renamed],
        )

    def _inside(self, element: Element, link: str, frame: NDArray[np.float64], group: str) -> None:
        """Bodies, sites and shapes of a body, the world or a <frame> in it. frame : (4, 4) in the link."""
        for child in element.children:
            if child.tag in REFUSED:
                raise child.fault("stands for other elements and is not read.", COMPILED)
            if child.tag == "body":
                self._body(child, link, frame, group)
            elif child.tag == "frame":
                inner = child.attributes.get("childclass", group)
                self._inside(child, link, frame @ pose_of(child, child.attributes, self.units), inner)
            elif child.tag == "site":
                self._site(child, link, frame, group)
            elif child.tag not in ("joint", "freejoint", "inertial"):
                self.left.append(LeftOut(child.tag, child.where, WHY.get(child.tag, "is not known here")))

    def _site(self, element: Element, link: str, frame: NDArray[np.float64], group: str) -> None:
        place = frame @ pose_of(element, self.defaults.of(element, group), self.units)
        name = element.attributes.get("name")
        if name is not None:
            self.site[name] = (link, place)
            self.point[name] = self.names.of(name, element.where, "joint")
            points = {**self.links[link].points, self.point[name]: place[:3, 3]}
            self.links[link] = replace(self.links[link], points=points)

    def _body(self, element: Element, parent: str, frame: NDArray[np.float64], group: str) -> None:
        group = element.attributes.get("childclass", group)
        given = element.attributes.get("name", f"body_{element.line}")
        name = self.names.of(given, element.where)
        if given in self.body:
            raise element.fault("has the name of another body.", "Give it another name.")
        for word, why in (("mocap", "moved bodies rest where they are"), ("gravcomp", "weight is not compensated")):
            if word in element.attributes:
                self.left.append(LeftOut(word, element.where, why))
        self.body[given] = name
        properties = properties_of(element, group, self.defaults, self.units)
        self.links[name] = Link(name=name, properties=properties, where=element.where)
        self._joints(element, name, parent, frame @ pose_of(element, element.attributes, self.units), group)
        self._inside(element, name, np.eye(4), group)

    def _joints(self, element: Element, name: str, parent: str, frame: NDArray[np.float64], group: str) -> None:
        """The joints of a body, one after the other, with links without mass between them; a weld without any."""
        joints = [one for one in element.children if one.tag in ("joint", "freejoint")]
        for index, one in enumerate(joints):
            given = self.defaults.of(one, group)
            one = _with(one, given)
            kind = JOINTS["free" if one.tag == "freejoint" else one.choice("type", tuple(JOINTS), "hinge")]
            child = name
            if index < len(joints) - 1:
                child = self.names.of(f"{name}.{index + 1}", one.where)
                self.links[child] = Link(name=child, where=one.where)
            pivot = self._pivot(one, kind, index, name)
            self.pivots.append(replace(pivot, parent=parent, child=child, origin=frame @ pivot.origin))
            parent, frame = child, np.eye(4)
        if not joints:
            held = Pivot(name=f"{name}.held", kind="weld", parent=parent, child=name, origin=frame, where=element.where)
            self.pivots.append(held)

    def _pivot(self, one: Element, kind: JointKind, index: int, body: str) -> Pivot:
        given = one.attributes.get("name", f"{body}_joint{index + 1 if index else ''}")
        if given in self.joint:
            raise one.fault("has the name of another joint.", "Give it another name.")
        own = self.names.of(given, one.where, "joint")
        self.joint[given] = own
        single = kind in ("revolute", "prismatic")
        carried = self._carried(one) if single else ()
        for word, why in JOINT_WHY.items():
            if word in one.attributes and (word == "range" or (word not in carried and np.any(one.numbers(word, (1, 2, 3))))):
                self.left.append(LeftOut(word, one.where, why))
        if kind == "free":
            return Pivot(name=own, kind=kind, parent="", child="", origin=np.eye(4), where=one.where)
        place = one.numbers("pos", 3, (0, 0, 0))
        axis = one.numbers("axis", 3, (0, 0, 1))
        if not (size := float(np.linalg.norm(axis))):
            raise one.fault("has an axis without direction.", 'Write for example axis="0 0 1".')
        axis, origin, value, limits = axis / size, placement(None, place), 0.0, None
        if kind in ("revolute", "prismatic"):
            scale = self.units.angle if kind == "revolute" else 1.0
            value = scale * one.number("ref", 0.0)
            if "range" in one.attributes:
                limits = tuple((scale * one.numbers("range", 2)).tolist())
            back = turn_about(axis, -value) if kind == "revolute" else None
            origin = placement(back, place if back is not None else place - value * axis)
        after = placement(None, -place)
        return Pivot(
            name=own, kind=kind, parent="", child="", origin=origin, axis=axis, after=after, home=value, limits=limits,
            spring=self._spring(one, kind, carried), armature=self._resisting(one, carried, "armature"), where=one.where,
        )  # fmt: skip

    def _carried(self, one: Element) -> tuple[str, ...]:
        """Attributes of a hinge or slide that its spring and its rotor hold: those of a single number."""
        several = any(len(one.text(word, "").split()) > 1 for word in ("stiffness", "damping"))
        return ("frictionloss", "armature") if several else ("stiffness", "damping", "frictionloss", "armature")

    def _spring(self, one: Element, kind: JointKind, carried: Collection[str]) -> tuple[float, float, float, float]:
        """Stiffness, value without force, damping and friction of a hinge or slide."""
        stiffness, damping, friction = (
            self._resisting(one, carried, word) for word in ("stiffness", "damping", "frictionloss")
        )
        rest = one.number("springref", 0.0) if "stiffness" in carried else 0.0
        return stiffness, self.units.angle * rest if kind == "revolute" else rest, damping, friction

    def _resisting(self, one: Element, carried: Collection[str], word: str) -> float:
        found = one.number(word, 0.0) if word in carried else 0.0
        if found < 0:
            raise one.fault(f"has the {word} {found:g}.", "Give 0 or more.")
        return found

    def _closure(self, element: Element) -> Iterator[Closure]:
        given = self.defaults.of(element, "main")
        element = _with(element, given)
        if given.get("active", "true") == "false":
            self.left.append(LeftOut(element.tag, element.where, "is not active"))
            return
        if element.tag not in ("connect", "weld"):
            self.left.append(LeftOut(element.tag, element.where, "this condition is not carried; add a coupling"))
            return
        name = self.names.of(given.get("name", f"{element.tag}_{element.line}"), element.where, "closure")
        kind: Literal["ball", "weld"] = "ball" if element.tag == "connect" else "weld"
        if "site1" in given or "site2" in given:
            one, two = (self._named(element, word, self.site, "site") for word in ("site1", "site2"))
            links, frames = (one[0], two[0]), (one[1], two[1])
        else:
            first = self._named(element, "body1", self.body, "body")
            second = self._named(element, "body2", self.body, "body") if "body2" in given else "world"
            links, frames = (first, second), self._frames(element, kind)
        if links[0] == links[1]:
            raise element.fault("joins a body to itself.", "Name two bodies.")
        yield Closure(name=name, kind=kind, links=links, frames=frames, where=element.where)

    def _frames(self, element: Element, kind: str) -> tuple[NDArray[np.float64], NDArray[np.float64] | None]:
        if kind == "ball":
            return placement(None, element.numbers("anchor", 3)), None
        pose = element.numbers("relpose", 7, (0, 0, 0, 0, 0, 0, 0))
        if not pose[3:].any():
            return np.eye(4), None
        return placement(quaternion_matrix(pose[3:]), pose[:3]), np.eye(4)

    def _drive(self, element: Element, spans: Mapping[str, Span]) -> Iterator[str]:
        element = _with(element, {**self.defaults.of(element, "main")})
        given = element.attributes
        if not {"joint", "tendon"} & given.keys() or given.get("tendon", "") not in {"", *spans}:
            self.left.append(
                LeftOut(element.tag, element.where, "only actuators of joints and of straight tendons are carried")
            )
            return
        known = {"name", "joint", "tendon", "class"}
        if "tendon" in given:
            name = spans[given["tendon"]].name
        else:
            name = self._named(element, "joint", self.joint, "joint")
            kind = {one.name: one for one in self.pivots}[name].kind
            if kind not in ("revolute", "prismatic"):
                raise element.fault("drives a joint of several freedoms.", "Drive hinges and slides.")
            if kind == "revolute" and (ratio := self._ratio(element)) is not None:
                self.ratios[name] = ratio
                known.add("gear")
        if more := sorted(set(given) - known):
            why = "of an actuator its joint is carried, and the gear of a hinge if it is above 0; control belongs to a run"
            self.left.append(LeftOut(f"{element.tag}: {', '.join(more)}", element.where, why))
        yield name

    def _ratio(self, element: Element) -> float | None:
        """The gear of an actuator: torque on the joint over that of the motor; None if a drive cannot hold it."""
        if "gear" not in element.attributes:
            return None
        numbers = element.numbers("gear", tuple(range(1, 7)))
        return float(numbers[0]) if numbers[0] > 0 and not numbers[1:].any() else None

    def _named(self, element: Element, word: str, known: Mapping[str, Any], what: str) -> Any:
        name = element.text(word)
        if name not in known:
            raise element.fault(f"{word}: no {what} called {name!r}.", nearest(name, known))
        return known[name]


def _with(element: Element, attributes: Mapping[str, str]) -> Element:
    """The element with the attributes of its class added."""
    return Element(element.file, element.tag, element.line, attributes, element.children)
