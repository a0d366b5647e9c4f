"""Input of the kernels of section forces, from a model and its forces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.actions import actions_of
from kinetruss.errors import InputError
from kinetruss.kernels.sections.records import Histories, Members, Polynomials
from kinetruss.kernels.sections.sections import COEFFICIENTS, most_segments, section_polynomials
from kinetruss.kinematics.given import check_motion
from kinetruss.mechanics import System, compile, kept
from kinetruss.mechanics.configuration import rates_in_space
from kinetruss.mechanics.structure import orientation
from kinetruss.model import Model
from kinetruss.results import Forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Given", "histories"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Given:
    """The input of section forces."""

    members: Members
    histories: Histories

    def polynomials(self, samples: slice) -> Polynomials:
        """Section forces along all parts at some samples."""
        cut = Histories(*(values[samples] for values in self.histories))
        out = self.allocate(len(cut.position))
        section_polynomials(self.members, cut, out)
        return out

    def allocate(self, count: int) -> Polynomials:
        """Arrays for the polynomials of so many samples."""
        parts = len(self.members.p) + int(self.members.two_rods.sum())
        shape = (count, parts, self.members.segments)
        return Polynomials(np.empty((*shape, COEFFICIENTS)), np.empty(shape), np.empty(shape[:-1]))


def histories(model: Model, forces: Forces) -> Given:
    """Arrays behind forces; velocities and accelerations are zero for forces at rest, joint forces of bodies NaN.

    Velocities and accelerations are those in space: under a base that rotates not those of the motion.

    Raises
    ------
    InputError : forces of another model, or motion and forces of different instants.
    """
    system = compile(model)
    motion, found = forces.motion.arrays, forces.arrays
    names, count = found["member"].values.tolist(), len(found["time"].values)
    if names != list(system.members) or len(motion["node"].values) != len(system.nodes):
        raise InputError("The forces belong to a model with other nodes or members. Compute them for this model.")
    check_motion(system, forces.motion)
    if (samples := len(motion["time"].values)) != count:
        raise InputError(f"{count} samples of forces but {samples} of their motion. Cut both alike.")
    position = np.ascontiguousarray(motion["position"].values)
    if forces.attrs.get("at_rest", 0):
        velocity, acceleration = np.zeros_like(position), np.zeros_like(position)
    else:
        velocity, acceleration = (np.ascontiguousarray(motion[name].values) for name in ("velocity", "acceleration"))
    velocity, acceleration = rates_in_space(forces.attrs, found["time"].values, position, velocity, acceleration)
    joint_force = np.ascontiguousarray(found["joint_force"].values)
    if system.is_body.any():
        joint_force = joint_force.copy()
        joint_force[:, system.is_body] = np.nan  # the distribution of its mass is unknown, so it has no sections
    on, worth, place = _actions(system, forces)
    spread = np.any(np.isnan(place), axis=0)
    return Given(
        members=_members(system, tuple(forces.attrs["gravity"]), on, tuple(spread.tolist())),
        histories=Histories(position, velocity, acceleration, joint_force, worth, place),
    )


@kept()
def _members(system: System, gravity: tuple[float, ...], on: tuple[str, ...], spread: tuple[bool, ...]) -> Members:
    """The members of a model, under actions on these members; not to be written to."""
    index = {name: k for k, name in enumerate(system.members)}
    acting = np.searchsorted([index[name] for name in on], np.arange(len(index) + 1))
    orient, reference = orientation(system)
    clamped_ptr = np.searchsorted(system.clamped[:, 0], np.arange(2 * len(index) + 1))
    return Members.of(
        {
            "segments": most_segments(acting, np.array(spread, np.bool_), clamped_ptr),
            "p": system.p,
            "q": system.q,
            "orient": orient,
            "two_rods": system.two_rods,
            "acting": acting,
            "spread": spread,
            "clamped_ptr": clamped_ptr,
            "clamped": system.clamped[:, 1:],
            "rods": system.own_rods,
            "reference": reference,
            "gravity": [*gravity, *[0.0] * (3 - system.dim)],
        }
    )


def _actions(system: System, forces: Forces) -> tuple[tuple[str, ...], NDArray[np.float64], NDArray[np.float64]]:
    """Actions on bars besides their weight and inertia: members in order, equivalent forces and place as in `Histories`."""
    arrays = forces.arrays
    count = len(arrays["time"].values)
    if "action" not in arrays:
        if actions_of(system, forces.load_case).actions:
            raise InputError("These forces do not hold the actions on bars: an older release wrote them. Compute them again.")
        return (), np.zeros((count, 0, 2, system.dim)), np.zeros((count, 0))
    worth, place = (np.ascontiguousarray(arrays[name].values) for name in ("action_force", "action_place"))
    return tuple(arrays["action_member"].values.tolist()), worth, place
