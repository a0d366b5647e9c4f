"""Inverse dynamics of robots with loops in minimal coordinates, with the tree of another program.

The tree gives tau = M a + h of its joints. With the velocities of all joints v = N u of those of the motors, the work of the
closures vanishes in N^T tau, which is what the motors must give (Lagrange's multipliers eliminated).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pinocchio as pin

SLIP = 1e-3
"""rad/s or m/s"""


class Tree(ABC):
    """A robot of another program: `q` of its pose, the columns of its motors."""

    q: Any
    motors: list[int]
    laws: dict[int, tuple[float, float, float]] = {}
    """Column -> damping, friction and inertia of a rotor that the other program does not count."""

    @abstractmethod
    def column(self, joint: str) -> int:
        """Of a hinge or slide."""

    @abstractmethod
    def integrate(self, q: Any, step: Any) -> Any: ...

    @abstractmethod
    def gap(self, q: Any) -> Any: ...

    @abstractmethod
    def jacobian(self, q: Any) -> Any: ...

    @abstractmethod
    def drift(self, q: Any, v: Any) -> Any:
        """Rate of the Jacobian times v."""

    @abstractmethod
    def inverse(self, q: Any, v: Any, a: Any) -> Any: ...

    @abstractmethod
    def value(self, q: Any) -> Any:
        """Of the motors."""

    def torques(self, values: Any, rates: Any, accelerations: Any) -> Any:
        """Of the motors along a motion (times, motors)."""
        found = []
        for value, u, du in zip(values, rates, accelerations, strict=True):
            self.q = self.closed(self.q, value)
            J = self.jacobian(self.q)
            rest = [k for k in range(J.shape[1]) if k not in self.motors]
            N = np.zeros((J.shape[1], len(self.motors)))
            N[self.motors] = np.eye(len(self.motors))
            N[rest] = np.linalg.lstsq(J[:, rest], -J[:, self.motors], rcond=1e-10)[0]
            v, a = N @ u, np.zeros(J.shape[1])
            a[self.motors] = du
            a[rest] = np.linalg.lstsq(J[:, rest], -self.drift(self.q, v) - J[:, self.motors] @ du, rcond=1e-10)[0]
            found.append(N.T @ (self.inverse(self.q, v, a) + self.resistance(v, a)))
        return np.array(found)

    def resistance(self, v: Any, a: Any) -> Any:
        """Of `laws`; friction has its size times tanh(rate/slip)."""
        found = np.zeros(len(v))
        for k, (damping, friction, rotor) in self.laws.items():
            found[k] = damping * v[k] + friction * np.tanh(v[k] / SLIP) + rotor * a[k]
        return found

    def closed(self, q: Any, value: Any) -> Any:
        """The closed pose near q with these values of the motors."""
        for _ in range(50):
            J, gap = self.jacobian(q), self.gap(q)
            step = np.zeros(J.shape[1])
            step[self.motors] = value - self.value(q)
            rest = [k for k in range(J.shape[1]) if k not in self.motors]
            step[rest] = np.linalg.lstsq(J[:, rest], -gap - J[:, self.motors] @ step[self.motors], rcond=1e-10)[0]
            q = self.integrate(q, step)
            if np.abs(step).max() < 1e-14:
                break
        assert np.abs(self.gap(q)).max(initial=0.0) < 1e-13
        return q


class PinocchioTree(Tree):
    """A URDF; closures of three conditions between pairs of frames; some joints may be balls.

    mimics : joint, other joint, multiplier, offset.
    """

    def __init__(
        self, path: Path, pairs: list[tuple[str, str]], motors: list[str], balls: tuple[str, ...] = (), mimics: Any = ()
    ) -> None:
        self.model = with_balls(pin.buildModelFromUrdf(str(path)), balls)
        self.data = self.model.createData()
        self.pairs = [tuple(self.model.getFrameId(name) for name in pair) for pair in pairs]
        joints = [self.model.joints[self.model.getJointId(name)] for name in motors]
        self.motors = [joint.idx_v for joint in joints]
        self.place = [(joint.idx_q, joint.nq) for joint in joints]
        self.q = pin.neutral(self.model)
        index = {name: self.model.joints[self.model.getJointId(name)] for one in mimics for name in one[:2]}
        self.mimics = [(index[one], index[other], *rest) for one, other, *rest in mimics]

    def column(self, joint):
        return self.model.joints[self.model.getJointId(joint)].idx_v

    def integrate(self, q, step):
        return pin.integrate(self.model, q, step)

    def value(self, q):
        return np.array([q[k] if n == 1 else np.arctan2(q[k + 1], q[k]) for k, n in self.place])

    def gap(self, q):
        pin.framesForwardKinematics(self.model, self.data, q)
        at = self.data.oMf
        loops = [at[a].translation - at[b].translation for a, b in self.pairs]
        return np.concatenate([*loops, [q[a.idx_q] - factor * q[b.idx_q] - offset for a, b, factor, offset in self.mimics]])

    def jacobian(self, q):
        axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        each = [[pin.computeFrameJacobian(self.model, self.data, q, k, axes)[:3] for k in pair] for pair in self.pairs]
        rows = np.zeros((len(self.mimics), self.model.nv))
        for row, (a, b, factor, _) in zip(rows, self.mimics, strict=True):
            row[[a.idx_v, b.idx_v]] = 1.0, -factor
        return np.vstack([*(one - two for one, two in each), rows])

    def drift(self, q, v):
        pin.forwardKinematics(self.model, self.data, q, v, np.zeros(self.model.nv))
        axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        each = [[pin.getFrameClassicalAcceleration(self.model, self.data, k, axes).linear for k in pair] for pair in self.pairs]
        return np.concatenate([*(one - two for one, two in each), np.zeros(len(self.mimics))])

    def inverse(self, q, v, a):
        return pin.rnea(self.model, self.data, q, v, a)


def with_balls(model: Any, balls: tuple[str, ...]) -> Any:
    """The model of a URDF with some joints as balls, which URDF does not have."""
    found = pin.Model()
    for k in range(1, model.njoints):
        name = model.names[k]
        joint = pin.JointModelSpherical() if name in balls else model.joints[k]
        found.addJoint(model.parents[k], joint, model.jointPlacements[k], name)
        found.appendBodyToJoint(k, model.inertias[k], pin.SE3.Identity())
    for frame in list(model.frames)[1:]:
        found.addFrame(pin.Frame(frame.name, frame.parentJoint, frame.placement, frame.type), False)
    return found


class MujocoTree(Tree):
    """An MJCF with `connect` between bodies, and linear couplings of two joints."""

    def __init__(self, path: Path, motors: list[str]) -> None:
        self.model = mujoco.MjModel.from_xml_path(str(path))
        self.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
        self.data = mujoco.MjData(self.model)
        self.motors = [int(self.model.jnt_dofadr[self.model.joint(name).id]) for name in motors]
        self.at = [int(self.model.jnt_qposadr[self.model.joint(name).id]) for name in motors]
        self.q = self.model.qpos0.copy()
        kinds = np.where(self.model.eq_active0, self.model.eq_type, -1)
        self.loops = np.flatnonzero(kinds == mujoco.mjtEq.mjEQ_CONNECT)
        joints = np.flatnonzero(kinds == mujoco.mjtEq.mjEQ_JOINT)
        assert len(self.loops) + len(joints) == np.sum(kinds >= 0)
        self.coupled = [
            (int(self.model.eq_obj1id[k]), int(self.model.eq_obj2id[k]), *self.model.eq_data[k, :2]) for k in joints
        ]

    def _couplings(self, q):
        """y - y0 - c0 - c1 (x - x0)"""
        at, zero = self.model.jnt_qposadr, self.model.qpos0
        return [q[at[y]] - zero[at[y]] - c0 - c1 * (q[at[x]] - zero[at[x]]) for y, x, c0, c1 in self.coupled]

    def _points(self):
        for k, _ in enumerate(self.loops):
            row = self.loops[k]
            ends = (int(self.model.eq_obj1id[row]), int(self.model.eq_obj2id[row]))
            for body, at, sign in zip(ends, (self.model.eq_data[row, :3], self.model.eq_data[row, 3:6]), (1, -1), strict=True):
                yield k, body, self.data.xpos[body] + self.data.xmat[body].reshape(3, 3) @ at, sign

    def _place(self, q, v=None):
        self.data.qpos[:] = q
        self.data.qvel[:] = 0 if v is None else v
        mujoco.mj_fwdPosition(self.model, self.data)
        mujoco.mj_fwdVelocity(self.model, self.data)

    def column(self, joint):
        return int(self.model.jnt_dofadr[self.model.joint(joint).id])

    def integrate(self, q, step):
        found = q.copy()
        mujoco.mj_integratePos(self.model, found, step, 1.0)
        return found

    def value(self, q):
        return q[self.at]

    def gap(self, q):
        self._place(q)
        found = np.zeros((len(self.loops), 3))
        for k, _, point, sign in self._points():
            found[k] += sign * point
        return np.concatenate([found.ravel(), self._couplings(q)])

    def jacobian(self, q):
        self._place(q)
        found = np.zeros((len(self.loops), 3, self.model.nv))
        for k, body, point, sign in self._points():
            J = np.zeros((3, self.model.nv))
            mujoco.mj_jac(self.model, self.data, J, None, point, body)
            found[k] += sign * J
        rows = np.zeros((len(self.coupled), self.model.nv))
        for row, (y, x, _, c1) in zip(rows, self.coupled, strict=True):
            row[self.model.jnt_dofadr[[y, x]]] = 1.0, -c1
        return np.vstack([found.reshape(-1, self.model.nv), rows])

    def drift(self, q, v):
        self._place(q, v)
        found = np.zeros((len(self.loops), 3))
        for k, body, point, sign in self._points():
            J = np.zeros((3, self.model.nv))
            mujoco.mj_jacDot(self.model, self.data, J, None, point, body)
            found[k] += sign * J @ v
        return np.concatenate([found.ravel(), np.zeros(len(self.coupled))])

    def inverse(self, q, v, a):
        self._place(q, v)
        self.data.qacc[:] = a
        mujoco.mj_inverse(self.model, self.data)
        return self.data.qfrc_inverse.copy()
