"""Random robots in MJCF and in URDF, as their own formats describe them, and some odd ones that are valid."""

from __future__ import annotations

import copy
import sys
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pinocchio as pin
import yaml

sys.path.insert(0, str(Path(__file__).resolve().parent))

from robot_oracles import Beside, PinocchioOracle


@dataclass
class Made:
    """Files of a robot: the one to read, what is beside it, features that it uses, gears of hinges."""

    kind: str
    path: Path
    seed: int = 1
    features: Counter[str] = field(default_factory=Counter)
    gears: dict[str, float] = field(default_factory=dict)
    at: dict[str, float] = field(default_factory=dict)
    beside: Beside = field(default_factory=Beside)
    closures: Path | None = None
    floating: bool = False
    rows: list[tuple[str, str]] = field(default_factory=list)
    """Word and name of an element: what has to be listed."""


SOFT = ".5 .6 .1 .5 2"
ROWS: dict[str, tuple[str, str, dict[str, str]]] = {
    # field: what is listed, elements, attributes
    "jnt_limited": ("range", "joint", {"range": "-1.1 1.2", "limited": "true"}),
    "jnt_actfrclimited": ("actuatorfrcrange", "joint", {"actuatorfrcrange": "-3 3", "actuatorfrclimited": "true"}),
    "jnt_springyield": ("springyield", "joint", {"stiffness": "2", "springyield": "50"}),
    "jnt_stiffnesspoly": ("stiffness", "joint", {"stiffness": "1.2 0.5"}),
    "dof_dampingpoly": ("damping", "joint", {"damping": "0.2 0.05"}),
    "dof_solref": ("solreffriction", "joint", {"frictionloss": "0.1", "solreffriction": ".05 1"}),
    "dof_solimp": ("solimpfriction", "joint", {"frictionloss": "0.1", "solimpfriction": SOFT}),
    "eq_solref": ("solref", "connect weld", {"solref": ".05 1", "active": "true"}),
    "eq_solimp": ("solimp", "connect weld", {"solimp": SOFT, "active": "true"}),
    "tendon_limited": ("range", "spatial fixed", {"range": "-2 3", "limited": "true"}),
    "tendon_actfrclimited": (
        "actuatorfrcrange", "spatial fixed", {"actuatorfrcrange": "-3 3", "actuatorfrclimited": "true"},
    ),
    "tendon_armature": ("armature", "spatial fixed", {"armature": "0.2"}),
    "tendon_stiffnesspoly": ("stiffness", "spatial fixed", {"stiffness": "4 3"}),
    "tendon_dampingpoly": ("damping", "spatial fixed", {"damping": "0.3 0.2"}),
    "tendon_springyield": ("springyield", "spatial fixed", {"stiffness": "4", "springyield": "90"}),
    "tendon_solref_fri": ("solreffriction", "spatial fixed", {"frictionloss": "0.1", "solreffriction": ".05 1"}),
    "tendon_solimp_fri": ("solimpfriction", "spatial fixed", {"frictionloss": "0.1", "solimpfriction": SOFT}),
    "actuator_dyntype": ("dyntype", "general", {"dyntype": "filter"}),
    "actuator_dynprm": ("dynprm", "general", {"dyntype": "filter", "dynprm": "0.2"}),
    "actuator_gaintype": ("gaintype", "general", {"gaintype": "affine"}),
    "actuator_gainprm": ("gainprm", "general", {"gainprm": "2.5"}),
    "actuator_biastype": ("biastype", "general", {"biastype": "affine"}),
    "actuator_biasprm": ("biasprm", "general", {"biastype": "affine", "biasprm": "0 -1 -2"}),
    "actuator_ctrlspec": ("ctrlspec", "pid", {"kp": "2", "kv": "1"}),
    "actuator_ctrllimited": ("ctrlrange", "motor general", {"ctrllimited": "true", "ctrlrange": "-1 1"}),
    "actuator_actlimited": ("actrange", "general", {"dyntype": "integrator", "actlimited": "true", "actrange": "-1 1"}),
    "actuator_forcelimited": ("forcerange", "motor general", {"forcelimited": "true", "forcerange": "-1 1"}),
    "actuator_actearly": ("actearly", "general", {"dyntype": "filter", "actearly": "true"}),
    "actuator_delay": ("delay", "motor general", {"delay": "0.01", "nsample": "5"}),
    "actuator_dampingpoly": ("damping of higher order", "motor general", {"damping": "0.1 0.2"}),
}  # fmt: skip
"""Rows of the table that are listed, and are not drawn with the elements themselves."""
HARMLESS_FLAGS = (
    "clampctrl warmstart refsafe sensor midphase eulerdamp autoreset nativeccd island multiccd filterparent",
    "override energy fwdinv invdiscrete diagexact speculative",
)


def words(values: Any) -> str:
    """Numbers as a person writes them."""
    return " ".join(f"{float(one):.6g}" for one in np.atleast_1d(values))


def moments(rng: np.random.Generator, mass: float) -> np.ndarray:
    """(3, 3) an inertia that a body of this mass can have: the trace of second moments less themselves."""
    A = rng.uniform(-0.15, 0.15, (3, 3))
    second = mass * (A @ A.T + 1e-3 * np.eye(3))
    return np.trace(second) * np.eye(3) - second


