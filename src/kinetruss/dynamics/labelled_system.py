"""The labelled equations of Newton and Euler of a whole model at one instant."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Literal

import numpy as np

from kinetruss.dynamics.actions import GIVEN
from kinetruss.dynamics.instants import Instant, OnBar, Rod, instant_of, turning
from kinetruss.errors import InputError
from kinetruss.mechanics import ELASTIC, FREE, System
from kinetruss.mechanics.matrices import bar_laws
from kinetruss.model import CoordinateDrive, Model
from kinetruss.results.user_parts import held_forces
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Forces, Motion


MOST_UNKNOWNS = 2500
"""Largest number of unknowns: a larger system is not readable, and its dense matrix fills the memory."""

_UNIQUE = 1e10
"""Largest condition number at which the equations alone count as determining the forces."""


@dataclass(frozen=True, kw_only=True, eq=False)
class LabelledSystem:
    """matrix @ unknowns = right, row by row and column by column with names.

    equations : ``M6 force x``, ``M6 moment 3``, ``M7.tube force y``, ``node N5 force z``; units N and N m.
    unknowns : ``M6 A x`` (force on the member at its end), ``M7 interface axial``, ``N1 reaction x``, ``motor torque``.
    matrix (equations, unknowns), right (equations,). product (unknowns,): the same forces as `dynamics.inverse` found them.
    solution (unknowns,): of these equations alone; where they do not determine it (`unique` is False), the one nearest to
    `product`. condition : condition number of the matrix (infinite with too few equations).
    joints : equations left out because a support holds one member only and replaces its joint.
    """

    time: float
    load_case: str
    equations: tuple[str, ...]
    unknowns: tuple[str, ...]
    matrix: NDArray[np.float64]
    right: NDArray[np.float64]
    product: NDArray[np.float64]
    joints: tuple[str, ...] = ()

    @cached_property
    def condition(self) -> float:
        """Ratio of the largest to the smallest singular value; infinite if there are more unknowns than equations.

        There are more equations than unknowns if the model moves freely: they then hold for its own accelerations only.
        """
        rows, columns = self.matrix.shape
        return float(np.linalg.cond(self.matrix)) if rows >= columns > 0 else float("inf")

    @property
    def unique(self) -> bool:
        """True if the equations alone determine all forces."""
        return self.condition < _UNIQUE

    @cached_property
    def solution(self) -> NDArray[np.float64]:
        """(unknowns,), N and N m."""
        if self.unique and self.matrix.shape[0] == self.matrix.shape[1]:
            return np.asarray(np.linalg.solve(self.matrix, self.right), np.float64)
        if self.unique:
            return np.asarray(np.linalg.lstsq(self.matrix, self.right, rcond=None)[0], np.float64)
        missing = np.linalg.lstsq(self.matrix, self.right - self.matrix @ self.product, rcond=None)[0]
        return np.asarray(self.product + missing, np.float64)

    @property
    def residual(self) -> float:
        """Largest residual of an equation with the forces of `dynamics.inverse`, N or N m."""
        return float(np.abs(self.matrix @ self.product - self.right).max(initial=0.0))

    @property
    def difference(self) -> float:
        """Largest difference between `solution` and `product`, N or N m."""
        return float(np.abs(self.solution - self.product).max(initial=0.0))

    @property
    def largest(self) -> float:
        """Largest force or moment of the solution, N or N m."""
        return float(np.abs(self.solution).max(initial=0.0))


@one_thread
def newton_euler(
    model: Model,
    motion: Motion,
    forces: Forces,
    *,
    time: float | None = None,
    rods: Literal["together", "apart"] | None = None,
) -> LabelledSystem:
    """All equations of motion of a model at one instant, solved and compared with the forces of `dynamics.inverse`.

    Parameters
    ----------
    motion, forces : of the same model and instants; ``forces.static`` gives the equations at rest.
    time : s, the nearest sample; may be left out where there is only one.
    rods : base and tube of active members as one body (``"together"``) or two (``"apart"``); by default apart in the plane
        and together in space, as Lacy (1991) counts them: 11 equations for his triangular truss, 117 for one bay.

    Returns
    -------
    LabelledSystem. The unknowns are the forces on every member at both ends, the reactions, the torques and forces of drives,
    and with separate rods the force and moments between them (member axes).

    Raises
    ------
    InputError : a time outside the motion, a model with more than 2500 unknowns, a model with hubs.

    Notes
    -----
    Of every body: sum of forces = sum of m (a - g) along x, y, z; moment about its centre of mass = rate of its angular
    momentum about member axes 2 and 3. Of every node: forces of members, supports and drives = m (a - g) - loads. An elastic
    bar adds its law, a free bar the absence of one; a planar body of a bar has its own centre and moment of inertia. Bodies
    that nodes carry are counted at these, sum m_ij (a_j - g). A drive of an angle and a coupling are one unknown each; they
    act on the bars that `inverse` reports, else on nodes along the gradient of their coordinate. Loads and bodies on a bar are
    on the right-hand side of its equations. So are the forces of springs, membranes and solids, which follow from the motion.
    Nothing else of the mass matrix of `inverse` is used: agreement shows that its consistent masses and mean tensions are
    equivalent to Newton and Euler's equations. Source: Lacy (1991, chapters 2 and 4), with the errata of the documentation.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> forces = kt.runs.forces_at_rest(model)
    >>> system = kt.dynamics.newton_euler(model, forces.motion, forces)
    >>> system.matrix.shape  # 3 bodies and a free node in the plane
    (11, 11)
    """
    if model.hubs:
        raise InputError("The braces of hubs have no equations of their own. Use dynamics.free_body of the arms and nodes.")
    here = instant_of(model, motion, forces, time)
    apart = model.dim == 2 if rods is None else rods == "apart"
    made = _Builder(here)
    joints = _joints(here)
    for i in range(len(here.system.members)):
        _member(made, i, apart)
    _grounds(made, joints)
    for node in here.system.nodes:
        if node not in joints:
            _node(made, node)
    if len(made.unknowns) > MOST_UNKNOWNS:
        raise InputError(f"The system has {len(made.unknowns)} unknowns, more than {MOST_UNKNOWNS}. Take a smaller model.")
    matrix = np.zeros((len(made.rows), len(made.unknowns)))
    for row, terms in enumerate(made.terms):
        for column, coefficient in terms:
            matrix[row, column] += coefficient
    return LabelledSystem(
        time=here.time,
        load_case=forces.load_case,
        equations=tuple(made.rows),
        unknowns=tuple(made.unknowns),
        matrix=matrix,
        right=np.array(made.right),
        product=np.array(made.values),
        joints=joints,
    )


@dataclass
class _Builder:
    """Collects unknowns (with their values by `dynamics.inverse`) and equations."""

    here: Instant
    unknowns: dict[str, int] = field(default_factory=dict)
    values: list[float] = field(default_factory=list)
    rows: list[str] = field(default_factory=list)
    terms: list[list[tuple[int, float]]] = field(default_factory=list)
    right: list[float] = field(default_factory=list)

    def amount(self, key: tuple[str, str]) -> NDArray[np.int64]:
        """Column of a drive of an angle or of a coupling; added at its first use."""
        kind, name = key
        word = "torque" if kind == "drive" else kind
        if f"{name} {word}" not in self.unknowns:
            value = self.here.data[f"{kind}_force"].sel({kind: [name]}).values
            return self.add(name, (word,), value)
        return np.array([self.unknowns[f"{name} {word}"]])

    def add(self, subject: str, names: tuple[str, ...], values: NDArray[np.float64]) -> NDArray[np.int64]:
        """New unknowns ``SUBJECT NAME``; their columns."""
        first = len(self.unknowns)
        for name, value in zip(names, values, strict=True):
            self.unknowns[f"{subject} {name}"] = len(self.unknowns)
            self.values.append(float(value))
        return np.arange(first, len(self.unknowns))

    def write(
        self,
        subject: str,
        names: tuple[str, ...],
        terms: list[tuple[NDArray[np.int64], NDArray[np.float64]]],
        right: NDArray[np.float64],
    ) -> None:
        """New equations ``SUBJECT NAME``: sum of coefficients (equations, columns) times unknowns = right (equations,)."""
        for k, name in enumerate(names):
            self.rows.append(f"{subject} {name}")
            self.terms.append(
                [(int(c), float(row[k, j])) for columns, row in terms for j, c in enumerate(columns) if row[k, j]]
            )
            self.right.append(float(right[k]))


def _joints(here: Instant) -> tuple[str, ...]:
    """Fully fixed nodes at the end of exactly one member."""
    system, model = here.system, here.system.model
    ends = np.bincount(np.concatenate([system.p, system.q]), minlength=len(system.nodes))
    loaded = {system.nodes[node] for node in here.loads.node}
    whole = set("xyz"[: system.dim])
    busy = {n for n in range(len(system.nodes)) if any(here.left_on(n, one).any() for one in here.several)}
    alone = (
        name
        for n, name in enumerate(system.nodes)
        if ends[n] == 1
        and n not in busy
        and here.elements_at(n) is None
        and not here.others[n].any()
        and set(model.fixed.get(name, "")) == whole
        and not system.node_mass[n]
        and name not in loaded
    )
    return tuple(alone)


def _member(made: _Builder, i: int, apart: bool) -> None:
    """Unknowns and equations of member i."""
    here = made.here
    name, axes, dim = here.system.members[i], here.axes[i], here.system.dim
    joint = here.data["joint_force"].values[i]
    A, B = (made.add(f"{name} {end}", tuple("xyz"[:dim]), joint[e]) for e, end in enumerate("AB"))
    rods, L = here.rods(i), here.length(i)
    acting = [(one, unit) for one, unit in zip(here.on_bars, here.on_bars_of_unit, strict=True) if one.action.member == i]
    if len(rods) == 1 or not apart:
        mass = sum(rod.mass for rod in rods)
        # a massless member has no centre: any point serves
        centre = sum(rod.mass * rod.centre for rod in rods) / mass if mass else L / 2
        _balance(made, name, rods, centre, axes, [(A, 0.0, np.eye(dim)), (B, L, np.eye(dim))], acting=acting)
    else:
        base, tube = rods
        S, M = _interface(made, name, dim)
        nut, along = L - tube.length, axes.T
        at_a, at_b = ([pair for pair in acting if pair[0].on_tube == tubes] for tubes in (False, True))
        unknown_forces = [(A, 0.0, np.eye(dim)), (S, nut, along)]
        _balance(made, base.name, (base,), base.centre, axes, unknown_forces, (M, np.eye(len(M))), at_a)
        unknown_forces = [(B, L, np.eye(dim)), (S, nut, -along)]
        _balance(made, tube.name, (tube,), tube.centre, axes, unknown_forces, (M, -np.eye(len(M))), at_b)
    if here.system.kind[i] in (ELASTIC, FREE):
        _law(made, i, A, B, acting)


def _interface(made: _Builder, name: str, dim: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    at = {"active": name}
    moments = ("moment_3",) if dim == 2 else ("moment_2", "moment_3")
    force, moment = (made.here.data[f"interface_{kind}"].sel(at).values for kind in ("force", "moment"))
    columns = made.add(f"{name} interface", (*("axial", "shear_2", "shear_3")[:dim], *moments), np.append(force, moment))
    return columns[:dim], columns[dim:]


def _balance(
    made: _Builder,
    body: str,
    rods: tuple[Rod, ...],
    centre: float,
    axes: NDArray[np.float64],
    unknown_forces: list[tuple[NDArray[np.int64], float, NDArray[np.float64]]],
    couple: tuple[NDArray[np.int64], NDArray[np.float64]] | None = None,
    acting: Sequence[tuple[OnBar, OnBar]] = (),
) -> None:
    """Sum of forces, and of moments about `centre`, m from A; each unknown force is columns, place (m from A), directions.

    couple : columns, and the moments of a unit of each. acting : actions on the member, total and for a unit of its drive or
        coupling.
    """
    here, dim, turn = made.here, made.here.system.dim, turning(axes)
    # offset of the centre of a planar body from the axis, m, times the direction of the axis
    lean = rods[0].side * axes[:1] if rods[0].side else None
    push = sum((rod.mass * (rod.acceleration - here.gravity) for rod in rods), np.zeros(dim))
    spin = turn @ sum(((rod.centre - centre) * rod.mass * rod.acceleration + rod.swing for rod in rods), np.zeros(dim))
    forces = [(c, d) for c, _, d in unknown_forces]
    moments = [(c, (at - centre) * turn @ d) for c, at, d in unknown_forces]
    if lean is not None:
        moments += [(c, lean @ d) for c, _, d in unknown_forces]
    if couple is not None:
        moments.append(couple)
    for one, unit in acting:
        known = one.action.kind in GIVEN
        it = one if known else unit
        about = (it.at - centre) * (turn @ it.force) + it.couple + (0.0 if lean is None else lean @ it.force)
        if known:
            push, spin = push - it.force, spin - about
        else:
            column = made.amount(it.key)
            forces.append((column, it.force[:, None]))
            moments.append((column, about[:, None]))
    made.write(body, tuple(f"force {axis}" for axis in "xyz"[:dim]), forces, push)
    made.write(body, ("moment 3",) if dim == 2 else ("moment 2", "moment 3"), moments, spin)


def _law(made: _Builder, i: int, A: NDArray[np.int64], B: NDArray[np.int64], acting: list[tuple[OnBar, OnBar]]) -> None:
    """Equation of the mean tension of an elastic bar by its law, or of a free bar by its damper.

    (F_B - F_A) . u/2 is the mean tension plus what the mass adds, m u . (a_B - a_A)/12, minus the equivalent end forces of the
    actions on the bar.
    """
    here, system = made.here, made.here.system
    u = here.axes[i, 0]
    apart = u @ (here.a[system.q[i]] - here.a[system.p[i]])
    L, Ld = np.array([here.length(i)]), np.array([u @ (here.v[system.q[i]] - here.v[system.p[i]])])
    # (F_B - F_A) . u/2 = N + m u . (a_B - a_A)/12
    N = bar_laws(system, L, Ld, [i]).tension[0]
    terms, right = [(A, -u[None] / 2), (B, u[None] / 2)], N + system.rods[i, 0] * apart / 12
    for it, unit in acting:
        if it.action.kind in GIVEN:
            right -= u @ (it.worth[1] - it.worth[0]) / 2
        else:
            terms.append((made.amount(it.key), np.array([[u @ (unit.worth[1] - unit.worth[0]) / 2]])))
    made.write(system.members[i], ("law",), terms, np.array([right]))


def _grounds(made: _Builder, joints: tuple[str, ...]) -> None:
    """Unknown reactions, and forces of drives."""
    here, model = made.here, made.here.system.model
    for node, force in zip(*held_forces(here.data), strict=True):
        if node not in joints:
            axes = tuple(axis for axis in "xyz" if axis in model.fixed[node])
            made.add(f"{node} reaction", axes, force[["xyz".index(axis) for axis in axes]])
    for drive, record in model.all_drives.items():
        if isinstance(record, CoordinateDrive):
            made.add(drive, ("push",), here.data["drive_force"].sel(drive=[drive]).values)
    for name in made.here.several:
        if (kind := made.here.kind_of(name)) not in GIVEN:
            made.amount((kind, name))


def _node(made: _Builder, node: str) -> None:
    """Minus forces on members, plus reaction and drive forces = m (a - g) - loads; for bodies sum m_ij (a_j - g)."""
    here, system = made.here, made.here.system
    n, dim = system.node_index(node), system.dim
    unit = np.eye(dim)
    ends = [f"{system.members[i]} {end}" for i in range(len(system.members)) for end in _ends_at(system, i, n)]
    terms = [(_columns(made, end, "xyz"[:dim]), -unit) for end in ends]
    held = system.model.fixed.get(node, "")
    terms += [(_columns(made, f"{node} reaction", axis), unit[:, ["xyz".index(axis)]]) for axis in held]
    for drive, record in system.model.all_drives.items():
        if isinstance(record, CoordinateDrive) and record.node == node:
            terms.append((_columns(made, drive, ("push",)), unit[:, ["xyz".index(record.axis)]]))
    load = sum((force for _, force in here.loads_on(n)), np.zeros(dim))
    for name, (amount, _) in here.several.items():
        if (left := here.left_on(n, name)).any():
            if (kind := here.kind_of(name)) in GIVEN:
                load = load + amount * left
            else:
                terms.append((made.amount((kind, name)), left[:, None]))
    push, weight = here.bodies_at(n)
    if (elements := here.elements_at(n)) is not None:
        push, weight = push + elements[1], weight + elements[2] + elements[0]
    right = system.lump[n] * (here.a[n] - here.lump_gravity[n]) + push - weight - load - here.others[n]
    made.write(f"node {node}", tuple(f"force {axis}" for axis in "xyz"[:dim]), terms, right)


def _ends_at(system: System, i: int, node: int) -> str:
    """The ends of member i that are at a node: ``A``, ``B`` or none."""
    return "".join(end for end, at in (("A", system.p[i]), ("B", system.q[i])) if at == node)


def _columns(made: _Builder, subject: str, names: Iterable[str]) -> NDArray[np.int64]:
    return np.array([made.unknowns[f"{subject} {name}"] for name in names])
