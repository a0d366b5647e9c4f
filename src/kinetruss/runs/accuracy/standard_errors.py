"""Standard errors of forces and motor currents along a measured motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss import actuators, dynamics, kinematics
from kinetruss.model import Measured, Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["standard_errors"]

_FIELDS = ("values", "rates", "accelerations")
_DEMANDS = ("motor_torque", "current", "voltage")


def standard_errors(model: Model, record: Measured, *, load_case: str | None = None) -> xr.Dataset:
    """Positions, forces and motor demands along a measured motion, with their standard errors.

    Parameters
    ----------
    record : lengths, angles or pose coordinates; smoothed as by `kinematics.measured`. What the record gives (rates,
        accelerations) counts as exact. load_case : None takes all loads of the model.

    Returns
    -------
    Dataset. ``position`` (time, node, axis) m, ``member_force`` (time, member) N, ``drive_force`` (time, drive) N or N m and,
    with drive trains, ``motor_torque`` N m, ``current`` A, ``voltage`` V (time, active), each with ``NAME_error``. The
    attribute ``curvature`` is the part of the changes that is not linear in the errors, as a fraction of the largest error.

    Raises
    ------
    InputError, ModelError : faults of the record or of its coordinates. AnalysisError : the motion ends early.

    Notes
    -----
    Each of value, rate and acceleration of each coordinate is moved by plus and minus its own standard error, and half the
    difference of the two results is its share; the shares of one coordinate are added with the covariance of the smoother,
    those of different coordinates as independent: variance = sum_k d_k^T R_k d_k. Forces are linear in accelerations and
    quadratic in rates, so that these shares are exact; those of the values are exact to the third order.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")},
    ... )
    >>> times = [0.05 * k for k in range(21)]
    >>> record = kt.Measured(times=times, values={"turn": [t**2 + (-1) ** k * 1e-3 for k, t in enumerate(times)]})
    >>> found = kt.runs.standard_errors(crank, record)
    >>> bool((found.position_error.sel(node="B").max("axis") > 0).all())  # m
    True
    """
    smooth = kinematics.measured(record)
    base = _outputs(model, smooth.trajectory, load_case)
    plain = {name: np.zeros(one.shape) for name, one in base.items()}
    bent = dict.fromkeys(base, 0.0)
    covariance = smooth.data["covariance"].values
    for k, name in enumerate(record.values):
        deviation = np.sqrt(np.einsum("rii->ri", covariance[:, k]))
        moved = [order for order in range(3) if deviation[:, order].any()]
        shares: dict[int, dict[str, NDArray[np.float64]]] = {}
        for order in moved:
            up, down = (
                _outputs(model, _moved(smooth.trajectory, name, order, s * deviation[:, order]), load_case) for s in (1, -1)
            )
            shares[order] = {key: (up[key].values - down[key].values) / 2 for key in base}
            for key, one in base.items():
                off = np.abs(up[key].values + down[key].values - 2 * one.values).max(initial=0.0) / 2
                bent[key] = max(bent[key], float(off))
        for a in moved:
            for b in moved:
                both = deviation[:, a] * deviation[:, b]
                R = np.divide(covariance[:, k, a, b], both, out=np.zeros(len(both)), where=both > 0)
                for key, variance in plain.items():
                    variance += R.reshape(-1, *[1] * (variance.ndim - 1)) * shares[a][key] * shares[b][key]
    data: dict[str, xr.DataArray] = {}
    for key, one in base.items():
        attrs = {"units": one.attrs["units"], "long_name": f"standard error of {one.attrs['long_name']}"}
        data |= {key: one, f"{key}_error": one.copy(data=np.sqrt(np.maximum(plain[key], 0.0))).assign_attrs(attrs)}
    largest = {key: float(data[f"{key}_error"].max()) for key in base}
    round_off = {key: 1e-12 * float(np.abs(one).max()) for key, one in base.items()}
    curvature = max((bent[key] / size for key, size in largest.items() if size > round_off[key]), default=0.0)
    return xr.Dataset(data, attrs={"kind": "standard_errors", "curvature": curvature, "message": smooth.message})


def _moved(record: Measured, name: str, order: int, by: NDArray[np.float64]) -> Measured:
    """The smoothed record with one column of one coordinate moved."""
    field = _FIELDS[order]
    columns = getattr(record, field)
    return record.with_(**{field: {**columns, name: tuple(np.array(columns[name]) + by)}})


def _outputs(model: Model, record: Measured, load_case: str | None) -> dict[str, xr.DataArray]:
    """Positions, forces and demands at the rows of a record."""
    times = np.array(record.times) - record.times[0]
    motion = kinematics.follow(model, record, times=times)
    forces = dynamics.inverse(model, motion, load_case, static=False)
    found = {"position": motion.data["position"]}
    found |= {name: forces.data[name] for name in ("member_force", "drive_force")}
    if model.actuators:
        demand = actuators.evaluate(model, motion, forces).data
        found |= {name: demand[name].reset_coords(drop=True) for name in _DEMANDS if np.isfinite(demand[name].values).any()}
    return found
