"""MuJoCo: bodies with hinges and `connect` for the loops; chains as particles (lumped masses), bars as tendon equalities.

Newton's solver, constraint stiffness as sharp as the step allows (time constant two steps), tight tolerance.
"""

from __future__ import annotations

import math
import time

import mujoco
import numpy as np
from _cases import Bars, Linkage, bars_of, linkage_of, state_of_angles

VERSION = mujoco.__version__
SHARP = "0.9999 0.9999 0.001"
STEPS = {
    "n_four_bar": (100, 200, 500, 1000, 2000, 5000),
    "chain_lumped": (500, 1000, 2000, 5000),
    "andrews": (300, 1000, 3000, 10000, 30000, 100000),
}


def settings(case: str, n: int) -> list[dict]:
    del n
    return [{"name": method, "steps": steps} for method in ("implicitfast", "RK4") for steps in STEPS.get(case, ())]


def prepare(case: str, n: int, setting: dict):
    steps = setting["steps"]
    if case == "chain_lumped":
        bars = bars_of(case, n)
        model = mujoco.MjModel.from_xml_string(_particles(bars, bars.t_end / steps, setting["name"]))
        qvel, torque = np.zeros(model.nv), np.zeros(model.nv)
        torque[:] = bars.force[~bars.fixed].reshape(-1)
        read = lambda data: data.qpos + bars.points[~bars.fixed].reshape(-1)  # noqa: E731
    else:
        linkage = linkage_of(case, n)
        model = mujoco.MjModel.from_xml_string(_tree(linkage, linkage.t_end / steps, setting["name"]))
        order = np.array([model.joint(f"j{i}").qposadr[0] for i in range(len(linkage.bodies))])
        angle, rate = linkage.relative()
        qvel, torque = np.zeros(model.nv), np.zeros(model.nv)
        qvel[order] = rate
        torque[order[0]] = linkage.torque
        read = lambda data: state_of_angles(case, linkage.absolute(data.qpos[order] + angle))  # noqa: E731
    data = mujoco.MjData(model)

    def run():
        mujoco.mj_resetData(model, data)
        data.qvel[:] = qvel
        data.qfrc_applied[:] = torque
        began = time.perf_counter()
        mujoco.mj_step(model, data, steps)
        seconds = time.perf_counter() - began
        if any(warning.number for warning in data.warning):  # it resets itself and carries on
            raise ArithmeticError("MuJoCo warned of an unstable simulation")
        return seconds, steps, np.array(read(data))

    return run


def _head(step: float, integrator: str, gravity: str) -> str:
    return (
        f'<mujoco><compiler angle="radian" boundmass="0" boundinertia="0"/>'
        f'<option timestep="{step!r}" integrator="{integrator}" '
        f'solver="Newton" tolerance="1e-12" gravity="{gravity}"><flag contact="disable"/></option>'
    )


def _sharp(step: float) -> str:
    return f'solref="{2 * step!r} 1" solimp="{SHARP}"'


def _tree(linkage: Linkage, step: float, integrator: str) -> str:
    """The plane is x-z; angles turn from x to z."""
    angle, _ = linkage.relative()
    children: dict[int, list[int]] = {}
    for i, body in enumerate(linkage.bodies):
        children.setdefault(body.parent, []).append(i)

    def text(i: int) -> str:
        body = linkage.bodies[i]
        half, thin, flat = angle[i] / 2, 1e-3 * body.inertia, body.inertia
        sites = ""
        if linkage.spring and linkage.spring[0] == i:
            x, z = linkage.spring[1]
            sites = f'<site name="s" pos="{x!r} 0 {z!r}"/>'
        return (
            f'<body name="b{i}" pos="{body.hinge[0]!r} 0 {body.hinge[1]!r}" quat="{math.cos(half)!r} 0 {-math.sin(half)!r} 0">'
            f'<joint name="j{i}" type="hinge" axis="0 -1 0"/><inertial pos="{body.centre[0]!r} 0 {body.centre[1]!r}" '
            f'mass="{body.mass!r}" diaginertia="{flat!r} {flat!r} {thin!r}"/>'
            f"{sites}{''.join(map(text, children.get(i, [])))}</body>"
        )

    ground = springs = ""
    if linkage.spring:
        _, _, at, stiffness, rest = linkage.spring
        ground = f'<site name="g" pos="{at[0]!r} 0 {at[1]!r}"/>'
        law = f'stiffness="{stiffness!r}" springlength="{rest!r}"'
        springs = f'<tendon><spatial {law}><site site="s"/><site site="g"/></spatial></tendon>'
    loops = "".join(
        f'<connect body1="b{i}" body2="b{j}" anchor="{p[0]!r} 0 {p[1]!r}" {_sharp(step)}/>' for i, p, j, _ in linkage.loops
    )
    bodies = ground + "".join(map(text, children[-1]))
    gravity = f"0 0 {-linkage.gravity!r}"
    return f"{_head(step, integrator, gravity)}<worldbody>{bodies}</worldbody>{springs}<equality>{loops}</equality></mujoco>"


def _particles(bars: Bars, step: float, integrator: str) -> str:
    """A particle on three slides for each free node."""
    bodies, tendons, equal = [], [], []
    for i, (x, y, z) in enumerate(bars.points.tolist()):
        site = f'<site name="n{i}" pos="0 0 0"/>'
        if bars.fixed[i]:
            bodies.append(f'<body pos="{x!r} {y!r} {z!r}">{site}</body>')
            continue
        slides = "".join(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))
        inertial = f'<inertial pos="0 0 0" mass="{float(bars.lump[i])!r}" diaginertia="1e-3 1e-3 1e-3"/>'
        bodies.append(f'<body pos="{x!r} {y!r} {z!r}">{slides}{inertial}{site}</body>')
    for k, ((i, j), rigid, length) in enumerate(zip(bars.ends.tolist(), bars.rigid, bars.lengths.tolist(), strict=True)):
        law = "" if rigid else f'stiffness="{bars.stiffness!r}" damping="{bars.damping!r}" springlength="{length!r}"'
        tendons.append(f'<spatial name="t{k}" {law}><site site="n{i}"/><site site="n{j}"/></spatial>')
        if rigid:
            equal.append(f'<tendon tendon1="t{k}" {_sharp(step)}/>')
    gravity = " ".join(repr(float(g)) for g in bars.gravity)
    return (
        f"{_head(step, integrator, gravity)}<worldbody>{''.join(bodies)}</worldbody>"
        f"<tendon>{''.join(tendons)}</tendon><equality>{''.join(equal)}</equality></mujoco>"
    )
