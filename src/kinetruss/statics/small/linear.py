"""Small displacements of an elastic truss by the stiffness method."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr
from scipy.sparse import csr_array

from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.structure.plan import LENGTH
from kinetruss.mechanics import System, compile, constraint_jacobian, ends_of
from kinetruss.mechanics.assembly import Loads, bar_laws, carried_mass, continua_stiffness, resting_forces
from kinetruss.mechanics.configuration import positions_of
from kinetruss.model import Model, nearest
from kinetruss.results import Result, Status, provenance, variable
from kinetruss.statics.small.stiffness import Solved, flexibility, solve, stiff_rows
from kinetruss.statics.small.sure import NOTHING, doubt
from kinetruss.statics.small.weights import Weight, end_weights, loads_at, weight_word

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Linear", "linear"]


class _Known(NamedTuple):
    """Forces known beforehand, N: `ends` (members, 2, 3) weight of members at their ends; `load` (3 n,) all that acts on nodes;
    `pull` (rows,) of bars and `pushed` (3 n,) of membranes and solids in the configuration itself.
    """

    ends: NDArray[np.float64]
    load: NDArray[np.float64]
    pull: NDArray[np.float64]
    pushed: NDArray[np.float64]


class Linear(Result):
    """Displacements, forces and reactions of an elastic truss under small displacements."""


def linear(
    model: Model,
    position: ArrayLike | None = None,
    load_case: str | None = None,
    *,
    weight: Weight = True,
    rigid: Collection[str] = (),
    time: float = 0.0,
) -> Linear:
    """Displacements, member forces and reactions of a truss whose bars are elastic and whose drives are locked.

    An independent check of `dynamics.inverse` at rest, and the answer for redundant trusses, 2-D and 3-D.

    Parameters
    ----------
    position : (n_nodes, dim), m, the configuration; by default the model's own. Bars are free of force there, but for bars of
        kind ``elastic`` or ``cable`` with another natural length. A cable that is slack there carries nothing.
    load_case : name; None takes all loads of the model with factor 1. Loads in time are taken at `time`, s.
    weight : True: members and lumped masses weigh; ``"lumped"``: massless members; False: nothing weighs.
    rigid : names of members kept inextensible although they have E and A.

    Returns
    -------
    Linear. ``displacement`` (node, axis) m; ``member_force`` (member) N, mean over the length, tension positive;
    ``end_force`` (member, end): axial tension at A and B; ``reaction`` (support, axis): force on the structure;
    ``elongation`` (member) m and ``strain`` (member), of the load alone; ``strain_energy`` (member) J; ``energy`` J, their
    sum; ``work`` J, half the loads times their displacements, equal to it where nothing is prestressed (Clapeyron).
    attrs ``force_error``, ``displacement_error``: bounds on the errors by rounding, of the largest force and displacement.
    Members without E and A are kept inextensible; the message names them. It says too where less than seven digits are sure,
    how many are, and what nearly moves.

    Raises
    ------
    InputError : a mechanism, named; an unknown load case or member; inextensible bars whose forces are not unique.
    AnalysisError : a structure so near to a mechanism that no digit is sure; ``error.result`` has the numbers.

    Notes
    -----
    N l/(E A) = g . u and the balance of all nodes, sum of N g = F, g = (-u, u) (Timoshenko & Young, Theory of Structures,
    1965, chapter 7), solved together: sparse LU, refined with residuals in doubled precision, so that the forces of a
    determinate truss are those of equilibrium to round-off; l/(E A) = 0 of inextensible bars.
    Rigid and driven bars alike are elastic, with the E and A
    of their section and material; an active member with those of the weaker of its two parts, over the whole length. Weight
    acts as equivalent forces at the ends: half and half for bars, by the lever for base and tube. Geometric stiffness is not
    counted: displacements must be small.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
    ...                material=kt.Material(E=70e9, density=0), loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> round(kt.statics.linear(rod).displacement.sel(node="B", axis="x").item(), 12)
    0.002
    """
    system = compile(model)
    x = positions_of(system, position)
    word = weight_word(weight)
    loads = loads_at(system, np.array([float(time)]), load_case, word).at(x[None])
    held = stiff_rows(system)
    flexible = flexibility(held, x)
    flexible[_rigid_rows(held, rigid)] = 0.0
    known = _known(system, held, x, loads)
    G = constraint_jacobian(held, x)
    solved = solve(held, x, flexible, known.load - G.T @ known.pull + known.pushed)
    data = _dataset(system, held, x, solved, known, G)
    force, displacement = solved.errors
    data.attrs |= {
        "kind": "linear",
        "load_case": loads.name,
        "weight": word,
        "load_time": float(time),
        "force_error": force,
        "displacement_error": displacement,
    }
    if not (known.pull.any() or known.pushed.any()):  # Clapeyron: an error that the bounds know nothing of shows here
        displacement = max(displacement, _unbalanced(data))
    unsure = doubt(held.with_rows(np.isfinite(flexible)), x, force, displacement)
    lost = not max(force, displacement) < NOTHING
    found = Linear(
        data=data,
        status=Status.UNSURE if lost else Status.COMPLETED,
        message=" ".join(text for text in (unsure, _message(held, flexible, rigid)) if text),
        provenance=provenance(model, load_case=loads.name, weight=word),
    )
    if lost:
        raise AnalysisError(f"{found.status.value} {unsure}", found)
    return found


def _unbalanced(data: xr.Dataset) -> float:
    """Difference of energy and work, of the larger of them."""
    energy, work = data["energy"].item(), data["work"].item()
    return float(abs(energy - work) / (max(abs(energy), abs(work)) or 1.0))


def _rigid_rows(held: System, names: Collection[str]) -> NDArray[np.int64]:
    given = [names] if isinstance(names, str) else list(names)
    if unknown := [name for name in given if name not in held.members]:
        raise InputError(f"No member called {unknown[0]!r} to keep rigid. {nearest(unknown[0], held.members)}")
    chosen = [held.members.index(name) for name in given]
    return np.flatnonzero(np.isin(held.row_member, chosen) & (held.row_kind == LENGTH))


def _known(system: System, held: System, x: NDArray[np.float64], loads: Loads) -> _Known:
    ends = end_weights(system, x, loads.gravity)
    pushed = np.zeros(x.size) if system.continua is None else resting_forces(system.continua, x).reshape(-1)
    return _Known(ends, _nodal(system, loads, ends), _prestress(held, x), pushed)


def _prestress(held: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Force (rows,) that elastic bars and cables have in the configuration, N."""
    i = held.row_member
    return np.where(held.row_kind == LENGTH, bar_laws(held, ends_of(held, x, i)[1], member=i).tension, 0.0)


