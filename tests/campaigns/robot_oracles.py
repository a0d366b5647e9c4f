"""Robots as MuJoCo and Pinocchio compute them, with loops and laws of this script's own: M a = f(q, v) - J^T lambda, J a = -J' v.

Both give positions, Jacobians and their rates at points of bodies, the mass matrix, and all forces but those of motors. What
a file holds that moves the robot is an `Influence`: it is carried by the product, or listed by it and then taken out here.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pinocchio as pin

mujoco.set_mju_user_warning(lambda text: None)  # else it writes a log beside the caller
SLIP = 1e-3
"""rad/s or m/s: the rate of friction, whose size is times tanh(rate/slip), by default."""
CARRIED, LISTED, EITHER = "carried", "listed", "either"
FREE, BALL, SLIDE, HINGE = (int(getattr(mujoco.mjtJoint, f"mjJNT_{word}")) for word in ("FREE", "BALL", "SLIDE", "HINGE"))
CONNECT, WELD, JOINT = (int(getattr(mujoco.mjtEq, f"mjEQ_{word}")) for word in ("CONNECT", "WELD", "JOINT"))
ON_JOINT = (int(mujoco.mjtTrn.mjTRN_JOINT), int(mujoco.mjtTrn.mjTRN_JOINTINPARENT))
OFF = {
    name[7:].lower(): int(getattr(mujoco.mjtDisableBit, name)) for name in dir(mujoco.mjtDisableBit) if name[:7] == "mjDSBL_"
}


@dataclass(frozen=True)
class Influence:
    """One thing in a file that changes the motion.

    words : one of which is in what the product says if it leaves it out. name : of its element. expected : carried, listed, or
    either. without : takes it out of the oracle; None where the oracle has no force of it in any case.
    """

    words: tuple[str, ...]
    name: str
    expected: str
    without: Callable[[], None] | None = None
    part: bool = False
    """It is only a term of higher order."""

    def listed(self, what: str, where: str, why: str) -> bool:
        """True if a line of what is left out is about this."""
        said = f"{what}: {why}".lower()
        if "soften" in said:  # conditions are rigid in every comparison
            return False
        if self.part != ("higher order" in said) or not any(re.search(rf"(?<![a-z]){word}", said) for word in self.words):
            return False
        return not self.name or re.search(rf"(?<![\w.]){re.escape(self.name)}(?![\w.])", f"{where} {why} {what}") is not None


class Oracle(ABC):
    """A robot of another program. `q` are its coordinates, velocities (nv,) as of that program."""

    nv: int
    q0: Any
    bodies: dict[str, Any]
    """Name -> its own key of a moving body."""
    influences: list[Influence]
    spun: set[str]
    """Bodies whose spin about an own axis of symmetry the product leaves out."""

    @abstractmethod
    def place(self, q: Any, v: Any = None) -> None:
        """Go to a state."""

    @abstractmethod
    def integrate(self, q: Any, step: Any) -> Any: ...

    @abstractmethod
    def frame(self, body: str) -> tuple[Any, Any]:
        """Rotation (3, 3) and place (3,) of a body."""

    @abstractmethod
    def jacobian(self, body: str, point: Any) -> Any:
        """(6, nv) of a point (3,) of space, as part of a body: its velocity, and the body's rotation."""

    @abstractmethod
    def drift(self, body: str, point: Any) -> Any:
        """(6,) rate of this Jacobian times v."""

    @abstractmethod
    def mass(self) -> Any:
        """(nv, nv)"""

    @abstractmethod
    def force(self) -> Any:
        """(nv,) of gravity, motion and laws, but without motors and closures."""

    @abstractmethod
    def rows(self) -> tuple[Any, Any, Any]:
        """Of the closures: gaps (m,), J (m, nv), J' v (m,)."""

    @abstractmethod
    def drives(self) -> dict[str, Callable[[], Any]]:
        """Drive that the product must have -> its direction (nv,)."""

    def value(self, q: Any, joint: str) -> float | None:
        """Of a hinge or slide."""
        return None

    def forget_spin(self, body: str) -> None:
        """Take the inertia of a body about its axis of symmetry out."""


