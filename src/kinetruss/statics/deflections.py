"""Elastic deflection along a motion, and the stiffness of a platform by its drives."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.dynamics.least_norm import apply_loads
from kinetruss.errors import InputError, few
from kinetruss.kernels.structure.structure import LENGTH, EndForces, States
from kinetruss.kinematics import platform_jacobian
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import System, arrange, compile
from kinetruss.mechanics.accuracy import SILENT, accuracy_note
from kinetruss.mechanics.elements import has_elements
from kinetruss.mechanics.loads import ROTATES, Loads
from kinetruss.mechanics.rotating_base import ROTATION
from kinetruss.mechanics.transfer import displacements, flat_positions
from kinetruss.model import Model, nearest
from kinetruss.model.data import ELEMENT_FIELDS
from kinetruss.results import Forces, Motion, Result, provenance, variable
from kinetruss.statics.active_set import changed
from kinetruss.statics.small_displacements import flexibility, loads_at, solve, stiff_rows
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class Deflection(Result):
    """Displacements and strain energy of elastic members along a motion."""


@one_thread
def deflection(model: Model, forces: Forces) -> Deflection:
    """Displacements of all nodes, elongations and strain energy that the forces of a motion cause in elastic members.

    Parameters
    ----------
    forces : from `dynamics.inverse` or `at_poses` of the same model. ``forces.static`` gives the deflection of the poses at
        rest, the difference is the effect of the motion alone.

    Returns
    -------
    Deflection, over the time axis of the forces. ``displacement`` (time, node, axis) m: from the position in the rigid motion;
    ``size`` (time, node) m; ``elongation`` (time, member) m; ``strain`` (time, member); ``strain_energy`` (time, member) J;
    ``energy`` (time) J; ``work`` (time) J: half the applied and inertia forces times the displacements; ``work_balance``
    (time) J: work minus energy, zero but for round-off. Members without E and A are kept inextensible.

    Raises
    ------
    InputError : forces of another model; freedoms that no drive holds; redundant inextensible bars; cables, stops or supports
        that the deflection tightens or slackens.

    Notes
    -----
    A member with mean tension N elongates by e = N l/(E A), and the nodes follow by J u = e: one forward sweep over the blocks
    of the kinematics a sample. Redundant structures and such with elastic bars are solved by the stiffness method under the
    same nodal forces f - M a instead. The work of those forces, found without N, closes the check (principle of virtual
    work). First order: the deflection changes neither the geometry nor, by its own inertia, the forces; it is valid if the
    first natural frequency is well above the frequencies of the motion. An active member counts with its
    `Compliance`, else with the E and A of the weaker of its two parts, over its whole length.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.statics.deflection(model, forces)
    >>> found.elongation.sel(member="strut").values[0].round(9).item()  # m: N l/(E A) = -1000/(210e9 * 314.16e-6)
    -1.5158e-05
    """
    system = compile(model)
    if list(forces.arrays["member"].values) != list(system.members):
        raise InputError("The forces belong to a model with other members. Compute them for this model.")
    check_motion(system, forces.motion)
    x = flat_positions(system, forces.motion.arrays["position"].values)
    load = nodal_forces(system, forces, x)
    held = stiff_rows(system)
    flexible = np.array([flexibility(held, one) for one in x.reshape(len(x), -1, 3)]).reshape(len(x), -1)
    if len(arrange(system).redundant) or np.any(system.spring > 0) or has_elements(system):
        u, e, bent, said = _stiffly(held, x, flexible, load)
    else:
        u, e = _swept(system, held, x, flexible, forces.arrays["member_force"].values)
        bent, said = np.zeros(len(x)), ""
    length = np.linalg.norm(_apart(system, x), axis=2)
    energy = np.zeros((len(x), len(system.members)))
    elongation = np.zeros_like(energy)
    bars = held.row_kind == LENGTH
    stiffness = np.divide(1.0, flexible, out=np.zeros_like(flexible), where=flexible > 0)
    elongation[:, held.row_member[bars]] = e[:, bars]
    stored = 0.5 * stiffness * e**2
    energy[:, held.row_member[bars]] = stored[:, bars]
    whole = stored.sum(axis=1) + bent
    work = 0.5 * np.einsum("tc,tc->t", load[:, system.free], u[:, system.free])
    return _record(system, forces, u, elongation, length, (energy, whole, work), said)


def nodal_forces(system: System, forces: Forces, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Nodal forces f - M a (times, 3 n), N, from loads, weight and inertia alone."""
    loads = loads_of(system, forces).at(x)
    if forces.whole.attrs.get("at_rest", 0):
        v = a = np.zeros((1, x.shape[1]))
    else:
        v, a = (flat_positions(system, forces.motion.whole[name].values) for name in ("velocity", "acceleration"))
    joint, rest = np.empty((len(x), len(system.members), 2, 3)), np.empty_like(x)
    apply_loads(system, loads, States(x, v, a), EndForces(joint, rest))
    return rest


