"""A robot from URDF, and the YAML file beside it: closures of loops, motors, types of joints.

``closed_loop: [[frame, frame], ...]``, ``type: [6d, 3d, ...]`` (6d: whole frames; 3d: their origins), ``name_mot: [joint,
...]``, ``joint_name: [joint, ...]`` with ``joint_type: [SPHERICAL, FIXED, CARDAN or UJOINT_XY,
...]``. The layout is that of the robots of example-parallel-robots (V. Batto, L. De Matteis, LAAS-CNRS).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.display import counted
from kinetruss.errors import Fault, InputError, ModelError, shown
from kinetruss.exchange.drawings import Names, tree_of
from kinetruss.exchange.robots import Closure, JointCoupling, JointKind, LeftOut, Link, Pivot, Robot, placement, turn_about
from kinetruss.exchange.xml import Element, parse_xml
from kinetruss.io.yaml_text import Tree
from kinetruss.library.bodies import MassProperties
from kinetruss.model import GROUND, nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray


TYPES: Mapping[str, Literal["ball", "weld"]] = {"3d": "ball", "6d": "weld"}
JOINTS = ("SPHERICAL", "FIXED", "CARDAN", "UJOINT_XY", "UJOINT_XZ", "UJOINT_YX", "UJOINT_YZ", "UJOINT_ZX", "UJOINT_ZY")
KEYS = ("closed_loop", "type", "name_mot", "joint_name", "joint_type")


class Closures:
    """The contents of the file; names are checked when those of the URDF are known."""

    def __init__(self, path: Path, tree: Tree) -> None:
        self.path = str(path)
        table = tree.table or {}
        self._table = table
        self.left_out = [
            LeftOut(key, f"{path}:{one.place[0]}", "is not known here") for key, one in table.items() if key not in KEYS
        ]
        if not any(key in table for key in KEYS):
            raise self._fault(tree, "names no closures and no motors.", f"Give some of: {', '.join(KEYS)}.")

    def _fault(self, tree: Tree, message: str, mend: str) -> ModelError:
        return ModelError([Fault((), message, mend, *tree.place, file=self.path)])

    def _list(self, key: str) -> list[Tree]:
        tree = self._table.get(key)
        if tree is None or (tree.value is None and tree.items is None and tree.table is None):
            return []
        if tree.items is None:
            raise self._fault(tree, f"{key} is no list.", f"Write {key}: [...].")
        return tree.items

    def _word(self, tree: Tree, what: str) -> str:
        if not isinstance(tree.value, str):
            raise self._fault(tree, f"is no {what}.", "Write a name.")
        return tree.value

    def _known(self, tree: Tree, known: Sequence[str] | Mapping[str, Any], what: str) -> str:
        name = self._word(tree, f"name of a {what}")
        if name not in known:
            raise self._fault(tree, f"no {what} called {shown(name)} in the URDF.", nearest(name, known))
        return name

    def drives(self, joints: Sequence[str]) -> list[str]:
        """The joints with motors: a list of names, or one text that their names contain."""
        tree = self._table.get("name_mot")
        if tree is not None and isinstance(tree.value, str):
            found = [name for name in joints if tree.value in name]
            if not found:
                raise self._fault(tree, f"no joint has {shown(tree.value)} in its name.", nearest(tree.value, joints))
            return found
        return [self._known(one, joints, "joint") for one in self._list("name_mot")]

    def kinds(self, joints: Sequence[str]) -> dict[str, str]:
        """Joint -> SPHERICAL, FIXED, CARDAN, or UJOINT_XY: turning about its x, then about its y; of all pairs of axes."""
        names, kinds = self._list("joint_name"), self._list("joint_type")
        self._same("joint_name", names, "joint_type", kinds)
        found = {}
        for name, kind in zip(names, kinds, strict=True):
            word = self._word(kind, "type of a joint").upper()
            if word not in JOINTS:
                raise self._fault(kind, f"joint_type {shown(word)} is not known.", nearest(word, JOINTS))
            found[self._known(name, joints, "joint")] = word
        return found

    def pairs(self, frames: Mapping[str, str]) -> Iterator[tuple[str, Literal["ball", "weld"], str, str, str]]:
        """Name, kind, both links and the place of each closure. frames : name of a link or joint -> link."""
        loops, types = self._list("closed_loop"), self._list("type")
        if types:
            self._same("closed_loop", loops, "type", types)
        for index, loop in enumerate(loops):
            if loop.items is None or len(loop.items) != 2:
                raise self._fault(loop, "a closure names two frames.", "Write [frame, frame].")
            kind: Literal["ball", "weld"] = "weld"
            if types:
                word = self._word(types[index], "type of a closure").lower()
                if word not in TYPES:
                    raise self._fault(types[index], f"type {shown(word)} is not known.", nearest(word, TYPES))
                kind = TYPES[word]
            one, two = (self._known(frame, frames, "link or joint") for frame in loop.items)
            if frames[one] == frames[two]:
                raise self._fault(loop, f"closes {one!r} with itself.", "Name frames of two links.")
            yield f"{one}_{two}", kind, frames[one], frames[two], f"{self.path}:{loop.place[0]}"

    def _same(self, one: str, first: Sequence[Tree], two: str, second: Sequence[Tree]) -> None:
        if len(first) != len(second):
            tree = self._table.get(two) or self._table[one]
            raise self._fault(
                tree, f"{one} has {counted(len(first), 'entry', 'entries')}, {two} {len(second)}.", "Give as many of both."
            )


def read_closures(path: Path, max_size: int) -> Closures:
    """The file; ModelError with line and column if it is not such a file."""
    tree = tree_of(path, max_size)
    if tree.table is None:
        mend = "Write for example closed_loop: [[frame_1A, frame_1B]]."
        raise ModelError([Fault((), "is not a table of names.", mend, *tree.place, file=str(path))])
    return Closures(path, tree)


# A robot from URDF, with the closures of its loops in a YAML file.
#
# URDF describes a tree. The YAML file beside it, as robots of the collection example-parallel-robots have it (Gepetto team,
# LAAS- CNRS), adds pairs of frames that stay together, motors, and joints with more freedoms than URDF knows.

KINDS: Mapping[str, JointKind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "weld",
    "floating": "free",
    "spherical": "ball",
    "planar": "revolute",
}
SINGLE = ("revolute", "continuous", "prismatic")
"""Types of joints with one value: they are driven if no file names motors."""
WHY = {
    "visual": "shapes are not carried; mass and places are",
    "collision": "contacts are not part of a model",
    "limit": "a model has no limits at joints; those of sliders size their guides",
    "dynamics": "friction and damping are those of hinges and sliders only",
    "joint_properties": "is no element of URDF; write its friction as <dynamics friction=.../>",
    "calibration": "has no meaning in a model",
    "safety_controller": "controllers are not carried",
    "transmission": "gears and motors are not carried; give them to the drive",
    "gazebo": "settings of another program",
    "material": "colours are not carried",
}
PARTS = {"link": ("inertial",), "joint": ("origin", "parent", "child", "axis", "limit", "dynamics", "mimic")}


def read_urdf(
    path: Path, text: str, closures: Closures | None = None, at: Mapping[str, float] | None = None, *, floating: bool = False
) -> Robot:
    """The robot of a URDF text. at : joint values, rad or m, at which the closed pose is searched. floating : its base is free.

    Raises
    ------
    ModelError : all that is wrong with an element, with its line.
    """
    root = parse_xml(path, text, "robot")
    _refuse_xacro(root, path)
    names = Names()
    links = {one.text("name"): one for one in _unique(root, "link")}
    joints = {one.text("name"): one for one in _unique(root, "joint")}
    if not links:
        raise root.fault("has no links.", 'Give at least one: <link name="base"/>.')
    base = _base(root, links, joints)
    own_ground = base == GROUND and not floating
    made = {
        name: _link(one, GROUND if own_ground and name == base else names.of(name, one.where)) for name, one in links.items()
    }
    left: list[LeftOut] = []
    if closures is None:
        drives = [name for name, one in joints.items() if one.attributes.get("type") in SINGLE and one.one("mimic") is None]
        kinds: Mapping[str, str] = {}
    else:
        drives, kinds = closures.drives(list(joints)), closures.kinds(list(joints))
        left += closures.left_out
    left += _left_out(root, kinds)
    _check_pose(path, at or {}, joints, kinds)
    pivots: list[Pivot] = []
    own: dict[str, Link] = {}
    called: dict[str, Pivot] = {}
    if floating:
        own[GROUND] = Link(name=GROUND)
        pivots.append(Pivot(name="floating_base", kind="free", parent=GROUND, child=made[base].name, origin=np.eye(4)))
    for name in _outwards(base, joints):
        for pivot, link in _pivots(joints[name], kinds.get(name), made, names):
            single = pivot.kind in ("revolute", "prismatic")
            driven = name in drives and single
            if name in drives and not single:
                left.append(LeftOut("motor", pivot.where, f"a {pivot.kind} joint has no single value to drive"))
            pivots.append(replace(pivot, start=(at or {}).get(name), drive=pivot.name if driven else None))
            called[name] = pivot
            if link is not None:
                own[link.name] = link
    frames = {name: made[name].name for name in links} | {
        name: made[_child(one)].name for name, one in joints.items() if name not in links
    }
    pairs = [] if closures is None else closures.pairs(frames)
    return Robot(
        title=root.attributes.get("name", path.stem),
        root=GROUND if floating else made[base].name,
        links={link.name: link for link in made.values()} | own,
        pivots=pivots,
        closures=[
            Closure(name=name, kind=kind, links=(one, two), frames=(np.eye(4), np.eye(4)), where=where)
            for name, kind, one, two, where in pairs
        ],
        couplings=list(_couplings(joints, called, kinds, left)),
        left_out=[*left, *names.renamed],
    )


def _check_pose(path: Path, at: Mapping[str, float], joints: Mapping[str, Element], kinds: Mapping[str, str]) -> None:
    """Refuse values of joints that are unknown or have no single value."""
    for name in at:
        if name not in joints:
            raise InputError(f"{path}: no joint called {name!r}. {nearest(name, joints)}")
        if not _single(joints[name], kinds.get(name)):
            kind = kinds.get(name) or joints[name].attributes.get("type", "")
            raise InputError(f"{path}: joint {name!r} is {kind}, without a single value. Leave it out of --at (at).")


def _single(joint: Element, other: str | None) -> bool:
    """True for a joint with one value. other : its type in the YAML file."""
    return other is None and joint.attributes.get("type") in SINGLE


def _refuse_xacro(root: Element, path: Path) -> None:
    """Macros stand for elements and numbers that only the program xacro knows."""
    elements = [root]
    while elements:
        one = elements.pop()
        if one.tag.startswith("xacro:") or any("${" in value or "$(" in value for value in one.attributes.values()):
            stem = path.name.split(".")[0]
            raise one.fault(
                "is a macro of xacro, which is not read.", f"Expand it first: xacro {path.name} -o {stem}.plain.urdf"
            )
        elements += one.children


def _couplings(
    joints: Mapping[str, Element], called: Mapping[str, Pivot], kinds: Mapping[str, str], left: list[LeftOut]
) -> Iterator[JointCoupling]:
    """Of joints with <mimic joint multiplier offset>: value - multiplier times that of the other joint = offset.

    A joint that is held stays at 0, so what mimics it stays at the offset.
    """
    for name, joint in joints.items():
        if (mimic := joint.one("mimic")) is None:
            continue
        other, where = mimic.text("joint"), f"{mimic.file}:{mimic.line} {joint.label}"
        if other not in joints:
            raise mimic.fault(f"no joint called {other!r}.", nearest(other, joints))
        if other == name:
            raise mimic.fault(f"joint {name!r} follows itself.", "Name another joint.")
        for one in (name, other):
            if called[one].kind != "weld" and not _single(joints[one], kinds.get(one)):
                raise mimic.fault(f"joint {one!r} has no single value.", "Couple revolute and prismatic joints.")
        factor, offset = mimic.number("multiplier", 1.0), mimic.number("offset", 0.0)
        if called[name].kind == "weld":
            left.append(LeftOut("mimic", where, f"joint {name!r} does not move"))
            continue
        factors = {called[name].name: 1.0}
        if called[other].kind == "weld":
            left.append(LeftOut("mimic", where, f"joint {other!r} does not move: {name!r} is held at the offset"))
        elif factor:
            factors[called[other].name] = -factor
        yield JointCoupling(name=f"{called[name].name}.mimic", factors=factors, value=offset, where=joint.where)


def _child(joint: Element) -> str:
    """Name of the child link of a joint."""
    child = joint.one("child")
    if child is None:
        raise joint.fault("has no <child>.", 'Write <child link="..."/>.')
    return child.text("link")


def _parent(joint: Element) -> str:
    parent = joint.one("parent")
    if parent is None:
        raise joint.fault("has no <parent>.", 'Write <parent link="..."/>.')
    return parent.text("link")


def _unique(root: Element, tag: str) -> Iterator[Element]:
    seen: dict[str, int] = {}
    for one in root.all(tag):
        name = one.text("name")
        if name in seen:
            raise one.fault(f"has the name of the {tag} in line {seen[name]}.", "Give it another name.")
        seen[name] = one.line
        yield one


def _base(root: Element, links: Mapping[str, Element], joints: Mapping[str, Element]) -> str:
    """The link that is no child; every other link is the child of one joint."""
    held: dict[str, Element] = {}
    for joint in joints.values():
        for end in (joint.one("parent"), joint.one("child")):
            name = "" if end is None else end.text("link")
            if end is None:
                _parent(joint), _child(joint)
            elif name not in links:
                raise end.fault(f"names the link {name!r}, which is not there.", nearest(name, links))
        child = _child(joint)
        if child in held:
            text = f"is the second joint that holds the link {child!r}; the first is in line {held[child].line}."
            raise joint.fault(text, "URDF is a tree: close loops in the YAML file (closed_loop).")
        held[child] = joint
    free = [name for name in links if name not in held]
    if not free:
        raise root.fault("has no base: every link is the child of a joint.", "Remove the joint that closes the circle.")
    if len(free) > 1:
        text = f"has {len(free)} links that no joint holds: {', '.join(free[:5])}."
        raise links[free[1]].fault(text, "Give all but the base a joint; a fixed one if they do not move.")
    return free[0]


def _outwards(base: str, joints: Mapping[str, Element]) -> list[str]:
    """Names of joints, each after that of its parent."""
    below: dict[str, list[str]] = {}
    for name, joint in joints.items():
        below.setdefault(_parent(joint), []).append(name)
    found: list[str] = []
    left = [base]
    while left:
        here = below.pop(left.pop(0), [])
        found += here
        left += [_child(joints[name]) for name in here]
    if below:  # links in a circle hang on no base
        name = next(iter(below.values()))[0]
        raise joints[name].fault("belongs to a circle of links that hangs on no base.", "Correct its parent or child.")
    return found


def _pose(element: Element | None) -> NDArray[np.float64]:
    """(4, 4) of <origin xyz rpy>: rotations about the fixed x, y, z, in this order."""
    if element is None:
        return np.eye(4)
    roll, pitch, yaw = element.numbers("rpy", 3, (0, 0, 0))
    R = turn_about((0, 0, 1), yaw) @ turn_about((0, 1, 0), pitch) @ turn_about((1, 0, 0), roll)
    return placement(R, element.numbers("xyz", 3, (0, 0, 0)))


def _link(element: Element, name: str) -> Link:
    inertial = element.one("inertial")
    if inertial is None:
        return Link(name=name, where=element.where)
    weight = inertial.one("mass")
    if weight is None:
        raise inertial.fault("has no <mass>.", 'Write <mass value="..."/>, kg.')
    mass = weight.number("value")
    if mass < 0:
        raise weight.fault(f"has the mass {mass:g} kg.", "Give 0 or more.")
    tensor, pose = np.zeros((3, 3)), _pose(inertial.one("origin"))
    if (given := inertial.one("inertia")) is not None:
        for i, row in enumerate("xyz"):
            for j, column in enumerate("xyz"):
                tensor[i, j] = given.number("i" + "".join(sorted(row + column)), 0.0 if row != column else None)
    if mass == 0 and not tensor.any():
        return Link(name=name, where=element.where)
    R = pose[:3, :3]
    properties = MassProperties(mass=mass, center=pose[:3, 3], inertia=R @ tensor @ R.T)
    return Link(name=name, properties=properties, where=(given or inertial).where.replace("<inertia>", f"{element.label}"))


def _pivots(joint: Element, other: str | None, links: Mapping[str, Link], names: Names) -> Iterator[tuple[Pivot, Link | None]]:
    """The joint; of a cardan two with a link between them. other : its type in the YAML file."""
    name, kind = names.of(joint.text("name"), joint.where, "joint"), joint.text("type")
    if other is None and kind not in KINDS:
        mend = "Build it from revolute and prismatic joints with links without mass between them."
        raise joint.fault(f"has the type {kind!r}, which is not carried.", f"{mend} Known are: {', '.join(KINDS)}.")
    parent, child, origin = links[_parent(joint)].name, links[_child(joint)].name, _pose(joint.one("origin"))
    axis = joint.one("axis")
    along = np.array([1.0, 0.0, 0.0]) if axis is None else axis.numbers("xyz", 3, (1, 0, 0))
    if other == "CARDAN" or (other or "").startswith("UJOINT_"):
        first, second = tuple("XY" if other == "CARDAN" else str(other)[-2:])
        middle = Link(name=names.of(f"{name}_cross", joint.where), where=joint.where)
        for word, ends, frame, link in (
            (first, (parent, middle.name), origin, middle),
            (second, (middle.name, child), np.eye(4), None),
        ):
            turning = np.eye(3)["XYZ".index(word)]
            yield (
                Pivot(
                    name=f"{name}_{word}", kind="revolute", parent=ends[0], child=ends[1], origin=frame, axis=turning,
                    where=joint.where,
                ),
                link,
            )  # fmt: skip
        return
    found: JointKind = "ball" if other == "SPHERICAL" else "weld" if other == "FIXED" else KINDS[kind]
    if found in ("revolute", "prismatic"):  # a planar one turns about its axis
        if not (size := float(np.linalg.norm(along))):
            raise (axis or joint).fault("has an axis without direction.", 'Write for example <axis xyz="0 0 1"/>.')
        along = along / size
    damping = friction = 0.0
    if kind in SINGLE and other is None and (dynamics := joint.one("dynamics")) is not None:
        damping, friction = (_resisting(dynamics, word) for word in ("damping", "friction"))
    limits = None
    if kind == "planar":
        x, y = _across(along)
        for word, way in (("x", x), ("y", y)):
            between = Link(name=names.of(f"{name}_{word}", joint.where), where=joint.where)
            slide = Pivot(
                name=names.of(f"{name}_{word}", joint.where, "joint"), kind="prismatic", parent=parent, child=between.name,
                origin=origin, axis=way, where=joint.where,
            )  # fmt: skip
            yield slide, between
            parent, origin = between.name, np.eye(4)
    if (limit := joint.one("limit")) is not None and "lower" in limit.attributes and "upper" in limit.attributes:
        limits = (limit.number("lower"), limit.number("upper"))
    yield (
        Pivot(
            name=name,
            kind=found,
            parent=parent,
            child=child,
            origin=origin,
            axis=along,
            limits=limits,
            spring=(0.0, 0.0, damping, friction),
            where=joint.where,
        ),
        None,
    )


def _across(normal: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Two unit vectors that are a right-handed frame with a third: x and y for z."""
    x = np.eye(3)[(int(np.argmax(np.abs(normal))) + 1) % 3]
    x = x - (x @ normal) * normal
    x /= np.linalg.norm(x)
    return x, np.cross(normal, x)


def _resisting(dynamics: Element, word: str) -> float:
    found = dynamics.number(word, 0.0)
    if found < 0:
        raise dynamics.fault(f"has the {word} {found:g}.", "Give 0 or more.")
    return found


def _left_out(root: Element, kinds: Mapping[str, str]) -> Iterator[LeftOut]:
    """Elements that are not carried. kinds : types of joints in the YAML file."""
    for one in root.children:
        if one.tag not in PARTS:
            yield LeftOut(one.tag, one.where, WHY.get(one.tag, "is not known here"))
            continue
        for child in one.children:
            still = child.tag == "dynamics" and one.attributes.get("type") in SINGLE and one.attributes.get("name") not in kinds
            if child.tag not in PARTS[one.tag] or (child.tag in ("limit", "dynamics") and not still):
                where = f"{child.file}:{child.line} {one.label}"
                yield LeftOut(child.tag, where, WHY.get(child.tag, "is not known here"))
