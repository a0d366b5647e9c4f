"""Static analyses as runs: poses at rest are counted along the time axis, a structure that stands still is one sample."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss import dynamics, flexible, kinematics, statics
from kinetruss.dynamics.bar_actions import acting_along, action_coordinates, action_variables, actions_of, take_off
from kinetruss.dynamics.prescribed import at_rest
from kinetruss.errors import AnalysisError, InputError, few
from kinetruss.kernels.structure.structure import States
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.loads import case_loads
from kinetruss.model import LengthDrive, Model
from kinetruss.model.runs import FLEXIBLE
from kinetruss.results import Forces, Motion, Result, Status, variable
from kinetruss.results.wide_tables import coordinate_axes, force_units
from kinetruss.runs.plans import Block, Plan, judged, poses_under

if TYPE_CHECKING:
    from numpy.typing import NDArray


ELASTIC = ("statics.deflection", *FLEXIBLE)
"""Analyses of elastic members along a motion."""


def along(plan: Plan, motion: Motion) -> Block:
    """Forces of the poses of a motion at rest; or those of the motion with what elastic members make of it."""
    model = plan.model
    if plan.run.analysis in ELASTIC:
        return _elastic(plan, motion)
    system, t = compile(model), motion.arrays["time"].values
    rates = [name for name, one in motion.whole.data_vars.items() if "/s" in one.attrs.get("units", "")]
    motion = motion.with_(data=motion.whole.assign({name: 0.0 * motion.whole[name] for name in rates}))
    still = [at_rest(system, motion, case_loads(system, t, case, rotating=True)) for case in plan.cases]
    return judged(plan, motion, {forces.load_case: forces for forces in still})


def _elastic(plan: Plan, motion: Motion) -> Block:
    """Forces of a motion, with its deflection, corrected lengths, frequencies or vibration."""
    model, analysis = plan.model, plan.run.analysis
    options = plan.run.elastic.arguments(analysis) if analysis in FLEXIBLE else {}
    package, _, verb = analysis.partition(".")
    analyse = getattr({"statics": statics, "flexible": flexible}[package], verb)
    moving, found = {}, {}
    for case in plan.cases:
        forces = dynamics.inverse(model, motion, case, static=plan.full)
        one = analyse(model, forces, **options)
        own = slice(0, len(motion.arrays["time"].values))  # a vibration goes on after the motion
        found[forces.load_case] = one.with_(data=one.whole.isel(time=own))
        moving[forces.load_case] = forces.with_(message=one.message)
    return judged(plan, motion, moving).with_(statics=found)


def standing(plan: Plan) -> Block:
    """Poses one by one, or the one configuration of `statics.linear` and `statics.equilibrium`."""
    if plan.run.poses:
        return _poses(plan)
    return (_linear if plan.run.analysis == "statics.linear" else _equilibrium)(plan)


def _poses(plan: Plan) -> Block:
    """The poses that a run lists, up to the first that cannot be reached."""
    poses = poses_under(plan.origin, plan.condition, plan.run.poses)
    found, status, message = [], Status.COMPLETED, ""
    for case in plan.cases:
        try:
            forces = statics.at_poses(plan.model, poses, load_case=case)
        except AnalysisError as error:
            if error.result is None:
                raise InputError(str(error)) from None
            forces, status, message = error.result, Status.OUT_OF_REACH, str(error)
        found.append(forces.with_(status=status, message=f"{forces.message} {message}".strip()))
    motion = found[0].motion.with_(status=status, message=found[0].message)
    return judged(plan, motion, {forces.load_case: forces.with_(motion=motion) for forces in found})


def _equilibrium(plan: Plan) -> Block:
    """The equilibrium, and the forces in it as of a pose at rest."""
    case = plan.cases[0]
    found = statics.equilibrium(plan.model, load_case=case, tasks=plan.run.tasks or None, raise_on_failure=False)
    motion = resting(plan.model, found.whole["position"].values).with_(status=found.status, message=found.message)
    if not found.status.ok:
        none = motion.with_(data=motion.whole.isel(time=slice(0, 0)))
        return Block(motion=none, forces={}, sections={}, demand={}, verdict=None)
    system = compile(plan.model)
    forces = at_rest(system, motion, case_loads(system, np.zeros(1), case))
    return judged(plan, motion, {forces.load_case: forces}).with_(statics={forces.load_case: _timed(found)})


def _linear(plan: Plan) -> Block:
    """Small displacements, and the forces of the stiffness method. The place is that without displacement."""
    model, system = plan.model, compile(plan.model)
    found = {}
    for case in plan.cases:
        try:
            found[case or "all"] = statics.linear(model, load_case=case)
        except AnalysisError as error:
            raise InputError(f"{error} No digit of the result is certain, so there is none.") from None
    said = " ".join(dict.fromkeys(one.message for one in found.values() if one.message))
    place = np.array([node.at for node in model.whole.nodes.values()])
    motion = resting(model, place).with_(message=said)
    others = acting_between(system, tuple(found))
    forces = {} if others else {case: forces_of_linear(model, one, motion, case) for case, one in found.items()}
    if others:
        said = f"{said} Section forces are not computed: {few(sorted(others), 4)} on members, between their joints."
        motion = motion.with_(message=said.strip())
    if not forces:
        block = Block(motion=motion, forces={}, sections={}, demand={}, verdict=None)
    else:
        block = judged(plan, motion, forces)
    return block.with_(demand={}, statics={case: _timed(one) for case, one in found.items()})


def acting_between(system: System, cases: Collection[str]) -> set[str]:
    """What acts on members between their joints besides loads in some load cases, so that section forces are not computed."""
    # what turns the frame of a node acts on inner bars, which have no sections; beams have their forces from their shapes
    inner = {k for k, name in enumerate(system.members) if name in system.model.inner.bars}
    acting = [one for case in cases for one in actions_of(system, case).actions if one.member not in inner]
    return {one.source for one in acting if one.kind != "load"}


def resting(model: Model, place: NDArray[np.float64]) -> Motion:
    """A place (n_nodes, dim), m, as a motion of one sample at rest."""
    still = np.zeros((1, *place.shape))
    return kinematics.from_arrays(model, [0.0], place[None], still, still)


def forces_of_linear(model: Model, found: Result, motion: Motion, case: str) -> Forces:
    """Forces of the stiffness method as of one pose at rest; those of drives of lengths are minus their tensions."""
    kept = ["member_force", "end_force", "joint_force", "reaction", "reaction_moment", "held_force"]
    kept += ["reaction_own", "reaction_moment_own", "coupling_force"]
    kept += [f"{kind}_{what}" for kind in coordinate_axes(compile(model)) for what in ("force", "value")]
    kept += ["displacement"] if any(beam.kind == "elastic" for beam in model.whole.beams.values()) else []
    data = _timed(found).whole
    data = data[[name for name in kept if name in data]]
    drive = np.full((1, len(model.all_drives)), np.nan)
    for k, one in enumerate(model.all_drives.values()):
        if isinstance(one, LengthDrive):
            drive[0, k] = -float(data["member_force"].sel(member=one.bar).item())
    units, named = force_units(compile(model), "drive")
    data = data.assign(drive_force=variable(("time", "drive"), drive, units["drive"], "drive force or torque"))
    data = data.assign_coords({"drive": list(model.all_drives), **named})
    system, own = compile(model), model.cases.get(case)
    if actions_of(system, case).actions:
        data = _between(system, data, case if case in model.cases else None)
    gravity = (None if own is None else own.gravity) or model.gravity or (0.0,) * model.dim
    data.attrs = {"kind": "forces", "load_case": case, "not_unique": [], "at_rest": 1, "gravity": list(gravity)}
    return Forces(data=data, message=motion.message, provenance=found.provenance, motion=motion, load_case=case)


def _between(system: System, data: xr.Dataset, case: str | None) -> xr.Dataset:
    """Forces with the loads on members between their joints, which the joints do not have to pass on."""
    still = np.zeros((1, system.x0.size))
    states = States(system.x0.reshape(1, -1), still, still)
    loads = case_loads(system, np.zeros(1), case).at(states.x)
    drive, coupling = np.zeros((1, len(system.drives))), np.zeros((1, len(system.model.couplings)))
    found, acting = acting_along(system, loads, states, drive, coupling)
    joint = np.pad(data["joint_force"].values, ((0, 0), (0, 0), (0, 0), (0, 3 - system.dim)))
    take_off(joint, found, acting)
    data = data.assign(joint_force=data["joint_force"].copy(data=joint[..., : system.dim]))
    return data.assign(action_variables(system, acting)).assign_coords(action_coordinates(system, found))


def _timed(found: Result) -> Result:
    """A result of one configuration as one sample of a time axis."""
    data = found.whole.expand_dims("time").assign_coords(time=variable(("time",), np.zeros(1), "s", "time"))
    return found.with_(data=data.assign_attrs(found.whole.attrs))
