"""Mobility of a structure: rank, mechanisms and states of self-stress by name."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import coo_array, csr_array, diags_array, vstack

from kinetruss.display import counted
from kinetruss.elements.beam_matrices import mode_gradients
from kinetruss.elements.caching import cached
from kinetruss.errors import Fault, InputError, few
from kinetruss.kernels.structure.structure import LENGTH, SUM
from kinetruss.mechanics.arguments import positions_of
from kinetruss.mechanics.arrangement import eliminated
from kinetruss.mechanics.mode_texts import moves_text, self_stress_text
from kinetruss.mechanics.null_space import Spaces, outside
from kinetruss.mechanics.row_gradients import RANK_TOLERANCE, constraint_jacobian, ends_of, row_directions, row_ends
from kinetruss.mechanics.system import System, compile
from kinetruss.model import CoordinateDrive, Model
from kinetruss.model.beam_checks import SPIN
from kinetruss.model.beam_frames import line_advice
from kinetruss.model.joints import GROUND
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray


# What beams, membranes and solids resist besides the rows of a system: gradients of their strains, as rows of unit size.
#
# Stiffnesses do not enter, only whether there is one: a change of positions that leaves all these strains and all rows as
# they are is a mechanism, whatever the slenderness of the parts. The rank of unit rows decides this for long chains of
# slender beams, where the least eigenvalue of a stiffness is far below the rounding of the largest.

STRAINED = 1e-10
"""Eigenvalues of the stiffness of an element above this fraction of its largest belong to strains."""


class Deformations(NamedTuple):
    """rows (r, 3 n) : unit gradients of strains. names (r,) : of the beam, of the membrane or of the solid of each."""

    rows: csr_array
    names: tuple[str, ...]


def beam_deformations(system: System, x: NDArray[np.float64]) -> Deformations:
    """Of elastic beams at positions x (n, 3): three for each in the plane, six in space."""
    beams = None if system.continua is None else system.continua.beams
    if beams is None:
        return Deformations(csr_array((0, x.size)), ())
    names = tuple(name for name in beams.names for _ in range(beams.rigidity.shape[1]))
    return Deformations(_unit(mode_gradients(beams, x)), names)


def deformations(system: System, x: NDArray[np.float64]) -> Deformations:
    """Of elastic beams, membranes and solids at positions x (n, 3)."""
    own = beam_deformations(system, x)
    found = system.continua
    if found is None or not found.patches:
        return own
    rows = [_elements(system, x, v) for v in found.groups]
    whole = csr_array(vstack(rows))
    return Deformations(csr_array(vstack([own.rows, whole])), (*own.names, *("" for _ in range(whole.shape[0]))))


def _elements(system: System, x: NDArray[np.float64], v: int) -> csr_array:
    """Of the elements of membranes and solids with v nodes: the strains with stiffness, by squared lengths of their edges."""
    found: Any = system.continua
    edge, upper = found.groups[v]
    w = edge.shape[1]
    stiff = np.zeros((len(edge), w, w))
    i, j = np.triu_indices(w)
    stiff[:, i, j] = stiff[:, j, i] = upper
    values, modes = np.linalg.eigh(stiff)
    element, mode = np.nonzero(values > STRAINED * values[:, -1:])
    share = modes[element, :, mode]  # (r, w) coefficients of the edges
    d = 2 * (x[found.q[edge]] - x[found.p[edge]])[element] * share[:, :, None]
    row = np.broadcast_to(np.arange(len(element))[:, None, None], d.shape).reshape(-1)
    parts = []
    for nodes, sign in ((found.p, -1.0), (found.q, 1.0)):
        columns = (3 * nodes[edge][element].astype(np.int64)[:, :, None] + np.arange(3)).reshape(-1)
        parts.append(coo_array((sign * d.reshape(-1), (row, columns)), shape=(len(element), x.size)))
    return _unit(csr_array(parts[0] + parts[1]))


def _unit(rows: csr_array) -> csr_array:
    size = np.sqrt(np.asarray(rows.multiply(rows).sum(axis=1)).reshape(-1))
    return csr_array(diags_array(1.0 / np.where(size > 0, size, 1.0)) @ rows)


# Mobility of a structure: rank, mechanisms and states of self-stress by name.

QUICK = 600
"""Rows and columns up to which an elimination is faster than inverse iteration."""
LINES = 40
"""Largest number of mechanisms, and of states of self-stress, that are printed."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Mobility:
    """Count and rank of a structure at one configuration (Maxwell 1864; Calladine 1978; Pellegrino & Calladine 1986).

    bars : rigid bars; link_bars : those of them that stand for rigid links. beams : elastic ones, and links : those of the
    user, which count as rigid here: what only bends them is no freedom. couplings : between coordinates. drives : prescribed
    coordinates.
    coordinates, fixed : of the user's nodes, with the rotations of beams and hubs. rank : of rigid bars, beams and couplings.
    degrees_of_freedom : freedoms before drives = coordinates - fixed - rank.
    undriven : freedoms left with all drives held. self_stress : number of states with all drives held.
    maxwell : coordinates - fixed - rigid bars - couplings - drives = undriven - self_stress (Calladine's count); each beam
    counts as 3 bars in the plane, 6 in space.
    node_names, row_names : names of nodes, inner ones included, and of what is held; of a beam once for each deformation.
    spaces : null spaces of the row-normalised Jacobian; their vectors are computed at first use.
    """

    coordinates: int
    fixed: int
    bars: int
    beams: int
    links: int
    link_bars: int
    couplings: int
    drives: int
    rank: int
    degrees_of_freedom: int
    undriven: int
    self_stress: int
    maxwell: int
    node_names: tuple[str, ...]
    row_names: tuple[str, ...]
    system: System = field(repr=False)
    position: NDArray[np.float64] = field(repr=False)
    spaces: Spaces = field(repr=False)

    @cached_property
    def mechanisms(self) -> NDArray[np.float64]:
        """(undriven, n_nodes, dim) displacements with all drives held, the largest component of each 1."""
        return self._flat.reshape(self.undriven, len(self.node_names), 3)[:, :, : self.system.dim]

    @cached_property
    def self_stress_states(self) -> NDArray[np.float64]:
        """(self_stress, n_rows) forces, the largest of each 1; row_names name the rows."""
        return self.spaces.left.T

    @cached_property
    def second_order(self) -> tuple[bool, ...]:
        """True for infinitesimal mechanisms that a self-stress stiffens to second order, as flat arrangements across their
        plane. Some s has sum of s_r |dd_r|^2/L_r other than 0 (Pellegrino & Calladine 1986).
        """
        return self._soft(self.undriven)

    def _soft(self, most: int) -> tuple[bool, ...]:
        """`second_order` of the first mechanisms."""
        if not self.self_stress or not self.undriven:
            return (False,) * min(most, self.undriven)
        return _stiffened(self.system, self.position, self._flat[:most])

    @cached_property
    def smallest_singular_value(self) -> float:
        """Of the row-normalised Jacobian over all rows, the larger side being the bars or coordinates."""
        return self.spaces.smallest

    @cached_property
    def _flat(self) -> NDArray[np.float64]:
        found = np.zeros((self.undriven, self.system.x0.size))
        found[:, self.system.free] = self.spaces.right.T
        return found

    def __str__(self) -> str:
        held = [counted(self.bars - self.link_bars, "rigid bar")]
        held += [counted(self.beams, "elastic beam")] if self.beams else []
        inside = f" (rigid, as {counted(self.link_bars, 'bar')})" if self.link_bars else ""
        held += [f"{counted(self.links, 'link')}{inside}"] if self.links else []
        held += [counted(self.couplings, "coupling")] if self.couplings else []
        lines = [
            f"{', '.join(held)}, {self.coordinates} coordinates, {self.fixed} fixed, "
            f"rank {self.rank}: "
            f"{counted(self.degrees_of_freedom, 'degree')} of freedom, {counted(self.drives, 'drive')}",
            f"with the drives held: {counted(self.undriven, 'mechanism')}, {counted(self.self_stress, 'state')} of self-stress "
            f"(count {self.maxwell} = {self.undriven} - {self.self_stress})",
        ]
        lines += [f"  mechanism {i + 1}: {text}" for i, text in enumerate(self.mechanism_texts(LINES))]
        lines += [f"  and {self.undriven - LINES} more mechanisms"] * (self.undriven > LINES)
        lines += [f"  self-stress {i + 1}: {text}" for i, text in enumerate(self.self_stress_texts(LINES))]
        lines += [f"  and {self.self_stress - LINES} more states of self-stress"] * (self.self_stress > LINES)
        if soft := yielding(self.system):
            lines.append(f"not counted, since they yield or have a gap: supports {few(soft, LINES)}")
        return "\n".join(lines)

    def mechanism_texts(self, most: int | None = None) -> list[str]:
        """Each mechanism in words, the first `most`: which node moves in which direction, largest first."""
        softly = self._soft(self.undriven if most is None else most)
        return [
            moves_text(self.system, mode) + (self._loose(mode) if flat else "")
            for mode, flat in zip(self.mechanisms[:most], softly, strict=True)
        ]

    def _loose(self, mode: NDArray[np.float64]) -> str:
        """What a mechanism (n_nodes, dim) that is stiff to second order needs."""
        given = self.system.given
        on_links = {node for link in given.links.values() for node in link.nodes}
        moved = np.abs(mode).max(axis=1) > 1e-6
        moving = [name for name, one in zip(self.node_names, moved, strict=True) if one and name in given.nodes]
        if self.system.dim == 3:
            fix = "hold a node off the plane by bars, or add a support"
        elif on_links.issuperset(moving):
            fix = "draw it beside that position, or add a support"
        else:
            fix = "a member with a pin in its middle is a link (links: {boom: [A, M, C]}), or add a support"
        return f" -- stiff to second order only, loose under the least load: {line_advice(self.system.model) or fix}"

    def self_stress_texts(self, most: int | None = None) -> list[str]:
        """Each state of self-stress in words, the first `most`: which bars are in compression or tension, largest first."""
        return [self_stress_text(self.system, state, self.row_names) for state in self.self_stress_states[:most]]


