"""The points of a study: the values of its variables, row by row, from a grid, a drawn sample or a table."""

from __future__ import annotations

import csv
import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.limits import MOST_VARIANTS, hold
from kinetruss.studies.study_file import Sample, Study, Variable, parted, unit_in

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

EDGE = 1e-12
"""Least distance of a draw from 0 and 1: a normal distribution has no ends."""


@dataclass(frozen=True, eq=False)
class Points:
    """Values of the variables of all variants.

    names : of the variables. units : of each, "" of bare numbers, None of texts. rows : (points) of values, numbers in these
    units, or texts.
    """

    names: tuple[str, ...]
    units: tuple[str | None, ...]
    rows: tuple[tuple[float | str, ...], ...]

    def texts(self, k: int) -> dict[str, Any]:
        """The values of row k by name, as they stand in a model file."""
        return {
            name: f"{value!r} {unit}" if unit and not isinstance(value, str) else value
            for name, unit, value in zip(self.names, self.units, self.rows[k], strict=True)
        }


def points_of(study: Study, cube: ArrayLike | None = None) -> Points:
    """All points of a study. cube : (points, variables) from 0 to 1 instead of its sample, e.g. of an engine of SciPy's qmc.

    Raises
    ------
    InputError : too many points, or a cube of another shape. ModelError : faults of a table.

    Notes
    -----
    Latin hypercube and scrambled Sobol points: `scipy.stats.qmc` (M. D. McKay et al., 1979; I. M. Sobol, 1967; A. B. Owen,
    1998). Saltelli's design: matrices A and B, and A with one column of B each (A. Saltelli et al., 2010, table 2).
    """
    if cube is not None:
        return _from_cube(study, _checked(study, cube))
    sample = study.sample or Sample(grid=1)
    if study.sample is None and (ranges := [name for name, one in study.variables.items() if one.values is None]):
        raise InputError(
            f"variables.{ranges[0]} is a range, and the study has no sample. Give for example sample: {{sobol: 256}}."
        )
    if sample.table is not None:
        return _table(study, Path(sample.table))
    if sample.kind == "grid":
        return _grid(study, sample.grid or 1)
    return _from_cube(study, _drawn(sample, len(study.variables)))


def _points(study: Study, rows: Sequence[Sequence[float | str]]) -> Points:
    units = tuple(one.unit for one in study.variables.values())
    return Points(tuple(study.variables), units, tuple(map(tuple, rows)))


def _held(count: int) -> None:
    hold(count, "This study", "Give fewer points.", most=MOST_VARIANTS, of="variants")


def _grid(study: Study, count: int) -> Points:
    levels = [_levels(one, count) for one in study.variables.values()]
    _held(math.prod(map(len, levels)))
    return _points(study, list(itertools.product(*levels)))


def _levels(one: Variable, count: int) -> list[float | str]:
    if one.values is not None:
        return [_value(text, one.unit) for text in one.values]
    low, high = (parted(text)[0] for text in one.between or ())  # type: ignore[index]
    return [float(value) for value in np.linspace(low, high, count)]


def _value(text: str, unit: str | None) -> float | str:
    """A listed value as a number in the unit of its variable; a text if it has none."""
    return text if unit is None else parted(text)[0]  # type: ignore[index]


def _drawn(sample: Sample, width: int) -> NDArray[np.float64]:
    """Points (points, width) from 0 to 1."""
    from scipy.stats import qmc

    kind, seed = sample.kind, sample.seed
    count: int = getattr(sample, kind)
    _held(count * (width + 2) if kind == "saltelli" else count)
    if kind == "monte_carlo":
        return np.random.default_rng(seed).random((count, width))
    if kind == "latin_hypercube":
        drawn: NDArray[np.float64] = qmc.LatinHypercube(width, rng=np.random.default_rng(seed)).random(count)
        return drawn
    both = qmc.Sobol(2 * width if kind == "saltelli" else width, rng=np.random.default_rng(seed)).random(count)
    if kind == "sobol":
        sobol: NDArray[np.float64] = both
        return sobol
    A, B = both[:, :width], both[:, width:]
    mixed = [np.where(np.arange(width) == k, B, A) for k in range(width)]
    return np.concatenate([A, B, *mixed])


def _checked(study: Study, cube: ArrayLike) -> NDArray[np.float64]:
    found = np.asarray(cube, float)
    wanted = len(study.variables)
    if found.ndim != 2 or found.shape[1] != wanted or not len(found):
        raise InputError(f"The points have the shape {found.shape}. Give (points, {wanted}): {', '.join(study.variables)}.")
    if not ((found >= 0) & (found <= 1)).all():
        raise InputError("The points are not from 0 to 1. Give points of the unit cube, as of scipy.stats.qmc.")
    _held(len(found))
    return found


def _from_cube(study: Study, cube: NDArray[np.float64]) -> Points:
    """The values at points of the unit cube, by the distribution of each variable."""
    columns = [_along(one, cube[:, k]) for k, one in enumerate(study.variables.values())]
    return _points(study, list(zip(*columns, strict=True)))


def _along(one: Variable, u: NDArray[np.float64]) -> list[float | str]:
    if one.values is not None:
        places = np.minimum((u * len(one.values)).astype(int), len(one.values) - 1)
        return [_value(one.values[k], one.unit) for k in places.tolist()]
    first, second = (parted(text)[0] for text in one.between or one.normal or ())  # type: ignore[index]
    if one.between is not None:
        return (first + (second - first) * u).tolist()  # type: ignore[no-any-return]
    from scipy.special import ndtri

    return (first + second * ndtri(np.clip(u, EDGE, 1 - EDGE))).tolist()  # type: ignore[no-any-return]


# A table of points.


def _table(study: Study, path: Path) -> Points:
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            lines = [
                (number, cells)
                for number, cells in enumerate(csv.reader(file, skipinitialspace=True), 1)
                if any(map(str.strip, cells))
            ]
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path} cannot be read: {error}. sample.table is a CSV file beside the study.") from None
    if len(lines) < 2:
        fault = Fault(
            ("table",), "has no row of values.", "Give a head with the names of the variables, and a row for each variant."
        )
        raise ModelError([fault], str(path))
    names, faults = tuple(cell.strip() for cell in lines[0][1]), []
    if missing := [name for name in study.variables if name not in names]:
        faults.append(Fault(("table",), f"has no column {missing[0]!r}.", "Add it, or remove the variable.", 1, 1))
    if twice := [name for name in names if names.count(name) > 1 or not name]:
        faults.append(
            Fault(("table",), f"has the column {twice[0]!r} twice, or without a name.", "Give each column one name.", 1, 1)
        )
    for number, cells in lines[1:]:
        if len(cells) != len(names):
            faults.append(
                Fault(("table",), f"has {len(cells)} cells, expected {len(names)}.", "Give one for each variable.", number, 1)
            )
        elif empty := [k for k, cell in enumerate(cells) if not cell.strip()]:
            faults.append(
                Fault(("table",), f"has no value of {names[empty[0]]!r}.", "Give one; ~ stands for none.", number, empty[0] + 1)
            )
    if faults:
        raise ModelError(faults, str(path))
    _held(len(lines) - 1)
    cells_of = list(zip(*(tuple(cell.strip() for cell in cells) for _, cells in lines[1:]), strict=True))
    units = tuple(unit_in(column) for column in cells_of)
    values = [[_value(text, unit) for text in column] for column, unit in zip(cells_of, units, strict=True)]
    return Points(names, units, tuple(zip(*values, strict=True)))
