"""Exudyn: mass points, distance constraints; a function before each step sets the driven lengths and reads the multipliers.

Generalised alpha with the spectral radius 0.8: 0.6 to 0.9 gave the same errors after the start, 1.0 does not settle. The
time is that of the steps.
"""

from __future__ import annotations

import time

import exudyn as exu
import numpy as np
from _case import DURATION, STEPS, changes, course, driven, times, truss
from _exudyn import options_of
from exudyn import itemInterface

VERSION = exu.__version__


def settings(case: str, n: int) -> list[dict]:
    del case, n
    return [{"name": "driven distances, generalised alpha", "steps": STEPS}]


def prepare(case: str, n: int, setting: dict):
    del case, setting
    bars = truss(n)
    container = exu.SystemContainer()
    system = container.AddSystem()
    objects = _assembled(system, bars)
    options = options_of(STEPS, DURATION, system.systemData.SystemSize(), radius=0.8)
    options.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    moved = driven(bars)
    lengths = bars.lengths[moved] + course(times())[0][:, None] * changes(bars)[moved]
    tension = np.empty((STEPS + 1, len(bars.ends)))

    def before(mbs, t):
        step = round(t * STEPS / DURATION)  # the end of the step
        tension[step - 1] = mbs.systemData.GetAECoordinates()
        for k, length in zip(moved, lengths[step], strict=True):
            mbs.SetObjectParameter(objects[k], "distance", length)
        return True

    system.SetPreStepUserFunction(before)

    def run():
        for k in moved:
            system.SetObjectParameter(objects[k], "distance", bars.lengths[k])
        solver = exu.MainSolverImplicitSecondOrder()
        solver.InitializeSolver(system, options)
        began = time.perf_counter()
        done = solver.SolveSteps(system, options)
        seconds = time.perf_counter() - began
        solver.FinalizeSolver(system, options)
        if not done:
            raise ArithmeticError("Exudyn's solver gave up")
        tension[-1] = system.systemData.GetAECoordinates()
        return seconds, STEPS, tension

    run.kept = container
    return run


def _assembled(system, bars) -> list[int]:
    """Numbers of the constraints of the bars."""
    markers = []
    for at, held, mass, force in zip(bars.points.tolist(), bars.fixed, bars.lump.tolist(), bars.force, strict=True):
        if held:
            number = system.AddNode(itemInterface.NodePointGround(referenceCoordinates=at))
        else:
            number = system.AddNode(itemInterface.NodePoint(referenceCoordinates=at))
            system.AddObject(itemInterface.ObjectMassPoint(physicsMass=mass, nodeNumber=number))
        markers.append(system.AddMarker(itemInterface.MarkerNodePosition(nodeNumber=number)))
        if not held:
            load = (force + mass * bars.gravity).tolist()
            system.AddLoad(itemInterface.LoadForceVector(markerNumber=markers[-1], loadVector=load))
    objects = [
        system.AddObject(itemInterface.ObjectConnectorDistance(markerNumbers=[markers[i], markers[j]], distance=length))
        for (i, j), length in zip(bars.ends.tolist(), bars.lengths.tolist(), strict=True)
    ]
    system.Assemble()
    return objects
