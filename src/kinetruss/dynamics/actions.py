"""Actions on bars between their ends besides their own weight and inertia: what they are, and on which bar they act.

The equations have forces on nodes only. The couple of a drive, the pin of a coupling in the middle of a bar, a load or a mass
on it enter them as equivalent forces f_A, f_B at the ends of the bar. Here each is put back at its place on the bar, as the
force q = f_A + f_B at a place s (a fraction from A) and the couple c = d x (f_B - s q) there, d from A to B; or spread along
the bar or a part of it, linear in xi, with the same f_A, f_B. The forces of the joints are reduced by as much: joint forces
balance the bar together with its actions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.kinds import spans_of
from kinetruss.elements.loads.load import Spread
from kinetruss.mechanics import System
from kinetruss.mechanics.elements import scalar_motions
from kinetruss.mechanics.frames import cross
from kinetruss.model.data import FORCE_ELEMENTS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.loads import Loads


GIVEN = ("load", "body", "friction", *FORCE_ELEMENTS, "hub", "bearing", "couple", "hinge")
"""Kinds of actions that follow from motion and loads alone; those of drives and couplings follow from their forces."""


def on_rods(ratio: tuple[float, float], nut: Any) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """What base and tube of an active member take of a load along it: its share, and its first moment about A over the length.

    ratio : amounts a length at both ends over the mean; nut : where the tube begins, as a fraction from A.
    """
    first, rise = ratio[0], ratio[1] - ratio[0]
    base = first * nut + rise * nut**2 / 2, first * nut**2 / 2 + rise * nut**3 / 3
    return base, (1.0 - base[0], first / 2 + rise / 3 - base[1])


class CarriedBy(NamedTuple):
    """What follows from solved forces: tension (t, members) N; support (t, n, 3) N on the structure, 0 at free nodes; couple
    (t, bearings, 3) N m on the members of bearings, without bearings at rest.
    """

    tension: NDArray[np.float64]
    support: NDArray[np.float64]
    couple: NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Instants:
    """The input of actions: x (t, n, 3) m; v, m/s, and a, m/s^2, (t, n, 3), or (1, n, 3) at rest; gravity (3,).

    amounts : of drives, couplings and springs, ``("drive", name)`` to (t,) N or N m. loads : nodal forces, those on bodies too.
    carried : the forces that load the arms of hubs; without them the actions on arms are NaN, and bearings do not rub.
    found : what several actions have in common, by name.
    """

    system: System
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    gravity: NDArray[np.float64]
    amounts: dict[tuple[str, str], NDArray[np.float64]]
    loads: Loads | None = None
    carried: CarriedBy | None = None
    found: dict[str, NDArray[np.float64]] = field(default_factory=dict, init=False)

    @cached_property
    def pin_torque(self) -> NDArray[np.float64]:
        """Torques of friction about pins (t, pairs), N m, of the pairs of `pins_of`."""
        x, v = (np.array(np.broadcast_to(y, self.x.shape)).reshape(len(self.x), -1) for y in (self.x, self.v))
        found: NDArray[np.float64] = -scalar_motions(self.system, x, v).force[:, spans_of(self.system)["friction"]]
        return found


@dataclass(frozen=True, kw_only=True, eq=False)
class Action:
    """An action on a member: forces, a couple, or both.

    source : name of a drive, coupling, load, body, hub or bearing, or of the node of a pin with friction; kind : which of them.
    member : index. place : the fraction from A, or a function for it (t,), or how it is spread.
    worth : function for the equivalent end forces f_A, f_B (t, 2, 3), N. couple : function for a couple (t, 3), N m, of which
        the part across the member counts: f_B = C x u/L = -f_A.
    counted : the row belongs to the member itself, so that its joint forces include the action.
    """

    source: str
    kind: str
    member: int
    place: float | Callable[[Instants], NDArray[np.float64]] | Spread
    worth: Callable[[Instants], NDArray[np.float64]] | None = None
    couple: Callable[[Instants], NDArray[np.float64]] | None = None
    counted: bool = False


@dataclass(frozen=True, kw_only=True)
class NotOnBars:
    """An action on nodes that cannot be assigned to one bar: it may bend members there.

    source, kind : as of `Action`. nodes, members : names; members are those whose bending is not known.
    """

    source: str
    kind: str
    nodes: tuple[str, ...]
    members: tuple[str, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Acting:
    """Values of actions: worth (t, k, 2, 3) N, place (t, k), NaN if spread, couple (t, k, 3) N m."""

    worth: NDArray[np.float64]
    place: NDArray[np.float64]
    couple: NDArray[np.float64]


def evaluate(actions: tuple[Action, ...], here: Instants) -> Acting:
    """Actions at some instants. A place beyond the ends of its bar counts as the end, with the couple of the arm."""
    count, system = len(here.x), here.system
    worth, place = np.zeros((count, len(actions), 2, 3)), np.full((count, len(actions)), np.nan)
    couple = np.zeros((count, len(actions), 3))
    for k, action in enumerate(actions):
        d = here.x[:, system.q[action.member]] - here.x[:, system.p[action.member]]
        spread = isinstance(action.place, Spread)
        if not spread:
            place[:, k] = np.clip(action.place(here), 0.0, 1.0) if callable(action.place) else min(max(action.place, 0.0), 1.0)
        if action.worth is not None:
            worth[:, k] = own = action.worth(here)
            if not spread:
                couple[:, k] = cross(d, own[:, 1] - place[:, k, None] * (own[:, 0] + own[:, 1]))
        if action.couple is not None:
            given = action.couple(here)
            square = np.vecdot(d, d)[:, None]
            across = cross(given, d)
            across /= square
            worth[:, k, 0] -= across
            worth[:, k, 1] += across
            if not spread:
                couple[:, k] += given
                if system.dim == 3:  # in the plane no part of it is along the member
                    couple[:, k] -= np.vecdot(given, d)[:, None] / square * d
    return Acting(worth=worth, place=place, couple=couple)
