"""The elastic structure at the instants of a rigid motion: its matrices, and the forces that its members must carry.

Rows of the system are lengths (and locked angles, couplings) that the rigid structure keeps. Their flexibility f (m/N) makes
them elastic: with small displacements u from the rigid motion and row forces N,

    M u'' + C u' + K u + G^T N = f_nodes - M a,    G u = f N

G (rows, n): gradients of the rows; K: geometric stiffness of all members and the stiffness of springs; f = l/(E A), that of the
`Compliance` of an active member, 1/k where a stiffness is given, and 0 of what is inextensible.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array, diags_array

from kinetruss.elements.beam_matrices import mode_forces, mode_stiffness
from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import System, compile, constraint_jacobian, ends_of
from kinetruss.mechanics.balance import Balance, balance_of, balanced_rows
from kinetruss.mechanics.elements import has_elements, material_stiffness
from kinetruss.mechanics.matrices import bar_laws, mass_matrix
from kinetruss.mechanics.rows import null_basis
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Model, nearest
from kinetruss.results import Forces
from kinetruss.statics.deflections import loads_of, nodal_forces
from kinetruss.statics.small_displacements import flexibility, stiff_rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Instant", "Softness", "elastic_stiffness", "instants_of", "modes_of", "refuse_unloaded_beams", "structure_at"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Softness:
    """stiffness : member -> N/m, in place of E A/l. rigid : members kept inextensible. Checked against a model."""

    stiffness: Mapping[str, float]
    rigid: Collection[str]

    def flexibility(self, system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Of the rows (rows,), m/N, at positions x (n, 3)."""
        held = stiff_rows(system)
        bars = held.row_kind == LENGTH
        by_member = np.zeros(len(system.members))
        by_member[held.row_member[bars]] = flexibility(held, x)[bars]
        found = np.where(system.row_kind == LENGTH, by_member[system.row_member], 0.0)
        for name, k in self.stiffness.items():
            found[self._row(system, name)] = 1.0 / k
        for name in self.rigid:
            found[self._row(system, name)] = 0.0
        return found

    @staticmethod
    def _row(system: System, name: str) -> int:
        rows = np.flatnonzero(system.row_kind == LENGTH)
        known = [system.members[i] for i in system.row_member[rows]]
        if name in system.given.bending:
            raise InputError(
                f"{name!r} is a {'link' if name in system.given.links else 'beam'}, which bends as its section and material "
                "say. Only bars and active members can be named in rigid and stiffness; give it another E to make it stiffer."
            )
        if name not in known:
            own = [one for one in known if one in system.given.members]
            raise InputError(f"{name!r} is no rigid or driven member. {nearest(name, own)}".rstrip())
        return int(rows[known.index(name)])

    def __post_init__(self) -> None:
        given = (self.rigid,) if isinstance(self.rigid, str) else tuple(self.rigid)
        object.__setattr__(self, "rigid", given)
        for name, k in self.stiffness.items():
            if not (np.isfinite(k) and k > 0):
                raise InputError(f"stiffness[{name!r}] is {k} N/m. Give a positive number, or name it in rigid.")
            if name in given:
                raise InputError(f"{name!r} is rigid and has a stiffness. Name it in one of them.")


@dataclass(frozen=True, kw_only=True, eq=False)
class Instant:
    """The structure at an instant, on its free coordinates (n,).

    x (nodes, 3) m. M, C, K sparse (n, n), of which B (n, n) is what membranes, solids and beams resist with; G sparse (rows,
    n); f (rows,) m/N; load (n,) N, f_nodes - M a; N (rows,) N, the row forces of the rigid structure.
    """

    balance: Balance
    x: NDArray[np.float64]
    M: Any
    C: Any
    K: Any
    B: Any
    G: Any
    f: NDArray[np.float64]
    load: NDArray[np.float64]
    N: NDArray[np.float64]


def instants_of(model: Model, forces: Forces, softness: Softness) -> Iterator[Instant]:
    """The structure at every sample of forces along a motion, or of poses.

    Raises
    ------
    InputError : forces of another model; nothing that is elastic; unknown members.
    """
    system = compile(model)
    if not isinstance(forces, Forces) or list(forces.arrays["member"].values) != list(system.members):
        raise InputError("The forces belong to a model with other members. Compute them for this model, by dynamics.inverse.")
    check_motion(system, forces.motion)
    x, v, a = (flat_positions(system, forces.motion.arrays[name].values) for name in ("position", "velocity", "acceleration"))
    load = nodal_forces(system, forces, x)
    shape, free = (len(x), -1, 3), system.free
    still = bool(forces.whole.attrs.get("at_rest", 0))
    soft = softness.flexibility(system, system.x0)
    if not (np.any(soft) or np.any(system.spring > 0) or has_elements(system)):
        raise InputError("No member is elastic. Give sections and materials, a stiffness for members, or springs.")
    case = forces.load_case if forces.load_case in system.model.cases else None
    gravity = loads_of(system, forces).gravity
    times = forces.arrays["time"].values
    if "load_time" in forces.whole.attrs:
        times = np.full(len(x), float(forces.whole.attrs["load_time"]))
    for i, (here, rate, second) in enumerate(zip(x.reshape(shape), v.reshape(shape), a.reshape(shape), strict=True)):
        balance = replace(balance_of(system, case, None, float(times[i])), gravity=gravity)
        stiff, push = _of_shapes(system, forces, i, here)
        N = balanced_rows(balance, here, load[i] + push)
        moving = None if still or not (np.any(rate) or np.any(second)) else (rate, second)
        found = structure_at(balance, softness, here, N, load[i], moving)
        yield replace(found, K=found.K + stiff[free][:, free])


