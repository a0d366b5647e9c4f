"""Drive lengths with which the loaded elastic structure reaches the pose that the rigid one has."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from scipy.sparse import block_array, csc_array, diags_array

from kinetruss.errors import AnalysisError, InputError
from kinetruss.flexible.structure import Instant, Softness, instants_of
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.mechanics import RANK_TOLERANCE, System, compile, constraint_jacobian, ends_of, row_scales
from kinetruss.mechanics.coordinates import Coordinate, coordinate_values, coordinates, derivatives_of
from kinetruss.mechanics.matrices import bar_laws
from kinetruss.mechanics.positions import row_values
from kinetruss.mechanics.rows import factors_of
from kinetruss.model import Model, Spline, nearest
from kinetruss.results import Forces, Result, provenance, variable
from kinetruss.results.wide_tables import unit_along
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Corrected", "corrected"]

STEPS = 40
"""Newton's steps at most."""

UNMOVED = 1e-5
"""Singular value of the motion of coordinates by drives, as a fraction of the largest: below, only elasticity moves them."""

CLOSE = 1e-13
"""Size of the last step, as a fraction of the size of the structure."""

ROUND_OFF = 1e-8
"""Below this fraction, a step that is no longer half the one before is round-off."""


class Corrected(Result):
    """Corrected drive lengths along a motion, and the loaded structure that has them."""

    @property
    def trajectory(self) -> Spline:
        """The corrected lengths as a trajectory, for `kinematics.follow` (times from the first sample)."""
        t = self.data["time"].values
        lengths = self.data["drive_length"]
        values = {str(name): tuple(lengths.sel(drive=name).values.tolist()) for name in lengths["drive"].values}
        return Spline(times=tuple((t - t[0]).tolist()), values=values)


@one_thread
def corrected(
    model: Model,
    forces: Forces,
    at: str | Iterable[str],
    *,
    drives: Iterable[str] | None = None,
    stiffness: Mapping[str, float] | None = None,
    rigid: Collection[str] = (),
) -> Corrected:
    """Drive lengths that bring the loaded elastic structure to the pose of the rigid motion.

    Parameters
    ----------
    forces : from `dynamics.inverse` (its loads, weights and inertia act) or `statics.at_poses` of the same model; the pose at
        every sample is that of its motion.
    at : coordinates that shall have the values of the rigid motion: nodes (``"N8"``: all its axes), ``"N8.z"``, pose
        coordinates (``"bay.beta"``), lengths. Not more than drives; with fewer the change of lengths is the least (least
        squares).
    drives : driven lengths that are changed; by default all.
    stiffness, rigid : as in `frequencies`. An active member has the E and A of the weaker of its parts, or its stiffness here.

    Returns
    -------
    Corrected. ``drive_length`` (time, drive) m: the actuators have these lengths without load; ``change`` (time, drive) m, from
    the rigid motion; ``displacement`` (time, node, axis) m, of the corrected structure from the rigid motion; ``member_force``
    (time, member) N; ``error`` (time, coordinate): what remains of each coordinate, m or rad; ``steps`` (time). ``trajectory``
    is a `Spline` of the lengths.

    Raises
    ------
    InputError : more coordinates than drives; drives that do not move the coordinates; forces of another model.
    AnalysisError : no equilibrium was found at a sample, named.

    Notes
    -----
    Large displacements: equilibrium in the displaced position, N = (l - l0)/f of every elastic member with l0 its rigid length,
    and of the actuators with l0 unknown; Newton's method on positions, forces and lengths together, with the whole tangent.
    Loads of inertia are those of the rigid motion. `statics.equilibrium` of the elastic structure with the corrected lengths
    has the wanted pose.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"O": (0, 0), "A": kt.Node(at=(0, -1), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
    ...     bars={"rod": kt.Bar(ends=("O", "A"), kind="driven", mass=0)},
    ... )
    >>> fixed = kt.flexible.corrected(model, kt.runs.forces_at_rest(model), at="A.y", stiffness={"rod": 20e3})
    >>> fixed.change.values.round(6).tolist()  # m: the rod starts m g/k shorter
    [[-0.001]]
    """
    system = compile(model)
    wanted = coordinates(system, at)
    rows = _actuators(system, drives)
    if len(wanted) > len(rows):
        raise InputError(
            f"{len(wanted)} coordinates cannot be held by {len(rows)} drives. Name fewer coordinates in at, e.g. node axes."
        )
    found = [
        _solved(system, here, wanted, rows, i)
        for i, here in enumerate(instants_of(model, forces, Softness(stiffness=stiffness or {}, rigid=rigid)))
    ]
    return _record(system, forces, wanted, rows, found)