@one_thread
def mobility(model: Model, position: NDArray[np.float64] | None = None) -> Mobility:
    """Degrees of freedom, mechanisms and states of self-stress of a model.

    Parameters
    ----------
    position : (n_nodes, dim), m; by default the model's own configuration.

    Notes
    -----
    Decided by the singular values of the Jacobian of lengths and angles with unit rows; values below 1e-9 of the largest
    count as zero. By rank, never by count. Up to 600 rows and coordinates an elimination finds the rank where bounds of the
    singular values leave no doubt. Of more than 300 else only the lowest are found, with sparse
    factors, in little more than proportion to the size; a long truss with a small bending stiffness then does not count as
    a mechanism: its bars rotate as little as they elongate. The vectors are computed at first use.

    >>> import kinetruss as kt
    >>> square = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}, fixed=["A", "B"],
    ...                   bars={"b": ("B", "C"), "c": ("C", "D"), "d": ("D", "A")})
    >>> print(kt.kinematics.mobility(square))
    3 rigid bars, 8 coordinates, 4 fixed, rank 3: 1 degree of freedom, 0 drives
    with the drives held: 1 mechanism, 0 states of self-stress (count 1 = 1 - 0)
      mechanism 1: C moves along x (+1.000), D moves along x (+1.000)
    """
    system = compile(model)
    return mobility_at(system, positions_of(system, position), beam_deformations)


