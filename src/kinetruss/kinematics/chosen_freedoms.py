"""Degrees of freedom and conditioning along a motion."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from scipy.linalg import qr

from kinetruss.errors import InputError
from kinetruss.kinematics.jacobians import jacobian, state_of
from kinetruss.mechanics import RANK_TOLERANCE, System, compile, constraint_jacobian, jacobian as rows_of
from kinetruss.mechanics.coordinates import Coordinate, chosen_dofs, coordinate_values, derivatives_of, released
from kinetruss.mechanics.rows import null_basis
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Model, nearest
from kinetruss.results import Motion, variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray


@one_thread
def freedoms(
    model: Model,
    motion: Motion,
    among: str | Iterable[str] | None = None,
    *,
    first: str | Iterable[str] | None = None,
    held: Iterable[str] = (),
    least: float = 0.2,
) -> xr.Dataset:
    """Degrees of freedom that are valid along a motion, exchanged for others if they degenerate.

    Parameters
    ----------
    among : names of node coordinates (``"B.x"``), nodes (all their axes), lengths of driven or elastic members and angles to
        choose from, mixed. By default all node coordinates that can move.
    first : the set to begin with; by default the best one.
    held : names of drives that stay prescribed; all others are released.
    least : a set is kept until its grip falls below this fraction of the grip of the best set, 0 < least < 1.

    Returns
    -------
    Dataset. ``chosen`` (time, dof): names of the set in use; ``value``, ``rate`` (time, dof): of these coordinates, m or rad
    (angles within -pi to pi);
    ``grip`` (time): smallest singular value of the set on the possible motions, at most 1, and 0 at a dead centre;
    ``switched`` (time): True at the first sample of a new set. attrs ``sets``: the sets in the order of use.

    Raises
    ------
    InputError : unknown names, coordinates that are held, nothing that can move, a set that never fixes the configuration.

    Notes
    -----
    With an orthonormal basis T of the null space of the prescribed rows, the rows S of the candidates as gradients of unit size
    and P = S T: the set is chosen by QR with column pivoting of P^T; its grip is the smallest singular value of its rows of P.
    For a crank that makes full turns no single node coordinate is valid throughout (Andrews' mechanism): x and y of its end
    alternate.

    >>> import kinetruss as kt
    >>> crank = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": ("A", "B")},
    ...                  drives={"w": kt.AngleDrive("b")})
    >>> turn = kt.kinematics.follow(crank, kt.ConstantRate(rates={"w": 6.0}, duration=1.0), samples=201)
    >>> kt.kinematics.freedoms(crank, turn).attrs["sets"]
    ['B.y', 'B.x', 'B.y', 'B.x']
    """
    if not 0 < least < 1:
        raise InputError(f"least={least:g} is not a fraction. Give a number between 0 and 1, e.g. 0.2.")
    system = compile(model)
    x, time = state_of(system, motion)
    v = flat_positions(system, motion.arrays["velocity"].values)
    loose = _released(system, held)
    candidates = chosen_dofs(system, among)[0] if among is not None else _node_coordinates(loose)
    places = {one.name: k for k, one in enumerate(candidates)}
    current = None if first is None else _indices(chosen_dofs(system, first)[0], places)
    rows: list[NDArray[np.int64]] = []
    grip = np.empty(len(x))
    numbers = np.empty((2, len(x)), object)
    for i, (place, speed) in enumerate(zip(x, v, strict=True)):
        P, S, r = _on_motions(loose, candidates, place.reshape(-1, 3))
        current, grip[i] = _kept(P, current, least, float(time.values[i]))
        rows.append(current)
        numbers[0, i] = coordinate_values(loose, [candidates[k] for k in current], place[None])[0].tolist()
        numbers[1, i] = (S[current] @ speed / r[current]).tolist()
    return _dataset(motion, candidates, np.array(rows), grip, numbers)


def _released(system: System, held: Iterable[str]) -> System:
    """The system with all drives released except those held."""
    kept = [held] if isinstance(held, str) else list(held)
    if unknown := [name for name in kept if name not in system.drives]:
        raise InputError(f"No drive called {unknown[0]!r} to hold. {nearest(unknown[0], system.drives)}")
    return released(system, tuple(name for name in system.drives if name not in kept))


def _node_coordinates(system: System) -> list[Coordinate]:
    """All node coordinates that are free."""
    names = [f"{system.nodes[flat // 3]}.{'xyz'[flat % 3]}" for flat in system.free]
    return [Coordinate(name, "node", int(flat)) for name, flat in zip(names, system.free, strict=True)]


def _indices(chosen: list[Coordinate], places: dict[str, int]) -> NDArray[np.int64]:
    if lost := [one.name for one in chosen if one.name not in places]:
        raise InputError(f"{lost[0]!r} of first is not among the coordinates to choose from. Name it in among too.")
    return np.array([places[one.name] for one in chosen], np.int64)


def _on_motions(
    system: System, candidates: list[Coordinate], x: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """P (candidates, freedoms): rows of unit size on the possible motions; the rows S (candidates, 3 n) and their r."""
    T = null_basis(constraint_jacobian(system, x)[:, system.free])
    if not T.shape[1]:
        raise InputError("Nothing can move here: rigid bars and held drives fix all nodes.")
    found = derivatives_of(system, candidates, x)
    S = found.g[0].toarray()
    size = np.linalg.norm(S[:, system.free], axis=1, keepdims=True)
    return (S[:, system.free] / np.where(size > 0, size, 1.0)) @ T, S, found.r[:, 0]


def _kept(
    P: NDArray[np.float64], current: NDArray[np.int64] | None, least: float, time: float
) -> tuple[NDArray[np.int64], float]:
    """The set to use and its grip: the current one, or the best one if the grip of the current one is too small."""
    _, order = qr(P.T, mode="r", pivoting=True)
    best = np.sort(order[: P.shape[1]])
    top = _grip(P, best)
    if len(best) < P.shape[1] or top < RANK_TOLERANCE:
        raise InputError(
            f"The coordinates named do not fix the configuration at t = {time:g} s: the structure has {P.shape[1]} freedoms. "
            f"Name more to choose from."
        )
    if current is None:
        return best, top
    if len(current) != P.shape[1]:
        raise InputError(f"first names {len(current)} coordinates, but the structure has {P.shape[1]} freedoms. Name as many.")
    own = _grip(P, current)
    return (current, own) if own >= least * top else (best, top)


def _grip(P: NDArray[np.float64], chosen: NDArray[np.int64]) -> float:
    return float(np.linalg.svd(P[chosen], compute_uv=False)[-1])


def _dataset(
    motion: Motion, candidates: list[Coordinate], rows: NDArray[np.int64], grip: NDArray[np.float64], numbers: Any
) -> xr.Dataset:
    switched = np.r_[False, np.any(rows[1:] != rows[:-1], axis=1)]
    names = np.array([one.name for one in candidates])[rows]
    starts = np.flatnonzero(np.r_[True, switched[1:]])
    per, units = ("time", "dof"), np.array([one.unit for one in candidates])[rows]
    single = len(np.unique(units)) == 1
    unit = str(units.flat[0]) if single else "dof_unit"
    data = {
        "chosen": variable(per, names, "", "degrees of freedom in use"),
        "value": variable(per, np.array(numbers[0].tolist(), float), unit, "value of the degree of freedom"),
        "rate": variable(per, np.array(numbers[1].tolist(), float), f"{unit}/s", "rate of the degree of freedom"),
        "grip": variable(("time",), grip, "", "smallest singular value of the set on the possible motions"),
        "switched": variable(("time",), switched, "", "a new set begins"),
    }
    attrs = {"kind": "freedoms", "sets": [", ".join(names[i]) for i in starts]}
    return xr.Dataset(data, coords={"time": motion.whole["time"]} | ({} if single else {"dof_unit": (per, units)}), attrs=attrs)


# Conditioning along a motion: singular values of the whole Jacobian at every sample.


@one_thread
def conditioning(
    model: Model, motion: Motion, *, of: str | Iterable[str] | None = None, wrt: str | Iterable[str] | None = None
) -> xr.Dataset:
    """Singular values and condition number along a motion.

    Parameters
    ----------
    of, wrt : without them, the Jacobian of all prescribed lengths and angles by all free coordinates, with rows of unit length
        (as in `mobility`); with them, the Jacobian of these coordinates, which should be all lengths or all angles on either
        side, since singular values of mixed units have no meaning.

    Returns
    -------
    Dataset: ``singular_value`` (time, mode), largest first; ``smallest`` (time); ``condition`` (time), largest over smallest,
    infinite at a singular position.

    Raises
    ------
    InputError : as in `jacobian`; ``wrt`` without ``of``.

    Notes
    -----
    ``motion.singularity`` is the smallest value among the blocks, which is faster; here the dense Jacobian is used.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")}
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"turn": 1.0}, duration=1.0), samples=3)
    >>> kt.kinematics.conditioning(crank, motion).condition.values.round(6).tolist()  # the rows are at right angles
    [1.0, 1.0, 1.0]
    """
    system = compile(model)
    x, time = state_of(system, motion)
    if of is not None:
        J = jacobian(model, motion, of=of, wrt=wrt).values
    elif wrt is not None:
        raise InputError("wrt is given without of. Name what is to be differentiated, e.g. of='N8'.")
    else:
        drives = motion.arrays["drive_position"].values
        J = np.array([rows_of(system, one.reshape(-1, 3), values) for one, values in zip(x, drives, strict=True)])
    found = np.linalg.svd(J, compute_uv=False) if J.size else np.ones((len(x), 1))
    data = {
        "singular_value": variable(("time", "mode"), found, "", "singular values of the Jacobian"),
        "smallest": variable(("time",), found[:, -1], "", "smallest singular value of the Jacobian"),
        "condition": variable(("time",), _ratio(found), "", "condition number of the Jacobian"),
    }
    coords = {"time": time, "mode": np.arange(1, found.shape[1] + 1)}
    return xr.Dataset(data, coords=coords, attrs={"kind": "conditioning"})


def _ratio(found: NDArray[np.float64]) -> NDArray[np.float64]:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(found[:, -1] > 0, found[:, 0] / found[:, -1], np.inf)