def _nodal(system: System, loads: Loads, ends: NDArray[np.float64]) -> NDArray[np.float64]:
    """Nodal forces (3 n,), N: loads, lumped masses, weight of members, bodies, membranes and solids."""
    load = system.lump[:, None] * loads.lump_gravity
    np.add.at(load, loads.node, loads.force[0])
    np.add.at(load, system.p, ends[:, 0])
    np.add.at(load, system.q, ends[:, 1])
    return np.asarray(load.reshape(-1) + carried_mass(system) @ np.tile(loads.gravity, len(load)))


def _dataset(system: System, held: System, x: NDArray[np.float64], solved: Solved, known: _Known, G: Any) -> xr.Dataset:
    ends, load, pull, pushed = known
    dim, members = system.dim, len(system.members)
    bars = held.row_kind == 0
    force, elongation, energy = (np.zeros(members) for _ in range(3))
    total = solved.force + pull
    force[held.row_member[bars]] = total[bars]
    length = ends_of(system, x)[1]
    elongation[held.row_member[bars]] = solved.elongation[bars]
    # what the load adds to the energy of a prestressed bar: (N + N0) e/2 + N0 e/2
    energy[held.row_member[bars]] = ((0.5 * solved.force + pull) * solved.elongation)[bars]
    held_now = system.prescribed.copy()
    held_now[system.coordinate_drive[:, 0]] = False
    more = _continuum(system, x) @ solved.displacement  # what membranes and solids resist with
    reaction = np.where(held_now, G.T @ total + more - pushed - load, 0.0).reshape(-1, 3)
    stored = energy.sum() + (0.5 * more - pushed) @ solved.displacement
    u = (x[system.q] - x[system.p]) / length[:, None]
    carried = np.stack([np.einsum("mc,mc->m", ends[:, 0], u), -np.einsum("mc,mc->m", ends[:, 1], u)], axis=1)
    supports = [system.node_index(name) for name in system.supports]
    data = {
        "displacement": variable(("node", "axis"), solved.displacement.reshape(-1, 3)[:, :dim], "m", "node displacement"),
        "member_force": variable(("member",), force, "N", "mean axial force, tension positive"),
        "end_force": variable(("member", "end"), force[:, None] + carried, "N", "axial tension at the ends"),
        "reaction": variable(("support", "axis"), reaction[supports, :dim], "N", "support force on the structure"),
        "elongation": variable(("member",), elongation, "m", "elongation by the load"),
        "strain": variable(("member",), elongation / length, "", "axial strain by the load"),
        "strain_energy": variable(("member",), energy, "J", "strain energy that the load adds"),
        "energy": variable((), np.asarray(stored), "J", "strain energy that the load adds, all members and elements"),
        "work": variable((), np.asarray(0.5 * load @ solved.displacement), "J", "half the loads times their displacements"),
    }
    coords = {
        "node": list(system.nodes),
        "axis": ["x", "y", "z"][:dim],
        "member": list(system.members),
        "end": ["A", "B"],
        "support": list(system.supports),
    }
    return xr.Dataset(data, coords=coords)


def _continuum(system: System, x: NDArray[np.float64]) -> Any:
    """Stiffness of membranes and solids (3 n, 3 n), N/m, without that of what they carry at x already."""
    if system.continua is None:
        return csr_array((x.size, x.size))
    return continua_stiffness(system.continua, x, np.zeros(len(system.continua.p)))


def _message(held: System, flexible: NDArray[np.float64], rigid: Collection[str]) -> str:
    """Names of members that were kept inextensible for want of E and A."""
    lacking = [
        held.members[i] for i, f, kind in zip(held.row_member, flexible, held.row_kind, strict=True) if not f and not kind
    ]
    lacking = [name for name in lacking if name not in rigid]
    if not lacking:
        return ""
    shown = ", ".join(lacking[:8]) + (f" and {len(lacking) - 8} more" if len(lacking) > 8 else "")
    return f"Kept inextensible, since they have no section or no material: {shown}."
