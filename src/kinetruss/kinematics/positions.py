"""One configuration from prescribed lengths, and whether it can be reached at all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError, InputError, shown
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.kernels.sweep.follow import continuation
from kinetruss.kinematics.redundant import AGREE, LEAST, Path, contradicts, misses, walked
from kinetruss.mechanics import System, arrange, cached, compile, jacobian
from kinetruss.mechanics.arguments import number_of
from kinetruss.mechanics.beam_shapes import shaped
from kinetruss.mechanics.mobility import underdriven
from kinetruss.mechanics.positions import row_values, shortest
from kinetruss.model import Model
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import Arrangement


LARGEST = 300
"""Number of free coordinates up to which the check is made."""
SHOWN = 3
HELD = 1e4
"""Weight of constraints that are not meant to change: their share of the residual is about 1/weight^2."""


def out_of_reach(system: System, path: Path, k: int, x: NDArray[np.float64]) -> str:
    """Text: how near to sample k of a path the structure comes from the positions x (3 n,); "" if it can be closed there.

    Minimises the sum of squares of all residuals, with those of bars and of drives at rest weighted so that only the moving
    drives miss their values. If the minimum is above round-off, no configuration nearby has the prescribed lengths.
    """
    free = np.flatnonzero(~system.prescribed)
    if len(free) > LARGEST:
        return ""
    from scipy.optimize import least_squares

    rows, values, here = np.arange(len(system.row_member)), path.drive[0][k], x.copy()
    if (plan := arrange(system).plan) is not None:
        here[plan.moving] = path.moving[0][k]

    moved = np.abs(values - path.drive[0][0]) > 0
    weight = np.where((system.row_drive >= 0) & moved[np.maximum(system.row_drive, 0)], 1.0, HELD) if len(moved) else HELD

    def placed(y: NDArray[np.float64]) -> NDArray[np.float64]:
        at = here.copy()
        at[free] = y
        return at

    def gaps(y: NDArray[np.float64]) -> NDArray[np.float64]:
        found: NDArray[np.float64] = weight * misses(system, rows, values[None], placed(y)[None])[0]
        return found

    def slopes(y: NDArray[np.float64]) -> NDArray[np.float64]:
        found: NDArray[np.float64] = np.reshape(weight, (-1, 1)) * jacobian(system, placed(y).reshape(-1, 3), values)
        return found

    # MINPACK's method takes a fiftieth of the time, but needs at least as many equations as unknowns
    method = "lm" if len(rows) >= len(free) else "trf"
    found = least_squares(gaps, here[free], slopes, method=method, xtol=1e-14, ftol=1e-14, gtol=1e-14, max_nfev=200)
    off = gaps(found.x) / weight
    if not np.abs(off).max() > 100 * AGREE * shortest(system):
        return ""
    driven = [r for r in rows if system.row_drive[r] >= 0 and system.row_kind[r] == LENGTH and moved[system.row_drive[r]]]
    driven = sorted((r for r in driven if abs(off[r]) > 0), key=lambda r: -abs(off[r]))[:SHOWN]
    wanted = values[system.row_drive[driven]] if driven else np.zeros(0)
    near = ", ".join(f"{system.row_name(r)} {w + off[r]:.6g} m of {w:.6g} m" for r, w in zip(driven, wanted, strict=True))
    return f"the nearest possible then is {near}" if near else f"the bars would be off by {np.abs(off).max():.3g} m"


# One configuration from prescribed lengths.


@one_thread
def assemble(model: Model, lengths: Mapping[str, float] | None = None) -> NDArray[np.float64]:
    """Node positions for prescribed lengths, reached from the model's own configuration.

    Parameters
    ----------
    lengths : member or drive name -> value, m (angle drives: rad). Members not named keep the model's value.

    Returns
    -------
    positions, (n_nodes, dim), m, in the order of ``model.nodes``.

    Raises
    ------
    InputError : an unknown name, a length that is not positive, or fewer drives than freedoms.
    AnalysisError : the lengths cannot be closed; `result` holds the last good positions.

    Notes
    -----
    Step-limited continuation (Allgower & Georg, 1990, chapter 2): all values change from their start to their target in
    steps small enough for Newton's method to converge. The configuration found is therefore connected to the start.

    >>> import kinetruss as kt
    >>> two = kt.Model(nodes={"A": (0, 0), "B": (4, 0), "C": (2, 1)}, fixed=["A", "B"],
    ...                bars={"a": ("A", "C"), "b": ("B", "C")})
    >>> kt.kinematics.assemble(two, {"a": 2.5, "b": 2.5})[2].round(9).tolist()
    [2.0, 1.5]
    """
    system = shaped(compile(model))
    wanted = system.row_value.copy()
    wanted[system.row_drive >= 0] = system.drive_start[system.row_drive[system.row_drive >= 0]]
    for name, value in given_lengths(lengths).items():
        wanted[_row_of(system, name)] = value
    if np.any(wanted[system.row_kind == LENGTH] <= 0):
        raise InputError("Every length must be greater than 0.")
    x, reached = assembled(system, wanted)
    if reached < 1:
        raise AnalysisError(
            f"The lengths cannot be closed: {reached:.1%} of the way from the model's own lengths was reached. "
            "Give lengths nearer to the model's own, or start from another configuration.",
            x[:, : system.dim],
        )
    refuse_unmet(system, x, wanted)
    return x[:, : system.dim].copy()


def given_lengths(lengths: Any) -> dict[str, float]:
    """Lengths (m) and angles (rad) by name, as numbers.

    Raises
    ------
    InputError : not a mapping, or a value that is not a finite number.
    """
    if lengths is not None and not isinstance(lengths, Mapping):
        raise InputError(f"lengths is {shown(lengths)}. Give name -> value, e.g. {{'M7': 1.2}}.")
    return {name: number_of(value, f"lengths[{name!r}]", "m or rad") for name, value in (lengths or {}).items()}


@cached()
def own_start(system: System) -> NDArray[np.float64]:
    """The model's own configuration, (n, 3) m; assembled first if its lengths differ from its node positions."""
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = system.drive_start[system.row_drive[driven]]
    if np.allclose(wanted, row_values(system, system.x0), rtol=0, atol=1e-12 * shortest(system)):
        return system.x0
    x, reached = assembled(system, wanted)
    if reached < 1:
        raise InputError(
            "The lengths given in the model cannot be closed from its node positions. "
            "Draw the nodes nearer to a closed configuration, or correct the lengths."
        )
    refuse_unmet(system, x, wanted)
    return x


