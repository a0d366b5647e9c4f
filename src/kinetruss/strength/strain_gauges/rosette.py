"""Rosettes: strain, principal strain and stress at a point from gauges in three or more directions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.arrays import array_of
from kinetruss.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.model import Material

__all__ = ["Rosette", "rosette"]

MAKERS_POISSON = 0.285
"""Poisson's ratio of the beams on which makers find gauge factors."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Rosette:
    """Strain at a point, all arrays of one shape (readings,).

    x, y, shear : strain along and across the axis from which angles count, and shear strain gamma_xy, 1e-6. principal :
    (..., 2), the larger first, 1e-6. angle : of the first principal direction, rad. stress : (..., 2) principal, Pa, and
    von_mises, Pa; None without a material (plane stress).
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    shear: NDArray[np.float64]
    principal: NDArray[np.float64]
    angle: NDArray[np.float64]
    stress: NDArray[np.float64] | None
    von_mises: NDArray[np.float64] | None


def rosette(strains: ArrayLike, angles: ArrayLike, *, material: Material | None = None, transverse: float = 0.0) -> Rosette:
    """Strain and stress at a point from the readings of a rosette.

    Parameters
    ----------
    strains : (..., gauges), 1e-6. angles : (gauges,), rad, of each gauge from the x axis: three or more different directions,
        0/45/90 and 0/60/120 degrees for instance. material : for stresses. transverse : transverse sensitivity of the gauges
        (their response to strain across over that along), as a fraction.

    Returns
    -------
    Rosette. More than three gauges: least squares.

    Raises
    ------
    InputError : another number of readings than angles; directions that do not determine the strain.

    Notes
    -----
    e(a) = x cos^2 a + y sin^2 a + shear sin a cos a; with a transverse sensitivity K a gauge reads (e(a) + K e(a + 90 deg))/
    (1 - 0.285 K). Source: Window, Strain Gauge Technology (1992), rosettes.

    >>> found = rosette([500.0, 350.0, -100.0], np.radians([0, 45, 90]))
    >>> found.principal.round(3).tolist(), round(float(found.shear), 3)
    ([535.41, -135.41], 300.0)
    """
    turns = array_of(angles, "angles", {"gauges": None}, unit="rad")
    readings = array_of(strains, "strains", {"...": None, "gauges": len(turns)}, unit="1e-6")
    c, s = np.cos(turns), np.sin(turns)
    along, across = np.stack([c * c, s * s, s * c], axis=1), np.stack([s * s, c * c, -s * c], axis=1)
    design = (along + transverse * across) / (1 - MAKERS_POISSON * transverse)
    if len(turns) < 3 or np.linalg.svd(design, compute_uv=False)[-1] < 1e-6:
        shown = ", ".join(f"{np.degrees(one):g}" for one in turns)
        raise InputError(f"Gauges at {shown} deg do not determine the strain. Give three different directions, e.g. 0, 45, 90.")
    found = readings @ np.linalg.pinv(design).T
    x, y, shear = (found[..., k] for k in range(3))
    middle, radius = (x + y) / 2, np.hypot(x - y, shear) / 2
    principal = np.stack([middle + radius, middle - radius], axis=-1)
    stress = von_mises = None
    if material is not None:
        nu = material.poisson
        stress = 1e-6 * material.E / (1 - nu**2) * (principal + nu * principal[..., ::-1])
        von_mises = np.sqrt(stress[..., 0] ** 2 - stress[..., 0] * stress[..., 1] + stress[..., 1] ** 2)
    angle = np.arctan2(shear, x - y) / 2
    return Rosette(x=x, y=y, shear=shear, principal=principal, angle=angle, stress=stress, von_mises=von_mises)
