"""Runs of which a study keeps some numbers: only as much is computed as these numbers need.

``forces`` : motion and member forces of a prescribed motion, as plain arrays (`dynamics.prepare`). ``judged`` : what `runs.run`
has without the same poses at rest, section forces and motor demands, which take most of the time of a small run. ``full`` :
all of it.
The numbers are those of `runs.run`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from kinetruss.dynamics.prepared import prepare
from kinetruss.errors import InputError
from kinetruss.mechanics import arrange, compile
from kinetruss.model import Model
from kinetruss.model.runs import MISSION
from kinetruss.results import Arrays, Axes, Forces, Motion, variable
from kinetruss.results.wide_tables import drive_unit
from kinetruss.runs.blocks import blocks
from kinetruss.runs.joining import Accumulator, in_memory, notes_of
from kinetruss.runs.missions import run_mission
from kinetruss.runs.plans import SIMULATED, Plan, plan
from kinetruss.runs.results import RunResult
from kinetruss.runs.running import run
from kinetruss.threads import one_thread

LEVELS = ("forces", "judged", "full")
"""How much of a run is computed, from the least."""
FORCE = {"m": "N", "rad": "N m"}
"""The unit of the force of drives, by that of their positions."""


@one_thread
def brief(model: Model, name: str, level: str, judged: bool = True) -> RunResult:
    """A run in memory at a level. judged : with the strength check.

    A run for which the least level is not enough, because its forces are not unique, its model has inner parts or it is no
    prescribed motion of one block, has the next one.
    """
    if model.runs[name].analysis == MISSION:
        return run_mission(model, name)
    if level == "full":
        return run(model, name)
    job = replace(plan(model, name), full=False, bare=not judged)
    found = _forces_alone(job) if level == "forces" and not judged else None
    if found is not None:
        return found
    computed = blocks(job)
    first = next(computed)
    if not first.last or job.run.analysis == SIMULATED:
        return _joined(job, [first, *computed])
    return RunResult(
        model=job.model,
        given=job.origin,
        name=job.name,
        motion=first.motion,
        forces=first.forces,
        statics=first.statics,
        verdict=first.verdict,
        status=first.motion.status,
        message=" ".join(notes_of(first)),
        samples=len(job.times),
    )


def _joined(job: Plan, found: Iterable[Any]) -> RunResult:
    accumulated, every = Accumulator(job.model), list(found)
    for block in every:
        accumulated.add(block)
    return in_memory(job, every, accumulated, 0.0)


def _forces_alone(job: Plan) -> RunResult | None:
    """Motion and forces of a run by `dynamics.prepare`; None if that is not enough."""
    system = compile(job.model)
    unit = drive_unit(system)[0]
    plain = job.run.analysis == "dynamics.inverse" and job.given is None and job.condition is None and unit in FORCE
    if not plain or job.run.trajectory is None or len(job.times) > job.block or system.inner.nodes or not arrange(system).plan:
        return None
    dim, axes = system.dim, _axes(job.model)
    ready = [prepare(job.model, case) for case in job.cases]
    places = ready[0].follow(job.run.trajectory, times=job.times)
    if not len(places.t):
        return None
    nodal, driven = ("time", "node", "axis"), ("time", "drive")
    moved = {
        "position": variable(nodal, places.position[..., :dim], "m", "node position"),
        "velocity": variable(nodal, places.velocity[..., :dim], "m/s", "node velocity"),
        "acceleration": variable(nodal, places.acceleration[..., :dim], "m/s^2", "node acceleration"),
        "drive_position": variable(driven, places.drive_position, unit, "drive coordinate"),
        "drive_velocity": variable(driven, places.drive_velocity, f"{unit}/s", "drive rate"),
    }
    motion = Motion(data=Arrays(axes, places.t, moved, {}).later, status=places.status, message=places.message)
    forces = {}
    for case, one in zip(job.cases, ready, strict=True):
        try:
            found = one.forces(places)
        except InputError:  # the positions are not in balance, of which the message of the forces tells
            return None
        if found.not_unique.any():
            return None  # of which the message of the forces tells
        carried = {
            "member_force": variable(("time", "member"), found.member_force, "N", "mean axial force, tension positive"),
            "drive_force": variable(driven, found.drive_force, FORCE[unit], "drive force or torque"),
        }
        data = Arrays(axes, places.t, carried, {}).later
        forces[case or "all"] = Forces(data=data, motion=motion, load_case=case or "all")
    return RunResult(
        model=job.model,
        given=job.origin,
        name=job.name,
        motion=motion,
        forces=forces,
        status=places.status,
        message=places.message,
        samples=len(job.times),
    )


def _axes(model: Model) -> Axes:
    system = compile(model)
    names = {"node": system.nodes, "member": system.members, "drive": system.drives, "axis": tuple("xyz"[: system.dim])}
    return Axes({axis: np.array(own, dtype=object).astype(str) for axis, own in names.items()})
