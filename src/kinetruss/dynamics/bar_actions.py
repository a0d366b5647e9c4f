"""Actions on the bars of a model: found once, evaluated along a motion, subtracted from joint forces."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.action_couples import actions_of_drives, actions_of_hinges
from kinetruss.dynamics.actions import Acting, Action, CarriedBy, Instants, NotOnBars, evaluate
from kinetruss.dynamics.bearing_friction import actions_of_bearings
from kinetruss.dynamics.hub_arms import (
    actions_of_bodies,
    actions_of_friction,
    actions_of_hubs,
    actions_of_loads,
    couples_through_members,
)
from kinetruss.kernels.structure.structure import ANGLE, States
from kinetruss.mechanics import System, cached, compile, ends_of
from kinetruss.mechanics.bars import bars_of
from kinetruss.mechanics.elements import named_motions
from kinetruss.model import NodalForce
from kinetruss.model.data import FORCE_ELEMENTS
from kinetruss.results import Column, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.loads import Loads
    from kinetruss.model import Model


TENSING = ("drive", "coupling", *FORCE_ELEMENTS, "hub", "hinge")
"""Kinds of actions that may add to the mean axial force of a member."""


@dataclass(frozen=True, kw_only=True, eq=False)
class BarActions:
    """Actions of one load case in the order of the members; names (k,), each once; actions that no bar carries."""

    actions: tuple[Action, ...]
    names: tuple[str, ...]
    loose: tuple[NotOnBars, ...]


@cached()
def actions_of(system: System, case: str) -> BarActions:
    """All actions on bars besides their own weight and inertia. case : name of a load case, else all loads act."""
    model = system.model
    chosen = model.cases[case].loads if case in model.cases else None
    loads = list(model.loads) if chosen is None else list(chosen)
    on_bodies = any(not isinstance(model.loads[name], NodalForce) for name in loads)
    records = len(system.measures) or model.bodies or model.hubs or model.bearings
    if not (records or np.any(system.row_kind == ANGLE) or on_bodies or system.friction.any()):
        return BarActions(actions=(), names=(), loose=())
    bars = bars_of(system)
    found = [
        *actions_of_drives(system, bars),
        *actions_of_bodies(system, bars),
        *actions_of_loads(system, bars, loads),
        *actions_of_friction(system),
        *actions_of_hubs(system),
        *actions_of_hinges(system, bars),
        *couples_through_members(system, loads),
        *actions_of_bearings(system),
    ]
    actions = sorted((one for one in found if isinstance(one, Action)), key=lambda one: one.member)
    met: Counter[str] = Counter()
    names = []
    for one in actions:
        name = f"{one.source} on {system.members[one.member]}"
        met[name] += 1
        names.append(name if met[name] == 1 else f"{name} ({met[name]})")
    loose = tuple(dict.fromkeys(one for one in found if isinstance(one, NotOnBars)))
    return BarActions(actions=tuple(actions), names=tuple(names), loose=loose)


def not_on_bars(model: Model, case: str = "all") -> tuple[NotOnBars, ...]:
    """Actions on nodes that cannot be assigned to one bar: they may bend members there.

    Parameters
    ----------
    case : name of a load case; else all loads act.

    Returns
    -------
    Drives, couplings, loads and bodies, each with its nodes and the members whose bending is unknown.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0), "P": (1, 0), "Q": (0.5, 0.5), "G": (0, 1)}
    >>> frame = kt.Model(nodes=corners, fixed=["O", "G"], bars={"up": ("O", "Q"), "on": ("Q", "P"), "tie": ("G", "P")},
    ...                  drives={"turn": kt.HingeDrive(axis="O", start="G", end="P")})
    >>> [(one.source, one.nodes, one.members) for one in kt.dynamics.not_on_bars(frame)]
    [('turn', ('P', 'O'), ('up', 'on', 'tie'))]
    """
    return actions_of(compile(model), case).loose


def acting_along(
    system: System,
    loads: Loads,
    states: States,
    drive: NDArray[np.float64],
    coupling: NDArray[np.float64],
    element: NDArray[np.float64] | None = None,
    carried: CarriedBy | None = None,
) -> tuple[BarActions, Acting]:
    """Actions along a motion, from the forces of drives, couplings and elements on coordinates (times, ...) and those of
    truss bars.

    Forces of elements follow from their laws if none are given.
    """
    x, v, a = (y.reshape(len(y), prod(y.shape[1:]) // 3, 3) for y in states)
    element = named_motions(system, x, v).force if element is None else element
    own = system.model.force_elements
    keys = [("drive", one) for one in system.drives] + [("coupling", one) for one in system.model.couplings]
    keys += [(own[name][0], name) for name in system.force_elements]
    amounts = dict(zip(keys, np.concatenate([drive, coupling, element], axis=1).T, strict=True))
    here = Instants(system=system, x=x, v=v, a=a, gravity=loads.gravity, amounts=amounts, loads=loads, carried=carried)
    found = actions_of(system, loads.name)
    return found, evaluate(found.actions, here)


def mean_tension_at_rest(
    system: System,
    loads: Loads,
    x: NDArray[np.float64],
    drive: NDArray[np.float64],
    coupling: NDArray[np.float64],
    carried: CarriedBy,
    element: NDArray[np.float64] | None = None,
) -> NDArray[np.float64]:
    """`mean_tension` (members,) at positions x (n, 3), under loads there, from the forces of drives (drives,), couplings and
    elements on coordinates, and those of truss bars and supports, one sample each.

    Forces of elements follow from their laws if none are given.
    """
    still = np.zeros((1, x.size))
    given = (drive[None], coupling[None], None if element is None else element[None])
    found, acting = acting_along(system, loads, States(x.reshape(1, -1), still, still), *given, carried)
    return np.asarray(mean_tension(system, found.actions, acting, x[None])[0])


def adds_tension(action: Action) -> bool:
    """Whether it adds to the mean axial force of its member, which the row of the member does not hold."""
    return action.kind in TENSING and not action.counted


def mean_tension(system: System, actions: tuple[Action, ...], acting: Acting, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean axial force of each member by drives, couplings, elements and hubs (times, members), N: f_A . u - (1 - s) q . u."""
    found = np.zeros((len(x), len(system.members)))
    kept = [k for k, action in enumerate(actions) if adds_tension(action)]
    member = np.array([actions[k].member for k in kept], np.int64)
    u = ends_of(system, x.reshape(len(x), prod(x.shape[1:]) // 3, 3), member)[2]
    ends, left = acting.worth[:, kept], 1.0 - acting.place[:, kept]
    np.add.at(found.T, member, np.sum((ends[:, :, 0] - left[:, :, None] * ends.sum(axis=2)) * u, axis=2).T)
    return found


def take_off(joint: NDArray[np.float64], found: BarActions, acting: Acting) -> None:
    """Subtract the actions on members from the joint forces (times, members, 2, 3)."""
    for k, action in enumerate(found.actions):
        if not action.counted:
            joint[:, action.member] -= acting.worth[:, k]


def action_variables(system: System, acting: Acting) -> dict[str, Column]:
    """Variables of actions in a Forces record; empty if there are none."""
    if not acting.place.shape[1]:
        return {}
    dim, turns = system.dim, slice(2, 3) if system.dim == 2 else slice(0, 3)
    per = ("time", "action")
    return {
        "action_force": variable((*per, "end", "axis"), acting.worth[..., :dim], "N", "equivalent forces at A, B"),
        "action_couple": variable((*per, "rotation"), acting.couple[..., turns], "N m", "couple on the member at the place"),
        "action_place": variable(per, acting.place, "", "place, fraction from A; NaN: spread along the member"),
    }


def action_coordinates(system: System, found: BarActions) -> dict[str, Any]:
    """Coordinates of these variables."""
    if not found.actions:
        return {}
    return {
        "action": np.array(found.names, dtype=object).astype(str),
        "action_member": ("action", np.array([system.members[one.member] for one in found.actions])),
        "action_source": ("action", np.array([f"{one.kind} {one.source}" for one in found.actions])),
        "rotation": ["z"] if system.dim == 2 else ["x", "y", "z"],
    }
