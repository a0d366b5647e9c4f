"""Variables with units."""

from __future__ import annotations

from typing import Any

import xarray as xr
from numpy.typing import NDArray

__all__ = ["variable"]


def variable(dims: tuple[str, ...], values: NDArray[Any], units: str, name: str) -> xr.Variable:
    """An xarray variable with units and a long name."""
    return xr.Variable(dims, values, {"units": units, "long_name": name})
