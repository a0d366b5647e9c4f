"""Axial, bending and shear stresses as components."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.model import Model
from kinetruss.results import Sections, variable
from kinetruss.strength.members.parts import Parts, parts_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["components", "matching_parts"]

_WORDS = {
    "axial": "mean axial stress T/A",
    "bending_2": "extreme fibre stress of M2",
    "bending_3": "extreme fibre stress of M3",
    "shear_2": "largest shear stress of V2",
    "shear_3": "largest shear stress of V3",
}


def components(model: Model, sections: Sections) -> xr.Dataset:
    """The five stress components at every station, in Pa and in microstrain.

    Returns
    -------
    Dataset over (time, part, station): ``axial`` = T/A, ``bending_2`` = M2 c3/I2, ``bending_3`` = M3 c2/I3, ``shear_2`` =
    k V2/A, ``shear_3`` = k V3/A, Pa, with the sign of the force or moment; the same with ``_microstrain``: stress/E, and
    stress/G for shear. In the plane ``axial``, ``bending_3``, ``shear_2``. NaN for parts without section (or material).

    Notes
    -----
    c2, c3 are the extreme fibres along axes 2, 3 and k the section's shear factor (largest over mean shear stress: 2 for
    a thin tube, 4/3 for a rod, 3/2 for a rectangle).

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.strength.components(model, kt.strength.sections(model, forces, stations=2))
    >>> found.axial.sel(part="strut").values.round(-3).tolist()  # Pa: -1000 N/314 mm^2
    [[-3183000.0, -3183000.0]]
    """
    parts = matching_parts(model, sections)
    stress = {"axial": sections.data["section_T"].values * _along(1 / parts.area)}
    for axis, modulus in (("2", parts.I2 / parts.c3), ("3", parts.I3 / parts.c2)):
        if axis in sections.data["moment"].values:
            stress[f"bending_{axis}"] = sections.data["section_M"].sel(moment=axis).values * _along(1 / modulus)
    for axis in sections.data["transverse"].values:
        stress[f"shear_{axis}"] = sections.data["section_V"].sel(transverse=axis).values * _along(parts.factor / parts.area)
    over = ("time", "part", "station")
    data = {name: variable(over, values, "Pa", _WORDS[name]) for name, values in stress.items()}
    for name, values in stress.items():
        stiffness = parts.G if name.startswith("shear") else parts.E
        strain = 1e6 * values / _along(stiffness)
        data[f"{name}_microstrain"] = variable(over, strain, "1e-6", f"strain of the {_WORDS[name]}")
    return xr.Dataset(data, coords=sections.data["section_T"].coords, attrs=sections.data.attrs | {"kind": "components"})


def matching_parts(model: Model, sections: Sections) -> Parts:
    """The parts of a model, after a check that the sections are of the same ones."""
    parts = parts_of(model)
    if list(sections.data["part"].values) != list(parts.names):
        raise InputError("The sections belong to a model with other members. Compute them for this model.")
    return parts


def _along(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (parts,) against (time, part, station)."""
    return values[None, :, None]