def structure_at(
    balance: Balance,
    softness: Softness,
    x: NDArray[np.float64],
    N: NDArray[np.float64],
    load: NDArray[np.float64],
    moving: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None,
) -> Instant:
    """The structure at positions x (n, 3) with row forces N (rows,) and forces (3 n,); moving : velocities, accelerations."""
    system = balance.system
    free, (_, L, u) = system.free, ends_of(system, x)
    Ld = np.zeros_like(L) if moving is None else np.einsum("mc,mc->m", u, moving[0][system.q] - moving[0][system.p])
    K, C = balance.tangents(x, N, bar_laws(system, L, Ld).tension - balance.push, *(moving or ()))
    return Instant(
        balance=balance,
        x=x,
        M=mass_matrix(system, x)[free][:, free],
        C=C[free][:, free],
        K=K[free][:, free],
        B=material_stiffness(system, x)[free][:, free],
        G=constraint_jacobian(system, x)[:, free],
        f=softness.flexibility(system, x),
        load=load[free],
        N=N,
    )


def _of_shapes(system: System, forces: Forces, i: int, x: NDArray[np.float64]) -> tuple[Any, NDArray[np.float64]]:
    """Geometric stiffness (3 n, 3 n), N/m, and forces (3 n,), N, of beams that keep their shape in sample i at x (n, 3)."""
    if "mode_force" not in forces.arrays:
        return csr_array((x.size, x.size)), np.zeros(x.size)
    found: Any = system.continua
    own, push = np.nan_to_num(forces.arrays["mode_force"].values[i]), np.zeros_like(x)
    np.subtract.at(push, found.beams.nodes, mode_forces(found.beams, x[None], own[None])[0])
    return mode_stiffness(found.beams, x, own), push.reshape(-1)


def refuse_unloaded_beams(model: Model, forces: Forces) -> None:
    """Refuse forces of positions in which elastic beams do not carry their loads: their stiffening would be missing.

    Raises
    ------
    InputError : such forces.
    """
    unknown = forces.attrs.get("not_balanced", 0) or forces.attrs.get("undecided", ())
    if unknown and any(beam.kind == "elastic" for beam in model.whole.beams.values()):
        raise InputError(
            "In these positions beams are not deformed by their loads, and balance alone does not decide the forces that "
            "stiffen them. Give the equilibrium: statics.at_poses(model, statics.equilibrium(model).position.values[None])."
        )


def elastic_stiffness(here: Instant) -> NDArray[np.float64]:
    """G^T f^-1 G of the rows that are elastic, dense (n, n), N/m."""
    soft = np.flatnonzero(here.f > 0)
    G = here.G[soft]
    return np.asarray((G.T @ diags_array(1.0 / here.f[soft]) @ G).toarray())


def modes_of(
    here: Instant, count: int
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Lowest undamped modes: squares of angular frequencies (k,), shapes (n, k) of unit modal mass, M and K dense (n, n).

    Nodes without mass follow without inertia: M v = mu K v with mu = 1/w^2.

    Raises
    ------
    InputError : a structure that is not stiff: a mechanism, or buckled.
    """
    from scipy.linalg import LinAlgError, eigh

    hard = here.f == 0
    K, M = elastic_stiffness(here) + here.K.toarray(), here.M.toarray()
    K = 0.5 * (K + K.T)
    Z = null_basis(here.G[np.flatnonzero(hard)]) if np.any(hard) else None
    n = len(K) if Z is None else Z.shape[1]
    if not n:
        raise InputError("Nothing can move: every member is inextensible. Give members a section and a material.")
    count = min(count, n)
    Kz, Mz = (K, M) if Z is None else (Z.T @ K @ Z, Z.T @ M @ Z)
    try:
        mu, shapes = eigh(Mz, Kz, subset_by_index=[n - count, n - 1])
    except LinAlgError:
        raise InputError(
            "The elastic structure is not stiff in this position: it has a mechanism, or its members' forces make it unstable. "
            "statics.buckling and kinematics.mobility say where."
        ) from None
    mu, shapes = mu[::-1], shapes[:, ::-1]
    kept = mu > mu[0] * 1e-14
    found = shapes[:, kept] / np.sqrt(mu[kept])
    return 1.0 / mu[kept], found if Z is None else Z @ found, M, K