class _Mjcf:
    """One robot while it is made."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng, self.features = rng, Counter[str]()
        self.root = ET.Element("mujoco", model="robot")
        self.gears: dict[str, float] = {}
        self.joints: dict[str, str] = {}
        """Name -> kind."""
        self.sites: list[str] = []
        self.count = 0

    def chance(self, share: float, feature: str = "") -> bool:
        """True now and then; the feature is counted."""
        yes = bool(self.rng.random() < share)
        if yes and feature:
            self.features[feature] += 1
        return yes

    def pick(self, *options: Any) -> Any:
        return options[int(self.rng.integers(len(options)))]

    def vector(self, reach: float, size: int = 3) -> str:
        return words(self.rng.uniform(-reach, reach, size))

    def angle(self, largest: float) -> float:
        """In the unit of the file."""
        return float(self.rng.uniform(-largest, largest)) * (180 / np.pi if self.degrees else 1.0)

    def made(self, size: int) -> None:
        self._settings()
        self._defaults()
        world = ET.SubElement(self.root, "worldbody")
        ET.SubElement(world, "site", name="s_w", pos=self.vector(0.5))
        self.bodies: list[ET.Element] = []
        for _ in range(size):
            self._body(world)
        if self.chance(0.06, "replicate of bodies"):
            self._replicated(world)
        self._sections()

    # settings -----------------------------------------------------------------------------------------------------------

    def _settings(self) -> None:
        given: dict[str, str] = {}
        self.degrees = not self.chance(0.5, "angle radian")
        if not self.degrees:
            given["angle"] = "radian"
        elif self.chance(0.5):
            given["angle"] = "degree"
        if self.chance(0.4, "eulerseq"):
            given["eulerseq"] = self.pick("xyz", "zyx", "XYZ", "ZXZ", "yXz", "zxY")
        self.from_geoms = "auto"
        if self.chance(0.3, "inertiafromgeom"):
            self.from_geoms = given["inertiafromgeom"] = self.pick("true", "false", "auto")
        for word, share, value in (
            ("balanceinertia", 0.15, "true"),
            ("boundmass", 0.1, "0.4"),
            ("boundinertia", 0.1, "0.004"),
            ("settotalmass", 0.12, "7"),
            ("autolimits", 0.15, "false"),
            ("fusestatic", 0.1, "true"),
            ("discardvisual", 0.1, "true"),
            ("alignfree", 0.1, "true"),
            ("inertiagrouprange", 0.1, "0 2"),
            ("strippath", 0.05, "true"),
        ):
            if self.chance(share, word):
                given[word] = value
        if "inertiagrouprange" in given and self.from_geoms == "true":
            del given["inertiagrouprange"]
        self.grouped = "inertiagrouprange" in given
        if given:
            ET.SubElement(self.root, "compiler", given)
        option = ET.SubElement(self.root, "option")
        if self.chance(0.7, "gravity"):
            option.set("gravity", self.pick("0 0 0", "0 0 -1.62", self.vector(10.0)))
        flags = {
            word: "disable"
            for word in (
                "gravity",
                "spring",
                "damper",
                "equality",
                "actuation",
                "frictionloss",
                "limit",
                "contact",
                "constraint",
            )
            if self.chance(0.07, f"flag {word}")
        }
        if flags:
            ET.SubElement(option, "flag", flags)
        if self.chance(0.1, "two options"):
            ET.SubElement(ET.SubElement(self.root, "option", timestep="0.001"), "flag", {"spring": "disable"})
        for word, value in (("density", "1.2"), ("viscosity", "2e-3"), ("wind", "3 -1 0.5")):
            if self.chance(0.05, word):
                option.set(word, value)

    def _defaults(self) -> None:
        top = ET.SubElement(self.root, "default")
        if self.chance(0.5, "default of geoms"):
            ET.SubElement(top, "geom", density="700")
        if self.chance(0.3, "default of joints"):
            ET.SubElement(top, "joint", damping="0.02", armature="0.004")
        if self.chance(0.3, "default of tendons"):
            ET.SubElement(top, "tendon", damping="0.3")
        if self.chance(0.3, "default of motors"):
            ET.SubElement(top, "motor", gear=self.pick("3", "-2", "7"), ctrlrange="-1 1")
        if self.chance(0.2, "default of equalities"):
            ET.SubElement(top, "equality", solref="0.01 1")
        heavy = ET.SubElement(top, "default", {"class": "heavy"})
        ET.SubElement(heavy, "geom", density="2500")
        ET.SubElement(heavy, "joint", stiffness="1.5", springref=words(self.angle(0.3)))
        ET.SubElement(heavy, "site", type="capsule", size="0.01", fromto="0.1 0 -0.1 0.1 0.3 0.2")
        deeper = ET.SubElement(heavy, "default", {"class": "deeper"})
        ET.SubElement(deeper, "joint", damping="0.2", frictionloss="0.05")
        ET.SubElement(deeper, "geom", type="box", size="0.05 0.08 0.1")
        light = ET.SubElement(top, "default", {"class": "light"})
        ET.SubElement(light, "geom", mass="0.3")
        ET.SubElement(light, "joint", axis="1 0.5 0", armature="0.01")
        if self.chance(0.15, "springdamper by class"):
            ET.SubElement(ET.SubElement(top, "default", {"class": "tuned"}), "joint", springdamper="0.8 0.4")

    def _class(self, share: float) -> dict[str, str]:
        names = [one.get("class", "") for one in self.root.iter("default") if one.get("class")]
        return {"class": str(self.pick(*names))} if self.chance(share, "class") else {}

    # bodies -------------------------------------------------------------------------------------------------------------

    def _pose(self, reach: float, share: float = 0.8) -> dict[str, str]:
        """Place and orientation in one of the forms."""
        given = {"pos": self.vector(reach)} if self.chance(0.9) else {}
        if self.chance(share):
            form = self.pick("quat", "euler", "axisangle", "xyaxes", "zaxis")
            self.features[form] += 1
            given[form] = {
                "quat": lambda: self.vector(1.0, 4),
                "euler": lambda: words([self.angle(1.5) for _ in range(3)]),
                "axisangle": lambda: f"{self.vector(1.0)} {words(self.angle(3.0))}",
                "xyaxes": lambda: self.vector(1.0, 6),
                "zaxis": lambda: self.vector(1.0),
            }[form]()
        return given

    def _inside(self, parent: ET.Element, share: float = 0.2, depth: int = 0) -> ET.Element:
        """The element itself, or a frame in it."""
        if depth > 2 or not self.chance(share, "frame" if not depth else "frame in a frame"):
            return parent
        given = self._pose(0.2)
        if self.chance(0.2, "frame with childclass"):
            given["childclass"] = self.pick("heavy", "light", "deeper")
        frame = ET.SubElement(parent, "frame", given)
        if self.chance(0.3):
            frame.set("name", f"f{self._number()}")
        return self._inside(frame, share, depth + 1)

    def _number(self) -> int:
        self.count += 1
        return self.count

    def _body(self, world: ET.Element) -> None:
        parent = world if not self.bodies or self.chance(0.25) else self.pick(*self.bodies)
        number = self._number()
        body = ET.SubElement(self._inside(parent), "body", {"name": f"b{number}", **self._pose(0.35)})
        if self.chance(0.2, "childclass"):
            body.set("childclass", self.pick("heavy", "light", "deeper"))
        if self.chance(0.04, "gravcomp"):
            body.set("gravcomp", self.pick("1", "0.6"))
        kinds: list[str]
        if parent is world and self.chance(0.12, "free body"):
            kinds = ["free"]
        elif self.chance(0.12, "ball"):
            kinds = ["slide", "ball"] if self.chance(0.2, "slide, ball") else ["ball"]
        elif self.chance(0.1, "welded body"):
            kinds = []
        else:
            kinds = [self.pick("hinge", "hinge", "hinge", "slide") for _ in range(self.pick(1, 1, 1, 1, 2, 2, 3))]
            self.features[", ".join(kinds)] += 1
        self._content(body, number, kinds)
        self.bodies.append(body)

    def _content(self, body: ET.Element, number: int, kinds: Sequence[str]) -> None:
        same = self.vector(0.1) if self.chance(0.5) else None
        for k, kind in enumerate(kinds):
            self._joint(body, f"j{number}_{k}", kind, same)
        mass = not kinds and self.chance(0.3, "body without mass")
        if not mass:
            geoms = self.from_geoms == "true" or (self.from_geoms == "auto" and self.chance(0.6))
            if not geoms:
                self._inertial(body)
            if geoms or self.chance(0.3, "geoms beside an inertial"):
                for _ in range(self.pick(1, 1, 2, 3)):
                    self._geom(body)
        for _ in range(self.pick(0, 0, 1)):
            self._site(body)

    def _joint(self, body: ET.Element, name: str, kind: str, same: str | None) -> None:
        self.joints[name] = kind
        where = self._inside(body, 0.12)
        if where is not body:
            self.features["joint in a frame"] += 1
        if kind == "free":
            where = body
            if self.chance(0.5, "freejoint"):
                ET.SubElement(where, "freejoint", name=name)
                return
        given = {"name": name, **({} if kind == "free" else self._class(0.2))}
        if kind != "hinge" or self.chance(0.5):
            given["type"] = kind
        if kind != "free" and (same or self.chance(0.6, "joint with a place")):
            given["pos"] = same or self.vector(0.1)
        if kind in ("hinge", "slide") and self.chance(0.85):
            given["axis"] = self.vector(2.0)
        turn = kind == "hinge"
        if kind in ("hinge", "slide"):
            if self.chance(0.3, "ref"):
                given["ref"] = words(self.angle(0.4) if turn else self.rng.uniform(-0.1, 0.1))
            if self.chance(0.25, "springref"):
                given["springref"] = words(self.angle(0.4) if turn else self.rng.uniform(-0.1, 0.1))
            if self.chance(0.2, "range"):
                given["range"] = words(np.array([-1.5, 1.2]) * (180 / np.pi if turn and self.degrees else 1.0))
                given["limited"] = "true"
            if self.chance(0.12, "springdamper"):
                given["springdamper"] = words(self.rng.uniform(0.2, 2.0, 2))
        share = 0.3 if kind in ("hinge", "slide") else 0.08
        of = "" if kind in ("hinge", "slide") else f" of {kind}"
        for word, largest in (("stiffness", 5.0), ("damping", 0.5), ("armature", 0.2), ("frictionloss", 0.3)):
            if self.chance(share if word != "frictionloss" else 0.5 * share, word + of):
                given[word] = words(self.rng.uniform(0.1, 1.0) * largest)
        if self.chance(0.04, "law of several numbers"):
            given[self.pick("stiffness", "damping")] = "1.2 0.5"
        ET.SubElement(where, "joint", given)

    def _inertial(self, body: ET.Element) -> None:
        mass = float(self.rng.uniform(0.2, 3.0))
        where = self._inside(body, 0.1)
        if where is not body:
            self.features["inertial in a frame"] += 1
        inertia = moments(self.rng, mass)
        given = {"mass": words(mass), "pos": self.vector(0.15)}
        if self.chance(0.4, "fullinertia"):
            given["fullinertia"] = words([*np.diag(inertia), inertia[0, 1], inertia[0, 2], inertia[1, 2]])
        else:
            given |= {word: text for word, text in self._pose(0.1).items() if word != "pos"}
            given["diaginertia"] = words(np.linalg.eigvalsh(inertia))
            self.features["diaginertia"] += 1
        ET.SubElement(where, "inertial", given)

    def _geom(self, body: ET.Element) -> None:
        where = self._inside(body, 0.15)
        kind = self.pick("sphere", "capsule", "cylinder", "box", "ellipsoid")
        given = {"type": kind, **self._class(0.3)}
        sizes = self.rng.uniform(0.02, 0.12, 3)
        if kind not in ("sphere",) and self.chance(0.4, f"{kind} fromto"):
            ends = self.rng.uniform(-0.3, 0.3, 6)
            given |= {"fromto": words(ends), "size": words(sizes[: 1 if kind in ("capsule", "cylinder") else 2])}
        else:
            given |= self._pose(0.2)
            given["size"] = words(sizes[: {"sphere": 1, "capsule": 2, "cylinder": 2}.get(kind, 3)])
        self.features[kind] += 1
        if self.chance(0.3, "mass of a geom"):
            given["mass"] = words(self.rng.uniform(0.1, 2.0))
        elif self.chance(0.3, "density of a geom"):
            given["density"] = words(self.rng.uniform(200, 3000))
        if self.chance(0.15, "shellinertia") and "class" not in given:
            given["shellinertia"] = "true"
        if self.grouped:
            given["group"] = self.pick("0", "2", "4")
        if self.chance(0.06, "replicate of geoms"):
            where = ET.SubElement(
                where, "replicate", count=self.pick("2", "3"), euler=f"0 0 {words(self.angle(1.0))}", offset="0.02 0 0.03"
            )
        ET.SubElement(where, "geom", given)
        if self.grouped:
            ET.SubElement(where, "geom", type="sphere", size="0.04", group="1", pos=self.vector(0.1))

    def _site(self, body: ET.Element) -> str:
        where = self._inside(body, 0.2)
        name = f"s{self._number()}"
        given = {"name": name}
        if self.chance(0.3, "site fromto"):
            given |= {"type": "capsule", "size": "0.01", "fromto": words(self.rng.uniform(-0.3, 0.3, 6))}
        elif self.chance(0.15, "site of a class"):
            given |= {"class": "heavy"}
        else:
            given |= self._pose(0.25)
        ET.SubElement(where, "site", given)
        self.sites.append(name)
        return name

    def _replicated(self, world: ET.Element) -> None:
        number = self._number()
        several = ET.SubElement(
            world, "replicate", count=self.pick("2", "3"), euler=f"0 0 {words(self.angle(1.5))}", offset="0.1 0.6 0"
        )
        body = ET.SubElement(several, "body", {"name": f"b{number}_", **self._pose(0.4)})
        ET.SubElement(body, "joint", name=f"j{number}_", axis=self.vector(1.0), damping="0.1")
        ET.SubElement(body, "inertial", mass="0.7", pos="0.1 0.02 0", diaginertia="0.003 0.004 0.005")

    # what is beside the tree --------------------------------------------------------------------------------------------

    def text(self) -> str:
        tree = copy.deepcopy(self.root)
        ET.indent(tree, " ")
        return ET.tostring(tree, encoding="unicode")

    def _sections(self) -> None:
        self._loops()
        self._tendons()
        self._coupled_tendons()
        self._motors()
        self._rows()
        if self.chance(0.1, "sensors"):
            ET.SubElement(ET.SubElement(self.root, "sensor"), "clock", name="time")
        if self.chance(0.1, "contacts") and len(self.bodies) > 1:
            ET.SubElement(
                ET.SubElement(self.root, "contact"),
                "exclude",
                body1=self.bodies[0].get("name", ""),
                body2=self.bodies[1].get("name", ""),
            )
        if self.chance(0.1, "cameras and lights"):
            ET.SubElement(self.bodies[0], "camera", pos="0 0 1")
            ET.SubElement(self.bodies[0], "light", pos="0 0 1")

    def _rows(self) -> None:
        """Some attributes that have to be listed, each at an element by itself."""
        self.rows: list[tuple[str, str]] = []
        off = {word for one in self.root.iter("flag") for word, value in one.items() if value == "disable"}
        quiet = bool({"limit", "frictionloss", "equality", "constraint", "actuation"} & off)
        for word, value in zip(HARMLESS_FLAGS, ("disable", "enable"), strict=True):
            if self.chance(0.2, f"harmless flag, {value}"):
                ET.SubElement(ET.SubElement(self.root, "option"), "flag", {self.pick(*word.split()): value})
        used: set[str] = set()
        for name, (word, tags, given) in ROWS.items():
            if quiet or not self.chance(0.08):
                continue
            parents = {"joint": "worldbody", "connect": "equality", "spatial": "tendon"}.get(tags.split()[0], "actuator")
            found = [one for top in self.root.findall(parents) for tag in tags.split() for one in top.iter(tag)]
            found = [one for one in found if one.get("type", "hinge") in ("hinge", "slide") and one.get("name") not in used]
            if parents == "actuator":
                found = [one for one in self._spare(tags.split()[-1]) if one.get("name") not in used]
            if found and (one := self.pick(*found)).get("name"):
                one.attrib |= given
                used.add(one.get("name", ""))
                self.rows.append((word, one.get("name", "")))
                self.features[f"row {name}"] += 1
        if self.chance(0.06, "row body_mocapid"):
            at = self.root.find("worldbody")
            ET.SubElement(at, "body", name="held", mocap="true", pos=self.vector(0.5))
            self.rows.append(("mocap", "held"))
        if self.chance(0.04, "row opt.enableflags") and self.root.find("tendon") is None:
            ET.SubElement(ET.SubElement(self.root, "option"), "flag", sleep="enable")
            self.rows.append(("flag sleep", ""))

    def _spare(self, tag: str) -> list[ET.Element]:
        """A further actuator of a hinge or slide that has one by a default."""
        driven = {str(one.get("joint")) for top in self.root.findall("actuator") for one in top}
        left = [name for name, kind in self.joints.items() if kind in ("hinge", "slide") and name not in driven]
        if not left:
            return []
        group = self.root.find("actuator")
        joint = self.pick(*left)
        return [
            ET.SubElement(ET.SubElement(self.root, "actuator") if group is None else group, tag, name=f"m_{joint}", joint=joint)
        ]

    def _loops(self) -> None:
        """Conditions that close where the robot is drawn, as far as they are independent."""
        single = [name for name, kind in self.joints.items() if kind in ("hinge", "slide")]
        model = mujoco.MjModel.from_xml_string(self.text())
        there = {model.body(k).name for k in range(model.nbody)}  # without those that are fused
        names = [name for one in self.bodies if (name := one.get("name", "")) in there]
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        group = ET.Element("equality")
        rows = np.zeros((0, model.nv))
        wanted = self.pick(0, 0, 0, 1, 1, 2)
        for _ in range(4 * wanted):
            if len(group) >= wanted:
                break
            kind = self.pick("connect", "connect", "weld", "joint")
            name = f"e{self._number()}"
            active = {"active": "false"} if self.chance(0.1, "active false") else {}
            if kind == "joint":
                if len(single) < 2:
                    continue
                one, two = (str(x) for x in self.rng.choice(single, 2, replace=False))
                row = np.zeros((1, model.nv))
                row[0, model.jnt_dofadr[model.joint(one).id]], row[0, model.jnt_dofadr[model.joint(two).id]] = 1.0, -1.5
                polynomial = "0 1.5 0.2 0 0" if self.chance(0.08, "coupling of second order") else "0 1.5 0 0 0"
                element = ET.Element(kind, name=name, joint1=one, joint2=two, polycoef=polynomial, **active)
            else:
                if len(names) < 2:
                    continue
                one, two = (str(x) for x in self.rng.choice([*names, "world"] if self.chance(0.3) else names, 2, replace=False))
                a, b = (model.body(x).id for x in (one, two))
                local = self.rng.uniform(-0.3, 0.3, 3)
                point = data.xpos[a] + data.xmat[a].reshape(3, 3) @ local
                Ja, Jb = np.zeros((6, model.nv)), np.zeros((6, model.nv))
                mujoco.mj_jac(model, data, Ja[:3], Ja[3:], point, a)
                mujoco.mj_jac(model, data, Jb[:3], Jb[3:], point, b)
                row = (Ja - Jb)[: 3 if kind == "connect" else 6]
                element = ET.Element(kind, name=name, **active)
                if self.chance(0.35, f"{kind} by sites") and "world" not in (one, two):
                    self._at_site(element, (one, two), (a, b), model, data, point)
                elif kind == "connect":
                    element.set("body1", one)
                    element.set("anchor", words(local))
                    if two != "world" or self.chance(0.5):
                        element.set("body2", two)
                else:
                    element.set("body1", one)
                    if two != "world" or self.chance(0.5):
                        element.set("body2", two)
            if not active:
                both = np.vstack([rows, row])
                values = np.linalg.svd(both, compute_uv=False)
                if len(both) >= model.nv or values[len(both) - 1] < 0.03 * values[0]:
                    continue
                rows = both
            self.features[kind] += 1
            group.append(element)
        if len(group):
            self.root.append(group)
        self.held = rows

    def _at_site(self, element: ET.Element, names: Any, bodies: Any, model: Any, data: Any, point: Any) -> None:
        """Two sites at one place, with one orientation, at the end of two bodies."""
        for k, (name, body) in enumerate(zip(names, bodies, strict=True)):
            R = data.xmat[body].reshape(3, 3)
            turn = np.zeros(4)
            mujoco.mju_mat2Quat(turn, np.ascontiguousarray(R.T).ravel())
            own = next(one for one in self.bodies if one.get("name") == name)
            site = f"s{self._number()}"
            at = " ".join(repr(float(x)) for x in R.T @ (point - data.xpos[body]))
            ET.SubElement(own, "site", name=site, pos=at, quat=" ".join(repr(float(x)) for x in turn))
            element.set(f"site{k + 1}", site)

    def _tendons(self) -> None:
        group = ET.Element("tendon")
        single = [name for name, kind in self.joints.items() if kind in ("hinge", "slide")]
        self.tendons: list[str] = []
        for _ in range(self.pick(0, 0, 0, 1, 2)):
            laws: dict[str, str] = {}
            for word, largest, share in (
                ("stiffness", 40.0, 0.6),
                ("damping", 3.0, 0.4),
                ("frictionloss", 0.5, 0.15),
                ("armature", 0.5, 0.06),
            ):
                if self.chance(share, f"{word} of a tendon"):
                    laws[word] = words(self.rng.uniform(0.2, 1.0) * largest)
            if self.chance(0.4, "springlength"):
                laws["springlength"] = words(self.rng.uniform(0.05, 0.8))
            elif self.chance(0.05, "springlength with a slack"):
                laws["springlength"] = "0.1 0.3"
            name = f"t{self._number()}"
            if self.sites and self.chance(0.75, "spatial tendon"):
                ends = [str(x) for x in self.rng.permutation(["s_w", *self.sites])]
                count = 3 if len(ends) > 2 and self.chance(0.1, "tendon over three sites") else 2
                one = ET.SubElement(group, "spatial", name=name, **laws)
                for site in ends[:count]:
                    ET.SubElement(one, "site", site=site)
                self.tendons += [name] * (count == 2)
            elif single:
                one = ET.SubElement(group, "fixed", name=name, **laws)
                self.features["fixed tendon"] += 1
                for joint in self.rng.permutation(single)[: self.pick(1, 2, 2, 3)]:
                    ET.SubElement(one, "joint", joint=str(joint), coef=words(self.rng.uniform(-2, 2)))
        if len(group):
            self.root.append(group)

    def _coupled_tendons(self) -> None:
        """Two fixed tendons whose lengths follow each other; or one whose length stays."""
        single = [str(one) for one in self.rng.permutation([k for k, v in self.joints.items() if v in ("hinge", "slide")])]
        if len(single) < 2 or not self.chance(0.15):
            return
        model = mujoco.MjModel.from_xml_string(self.text())
        row, tendons = np.zeros((1, model.nv)), ET.Element("tendon")
        ends = (single[:1], single[1:3]) if len(single) > 2 and self.chance(0.7) else (single[:2],)
        condition = ET.Element("tendon", name=f"e{self._number()}", polycoef="0 0.8 0 0 0")
        for k, joints in enumerate(ends):
            name = f"t{self._number()}"
            condition.set(f"tendon{k + 1}", name)
            one = ET.SubElement(tendons, "fixed", name=name)
            for joint in joints:
                coef = float(words(self.rng.uniform(0.5, 2)))
                ET.SubElement(one, "joint", joint=joint, coef=words(coef))
                row[0, model.jnt_dofadr[model.joint(joint).id]] += coef if k == 0 else -0.8 * coef
        both = np.vstack([self.held, row])
        values = np.linalg.svd(both, compute_uv=False)
        if len(both) >= model.nv or values[len(both) - 1] < 0.03 * values[0]:
            return
        self.features[f"coupling of {len(ends)} tendons"] += 1
        self.root.append(tendons)
        ET.SubElement(self.root, "equality").append(condition)

    def _motors(self) -> None:
        group = ET.Element("actuator")
        for joint, kind in self.joints.items():
            if kind not in ("hinge", "slide") or not self.chance(0.6):
                continue
            given = {"joint": joint}
            if self.chance(0.7):
                given["name"] = f"m_{joint}"
            if self.chance(0.4, f"gear of a {kind}"):
                given["gear"] = self.pick("20", "0.5", "-3", "12 0 0")
            servo = self.chance(0.06, "position servo")
            if servo:
                given |= {"name": f"m_{joint}", "kp": "4"}
            else:
                for word, value in (("armature", "0.05"), ("damping", "0.1")):
                    if self.chance(0.03, f"{word} of a motor"):
                        given |= {"name": f"m_{joint}", word: value}
            ET.SubElement(group, "position" if servo else "motor", given)
        for tendon in self.tendons:
            if self.chance(0.4, "motor of a tendon"):
                ET.SubElement(group, "motor", name=f"m_{tendon}", tendon=tendon)
        if len(group):
            self.root.append(group)

    def files(self, folder: Path) -> Path:
        """The text, parts of it in files of their own."""
        tree = copy.deepcopy(self.root)
        if self.chance(0.2, "include"):
            for k, tag in enumerate(("default", "actuator", "body", "body")):
                found = [
                    (parent, one) for parent in tree.iter() for one in parent if one.tag == tag and parent.tag != "default"
                ]
                if not found or self.chance(0.3):
                    continue
                parent, one = found[int(self.rng.integers(len(found)))]
                if any(inner.tag == "include" for inner in one.iter()):
                    self.features["include in an include"] += 1
                index = list(parent).index(one)
                parent.remove(one)
                parent.insert(index, ET.Element("include", file=f"part{k}.xml"))
                outer = ET.Element(self.pick("mujocoinclude", "mujoco") if k else "mujocoinclude")
                outer.append(one)
                ET.indent(outer, " ")
                (folder / f"part{k}.xml").write_text(ET.tostring(outer, encoding="unicode"))
        ET.indent(tree, " ")
        path = folder / "robot.xml"
        path.write_text(ET.tostring(tree, encoding="unicode"))
        return path


def mjcf(rng: np.random.Generator, folder: Path, seed: int) -> Made:
    """A random robot that MuJoCo loads; what it refuses is drawn again."""
    while True:
        one = _Mjcf(rng)
        try:
            one.made(int(rng.integers(1, 7)))
            path = one.files(folder)
            model = mujoco.MjModel.from_xml_path(str(path))
        except ValueError as error:
            rejected(str(error))
            continue
        if not model.nv or _loose(model):
            continue
        gears = {
            model.joint(model.actuator_trnid[a, 0]).name: float(model.actuator_gear[model.actuator_outadr[a], 0])
            for a in range(model.nactuator)
            if model.actuator_trntype[a] == 0 and model.jnt_type[model.actuator_trnid[a, 0]] == 3
        }
        at: dict[str, float] = {}
        if rng.random() < 0.25 and not model.neq:
            one.features["--at"] += 1
            at = {
                name: float(rng.uniform(-0.8, 0.8) if kind == "hinge" else rng.uniform(-0.1, 0.1))
                for name, kind in one.joints.items()
                if kind in ("hinge", "slide") and rng.random() < 0.5
            }
        return Made(kind="mjcf", path=path, seed=seed, features=one.features, gears=gears, at=at, rows=one.rows)


def _loose(model: Any) -> bool:
    """True if a freedom moves next to nothing but rotors, as of two hinges of one body about one axis.

    The places of the bodies do not say then where the joints are.
    """
    data, M = mujoco.MjData(model), np.zeros((model.nv, model.nv))
    model.dof_armature[:] = model.tendon_armature[:] = model.actuator_armature[:] = 0
    model.dof_simplenum[:] = model.body_simple[:] = 0
    mujoco.mj_fwdPosition(model, data)
    mujoco.mj_fullM(model, data, M)
    return bool(np.linalg.cond(M) > 1e7)


REJECTED = Counter[str]()
"""What MuJoCo said of drafts that it refused."""


def rejected(text: str) -> None:
    REJECTED[text.split("\n")[0][:90]] += 1


# -------------------------------------------------------------------------------------------------------------------- URDF


class _Urdf:
    """One robot while it is made."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng, self.features = rng, Counter[str]()
        self.root = ET.Element("robot", name="robot")
        self.beside = Beside()
        self.joints: dict[str, str] = {}
        self.links: list[str] = []
        self.table: dict[str, Any] = {}

    chance = _Mjcf.chance
    pick = _Mjcf.pick
    vector = _Mjcf.vector

    def made(self, size: int, floating: bool) -> None:
        self._link("l0", floating)
        while len(self.links) < size + 1:
            self._joint()
        self._mimics()
        self._loops()
        elements = list(self.root)
        if self.chance(0.3, "elements in any order"):
            self.root[:] = [elements[k] for k in self.rng.permutation(len(elements))]
        self.beside.motors = [
            name
            for name, kind in self.joints.items()
            if kind in ("revolute", "continuous", "prismatic") and name not in [one[0] for one in self.beside.mimics]
        ]

    def _link(self, name: str, heavy: bool) -> ET.Element:
        link = ET.SubElement(self.root, "link", name=name)
        self.links.append(name)
        if heavy:
            mass = float(self.rng.uniform(0.2, 3.0))
            inertia = moments(self.rng, mass)
            own = ET.SubElement(link, "inertial")
            if self.chance(0.85):
                ET.SubElement(
                    own,
                    "origin",
                    xyz=self.vector(0.15),
                    **({"rpy": self.vector(1.0)} if self.chance(0.6, "rpy of an inertial") else {}),
                )
            ET.SubElement(own, "mass", value=words(mass))
            six = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
            ET.SubElement(own, "inertia", {word: words(inertia[at]) for word, at in six.items()})
        if self.chance(0.15, "visual"):
            shape = ET.SubElement(ET.SubElement(link, "visual"), "geometry")
            ET.SubElement(shape, "sphere", radius="0.1")
        return link

    def _joint(self, kind: str | None = None, parent: str | None = None, heavy: bool | None = None) -> str:
        number = len(self.links)
        kind = kind or self.pick("revolute", "revolute", "continuous", "prismatic", "fixed", "revolute")
        parent = parent or (self.links[-1] if self.chance(0.7) else self.pick(*self.links))
        self.features[kind] += 1
        name = f"j{number}"
        joint = ET.SubElement(self.root, "joint", name=name, type=kind)
        ET.SubElement(joint, "parent", link=parent)
        ET.SubElement(joint, "child", link=f"l{number}")
        if self.chance(0.85):
            ET.SubElement(
                joint, "origin", xyz=self.vector(0.4), **({"rpy": self.vector(1.5)} if self.chance(0.6, "rpy") else {})
            )
        if kind not in ("fixed", "floating"):
            if self.chance(0.85):
                ET.SubElement(joint, "axis", xyz=self.vector(2.0))
            if kind != "continuous":
                ET.SubElement(joint, "limit", lower="-1", upper="1", effort="10", velocity="3")
            law = [
                round(float(self.rng.uniform(0.05, 0.5)), 3) if self.chance(0.25, word) else 0.0
                for word in ("damping", "friction")
            ]
            if any(law):
                given = {word: repr(x) for word, x in zip(("damping", "friction"), law, strict=True) if x}
                ET.SubElement(joint, "dynamics", given)
                self.beside.laws[name] = (law[0], law[1])
        self.joints[name] = kind
        bare = heavy is False or (heavy is None and kind != "fixed" and self.chance(0.12, "link without mass"))
        self._link(f"l{number}", not bare and (kind != "fixed" or heavy is True or self.chance(0.6)))
        if bare and heavy is None:
            self._joint(self.pick("revolute", "prismatic"), f"l{number}", True)
        return name

    def _mimics(self) -> None:
        single = [name for name, kind in self.joints.items() if kind in ("revolute", "continuous", "prismatic")]
        if len(single) < 2 or not self.chance(0.25, "mimic"):
            return
        one, two = (str(x) for x in self.rng.choice(single, 2, replace=False))
        factor = round(float(self.rng.uniform(-2, 2)), 3)
        offset = round(float(self.rng.uniform(-0.2, 0.2)), 3) if self.chance(0.4, "mimic with an offset") else 0.0
        joint = next(j for j in self.root.iter("joint") if j.get("name") == one)
        ET.SubElement(joint, "mimic", joint=two, multiplier=repr(factor), offset=repr(offset))
        self.beside.mimics.append((one, two, factor, offset))
        if offset:  # the pose in which the mimic holds is found by frames
            for link in list(self.links):
                for k, at in enumerate(("0.1 0 0", "0 0.1 0", "0 0 0.1")):
                    self._fixed(link, f"{link}_at{k}", {"xyz": at})

    def _fixed(self, link: str, name: str, origin: dict[str, str]) -> None:
        """A named frame of a link."""
        joint = ET.SubElement(self.root, "joint", name=f"{name}_joint", type="fixed")
        ET.SubElement(joint, "parent", link=link)
        ET.SubElement(joint, "child", link=name)
        ET.SubElement(joint, "origin", origin)
        ET.SubElement(self.root, "link", name=name)

    def _loops(self) -> None:
        """Pairs of frames that meet where the robot is drawn, if their conditions are independent."""
        wanted = self.pick(0, 0, 1, 1, 2) if not any(one[3] for one in self.beside.mimics) else 0
        pairs, types = [], []
        for _ in range(5 * wanted):
            if len(pairs) >= wanted:
                break
            model = pin.buildModelFromXML(ET.tostring(self.root, encoding="unicode"))
            if model.nv < 4:  # without freedoms Pinocchio ends the process
                break
            data = model.createData()
            pin.framesForwardKinematics(model, data, pin.neutral(model))
            pin.computeJointJacobians(model, data, pin.neutral(model))
            a, b = (str(x) for x in self.rng.choice(self.links, 2, replace=False))
            A, B = (data.oMf[model.getFrameId(x, pin.BODY)] for x in (a, b))
            place = pin.SE3(pin.rpy.rpyToMatrix(self.rng.uniform(-1, 1, 3)), A.act(self.rng.uniform(-0.3, 0.3, 3)))
            size = self.pick(3, 3, 3, 6)
            row = []
            for name, at in ((a, A), (b, B)):
                J = pin.getFrameJacobian(model, data, model.getFrameId(name, pin.BODY), pin.LOCAL_WORLD_ALIGNED)
                J[:3] += np.cross(J[3:].T, place.translation - at.translation).T
                row.append(J)
            rows = (row[0] - row[1])[:size]
            values = np.linalg.svd(rows, compute_uv=False)
            if len(rows) >= model.nv or values[-1] < 0.03 * values[0] or pairs:
                continue
            tips = []
            for name, at in ((a, A), (b, B)):
                tip = f"tip_{name}_{len(self.links)}"
                relative = at.inverse() * place
                exact = {"xyz": relative.translation, "rpy": pin.rpy.matrixToRpy(relative.rotation)}
                self._fixed(name, tip, {word: " ".join(repr(float(x)) for x in given) for word, given in exact.items()})
                tips.append(tip)
            pairs.append(tips)
            types.append(f"{size}d")
            self.features[f"closure {size}d"] += 1
            self.beside.closures.append((tips[0], tips[1], size))
        if pairs:
            self.table |= {"closed_loop": pairs, "type": types}


