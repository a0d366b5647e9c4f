"""Datasets of results: fixed coordinates made once, a time axis, variables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import xarray as xr
from numpy.typing import NDArray

from kinetruss.results.records.variable import variable

__all__ = ["dataset", "fixed_coordinates"]


def fixed_coordinates(coordinates: Mapping[str, Any]) -> xr.Coordinates:
    """Coordinates with their indexes, to be kept between calls: making them takes as long as analysing a short motion."""
    return xr.Coordinates(dict(coordinates))


def dataset(fixed: xr.Coordinates, time: NDArray[Any], data: Mapping[str, xr.Variable], attrs: Mapping[str, Any]) -> xr.Dataset:
    """A dataset of `data` over a time axis (times,) s and fixed coordinates."""
    index = xr.indexes.PandasIndex(time, "time")
    axis = index.create_variables({"time": variable(("time",), time, "s", "time")})
    coords = xr.Coordinates({**fixed.variables, **axis}, indexes={**fixed.xindexes, "time": index})
    return xr.Dataset(data, coords=coords, attrs=attrs)