def mobility_at(
    system: System, x: NDArray[np.float64], held: Callable[[System, NDArray[np.float64]], Deformations] | None = None
) -> Mobility:
    """`mobility` of a compiled system at positions x (n, 3). held : the deformations that are held beside its rows, e.g. those
    of its beams (`beam_deformations`); by default none.
    """
    found = Deformations(csr_array((0, x.size)), ()) if held is None else held(system, x)
    own = np.append(system.row_drive < 0, np.ones(len(found.names), np.bool_))
    quick = max(len(own), len(system.free)) <= QUICK
    sure = eliminated(system, x) if quick and not found.names else None
    J: Any = constraint_jacobian(system, x)[:, system.free] if sure is None else sure.J
    if found.names:
        J = csr_array(vstack([J, found.rows[:, system.free]]))
        if quick:
            from kinetruss.mechanics.elimination import Elimination  # kernels, which few checks need

            whole = Elimination(J.toarray(), ~own)
            sure = whole if whole.sure else None
    spaces = Spaces(J, lambda change: _hardly_strains(system, x, change, found.rows[:, system.free]), sure)
    if sure is not None:
        rank = sure.first
    else:
        rank = spaces.rank if own.all() else Spaces(J[own], spaces.near).rank
    rows, columns = J.shape
    driven, counted = len(system.coordinate_drive), _counted(system)
    return Mobility(
        **counted.of,
        beams=sum(name in system.given.beams for name in set(found.names)),
        rank=rank - counted.braces,
        degrees_of_freedom=columns + driven - rank,
        undriven=columns - spaces.rank,
        self_stress=rows - spaces.rank,
        maxwell=columns - rows,
        node_names=system.nodes,
        row_names=(*system.row_names, *found.names),
        system=system,
        position=x,
        spaces=spaces,
    )


