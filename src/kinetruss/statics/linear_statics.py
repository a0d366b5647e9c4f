"""The stiffness method for a model: its record, its load cases, its messages."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr

from kinetruss.dynamics.actions import CarriedBy
from kinetruss.dynamics.bar_actions import mean_tension_at_rest
from kinetruss.errors import AnalysisError, InputError, few
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics import System, compile, constraint_jacobian, ends_of
from kinetruss.mechanics.accuracy import NOTHING, SILENT, accuracy_note
from kinetruss.mechanics.arguments import number_of, positions_of
from kinetruss.mechanics.balance import measure_forces
from kinetruss.mechanics.elements import element_forces, named_laws, named_motions, strained_forces
from kinetruss.mechanics.loads import Loads
from kinetruss.mechanics.matrices import bar_laws, body_and_continua_mass
from kinetruss.mechanics.rotations import rotation_axes, small_rotations
from kinetruss.model import Model, nearest
from kinetruss.model.beam_checks import spin_note
from kinetruss.results import Result, Status, provenance, variable
from kinetruss.results.user_parts import lifted_note, part_axes, reactions, rotation_columns, support_axes
from kinetruss.results.wide_tables import coordinate_axes, displaced_columns, element_columns, force_units
from kinetruss.statics.active_set import OneSided, kinks_of, solve_one_sided
from kinetruss.statics.small_displacements import (
    Weight,
    element_rows,
    end_weights,
    flexibility,
    loads_at,
    solve,
    stiff_rows,
    weight_word,
)
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


# Small displacements of an elastic truss by the stiffness method.


class Known(NamedTuple):
    """Given forces, N: `ends` (members, 2, 3) weight of members at their ends; `load` (3 n,) all nodal forces; `tension`
    (rows,) of bars and springs, `continua_force` (3 n,) of membranes and solids in the configuration itself; `loads` by name.
    """

    ends: NDArray[np.float64]
    load: NDArray[np.float64]
    tension: NDArray[np.float64]
    continua_force: NDArray[np.float64]
    loads: Loads


class Linear(Result):
    """Displacements, forces and reactions of an elastic truss under small displacements."""


@one_thread
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

    An independent check of `dynamics.inverse` at rest, and the forces of redundant trusses by their stiffness, in 2-D and 3-D.

    Parameters
    ----------
    position : (n_nodes, dim), m, the configuration; by default the model's own. Bars have no force there, except bars of kind
        ``elastic`` or ``cable`` with another natural length. Cables pull or are slack, as the load wants: the message names
        the slack ones. So do springs with play and stops, also those of supports with a gap; couplings whose value the
        configuration does not have, as settlements of supports, displace it.
    load_case : name; None takes all loads of the model with factor 1. Loads in time are taken at `time`, s.
    weight : True: members and lumped masses weigh; ``"lumped"``: massless members; False: nothing weighs.
    rigid : names of members kept inextensible although they have E and A.

    Returns
    -------
    Linear. ``displacement`` (node, axis) m; ``member_force`` (member) N, mean over the length, tension positive;
    ``end_force`` (member, end): axial tension at A and B; ``joint_force`` (member, end, axis): force on the member from its
    joint; ``reaction`` (support, axis): force on the structure; ``node_rotation`` (frame, about) rad of the nodes of beams;
    ``elongation`` (member) m and ``strain`` (member), of the load alone; ``strain_energy`` (member) J; ``energy`` J, their
    sum; ``work`` J, half the loads times their displacements, equal to it without prestress (Clapeyron).
    attrs ``force_error``, ``displacement_error``: bounds on the errors by round-off, relative to the largest force and
    displacement (under the loads alone, where this is larger). Members without E and A are kept inextensible; the message
    names them. If fewer than seven digits are accurate, it also says how many are, and which mechanism is near.

    Raises
    ------
    InputError : a mechanism, named; an unknown load case or member; inextensible bars whose forces are not unique.
    AnalysisError : a structure so near to a mechanism that no digit is accurate; ``error.result`` has the numbers.

    Notes
    -----
    N l/(E A) = g . u and the equilibrium of all nodes, sum of N g = F, g = (-u, u) (Timoshenko & Young, Theory of Structures,
    1965, chapter 7), solved together: sparse LU, refined with residuals in doubled precision, so that the forces of a
    determinate truss are those of equilibrium to round-off; l/(E A) = 0 of inextensible bars.
    Rigid and driven bars alike are elastic, with the E and A
    of their section and material; an active member with those of the weaker of its two parts, over the whole length. Weight
    acts as equivalent forces at the ends: half and half for bars, by the lever for base and tube. Geometric stiffness is
    neglected: displacements must be small.

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
    ...                material=kt.Material(E=70e9, density=0), loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> round(kt.statics.linear(rod).displacement.sel(node="B", axis="x").item(), 12)
    0.002
    """
    system = compile(model)
    x, load_time = positions_of(system, position), number_of(time, "time", "s")
    word = weight_word(weight)
    loads = loads_at(system, np.array([load_time]), load_case, word).at(x[None])
    held = stiff_rows(system)
    flexible = flexibility(held, x)
    flexible[rigid_rows(held, rigid)] = 0.0
    known = known_forces(system, held, x, loads)
    G = constraint_jacobian(held, x)
    found = solve_one_sided(held, x, flexible, known.tension, known.load + known.continua_force)
    flexible = found.flexible
    columns, coords = variables(system, held, x, found, known, G)
    data = xr.Dataset(columns, coords=coords)
    force, displacement = found.solved.errors
    stressed = known.tension.any() or found.tension.any() or known.continua_force.any()
    if stressed and displacement > SILENT:  # beside a state in balance what is left is round-off of what the loads alone do
        most, alone = found.solved.displacement, solve(held, x, flexible, known.load).displacement
        displacement *= float(np.abs(most).max() / max(np.abs(most).max(), np.abs(alone).max()))
    data.attrs |= {
        "kind": "linear",
        "load_case": loads.name,
        "weight": word,
        "load_time": load_time,
        "at_model": int(np.array_equal(x, system.x0)),
        "force_error": force,
        "displacement_error": displacement,
    }
    if not stressed:  # Clapeyron: shows an error that the bounds do not cover
        displacement = max(displacement, _unbalanced(data))
    unsure = accuracy_note(held.with_rows(np.isfinite(flexible)), x, force, displacement)
    lost = not max(force, displacement) < NOTHING
    said = (
        _message(held, flexible, rigid),
        _slack(found.slack),
        lifted_note(system, _on_elements(held, found)),
        _curved(kinks_of(held, x, flexible).curved),
        spin_note(model.whole),
    )
    result = Linear(
        data=data,
        status=Status.UNSURE if lost else Status.COMPLETED,
        message=" ".join(text for text in (unsure, *said) if text),
        provenance=provenance(model, load_case=loads.name, weight=word),
    )
    if lost:
        raise AnalysisError(f"{result.status.value} {unsure}", result)
    return result