def urdf(rng: np.random.Generator, folder: Path, seed: int) -> Made:
    """A random robot that Pinocchio loads."""
    while True:
        one = _Urdf(rng)
        floating = one.chance(0.15, "floating base")
        one.made(int(rng.integers(1, 8)), floating)
        if not one.beside.motors:
            continue
        retyped = [
            name
            for name, kind in one.joints.items()
            if kind in ("revolute", "continuous")
            and name not in one.beside.laws
            and all(name not in mimic[:2] for mimic in one.beside.mimics)
        ]
        if retyped and not one.beside.closures and one.chance(0.12, "types of joints in the YAML file"):
            name, kind = str(one.pick(*retyped)), one.pick("SPHERICAL", "FIXED")
            one.table |= {"joint_name": [name], "joint_type": [kind]}
            one.beside.balls, one.beside.stiff = ([name], []) if kind == "SPHERICAL" else ([], [name])
        if one.table:
            rest = [name for name in one.beside.motors if name not in (*one.beside.balls, *one.beside.stiff)]
            one.beside.motors = [name for name in rest if rng.random() < 0.6]
            one.table["name_mot"] = one.beside.motors
        path, closures = folder / "robot.urdf", folder / "robot.yaml"
        tree = copy.deepcopy(one.root)
        ET.indent(tree, " ")
        path.write_text(ET.tostring(tree, encoding="unicode"))
        if one.table:
            closures.write_text(yaml.safe_dump(one.table))
        if PinocchioOracle(path, copy.deepcopy(one.beside), floating).nv == 0:
            continue
        at: dict[str, float] = {}
        if not one.beside.closures and not one.beside.mimics and one.chance(0.25, "--at"):
            at = {name: float(rng.uniform(-0.8, 0.8)) for name in one.beside.motors if rng.random() < 0.5}
        return Made(
            kind="urdf",
            path=path,
            seed=seed,
            features=one.features,
            beside=one.beside,
            at=at,
            closures=closures if one.table else None,
            floating=floating,
        )


