"""What the kernels of section forces take, from a model and its forces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.actions.bar_actions import actions_of
from kinetruss.errors import InputError
from kinetruss.kernels.sections.sections import most_segments, start_references
from kinetruss.kinematics.given.own_motion import check_motion
from kinetruss.mechanics import System, compile
from kinetruss.model import Model
from kinetruss.results import Forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Histories", "histories"]


class Histories(NamedTuple):
    """Arguments of `section_forces` and `section_polynomials` up to the actions on bars, in their order."""

    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    joint_force: NDArray[np.float64]
    gravity: NDArray[np.float64]
    p: NDArray[np.int32]
    q: NDArray[np.int32]
    two_rods: NDArray[np.bool_]
    rods: NDArray[np.float64]
    orient: NDArray[np.int32]
    reference: NDArray[np.float64]
    acting: NDArray[np.int64]
    worth: NDArray[np.float64]
    place: NDArray[np.float64]
    spread: NDArray[np.bool_]

    def cut(self, part: slice) -> Histories:
        """The samples of a slice."""
        names = ("position", "velocity", "acceleration", "joint_force", "worth", "place")
        return self._replace(**{name: getattr(self, name)[part] for name in names})

    @property
    def segments(self) -> int:
        """Segments a part has at most."""
        return int(most_segments(self.acting, self.spread))


def histories(model: Model, forces: Forces) -> Histories:
    """Arrays behind forces; velocities and accelerations are zero for forces at rest, joint forces of bodies NaN.

    Raises
    ------
    InputError : forces of another model, or motion and forces of different instants.
    """
    system = compile(model)
    motion = forces.motion.data
    names, count = list(forces.data["member"].values), forces.data.sizes["time"]
    if names != list(system.members) or motion.sizes["node"] != len(system.nodes):
        raise InputError("The forces belong to a model with other nodes or members. Compute them for this model.")
    check_motion(system, forces.motion)
    if motion.sizes["time"] != count:
        raise InputError(f"{count} samples of forces but {motion.sizes['time']} of their motion. Cut both alike.")
    position = np.ascontiguousarray(motion["position"].values)
    if forces.data.attrs.get("at_rest", 0):
        velocity, acceleration = np.zeros_like(position), np.zeros_like(position)
    else:
        velocity, acceleration = (np.ascontiguousarray(motion[name].values) for name in ("velocity", "acceleration"))
    joint_force = np.ascontiguousarray(forces.data["joint_force"].values)
    if system.is_body.any():
        joint_force = joint_force.copy()
        joint_force[:, system.is_body] = np.nan  # how its mass is spread is not known, so neither is any section
    orient = [-1 if m.orientation is None else system.node_index(m.orientation) for m in model.members.values()]
    return Histories(
        position=position,
        velocity=velocity,
        acceleration=acceleration,
        joint_force=joint_force,
        gravity=np.array(forces.data.attrs["gravity"], float),
        p=system.p,
        q=system.q,
        two_rods=system.two_rods,
        rods=system.rods,
        orient=np.array(orient, np.int32),
        reference=start_references(system.x0[:, : model.dim], system.p, system.q),
        **_actions(system, forces),
    )


def _actions(system: System, forces: Forces) -> dict[str, Any]:
    """What acts on bars beside their weight and inertia, in the order of the members."""
    count = forces.data.sizes["time"]
    if "action" not in forces.data.coords:
        if actions_of(system, forces.load_case).actions:
            raise InputError("These forces do not say what acts on the bars: an older release wrote them. Compute them again.")
        acting = np.zeros(len(system.members) + 1, np.int64)
        nothing = np.zeros((count, 0, 2, system.dim)), np.zeros((count, 0)), np.zeros(0, np.bool_)
        return dict(zip(("acting", "worth", "place", "spread"), (acting, *nothing), strict=True))
    index = {name: k for k, name in enumerate(system.members)}
    on = [index[name] for name in forces.data["action_member"].values.tolist()]
    worth, place = (np.ascontiguousarray(forces.data[name].values) for name in ("action_force", "action_place"))
    acting = np.searchsorted(on, np.arange(len(index) + 1)).astype(np.int64)
    return {"acting": acting, "worth": worth, "place": place, "spread": np.isnan(place).any(axis=0)}