def _unbalanced(data: xr.Dataset) -> float:
    """Difference of energy and work as a fraction of the larger."""
    energy, work = data["energy"].item(), data["work"].item()
    return float(abs(energy - work) / (max(abs(energy), abs(work)) or 1.0))


def rigid_rows(held: System, names: Collection[str]) -> NDArray[np.int64]:
    """The rows of members that are kept inextensible."""
    given = [names] if isinstance(names, str) else list(names)
    if unknown := [name for name in given if name not in held.members]:
        raise InputError(f"No member called {unknown[0]!r} to keep rigid. {nearest(unknown[0], held.members)}")
    chosen = [held.members.index(name) for name in given]
    return np.flatnonzero(np.isin(held.row_member, chosen) & (held.row_kind == LENGTH))


def known_forces(system: System, held: System, x: NDArray[np.float64], loads: Loads) -> Known:
    """The given forces at positions x (n, 3)."""
    ends = end_weights(system, x, loads.gravity)
    pushed = strained_forces(system, x) + element_forces(system, x, rows=False)
    return Known(ends, _nodal(system, loads, ends), _prestress(held, x), pushed, loads)


def _prestress(held: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Force (rows,) that elastic bars, cables and springs have in the configuration, N."""
    i = held.row_member
    found = np.where(held.row_kind == LENGTH, bar_laws(held, ends_of(held, x, i)[1], member=i).tension, 0.0)
    found[element_rows(held)] = named_laws(held, x)[:, 0] / held.measure_scale[held.force_element_measure]
    return found


def _nodal(system: System, loads: Loads, ends: NDArray[np.float64]) -> NDArray[np.float64]:
    """Nodal forces (3 n,), N: loads, lumped masses, weight of members, bodies, membranes and solids."""
    load = system.lump[:, None] * loads.lump_gravity
    np.add.at(load, loads.node, loads.force[0])
    np.add.at(load, system.p, ends[:, 0])
    np.add.at(load, system.q, ends[:, 1])
    return np.asarray(load.reshape(-1) + body_and_continua_mass(system) @ np.tile(loads.gravity, len(load)))


def variables(
    system: System, held: System, x: NDArray[np.float64], found: OneSided, known: Known, G: Any
) -> tuple[dict[str, Any], dict[str, Any]]:
    """The variables of the result and the names along their axes, G the gradients of the rows (rows, 3 n)."""
    solved, (ends, load, _, continua_force, loads) = found.solved, known
    dim, members = system.dim, len(system.members)
    bars = held.row_kind == 0
    force, elongation, energy = (np.zeros(members) for _ in range(3))
    total = solved.force + found.tension
    force[held.row_member[bars]] = total[bars]
    on_coordinates = _on_elements(held, found)
    length = ends_of(system, x)[1]
    elongation[held.row_member[bars]] = solved.elongation[bars]
    energy[held.row_member[bars]] = found.stored[bars]
    held_now = system.prescribed.copy()
    held_now[system.coordinate_drive[:, 0]] = False
    reaction = np.where(held_now, G.T @ total + solved.inner - continua_force - load, 0.0).reshape(-1, 3)
    if len(system.measures) or system.model.hubs:
        drive, coupling = _on_measures(held, total)
        acting = CarriedBy(force[None], reaction[None], np.zeros((1, 0, 3)))
        force = force + mean_tension_at_rest(system, loads, x, drive, coupling, acting, on_coordinates)
    work = 0.5 * (load @ solved.displacement - solved.force @ found.given)
    stored = found.stored.sum() + (0.5 * solved.inner - continua_force) @ solved.displacement
    u = (x[system.q] - x[system.p]) / length[:, None]
    carried = np.stack([np.einsum("mc,mc->m", ends[:, 0], u), -np.einsum("mc,mc->m", ends[:, 1], u)], axis=1)
    tensions = force[:, None] * u
    joint = np.stack([-tensions, tensions], axis=1) - ends
    supports = [system.node_index(name) for name in system.supports]
    data = {
        "displacement": variable(("node", "axis"), solved.displacement.reshape(-1, 3)[:, :dim], "m", "node displacement"),
        "member_force": variable(("member",), force, "N", "mean axial force, tension positive"),
        "end_force": variable(("member", "end"), force[:, None] + carried, "N", "axial tension at end A (first node), end B"),
        "joint_force": variable(("member", "end", "axis"), joint[..., :dim], "N", "force on the member from its joint"),
        **reactions(system, (), x, reaction[supports], _on_measures(held, total)[1], on_coordinates),
        "elongation": variable(("member",), elongation, "m", "elongation by the load"),
        "strain": variable(("member",), elongation / length, "", "axial strain by the load"),
        "strain_energy": variable(("member",), energy, "J", "strain energy that the load adds"),
        "energy": variable((), np.asarray(stored), "J", "strain energy that the load adds: members, springs, elements"),
        "work": variable((), np.asarray(work), "J", "half the loads times their displacements, and of settlements"),
    }
    coords: dict[str, Any] = {
        **part_axes(system),
        **support_axes(system),
        "end": ["A", "B"],
    }
    axes = coordinate_axes(system)
    if system.model.couplings:
        axes = axes | {"coupling": list(system.model.couplings)}
        units, words = force_units(system)[0]["coupling"], "force or torque on the coupled coordinate"
        data["coupling_force"] = variable(("coupling",), _on_measures(held, total)[1], units, words)
    coords |= axes | (force_units(system, *axes)[1] if axes else {})
    if system.force_elements:
        stretched = solved.elongation[element_rows(held)] / system.measure_scale[system.force_element_measure]
        data |= element_columns(system, (), on_coordinates, named_motions(system, x[None]).value[0] + stretched)
    data |= rotation_columns(system, (), lambda: small_rotations(system, x, solved.displacement.reshape(-1, 3)))
    coords |= rotation_axes(system)
    displaced, axes = displaced_columns(system, x, solved.displacement.reshape(-1, 3))
    data, coords = data | displaced, coords | axes
    return data, coords


def _on_measures(held: System, total: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Forces of drives (drives,) and couplings (couplings,) on measures, N or N m, from row forces (rows,)."""
    on = measure_forces(held, total)
    last = len(held.measures) - len(held.force_elements)
    drive, measured = np.zeros(len(held.drives)), held.drive_measure >= 0
    drive[measured] = -on[held.drive_measure[measured]]
    return drive, -on[last - len(held.model.couplings) : last]


def _on_elements(held: System, found: OneSided) -> NDArray[np.float64]:
    """Forces on the coordinates of elements (force_elements,), N or N m."""
    total = found.solved.force + found.tension
    return np.asarray(-total[element_rows(held)] * held.measure_scale[held.force_element_measure])


def _curved(names: tuple[str, ...]) -> str:
    """The sentence on elements whose law is not a straight line."""
    return f"Taken with their slope in the configuration, although their law is curved: {few(names, 8)}." if names else ""


def _slack(names: tuple[str, ...]) -> str:
    """The sentence on cables, struts and stops that carry nothing."""
    return f"Slack, so that {'it carries' if len(names) == 1 else 'they carry'} nothing: {few(names, 8)}." if names else ""


def _message(held: System, flexible: NDArray[np.float64], rigid: Collection[str]) -> str:
    """Message with the names of members that are kept inextensible because they have no E or A."""
    lacking = [
        held.members[i] for i, f, kind in zip(held.row_member, flexible, held.row_kind, strict=True) if not f and not kind
    ]
    # bars that hold bodies and frames of beams together are rigid by their purpose
    lacking = [name for name in lacking if name not in rigid and name not in held.inner.bars]
    if not lacking:
        return ""
    return f"Kept inextensible, since they have no section or no material: {few(lacking, 8)}."
