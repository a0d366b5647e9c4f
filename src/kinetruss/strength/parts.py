"""Parts of members with their sections, torsion by couples, and the input of the kernels of section forces."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.action_couples import hinge_wrench
from kinetruss.dynamics.bar_actions import actions_of
from kinetruss.dynamics.bearing_friction import friction_on_arms
from kinetruss.elements.loads.load import Spread
from kinetruss.elements.local_axes import orientation
from kinetruss.errors import InputError
from kinetruss.kernels.sections.peaks import GENERAL, RECTANGLE, ROUND, UNKNOWN
from kinetruss.kernels.sections.records import COUPLE, FORCE, POINT, Histories, Members, Polynomials
from kinetruss.kernels.sections.sections import COEFFICIENTS, most_segments, section_polynomials
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import CABLE, System, cached, compile, ends_of
from kinetruss.mechanics.loads import case_loads
from kinetruss.mechanics.rotating_base import rates_in_space
from kinetruss.model import Active, Bar, BodyCouple, Model
from kinetruss.model.data import ModelData
from kinetruss.model.hub_arms import arm_through
from kinetruss.results import Forces

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray


_SHAPES = {"tube": ROUND, "rod": ROUND, "rectangle": RECTANGLE, "general": GENERAL}


@dataclass(frozen=True, kw_only=True, eq=False)
class Parts:
    """Parts of the real members, in their order; the base of an active member before its tube.

    names, members (parts,): names of parts and of their members. member (parts,): index of the member. first (members,):
    index of each member's first part. two (members,): active members. cable (members,). body (parts,): planar bodies.
    length (parts,): m, NaN for bars. shape (parts,): codes of `kernels.sections.peaks`. area m^2, I2, I3 m^4, c2, c3 m, factor
    (shear), E, G, yield_strength Pa: NaN where not known. twist: largest shear stress of torsion over torque, 1/m^3.
    """

    names: tuple[str, ...]
    members: tuple[str, ...]
    member: NDArray[np.int64]
    first: NDArray[np.int64]
    two: NDArray[np.bool_]
    cable: NDArray[np.bool_]
    body: NDArray[np.bool_]
    length: NDArray[np.float64]
    shape: NDArray[np.int64]
    area: NDArray[np.float64]
    I2: NDArray[np.float64]
    I3: NDArray[np.float64]
    c2: NDArray[np.float64]
    c3: NDArray[np.float64]
    factor: NDArray[np.float64]
    E: NDArray[np.float64]
    G: NDArray[np.float64]
    yield_strength: NDArray[np.float64]
    twist: NDArray[np.float64]

    @property
    def judged(self) -> tuple[str, ...]:
        """Names of the members that have a section in one of their parts."""
        return tuple(dict.fromkeys(name for name, shape in zip(self.members, self.shape, strict=True) if shape != UNKNOWN))

    @cached_property
    def base(self) -> NDArray[np.bool_]:
        """(parts,): base rods of active members, which overhang beyond the interface to the tube."""
        found = np.zeros(len(self.names), np.bool_)
        found[self.first[self.two]] = True
        return found

    @property
    def scale(self) -> NDArray[np.float64]:
        """(parts, 4): factors from T, M2, M3 and V to nominal stresses: 1/A, c3/I2, c2/I3, shear factor/A."""
        return np.stack([1 / self.area, self.c3 / self.I2, self.c2 / self.I3, self.factor / self.area], axis=1)

    def lengths(self, member_length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Lengths of all parts (times, parts), m, from those of all members (times, members)."""
        found = member_length[:, self.member]
        known = ~np.isnan(self.length)
        found[:, known] = self.length[known]
        return found

    def starts(self, member_length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Distance (times, parts), m, of each part's end towards A from the member's end A."""
        tube = self.first[self.two] + 1
        found = np.zeros((len(member_length), len(self.names)))
        found[:, tube] = member_length[:, : len(self.two)][:, self.two] - self.length[tube]
        return found


def parts_of(model: Model) -> Parts:
    """The parts of a model."""
    return _parts(compile(model))


@cached(of_records=True)
def _parts(system: System) -> Parts:
    model = system.model
    rows: list[tuple[str, str, int, float, tuple[float, ...]]] = []
    first = []
    for k, (name, member) in enumerate(model.real_members.items()):
        first.append(len(rows))
        if isinstance(member, Active):
            for role, part in (("base", member.base), ("tube", member.tube)):
                rows.append((f"{name}.{role}", name, k, part.length, _numbers(model, part)))
        else:
            rows.append((name, name, k, np.nan, _numbers(model, member)))
    numbers = np.array([row[4] for row in rows]).reshape(len(rows), 11)
    area, I2, I3, c2, c3, factor, E, poisson, strength, shape, twist = numbers.T
    return Parts(
        names=tuple(row[0] for row in rows),
        members=tuple(row[1] for row in rows),
        member=np.array([row[2] for row in rows], np.int64),
        first=np.array(first, np.int64),
        cable=(system.law == CABLE)[: len(first)],
        body=system.is_body[[row[2] for row in rows]],
        two=np.array([isinstance(member, Active) for member in model.real_members.values()], np.bool_),
        length=np.array([row[3] for row in rows], float),
        shape=shape.astype(np.int64),
        area=area,
        I2=I2,
        I3=I3,
        c2=c2,
        c3=c3,
        factor=factor,
        E=E,
        G=E / (2 * (1 + poisson)),
        yield_strength=strength,
        twist=twist,
    )


def _numbers(model: ModelData, part: Any) -> tuple[float, ...]:
    section, material = model.section_of(part), model.material_of(part)
    if isinstance(part, Bar) and part.body is not None:
        section = material = None
    shape = (np.nan,) * 6
    if section is not None:
        shape = (section.area, *section.second_moments, *section.extreme_fibres, section.shear_factor)
    stuff = (np.nan,) * 3
    if material is not None:
        stuff = (material.E, material.poisson, material.yield_strength or np.nan)
    known = section is not None and section.torsion_arm is not None
    twist = section.torsion_arm / section.torsion_constant if known else np.nan
    return (*shape, *stuff, UNKNOWN if section is None else _SHAPES[section.kind], twist)


# Torsion of arms and members by couples that pass through hinges, or enter hubs through members.

ROUND_OFF = 1e-10
"""Torques below this fraction of the couple are round-off."""


def twisted_parts(model: Model) -> NDArray[np.bool_]:
    """Parts (parts,) that may be under torsion: arms and members of hinges and of `BodyCouple.member`."""
    through, pivots = {(load.body, load.member) for load in _couples(model).values()}, model.whole.inner.pivots
    names = {str(name) for _, name in through}
    names |= {arm.name for body, member in through if member and (arm := arm_through(model.whole, body, member))}
    names |= {one.tip for one in pivots}
    names |= {one.member for one in pivots if one.clamped or [other.member for other in pivots].count(one.member) == 2}
    return np.array([name in names for name in parts_of(model).members], np.bool_)


def _couples(model: Model) -> dict[str, BodyCouple]:
    """Loads that enter hubs through members."""
    return {name: load for name, load in model.loads.items() if isinstance(load, BodyCouple) and load.member is not None}


def torsion_of(model: Model, forces: Forces) -> NDArray[np.float64] | None:
    """Torque about axis 1 along every part, exerted by its B-side on its A-side, (times, parts) N m; None if nothing twists.

    The arm of a member has the component along it of the couples that pass through the joint, from its tip to the centre of the
    hub. The member itself, with base and tube, has their component along its own axis, from joint to joint.
    """
    found = None
    system, parts = compile(model), parts_of(model)
    x = np.pad(forces.motion.arrays["position"].values, ((0, 0), (0, 0), (0, 3 - model.dim)))
    index = {name: i for i, name in enumerate(system.members)}
    for arm, member, end, couple in _passed(model, forces, x):
        if found is None:
            found = np.zeros((len(x), len(parts.names)))
        size = ROUND_OFF * np.linalg.norm(couple, axis=1)
        for name, sign in ((arm, 1.0 if system.nodes[system.q[index[arm]]] == arm else -1.0), (member, 1.0 - 2.0 * end)):
            if not name:
                continue
            i = index[name]
            torque = sign * np.einsum("tc,tc->t", couple, ends_of(system, x, i)[2])
            rods = 2 if name in model.active else 1
            found[:, parts.first[i] : parts.first[i] + rods] += np.where(np.abs(torque) > size, torque, 0.0)[:, None]
    return found


def _passed(model: Model, forces: Forces, x: NDArray[np.float64]) -> Iterator[tuple[str, str, int, NDArray[np.float64]]]:
    """Arm, member that is twisted from its other end (or empty), end of the member, couple (times, 3) of it on the hub."""
    arrays, twisted = forces.arrays, set[str]()
    if couples := _couples(model):
        case = forces.load_case if forces.load_case in model.cases else None
        given = case_loads(compile(model), arrays["time"].values, case, rotating=True).amounts
        by_end: dict[tuple[str, int], str] = {}
        for name, load in couples.items():
            arm = arm_through(model.whole, load.body, str(load.member))
            if name in given and arm is not None:
                # what leaves at one end entered at the other: of a member with couples at both ends the first counts
                own = by_end.setdefault((arm.member, 0), f"{arm.end}") == f"{arm.end}"
                yield arm.name, arm.member if own else "", arm.end, given[name]
    if model.whole.inner.pivots:
        system, pivots = compile(model), model.whole.inner.pivots
        rubbed: dict[int, NDArray[np.float64]] = {}
        tension, names = arrays["member_force"].values, list(model.whole.couplings)
        amounts = dict(zip(names, arrays["coupling_force"].values.T, strict=True)) if names else {}
        if "bearing_couple" in arrays:
            rubbed = friction_on_arms(system, x, arrays["bearing_couple"].values)
        for k, pivot in enumerate(pivots):
            couple = hinge_wrench(system, k, x, tension, amounts)[1]
            alone = not pivot.clamped and [one.member for one in pivots].count(pivot.member) == 1
            own = not alone and pivot.member not in twisted
            twisted.add(pivot.member)
            more = rubbed.get(list(model.whole.members).index(pivot.tip), 0.0)
            yield pivot.tip, pivot.member if own else "", pivot.end, couple + more


def shear_of_torsion(model: Model, torque: NDArray[np.float64]) -> NDArray[np.float64]:
    """Largest shear stress, Pa, by torques (times, parts), N m; NaN at all times where a section does not know it."""
    factor = np.where((torque != 0).any(axis=0), parts_of(model).twist, 0.0)
    return np.asarray(np.abs(torque) * factor)


def with_torsion(von_mises: NDArray[np.float64], shear: NDArray[np.float64], twist: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound on the von Mises stress where the largest shear stresses of V and of torsion, Pa, act at its point.

    s^2 = sigma^2 + 3 tau_V^2 at any point, so sigma^2 + 3 (tau_V + tau)^2 <= s^2 + 3 (2 tau_V tau + tau^2) with the largest s,
    tau_V and tau.
    """
    return np.asarray(np.sqrt(von_mises**2 + 3 * twist * (2 * shear + twist)))


# Input of the kernels of section forces, from a model and its forces.


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
    real = len(system.model.real_members)
    joint_force = np.ascontiguousarray(found["joint_force"].values[:, :real])
    if system.is_body.any():
        joint_force = joint_force.copy()
        joint_force[:, system.is_body[:real]] = np.nan  # the distribution of its mass is unknown, so it has no sections
    on, worth, place = _actions(system, forces)
    actions = actions_of(system, forces.load_case).actions if on else ()
    places = tuple(one.place if isinstance(one.place, Spread) else None for one in actions)
    return Given(
        members=_members(system, tuple(forces.attrs["gravity"]), on, places),
        histories=Histories(position, velocity, acceleration, joint_force, worth, place),
    )


@cached()
def _members(system: System, gravity: tuple[float, ...], on: tuple[str, ...], places: tuple[Spread | None, ...]) -> Members:
    """The real members of a model, under actions on these members; not to be written to."""
    index = {name: k for k, name in enumerate(system.members)}
    real = len(system.model.real_members)
    acting = np.searchsorted([index[name] for name in on], np.arange(real + 1))
    orient, reference = orientation(system)
    clamped_ptr = np.searchsorted(system.clamped[:, 0], np.arange(2 * real + 1))
    spread = np.array([POINT if one is None else COUPLE if one.couple else FORCE for one in places], np.int64)
    along = np.array([(0.0,) * 4 if one is None else (one.begin, one.end, *(one.ratio or (0.0, 0.0))) for one in places])
    along = along.reshape(-1, 4)
    return Members.of(
        {
            "segments": most_segments(acting, spread, along, clamped_ptr),
            "p": system.p[:real],
            "q": system.q[:real],
            "orient": orient[:real],
            "two_rods": system.two_rods[:real],
            "acting": acting,
            "spread": spread,
            "along": along,
            "clamped_ptr": clamped_ptr,
            "clamped": system.clamped[:, 1:],
            "rods": system.own_rods[:real],
            "reference": reference[:real],
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