class MujocoOracle(Oracle):
    """An MJCF file."""

    def __init__(self, path: Path) -> None:
        self.model = mujoco.MjModel.from_xml_path(str(path))
        self.data = mujoco.MjData(self.model)
        m = self.model
        m.dof_simplenum[:] = m.body_simple[:] = 0  # else the mass matrix of some bodies is one from before changes
        self.nv, self.q0 = m.nv, m.qpos0.copy()
        self.v = np.zeros(m.nv)
        self.bodies = {m.body(i).name: i for i in range(1, m.nbody)}
        self.spun = set()
        self.closed = not m.opt.disableflags & (OFF["equality"] | OFF["constraint"])
        self.rubbing = not m.opt.disableflags & (OFF["frictionloss"] | OFF["constraint"])
        self.active = [bool(one) and self.closed for one in m.eq_active0]
        self.friction = m.dof_frictionloss.copy() * self.rubbing
        self.tendon_friction = m.tendon_frictionloss.copy() * self.rubbing
        self.influences = list(self._influences())

    def _influences(self) -> Iterator[Influence]:
        m = self.model
        sprung, damped, acting = (not m.opt.disableflags & OFF[word] for word in ("spring", "damper", "actuation"))

        def zero(values: Any, index: Any) -> Callable[[], None]:
            return lambda: values.__setitem__(index, 0)

        for j in range(m.njnt):
            name, kind = m.joint(j).name, int(m.jnt_type[j])
            single = kind in (HINGE, SLIDE)
            status = CARRIED if single else EITHER
            first = m.jnt_dofadr[j]
            own = slice(first, first + {FREE: 6, BALL: 3}.get(kind, 1))
            bent, drag = m.jnt_stiffnesspoly[j], m.dof_dampingpoly[first]
            if sprung and m.jnt_stiffness[j]:
                yield Influence(("stiffness",), name, status, zero(m.jnt_stiffness, j))
            if bent.any():
                yield Influence(("stiffness",), name, LISTED, zero(m.jnt_stiffnesspoly, j), True)
            if damped and m.dof_damping[own].any():
                yield Influence(("damping",), name, status, zero(m.dof_damping, own))
            if drag.any():
                yield Influence(("damping",), name, LISTED, zero(m.dof_dampingpoly, own), True)
            if self.friction[own].any():
                yield Influence(("frictionloss", "friction"), name, status, zero(self.friction, own))
            if m.dof_armature[own].any():
                yield Influence(("armature",), name, status, zero(m.dof_armature, own))
        for t in range(m.ntendon):
            yield from self._of_tendon(t, sprung, damped, zero)
        for e in np.flatnonzero(self.active):
            name, kind, data = m.eq(e).name, int(m.eq_type[e]), m.eq_data[e]
            tag = {CONNECT: "connect", WELD: "weld", JOINT: "joint"}.get(kind, "tendon")
            plain = kind in (CONNECT, WELD) or (m.eq_obj2id[e] >= 0 and not data[2:5].any())
            yield Influence((tag, "equality", "coupling", "polycoef"), name, CARRIED if plain else EITHER, zero(self.active, e))
        if m.opt.density:
            yield Influence(("density",), "", LISTED, lambda: setattr(m.opt, "density", 0.0))
        if m.opt.viscosity:
            yield Influence(("viscosity",), "", LISTED, lambda: setattr(m.opt, "viscosity", 0.0))
        if m.opt.wind.any():
            yield Influence(("wind",), "", LISTED)
        for b in np.flatnonzero(m.body_gravcomp):
            yield Influence(("gravcomp",), m.body(b).name, LISTED, zero(m.body_gravcomp, b))
        for a in range(m.nactuator):
            name, gains = m.actuator(a).name, m.actuator_biasprm[a].any() or m.actuator_biastype[a]
            if gains and acting:
                yield Influence(("position", "velocity", "damper", "general", "bias", "gain", "kp", "kv"), name, LISTED)
            if m.actuator_dampingpoly[a].any():
                yield Influence(("damping",), name, LISTED, zero(m.actuator_dampingpoly, a), True)
            if m.actuator_armature[a]:
                yield Influence(("armature",), name, EITHER, zero(m.actuator_armature, a))
            if m.actuator_damping[a] and damped:
                yield Influence(("damping",), name, EITHER, zero(m.actuator_damping, a))

    def _of_tendon(self, t: int, sprung: bool, damped: bool, zero: Any) -> Iterator[Influence]:
        m = self.model
        name = m.tendon(t).name
        straight = self._straight(t)
        slack = m.tendon_lengthspring[t]
        status = CARRIED if straight else EITHER
        whole = ("spatial:", "fixed:", "tendon:")
        if sprung and m.tendon_stiffness[t]:
            one = status if slack[0] == slack[1] else EITHER
            yield Influence(("stiffness", "springlength", *whole), name, one, zero(m.tendon_stiffness, t))
        if damped and m.tendon_damping[t]:
            yield Influence(("damping", *whole), name, status, zero(m.tendon_damping, t))
        if self.tendon_friction[t]:
            yield Influence(("friction", *whole), name, status, zero(self.tendon_friction, t))
        for word, bent in (("stiffness", m.tendon_stiffnesspoly), ("damping", m.tendon_dampingpoly)):
            if bent[t].any():
                yield Influence((word,), name, LISTED, zero(bent, t), True)
        if m.tendon_armature[t]:
            yield Influence(("armature", *whole), name, LISTED, zero(m.tendon_armature, t))

    def _straight(self, t: int) -> list[int] | None:
        """The two sites of a straight tendon."""
        m = self.model
        at, n = m.tendon_adr[t], m.tendon_num[t]
        if n == 2 and (m.wrap_type[at : at + 2] == mujoco.mjtWrap.mjWRAP_SITE).all():
            return [int(one) for one in m.wrap_objid[at : at + 2]]
        return None

    def place(self, q, v=None):
        self.data.qpos[:] = q
        self.v = np.zeros(self.nv) if v is None else np.asarray(v)
        self.data.qvel[:] = self.v
        mujoco.mj_fwdPosition(self.model, self.data)
        mujoco.mj_fwdVelocity(self.model, self.data)

    def integrate(self, q, step):
        found = q.copy()
        mujoco.mj_integratePos(self.model, found, np.asarray(step, float), 1.0)
        return found

    def frame(self, body):
        k = self.bodies[body]
        return self.data.xmat[k].reshape(3, 3).copy(), self.data.xpos[k].copy()

    def _jac(self, k, point):
        J = np.zeros((6, self.nv))
        mujoco.mj_jac(self.model, self.data, J[:3], J[3:], np.asarray(point, float), k)
        return J

    def _rate(self, k, point):
        J = np.zeros((6, self.nv))
        mujoco.mj_jacDot(self.model, self.data, J[:3], J[3:], np.asarray(point, float), k)
        return J @ self.v

    def jacobian(self, body, point):
        return self._jac(self.bodies[body], point)

    def drift(self, body, point):
        return self._rate(self.bodies[body], point)

    def mass(self):
        M = np.zeros((self.nv, self.nv))
        mujoco.mj_fullM(self.model, self.data, M)
        return M

    def force(self):
        found = self.data.qfrc_passive - self.data.qfrc_bias - self.friction * np.tanh(self.v / SLIP)
        for t in np.flatnonzero(self.tendon_friction):
            row = self._tendon_row(t)
            found = found - self.tendon_friction[t] * np.tanh(row @ self.v / SLIP) * row
        return found

    def _tendon_row(self, t):
        """Gradient of the length of a tendon, by the rates of all coordinates."""
        if (sites := self._straight(t)) is None:
            row = np.zeros(self.nv)
            at = self.model.tendon_adr[t]
            for k in range(at, at + self.model.tendon_num[t]):
                row[self.model.jnt_dofadr[self.model.wrap_objid[k]]] += self.model.wrap_prm[k]
            return row
        one, two = (self.data.site_xpos[s] for s in sites)
        along = (two - one) / np.linalg.norm(two - one)
        first, second = (self._jac(self.model.site_bodyid[s], self.data.site_xpos[s])[:3] for s in sites)
        return along @ (second - first)

    def rows(self):
        m = self.model
        gaps, rows, rates = [np.zeros(0)], [np.zeros((0, self.nv))], [np.zeros(0)]
        for e in np.flatnonzero(self.active):
            one, two, data = m.eq_obj1id[e], m.eq_obj2id[e], m.eq_data[e]
            if int(m.eq_type[e]) in (CONNECT, WELD):
                whole = int(m.eq_type[e]) == WELD
                ends = self._ends(one, two, m.eq_objtype[e], data, whole)
                (k, p, R), (n, r, S) = ends
                size = 6 if whole else 3
                gap = p - r
                if whole:
                    T = R @ S.T
                    gap = np.concatenate([gap, 0.5 * np.array([T[2, 1] - T[1, 2], T[0, 2] - T[2, 0], T[1, 0] - T[0, 1]])])
                gaps.append(gap)
                rows.append((self._jac(k, p) - self._jac(n, r))[:size])
                rates.append((self._rate(k, p) - self._rate(n, r))[:size])
            else:
                y, row = self._coordinate(int(m.eq_type[e]), one)
                x, other = self._coordinate(int(m.eq_type[e]), two) if two >= 0 else (0.0, np.zeros(self.nv))
                gaps.append(np.array([y - sum(data[k] * x**k for k in range(5))]))
                rows.append((row - sum(k * data[k] * x ** (k - 1) for k in range(1, 5)) * other)[None])
                bend = sum(k * (k - 1) * data[k] * x ** (k - 2) for k in range(2, 5))
                rates.append(np.array([-bend * (other @ self.v) ** 2]))
        return np.concatenate(gaps), np.vstack(rows), np.concatenate(rates)

    def _coordinate(self, kind, k):
        """What a condition couples, a hinge, slide or fixed tendon: its value from the start on, and its constant gradient."""
        m = self.model
        if kind == JOINT:
            return self.data.qpos[m.jnt_qposadr[k]] - m.qpos0[m.jnt_qposadr[k]], np.eye(self.nv)[m.jnt_dofadr[k]]
        return self.data.ten_length[k] - m.tendon_length0[k], self._tendon_row(k)

    def _ends(self, one, two, kind, data, whole):
        m, d = self.model, self.data
        if kind == mujoco.mjtObj.mjOBJ_SITE:
            return [(m.site_bodyid[s], d.site_xpos[s].copy(), d.site_xmat[s].reshape(3, 3)) for s in (one, two)]
        R, S = (d.xmat[k].reshape(3, 3) for k in (one, two))
        near, far = (data[3:6], data[:3]) if whole else (data[:3], data[3:6])
        turn = np.zeros(9)
        mujoco.mju_quat2Mat(turn, data[6:10] if whole else np.array([1.0, 0, 0, 0]))
        return [(one, d.xpos[one] + R @ near, R @ turn.reshape(3, 3)), (two, d.xpos[two] + S @ far, S)]

    def drives(self):
        m = self.model
        if m.opt.disableflags & OFF["actuation"]:
            return {}
        found: dict[str, Callable[[], Any]] = {}
        for a in range(m.nactuator):
            k = int(m.actuator_trnid[a, 0])
            if int(m.actuator_trntype[a]) in ON_JOINT:
                if int(m.jnt_type[k]) in (HINGE, SLIDE):
                    found[m.joint(k).name] = lambda k=k: np.eye(self.nv)[m.jnt_dofadr[k]]
            elif m.actuator_trntype[a] == mujoco.mjtTrn.mjTRN_TENDON and self._straight(k) is not None:
                found[m.tendon(k).name] = lambda k=k: self._tendon_row(k)
        return found

    def value(self, q, joint):
        k = self.model.joint(joint).id
        single = int(self.model.jnt_type[k]) in (HINGE, SLIDE)
        return float(q[self.model.jnt_qposadr[k]]) if single else None

    def at(self, values):
        """Coordinates with values of hinges and slides."""
        q = self.q0.copy()
        for joint, value in values.items():
            q[self.model.jnt_qposadr[self.model.joint(joint).id]] = value
        return q

    def forget_spin(self, body):
        if body in self.bodies:
            I = self.model.body_inertia[self.bodies[body]]
            pairs = [(abs(I[i] - I[j]), k) for i, j, k in ((0, 1, 2), (0, 2, 1), (1, 2, 0))]
            I[min(pairs)[1]] = 0.0
            self.spun.add(body)

    def fields(self) -> set[str]:
        """Fields of the model and its options that are set."""
        found = {name for name in dir(self.model) if name[0] != "_" and np.any(getattr(self.model, name, 0))}
        return found | {
            f"opt.{name}" for name in dir(self.model.opt) if name[0] != "_" and np.any(getattr(self.model.opt, name))
        }

    def heavy(self) -> float:
        """kg that can move."""
        m = self.model
        return float(sum(m.body_mass[b] for b in range(1, m.nbody) if m.body_weldid[b]))


