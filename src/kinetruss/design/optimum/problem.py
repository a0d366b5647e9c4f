"""What is asked of an optimum: variables with their scales, a function to be made small, limits on others."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, Protocol

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

Scale = Literal["range", "log", "inverse"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Variable:
    """A number to be chosen between two bounds, in SI.

    scale : in which the solver sees it: ``range`` linear; ``log`` its logarithm; ``inverse`` its reciprocal, in which stresses
    and displacements of a truss are nearly linear in the areas (Schmit and Farshi 1974). unit : for messages.
    """

    name: str
    lower: float
    upper: float
    start: float
    scale: Scale = "range"
    unit: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit:
    """One row of the limits: value <= limit (or >=), which the function gives as excess = (value - limit) sign/size <= 0.

    subject : of what, e.g. ``stress of M7 in case 3 at 1.2 s``. family : rows of one family are the instants of
    one limit on one part, of which few matter. size : by which it is divided, > 0. sign : 1 at most, -1 at least.
    """

    subject: str
    family: str
    limit: float
    size: float
    sign: int = 1
    unit: str = ""


class Function(Protocol):
    """What is computed at a point p (n,), in SI."""

    def values(self, p: NDArray[np.float64], rows: NDArray[np.int64] | None) -> tuple[float, NDArray[np.float64]]:
        """The objective, and the excess of some limits (rows,), or of all."""
        ...

    def gradients(self, p: NDArray[np.float64], rows: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Derivatives by p of the objective (n,), and of the excess of some limits (rows, n)."""
        ...


@dataclass(frozen=True, kw_only=True)
class Problem:
    """Variables (n), limits (m), and the function of both. families : see `family`. objective, unit : what is least."""

    variables: Sequence[Variable]
    limits: Sequence[Limit]
    function: Function = field(repr=False)
    families: NDArray[np.int64] | None = field(default=None, repr=False)
    objective: str = "objective"
    unit: str = ""

    def __len__(self) -> int:
        return len(self.variables)

    @cached_property
    def lower(self) -> NDArray[np.float64]:
        """(n,)."""
        return np.array([one.lower for one in self.variables], float)

    @cached_property
    def upper(self) -> NDArray[np.float64]:
        """(n,)."""
        return np.array([one.upper for one in self.variables], float)

    @cached_property
    def start(self) -> NDArray[np.float64]:
        """(n,)."""
        return np.array([one.start for one in self.variables], float)

    @cached_property
    def family(self) -> NDArray[np.int64]:
        """(m,): number of the family of each limit."""
        if self.families is not None:
            return self.families
        known: dict[str, int] = {}
        return np.array([known.setdefault(one.family, len(known)) for one in self.limits], np.int64)

    def scaled(self, p: NDArray[np.float64]) -> NDArray[np.float64]:
        """z (n,), 0 to 1 between the bounds, of p."""
        low, high = self._seen(self.lower), self._seen(self.upper)
        return (self._seen(p) - low) / (high - low)

    def real(self, z: NDArray[np.float64]) -> NDArray[np.float64]:
        """p (n,) of z, kept within the bounds."""
        low, high = self._seen(self.lower), self._seen(self.upper)
        seen = low + np.clip(z, 0.0, 1.0) * (high - low)
        found = np.array([_BACK[v.scale](one) for v, one in zip(self.variables, seen, strict=True)])
        return np.asarray(np.clip(found, self.lower, self.upper))

    def slope(self, p: NDArray[np.float64]) -> NDArray[np.float64]:
        """dp/dz (n,)."""
        span = self._seen(self.upper) - self._seen(self.lower)
        return np.asarray(span * np.array([_SLOPE[v.scale](one) for v, one in zip(self.variables, p, strict=True)]))

    def _seen(self, p: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.array([_SEEN[v.scale](one) for v, one in zip(self.variables, p, strict=True)])


_SEEN: dict[str, Any] = {"range": lambda p: p, "log": np.log, "inverse": lambda p: -1.0 / p}
_BACK: dict[str, Any] = {"range": lambda s: s, "log": np.exp, "inverse": lambda s: -1.0 / s}
_SLOPE: dict[str, Any] = {"range": lambda _: 1.0, "log": lambda p: p, "inverse": lambda p: p * p}
"""dp/ds of the number s that the solver sees."""
