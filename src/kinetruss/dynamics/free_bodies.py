"""The free body of a member or a node: every force on it, its equations in numbers, and what equilibrium alone determines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.linalg import null_space

from kinetruss.dynamics.hub_arms import braces_of_hubs, grounded_tips
from kinetruss.dynamics.instants import Instant, Rod, instant_of, turning
from kinetruss.errors import InputError
from kinetruss.mechanics import RANK_TOLERANCE, System, constraint_jacobian
from kinetruss.model import CoordinateDrive, Model, nearest
from kinetruss.results.user_parts import held_forces
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Forces, Motion


LARGEST = 900
"""Largest number of unknown forces; above it, the null space takes too long."""


def determined(system: System, x: NDArray[np.float64], body: str, names: Sequence[str]) -> bool | None:
    """True if force and moment on a body through some of its nodes follow from balance and motion; None beyond `LARGEST`.

    x (n, 3) : positions, m. The unknowns are the forces of all rows outside rigid bodies, and those that every rigid body
    exerts on the nodes that it shares, in balance with each other. The equations are the equilibrium of the nodes. The cut is
    determined if no state of self-stress has a force or moment there.
    """
    dim, count = system.dim, len(system.nodes)
    own = {one: [system.node_index(n) for n in body.nodes] for one, body in system.model.bodies.items() if body.kind == "rigid"}
    of: list[set[str]] = [set() for _ in system.nodes]
    for name, nodes in own.items():
        for n in nodes:
            of[n].add(name)
    ends = zip(system.p[system.row_member].tolist(), system.q[system.row_member].tolist(), strict=True)
    outside = [r for r, (p, q) in enumerate(ends) if system.row_measure[r] >= 0 or not of[p] & of[q]]
    if len(outside) > LARGEST:
        return None
    rows = constraint_jacobian(system, x)[outside].toarray().reshape(len(outside), count, 3)[:, :, :dim]
    rows = rows / np.maximum(np.abs(rows).max(axis=(1, 2), keepdims=True, initial=0.0), np.finfo(float).tiny)
    fixed = system.prescribed.reshape(-1, 3)[:, :dim]
    met = np.array([len(bodies) for bodies in of]) + rows.any(axis=(0, 2)) + fixed.any(axis=1)
    blocks, wrenches = [rows], [np.zeros((len(rows), 3 * dim - 3))]
    size = float(np.ptp(x, axis=0).max()) or 1.0
    for name, nodes in own.items():
        if not (at := [n for n in nodes if met[n] > 1]):
            continue
        forces = np.eye(dim * len(at)).reshape(-1, len(at), dim)
        moments = np.cross(x[at] / size, np.pad(forces, ((0, 0), (0, 0), (0, 3 - dim))))
        each = np.concatenate([forces, moments[..., 2:] if dim == 2 else moments], axis=2)
        balanced = null_space(each.sum(axis=1).T).T
        blocks.append(np.zeros((len(balanced), count, dim)))
        blocks[-1][:, at] = balanced.reshape(-1, len(at), dim)
        cut = np.array([name == body and system.nodes[n] in names for n in at], bool)
        wrenches.append(balanced @ each[:, cut].sum(axis=1))
    forces, wrench = np.concatenate(blocks), np.concatenate(wrenches)
    if len(forces) > LARGEST:
        return None
    free = np.flatnonzero(~fixed & forces.any(axis=(0, 2)).reshape(-1, 1))
    _, values, Vt = np.linalg.svd(forces.reshape(len(forces), dim * count)[:, free].T)
    stress = Vt[int(np.sum(values > RANK_TOLERANCE * values.max(initial=0.0))) :]
    return bool(np.abs(stress @ wrench).max(initial=0.0) < 100 * RANK_TOLERANCE)


# The free body of a member or a node: every force on it, and its equations in numbers.


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Term:
    """The action of one neighbour on a body, or an inertia term.

    symbol : short name, e.g. ``F_A``. source : where it comes from. force : (dim,) N, global axes. local : (dim,) N, member
    axes 1, 2, 3 (empty for nodes). moment : about the body's centre of mass and member axes 2, 3 (in the plane 3), N m;
    of the force and of its own moment (empty for nodes).
    """

    symbol: str
    source: str
    force: NDArray[np.float64]
    local: NDArray[np.float64]
    moment: NDArray[np.float64]


class Equation(NamedTuple):
    """One equation in numbers: sum of the terms = right; `residual` is the difference."""

    name: str
    unit: str
    left: float
    right: float
    residual: float


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Body:
    """A body cut free: terms on the left, `inertia` (m a, and the rate of angular momentum H') on the right.

    mass : kg. centre, acceleration : (dim,) of its centre of mass, m, m/s^2.
    """

    name: str
    mass: float
    centre: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    terms: tuple[Term, ...]
    inertia: Term

    @property
    def force_sum(self) -> NDArray[np.float64]:
        """Sum of all forces (dim,), N."""
        return np.asarray(sum((term.force for term in self.terms), np.zeros(len(self.inertia.force))))

    @property
    def moment_sum(self) -> NDArray[np.float64]:
        """Sum of all moments about the centre of mass (moments,), N m."""
        return np.asarray(sum((term.moment for term in self.terms), np.zeros(len(self.inertia.moment))))

    @property
    def equations(self) -> tuple[Equation, ...]:
        """Sum of forces = m a along x, y, z; sum of moments = H' about member axes 2, 3."""
        found = []
        for axis, left, right in zip("xyz", self.force_sum, self.inertia.force, strict=False):
            found.append(Equation(f"force {axis}", "N", float(left), float(right), float(left - right)))
        about = "23"[-len(self.inertia.moment) :] if len(self.inertia.moment) else ""
        for axis, left, right in zip(about, self.moment_sum, self.inertia.moment, strict=True):
            found.append(Equation(f"moment {axis}", "N m", float(left), float(right), float(left - right)))
        return tuple(found)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class FreeBody:
    """The free body of a member (a bar; base and tube of an active member) or of a node, at one instant.

    kind : ``bar``, ``active`` or ``node``. ends : names of a member's nodes. length : m, and axes (dim, dim): member axes as
    rows; None for nodes. tension : axial tension at A, mean over the length, at B, N (of an active member the mean is
    the actuator's). largest : largest force of the free body, N, the measure for residuals.
    """

    kind: str
    name: str
    time: float
    load_case: str
    ends: tuple[str, ...]
    bodies: tuple[Body, ...]
    length: float | None = None
    axes: NDArray[np.float64] | None = None
    tension: tuple[float, ...] = ()

    @property
    def largest(self) -> float:
        """Largest force component, N."""
        return max(float(np.abs(term.force).max()) for body in self.bodies for term in (*body.terms, body.inertia))

    @property
    def residual(self) -> float:
        """Largest residual of all equations, N or N m."""
        return max(abs(equation.residual) for body in self.bodies for equation in body.equations)


@one_thread
def free_body(
    model: Model,
    motion: Motion,
    forces: Forces,
    *,
    member: str | None = None,
    node: str | None = None,
    time: float | None = None,
) -> FreeBody:
    """The free body of a member or a node: all forces on it, its inertia, its equations and their residuals.

    Parameters
    ----------
    motion, forces : of the same model and instants; ``forces.static`` gives the free body at rest.
    member, node : the name of what is cut free; give one of them.
    time : s, the nearest sample; may be left out where there is only one.

    Returns
    -------
    FreeBody. Its bodies are the bar; base and tube of an active member, each with the force and moment between them at the
    tube's free end; or the node. Drives (``T``), couplings (``Q``), springs (``K``), loads (``P``), bodies (``B``) act on a bar
    at the place that `inverse` reports. On a node act the members, the forces of these that act on no bar (``Q``), and the
    membranes and solids that it belongs to (``E``), with its part of their mass.

    Raises
    ------
    InputError : neither or both of member and node, a name that is not in the model, a time outside the motion.

    Notes
    -----
    Sum of forces: F_A + F_B + what else acts + m g = m a. Moment about the centre of mass c: sum r x F + M = H', H' = I u x u''
    for a rigid rod, with the forces that `dynamics.inverse` found from its own, different equations. About axis 1 there is no
    moment. Source: Newton and Euler's equations of a rigid rod; Lacy (1991, chapters 2 and 4).

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(payload_mass=10.0)
    >>> forces = kt.runs.forces_at_rest(model)
    >>> body = kt.dynamics.free_body(model, forces.motion, forces, node="B")
    >>> [term.symbol for term in body.bodies[0].terms]
    ['-F_B', '-F_B', 'm g']
    """
    if (member is None) == (node is None):
        raise InputError("Name one thing to cut free: member=..., or node=...")
    here = instant_of(model, motion, forces, time)
    if node is not None:
        if node not in here.system.model.nodes:
            raise InputError(f"No node called {node!r}. {nearest(node, model.nodes)}")
        return _node(here, node, forces.load_case)
    if member not in here.system.model.members:
        raise InputError(f"No member called {member!r}. {nearest(member, model.members)}")
    return _member(here, str(member), forces.load_case)


def _member(here: Instant, name: str, case: str) -> FreeBody:
    system, i = here.system, here.system.members.index(name)
    ends = tuple(system.model.members[name].ends)
    L, axes = here.length(i), here.axes[i]
    joint = here.data["joint_force"].values[i]
    end_a = _Force("F_A", f"joint {ends[0]}, end A", joint[0], 0.0)
    end_b = _Force("F_B", f"joint {ends[1]}, end B", joint[1], L)
    rods, acting = here.rods(i), list(_acting(here, i))
    if len(rods) == 1:
        cut = [(rods[0], [end_a, end_b, *acting])]
    else:
        on_base, on_tube = _interface(here, name, axes, L - rods[1].length)
        at_a, at_b = ([one for one in acting if one.on_tube == tubes] for tubes in (False, True))
        cut = [(rods[0], [end_a, *on_base, *at_a]), (rods[1], [*on_tube, end_b, *at_b])]
    tension = (*here.data["end_force"].values[i], here.data["member_force"].values[i])
    return FreeBody(
        kind="bar" if len(rods) == 1 else "active",
        name=name,
        time=here.time,
        load_case=case,
        ends=ends,
        length=L,
        axes=axes,
        bodies=tuple(_rod_body(here, rod, axes, here.x[system.p[i]], acting) for rod, acting in cut),
        tension=tuple(float(tension[k]) for k in (0, 2, 1)),
    )


class _Force(NamedTuple):
    """A force (dim,) at a distance from end A of a member, and a moment of its own about axes 2, 3."""

    symbol: str
    source: str
    force: NDArray[np.float64]
    at: float
    moment: NDArray[np.float64] | None = None
    on_tube: bool = False


def _interface(here: Instant, name: str, axes: NDArray[np.float64], nut: float) -> tuple[list[_Force], list[_Force]]:
    """Force and moment between base and tube at the interface: on the base, and on the tube."""
    at = {"active": name}
    S = here.data["interface_force"].sel(at).values @ axes
    M = here.data["interface_moment"].sel(at).values
    none = 0 * S
    on_base = [_Force("S", "tube, at the nut", S, nut), _Force("M", "tube, at the nut", none, nut, M)]
    return on_base, [_Force("-S", "base, at the nut", -S, nut), _Force("-M", "base, at the nut", none, nut, -M)]


_SYMBOLS = {
    "drive": ("T", "drive"),
    "coupling": ("Q", "coupling"),
    "load": ("P", "load"),
    "body": ("B", "weight less m a of body"),
    "friction": ("C", "friction at"),
    "bearing": ("C", "bearing"),
    "hub": ("H", "centre of hub"),
    "couple": ("C", "couple of"),
    "hinge": ("C", "hinge at hub"),
}


def _acting(here: Instant, member: int) -> Iterator[_Force]:
    """Actions on a member besides its joints and weight, without axial forces, which are in its tension."""
    for one in here.on_bars:
        small = 1e-12 * np.abs(one.worth).max()
        if one.action.member == member and (
            not small or np.abs(one.force).max() > small or np.abs(one.couple).max() > small * here.length(member)
        ):
            symbol, words = _SYMBOLS.get(one.action.kind, ("K", one.action.kind))
            yield _Force(symbol, f"{words} {one.action.source}", one.force, one.at, one.couple, one.on_tube)


def _rod_body(here: Instant, rod: Rod, axes: NDArray[np.float64], origin: NDArray[np.float64], acting: list[_Force]) -> Body:
    turn = turning(axes)
    terms = []
    for one in acting:
        # lever along the axis times the force across it, and the eccentricity times the force along it
        moment = (one.at - rod.centre) * (turn @ one.force)
        if rod.side:
            moment = moment + rod.side * (axes[:1] @ one.force)
        if one.moment is not None:
            moment = moment + one.moment
        terms.append(Term(symbol=one.symbol, source=one.source, force=one.force, local=axes @ one.force, moment=moment))
    weight = rod.mass * here.gravity
    terms.append(Term(symbol="m g", source="weight", force=weight, local=axes @ weight, moment=np.zeros(len(turn))))
    push = rod.mass * rod.acceleration
    inertia = Term(symbol="m a", source="", force=push, local=axes @ push, moment=turn @ rod.swing)
    return Body(
        name=rod.name,
        mass=rod.mass,
        centre=origin + rod.centre * axes[0] + rod.side * axes[1],
        acceleration=rod.acceleration,
        terms=tuple(terms),
        inertia=inertia,
    )


def _node(here: Instant, name: str, case: str) -> FreeBody:
    system, n = here.system, here.system.node_index(name)
    beams = None if system.continua is None else system.continua.beams
    if beams is not None and n in beams.nodes and ("mode_force" in here.data or here.data.attrs.get("undecided", ())):
        raise InputError(
            f"Beams keep their shape in this motion, and node {name!r} is one of theirs: free bodies are of bars and of other "
            "nodes. The forces and moments at the ends of beams are those of strength.beams."
        )
    forces: list[tuple[str, str, NDArray[np.float64]]] = []
    left_out, tips = braces_of_hubs(system), grounded_tips(system, name)
    for i, member in enumerate(system.members):
        for e, end in enumerate((system.p[i], system.q[i])):
            if end == n and i not in left_out:
                forces.append((f"-F_{'AB'[e]}", f"{member}, end {'AB'[e]}", -here.data["joint_force"].values[i, e]))
    held = dict(zip(*held_forces(here.data), strict=True))
    on = (name, *(tips or ())) if tips != [] else ()  # the ground holds a hub at its centre
    forces.extend(("R", "support" if one == name else f"support {one}", held[one]) for one in on if one in held)
    for drive, record in system.model.all_drives.items():
        if isinstance(record, CoordinateDrive) and record.node == name:
            push = np.zeros(system.dim)
            push["xyz".index(record.axis)] = float(here.data["drive_force"].sel(drive=drive))
            forces.append(("D", f"drive {drive}", push))
    forces += [("P", f"load {load}", force) for load, force in here.loads_on(n)]
    for one, (amount, _) in here.several.items():
        if (left := here.left_on(n, one)).any():
            owner = system.inner.part_of(one)
            forces.append(("Q", f"{here.kind_of(one)} {one}" if owner == one else owner, amount * left))
    mass = float(system.lump[n])
    push, weight = here.bodies_at(n)
    if (elements := here.elements_at(n)) is not None:
        words = "beams, membranes and solids" if system.model.beams else "membranes and solids"
        forces.append(("E", words, elements[0]))
        push, weight = push + elements[1], weight + elements[2]
    if here.others[n].any():
        forces.append(("E", here.other_kinds(n), here.others[n]))
    if mass or weight.any():
        forces.append(("m g", "weight", mass * here.lump_gravity[n] + weight))
    none = np.zeros(0)
    terms = tuple(Term(symbol=s, source=w, force=np.asarray(f, float), local=none, moment=none) for s, w, f in forces)
    inertia = Term(symbol="m a", source="", force=mass * here.a[n] + push, local=none, moment=none)
    body = Body(name=name, mass=mass, centre=here.x[n], acceleration=here.a[n], terms=terms, inertia=inertia)
    return FreeBody(kind="node", name=name, time=here.time, load_case=case, ends=(), bodies=(body,))