@dataclass
class Beside:
    """What a URDF has beside Pinocchio's reading: laws, mimics, closures, other types of joints.

    laws : joint -> damping, friction. mimics : joint, leader, factor, offset. closures : two links, number of conditions (3, 6).
    """

    laws: dict[str, tuple[float, float]] = field(default_factory=dict)
    mimics: list[tuple[str, str, float, float]] = field(default_factory=list)
    closures: list[tuple[str, str, int]] = field(default_factory=list)
    balls: Sequence[str] = ()
    stiff: Sequence[str] = ()
    motors: Sequence[str] = ()
    gravity: tuple[float, float, float] = (0.0, 0.0, -9.81)


class PinocchioOracle(Oracle):
    """A URDF, its base held or floating."""

    def __init__(self, path: Path, beside: Beside, floating: bool = False) -> None:
        root = [pin.JointModelFreeFlyer()] if floating else []
        m = pin.buildModelFromUrdf(str(path), *root)
        self.model, self.beside = _retyped(m, beside), beside
        self.model.gravity.linear = np.array(beside.gravity)
        self.data = self.model.createData()
        self.nv, self.q0 = self.model.nv, pin.neutral(self.model)
        self.v = np.zeros(self.nv)
        bodies = [k for k, frame in enumerate(self.model.frames) if frame.type == pin.FrameType.BODY]
        self.bodies = {self.model.frames[k].name: k for k in bodies}
        self.spun = set()
        self.laws = {self._joint(name).idx_v: law for name, law in beside.laws.items() if self.model.existJointName(name)}
        self.influences = list(self._influences())

    def _joint(self, name):
        return self.model.joints[self.model.getJointId(name)]

    def _influences(self) -> Iterator[Influence]:
        for name, (damping, friction) in self.beside.laws.items():
            if not self.model.existJointName(name):
                continue
            k = self._joint(name).idx_v
            if damping:
                yield Influence(("damping", "dynamics"), name, CARRIED, lambda k=k: self._law(k, 0))
            if friction:
                yield Influence(("friction", "dynamics"), name, CARRIED, lambda k=k: self._law(k, 1))
        for one in self.beside.mimics:
            yield Influence(("mimic", "coupling"), one[0], CARRIED, lambda one=one: self.beside.mimics.remove(one))

    def _law(self, k, which):
        self.laws[k] = tuple(0.0 if i == which else x for i, x in enumerate(self.laws[k]))

    def place(self, q, v=None):
        self.q, self.v = q, np.zeros(self.nv) if v is None else np.asarray(v, float)
        pin.computeJointJacobians(self.model, self.data, q)
        pin.forwardKinematics(self.model, self.data, q, self.v, np.zeros(self.nv))
        pin.updateFramePlacements(self.model, self.data)

    def integrate(self, q, step):
        return pin.integrate(self.model, q, np.asarray(step, float))

    def frame(self, body):
        at = self.data.oMf[self.bodies[body]]
        return at.rotation.copy(), at.translation.copy()

    def jacobian(self, body, point):
        k = self.bodies[body]
        J = np.reshape(pin.getFrameJacobian(self.model, self.data, k, pin.LOCAL_WORLD_ALIGNED), (6, self.nv)).copy()
        r = point - self.data.oMf[k].translation
        J[:3] += np.cross(J[3:].T, r).T
        return J

    def drift(self, body, point):
        k = self.bodies[body]
        a = pin.getFrameClassicalAcceleration(self.model, self.data, k, pin.LOCAL_WORLD_ALIGNED)
        w = pin.getFrameVelocity(self.model, self.data, k, pin.LOCAL_WORLD_ALIGNED).angular
        r = point - self.data.oMf[k].translation
        return np.concatenate([a.linear + np.cross(a.angular, r) + np.cross(w, np.cross(w, r)), a.angular])

    def mass(self):
        M = pin.crba(self.model, self.data.copy(), self.q)
        return np.triu(M) + np.triu(M, 1).T

    def force(self):
        found = -pin.rnea(self.model, self.data.copy(), self.q, self.v, np.zeros(self.nv))
        for k, (damping, friction) in self.laws.items():
            found[k] -= damping * self.v[k] + friction * np.tanh(self.v[k] / SLIP)
        return found

    def rows(self):
        gaps, rows, rates = [np.zeros(0)], [np.zeros((0, self.nv))], [np.zeros(0)]
        for a, b, size in self.beside.closures:
            (R, p), (S, r) = self.frame(a), self.frame(b)
            T = R @ S.T
            turn = 0.5 * np.array([T[2, 1] - T[1, 2], T[0, 2] - T[2, 0], T[1, 0] - T[0, 1]])
            gaps.append(np.concatenate([p - r, turn])[:size])
            rows.append((self.jacobian(a, p) - self.jacobian(b, r))[:size])
            rates.append((self.drift(a, p) - self.drift(b, r))[:size])
        for name, leader, factor, offset in self.beside.mimics:
            one, two = self._joint(name), self._joint(leader)
            row = np.zeros((1, self.nv))
            row[0, one.idx_v] = 1.0
            row[0, two.idx_v] -= factor
            gap = self.value(self.q, name) - factor * self.value(self.q, leader) - offset
            gaps.append(np.array([gap]))
            rows.append(row)
            rates.append(np.zeros(1))
        return np.concatenate(gaps), np.vstack(rows), np.concatenate(rates)

    def drives(self):
        return {name: (lambda k=self._joint(name).idx_v: np.eye(self.nv)[k]) for name in self.beside.motors}

    def value(self, q, joint):
        one = self._joint(joint)
        if one.nv != 1:
            return None
        return float(q[one.idx_q]) if one.nq == 1 else float(np.arctan2(q[one.idx_q + 1], q[one.idx_q]))

    def at(self, values):
        """Coordinates with values of hinges and sliders."""
        q = self.q0.copy()
        for joint, value in values.items():
            one = self._joint(joint)
            q[one.idx_q : one.idx_q + one.nq] = value if one.nq == 1 else (np.cos(value), np.sin(value))
        return q

    def forget_spin(self, body):
        self.spun.add(body)

    def heavy(self) -> float:
        """kg that can move."""
        return float(sum(one.mass for one in list(self.model.inertias)[1:]))


def _retyped(model: Any, beside: Beside) -> Any:
    """The model with some hinges as balls or fixed, as a file beside a URDF may say."""
    found, number, shift = pin.Model(), {0: 0}, {0: pin.SE3.Identity()}
    for k in range(1, model.njoints):
        name, parent = model.names[k], model.parents[k]
        at = shift[parent] * model.jointPlacements[k]
        if name in beside.stiff:
            number[k], shift[k] = number[parent], at
        else:
            joint = pin.JointModelSpherical() if name in beside.balls else model.joints[k]
            number[k], shift[k] = found.addJoint(number[parent], joint, at, name), pin.SE3.Identity()
        found.appendBodyToJoint(number[k], model.inertias[k], shift[k])
    for frame in list(model.frames)[1:]:
        at = shift[frame.parentJoint] * frame.placement
        found.addFrame(pin.Frame(frame.name, number[frame.parentJoint], at, frame.type), False)
    return found
