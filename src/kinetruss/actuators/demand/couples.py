"""The reaction torque of screws about the axes of their members, as couples on the hubs at both ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import BodyCouple
from kinetruss.model.hubs import hub_of

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Demand, Motion

__all__ = ["screw_couples"]


def screw_couples(model: Model, motion: Motion, demand: Demand) -> dict[str, BodyCouple]:
    """The couples of screws on the hubs at the ends of active members, as loads.

    Parameters
    ----------
    motion, demand : of the same instants; the demand from `evaluate`.

    Returns
    -------
    Loads by name, ``MEMBER.torque.A`` and ``MEMBER.torque.B``: on the hub at end A the `axis_torque` along the member's axis,
    on the hub at end B its opposite; N m, in global axes. They enter through the member (`BodyCouple.member`), so that they
    twist it and twist and bend its arms. A node fixed to the ground, without hub, needs none.
    ``model.with_(loads=model.loads | couples)`` is the model for `dynamics.inverse`. The couples change the thrust, and with it
    the torque, by a share of about lead/(distance of the hub's joints): evaluate again for more digits.

    Raises
    ------
    InputError : a planar model; instants of another motion; an end that is no hub, which passes no moment.
    """
    if model.dim == 2:
        raise InputError("A planar model has no torque about the axis of a member. Make the model spatial.")
    time, position = motion.arrays["time"].values, motion.arrays["position"].values
    if not np.array_equal(time, demand.arrays["time"].values):
        raise InputError("Motion and demand have other instants. Evaluate the demand along this motion.")
    nodes, found = list(model.nodes), {}
    for k, name in enumerate(demand.arrays["active"].values.tolist()):
        torque = demand.arrays["axis_torque"].values[:, k]
        if name not in model.active or np.isnan(torque).any():
            continue
        ends = model.active[name].ends
        d = position[:, nodes.index(ends[1])] - position[:, nodes.index(ends[0])]
        along = torque[:, None] * d / np.linalg.norm(d, axis=1)[:, None]
        for which, end, sign in (("A", ends[0], 1.0), ("B", ends[1], -1.0)):
            hub = hub_of(model, end, name)
            if not hub and len(model.fixed.get(end, "")) == 3:
                continue
            if not hub:
                raise InputError(
                    f"{name!r} ends at node {end!r}, which passes no moment: nothing holds the torque of its screw. Give the "
                    f"node a hub with an arm for it: hubs={{{end!r}: kt.Hub(arms={{{name!r}: 0.05}})}}."
                )
            moments = tuple(map(tuple, (sign * along).tolist()))
            found[f"{name}.torque.{which}"] = BodyCouple(
                body=f"{hub}.hub", times=tuple(time.tolist()), moments=moments, member=name
            )
    return found
