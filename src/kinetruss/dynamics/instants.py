"""One instant of a motion and its forces, as small arrays: the input of free bodies and labelled systems."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.actions import Action, on_rods
from kinetruss.dynamics.bar_actions import acting_along, actions_of
from kinetruss.dynamics.hub_arms import bodies_on_bars, loads_of_hubs, of_two_masses
from kinetruss.elements.beam_matrices import mode_gradients
from kinetruss.elements.kinds import present
from kinetruss.elements.loads.load import Spread
from kinetruss.elements.local_axes import local_axes
from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import States
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import System, compile, direction_rates, measure_gradients
from kinetruss.mechanics.elements import element_forces, element_tangents, strained_forces
from kinetruss.mechanics.frames import source_of
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.rotating_base import rates_in_space
from kinetruss.mechanics.tables import body_masses, continua_mass
from kinetruss.model import Model

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.mechanics import BeamElements
    from kinetruss.results import Forces, Motion


LEFT = 1e-12
"""The part of a force that acts on no bar is round-off below this fraction of the force."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Rod:
    """A rod, or the planar body of a bar, at one instant.

    start, length : where it begins, from end A of its member, and how long it is, m. mass : kg. acceleration : (dim,) of its
    centre of mass, m/s^2. swing : (dim,) N m; u x swing is the rate of its angular momentum about its centre of mass.
    place : of the centre of a body or of a rod with masses on it, along the bar from end A and to its left, m; None of a rod
    whose centre is its middle.
    """

    name: str
    start: float
    length: float
    mass: float
    acceleration: NDArray[np.float64]
    swing: NDArray[np.float64]
    place: tuple[float, float] | None = None

    @property
    def centre(self) -> float:
        """Distance of the centre of mass from end A, along the member, m."""
        return self.start + self.length / 2 if self.place is None else self.place[0]

    @property
    def side(self) -> float:
        """Distance of the centre of mass from the member's axis, along axis 2, m."""
        return 0.0 if self.place is None else self.place[1]


@dataclass(frozen=True, kw_only=True, eq=False)
class OnBar:
    """An action on a member: force (dim,) N and couple (turns,) N m about member axes 2, 3, `at` m from A.

    on_tube : of an active member, on which a load along the whole is two actions; of the two the first has its worth.
    worth (2, dim) N : the equivalent forces at the ends, which do not act on its nodes.
    """

    action: Action
    at: float
    force: NDArray[np.float64]
    couple: NDArray[np.float64]
    worth: NDArray[np.float64]
    on_tube: bool = False

    @property
    def key(self) -> tuple[str, str]:
        """Kind and name of the source."""
        return self.action.kind, self.action.source


