"""Equivalent stresses of a section: the two classical points and the true maximum."""

from __future__ import annotations

from typing import Literal

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kernels.sections.stress import section_von_mises
from kinetruss.model import Model
from kinetruss.results import Sections, variable
from kinetruss.strength.members.components import components, matching_parts
from kinetruss.strength.members.torsion import shear_of_torsion, with_torsion

__all__ = ["stresses"]


def stresses(
    model: Model,
    sections: Sections,
    *,
    bending: Literal["resultant", "2", "3"] = "resultant",
    shear_factor: float | None = None,
) -> xr.Dataset:
    """Equivalent stresses at every station, Pa, over (time, part, station).

    Parameters
    ----------
    bending : ``"resultant"``; or ``"2"`` or ``"3"`` to use only one bending moment in S2 (Lacy, 1991, planar points).
    shear_factor : for S1, instead of the section's own (Lacy: 2 everywhere).

    Returns
    -------
    ``S1``: von Mises stress on the neutral axis, sqrt((T/A)^2 + 3 (k V/A)^2) with the resultant V.
    ``S2``: outer fibre, |T|/A + |M| c/I with the resultant M of a round section, else the corner
    |T|/A + |M2| c3/I2 + |M3| c2/I3.
    ``von_mises``: the largest over the section, never below S1 and S2. NaN for parts without section. Torsion adds its
    largest shear stress tau to all three, to ``von_mises`` as a bound: sqrt(s^2 + 3 (2 k V/A tau + tau^2)), s without torsion,
    which is exact where V = 0; NaN for a section that does not know its shear stress of torsion.

    Notes
    -----
    The maximum over the section: round sections over the outer circle with the shear stress k V/A sin of the angle from V
    (exact for a thin tube, beam theory for a solid rod, between them on the safe side); rectangles over the whole section
    with parabolic shear; general sections by a bound (all bending and all shear at one point).
    Source: Lacy (1991, eq. 2.20 to 2.24); Timoshenko & Gere, Mechanics of Materials. S2 with one moment of two is up to 8 %
    too small in a double-octahedral bay; the resultant gives the stress of the fibre.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.strength.stresses(model, kt.strength.sections(model, forces, stations=2))
    >>> found.von_mises.sel(part="strut").values.round(-3).tolist()  # Pa: 1000 N/314 mm^2, nothing bends it
    [[3183000.0, 3183000.0]]
    """
    parts = matching_parts(model, sections)
    if bending not in ("resultant", "2", "3"):
        raise InputError(f"bending {bending!r} is not known. Write 'resultant', '2' or '3'.")
    nominal = components(model, sections)
    axial = np.abs(nominal["axial"].values)
    none = np.zeros_like(axial)
    b2, b3 = (np.abs(nominal[name].values) if name in nominal else none for name in ("bending_2", "bending_3"))
    k2, k3 = (nominal[name].values if name in nominal else none for name in ("shear_2", "shear_3"))
    shear = np.hypot(k2, k3)
    if shear_factor is not None:
        shear = shear * (shear_factor / parts.factor)[None, :, None]
    is_round = (parts.shape == 0)[None, :, None]
    fibre = {"resultant": np.where(is_round, np.hypot(b2, b3), b2 + b3), "2": b2, "3": b3}[bending]
    worst = np.empty_like(axial)
    T, V, M = (np.ascontiguousarray(sections.data[f"section_{name}"].values) for name in "TVM")
    section_von_mises(parts.shape, parts.scale, T, V, M, worst)
    twist = (
        shear_of_torsion(model, sections.data["torsion"].values[:, :, 0])[:, :, None] if "torsion" in sections.data else none
    )
    worst = with_torsion(worst, np.abs(shear), twist)
    over = ("time", "part", "station")
    data = {
        "S1": variable(over, np.sqrt(axial**2 + 3 * (shear + twist) ** 2), "Pa", "von Mises stress on the neutral axis"),
        "S2": variable(over, np.sqrt((axial + fibre) ** 2 + 3 * twist**2), "Pa", "stress in the outer fibre"),
        "von_mises": variable(over, worst, "Pa", "largest von Mises stress over the section"),
    }
    return xr.Dataset(data, coords=nominal.coords, attrs=sections.data.attrs | {"kind": "stresses"})
