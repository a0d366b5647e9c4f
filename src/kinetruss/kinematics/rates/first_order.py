"""The first-order prediction of a motion from its start, and its error."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import xarray as xr

from kinetruss.kinematics.rates.jacobian import sensitivities, state_of
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.freedom import coordinate_values, coordinates
from kinetruss.model import Model
from kinetruss.results import Motion, variable

__all__ = ["first_order"]


def first_order(model: Model, motion: Motion, wrt: str | Iterable[str] | None = None) -> xr.Dataset:
    """Node positions predicted from the first sample by the Jacobian there, the exact ones, and the error.

    Parameters
    ----------
    wrt : the coordinates whose finite changes are used, as in `jacobian`; by default all drives. Another choice gives another
        prediction (linear in the pose instead of in the lengths, for instance).

    Returns
    -------
    Dataset over (time, node, axis), m: ``predicted`` = x(0) + J(0) (q(t) - q(0)), ``exact``, ``error`` = predicted - exact;
    ``error_size`` (time, node) and ``largest_error`` (time): distances, m.

    Raises
    ------
    InputError : as in `jacobian`; a motion without samples.

    Notes
    -----
    The error is proportional to the square of the step. Moving supports are included.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")}
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"turn": 1.0}, duration=0.1), samples=2)
    >>> kt.kinematics.first_order(crank, motion).largest_error.values.round(4).tolist()  # m: about 2 (0.1 rad)^2/2
    [0.0, 0.01]
    """
    system = compile(model)
    x, time = state_of(system, motion)
    names = list(system.drives) if wrt is None else [wrt] if isinstance(wrt, str) else list(wrt)
    moved = coordinates(system, [*names, *_supports(system, names)])
    q = coordinate_values(system, moved, x)
    S = sensitivities(system, x[:1], moved)[0]
    predicted = (x[0] + (q - q[0]) @ S.T).reshape(len(x), -1, 3)[:, :, : system.dim]
    exact = motion.arrays["position"].values
    nodal = ("time", "node", "axis")
    size = np.linalg.norm(predicted - exact, axis=2)
    data = {
        "predicted": variable(nodal, predicted, "m", "position, first order from the first sample"),
        "exact": variable(nodal, exact, "m", "position"),
        "error": variable(nodal, predicted - exact, "m", "predicted minus exact position"),
        "error_size": variable(("time", "node"), size, "m", "distance of predicted and exact position"),
        "largest_error": variable(("time",), size.max(axis=1), "m", "largest distance of any node"),
    }
    coords = {"time": time, "node": motion.data["node"], "axis": motion.data["axis"]}
    return xr.Dataset(data, coords=coords, attrs={"kind": "first_order", "wrt": [one.name for one in moved]})


def _supports(system: System, names: list[str]) -> list[str]:
    """Coordinates of moving supports that are not named already."""
    moving = (f"{node}.{axis}" for node in system.model.support_motion for axis in system.model.fixed[node])
    return [name for name in moving if name not in names]
