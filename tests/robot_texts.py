"""Closed-loop robots described once and written in two dialects: MJCF with `connect`, and URDF with closures in YAML."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

Vector = tuple[float, float, float]
ZERO: Vector = (0.0, 0.0, 0.0)


@dataclass(kw_only=True)
class Part:
    """A link and the joint that holds it. kind : hinge, slide or ball; at : of the joint in the parent, turned by rpy.

    line : a slender rod from the joint to this point, else a block of half sizes `block` about `center`.
    """

    name: str
    on: str = "base"
    kind: str = "hinge"
    at: Vector = ZERO
    rpy: Vector = ZERO
    axis: Vector = (0.0, 0.0, 1.0)
    mass: float = 0.0
    line: Vector | None = None
    center: Vector = ZERO
    block: Vector = (0.04, 0.05, 0.02)
    damping: float = 0.0
    friction: float = 0.0
    armature: float = 0.0

    @property
    def joint(self) -> str:
        return f"{self.name}_joint"

    def inertia(self) -> tuple[Vector, np.ndarray]:
        """Centre and tensor about it. Rods have next to no moment about their line, which no joint between balls holds."""
        if self.line is None:
            a, b, c = np.square(self.block)
            return self.center, self.mass / 3 * np.diag([b + c, a + c, a + b])
        way = np.array(self.line)
        square = float(way @ way)
        along, thin = np.outer(way, way) / square, 1e-10 if self.kind == "ball" else 1e-2
        return tuple((way / 2).tolist()), self.mass * square / 12 * (np.eye(3) - (1 - thin) * along)


@dataclass(kw_only=True)
class Closing:
    """Points of two links that stay together."""

    links: tuple[str, str]
    points: tuple[Vector, Vector]


@dataclass(kw_only=True)
class Described:
    """parts : each after the one that it is on. motors : names of parts whose joints are driven."""

    name: str
    parts: list[Part]
    closings: list[Closing] = field(default_factory=list)
    motors: list[str] = field(default_factory=list)

    @property
    def drives(self) -> list[str]:
        return [f"{name}_joint" for name in self.motors]

    @property
    def balls(self) -> tuple[str, ...]:
        return tuple(one.joint for one in self.parts if one.kind == "ball")

    @property
    def pairs(self) -> list[tuple[str, str]]:
        return [(f"end{k}_1", f"end{k}_2") for k, _ in enumerate(self.closings)]

    def frictions(self) -> dict[str, float]:
        return {one.joint: one.friction for one in self.parts if one.friction}

    def mjcf(self, folder: Path) -> Path:
        path = folder / f"{self.name}.xml"
        connects = "".join(
            f'<connect body1="{one.links[0]}" body2="{one.links[1]}" anchor="{row(one.points[0])}"/>' for one in self.closings
        )
        motors = "".join(f'<motor joint="{name}"/>' for name in self.drives)
        path.write_text(
            f'<mujoco model="{self.name}"><compiler angle="radian" eulerseq="XYZ"/><worldbody>{self._bodies("base")}'
            f"</worldbody><equality>{connects}</equality><actuator>{motors}</actuator></mujoco>"
        )
        return path

    def _bodies(self, on: str, before: str = "", frame: str = "") -> str:
        """before : joints of a link without mass, which MJCF does not have, and frame : its pose."""
        found = ""
        for one in self.parts:
            if one.on != on:
                continue
            axis = "" if one.kind == "ball" else f'axis="{row(one.axis)}"'
            laws = f'damping="{one.damping}" frictionloss="{one.friction}" armature="{one.armature}"'
            joint = f'<joint name="{one.joint}" type="{one.kind}" {axis} {"" if one.kind == "ball" else laws}/>'
            pose = frame or f'pos="{row(one.at)}" euler="{row(one.rpy)}"'
            if not one.mass:
                found += self._bodies(one.name, before + joint, pose)
                continue
            center, I = one.inertia()
            tensor = row([I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]])
            mass = f'<inertial pos="{row(center)}" mass="{one.mass}" fullinertia="{tensor}"/>'
            found += f'<body name="{one.name}" {pose}>{before}{joint}{mass}{self._bodies(one.name)}</body>'
        return found

    def urdf(self, folder: Path) -> tuple[Path, Path]:
        path, beside = folder / f"{self.name}.urdf", folder / f"{self.name}.yaml"
        kinds = {"hinge": "revolute", "slide": "prismatic", "ball": "revolute"}
        text = '<link name="base"/>'
        for one in self.parts:
            center, I = one.inertia()
            entries = " ".join(f'i{"xyz"[i]}{"xyz"[j]}="{float(I[i, j])!r}"' for i in range(3) for j in range(i, 3))
            mass = f'<inertial><origin xyz="{row(center)}"/><mass value="{one.mass}"/><inertia {entries}/></inertial>'
            text += f'<link name="{one.name}">{mass if one.mass else ""}</link>'
            text += (
                f'<joint name="{one.joint}" type="{kinds[one.kind]}"><parent link="{one.on}"/><child link="{one.name}"/>'
                f'<origin xyz="{row(one.at)}" rpy="{row(one.rpy)}"/><axis xyz="{row(one.axis)}"/>'
                '<limit lower="-3" upper="3" effort="9" velocity="9"/>'
                f'<dynamics damping="{one.damping}" friction="{one.friction}"/></joint>'
            )
        for closing, names in zip(self.closings, self.pairs, strict=True):
            for name, link, point in zip(names, closing.links, closing.points, strict=True):
                text += f'<link name="{name}"/><joint name="{name}_held" type="fixed"><parent link="{link}"/>'
                text += f'<child link="{name}"/><origin xyz="{row(point)}"/></joint>'
        path.write_text(f'<robot name="{self.name}">{text}</robot>')
        loops = ", ".join(f"[{one}, {two}]" for one, two in self.pairs)
        beside.write_text(
            f"closed_loop: [{loops}]\ntype: [{', '.join(['3d'] * len(self.pairs))}]\nname_mot: [{', '.join(self.drives)}]\n"
            f"joint_name: [{', '.join(self.balls)}]\njoint_type: [{', '.join(['SPHERICAL'] * len(self.balls))}]\n"
        )
        return path, beside


def row(values) -> str:
    return " ".join(repr(float(one)) for one in values)


def turned(angle: float, point: Vector) -> Vector:
    """A point turned about z."""
    c, s = float(np.cos(angle)), float(np.sin(angle))
    return c * point[0] - s * point[1], s * point[0] + c * point[1], point[2]


def less(one: Vector, two: Vector) -> Vector:
    return tuple((np.array(one) - np.array(two)).tolist())


def delta() -> Described:
    """Three arms with motors, parallelograms of two rods between balls, a platform that only translates (Clavel)."""
    parts, closings = [], []
    for k in range(3):
        angle = 2 * np.pi * k / 3 + 0.1
        arm = f"arm{k}"
        parts.append(
            Part(
                name=arm, at=turned(angle, (0.2, 0, 0)), rpy=(0, 0, angle), axis=(0, 1, 0), mass=0.9, line=(0.25, 0, -0.1),
                damping=0.2, friction=0.4, armature=0.03,
            )
        )  # fmt: skip
        for side, y in (("a", 0.05), ("b", -0.05)):
            rod = f"rod{k}{side}"
            parts.append(Part(name=rod, on=arm, kind="ball", at=(0.25, y, -0.1), mass=0.15, line=(-0.37, 0, -0.55)))
            if (k, side) == (0, "a"):
                parts.append(
                    Part(name="platform", on=rod, kind="ball", at=(-0.37, 0, -0.55), rpy=(0, 0, -angle), mass=1.3,
                         center=less((0, 0, 0.01), turned(angle, (0.08, y, 0))))
                )  # fmt: skip
            else:
                point = less(turned(angle, (0.08, y, 0)), turned(0.1, (0.08, 0.05, 0)))
                closings.append(Closing(links=(rod, "platform"), points=((-0.37, 0, -0.55), point)))
    return Described(name="delta", parts=parts, closings=closings, motors=["arm0", "arm1", "arm2"])


def scara() -> Described:
    """A five-bar linkage that moves a quill, which slides and turns about a vertical axis."""
    left, right, tip = (-0.1, 0, 0.4), (0.1, 0, 0.4), (0.05, 0.42, 0.4)
    elbows = (-0.27, 0.2, 0.4), (0.3, 0.18, 0.4)
    parts = [
        Part(name="arm1", at=left, mass=1.1, line=less(elbows[0], left), friction=0.3, armature=0.05),
        Part(name="fore1", on="arm1", at=less(elbows[0], left), mass=0.6, line=less(tip, elbows[0]), damping=0.05),
        Part(name="arm2", at=right, mass=1.0, line=less(elbows[1], right), damping=0.1, armature=0.02),
        Part(name="fore2", on="arm2", at=less(elbows[1], right), mass=0.7, line=less(tip, elbows[1]), friction=0.08),
        Part(name="quill", on="fore1", kind="slide", at=less(tip, elbows[0]), mass=0.5, center=(0, 0, 0.05), friction=2,
             armature=1.5),
        Part(name="tool", on="quill", at=(0, 0, -0.1), mass=0.4, center=(0.03, 0.02, -0.02), armature=0.004),
    ]  # fmt: skip
    closing = Closing(links=("fore1", "fore2"), points=(less(tip, elbows[0]), less(tip, elbows[1])))
    return Described(name="scara", parts=parts, closings=[closing], motors=["arm1", "arm2", "quill", "tool"])


def three_rrr() -> Described:
    """A plate in the plane on three legs of two bars, each turned by a motor on the ground; gravity across some joints."""
    parts, closings = [], []
    corner = turned(0.3, (0.12, 0, 0))
    for k in range(3):
        foot = turned(2 * np.pi * k / 3, (0.5, 0.1, 0))
        knee = turned(2 * np.pi * k / 3, (0.32, -0.22, 0))
        end = turned(2 * np.pi * k / 3 + 0.3, (0.12, 0, 0))
        parts.append(Part(name=f"low{k}", at=(0, foot[0], foot[1]), rpy=(np.pi / 2, 0, np.pi / 2), mass=1.2,
                          line=less(knee, foot), armature=0.1 * k, friction=0.5))  # fmt: skip
        parts.append(Part(name=f"high{k}", on=f"low{k}", at=less(knee, foot), mass=0.8, line=less(end, knee), damping=0.02))
        if k == 0:
            parts.append(Part(name="plate", on="high0", at=less(end, knee), mass=2.0, center=less((0.01, 0.02, 0.03), corner)))
        else:
            closings.append(Closing(links=(f"high{k}", "plate"), points=(less(end, knee), less(end, corner))))
    return Described(name="three_rrr", parts=parts, closings=closings, motors=["low0", "low1", "low2"])


def gough() -> Described:
    """Six legs on universal joints, with slides and balls under a plate (Gough and Stewart)."""
    parts, closings = [], []
    first: Vector = ZERO
    for k in range(6):
        low = np.radians(60 * k + (10 if k % 2 else -10))
        high = np.radians(60 * k + (-18 if k % 2 else 18))
        foot, end = np.array([0.5 * np.cos(low), 0.5 * np.sin(low), 0]), np.array([0.3 * np.cos(high), 0.3 * np.sin(high), 0.6])
        way = end - foot
        size = float(np.linalg.norm(way))
        pitch, yaw = float(np.arctan2(np.hypot(*way[:2]), way[2])), float(np.arctan2(way[1], way[0]))
        tip = (0, 0, size - 0.3)
        parts += [
            Part(name=f"cross{k}", at=tuple(foot.tolist()), rpy=(0, pitch, yaw), axis=(1, 0, 0)),
            Part(name=f"tube{k}", on=f"cross{k}", axis=(0, 1, 0), mass=0.7, line=(0, 0, 0.3)),
            Part(
                name=f"rod{k}",
                on=f"tube{k}",
                kind="slide",
                at=(0, 0, 0.3),
                mass=0.4,
                line=tip,
                damping=5,
                friction=3,
                armature=2,
            ),
        ]
        if k == 0:
            first = tuple(end.tolist())
            parts.append(Part(name="top", on="rod0", kind="ball", at=tip, rpy=(0, 0, 0), mass=4, center=(0, 0, 0)))
            frame = rotation(0, pitch, yaw)
            parts[-1].rpy = angles(frame.T)
            parts[-1].center = less((0.02, 0.01, 0.63), first)
        else:
            closings.append(Closing(links=(f"rod{k}", "top"), points=(tip, less(tuple(end.tolist()), first))))
    return Described(name="gough", parts=parts, closings=closings, motors=[f"rod{k}" for k in range(6)])


def leg() -> Described:
    """Hip and knee with motors; two motors in the shank move the ankle, which pitches and rolls, by cranks and rods."""
    parts = [
        Part(name="thigh", axis=(0, 1, 0), rpy=(0, -0.3, 0), mass=4, line=(0, 0, -0.4), armature=0.2, friction=1.0),
        Part(
            name="shank", on="thigh", at=(0, 0, -0.4), rpy=(0, 0.5, 0), axis=(0, 1, 0), mass=3, line=(0, 0, -0.4), armature=0.2
        ),
        Part(name="cross", on="shank", at=(0, 0, -0.4), axis=(0, 1, 0)),
        Part(
            name="foot", on="cross", axis=(1, 0, 0), mass=1.1, center=(0.05, 0, -0.05), block=(0.12, 0.05, 0.02), friction=0.2
        ),
    ]
    closings = []
    for k, (y, z) in enumerate(((0.05, -0.1), (-0.05, -0.18))):
        crank, rod = f"crank{k}", f"rod{k}"
        parts += [
            Part(name=crank, on="shank", at=(0, y, z), axis=(0, 1, 0), mass=0.2, line=(-0.06, 0, 0.005), armature=0.01,
                 damping=0.03),
            Part(name=rod, on=crank, kind="ball", at=(-0.06, 0, 0.005), mass=0.15, line=(-0.005, 0, -0.4 - z - 0.015)),
        ]  # fmt: skip
        closings.append(Closing(links=(rod, "foot"), points=((-0.005, 0, -0.4 - z - 0.015), (-0.065, y, -0.01))))
    return Described(name="leg", parts=parts, closings=closings, motors=["thigh", "shank", "crank0", "crank1"])


def rotation(roll: float, pitch: float, yaw: float) -> np.ndarray:
    """Of angles about the fixed x, y, z."""

    def about(axis: int, t: float) -> np.ndarray:
        i, j = (axis + 1) % 3, (axis + 2) % 3
        R = np.eye(3)
        R[i, i] = R[j, j] = np.cos(t)
        R[i, j], R[j, i] = -np.sin(t), np.sin(t)
        return R

    return about(2, yaw) @ about(1, pitch) @ about(0, roll)


def angles(R: np.ndarray) -> Vector:
    """Roll, pitch and yaw of a rotation."""
    return float(np.arctan2(R[2, 1], R[2, 2])), float(-np.arcsin(R[2, 0])), float(np.arctan2(R[1, 0], R[0, 0]))
