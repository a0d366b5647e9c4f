"""Stiffness of a platform by its drives."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kinematics import platform_jacobian
from kinetruss.model import Model, nearest
from kinetruss.results import Motion, variable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["platform_stiffness"]


def platform_stiffness(
    model: Model,
    platform: str | Sequence[str],
    stiffness: float | Mapping[str, float],
    state: Motion | ArrayLike | None = None,
) -> xr.Dataset:
    """Compliance and stiffness of a platform with elastic drives and rigid bars.

    Parameters
    ----------
    platform, state : as in `kinematics.platform_jacobian`.
    stiffness : of each drive, N/m (N m/rad of an angle): one for all, or by name; drives not named are rigid.

    Returns
    -------
    Dataset. ``compliance`` (time, twist, wrench): C = J K_d^-1 J^T, displacement of the centroid of the nodes (m) and rotation
    (rad) per force through it (N) and couple (N m), global axes; ``stiffness`` (time, wrench, twist): its inverse, the
    pseudoinverse if the platform cannot move in some direction (a Delta's platform does not rotate: 0 there stands for rigid).

    Raises
    ------
    InputError : unknown drives, a stiffness that is not positive, a model with springs.

    Notes
    -----
    To first order about a state without load. Gosselin, Stiffness mapping for parallel manipulators, IEEE Trans. Robotics and
    Automation 6 (1990) 377-382.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1), "D": (1, 1)}, fixed={"A": "xy", "B": "xy", "C": "x", "D": "x"},
    ...     bars={one: kt.Bar(ends=ends, kind="driven") for one, ends in {"left": ("A", "C"), "right": ("B", "D")}.items()},
    ... )
    >>> found = kt.statics.platform_stiffness(model, ["C", "D"], 1000.0)  # N/m of each drive
    >>> found.compliance.sel(twist="v_y", wrench="F_y").round(9).item()  # m/N: two springs side by side
    0.0005
    """
    if model.springs:
        raise InputError(
            f"platform_stiffness counts drives alone, not the spring {next(iter(model.springs))!r}. Take statics.linear under "
            "unit loads, or leave the springs out: model.with_(springs={})."
        )
    found = platform_jacobian(model, platform, state)
    drives = [str(name) for name in found["drive"].values]
    given = dict.fromkeys(drives, float(stiffness)) if isinstance(stiffness, (int, float)) else dict(stiffness)
    if unknown := [name for name in given if name not in drives]:
        raise InputError(f"No drive called {unknown[0]!r}. {nearest(unknown[0], drives)}")
    if bad := [name for name, value in given.items() if not 0 < value < math.inf]:
        raise InputError(f"stiffness[{bad[0]!r}] is {given[bad[0]]:g}. Give a finite value above 0, N/m or N m/rad.")
    soft = np.array([1 / given[name] if name in given else 0.0 for name in drives])
    J = found["jacobian"].transpose(..., "twist", "drive").values
    C = (J * soft) @ np.swapaxes(J, -1, -2)
    time = ("time",) if "time" in found["jacobian"].dims else ()
    twist = list(found["twist"].values)
    wrench = [name.replace("v", "F").replace("w", "M") for name in twist]
    data = {
        "compliance": variable((*time, "twist", "wrench"), C, "twist_unit/wrench_unit", "compliance of the platform"),
        "stiffness": variable(
            (*time, "wrench", "twist"), _inverse(C, found.attrs["length"], model.dim), "wrench_unit/twist_unit", "stiffness"
        ),
    }
    units = {"twist_unit": ("twist", found["twist_unit"].values.tolist())}
    units["wrench_unit"] = ("wrench", ["N" if name.startswith("F") else "N m" for name in wrench])
    coords = {"twist": twist, "wrench": wrench, **units} | ({"time": found["time"]} if time else {})
    return xr.Dataset(data, coords=coords, attrs={"kind": "platform_stiffness"})


def _inverse(C: np.ndarray, length: float, dim: int) -> np.ndarray:
    """Inverse of a compliance, weighed by a length so that metres and radians compare."""
    scale = np.ones(C.shape[-1])
    scale[dim:] = length
    weight = scale[:, None] * scale
    return np.asarray(np.linalg.pinv(C * weight, rcond=1e-11, hermitian=True) * weight)
