"""The reaction torque of screws about the axes of their members, as couples on the hubs at both ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import BodyCouple
from kinetruss.model.hubs import hub_of
from kinetruss.results.records import check_samples

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

    Examples
    --------
    >>> import kinetruss as kt
    >>> from math import cos, pi, sin
    >>> def ring(letter: str, radius: float, turn: float) -> dict[str, tuple[float, float, float]]:
    ...     angles = [k * pi / 3 + turn * (-1) ** k for k in range(6)]
    ...     return {f"{letter}{k}": (radius * cos(a), radius * sin(a), 0.0) for k, a in enumerate(angles)}
    >>> part = kt.Part(length=0.5, section=kt.Tube(outer=0.02, inner=0.016), material="steel_s235")
    >>> screw = kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.1)
    >>> leg = kt.Active(ends=("F0", "C"), base=part, tube=part, screw=screw)
    >>> model = kt.Model(
    ...     nodes={"C": kt.Node(at=(0, 0, 0.8), mass=20.0), **ring("F", 0.5, 0.4)}, fixed=list(ring("F", 0.5, 0.4)),
    ...     bars={f"L{k}": kt.Bar(ends=(f"F{k}", "C"), kind="driven", mass=0) for k in range(1, 6)}, active={"L0": leg},
    ...     hubs={"C": kt.Hub(arms=ring("L", 0.2, -0.4))}, gravity=(0, 0, -9.81),
    ... )
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"L0": 0.01}, duration=1.0), samples=5)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> couples = kt.actuators.screw_couples(model, motion, demand)
    >>> list(couples), couples["L0.torque.B"].body  # the other end is on the ground
    (['L0.torque.B'], 'C.hub')
    """
    if model.dim == 2:
        raise InputError("A planar model has no torque about the axis of a member. Make the model spatial.")
    time, position = motion.arrays["time"].values, motion.arrays["position"].values
    check_samples(motion)
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
            # of one instant: a constant couple
            table = {"times": tuple(time.tolist()), "moments": moments} if len(time) > 1 else {"moment": moments[0]}
            found[f"{name}.torque.{which}"] = BodyCouple(body=f"{hub}.hub", member=name, **table)
    return found
