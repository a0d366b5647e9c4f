"""Conditioning along a motion: singular values of the whole Jacobian at every sample."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kinematics.rates.jacobian import jacobian, state_of
from kinetruss.mechanics import compile
from kinetruss.mechanics import jacobian as rows_of
from kinetruss.model import Model
from kinetruss.results import Motion, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["conditioning"]


def conditioning(
    model: Model, motion: Motion, *, of: str | Iterable[str] | None = None, wrt: str | Iterable[str] | None = None
) -> xr.Dataset:
    """Singular values and condition number along a motion.

    Parameters
    ----------
    of, wrt : without them, the Jacobian of all prescribed lengths and angles by all free coordinates, with rows of unit length
        (as in `mobility`); with them, the Jacobian of these coordinates, which should be all lengths or all angles on either
        side, since singular values of mixed units have no meaning.

    Returns
    -------
    Dataset: ``singular_value`` (time, mode), largest first; ``smallest`` (time); ``condition`` (time), largest over smallest,
    infinite at a singular position.

    Raises
    ------
    InputError : as in `jacobian`; ``wrt`` without ``of``.

    Notes
    -----
    ``motion.singularity`` is the smallest value among the blocks, which is faster; here the dense Jacobian is used.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")}
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"turn": 1.0}, duration=1.0), samples=3)
    >>> kt.kinematics.conditioning(crank, motion).condition.values.round(6).tolist()  # the rows are at right angles
    [1.0, 1.0, 1.0]
    """
    system = compile(model)
    x, time = state_of(system, motion)
    if of is not None:
        J = jacobian(model, motion, of=of, wrt=wrt).values
    elif wrt is not None:
        raise InputError("wrt is given without of. Name what is to be differentiated, e.g. of='N8'.")
    else:
        drives = motion.arrays["drive_position"].values
        J = np.array([rows_of(system, one.reshape(-1, 3), values) for one, values in zip(x, drives, strict=True)])
    found = np.linalg.svd(J, compute_uv=False) if J.size else np.ones((len(x), 1))
    data = {
        "singular_value": variable(("time", "mode"), found, "", "singular values of the Jacobian"),
        "smallest": variable(("time",), found[:, -1], "", "smallest singular value of the Jacobian"),
        "condition": variable(("time",), _ratio(found), "", "condition number of the Jacobian"),
    }
    coords = {"time": time, "mode": np.arange(1, found.shape[1] + 1)}
    return xr.Dataset(data, coords=coords, attrs={"kind": "conditioning"})


def _ratio(found: NDArray[np.float64]) -> NDArray[np.float64]:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(found[:, -1] > 0, found[:, 0] / found[:, -1], np.inf)
