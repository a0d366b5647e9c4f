"""MuJoCo: particles on slides, bars as tendons; driven equalities in every step, or `mj_inverse` and an own solution.

The second gets positions, velocities and accelerations from elsewhere; its time leaves them out.
"""

from __future__ import annotations

import time

import mujoco
import numpy as np
from _case import DURATION, STEPS, changes, course, driven, right, times, truss

VERSION = mujoco.__version__
SHARP = "0.9999 0.9999 0.001"
SLIDES = "".join(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))


def settings(case: str, n: int) -> list[dict]:
    del case, n
    names = ("driven equalities, implicitfast", "driven equalities, RK4", "mj_inverse and own solution, motion given")
    return [{"name": name, "steps": STEPS} for name in names]


def prepare(case: str, n: int, setting: dict):
    del case
    bars = truss(n)
    if setting["name"].startswith("mj_inverse"):
        return _inverse(mujoco.MjModel.from_xml_string(_text(bars, "implicitfast", equal=False)), bars, n)
    model = mujoco.MjModel.from_xml_string(_text(bars, setting["name"].rpartition(" ")[2], equal=True))
    return _stepped(model, bars)


def _stepped(model, bars):
    data = mujoco.MjData(model)
    moved, push = driven(bars), bars.force[~bars.fixed].reshape(-1)
    change = course(times())[0][:, None] * changes(bars)[moved]

    def run():
        mujoco.mj_resetData(model, data)
        data.qfrc_applied[:] = push
        tension = np.full((STEPS + 1, len(bars.ends)), np.nan)
        began = time.perf_counter()
        for step in range(STEPS + 1):
            model.eq_data[moved, 0] = change[step]
            mujoco.mj_step(model, data)
            tension[step] = -data.efc_force[: len(bars.ends)]
        seconds = time.perf_counter() - began
        if any(warning.number for warning in data.warning):  # it resets itself and carries on
            raise ArithmeticError("MuJoCo warned of an unstable simulation")
        return seconds, STEPS, tension

    return run


def _inverse(model, bars, n: int):
    data = mujoco.MjData(model)
    free, push = ~bars.fixed, bars.force[~bars.fixed].reshape(-1)
    position, velocity, acceleration = (each[:, free].reshape(STEPS + 1, -1) for each in right(n)[:3])
    position = position - bars.points[free].reshape(-1)
    count = len(bars.ends)
    places = model.ten_J_rownnz, model.ten_J_rowadr, model.ten_J_colind.reshape(-1)

    def run():
        tension = np.empty((STEPS + 1, count))
        began = time.perf_counter()
        for step in range(STEPS + 1):
            data.qpos[:], data.qvel[:], data.qacc[:] = position[step], velocity[step], acceleration[step]
            mujoco.mj_inverse(model, data)
            rows = np.zeros((count, model.nv))
            mujoco.mju_sparse2dense(rows, data.ten_J.reshape(-1), *places)
            tension[step] = np.linalg.solve(rows.T, push - data.qfrc_inverse)
        return time.perf_counter() - began, STEPS, tension

    return run


def _text(bars, integrator: str, *, equal: bool) -> str:
    """A particle on three slides for each free node, a tendon for each bar, an equality for each tendon."""
    step = DURATION / STEPS
    bodies = []
    for i, (x, y, z) in enumerate(bars.points.tolist()):
        slides = (
            "" if bars.fixed[i] else "".join(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))
        )
        mass = "" if bars.fixed[i] else f'<inertial pos="0 0 0" mass="{float(bars.lump[i])!r}" diaginertia="1e-3 1e-3 1e-3"/>'
        bodies.append(f'<body pos="{x!r} {y!r} {z!r}">{slides}{mass}<site name="n{i}"/></body>')
    tendons = [
        f'<spatial name="t{k}"><site site="n{i}"/><site site="n{j}"/></spatial>' for k, (i, j) in enumerate(bars.ends.tolist())
    ]
    law = f'solref="{2 * step!r} 1" solimp="{SHARP}"'
    equalities = [f'<tendon tendon1="t{k}" {law}/>' for k in range(len(tendons))] if equal else []
    gravity = " ".join(repr(float(g)) for g in bars.gravity)
    return (
        '<mujoco><compiler angle="radian" boundmass="0" boundinertia="0"/>'
        f'<option timestep="{step!r}" integrator="{integrator}" solver="Newton" tolerance="1e-12" gravity="{gravity}">'
        f'<flag contact="disable"/></option><worldbody>{"".join(bodies)}</worldbody>'
        f"<tendon>{''.join(tendons)}</tendon><equality>{''.join(equalities)}</equality></mujoco>"
    )