class _Counted(NamedTuple):
    """Numbers of parts by the fields of `Mobility`; braces : rows that only hold what stands for the user's parts together."""

    of: dict[str, int]
    braces: int


@cached(of_records=True)
def _counted(system: System) -> _Counted:
    """Coordinates and parts as the user has them, without those that stand for others."""
    dim, driven, inner, own = system.dim, len(system.coordinate_drive), system.inner, system.row_drive < 0
    idle = (dim - 1) * sum(node.scalar for node in system.model.nodes.values())
    # of inner nodes and the bars that hold them only the rotations count that they represent
    places = np.array([system.node_index(name) for name in inner.nodes], np.int64)
    loose = int((~system.prescribed.reshape(-1, 3)[places, :dim]).sum())
    length = own & (system.row_kind == LENGTH)
    framed = {node for frame in inner.frames.values() for node in frame.nodes} | {hinge.node for hinge in inner.hinges}
    rest = inner.nodes.keys() - framed
    added = [name in inner.bars and any(end in rest for end in one.ends) for name, one in system.model.members.items()]
    bars = int((length & np.array(added, np.bool_)[system.row_member]).sum())
    users = np.array([name not in inner.bars or inner.bars[name].table == "bodies" for name in system.members], np.bool_)
    own_bars = int((length & users[system.row_member]).sum())
    # a frame that moves by itself is one rotation in the plane, three in space; what else holds at it counts as bars
    free = {
        name
        for name, held in zip(system.nodes, system.prescribed.reshape(-1, 3)[:, :dim].tolist(), strict=True)
        if not all(held)
    }
    own_turns = [
        name
        for name, frame in inner.frames.items()
        if free.intersection(frame.nodes) and system.model.clamped.get(name, GROUND) == GROUND
    ]
    spots = np.array([system.node_index(name) for name in framed], np.int64)
    bars += int((~system.prescribed.reshape(-1, 3)[spots, :dim]).sum()) - len(own_turns) * dim * (dim - 1) // 2
    # of inner couplings those of a rotation go with a scalar, which is the user's
    turned = {name for name, owner in inner.couplings.items() if owner.table == "hubs" or name.endswith(SPIN)}
    couplings = sum(name in turned for name in system.row_names)
    braces = bars + couplings
    of = {
        "coordinates": len(system.nodes) * dim - idle - len(places) * dim + loose - braces,
        "fixed": int(system.prescribed.sum()) - driven - len(system.nodes) * (3 - dim) - idle - (len(places) * dim - loose),
        "bars": int(length.sum()) - bars,
        "links": len(system.given.links),
        "link_bars": max(int(length.sum()) - bars - own_bars, 0) if system.given.links else 0,
        "couplings": int((system.row_kind == SUM)[system.row_drive < 0].sum()) - couplings,
        "drives": len(system.drives),
    }
    return _Counted(of, braces)


