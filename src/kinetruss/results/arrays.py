"""Arrays of a result with named axes, and the xarray dataset that is made from them when it is first needed.

Making a dataset takes longer than computing two hundred samples of a four-bar.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from kinetruss.model import ReadOnly

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray


class Column(NamedTuple):
    """An array with the names of its axes and its attributes, in the argument order of xarray."""

    dims: tuple[str, ...]
    values: NDArray[Any]
    attrs: Mapping[str, Any]


Columns = Mapping[str, Column]
"""Arrays by name."""


def variable(dims: tuple[str, ...], values: NDArray[Any], units: str, name: str) -> Column:
    """An array with its axes, its unit and a long name.

    >>> import kinetruss as kt
    >>> import numpy as np
    >>> column = kt.results.variable(("time",), np.array([0.0, 5.0]), "N", "axial force")
    >>> column.dims, column.attrs
    (('time',), {'units': 'N', 'long_name': 'axial force'})
    """
    return Column(dims, values, {"units": units, "long_name": name})


class Axes:
    """Names along the axes of a result. They do not change from call to call, so they are indexed once, for the first dataset.

    names : axis -> names, a `Column`, or a pair (axis, names).
    """

    def __init__(self, names: Mapping[str, Any]) -> None:
        self.names = dict(names)

    @cached_property
    def columns(self) -> dict[str, Column]:
        """The names as arrays."""
        return {name: _column(name, given) for name, given in self.names.items()}

    @cached_property
    def indexed(self) -> xr.Coordinates:
        """The names as coordinates of xarray."""
        import xarray as xr

        return xr.Coordinates(dict(self.names))


def _column(name: str, given: Any) -> Column:
    if isinstance(given, Column):
        return given
    dim, values = given if isinstance(given, tuple) else (name, given)
    return Column((dim,), np.asarray(values), {})


class Arrays:
    """The arrays of a result, over fixed axes and, unless it is None, over a time axis (times,), s.

    After the dataset is made, all values are read from it, since the user may have changed it.
    """

    def __init__(self, axes: Axes, time: NDArray[Any] | None, data: Columns, attrs: Mapping[str, Any]) -> None:
        self._axes, self._time, self._data, self._attrs = axes, time, dict(data), dict(attrs)
        self._dataset: xr.Dataset | None = None

    @property
    def dataset(self) -> xr.Dataset:
        """The dataset, made at the first call."""
        if self._dataset is None:
            self._dataset = self._made()
        return self._dataset

    @property
    def later(self) -> xr.Dataset:
        """The arrays for the field `data` of a result, which makes the dataset when it is first read."""
        return cast("xr.Dataset", self)

    @property
    def columns(self) -> Columns:
        """All arrays and names by their name."""
        return self._columns if self._dataset is None else columns_of(self._dataset)

    @cached_property
    def _columns(self) -> Columns:
        time = {} if self._time is None else {"time": variable(("time",), self._time, "s", "time")}
        return ReadOnly({**self._axes.columns, **time, **self._data})

    @property
    def attrs(self) -> dict[str, Any]:
        """Attributes of the dataset."""
        return self._attrs if self._dataset is None else self._dataset.attrs

    def _made(self) -> xr.Dataset:
        import xarray as xr

        fixed = self._axes.indexed
        if self._time is None:
            return xr.Dataset(self._data, coords=fixed, attrs=self._attrs)
        index = xr.indexes.PandasIndex(self._time, "time")
        axis = index.create_variables({"time": xr.Variable(*variable(("time",), self._time, "s", "time"))})
        coords = xr.Coordinates({**fixed.variables, **axis}, indexes={**fixed.xindexes, "time": index})
        return xr.Dataset(self._data, coords=coords, attrs=self._attrs)


def columns_of(data: xr.Dataset) -> Columns:
    """The arrays of a dataset; its variables have the fields of a `Column`."""
    return cast("Columns", data.variables)
