"""Exudyn: nodes, consistent mass by one generic second-order object, distance constraints (natural coordinates).

Lumped chains use mass points; Andrews' mechanism planar rigid bodies with revolute joints. Generalised-alpha with the
spectral radius 0.9 (its default for such systems), modified Newton. The time is that of `SolveSteps`.
"""

from __future__ import annotations

import time

import exudyn as exu
import numpy as np
from _cases import Bars, Linkage, bars_of, linkage_of, state_of_angles
from _reference import mass_matrix
from exudyn import itemInterface

VERSION = exu.__version__
STEPS = {
    "n_four_bar": (100, 500, 1000, 5000, 20000), "chain": (100, 500, 1000, 5000), "chain_lumped": (100, 500, 1000, 5000),
    "andrews": (300, 3000, 10000, 30000, 100000),
}  # fmt: skip
DENSE = 30  # unknowns up to which its own dense solver is the faster one


def settings(case: str, n: int) -> list[dict]:
    del n
    return [{"name": "generalised alpha", "steps": steps} for steps in STEPS.get(case, ())]


def prepare(case: str, n: int, setting: dict):
    container = exu.SystemContainer()
    system = container.AddSystem()
    if case == "andrews":
        linkage = linkage_of(case, n)
        read, t_end = _bodies(system, linkage, case), linkage.t_end
    else:
        bars = bars_of(case, n)
        read, t_end = _nodes(system, bars), bars.t_end
    system.Assemble()
    steps = setting["steps"]
    options = options_of(steps, t_end, system.systemData.SystemSize())

    def run():
        solver = exu.MainSolverImplicitSecondOrder()
        solver.InitializeSolver(system, options)
        began = time.perf_counter()
        done = solver.SolveSteps(system, options)
        seconds = time.perf_counter() - began
        solver.FinalizeSolver(system, options)
        if not done:
            raise ArithmeticError("Exudyn's solver gave up")
        return seconds, steps, read()

    run.kept = container
    return run


def options_of(steps: int, t_end: float, unknowns: int, radius: float = 0.9):
    """Settings of generalised alpha with a spectral radius, without output."""
    options = exu.SimulationSettings()
    march = options.timeIntegration
    march.numberOfSteps, march.endTime, march.verboseMode = steps, t_end, 0
    march.generalizedAlpha.spectralRadius = radius
    march.newton.useModifiedNewton = True
    march.newton.relativeTolerance, march.newton.absoluteTolerance = 1e-9, 1e-11
    options.solutionSettings.writeSolutionToFile = False
    options.solutionSettings.sensorsStoreAndWriteFiles = False
    options.solutionSettings.solutionInformation = ""
    options.solutionSettings.solverInformationFileName = ""
    options.linearSolverType = exu.LinearSolverType.EXUdense if unknowns <= DENSE else exu.LinearSolverType.EigenSparse
    options.displayStatistics = options.displayComputationTime = False
    return options


def _nodes(system, bars: Bars):
    """Nodes, masses, weights, bars; gives the function that reads the free nodes' positions."""
    free, dim = np.flatnonzero(~bars.fixed), bars.points.shape[1]
    point = itemInterface.NodePoint2D if dim == 2 else itemInterface.NodePoint
    numbers, markers = {}, []
    for i, at in enumerate(bars.points.tolist()):
        if bars.fixed[i]:
            number = system.AddNode(itemInterface.NodePointGround(referenceCoordinates=(*at, 0.0)[:3]))
        else:
            number = system.AddNode(point(referenceCoordinates=at, initialVelocities=bars.velocity[i].tolist()))
        numbers[i] = number
        markers.append(system.AddMarker(itemInterface.MarkerNodePosition(nodeNumber=number)))
    mass = mass_matrix(bars)
    weight = (mass @ np.tile(bars.gravity, len(bars.points))).reshape(bars.points.shape)
    load = (weight + bars.force)[free]
    keep = (dim * free[:, None] + np.arange(dim)).reshape(-1)
    if bars.mass.any():
        _consistent(system, [numbers[i] for i in free], mass[keep][:, keep].tocsr(), load.reshape(-1))
    else:
        for i, force in zip(free, load.tolist(), strict=True):
            system.AddObject(itemInterface.ObjectMassPoint(physicsMass=float(bars.lump[i]), nodeNumber=numbers[i]))
            system.AddLoad(itemInterface.LoadForceVector(markerNumber=markers[i], loadVector=force))
    for (i, j), rigid, length in zip(bars.ends.tolist(), bars.rigid, bars.lengths.tolist(), strict=True):
        pair = [markers[i], markers[j]]
        if rigid:
            system.AddObject(itemInterface.ObjectConnectorDistance(markerNumbers=pair, distance=length))
        else:
            law = {"stiffness": bars.stiffness, "damping": bars.damping}
            system.AddObject(itemInterface.ObjectConnectorSpringDamper(markerNumbers=pair, referenceLength=length, **law))

    def read():
        return bars.points[free] + system.systemData.GetODE2Coordinates().reshape(-1, dim)

    return read


def _consistent(system, nodes: list[int], mass, load) -> None:
    matrix = exu.MatrixContainer()
    matrix.SetWithSparseMatrix(mass)
    system.AddObject(itemInterface.ObjectGenericODE2(nodeNumbers=nodes, massMatrix=matrix, forceVector=load))


def _bodies(system, linkage: Linkage, case: str):
    """Rigid bodies in the plane about their centres of mass, revolute joints; reads the angles."""
    ground = system.AddObject(itemInterface.ObjectGround())
    numbers, places = [], []
    for body in linkage.bodies:
        origin = np.array(body.hinge)
        if body.parent >= 0:
            origin = places[body.parent] + _turn(linkage.bodies[body.parent].angle) @ body.hinge
        places.append(origin)
        centre = origin + _turn(body.angle) @ body.centre
        node = system.AddNode(itemInterface.NodeRigidBody2D(referenceCoordinates=[*centre, body.angle]))
        rigid = itemInterface.ObjectRigidBody2D(physicsMass=body.mass, physicsInertia=body.inertia, nodeNumber=node)
        numbers.append(system.AddObject(rigid))

    def marker(k: int, at):
        own = np.array(at) - (0.0 if k < 0 else np.array(linkage.bodies[k].centre))
        return system.AddMarker(
            itemInterface.MarkerBodyRigid(bodyNumber=ground if k < 0 else numbers[k], localPosition=[*own, 0.0])
        )

    for i, body in enumerate(linkage.bodies):
        system.AddObject(
            itemInterface.ObjectJointRevolute2D(markerNumbers=[marker(body.parent, body.hinge), marker(i, (0.0, 0.0))])
        )
    for i, p, j, q in linkage.loops:
        system.AddObject(itemInterface.ObjectJointRevolute2D(markerNumbers=[marker(i, p), marker(j, q)]))
    if linkage.spring:
        i, p, at, stiffness, rest = linkage.spring
        pair = [marker(-1, at), marker(i, p)]
        system.AddObject(
            itemInterface.ObjectConnectorSpringDamper(markerNumbers=pair, stiffness=stiffness, referenceLength=rest)
        )
    system.AddLoad(itemInterface.LoadTorqueVector(markerNumber=marker(0, (0.0, 0.0)), loadVector=[0.0, 0.0, linkage.torque]))
    start = np.array([body.angle for body in linkage.bodies])
    return lambda: state_of_angles(case, start + system.systemData.GetODE2Coordinates()[2::3])


def _turn(angle: float) -> np.ndarray:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
