"""Histories as one table: one row per instant, one column per value."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["flat", "labels", "units_of", "wide"]


def wide(data: xr.Dataset) -> Any:
    """A pandas table of a dataset along time, with a column for every value of an instant; without time one row per name.

    An empty dimension (no supports, no active members) has no columns and does not affect the others.
    """
    import importlib

    import numpy as np

    pd = importlib.import_module("pandas")  # pandas comes with xarray; its types are in a separate package

    if "time" not in data.dims:
        return data.drop_vars([name for name, one in data.data_vars.items() if not one.size]).to_dataframe()
    kept = {str(key): one for key, one in data.data_vars.items() if one.dims[:1] == ("time",)}
    heads = [f"{key}[{','.join(names)}]" if names else key for key, one in kept.items() for names in labels(one)]
    if "pose" in data.coords:
        index = pd.Index(data["pose"].values.astype(str), name="pose")
    else:
        index = pd.Index(data["time"].values, name="time")
    columns = [flat(one) for one in kept.values()]
    values = np.hstack(columns) if columns else np.empty((len(index), 0))
    return pd.DataFrame(values, index=index, columns=heads)


def flat(data: xr.DataArray) -> Any:
    """A history as (times, values), in the order of `labels`."""
    return data.values.reshape(data.shape[0], math.prod(data.shape[1:]))


def labels(data: xr.DataArray) -> Iterator[tuple[str, ...]]:
    """Names of the values of one instant, in the order of the flat array."""
    return itertools.product(*([_label(value) for value in data[dim].values] for dim in data.dims[1:]))


def units_of(data: xr.DataArray) -> Iterator[str]:
    """Units of the values of one instant, in the order of `labels`; the name of a coordinate stands for its entries."""
    text = str(data.attrs.get("units", ""))
    named = [name for name in re.findall(r"\w+_unit\b", text) if name in data.coords and data[name].dims]
    for place in itertools.product(*(range(size) for size in data.shape[1:])):
        unit, at = text, dict(zip(data.dims[1:], place, strict=True))
        for name in named:
            unit = unit.replace(name, str(data[name].values[at[data[name].dims[0]]]))
        yield unit


def _label(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)
