"""OpenSeesPy: linear statics of the pose at every sample, with own inertia loads. It gets the motion from elsewhere."""

from __future__ import annotations

import time
from importlib.metadata import version

import numpy as np
import openseespy.opensees as ops
from _case import STEPS, right, truss

VERSION = version("openseespy")
STIFFNESS = 1e9  # E A, N; the forces of a determinate truss do not depend on it


def settings(case: str, n: int) -> list[dict]:
    del case, n
    return [{"name": "statics of every pose, motion and inertia loads given", "steps": STEPS}]


def prepare(case: str, n: int, setting: dict):
    del case, setting
    bars = truss(n)
    position, _, acceleration, _ = right(n)
    loads = bars.force + bars.lump[:, None] * (bars.gravity - acceleration)

    def run():
        tension = np.empty((STEPS + 1, len(bars.ends)))
        began = time.perf_counter()
        for step in range(STEPS + 1):
            tension[step] = _forces(bars, position[step].tolist(), loads[step].tolist())
        return time.perf_counter() - began, STEPS, tension

    return run


def _forces(bars, position, loads) -> list[float]:
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 3)
    ops.uniaxialMaterial("Elastic", 1, STIFFNESS)
    ops.timeSeries("Constant", 1)
    ops.pattern("Plain", 1, 1)
    for i, (at, load, held) in enumerate(zip(position, loads, bars.fixed, strict=True)):
        ops.node(i, *at)
        if held:
            ops.fix(i, 1, 1, 1)
        else:
            ops.load(i, *load)
    for k, (i, j) in enumerate(bars.ends.tolist()):
        ops.element("Truss", k, i, j, 1.0, 1)
    ops.system("BandGen")
    ops.numberer("RCM")
    ops.constraints("Plain")
    ops.integrator("LoadControl", 1.0)
    ops.algorithm("Linear")
    ops.analysis("Static")
    if ops.analyze(1) != 0:
        raise ArithmeticError("OpenSees' analysis failed")
    return [ops.basicForce(k)[0] for k in range(len(bars.ends))]