@dataclass(frozen=True, kw_only=True, eq=False)
class Instant:
    """x, v, a (n, dim), v and a in space where the base rotates; rate (n, dim): velocities relative to it; gravity (dim,),
    lump_gravity (n, dim); axes (m, dim, dim) member axes as rows; data: its forces.
    """

    system: System
    time: float
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    rate: NDArray[np.float64]
    gravity: NDArray[np.float64]
    lump_gravity: NDArray[np.float64]
    axes: NDArray[np.float64]
    loads: Loads
    data: xr.Dataset

    def length(self, i: int) -> float:
        """Present length of member i, m."""
        return float(np.linalg.norm(self.x[self.system.q[i]] - self.x[self.system.p[i]]))

    def _on_bars(self, worth: NDArray[np.float64], place: NDArray[np.float64]) -> tuple[OnBar, ...]:
        """Actions on members by their equivalent forces (k, 2, dim), N, and places (k,)."""
        made = []
        for action, ends, at in zip(actions_of(self.system, self.loads.name).actions, worth, place, strict=True):
            L, spread = self.length(action.member), isinstance(action.place, Spread)
            if isinstance(action.place, Spread) and self.system.two_rods[action.member]:
                nut = max(0.0, 1.0 - self.system.own_rods[action.member, 4] / L)
                none = np.zeros(1 if self.system.dim == 2 else 2)
                for tube, (share, first) in enumerate(on_rods(action.place.ratio or (1.0, 1.0), nut)):
                    force, own = share * ends.sum(axis=0), (1 - tube) * ends
                    where = first / share * L if share else 0.0
                    made.append(OnBar(action=action, at=where, force=force, couple=none, worth=own, on_tube=bool(tube)))
                continue
            at = 0.5 if spread else float(at)
            lever = L * (turning(self.axes[action.member]) @ (ends[1] - at * ends.sum(axis=0)))
            force = ends.sum(axis=0)
            made.append(OnBar(action=action, at=at * L, force=force, couple=lever, worth=ends, on_tube=at > 0.0))
        return tuple(made)

    @cached_property
    def on_bars(self) -> tuple[OnBar, ...]:
        """Actions on members besides their weight and inertia."""
        if "action_force" not in self.data:
            return ()
        return self._on_bars(self.data["action_force"].values, self.data["action_place"].values)

    @cached_property
    def on_bars_of_unit(self) -> tuple[OnBar, ...]:
        """Actions of 1 N or 1 N m of every drive, coupling and spring."""
        system, pad = self.system, ((0, 0), (0, 3 - self.system.dim))
        states = States(*(np.pad(y, pad).reshape(1, -1) for y in (self.x, self.rate, self.a)))
        names = (system.drives, system.model.couplings, system.force_elements)
        drive, coupling, element = (np.ones((1, len(one))) for one in names)
        acting = acting_along(system, self.loads, states, drive, coupling, element)[1]
        return self._on_bars(acting.worth[0, :, :, : system.dim], acting.place[0])

    def left_on(self, node: int, name: str) -> NDArray[np.float64]:
        """Force (dim,) on a node of 1 N or 1 N m of a drive, coupling or spring, without the part that acts on members."""
        return np.asarray(self._left[name][node])

    @cached_property
    def _left(self) -> dict[str, NDArray[np.float64]]:
        """The forces (n, dim) of `left_on` by source."""
        whole = {(self.kind_of(name), name): force for name, (_, force) in self.several.items()}
        left = {key: force.copy() for key, force in whole.items()}
        for one in self.on_bars_of_unit:
            if one.key in left and not one.action.counted:
                left[one.key][[self.system.p[one.action.member], self.system.q[one.action.member]]] -= one.worth
        return {key[1]: np.where(np.abs(one) > LEFT * np.abs(whole[key]).max(), one, 0.0) for key, one in left.items()}

    def kind_of(self, name: str) -> str:
        """Whose coordinate has this name: a drive, coupling or spring."""
        return source_of(self.system.model, name)[0]

    def loads_on(self, node: int) -> list[tuple[str, NDArray[np.float64]]]:
        """Name and force (dim,), N, of every load on a node; one on a bar is not on its nodes, one on a hub at its centre."""
        on_bars = {one.action.source for one in self.on_bars if one.action.kind == "load"}
        found, of_hubs = dict[str, Any](), loads_of_hubs(self.system)
        for name, at, force in zip(self.loads.loads, self.loads.node, self.loads.force[0], strict=True):
            if name not in on_bars and of_hubs.get(name, at) == node:
                found[name] = found.get(name, 0.0) + force[: self.system.dim]
        return list(found.items())

    def bodies_at(self, node: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """M a and M g of bodies at a node, (dim,) N each; a body on a bar does not act on its nodes."""
        dim, system = self.system.dim, self.system
        rows = body_masses(system)[[3 * node + c for c in range(dim)]].toarray().reshape(dim, len(self.x), 3)[:, :, :dim]
        found, largest = [], 0.0
        for y in (self.a, np.tile(self.gravity, (len(self.x), 1))):
            total = np.einsum("ijk,jk->i", rows, y)
            for i, m, skew in bodies_on_bars(system).values():
                ends = np.array([system.p[i], system.q[i]])
                total -= of_two_masses(m, skew, y[None, ends])[0, ends == node].sum(axis=0)
            found.append(total)
            largest = max(largest, float(np.abs(rows).sum()) * float(np.abs(y).max(initial=0.0)))
        # smaller forces are round-off
        inertia, weight = (np.where(np.abs(one) > LEFT * largest, one, 0.0) for one in found)
        return inertia, weight

    @cached_property
    def several(self) -> dict[str, tuple[float, NDArray[np.float64]]]:
        """Force, N or N m, and nodal forces (n, dim) of its unit, by drive of hinges and angles in space, coupling, spring."""
        x = np.pad(self.x, ((0, 0), (0, 3 - self.system.dim)))
        found = {}
        for m, name in enumerate(self.system.measures):
            kind = self.kind_of(name)
            amount = self.data[f"{kind}_force"].sel({kind: name})
            force = measure_gradients(self.system, m, x[None])[0].reshape(-1, 3)[:, : self.system.dim]
            found[name] = float(amount), force
        return found

    @cached_property
    def elements(self) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]] | None:
        """Nodal forces (n, dim), N, of beams, membranes and solids: by their stress, M a, M g; None without them."""
        found, dim = self.system.continua, self.system.dim
        if found is None:
            return None
        x, a, g = (np.pad(y, ((0, 0), (0, 3 - dim))) for y in (self.x, self.a, np.tile(self.gravity, (len(self.x), 1))))
        M = continua_mass(self.system)
        stress = strained_forces(self.system, x).reshape(-1, 3)
        if found.beams is not None:
            stress += self._of_beams(found.beams, x)
        parts = stress, (M @ a.reshape(-1)).reshape(-1, 3), (M @ g.reshape(-1)).reshape(-1, 3)
        return parts[0][:, :dim], parts[1][:, :dim], parts[2][:, :dim]

    def _of_beams(self, beams: BeamElements, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Nodal forces (n, 3), N, of beams by small displacements from the positions x (n, 3), which those of x lack."""
        if "displacement" not in self.data:
            return np.zeros_like(x)
        B, u = mode_gradients(beams, x), np.pad(self.data["displacement"].values, ((0, 0), (0, 3 - self.system.dim)))
        return np.asarray(-(B.T @ (beams.rigidity.reshape(-1) * (B @ u.reshape(-1))))).reshape(-1, 3)

    @cached_property
    def others(self) -> NDArray[np.float64]:
        """Forces (n, dim), N, on the nodes of elements that are neither on coordinates nor beams, membranes or solids."""
        system, pad = self.system, ((0, 0), (0, 3 - self.system.dim))
        x, v = np.pad(self.x, pad), np.pad(self.rate, pad)
        found = element_forces(system, x, v, float(np.ravel(self.loads.t)[0]), rows=False)
        if "displacement" in self.data:  # small ones, which those of x lack
            u = np.pad(self.data["displacement"].values, pad).reshape(-1)
            found -= element_tangents(system, x, None, rows=False)[0] @ u
        return found.reshape(-1, 3)[:, : system.dim]

    def other_kinds(self, node: int) -> str:
        """The kinds of these elements at a node, in words."""
        rest = np.zeros((1, self.system.x0.size))
        found = [
            one.results(self.system, record, np.zeros(1), rest, rest).kind
            for one, record in present(self.system)
            if one.results is not None and (one.coordinates(record) // 3 == node).any()
        ]
        return " and ".join(found) or "elements"

    def elements_at(self, node: int) -> NDArray[np.float64] | None:
        """(3, dim) N of `elements` at a node; None if it belongs to no element."""
        found = self.system.continua
        if self.elements is None or found is None or not np.any((found.p == node) | (found.q == node)):
            return None
        return np.stack([part[node] for part in self.elements])

    def rods(self, i: int) -> tuple[Rod, ...]:
        """The rod of member i; of an active member base and tube.

        Along a bar the acceleration is linear between its ends (so a driven bar stretches evenly); along the base rod it is
        a_A + s u'', along the tube a_B - s' u''.
        """
        system, name = self.system, self.system.members[i]
        A, B = system.p[i], system.q[i]
        L, bend = self.length(i), self._bend(i)
        if system.is_body[i]:
            return (self._body(i, bend),)
        m, l, rotary, m_tube, l_tube, rotary_tube = system.rods[i]
        own_base, own_tube = map(float, system.own_rods[i, [1, 4]])
        if not system.two_rods[i]:
            # int (s - L/2) a ds m/L = m L (a_B - a_A)/12
            swing = m * L / 12 * (self.a[B] - self.a[A]) + rotary * bend
            return (Rod(name=name, start=0.0, length=L, mass=m, acceleration=(self.a[A] + self.a[B]) / 2, swing=swing),)
        base = Rod(
            name=f"{name}.base",
            start=0.0,
            length=own_base,
            place=(l / 2, 0.0),
            mass=m,
            acceleration=self.a[A] + l / 2 * bend,
            swing=(m * l**2 / 12 + rotary) * bend,
        )
        tube = Rod(
            name=f"{name}.tube",
            start=L - own_tube,
            length=own_tube,
            place=(L - l_tube / 2, 0.0),
            mass=m_tube,
            acceleration=self.a[B] - l_tube / 2 * bend,
            swing=(m_tube * l_tube**2 / 12 + rotary_tube) * bend,
        )
        return base, tube

    def _body(self, i: int, bend: NDArray[np.float64]) -> Rod:
        """The planar body of bar i: its centre is carried by the bar, a_A + e u'' + f n'' with n = u turned by 90 deg."""
        system = self.system
        mass, e, f, inertia = map(float, system.body[i])
        acceleration = self.a[system.p[i]] + e * bend + f * np.array([-bend[1], bend[0]])
        return Rod(
            name=system.members[i],
            start=0.0,
            length=self.length(i),
            mass=mass,
            acceleration=acceleration,
            swing=inertia * bend,
            place=(e, f),
        )

    def _bend(self, i: int) -> NDArray[np.float64]:
        """u'' of member i."""
        A, B = self.system.p[i], self.system.q[i]
        return direction_rates(*(y[B] - y[A] for y in (self.x, self.v, self.a)))[1][2]


def turning(axes: NDArray[np.float64]) -> NDArray[np.float64]:
    """(moments, dim): times a vector w it gives u x w about the member axes 2 and 3, in the plane about 3."""
    return np.stack([axes[1]]) if len(axes) == 2 else np.stack([-axes[2], axes[1]])


def instant_of(model: Model, motion: Motion, forces: Forces, time: float | None) -> Instant:
    """The sample of `forces` nearest to `time` (s); velocities and accelerations are zero for forces at rest.

    Raises
    ------
    InputError : a motion or forces of another model, a time outside them, no time where there are several samples.
    """
    system, times = compile(model), forces.arrays["time"].values
    names = list(motion.arrays["node"].values), list(forces.arrays["member"].values)
    if names != (list(system.nodes), list(system.members)):
        raise InputError("The motion or the forces are of a model with other nodes or members. Compute them for this model.")
    check_motion(system, motion)
    if not np.array_equal(times, motion.arrays["time"].values):
        raise InputError("Motion and forces have different instants. Select the same ones of both.")
    k = _nearest(times, time)
    here = motion.whole.isel(time=k)
    still = bool(forces.whole.attrs.get("at_rest", 0))
    x, v, a = (np.array(here[name].values, float) for name in ("position", "velocity", "acceleration"))
    v, a = (0 * v, 0 * a) if still else (v, a)
    case = forces.load_case if forces.load_case in model.cases else None
    loads = case_loads(system, times[k : k + 1], case, rotating=True)
    given = loads.at(np.pad(x, ((0, 0), (0, 3 - system.dim)))[None])
    loads = _turned(given)
    change = loads.gravity - given.gravity
    seen = rates_in_space(forces.attrs, times[k : k + 1], *(y[None] for y in (x, v, a)))
    return Instant(
        system=system,
        time=float(times[k]),
        x=x,
        v=seen[0][0],
        a=seen[1][0] + change[: model.dim],
        rate=v,
        gravity=loads.gravity[: model.dim],
        lump_gravity=loads.lump_gravity[:, : model.dim],
        axes=local_axes(system, x[None])[0, :, : model.dim, : model.dim],
        loads=loads,
        data=forces.whole.isel(time=k),
    )


def _turned(loads: Loads) -> Loads:
    """Loads of one instant with the gravity of that instant, where it turns as seen from the base."""
    if loads.base is None:
        return loads
    change = loads.base.gravity_change(loads.t, loads.gravity)[0]
    return replace(loads, gravity=loads.gravity + change, lump_gravity=loads.lump_gravity + change)


def _nearest(times: NDArray[np.float64], time: float | None) -> int:
    if time is None:
        if len(times) == 1:
            return 0
        raise InputError(f"time is not given, and there are {len(times)} samples. Give time, s.")
    slack = 1e-9 * max(abs(times[0]), abs(times[-1]), 1e-9)
    if not times[0] - slack <= time <= times[-1] + slack:
        raise InputError(f"time {time:g} s is outside the motion, {times[0]:g} s to {times[-1]:g} s. Choose one inside.")
    return int(np.argmin(np.abs(times - time)))