def _actuators(system: System, drives: Iterable[str] | None) -> NDArray[np.int64]:
    """Rows of the driven lengths."""
    rows = np.flatnonzero((system.row_drive >= 0) & (system.row_kind == LENGTH))
    known = [system.drives[d] for d in system.row_drive[rows]]
    given = known if drives is None else [drives] if isinstance(drives, str) else list(drives)
    for name in given:
        if name not in known:
            raise InputError(f"{name!r} is no driven length. {nearest(name, known)}".rstrip())
    if not given:
        raise InputError("No length is driven. Give active members or driven bars, whose lengths are corrected.")
    return rows[[known.index(name) for name in given]]


@dataclass(frozen=True, kw_only=True, eq=False)
class Found:
    """A sample: x (n, 3), row forces N, changes of the drives, remaining errors (coordinates,), steps, tension (m,) of laws."""

    x: NDArray[np.float64]
    N: NDArray[np.float64]
    change: NDArray[np.float64]
    error: NDArray[np.float64]
    steps: int
    tension: NDArray[np.float64]


def _solved(system: System, here: Instant, wanted: list[Coordinate], rows: NDArray[np.int64], sample: int) -> Found:
    """Newton's method: K du + G^T N = F, G du - f N - dL = L - l, T du = what is missing of the coordinates."""
    free, n, m = system.free, len(system.free), len(here.f)
    x, N, change = here.x.copy(), here.N.copy(), np.zeros(len(rows))
    start = row_values(system, here.x)
    aim = coordinate_values(system, wanted, here.x.reshape(1, -1))[0]
    base = here.balance.applied(here.x)[free]
    size, before = float(np.ptp(here.x, axis=0).max()), np.inf
    for step in range(1, STEPS + 1):
        G = constraint_jacobian(system, x)[:, free]
        own = bar_laws(system, ends_of(system, x)[1]).tension - here.balance.push
        K = here.balance.tangents(x, N, own)[0][free][:, free]
        solve = _balanced(K, G, here.f)
        if solve is None:
            break
        derived = derivatives_of(system, wanted, x)
        T = (derived.g[0][:, free].toarray()) / derived.r[:, [0]]
        missing = aim - coordinate_values(system, wanted, x.reshape(1, -1))[0]
        right = np.concatenate([here.load + here.balance.applied(x)[free] - base, -_away(system, start, x)])
        # T du by a change of lengths: T M^-1 of their columns, by one transposed solution for each coordinate
        reach = solve(np.vstack([T.T, np.zeros((m, len(wanted)))]), "T")[n + rows].T
        _refuse_unmoved(system, wanted, reach, rows)
        change = np.linalg.lstsq(reach, missing - T @ solve(right, "N")[:n], rcond=RANK_TOLERANCE)[0]
        right[n + rows] += change
        u, N = np.split(solve(right, "N"), [n])
        x = x.copy()
        x.reshape(-1)[free] += u
        moved = float(np.abs(u).max(initial=0.0)) / size
        if moved <= CLOSE or ROUND_OFF > moved > 0.5 * before:
            error = coordinate_values(system, wanted, x.reshape(1, -1))[0] - aim
            tension = bar_laws(system, ends_of(system, x)[1]).tension
            return Found(x=x, N=N, change=change, error=error, steps=step, tension=tension)
        if not moved < 10:
            break
        before = moved
    raise AnalysisError(
        f"No equilibrium with corrected lengths was found at sample {sample}. The deflection is large there: stiffen the "
        "members, or correct other coordinates."
    )