def _hardly_strains(system: System, x: NDArray[np.float64], change: NDArray[np.float64], held: csr_array) -> bool:
    """True if a change (free,) with a small effect on lengths is a mechanism, not the bending of a long structure.

    A long truss bends with little strain, but then its bars also rotate little. In a mechanism the relative displacement of
    the ends of some bar is far larger than its elongation, and than the deformations (r, free) held besides.
    """
    bars = system.row_kind == LENGTH
    flat = np.zeros(system.x0.size)
    flat[system.free] = change
    apart = row_ends(system, flat.reshape(-1, 3), bars)
    strain = np.abs(np.einsum("rc,rc->r", row_directions(system, x, rows=bars), apart)).max(initial=0.0)
    strain = max(strain, np.abs(held @ change).max(initial=0.0))
    return bool(strain <= RANK_TOLERANCE * np.linalg.norm(apart, axis=1).max(initial=0.0))


def _stiffened(system: System, x: NDArray[np.float64], modes: NDArray[np.float64]) -> tuple[bool, ...]:
    """True if a self-stress of lengths alone stiffens an infinitesimal mechanism (3 n,).

    Rigid motions and finite mechanisms have no such self-stress: the stress matrix of a self-stress maps every affine
    motion to 0. The states of self-stress of the lengths are orthogonal to the range of their Jacobian.
    """
    bars = np.flatnonzero(system.row_kind == LENGTH)
    length = ends_of(system, x, system.row_member[bars])[1]
    bent = (np.sum(row_ends(system, modes.reshape(len(modes), len(x), 3), bars) ** 2, axis=2) / length).T
    J = constraint_jacobian(system, x)[:, system.free][bars]
    stiff = np.linalg.norm(outside(J, bent), axis=0)
    return tuple(bool(one) for one in stiff > 1e-6 * np.linalg.norm(bent, axis=0) + 1e-12 / length.min(initial=np.inf))


def _beside(system: System) -> str:
    """How to leave a singular position."""
    advice = line_advice(system.model)
    return f"{advice}." if advice else "Draw it beside that position, or drive another member."


def afloat(model: Model) -> Fault | None:
    """The fault of a structure that the ground holds nowhere, where supports are needed; None if there are some."""
    on_ground = any(isinstance(drive, CoordinateDrive) for drive in model.drives.values())
    if model.fixed or model.supports or "ground" in model.clamped.values() or on_ground:
        return None
    return Fault((), "no node is fixed, so that the structure moves as a whole.", "Name the nodes at its supports in 'fixed'.")


def yielding(system: System) -> list[str]:
    """Supports, with their directions, that hold nothing rigidly: springs, and gaps."""
    return [one.text(system.dim) for one in system.inner.holdings if one.table != "couplings"]


def underdriven(system: System) -> InputError:
    """The error of a mechanism that its drives do not hold, naming the nodes that move."""
    found = mobility_at(system, system.x0, beam_deformations)
    if not found.undriven:
        way = np.zeros(system.x0.size)
        way[system.free] = found.spaces.weakest / np.abs(found.spaces.weakest).max()
        return InputError(
            f"The structure is in a singular position (smallest singular value {found.smallest_singular_value:.2g}): there "
            "its drives do not say which way it goes on. Nothing holds this: "
            f"{moves_text(system, way.reshape(-1, 3)[:, : system.dim])}. "
            f"{_beside(system)}"
        )
    if not system.prescribed.reshape(-1, 3)[:, : system.dim].any() and (free := afloat(system.given)) is not None:
        float_on = "A structure that floats can be moved by its momentum in kinematics.follow and dynamics.simulate."
        return InputError(f"{free.message.capitalize()} {free.mend} {float_on}")
    moves = "; ".join(found.mechanism_texts(4))
    mend = "Add a drive or a bar for each, or fix a node."
    if soft := yielding(system):
        mend = (
            f"Not counted, since they yield or have a gap: supports {few(soft, LINES)}. A motion of drives does not say how "
            "far. Hold them for it, or put a bar in place of each, which can have a stiffness in flexible analyses; "
            "simulations and statics take them as they are."
        )
    return InputError(
        f"The drives leave {found.undriven} freedom{'s' if found.undriven != 1 else ''} of the mechanism: {moves}. {mend}"
    )
