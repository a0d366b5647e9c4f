"""A robot from MJCF, the format of MuJoCo: from the model that MuJoCo compiles of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.exchange.drawings import Names
from kinetruss.exchange.mjcf_child import LEAST
from kinetruss.exchange.mjcf_compile import Compiled, compiled, included
from kinetruss.exchange.mjcf_fields import CONTROL, FLAGS, LISTED
from kinetruss.exchange.robots import (
    Closure,
    JointCoupling,
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
from kinetruss.exchange.xml import Element, parse_xml
from kinetruss.io import MAX_SIZE
from kinetruss.library.bodies import MassProperties
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray


KINDS: Mapping[str, JointKind] = {
    "mjJNT_HINGE": "revolute",
    "mjJNT_SLIDE": "prismatic",
    "mjJNT_BALL": "ball",
    "mjJNT_FREE": "free",
}
SINGLE = ("revolute", "prismatic")
READ = ("compiler", "option", "default", "worldbody", "equality", "actuator", "tendon", "extension", "deformable")
SETTINGS = "settings of another program"
WHY = {
    "asset": "meshes and textures are not carried",
    "contact": "contacts are not part of a model",
    "sensor": "sensors are not carried",
    "keyframe": "poses are not carried; give one with --at",
    **dict.fromkeys(("visual", "statistic", "size", "custom"), SETTINGS),
    "camera": "views are not carried",
    "light": "views are not carried",
    "geom": "shapes are not carried; mass and places are",
}
MANY = {
    "armature": "inertia of the rotors of balls and of free bodies is not carried",
    "damping": "damping of balls and of free bodies is not carried",
    "stiffness": "springs of balls and of free bodies are not carried",
    "frictionloss": "friction of balls and of free bodies is not carried",
}


def read_mjcf(path: Path, text: str, at: Mapping[str, float] | None = None, *, max_size: int = MAX_SIZE) -> Robot:
    """The robot of an MJCF text and the files that it includes. at : joint values, rad or m, at which the search starts.

    Raises
    ------
    ModelError : all that is wrong with an element, with its line. InputError : MuJoCo is not installed.
    """
    root = included(parse_xml(path, text, "mujoco"), path.parent, max_size)
    if next(root.all("worldbody"), None) is None:
        raise root.fault("has no <worldbody>.", "Give <worldbody> with at least one <body>.")
    return _Reader(root, compiled(root, path.parent, max_size)).robot(path, at or {})


class _Reader:
    """Links, joints and points of the bodies, then what acts between them."""

    def __init__(self, root: Element, made: Compiled) -> None:
        self.root, self.made, self.names = root, made, Names()
        self.off = {flag.removeprefix("mjDSBL_") for flag in made.said["disableflags"]}
        if "CONSTRAINT" in self.off:
            self.off |= {"EQUALITY", "FRICTIONLOSS", "LIMIT", "CONTACT"}
        self.left: list[LeftOut] = []
        self.links = [Link(name="world")]
        self.pivots: dict[int, Pivot] = {}
        """Joint -> its pivot."""
        self.chain: list[Pivot | int] = []
        """Welds and joints outwards; what acts on a joint is known later."""
        self.between: list[Link] = []

    def robot(self, path: Path, at: Mapping[str, float]) -> Robot:
        made = self.made
        for root in made.roots:
            self._sections(root, top=True)
        for body in range(1, int(made.nbody)):
            self._body(body)
        self._points()
        self._listed()
        closures, couplings = list(self._closures()), list(self._couplings())
        spans = self._spans()
        self._actuators(spans)
        self._acting(spans)
        called = {made.name("joint", j) or one.name: one.name for j, one in self.pivots.items()}
        if unknown := [name for name in at if name not in called]:
            raise InputError(f"{path}: no joint called {unknown[0]!r}. {nearest(unknown[0], called)}")
        start = {called[name]: value for name, value in at.items()}
        pivots = [self.pivots[one] if isinstance(one, int) else one for one in self.chain]
        missing = ", ".join(sorted(Path(file).name for file in made.said["missing"]))
        return Robot(
            title=self.root.attributes.get("model", path.stem),
            root="world",
            links={one.name: one for one in [*self.links, *self.between]},
            pivots=[replace(one, start=start.get(one.name)) if one.kind != "weld" else one for one in pivots],
            closures=closures,
            couplings=couplings,
            spans=[one for one in spans.values() if one.driven or one.spring],
            gravity=(0.0, 0.0, 0.0) if "GRAVITY" in self.off else tuple(made.fields["opt.gravity"].tolist()),
            left_out=[*self.left, *self.names.renamed],
            notes=[f"files of shapes that are not there, and that no mass needs: {missing}"] if missing else [],
        )

    def _lost(self, what: str, element: Element, why: str) -> None:
        self.left.append(LeftOut(what, element.where, why))

    def _sections(self, element: Element, *, top: bool = False) -> None:
        """Elements of the file that a model does not have."""
        for one in element.children:
            if top and one.tag not in READ:
                self._lost(one.tag, one, WHY.get(one.tag, "is not known here"))
            elif one.tag in ("worldbody", "body", "frame", "replicate"):
                self._sections(one)
            elif one.tag in ("geom", "camera", "light"):
                self._lost(one.tag, one, WHY[one.tag])

    def _called(self, kind: str, index: int, otherwise: str, table: str) -> str:
        """A name for an element of the file; `otherwise` if it has none."""
        name, where = self.made.name(kind, index), self.made.element(kind, index).where
        found, listed = self.names.of(name or otherwise, where, table), self.names.renamed
        if not name and listed and listed[-1].where == where:
            listed.pop()
        return found

    def _body(self, body: int) -> None:
        """The link of a body, and its joints one after the other, with links without mass between them; a weld without any."""
        made, element = self.made, self.made.element("body", body)
        name = self._called("body", body, f"body_{element.line}", "link")
        self.links.append(Link(name=name, properties=_properties(made, body), where=element.where))
        parent = self.links[made.body_parentid[body]].name
        frame = placement(quaternion_matrix(made.body_quat[body]), made.body_pos[body])
        count, first = int(made.body_jntnum[body]), int(made.body_jntadr[body])
        for index in range(count):
            child = name
            if index < count - 1:
                where = made.element("joint", first + index).where
                child = self.names.of(f"{name}.{index + 1}", where)
                self.between.append(Link(name=child, where=where))
            pivot = self._pivot(first + index, f"{name}_joint{index + 1 if index else ''}")
            self.pivots[first + index] = replace(pivot, parent=parent, child=child, origin=frame @ pivot.origin)
            self.chain.append(first + index)
            parent, frame = child, np.eye(4)
        if not count:
            held = Pivot(name=f"{name}.held", kind="weld", parent=parent, child=name, origin=frame, where=element.where)
            self.chain.append(held)

    def _pivot(self, joint: int, otherwise: str) -> Pivot:
        made, element = self.made, self.made.element("joint", joint)
        kind = KINDS[made.jnt_type[joint]]
        given: dict[str, Any] = {
            "name": self._called("joint", joint, otherwise, "joint"), "kind": kind, "parent": "", "child": "",
            "where": element.where,
        }  # fmt: skip
        dof, value, rest = (int(made.jnt_dofadr[joint]), int(made.jnt_qposadr[joint]), 0.0)
        law = {
            "stiffness": 0.0 if "SPRING" in self.off else float(made.jnt_stiffness[joint]),
            "damping": 0.0 if "DAMPER" in self.off else float(made.dof_damping[dof]),
            "frictionloss": 0.0 if "FRICTIONLOSS" in self.off else float(made.dof_frictionloss[dof]),
            "armature": float(made.dof_armature[dof]),
        }
        for word, number in law.items():
            if number < 0:
                raise element.fault(f"has the {word} {number:g}.", "Give 0 or more.")
            if number and kind not in SINGLE:
                self._lost(word, element, MANY[word])
        if kind == "free":
            return Pivot(origin=np.eye(4), **given)
        place, axis = made.jnt_pos[joint], made.jnt_axis[joint]
        if kind == "ball":
            return Pivot(origin=placement(None, place), after=placement(None, -place), **given)
        home, rest = float(made.qpos0[value]), float(made.qpos_spring[value])
        limits = tuple(made.jnt_range[joint].tolist()) if made.jnt_limited[joint] else None
        turned = kind == "revolute"
        return Pivot(
            origin=placement(turn_about(axis, -home), place) if turned else placement(None, place - home * axis),
            axis=axis, after=placement(None, -place), home=home, limits=limits, armature=law["armature"],
            spring=(law["stiffness"], rest, law["damping"], law["frictionloss"]), **given,
        )  # fmt: skip

    def _points(self) -> None:
        """Sites with a name are points of their links."""
        made = self.made
        self.point: dict[int, str] = {}
        for site in range(int(made.nsite)):
            if made.name("site", site):
                self.point[site] = self._called("site", site, "", "joint")
                body = int(made.site_bodyid[site])
                points = {**self.links[body].points, self.point[site]: made.site_pos[site]}
                self.links[body] = replace(self.links[body], points=points)

    def _closures(self) -> Iterator[Closure]:
        """Of connect and weld."""
        made = self.made
        for k in range(int(made.neq)):
            one, kind = made.element("equality", k), str(made.eq_type[k])
            if kind in ("mjEQ_JOINT", "mjEQ_TENDON"):
                continue
            if not self._acts(k):
                continue
            if kind not in ("mjEQ_CONNECT", "mjEQ_WELD"):
                self._lost(one.tag, one, "this condition is not carried; add a coupling")
                continue
            data, ids = made.eq_data[k], (int(made.eq_obj1id[k]), int(made.eq_obj2id[k]))
            ball = kind == "mjEQ_CONNECT" or not data[10]  # a weld without a torque is a ball
            if made.eq_objtype[k] == "mjOBJ_SITE":
                frames = tuple(placement(quaternion_matrix(made.site_quat[i]), made.site_pos[i]) for i in ids)
                ids = (int(made.site_bodyid[ids[0]]), int(made.site_bodyid[ids[1]]))
            elif kind == "mjEQ_CONNECT":
                frames = (placement(None, data[:3]), placement(None, data[3:6]))
            else:  # of the second body the point, in the first the same point and the rotation of the second
                frames = (placement(quaternion_matrix(data[6:10]), data[3:6]), placement(None, data[:3]))
            links = (self.links[ids[0]].name, self.links[ids[1]].name)
            if links[0] == links[1]:
                raise one.fault("joins a body to itself.", "Name two bodies.")
            name = self._called("equality", k, f"{one.tag}_{one.line}", "closure")
            yield Closure(
                name=name, kind="ball" if ball else "weld", links=links, frames=(frames[0], frames[1]), where=one.where
            )

    def _acts(self, k: int) -> bool:
        """True for a condition that is on."""
        one, off = self.made.element("equality", k), "EQUALITY" in self.off
        if off or not self.made.eq_active0[k]:
            what = "joint equality" if one.tag == "joint" else one.tag
            self._lost(what, one, "is switched off by a flag of the file" if off else "is not active")
            return False
        return True

    def _couplings(self) -> Iterator[JointCoupling]:
        """Of joints and fixed tendons: y - y0 = c0 + c1 (x - x0), with y0, x0 the values where the file draws the robot."""
        made = self.made
        for k in range(int(made.neq)):
            one, kind = made.element("equality", k), str(made.eq_type[k])
            if kind not in ("mjEQ_JOINT", "mjEQ_TENDON") or not self._acts(k):
                continue
            what = "joint equality" if kind == "mjEQ_JOINT" else "tendon equality"
            ids = [int(i) for i in (made.eq_obj1id[k], made.eq_obj2id[k]) if i >= 0]
            series = made.eq_data[k, :5].tolist()
            if len(ids) == 2 and any(series[2:]):
                self._lost(what, one, "only linear couplings (c0, c1) are carried")
                continue
            terms = [self._terms(i, kind == "mjEQ_JOINT") for i in ids]
            if not all(terms):
                self._lost(what, one, "only hinges, slides and fixed tendons of them are coupled")
                continue
            factors: dict[str, float] = {}
            value = series[0]
            for slope, own in zip((1.0, -series[1]), terms, strict=False):
                for joint, factor in own.items():
                    pivot = self.pivots[joint]
                    factors[pivot.name] = factors.get(pivot.name, 0.0) + slope * factor
                    value += slope * factor * pivot.home
            factors = {joint: factor for joint, factor in factors.items() if factor}
            if not factors:
                self._lost(what, one, "holds nothing")
                continue
            name = self._called("equality", k, f"coupling_{one.line}", "joint")
            yield JointCoupling(name=name, factors=factors, value=value, where=one.where)

    def _terms(self, index: int, joint: bool) -> dict[int, float]:
        """Joint -> factor of a joint or a fixed tendon; empty for another tendon."""
        made = self.made
        if joint:
            return {index: 1.0} if self.pivots[index].kind in SINGLE else {}
        found: dict[int, float] = {}
        for wrap in self._path(index):
            if made.wrap_type[wrap] != "mjWRAP_JOINT":
                return {}
            found[int(made.wrap_objid[wrap])] = found.get(int(made.wrap_objid[wrap]), 0.0) + float(made.wrap_prm[wrap])
        return found

    def _path(self, tendon: int) -> range:
        first = int(self.made.tendon_adr[tendon])
        return range(first, first + int(self.made.tendon_num[tendon]))

    def _spans(self) -> dict[int, Span]:
        """Tendons straight between two sites."""
        made, found = self.made, dict[int, Span]()
        for k in range(int(made.ntendon)):
            one, path = made.element("tendon", k), self._path(k)
            ends = [int(made.wrap_objid[wrap]) for wrap in path if made.wrap_type[wrap] == "mjWRAP_SITE"]
            if len(ends) != 2 or len(path) != 2:
                self._lost(one.tag, one, "only tendons straight between two sites are carried")
                continue
            low, high = made.tendon_lengthspring[k].tolist()
            stiffness = 0.0 if "SPRING" in self.off else float(made.tendon_stiffness[k])
            if stiffness and low != high:
                self._lost("springlength", one, "a spring that is slack between two lengths is not carried")
                stiffness = 0.0
            damping = 0.0 if "DAMPER" in self.off else float(made.tendon_damping[k])
            friction = 0.0 if "FRICTIONLOSS" in self.off else float(made.tendon_frictionloss[k])
            for word, number in (("stiffness", stiffness), ("damping", damping), ("frictionloss", friction)):
                if number < 0:
                    raise one.fault(f"has the {word} {number:g}.", "Give 0 or more.")
            found[k] = Span(
                name=self._called("tendon", k, f"tendon_{one.line}", "joint"),
                points=(self.point[ends[0]], self.point[ends[1]]),
                spring=(stiffness, low, damping, friction) if stiffness or damping or friction else None,
                where=one.where,
            )
        return found

    def _acting(self, spans: Mapping[int, Span]) -> None:
        for one in spans.values():
            if not one.driven and one.spring is None:
                self.left.append(LeftOut("spatial", one.where, "has no actuator, stiffness, damping or friction, so no force"))

    def _actuators(self, spans: dict[int, Span]) -> None:
        """Drives of joints and spans, gears of hinges, and the damping and the rotors of the actuators themselves."""
        made = self.made
        driving: dict[str, list[int]] = {}
        gear = [float(made.actuator_gear[row][0]) for row in made.actuator_outadr]
        words = self._words()
        for k in range(int(made.nactuator)):
            one, kind, target = made.element("actuator", k), str(made.actuator_trntype[k]), int(made.actuator_trnid[k][0])
            on_joint, on_span = kind in ("mjTRN_JOINT", "mjTRN_JOINTINPARENT"), kind == "mjTRN_TENDON" and target in spans
            if not on_span and not (on_joint and self.pivots[target].kind in SINGLE):
                self._lost(one.tag, one, "only actuators of hinges, slides and straight tendons are carried")
                continue
            damping = 0.0 if "DAMPER" in self.off else float(made.actuator_damping[k]) * gear[k] ** 2
            rotor = float(made.actuator_armature[k]) * gear[k] ** 2
            if on_span:
                spans[target] = _damped(spans[target], damping)
                words[k] += ["armature"] * bool(rotor) + ["gear"] * (gear[k] != 1)
            else:
                pivot = self.pivots[target]
                stiffness, rest, own, friction = pivot.spring
                law = (stiffness, rest, own + damping, friction)
                self.pivots[target] = replace(pivot, spring=law, armature=pivot.armature + rotor)
            if "ACTUATION" in self.off or int(made.fields["opt.disableactuator"]) >> int(made.actuator_group[k]) & 1:
                self._lost(one.tag, one, "is switched off by the file: it drives nothing")
                words[k] = []
                continue
            if on_span:
                spans[target] = replace(spans[target], driven=True)
            else:
                driving.setdefault(self.pivots[target].name, []).append(k)
        for target, pivot in self.pivots.items():
            if rows := driving.get(pivot.name):
                ratio = gear[rows[0]] if pivot.kind == "revolute" and len(rows) == 1 and gear[rows[0]] > 0 else None
                for k in rows:
                    words[k] += ["gear"] * (gear[k] != 1 and ratio is None)
                self.pivots[target] = replace(pivot, drive=pivot.name, ratio=None if ratio == 1 else ratio)
        for k, some in words.items():
            if some:
                one = made.element("actuator", k)
                self._lost(f"{one.tag}: {', '.join(sorted(set(some)))}", one, CONTROL)

    def _words(self) -> dict[int, list[str]]:
        """Actuator -> its attributes that are listed."""
        made = self.made
        found: dict[int, list[str]] = {k: [] for k in range(int(made.nactuator))}
        for k, (word, _) in self._unusual("actuator_"):
            found[k].append(word)
        return found

    def _unusual(self, kind: str) -> Iterator[tuple[int, tuple[str, str]]]:
        """Elements of a kind whose listed fields are not at their defaults, with the attribute and the reason."""
        made = self.made
        for name, (word, default, why) in LISTED.items():
            if not name.startswith(kind) or name not in made.fields:
                continue
            values = made.fields[name]
            rows = np.atleast_2d(values) if kind == "opt." else values.reshape(len(values), values[:1].size)
            unusual = (rows != np.resize(np.array(default, float), rows.shape[1])).any(axis=1)
            owner = np.repeat(np.arange(made.nactuator), made.actuator_ctrlnum) if name == "actuator_ctrllimited" else None
            for row in np.flatnonzero(unusual):
                yield int(row if owner is None else owner[row]), (word, why)

    def _listed(self) -> None:
        """What a model does not have and the file sets."""
        made = self.made
        for kind, prefix in (("body", "body_"), ("joint", "jnt_"), ("equality", "eq_"), ("tendon", "tendon_")):
            for k, (word, why) in self._unusual(prefix):
                if self._matters(kind, k, word):
                    self._lost(word, made.element(kind, k), why)
        joints = {(int(made.dof_jntid[dof]), one): dof for dof, one in self._unusual("dof_")}
        for (joint, (word, why)), dof in joints.items():
            if not word.startswith("sol") or (made.dof_frictionloss[dof] and "FRICTIONLOSS" not in self.off):
                self._lost(word, made.element("joint", joint), why)
        for _, (word, why) in self._unusual("opt."):
            if word != "flag":
                self._lost(word, self._option(word), why)
        for k in range(int(made.nflex)):
            one = made.element("flex", k)
            self._lost(one.tag, one, "bodies are not deformed by the forces of MuJoCo; masses and places are carried")
        for flag in [*made.said["disableflags"], *made.said["enableflags"]]:
            word = flag.split("_")[-1]
            if word not in (*FLAGS["carried"], *FLAGS["without influence on motion"]):
                self._lost(f"flag {word.lower()}", self._option(word.lower()), "has no counterpart in a model")
        for name in made.said["unknown"]:
            self._lost(name, self.root, f"this field of MuJoCo {made.said['version']} is not known here")
        for one, name in made.former:
            self._lost(name, one, f"is not known to MuJoCo {made.said['version']}")
        self._touching()

    def _matters(self, kind: str, k: int, word: str) -> bool:
        """False for limits and friction of joints and tendons that flags switch off, and for conditions that are off."""
        if word == "range":
            return "LIMIT" not in self.off
        if kind == "equality":
            return bool(self.made.eq_active0[k]) and "EQUALITY" not in self.off
        if word.startswith("sol"):
            return bool(self.made.tendon_frictionloss[k]) and "FRICTIONLOSS" not in self.off
        return True

    def _option(self, word: str) -> Element:
        """The last element of the options that has an attribute; the whole file without."""
        found = [one for top in self.root.all("option") for one in (top, *top.children) if word in one.attributes]
        return found[-1] if found else self.root

    def _touching(self) -> None:
        """Contacts: said once, at the first shape of a body that can touch another by the rules of MuJoCo."""
        made = self.made
        if "CONTACT" in self.off:
            return
        own, can, weld = made.body_contype, made.body_conaffinity, made.body_weldid
        meets = (own[:, None] & can[None, :]) != 0
        meets |= meets.T
        meets &= weld[:, None] != weld[None, :]
        if "FILTERPARENT" not in self.off:
            above = weld[made.body_parentid[weld]]
            family = (above[:, None] == weld[None, :]) & (weld[None, :] != 0) & (weld[:, None] != 0)
            meets &= ~(family | family.T)
        for signature in made.exclude_signature.tolist():
            one, two = signature >> 16, signature & 0xFFFF
            meets[one, two] = meets[two, one] = False
        bodies = set(np.flatnonzero(meets.any(axis=0)).tolist())
        geoms = [k for k, body in enumerate(made.geom_bodyid.tolist()) if body in bodies]
        if geoms or made.npair:
            one = made.element("geom", geoms[0]) if geoms else next(self.root.all("contact"), self.root)
            self._lost("contact", one, "bodies that can touch do not push each other here; of such shapes this is the first")


def _properties(made: Compiled, body: int) -> MassProperties | None:
    """Mass, centre and inertia of a body in its frame."""
    mass = float(made.body_mass[body])
    if mass <= LEAST:
        return None
    R = quaternion_matrix(made.body_iquat[body])
    moments: NDArray[np.float64] = np.where(made.body_inertia[body] > LEAST, made.body_inertia[body], 0.0)
    return MassProperties(mass=mass, center=made.body_ipos[body], inertia=R @ np.diag(moments) @ R.T)


def _damped(one: Span, damping: float) -> Span:
    if not damping:
        return one
    stiffness, rest, own, friction = one.spring or (0.0, 0.0, 0.0, 0.0)
    return replace(one, spring=(stiffness, rest, own + damping, friction))
