"""Small displacements of an elastic truss: the stiffness method in mixed form."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np
from scipy.sparse import block_array, csr_array, diags_array, vstack

from kinetruss.elements.beam_matrices import mode_gradients
from kinetruss.elements.kinds import present
from kinetruss.errors import InputError, few
from kinetruss.kernels.structure.structure import LENGTH, SUM
from kinetruss.mechanics import FREE, NONE, System, cached, constraint_jacobian, ends_of
from kinetruss.mechanics.elements import continuum_stiffness, named_laws
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.matrices import bar_laws
from kinetruss.mechanics.mobility import beam_deformations, deformations, mobility_at
from kinetruss.mechanics.tables import elements, pair_weights
from kinetruss.statics.frame_motions import Motions, motions_of, reduced
from kinetruss.statics.refinement import best_of, each_of, fill_order

if TYPE_CHECKING:
    from numpy.typing import NDArray


Weight = bool | Literal["lumped"]


def weight_word(weight: Weight) -> str:
    """``all``, ``lumped`` or ``none``; InputError for anything else."""
    if weight is True or weight is False:
        return "all" if weight else "none"
    if weight == "lumped":
        return "lumped"
    raise InputError(
        f"weight={weight!r}: give True (members and lumped masses), 'lumped' (massless members) or False (nothing weighs)."
    )


def loads_at(system: System, t: NDArray[np.float64], load_case: str | None, word: str, *, rotating: bool = False) -> Loads:
    """Loads of a case with the chosen weights; loads in time are taken at the times t. rotating : as of `case_loads`.

    Raises
    ------
    InputError : a base that rotates, with masses left out.
    """
    loads = case_loads(system, t, load_case, rotating=rotating)
    if word == "all":
        return loads
    if loads.base is not None:
        raise InputError("Masses that do not weigh do not rotate with the base. Give weight=True, or leave out base_rotation.")
    lump = loads.lump_gravity if word == "lumped" else np.zeros_like(loads.lump_gravity)
    return replace(loads, gravity=np.zeros(3), lump_gravity=lump)


def end_weights(system: System, x: NDArray[np.float64], g: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weight of members at their ends A and B, (members, 2, 3) N, at positions x (n, 3) under gravity g (3,).

    Half at each end for a uniform bar, by the place of its centre for a planar body. Along an active member, the base is
    carried by end A and the tube by end B; across it, the lever rule applies.
    """
    found, out = elements(system), np.zeros((len(system.members), 2, 3))
    own = found["pair_member"] >= 0
    out[found["pair_member"][own]] = pair_weights(found["pair"][own], g)
    # varying masses: m_A g and m_B g, and across the member the lever of the first moments h over L
    member, (m_A, m_B, h_A, h_B, _, _) = found["varying_member"], found["varying"].T[:, :, None]
    d = x[system.q[member]] - x[system.p[member]]
    L = np.linalg.norm(d, axis=1)[:, None]
    lever = (h_A - h_B) / L * (g - (d @ g)[:, None] * d / L**2)
    out[member, 0] += m_A * g - lever
    out[member, 1] += m_B * g + lever
    return out


# The stiffness method in mixed form: small displacements and forces of pin-jointed bars from one sparse symmetric matrix.
#
#     f N - G u = 0,   G^T N + C u = F
#
# f = l/(E A), or one over the slope of a law, of bars and springs; 0 of bars without one and of locked angles, which are
# inextensible. The deformations of beams are rows too, f one over their rigidity; C are membranes and solids. Forces come
# from equilibrium, not from differences of displacements: of a determinate truss they do not depend on f, and the accuracy that
# the condition of G^T f^-1 G would cost is kept (Bjorck, Numerical Methods for Least Squares Problems, 1996, section 2.5).