def loads_of(system: System, forces: Forces) -> Loads:
    """The loads of the forces.

    Raises
    ------
    InputError : forces in a base that rotates.
    """
    if ROTATION in forces.attrs:
        raise InputError(ROTATES)
    t = forces.arrays["time"].values
    if "load_time" in forces.whole.attrs:
        t = np.full(len(t), float(forces.whole.attrs["load_time"]))
    case = forces.load_case if forces.load_case in system.model.cases else None
    return loads_at(system, t, case, str(forces.whole.attrs.get("weight", "all")))


def _apart(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    nodes = x.reshape(len(x), -1, 3)
    return nodes[:, system.q] - nodes[:, system.p]


def _swept(
    system: System, held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], force: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Displacements and elongations of a determinate structure from its member forces."""
    e = np.where(held.row_kind == LENGTH, flexible * force[:, held.row_member], 0.0)
    # the rows of the system are the same members in the same order, but without free bars
    place = {key: r for r, key in enumerate(_keys(held))}
    chosen = [place[key] for key in _keys(system)]
    return displacements(system, x, e[:, chosen]), e


def _stiffly(
    held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], load: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], str]:
    """The same for redundant structures, by the stiffness method; then the strain energy (times,) of elements, J,
    and the message on the least accurate sample.
    """
    u, e, bent = np.empty_like(x), np.empty_like(flexible), np.zeros(len(x))
    worst, at = (0.0, 0.0), 0
    for i in range(len(x)):
        solved = solve(held, x[i].reshape(-1, 3), flexible[i], load[i])
        u[i], e[i], bent[i] = solved.displacement, solved.elongation, 0.5 * solved.displacement @ solved.inner
        if names := changed(held, x[i].reshape(-1, 3), flexible[i], e[i]):
            raise InputError(
                f"At sample {i} the deflection tightens or slackens {few(names, 6)}, while a deflection takes what pulls or "
                "presses as it is in the rigid motion. Take statics.linear, statics.equilibrium or flexible.simulate for it."
            )
        if max(solved.errors) > max(worst):
            worst, at = solved.errors, i
    said = accuracy_note(held.with_rows(np.isfinite(flexible[at])), x[at].reshape(-1, 3), *worst) if len(x) else ""
    return u, e, bent, said


def _record(
    system: System,
    forces: Forces,
    u: NDArray[np.float64],
    elongation: NDArray[np.float64],
    length: NDArray[np.float64],
    energies: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
    said: str,
) -> Deflection:
    energy, stored, work = energies
    nodes = u.reshape(len(u), -1, 3)[:, :, : system.dim]
    per, time = ("time", "member"), ("time",)
    data = {
        "displacement": variable(("time", "node", "axis"), nodes, "m", "displacement from the rigid motion"),
        "size": variable(("time", "node"), np.linalg.norm(nodes, axis=2), "m", "size of the displacement"),
        "elongation": variable(per, elongation, "m", "elastic elongation"),
        "strain": variable(per, elongation / length, "", "axial strain"),
        "strain_energy": variable(per, energy, "J", "strain energy"),
        "energy": variable(time, stored, "J", "strain energy of all members and springs"),
        "work": variable(time, work, "J", "half the nodal forces times their displacements"),
        "work_balance": variable(time, work - stored, "J", "work minus strain energy"),
    }
    kept = ("time", "pose", "node", "axis", "member")
    coords = forces.whole.coords
    frame = xr.Dataset(data, attrs={"kind": "deflection", "load_case": forces.load_case})
    frame = frame.assign_coords({name: coords[name] for name in kept if name in coords})
    if "pose" in coords:
        frame = frame.set_xindex("pose")
    message = " ".join(text for text in (forces.message, said, _unbalanced(stored, work)) if text)
    return Deflection(
        data=frame, status=forces.status, message=message, provenance=provenance(system.given, load_case=forces.load_case)
    )


def _unbalanced(stored: NDArray[np.float64], work: NDArray[np.float64]) -> str:
    """The message if the work of the nodal forces differs from the strain energy: the forces are then not in equilibrium."""
    off = np.abs(work - stored) / (max(float(np.abs(stored).max(initial=0.0)), float(np.abs(work).max(initial=0.0))) or 1.0)
    if not len(off) or off.max() <= SILENT:
        return ""
    return (
        f"Work and strain energy differ by {off.max():.1g} of the largest at sample {int(off.argmax())}: digits are lost there."
    )


def _keys(system: System) -> list[tuple[int, int, int]]:
    """A hashable key of the rows of a model."""
    columns = (system.row_member, system.row_kind, system.row_measure)
    return [(int(i), int(kind), int(m)) for i, kind, m in zip(*columns, strict=True)]


# Stiffness of a platform by its drives.


@one_thread
def platform_stiffness(
    model: Model,
    platform: str | Sequence[str],
    stiffness: float | Mapping[str, float],
    state: Motion | ArrayLike | None = None,
) -> xr.Dataset:
    """Compliance and stiffness of a platform with elastic drives and rigid bars.

    Parameters
    ----------
    platform, state : as in `kinematics.platform_jacobian`.
    stiffness : of each drive, N/m (N m/rad of an angle): one for all, or by name; drives not named are rigid.

    Returns
    -------
    Dataset. ``compliance`` (time, twist, wrench): C = J K_d^-1 J^T, displacement of the centroid of the nodes (m) and rotation
    (rad) per force through it (N) and couple (N m), global axes; ``stiffness`` (time, wrench, twist): its inverse, the
    pseudoinverse if the platform cannot move in some direction (a Delta's platform does not rotate: 0 there stands for rigid).

    Raises
    ------
    InputError : unknown drives, a stiffness that is not positive, a model with springs.

    Notes
    -----
    To first order about a state without load. Gosselin, Stiffness mapping for parallel manipulators, IEEE Trans. Robotics and
    Automation 6 (1990) 377-382.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1), "D": (1, 1)}, fixed={"A": "xy", "B": "xy", "C": "x", "D": "x"},
    ...     bars={one: kt.Bar(ends=ends, kind="driven") for one, ends in {"left": ("A", "C"), "right": ("B", "D")}.items()},
    ... )
    >>> found = kt.statics.platform_stiffness(model, ["C", "D"], 1000.0)  # N/m of each drive
    >>> found.compliance.sel(twist="v_y", wrench="F_y").round(9).item()  # m/N: two springs side by side
    0.0005
    """
    for kind, field in ELEMENT_FIELDS.items():
        for name in getattr(model, field):
            raise InputError(
                f"platform_stiffness counts drives alone, not the {kind} {name!r}. Take statics.linear under unit loads, or "
                f"leave it out: model.with_({field}={{}})."
            )
    found = platform_jacobian(model, platform, state)
    drives = [str(name) for name in found["drive"].values]
    given = dict.fromkeys(drives, float(stiffness)) if isinstance(stiffness, (int, float)) else dict(stiffness)
    if unknown := [name for name in given if name not in drives]:
        raise InputError(f"No drive called {unknown[0]!r}. {nearest(unknown[0], drives)}")
    if bad := [name for name, value in given.items() if not 0 < value < math.inf]:
        raise InputError(f"stiffness[{bad[0]!r}] is {given[bad[0]]:g}. Give a finite value above 0, N/m or N m/rad.")
    soft = np.array([1 / given[name] if name in given else 0.0 for name in drives])
    J = found["jacobian"].transpose(..., "twist", "drive").values
    C = (J * soft) @ np.swapaxes(J, -1, -2)
    time = ("time",) if "time" in found["jacobian"].dims else ()
    twist = list(found["twist"].values)
    wrench = [name.replace("v", "F").replace("w", "M") for name in twist]
    data = {
        "compliance": variable((*time, "twist", "wrench"), C, "twist_unit/wrench_unit", "compliance of the platform"),
        "stiffness": variable(
            (*time, "wrench", "twist"), _inverse(C, found.attrs["length"], model.dim), "wrench_unit/twist_unit", "stiffness"
        ),
    }
    units = {"twist_unit": ("twist", found["twist_unit"].values.tolist())}
    units["wrench_unit"] = ("wrench", ["N" if name.startswith("F") else "N m" for name in wrench])
    coords = {"twist": twist, "wrench": wrench, **units} | ({"time": found["time"]} if time else {})
    return xr.Dataset(data, coords=coords, attrs={"kind": "platform_stiffness"})


def _inverse(C: np.ndarray, length: float, dim: int) -> np.ndarray:
    """Inverse of a compliance, weighed by a length so that metres and radians compare."""
    scale = np.ones(C.shape[-1])
    scale[dim:] = length
    weight = scale[:, None] * scale
    return np.asarray(np.linalg.pinv(C * weight, rcond=1e-11, hermitian=True) * weight)
