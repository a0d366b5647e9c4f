"""What the kernels of section forces take, from a model and its forces."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels._sections import start_references
from kinetruss.model import Model
from kinetruss.results import Forces
from kinetruss.system import compile

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Histories", "histories"]


class Histories(NamedTuple):
    """Arguments of `section_forces` and `section_polynomials` up to the reference directions, in their order."""

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

    def cut(self, part: slice) -> Histories:
        """The samples of a slice."""
        return self._replace(
            position=self.position[part],
            velocity=self.velocity[part],
            acceleration=self.acceleration[part],
            joint_force=self.joint_force[part],
        )


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
    )
