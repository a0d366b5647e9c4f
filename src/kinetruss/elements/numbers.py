"""The numbers of a model as arrays by name, real or complex, also several copies of them side by side.

Arrays of numbers have the copies first: places are (n, dim), or (copies, n, dim). One complex step with every number in a copy
of its own gives the derivatives of all that follows from them (Squire & Trapp, 1998), so formulas on numbers are arithmetic
that takes complex ones. What is chosen by a number, a law or whether a mass is there, is chosen by its real part.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import dist, prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.errors import AnalysisError

Array = NDArray[Any]


class Numbers(dict[str, Array]):
    """Arrays by name; `lead` (copies,) or () are the leading axes of all, `dtype` is float or complex."""

    def __init__(self, arrays: Mapping[str, Array], lead: tuple[int, ...] = (), dtype: Any = float) -> None:
        super().__init__(arrays)
        self.lead, self.dtype = lead, dtype
        self.plain = not lead and dtype is float
        """True of real numbers without copies."""

    def full(self, *shape: int, value: float = 0.0) -> Array:
        """An array for what follows from them, (copies, *shape)."""
        return np.full(self.lead + shape, value, self.dtype) if value else np.zeros(self.lead + shape, self.dtype)

    def each(self, name: str) -> Any:
        """The entries of a list of numbers one by one: Python's numbers if they are plain, else over the copies."""
        return entries(self[name])


def entries(values: Array) -> Any:
    """The entries of a list of numbers (k,) one by one: Python's numbers if they are plain, else (copies,)."""
    return values.tolist() if values.ndim == 1 and values.dtype == float else np.moveaxis(values, -1, 0)


def size(d: Array) -> Array:
    """Length of vectors (..., 3)."""
    return np.asarray(np.linalg.norm(d) if d.ndim == 1 and d.dtype == float else np.sqrt(np.add.reduce(d * d, axis=-1)))


def apart(a: Any, b: Any) -> Any:
    """Distance of two points (dim,), or (copies, dim)."""
    return dist(a, b) if a.ndim == 1 and a.dtype == float else size(a - b)


def one_copy(places: Array) -> Array:
    """The real parts of the first copy of places (..., n, 3), by which is chosen what is chosen by numbers."""
    return np.asarray(places[(0,) * (places.ndim - 2)].real)


def chosen(which: Array, what: str) -> Array:
    """A choice (k,) from (k,) or (copies, k), in which all copies have to agree.

    Raises
    ------
    AnalysisError : they do not, as where a derivative is asked for by a number that is 0 and so is left out.
    """
    if which.ndim == 1:
        return which
    one = which.reshape(prod(which.shape[:-1]), which.shape[-1])
    if (one != one[:1]).any():
        raise AnalysisError(
            f"The copies of the numbers of a model differ in {what}. Give a model whose numbers are not 0 there."
        )
    return np.asarray(one[0])


def sums_at(places: Array, values: Array, count: int) -> Array:
    """Sums (..., count) of values (..., k) by their places (k,), one after the other."""
    lead, copies = values.shape[:-1], prod(values.shape[:-1])
    at = (places + count * np.arange(copies)[:, None]).reshape(-1) if lead else places
    flat = values.reshape(-1)
    found = np.bincount(at, flat.real, count * copies)
    if np.iscomplexobj(flat):
        found = found + 1j * np.bincount(at, flat.imag, count * copies)
    return np.asarray(found.reshape(*lead, count))
