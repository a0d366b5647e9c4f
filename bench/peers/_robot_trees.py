"""The robot of five freedoms as a tree of rigid bodies: Pinocchio and MuJoCo give accelerations, integrators of order 4 and 8.

Fixed steps: the classical Runge-Kutta method, for MuJoCo its own. Error control: SciPy's DOP853 on the same right-hand side.
"""

from __future__ import annotations

import numpy as np
from _robots import CENTRE, END, INERTIA, MASS, RATES, START, robot_drives
from scipy.integrate import DOP853

STEPS = (25, 50, 100, 200, 400)
TOLERANCES = (1e-6, 1e-7, 1e-8, 3e-9, 1e-9, 1e-10)
JOINTS = (("slide", "0 0 1"), ("hinge", "0 0 1"), ("hinge", "0 1 0"), ("slide", "0 1 0"), ("hinge", "1 0 0"))


def settings() -> list[tuple[str, float]]:
    """Methods with their steps or tolerances, coarse to fine."""
    return [("RK4", float(n)) for n in STEPS] + [("DOP853", rtol) for rtol in TOLERANCES]


def prepared(code: str, method: str, fine: float):
    """A function that runs to 0.8 s and gives the five coordinates."""
    if code == "mujoco" and method == "RK4":
        return _mujoco_steps(int(fine))
    acceleration = {"pinocchio": _pinocchio, "mujoco": _mujoco}[code]()
    if method == "RK4":
        return lambda: _classical(acceleration, int(fine))
    return lambda: _controlled(acceleration, fine)


def _pinocchio():
    import pinocchio as pin

    model = pin.Model()
    kinds = (pin.JointModelPZ(), pin.JointModelRZ(), pin.JointModelRY(), pin.JointModelPY(), pin.JointModelRX())
    bodies, last = {1: 0, 3: 1, 4: 2}, 0
    for k, kind in enumerate(kinds):
        last = model.addJoint(last, kind, pin.SE3.Identity(), f"joint{k}")
        if k in bodies:
            i = bodies[k]
            model.appendBodyToJoint(last, pin.Inertia(MASS[i], CENTRE[i], np.diag(INERTIA[i])), pin.SE3.Identity())
    data = model.createData()
    return lambda t, q, v: pin.aba(model, data, q, v, robot_drives(t))


def _mujoco_model(steps: int):
    import mujoco

    joints = [f'<joint type="{kind}" axis="{axis}"/>' for kind, axis in JOINTS]
    inertial = [
        f'<inertial pos="{c[0]} {c[1]} {c[2]}" mass="{m}" diaginertia="{i[0]} {i[1]} {i[2]}"/>'
        for m, c, i in zip(MASS, CENTRE, INERTIA, strict=True)
    ]
    text = (
        f'<mujoco><compiler angle="radian" boundmass="0" boundinertia="0"/><option timestep="{END / steps!r}" integrator="RK4" '
        f'gravity="0 0 -9.81"/><worldbody><body>{joints[0]}{joints[1]}{inertial[0]}<body>{joints[2]}{joints[3]}{inertial[1]}'
        f"<body>{joints[4]}{inertial[2]}</body></body></body></worldbody></mujoco>"
    )
    model = mujoco.MjModel.from_xml_string(text)
    return mujoco, model, mujoco.MjData(model)


def _mujoco():
    mujoco, model, data = _mujoco_model(100)

    def acceleration(t, q, v):
        data.qpos[:], data.qvel[:], data.qfrc_applied[:] = q, v, robot_drives(t)
        mujoco.mj_forward(model, data)
        return data.qacc.copy()

    return acceleration


def _mujoco_steps(steps: int):
    mujoco, model, data = _mujoco_model(steps)

    def drive(_, data):
        data.qfrc_applied[:] = robot_drives(data.time)

    def run():
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = START, RATES
        mujoco.set_mjcb_control(drive)
        try:
            for _ in range(steps):
                mujoco.mj_step(model, data)
        finally:
            mujoco.set_mjcb_control(None)
        return data.qpos.copy()

    return run


def _classical(acceleration, steps: int) -> np.ndarray:
    q, v, h = START, RATES, END / steps
    for k in range(steps):
        t = k * h
        a1 = acceleration(t, q, v)
        v2 = v + 0.5 * h * a1
        a2 = acceleration(t + 0.5 * h, q + 0.5 * h * v, v2)
        v3 = v + 0.5 * h * a2
        a3 = acceleration(t + 0.5 * h, q + 0.5 * h * v2, v3)
        v4 = v + h * a3
        a4 = acceleration(t + h, q + h * v3, v4)
        q = q + h / 6 * (v + 2 * v2 + 2 * v3 + v4)
        v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    return q


def _controlled(acceleration, rtol: float) -> np.ndarray:
    def rates(t, y):
        return np.concatenate([y[5:], acceleration(t, y[:5], y[5:])])

    solver = DOP853(rates, 0.0, np.concatenate([START, RATES]), END, rtol=rtol, atol=rtol)
    while solver.status == "running":
        solver.step()
    return solver.y[:5]