SURE = 1e-8
"""Error bound above which the rank is checked."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Solved:
    """displacement (3 n,) m, elongation (rows,) m and force (rows,) N of the rows of `stiff_rows`. errors : bounds on the
    errors of forces and displacements, relative to the largest force (beside membranes, solids and beams: or load) and
    displacement. inner (3 n,) : forces of beams, membranes and solids against the displacements, N.
    """

    displacement: NDArray[np.float64]
    elongation: NDArray[np.float64]
    force: NDArray[np.float64]
    errors: tuple[float, float]
    inner: NDArray[np.float64]


@cached()
def stiff_rows(system: System) -> System:
    """The system with a row for every member that carries force, elastic ones too, driven angles, sums, force elements."""
    members = np.flatnonzero(system.kind != FREE)
    angles = system.row_kind != LENGTH
    count, own = len(members), system.force_element_measure
    extra = len(own)
    return replace(
        system,
        row_member=np.concatenate([members, system.row_member[angles], np.zeros(extra)]).astype(np.int32),
        row_kind=np.concatenate([np.full(count, LENGTH), system.row_kind[angles], np.full(extra, SUM)]).astype(np.int8),
        row_drive=np.concatenate([np.full(count, -1), system.row_drive[angles], np.full(extra, -1)]).astype(np.int32),
        row_value=np.concatenate([system.length0[members], system.row_value[angles], system.measure_start[own]]),
        row_measure=np.concatenate([np.full(count, -1), system.row_measure[angles], own]),
    )


def element_rows(held: System) -> NDArray[np.int64]:
    """The rows of elements on coordinates among `stiff_rows`, in their order."""
    return np.arange(len(held.row_kind) - len(held.force_elements), len(held.row_kind))


def flexibility(held: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """l/(E A) of the rows at positions x (n, 3), m/N; 0 for inextensible ones, infinite for slack cables and springs in play.

    Active members have their `Compliance`; elastic bars, cables and springs one over the slope of their law at their present
    length.
    """
    i = held.row_member
    length = ends_of(held, x, i)[1]
    found = np.nan_to_num(held.compliance[i]) * length + held.yielding[i]
    if held.law.any():
        pulling = held.law[i] != NONE
        with np.errstate(divide="ignore"):
            found[pulling] = 1 / bar_laws(held, length, member=i).slope[pulling]
    found[held.row_kind != LENGTH] = 0.0
    if held.force_elements:
        with np.errstate(divide="ignore"):
            # a row is the coordinate times its scale, so its force the force on the coordinate over the scale
            found[element_rows(held)] = held.measure_scale[held.force_element_measure] ** 2 / named_laws(held, x)[:, 1]
    return np.asarray(found)


def solve(
    held: System,
    x: NDArray[np.float64],
    flexible: NDArray[np.float64],
    load: NDArray[np.float64],
    given: NDArray[np.float64] | None = None,
) -> Solved:
    """Displacements and forces under nodal forces load (3 n,), N, at positions x (n, 3), with error bounds.

    given (rows,) : elongations of inextensible rows that are prescribed, m.

    Raises
    ------
    InputError : a mechanism, named; inextensible bars whose forces are not unique.
    """
    known = _assembled(held, x, flexible)
    prescribed = np.zeros(len(flexible)) if given is None else given
    b, push = known.right(load, np.append(prescribed, np.zeros(len(known.kept) - len(flexible))))
    # elements may carry the load alone: the forces of bars are then 0 but for round-off
    least = 1.0 if held.continua is not None or known.only.nnz else 0.0
    found = best_of(known.matrix, b, known.parts, _order(held), least)
    if not found.worst <= SURE:
        _explain(held, x, flexible)
    displacement, force = known.unscaled(found.y, push, load)
    rows, inner, slack = len(flexible), np.zeros(held.x0.size), np.isinf(flexible)
    stretched = np.where(slack, 0.0, flexible) * force[:rows] + prescribed
    elongation = np.where(slack, known.whole[:rows] @ displacement[held.free], stretched)
    if held.continua is not None or known.only.nnz:
        inner = known.only @ displacement + beam_rows(held, x).T @ force[rows:]
    return Solved(
        displacement=displacement,
        elongation=elongation,
        force=force[:rows],
        errors=(found.errors[0], found.errors[1]),
        inner=inner,
    )


def solve_each(
    held: System,
    x: NDArray[np.float64],
    flexible: NDArray[np.float64],
    load: NDArray[np.float64],
    given: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Displacements (k, 3 n) and forces (k, rows + r) of rows and deformations of beams as of `solve`, for several loads
    (k, 3 n) and prescribed elongations (k, rows + r), where `solve` has an answer: one factorisation, no error bounds.
    """
    known = _assembled(held, x, flexible)
    aside = [known.aside(one) for one in given]
    right = [
        known.right(own - known.only @ u, one - known.whole @ u[held.free])
        for own, one, u in zip(load, given, aside, strict=True)
    ]
    found = each_of(known.matrix, [b for b, _ in right], known.parts, _order(held))
    back = [known.unscaled(y, push, *own) for y, (_, push), *own in zip(found, right, load, aside, strict=True)]
    return np.array([one for one, _ in back]), np.array([one for _, one in back])