# ----------------------------------------------------------------------------------------------------- odd ones that are valid

INERTIAL = '<inertial pos="{at}" mass="1.3" diaginertia="0.011 0.013 0.017"/>'


def _of_text(kind: str, text: str, feature: str, **beside: Any) -> Callable[[Path], Made]:
    def written(folder: Path) -> Made:
        path = folder / ("robot.xml" if kind == "mjcf" else "robot.urdf")
        path.write_text(text)
        return Made(kind=kind, path=path, features=Counter([feature]), beside=Beside(**copy.deepcopy(beside)))

    return written


def _mjcf_of(bodies: str, feature: str, more: str = "") -> Callable[[Path], Made]:
    return _of_text(
        "mjcf", f'<mujoco>\n<compiler angle="radian"/>\n<worldbody>\n{bodies}\n</worldbody>\n{more}</mujoco>', feature
    )


def _chain(links: dict[str, str], joints: Sequence[tuple[str, str, str, str, str]]) -> str:
    """A URDF of links (mass and moments as numbers, or nothing) and joints (name, type, parent, child, what is inside)."""
    lines = ['<robot name="odd">']
    for name, given in links.items():
        if not given:
            lines.append(f'<link name="{name}"/>')
            continue
        mass, one, two, three, *at = given.split()
        lines.append(
            f'<link name="{name}"><inertial><origin xyz="{" ".join(at) or "0 0 0"}"/><mass value="{mass}"/>'
            f'<inertia ixx="{one}" iyy="{two}" izz="{three}" ixy="0" ixz="0" iyz="0"/></inertial></link>'
        )
    for name, kind, parent, child, inside in joints:
        lines.append(
            f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}'
            '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        )
    return "\n".join([*lines, "</robot>"])


