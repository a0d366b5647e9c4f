"""Runs of which a study keeps some numbers: only as much is computed as these numbers need.

``forces`` : motion and member forces of a prescribed motion, as plain arrays (`dynamics.prepare`). ``judged`` : what `runs.run`
has without the same poses at rest, section forces and motor demands, which take most of the time of a small run. ``full`` :
all of it.
The numbers are those of `runs.run`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.prepared import Places, prepare
from kinetruss.errors import InputError
from kinetruss.mechanics import arrange, compile
from kinetruss.model import Model, turns
from kinetruss.model.runs import MISSION
from kinetruss.results import Arrays, Axes, Forces, Motion, variable
from kinetruss.runs.blocks import blocks
from kinetruss.runs.joining import Accumulator, in_memory, notes_of
from kinetruss.runs.missions import run_mission
from kinetruss.runs.plans import SIMULATED, Plan, plan
from kinetruss.runs.results import RunResult
from kinetruss.runs.running import run
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

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
    plain = job.run.analysis == "dynamics.inverse" and job.given is None and job.condition is None and _unit(job.model) in FORCE
    if not plain or job.run.trajectory is None or len(job.times) > job.block or system.inner.nodes or not arrange(system).plan:
        return None
    ready = {case or "all": prepare(job.model, case) for case in job.cases}
    places = next(iter(ready.values())).follow(job.run.trajectory, times=job.times)
    if not len(places.t):
        return None
    forces = {}
    for case, one in ready.items():
        try:
            found = one.forces(places)
        except InputError:  # the positions are not in balance, of which the message of the forces tells
            return None
        if found.not_unique.any():
            return None  # of which it tells too
        forces[case] = (found.member_force, found.drive_force)
    whole = run_of_arrays(job.model, job.name, places, forces)
    return replace(whole, samples=len(job.times))


def run_of_arrays(model: Model, name: str, places: Places, forces: Mapping[str, tuple[Floats, Floats]]) -> RunResult:
    """A run of a motion, and by load case of the forces (times, members) and (times, drives), N or N m."""
    axes, unit = _axes(model), _unit(model)
    nodal, driven = ("time", "node", "axis"), ("time", "drive")
    x, v, a = (one[..., : model.dim] for one in (places.position, places.velocity, places.acceleration))
    moved = {
        "position": variable(nodal, x, "m", "node position"),
        "velocity": variable(nodal, v, "m/s", "node velocity"),
        "acceleration": variable(nodal, a, "m/s^2", "node acceleration"),
        "drive_position": variable(driven, places.drive_position, unit, "drive coordinate"),
        "drive_velocity": variable(driven, places.drive_velocity, f"{unit}/s", "drive rate"),
    }
    motion = Motion(data=Arrays(axes, places.t, moved, {}).later, status=places.status, message=places.message)
    found = {}
    for case, (member, drive) in forces.items():
        carried = {
            "member_force": variable(("time", "member"), member, "N", "mean axial force, tension positive"),
            "drive_force": variable(driven, drive, FORCE[unit], "drive force or torque"),
        }
        found[case] = Forces(data=Arrays(axes, places.t, carried, {}).later, motion=motion, load_case=case)
    return RunResult(
        model=model,
        given=model,
        name=name,
        motion=motion,
        forces=found,
        status=places.status,
        message=places.message,
        samples=len(places.t),
    )


def _axes(model: Model) -> Axes:
    names = {
        "node": list(model.nodes),
        "member": list(model.members),
        "drive": list(model.all_drives),
        "axis": list("xyz"[: model.dim]),
    }
    return Axes({axis: np.array(own, dtype=object).astype(str) for axis, own in names.items()})


def _unit(model: Model) -> str:
    """The unit of the positions of all drives; empty if they have several."""
    units = {"rad" if turns(one) else "m" for one in model.all_drives.values()}
    return units.pop() if len(units) == 1 else "" if units else "m"
