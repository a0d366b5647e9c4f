"""All assembly modes of a structure with given drives."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.structure.plan import ANGLE, LENGTH
from kinetruss.kinematics.modes.homotopy import Quadratics, carry, generic, polished, solve_all
from kinetruss.kinematics.modes.known_platform import all_places, known_platform
from kinetruss.kinematics.modes.layout import Equations, Layout
from kinetruss.kinematics.modes.rigid_groups import rigid_groups
from kinetruss.kinematics.path.assemble import _row_of as row_of
from kinetruss.kinematics.path.assemble import given_lengths
from kinetruss.kinematics.rates.singularity import singularity_at
from kinetruss.mechanics import System, block_triangular, compile
from kinetruss.mechanics.configuration import row_values
from kinetruss.mechanics.constraints import matching
from kinetruss.model import Model
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["assembly_modes"]

LARGEST_BLOCK = 12
"""Largest number of quadratic equations that are solved together: 4,096 paths."""
REAL = 1e-7
"""Solutions with imaginary parts below this fraction of the size of the structure are real."""
CLOSED = 1e-8
"""Tolerance of a row as a fraction of its length."""


def assembly_modes(model: Model, lengths: Mapping[str, float] | None = None, *, most: int = 1000) -> xr.Dataset:
    """All configurations that a structure can have with given drives, not only the one that is connected to its start.

    Parameters
    ----------
    lengths : member or drive name -> value, m or rad, as in `assemble`; by default as in the model.
    most : configurations at which to stop.

    Returns
    -------
    Dataset. ``position`` (mode, node, axis) m; ``distance`` (mode): root mean square distance of the nodes from the model's own
    configuration, m, by which the modes are sorted; ``singularity`` (mode): distance from a singular position, as
    `Motion.singularity`. attrs: ``complex_solutions`` of each block of equations, ``lost``: paths that could not be followed
    to their end (0: the list is complete, with probability one).

    Raises
    ------
    InputError : a structure that can move with its drives held, blocks of more than 12 quadratic equations, drives other than
        lengths, node coordinates and angles in the plane. AnalysisError : more than `most`.

    Notes
    -----
    Bodies of rigid bars keep their handedness. Their inner bars are left out, and the remaining equations split into blocks (a
    Stewart-Gough platform with joints in a plane is one of nine quadratics, 40 complex solutions at most: M. Raghavan 1993; a
    half bay is one of nine). A body on six legs is solved by 40 paths from a generic platform whose poses are stored (see
    `known_platform`). Any other block is solved once for generic complex data by following all 2^n paths (see `homotopy`),
    then continued to the real data by as many paths as it has solutions.

    >>> import kinetruss as kt
    >>> two = kt.Model(nodes={"A": (0, 0), "B": (4, 0), "C": (2, 1)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")})
    >>> kt.kinematics.assembly_modes(two).position.sel(node="C").values.round(9).tolist()
    [[2.0, 1.0], [2.0, -1.0]]
    """
    system = compile(model)
    wanted = _wanted(system, given_lengths(lengths))
    groups = rigid_groups(system, _outside(system))
    layout = Layout(system, groups)
    equations = layout.equations(wanted)
    scale = float(np.mean(wanted[system.row_kind == LENGTH])) if len(wanted) else 1.0
    states = [np.zeros(len(layout.unknown))]
    counts, lost = [], 0
    for rows, columns in _blocks(equations):
        body = layout.body_of(columns)
        found = None if body is None else _platform(equations, rows, columns, states, scale, system.x0[body] / scale)
        states, count, missed = found or _solved(equations, rows, columns, states, scale)
        counts.append(count)
        lost += missed
        if len(states) > most:
            raise AnalysisError(f"More than {most} configurations. Ask for fewer bays at once, or raise most.", None)
    return _dataset(system, layout, [layout.places(one) for one in states], wanted, counts, lost)


def _platform(
    equations: Equations, rows: Any, columns: Any, states: list[NDArray[np.float64]], scale: float, points: NDArray[np.float64]
) -> tuple[list[NDArray[np.float64]], int, int] | None:
    """Like `_solved`, for a body on six legs; None if the block is not one, or has fewer solutions."""
    grown = []
    for state in states:
        block = _block(equations, rows, columns, state, scale)
        if (u := all_places(block, points)) is None:
            return None
        for one in polished(block, u[np.abs(u.imag).max(axis=1) < REAL].real).real:
            grown.append(state.copy())
            grown[-1][columns] = one * scale
    return grown, len(known_platform()[1]), 0


def _solved(
    equations: Equations, rows: Any, columns: Any, states: list[NDArray[np.float64]], scale: float
) -> tuple[list[NDArray[np.float64]], int, int]:
    """Every state with every real solution of one block inserted; the number of complex solutions of the block; lost paths."""
    if not states:
        return [], 0, 0
    outer = np.delete(equations.D[rows], columns, axis=2)  # rows between unknowns of the block alone keep their d = 0
    apart = np.any(outer != 0, axis=(1, 2)) | np.any(equations.d[rows] != 0, axis=1)
    family = generic(_block(equations, rows, columns, states[0], scale), apart)
    known = solve_all(family)
    lost, grown = known.lost, []
    for state in states:
        found = carry(_block(equations, rows, columns, state, scale), family, known.u)
        lost += found.lost
        for u in found.u[np.abs(found.u.imag).max(axis=1, initial=0) < REAL].real:
            grown.append(state.copy())
            grown[-1][columns] = u * scale
    return grown, len(known.u), lost


def _wanted(system: System, lengths: Mapping[str, float]) -> NDArray[np.float64]:
    """Values of the rows; refuses rows that are neither lengths nor angles in the plane."""
    if np.any((system.row_kind != LENGTH) & (system.row_kind != ANGLE)) or (
        system.dim == 3 and np.any(system.row_kind == ANGLE)
    ):
        raise InputError("Only lengths, node coordinates and angles in the plane can be held here. Drive lengths instead.")
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = system.drive_start[system.row_drive[driven]]
    for name, value in lengths.items():
        row = row_of(system, name)
        if system.row_kind[row] == LENGTH and value <= 0:
            raise InputError(f"lengths[{name!r}] is {value:g}. Give a value of a length above 0 m.")
        wanted[row] = value
    return wanted


def _outside(system: System) -> NDArray[np.bool_]:
    """Nodes used outside the rigid bars of one body: ends of other rows than rigid lengths, prescribed coordinates."""
    found: NDArray[np.bool_] = np.any(system.prescribed.reshape(-1, 3)[:, : system.dim], axis=1)
    rest = (system.row_drive >= 0) | (system.row_kind != LENGTH)
    for ends in (system.p, system.q):
        found[ends[system.row_member[rest]]] = True
    return found


def _blocks(equations: Equations) -> list[tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """Rows and columns of square blocks, each depending on earlier ones only; unused rows are checked at the end."""
    from scipy.sparse import csr_array

    touches = np.any(equations.D != 0, axis=1)
    row_of_column = matching(csr_array(touches.T))
    if np.any(row_of_column < 0):
        raise InputError("The structure can move with its drives held, so it has infinitely many configurations. Add drives.")
    found = []
    for mine, columns in block_triangular(csr_array(touches[row_of_column])) or []:
        rows = row_of_column[mine]
        quadratic = int((~equations.linear[rows]).sum())
        if quadratic > LARGEST_BLOCK:
            raise InputError(
                f"{quadratic} quadratic equations are coupled here, more than the {LARGEST_BLOCK} that can be solved at "
                f"once. Hold more of the structure, or take it apart."
            )
        found.append((rows, np.array(columns)))
    return found


def _block(equations: Equations, rows: Any, columns: Any, state: NDArray[np.float64], scale: float) -> Quadratics:
    """One block with known values inserted; lengths over a scale."""
    known = state.copy()
    known[columns] = 0.0
    d = (equations.d[rows] + equations.D[rows] @ known) / scale
    return Quadratics(
        D=equations.D[np.ix_(rows, range(3), columns)],
        d=d,
        s=(equations.value[rows] / scale) ** 2,
        normal=equations.normal[rows],
        linear=equations.linear[rows],
    )


def _dataset(
    system: System, layout: Layout, places: list[NDArray[np.float64]], wanted: NDArray[np.float64], counts: list[int], lost: int
) -> xr.Dataset:
    """Configurations that satisfy all rows and keep the handedness of every body, the nearest to the model's own first."""
    length = system.row_kind == LENGTH
    good = []
    for x in places:
        off = row_values(system, x) - wanted
        off = np.where(length, off / np.maximum(wanted, 1e-300), np.abs(np.exp(1j * off) - 1))
        if np.abs(off).max(initial=0.0) < CLOSED and _same_hand(system, layout, x):
            good.append(x)
    distance = np.array([np.sqrt(np.mean(np.sum((x - system.x0) ** 2, axis=1))) for x in good])
    order = np.argsort(distance, kind="stable")
    position = np.array(good).reshape(-1, len(system.nodes), 3)[order][:, :, : system.dim]
    gauge = singularity_at(system, np.array(good).reshape(len(good), -1)[order])
    data = {
        "position": variable(("mode", "node", "axis"), position, "m", "node position"),
        "distance": variable(("mode",), distance[order], "m", "root mean square distance from the model's configuration"),
        "singularity": variable(("mode",), gauge, "", "distance from a singular position"),
    }
    coords = {"mode": np.arange(1, len(good) + 1), "node": list(system.nodes), "axis": ["x", "y", "z"][: system.dim]}
    return xr.Dataset(data, coords=coords, attrs={"kind": "assembly_modes", "complex_solutions": counts, "lost": lost})


def _same_hand(system: System, layout: Layout, x: NDArray[np.float64]) -> bool:
    """True if no body of four basis nodes is mirrored."""
    for group in layout.groups:
        if len(group.basis) == 4:
            index = list(group.basis)
            now, start = (float(np.linalg.det(y[index[1:]] - y[index[0]])) for y in (x, system.x0))
            if now * start <= 0:
                return False
    return True
