"""Pinocchio: bodies with hinges, point anchors for the loops, proximal constraint dynamics; the integrator is the user's.

Classical Runge-Kutta of order 4 with fixed steps, `constraintDynamics` or `lcaba` (recursive in the loops), and SciPy's
error-controlled DOP853 on the same right-hand side.
"""

from __future__ import annotations

import math
import time

import numpy as np
import pinocchio as pin
from _cases import Linkage, linkage_of, state_of_angles
from scipy.integrate import DOP853

VERSION = pin.__version__
STEPS = {"n_four_bar": (50, 100, 200, 500, 1000, 2000), "andrews": (300, 1000, 3000, 10000, 30000)}
FINEST = {"constraintDynamics": 10, "lcaba": 8}
TOLERANCES = {solver: [f * 10.0**-k for k in range(4, last + 1) for f in (1.0, 0.3)] for solver, last in FINEST.items()}
MU = {"constraintDynamics": 1e-12, "lcaba": 1e-6}  # the second loses digits below
LARGEST = {"constraintDynamics": 100, "lcaba": 1000}  # its memory grows as the cube: 147 MB at 50 loops, 5 GB at 200


def settings(case: str, n: int) -> list[dict]:
    if case not in STEPS:
        return []  # bars in space need a ball joint at each end: three times the coordinates, constraints by the dozen
    solvers = [solver for solver, most in LARGEST.items() if n <= most]
    fixed = [{"name": f"RK4 {solver}", "solver": solver, "steps": steps} for solver in solvers for steps in STEPS[case]]
    controlled = [
        {"name": f"DOP853 {solver}", "solver": solver, "rtol": rtol, "steps": 50}
        for solver in solvers
        for rtol in TOLERANCES[solver]
    ]
    return fixed + controlled


def prepare(case: str, n: int, setting: dict):
    linkage = linkage_of(case, n)
    acceleration, count = _right_hand_side(linkage, setting["solver"])
    angle, rate = linkage.relative()
    march = _controlled if "rtol" in setting else _fixed

    def run():
        began = time.perf_counter()
        q, steps = march(acceleration, np.zeros(count), rate, linkage.t_end, setting)
        seconds = time.perf_counter() - began
        return seconds, steps, state_of_angles(case, linkage.absolute(q + angle))

    return run


def _fixed(acceleration, q, v, t_end: float, setting: dict):
    steps = setting["steps"]
    h = t_end / steps
    for _ in range(steps):
        a1 = acceleration(q, v)
        v2 = v + (0.5 * h) * a1
        a2 = acceleration(q + (0.5 * h) * v, v2)
        v3 = v + (0.5 * h) * a2
        a3 = acceleration(q + (0.5 * h) * v2, v3)
        v4 = v + h * a3
        a4 = acceleration(q + h * v3, v4)
        q = q + (h / 6) * (v + 2 * v2 + 2 * v3 + v4)
        v = v + (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4)
    return q, steps


def _controlled(acceleration, q, v, t_end: float, setting: dict):
    count = len(q)

    def slope(_, y):
        return np.concatenate([y[count:], acceleration(y[:count], y[count:])])

    solver, steps = DOP853(slope, 0.0, np.concatenate([q, v]), t_end, rtol=setting["rtol"], atol=setting["rtol"]), 0
    while solver.status == "running":
        solver.step()
        steps += 1
    if solver.status != "finished":
        raise ArithmeticError("DOP853 gave up")
    return solver.y[:count], steps


def _right_hand_side(linkage: Linkage, solver: str):
    """Accelerations of angles counted from the start."""
    model, joints = _model(linkage)
    loops = pin.StdVec_RigidConstraintModel()
    for i, p, j, q in linkage.loops:
        at = [pin.SE3(np.eye(3), np.array([*point, 0.0])) for point in (p, q)]
        loops.append(
            pin.RigidConstraintModel(
                pin.ContactType.CONTACT_3D, model, joints[i], at[0], joints[j], at[1], pin.LOCAL_WORLD_ALIGNED
            )
        )
    data = model.createData()
    states = pin.StdVec_RigidConstraintData()
    for loop in loops:
        states.append(loop.createData())
    exact = pin.ProximalSettings(1e-10, MU[solver], 20)
    dynamics = pin.constraintDynamics if solver == "constraintDynamics" else pin.lcaba
    if solver == "constraintDynamics":
        pin.initConstraintDynamics(model, data, loops, states)
    else:
        pin.computeJointMinimalOrdering(model, data, loops)
    torque, spring = np.zeros(model.nv), linkage.spring
    torque[0] = linkage.torque
    if spring is None:
        return lambda q, v: dynamics(model, data, q, v, torque, loops, states, exact).copy(), model.nv
    body, point, ground, stiffness, rest = spring
    start, place = linkage.bodies[body].angle, model.joints[joints[body]].idx_v
    px, py = point
    gx, gy = ground[0] - linkage.bodies[body].hinge[0], ground[1] - linkage.bodies[body].hinge[1]

    def acceleration(q, v):  # the spring's body hangs on the ground: its torque is closed form
        c, s = math.cos(start + q[place]), math.sin(start + q[place])
        x, y = c * px - s * py, s * px + c * py
        dx, dy = gx - x, gy - y
        length = math.sqrt(dx * dx + dy * dy)
        torque[place] = stiffness * (length - rest) / length * (x * dy - y * dx)
        return dynamics(model, data, q, v, torque, loops, states, exact).copy()

    return acceleration, model.nv


def _model(linkage: Linkage):
    """Joint k turns body k; joint angles count from the start."""
    model, joints = pin.Model(), []
    model.gravity.linear = np.array([0.0, -linkage.gravity, 0.0])
    for i, (body, angle) in enumerate(zip(linkage.bodies, linkage.relative()[0], strict=True)):
        parent = 0 if body.parent < 0 else joints[body.parent]
        place = pin.SE3(pin.utils.rotate("z", float(angle)), np.array([*body.hinge, 0.0]))
        joint = model.addJoint(parent, pin.JointModelRZ(), place, f"j{i}")
        thin = np.diag([body.inertia / 2, body.inertia / 2, body.inertia])
        model.appendBodyToJoint(joint, pin.Inertia(body.mass, np.array([*body.centre, 0.0]), thin), pin.SE3.Identity())
        joints.append(joint)
    return model, joints