def refuse_unmet(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64]) -> None:
    """Raise `InputError` if a redundant constraint is not satisfied: then the prescribed values contradict each other."""
    extra = arrange(system).redundant
    if not len(extra):
        return
    miss = np.abs(row_gaps(system, x, wanted))
    if miss.max() > AGREE * shortest(system):
        r = int(miss.argmax())
        raise InputError(
            f"The lengths contradict each other: {system.part_of(r)!r} is fixed by the others and is "
            f"off by {miss[r]:.3g} m. "
            "Do not prescribe all of them."
        )


def assembled(
    system: System, wanted: NDArray[np.float64], moved: NDArray[np.float64] | None = None
) -> tuple[NDArray[np.float64], float]:
    """Returns positions (n, 3) with all constraints at `wanted`, and the fraction of the change reached (1: all of it).

    moved : (coordinate drives,) their target, m; by default they stand still. Supports stand still.
    """
    arrangement = arrange(system)
    if arrangement.plan is None:
        raise underdriven(system)
    x = system.x0.reshape(1, -1).copy()
    now = row_values(system, system.x0)
    held = x[0, arrangement.plan.moving]
    there = held.copy()
    if moved is not None:
        there[: len(moved)] = moved
    # continuation treats every constraint as a drive, so that rigid lengths that differ from the drawing change in steps too
    every = np.arange(len(now))
    plan = arrangement.plan.with_(drive=every, driven=every)
    ends = np.stack([now, wanted])[:, plan.row]
    if not len(arrangement.redundant):
        return x.reshape(-1, 3), continuation(plan, x, 0, ends, held, there, shortest(system), np.zeros(len(plan.ptr)), False)
    return _together(system, arrangement, now, wanted, (held, there), (plan, x, ends))


def _together(
    system: System,
    arrangement: Arrangement,
    now: NDArray[np.float64],
    wanted: NDArray[np.float64],
    moving: tuple[NDArray[np.float64], NDArray[np.float64]],
    kept: tuple[Any, ...],
) -> tuple[NDArray[np.float64], float]:
    """`assembled` of a redundant structure: all constraints change together. If that fails, the independent ones change and the
    redundant ones must agree.

    Constraints that contradict each other to first order keep a residual, which the caller reports.
    """
    free = replace(system, row_drive=np.arange(len(now), dtype=system.row_drive.dtype), drive_start=now)
    still = np.zeros_like
    pair, places = np.stack([now, wanted]), np.stack(moving)
    path = Path(t=np.array([0.0, 1.0]), drive=(pair, still(pair), still(pair)), moving=(places, still(places), still(places)))
    there, share = walked(free, path, system.x0.reshape(-1), 0, LEAST)
    if share == 1:
        return there.reshape(-1, 3), 1.0
    plan, x, ends = kept
    reached = float(continuation(plan, x, 0, ends, *moving, shortest(system), np.zeros(len(plan.ptr)), False))
    met = reached == 1 and np.abs(row_gaps(system, x.reshape(-1, 3), wanted)).max() <= AGREE * shortest(system)
    if met or (reached == 1 and contradicts(free, arrangement, path, 0, system.x0.reshape(-1))):
        return x.reshape(-1, 3), 1.0
    return there.reshape(-1, 3), share


def row_gaps(system: System, x: NDArray[np.float64], wanted: NDArray[np.float64]) -> NDArray[np.float64]:
    """Residuals of all constraints (rows,), m: value at positions x (n, 3) minus `wanted` (rows,)."""
    free = replace(system, row_drive=np.arange(len(wanted), dtype=system.row_drive.dtype))
    found: NDArray[np.float64] = misses(free, np.arange(len(wanted)), wanted[None], x.reshape(1, -1))[0]
    return found


def _row_of(system: System, name: str) -> int:
    if name in system.drives:
        found = np.flatnonzero(system.row_drive == system.drives.index(name))
        if len(found):
            return int(found[0])
    if name in system.members:
        found = np.flatnonzero((system.row_member == system.members.index(name)) & (system.row_kind == LENGTH))
        if len(found):
            return int(found[0])
    known = ", ".join(system.row_name(r) for r in range(min(12, len(system.row_member))))
    raise InputError(f"No prescribed length called {name!r}. There are: {known}.")
