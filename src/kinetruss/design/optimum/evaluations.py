"""Every point is computed once: values are remembered, also in a file, from which a killed search goes on as if never stopped.

The search is deterministic. It begins anew, and what the file knows is not computed again; so it reaches the place where it was
stopped, to the last bit, without any state of the solvers.
"""

from __future__ import annotations

import base64
import hashlib
import json
import os
import zlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.design.optimum.problem import Problem
from kinetruss.errors import AnalysisError, ModelError

if TYPE_CHECKING:
    from numpy.typing import NDArray

FEASIBLE = 1e-6
"""Largest excess, of the size of its limit, of a point that is taken as feasible."""
UNKNOWN = 1e3
"""Excess of a value that is not known, although it was at the start, or infinite, as of a member beyond its buckling load."""


class BeyondError(AnalysisError):
    """A place p (n,) where limits that are far exceeded have no gradient, as they are infinite or nearly so."""

    def __init__(self, p: NDArray[np.float64]) -> None:
        super().__init__(
            "Limits are infinite near the start of the search, as of a member beyond its buckling load, and have no gradient. "
            "Start with stronger members, or raise the least values of variables."
        )
        self.p = p


class OutsideError(BeyondError):
    """A place p (n,) where an analysis fails, as it does out of reach, or there is no such model, unlike at the start."""

    def __init__(self, p: NDArray[np.float64], why: str) -> None:
        super().__init__(p)
        self.args = (
            f"Near where the search stands the analysis fails. Start it elsewhere, or narrow the bounds. {why}".strip(),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """One point of the history. analyses : computed so far. feasible : no limit is exceeded of those that were asked."""

    analyses: int
    objective: float
    worst: float
    feasible: bool


class Evaluations:
    """The function of a problem, remembered.

    analyses : points at which it was asked, also those that the file knew; computed : those that were computed here.
    best : the best point p that keeps all limits so far, and its objective; nearest : that with the least excess.
    """

    def __init__(
        self, problem: Problem, file: Path | None = None, told: Callable[[int, float, float], None] | None = None
    ) -> None:
        self.problem, self.file, self.told = problem, file, told
        self.analyses = self.computed = 0
        self.history: list[Step] = []
        self.best: tuple[NDArray[np.float64], float] | None = None
        self.nearest: tuple[NDArray[np.float64], float] | None = None
        self._known: dict[str, tuple[NDArray[np.float64], NDArray[np.float64]]] = {}
        self._seen: set[bytes] = set()
        self._why: dict[bytes, str] = {}
        """What an analysis said where it failed."""
        self._stored = _stored(file) if file is not None else {}

    def values(self, p: NDArray[np.float64], rows: NDArray[np.int64] | None = None) -> tuple[float, NDArray[np.float64]]:
        """Objective, and excess of some limits, or of all.

        Raises
        ------
        OutsideError : the analysis fails there. AnalysisError : it does at the first point of all.
        """
        objective, excess = self._asked("v", p, rows, self._values)
        if np.isnan(objective):
            raise OutsideError(p, self._why.get(p.tobytes(), ""))
        self._noted(p, float(objective), excess, whole=rows is None or len(rows) == len(self.problem.limits))
        return float(objective), excess

    def gradients(self, p: NDArray[np.float64], rows: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Derivatives by z, in which the solver sees the variables: of the objective (n,), of the excess (rows, n)."""
        try:
            objective, excess = self._asked("g", p, rows, self.problem.function.gradients)
        except (AnalysisError, ModelError):
            self.values(p, rows)  # raises where these fail too
            raise
        slope = self.problem.slope(p)
        return objective * slope, excess * slope

    def _values(self, p: NDArray[np.float64], rows: NDArray[np.int64] | None) -> tuple[float, NDArray[np.float64]]:
        """As of the function; NaN where it fails."""
        try:
            return self.problem.function.values(p, rows)
        except (AnalysisError, ModelError) as error:
            if not self.history:
                raise
            self._why[p.tobytes()] = str(error)
            return np.nan, np.full(len(self.problem.limits) if rows is None else len(rows), np.nan)

    def _asked(self, kind: str, p: Any, rows: Any, compute: Any) -> Any:
        which = b"all" if rows is None else np.asarray(rows, np.int64).tobytes()
        key = f"{kind}{hashlib.blake2b(p.tobytes() + which, digest_size=16).hexdigest()}"
        if key not in self._known:
            if (point := p.tobytes()) not in self._seen:
                self._seen.add(point)
                self.analyses += 1
            if key in self._stored:
                self._known[key] = self._stored.pop(key)
            else:
                self.computed += 1
                one, more = compute(p, rows)
                self._known[key] = np.asarray(one, float), np.asarray(more, float)
                self._written(key)
            if len(self._known) > 64:  # solvers look back at a few points only
                del self._known[next(iter(self._known))]
        return self._known[key]

    def _written(self, key: str) -> None:
        if self.file is None:
            return
        line = json.dumps([key, *map(_packed, self._known[key])])
        with self.file.open("a", encoding="ascii") as file:
            file.write(line + "\n")
            file.flush()
            os.fsync(file.fileno())

    def _noted(self, p: NDArray[np.float64], objective: float, excess: NDArray[np.float64], *, whole: bool) -> None:
        worst = float(excess.max(initial=-np.inf))
        feasible = whole and worst <= FEASIBLE
        if not self.history or self.history[-1].analyses != self.analyses:
            self.history.append(Step(analyses=self.analyses, objective=objective, worst=worst, feasible=feasible))
            if self.told is not None:
                self.told(self.analyses, objective, worst)
        if feasible and (self.best is None or objective < self.best[1]):
            self.best = p.copy(), objective
        if whole and (self.nearest is None or worst < self.nearest[1]):
            self.nearest = p.copy(), worst


def _packed(array: NDArray[np.float64]) -> list[Any]:
    return [list(array.shape), base64.b85encode(zlib.compress(np.ascontiguousarray(array).tobytes(), 1)).decode("ascii")]


def _unpacked(given: list[Any]) -> NDArray[np.float64]:
    shape, text = given
    return np.frombuffer(zlib.decompress(base64.b85decode(text))).reshape(shape).copy()


def _stored(file: Path) -> dict[str, tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """What a file knows; a last line that is not whole, of a killed process, is cut off."""
    if not file.exists():
        return {}
    found, good = {}, 0
    with file.open("rb") as lines:
        for line in lines:
            try:
                key, one, more = json.loads(line)
                if not line.endswith(b"\n"):
                    break
                found[key] = _unpacked(one), _unpacked(more)
            except (ValueError, zlib.error):
                break
            good += len(line)
    with file.open("rb+") as cut:
        cut.truncate(good)
    return found


def history_of(file: Path) -> list[list[float | None]]:
    """Number, objective and largest excess (None without limits) of all values that a file knows, as they were computed."""
    found: list[list[float | None]] = []
    if not file.exists():
        return found
    with file.open("rb") as lines:
        for line in lines:
            try:
                key, one, more = json.loads(line)
                if key.startswith("v"):
                    excess = _unpacked(more)
                    found.append([len(found) + 1, float(_unpacked(one)), float(excess.max()) if excess.size else None])
            except (ValueError, zlib.error):
                break
    return found