def _balanced(K: Any, G: Any, f: NDArray[np.float64]) -> Callable[[NDArray[np.float64], str], NDArray[np.float64]] | None:
    """Solutions with M = [[K, G^T], [G, -f]] ("N") or its transpose ("T") by sparse factors; None if it is singular."""
    matrix = csc_array(block_array([[K, G.T], [G, diags_array(-f)]]))
    if (factors := factors_of(matrix)) is None:
        return None

    def solve(right: NDArray[np.float64], kind: str) -> NDArray[np.float64]:
        M = matrix if kind == "N" else matrix.T
        found = factors.solve(right, kind)
        # one step of refinement
        return np.asarray(found + factors.solve(right - M @ found, kind))

    return solve


def _away(system: System, start: NDArray[np.float64], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Change of the row values since the rigid pose, scaled like the rows of the Jacobian, m."""
    off = row_values(system, x) - start
    turning = system.row_kind != LENGTH
    if turning.any():
        off[turning] *= row_scales(system, x, np.flatnonzero(turning))
    return off


def _refuse_unmoved(system: System, wanted: list[Coordinate], reach: NDArray[np.float64], rows: NDArray[np.int64]) -> None:
    """Refuse coordinates that the drives do not move, or not independently."""
    u, s, _ = np.linalg.svd(reach)
    if s.min() > UNMOVED * s.max():
        return
    named = wanted[int(np.abs(u[:, -1]).argmax())].name
    drives = ", ".join(system.drives[d] for d in system.row_drive[rows])
    raise InputError(f"The drives {drives} do not move {named!r} independently of the other coordinates. Leave it out of at.")


def _record(system: System, forces: Forces, wanted: list[Coordinate], rows: NDArray[np.int64], found: list[Found]) -> Corrected:
    x0 = forces.motion.arrays["position"].values
    x = np.array([one.x for one in found])[:, :, : system.dim]
    change = np.array([one.change for one in found])
    rigid = forces.motion.arrays["length"].values[:, system.row_member[rows]]
    tension = np.array([one.tension for one in found])
    bars = system.row_kind == LENGTH
    tension[:, system.row_member[bars]] = np.array([one.N for one in found])[:, bars]
    per, (unit, named) = ("time", "drive"), unit_along("coordinate", [one.unit for one in wanted], "coordinate_unit", "m")
    data = {
        "drive_length": variable(per, rigid + change, "m", "length of the actuator without load"),
        "change": variable(per, change, "m", "change of the length"),
        "displacement": variable(("time", "node", "axis"), x - x0, "m", "displacement from the rigid motion"),
        "member_force": variable(("time", "member"), tension, "N", "mean axial force, tension positive"),
        "error": variable(("time", "coordinate"), np.array([one.error for one in found]), unit, "remaining error"),
        "steps": variable(("time",), np.array([one.steps for one in found]), "", "Newton's steps"),
    }
    coords = {
        name: forces.whole.coords[name] for name in ("time", "pose", "node", "axis", "member") if name in forces.whole.coords
    }
    own = {"drive": [system.drives[d] for d in system.row_drive[rows]], "coordinate": [one.name for one in wanted], **named}
    frame = xr.Dataset(data, coords=own, attrs={"kind": "corrected", "load_case": forces.load_case}).assign_coords(coords)
    return Corrected(
        data=frame,
        status=forces.status,
        message=forces.message,
        provenance=provenance(system.given, load_case=forces.load_case),
    )