AXIS = '<origin xyz="{}"/><axis xyz="{}"/>'


def planted() -> dict[str, Callable[[Path], Made]]:
    """Robots that readers trip over: name -> what writes them into a folder."""
    heavy = "1.2 0.01 0.012 0.014 0.1 0.02 0.03"
    base = {"base": "", "a": heavy, "b": heavy}
    found = {
        "two joints at one place": _mjcf_of(
            f'<body name="a"><joint name="j" axis="0 1 0"/>{INERTIAL.format(at="0.2 0 0")}<body name="b"><joint name="k" axis="1 0 0"/>'
            f'{INERTIAL.format(at="0.1 0.1 0")}<body name="c"><joint name="l" axis="0 0 1"/>{INERTIAL.format(at="0 0.2 0.1")}</body></body></body>',
            "two joints at one place",
        ),
        "slide, slide, hinge": _mjcf_of(
            f'<body name="a"><joint name="x" type="slide" axis="1 0 0"/><joint name="y" type="slide" axis="0 1 0"/><joint name="t" axis="0 0 1"/>'
            f'{INERTIAL.format(at="0.1 0 0")}<body name="b" pos="0.3 0 0.1"><joint name="k" axis="0 1 0"/>{INERTIAL.format(at="0.1 0 0.1")}</body></body>',
            "slide, slide, hinge base",
        ),
        "three slides": _mjcf_of(
            '<body name="a"><joint name="x" type="slide" axis="1 0 0"/><joint name="y" type="slide" axis="0 1 0"/>'
            f'<joint name="z" type="slide" axis="0 0 1"/>{INERTIAL.format(at="0 0 0")}</body>',
            "three slides",
        ),
        "ball at the centre of mass": _mjcf_of(
            f'<body name="a"><joint name="j" type="ball"/>{INERTIAL.format(at="0 0 0")}</body>', "body on one node"
        ),
        "balls at one place": _mjcf_of(
            f'<body name="a"><joint name="j" type="ball"/>{INERTIAL.format(at="0.2 0 0")}<body name="b"><joint name="k" type="ball"/>'
            f"{INERTIAL.format(at='0 0.2 0')}</body></body>",
            "two balls at one place",
        ),
        "free body with arms": _mjcf_of(
            f'<body name="a" pos="0 0 1"><freejoint name="f"/>{INERTIAL.format(at="0 0 0")}<body name="b"><joint name="k" axis="0 1 0"/>'
            f'{INERTIAL.format(at="0.2 0 0")}</body><body name="c"><joint name="l" axis="0 1 0"/>{INERTIAL.format(at="-0.2 0 0")}</body></body>',
            "free body with arms",
        ),
        "hinge, hinge, hinge crossing": _mjcf_of(
            f'<body name="a"><joint name="x" axis="1 0 0"/><joint name="y" axis="0 1 0"/><joint name="z" axis="0 0 1"/>{INERTIAL.format(at="0.1 0.1 0.1")}</body>',
            "three crossing hinges",
        ),
        "coaxial hinges": _mjcf_of(
            f'<body name="a"><joint name="j" axis="0 0 1"/>{INERTIAL.format(at="0.2 0 0")}<body name="b" pos="0 0 0.2"><joint name="k" axis="0 0 1"/>'
            f"{INERTIAL.format(at='0.2 0 0')}</body></body>",
            "coaxial hinges",
        ),
        "small body": _mjcf_of(
            f'<body name="a"><joint name="j" axis="0 1 0"/>{INERTIAL.format(at="0.2 0 0")}<body name="b" pos="0.3 0 0"><joint name="k" axis="0 1 0"/>'
            '<inertial pos="0.0001 0 0" mass="1e-5" diaginertia="1e-11 1e-11 1e-11"/></body></body>',
            "very small body",
        ),
        "flat four-bar": _mjcf_of(
            f'<body name="a"><joint name="j" axis="0 1 0"/>{INERTIAL.format(at="0 0 0.1")}<body name="b" pos="0 0 0.2"><joint name="k" axis="0 1 0"/>'
            f'{INERTIAL.format(at="0.2 0 0")}</body></body><body name="c" pos="0.5 0 0"><joint name="l" axis="0 1 0"/>{INERTIAL.format(at="0 0 0.1")}</body>',
            "flat four-bar",
            '<equality><connect name="e" body1="b" body2="c" anchor="0.5 0 0.1"/></equality>',
        ),
        "dummy links": _of_text(
            "urdf",
            _chain(
                {"base": "", "d1": "1e-9 5e-20 5e-20 5e-20", "d2": "1e-9 5e-20 5e-20 5e-20", "a": heavy},
                [
                    ("x", "prismatic", "base", "d1", AXIS.format("0 0 0", "1 0 0")),
                    ("y", "prismatic", "d1", "d2", AXIS.format("0 0 0", "0 1 0")),
                    ("t", "continuous", "d2", "a", AXIS.format("0 0 0", "0 0 1")),
                ],
            ),
            "dummy links",
            motors=["x", "y", "t"],
        ),
        "massless chain": _of_text(
            "urdf",
            _chain(
                {"base": "", "d1": "", "d2": "", "a": heavy},
                [
                    ("x", "revolute", "base", "d1", AXIS.format("0 0 0", "1 0 0")),
                    ("y", "revolute", "d1", "d2", AXIS.format("0 0.1 0", "0 1 0")),
                    ("t", "revolute", "d2", "a", AXIS.format("0.1 0 0", "0 0 1")),
                ],
            ),
            "massless chain",
            motors=["x", "y", "t"],
        ),
        "mimic of a fixed joint": _of_text(
            "urdf",
            _chain(
                base | {"c": ""},
                [
                    ("j", "revolute", "base", "a", AXIS.format("0 0 0", "0 1 0")),
                    ("k", "revolute", "a", "b", AXIS.format("0.3 0 0", "0 1 0")),
                    ("f", "fixed", "b", "c", AXIS.format("0.1 0 0", "0 0 1") + '<mimic joint="j" multiplier="2"/>'),
                ],
            ),
            "mimic of a fixed joint",
            motors=["j", "k"],
        ),
        "mimic led by a massless link": _of_text(
            "urdf",
            _chain(
                base | {"c": ""},
                [
                    ("j", "revolute", "base", "a", AXIS.format("0 0 0", "0 1 0")),
                    ("k", "revolute", "a", "b", AXIS.format("0.3 0 0", "0 1 0") + '<mimic joint="l" multiplier="2"/>'),
                    ("l", "revolute", "b", "c", AXIS.format("0.1 0 0", "0 0 1")),
                ],
            ),
            "mimic led by a massless link",
            motors=["j", "l"],
            mimics=[("k", "l", 2.0, 0.0)],
        ),
        "mass without inertia": _of_text(
            "urdf",
            _chain(
                {"base": "", "a": "1.5 0 0 0 0.2 0 0.1", "b": heavy},
                [
                    ("j", "revolute", "base", "a", AXIS.format("0 0 0", "0 1 0")),
                    ("k", "revolute", "a", "b", AXIS.format("0.3 0 0", "0 0 1")),
                ],
            ),
            "mass without inertia",
            motors=["j", "k"],
        ),
    }
    return found