class _Assembled(NamedTuple):
    """The matrix for forces and -displacements, scaled, of the rows and free coordinates that are unknowns.

    whole (rows + r, free) : gradients of the rows and of the deformations of beams. only (3 n, 3 n) : stiffness of elements
    without rows. f (rows + r,) flexibilities; slack, kept (rows + r,). size : of flexibilities, m/N. forces : their number.
    """

    held: System
    x: NDArray[np.float64]
    whole: Any
    only: Any
    motions: Motions | None
    slack: NDArray[np.bool_]
    kept: NDArray[np.bool_]
    size: float
    matrix: csr_array
    forces: int

    @property
    def parts(self) -> list[slice]:
        """Forces, then displacements, among the unknowns."""
        return [slice(0, self.forces), slice(self.forces, self.matrix.shape[0])]

    def right(self, load: NDArray[np.float64], given: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
        """The right-hand side for nodal forces (3 n,), N, and prescribed elongations (rows + r,), m, and its scale, N."""
        push_on = load[self.held.free] if self.motions is None else self.motions.to.T @ load[self.held.free]
        push = max(float(np.abs(push_on).max(initial=0.0)), float(np.abs(given).max(initial=0.0)) / self.size) or 1.0
        return np.concatenate([-given[self.kept] / (push * self.size), push_on / push]), push

    def aside(self, given: NDArray[np.float64]) -> NDArray[np.float64]:
        """Displacements (3 n,) of the tips of frames whose bars have prescribed elongations, of (rows + r,)."""
        if self.motions is None or not given[row := self.motions.frames.row].any():
            return np.zeros(self.held.x0.size)
        return self.motions.stretched(self.x, given[row])

    def unscaled(
        self, y: NDArray[np.float64], push: float, load: NDArray[np.float64], aside: NDArray[np.float64] | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Displacements (3 n,) and forces (rows + r,) from a solution under nodal forces (3 n,), beside those of `aside`."""
        force, displacement = np.zeros(len(self.kept)), np.zeros(self.held.x0.size)
        force[self.kept] = y[: self.forces] * push
        moved = -y[self.forces :] * push * self.size
        displacement[self.held.free] = moved if self.motions is None else self.motions.to @ moved
        if aside is not None:
            displacement += aside
        if self.motions is not None:
            left = np.zeros(self.held.x0.size)
            left[self.held.free] = (load - self.only @ displacement)[self.held.free] - self.whole.T @ force
            force[self.motions.frames.row] = self.motions.bar_forces(self.x, left)
        return displacement, force


def _assembled(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64]) -> _Assembled:
    rows, (whole, soft) = len(flexible), with_beams(held, x)
    only, motions = elements_only(held, x), motions_of(held, x)
    C = csr_array(only)[held.free][:, held.free]
    slack = np.append(np.isinf(flexible), np.zeros(len(soft), np.bool_))
    f = np.where(slack, 0.0, np.concatenate([flexible, soft]))
    kept = np.ones(len(f), np.bool_)
    if motions is not None:
        kept[:rows], C = motions.kept, csr_array(motions.to.T @ C @ motions.to)
    size = float(f.max(initial=0.0)) or 1.0 / (float(np.abs(C.data).max(initial=0.0)) or 1.0)
    matrix = _saddle(reduced(motions, whole, len(soft)), f[kept] / size, slack[kept], size * C)
    return _Assembled(held, x, whole, only, motions, slack, kept, size, matrix, int(kept.sum()))


def beam_rows(held: System, x: NDArray[np.float64]) -> csr_array:
    """The deformations of beams as rows of unit size (r, 3 n)."""
    return beam_deformations(held, x).rows


def with_beams(held: System, x: NDArray[np.float64]) -> tuple[Any, NDArray[np.float64]]:
    """Gradients (rows, free) of the rows, then of the deformations of beams; and the flexibilities of these, m/N."""
    G = constraint_jacobian(held, x)[:, held.free]
    if held.continua is None or held.continua.beams is None:
        return G, np.zeros(0)
    beams = held.continua.beams
    own = mode_gradients(beams, x)
    # a row of unit size is the mode over the size of its gradient
    soft = 1.0 / (beams.rigidity.reshape(-1) * np.asarray(own.multiply(own).sum(axis=1)).reshape(-1))
    return csr_array(vstack([G, beam_rows(held, x)[:, held.free]])), soft


def _saddle(G: Any, f: NDArray[np.float64], slack: NDArray[np.bool_], C: Any) -> csr_array:
    """[[f, G], [G^T, -C]] for forces N and displacements -u; rows of slack cables say N = 0."""
    if slack.any():
        f = np.where(slack, 1.0, f)
        G = csr_array(diags_array(np.where(slack, 0.0, 1.0)) @ G)
    return csr_array(block_array([[diags_array(f), G], [G.T, -C]]))


@cached()
def _order(held: System) -> NDArray[np.int64]:
    """Order of elimination of forces and displacements: that of the stiffness matrix, every force before its first node."""
    whole, soft = with_beams(held, held.x0)
    motions = motions_of(held, held.x0)
    G, C = reduced(motions, whole, len(soft)), abs(_continuum(held, held.x0))
    if motions is not None:
        C = abs(motions.to).T @ C @ abs(motions.to)
    unit = csr_array((np.ones(G.nnz), G.indices, G.indptr), shape=G.shape)
    place = np.argsort(fill_order(unit.T @ unit + C))
    first = np.full(G.shape[0], -1.0)
    touched = np.diff(unit.indptr) > 0
    if touched.any():
        first[touched] = np.minimum.reduceat(place[unit.indices], unit.indptr[:-1][touched]) - 0.5
    return np.argsort(np.concatenate([first, place]), kind="stable")


def _continuum(held: System, x: NDArray[np.float64]) -> Any:
    """Stiffness of membranes and solids over the free coordinates, N/m, without that of their stresses at x."""
    return csr_array(elements_only(held, x))[held.free][:, held.free]


def elements_only(held: System, x: NDArray[np.float64]) -> Any:
    """The same over all coordinates: of all continua but beams, whose deformations are rows, and of kinds without rows."""
    found, K = held.continua, csr_array((x.size, x.size))
    if found is not None and found.patches:
        K = continuum_stiffness(held, x)
    for one, record in present(held):
        if not one.rows:
            K = K + one.tangents(held, record, x, None)[0]
    return K


def _explain(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64]) -> None:
    """Raise an InputError that names the mechanism, or the inextensible bars whose forces are not unique."""
    pulling = _rows_of(held, np.isfinite(flexible))  # slack cables have no stiffness
    found = mobility_at(pulling, x, deformations)
    if found.undriven:
        moves = "; ".join(found.mechanism_texts(4))
        loose = held.parts_of(np.flatnonzero(np.isinf(flexible)))
        slack = f"Slack here, so that they hold nothing: {few(loose, 6)}. " if loose else ""
        raise InputError(
            f"{slack}The structure is a mechanism here, with all drives locked ({found.undriven} "
            f"freedom{'s' if found.undriven != 1 else ''}): {moves}. Add a bar or a support for each."
        )
    rigid = _rows_of(held, flexible == 0)
    shared = mobility_at(rigid, x)
    if shared.self_stress:
        raise InputError(
            f"The forces of inextensible bars are not unique: {shared.self_stress_texts(1)[0]}. "
            "Give them a section and a material (E and A)."
        )


def _rows_of(held: System, chosen: NDArray[np.bool_]) -> System:
    """The system with some of its rows only."""
    return held.with_rows(chosen)
