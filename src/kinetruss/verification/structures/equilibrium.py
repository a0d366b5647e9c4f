"""Equilibrium with large displacements: a rhombus on its spring, the von Mises truss up to its limit and beyond."""

from __future__ import annotations

import math
from typing import Literal

import kinetruss as kt

Strain = Literal["engineering", "green"]

HALF, RISE, LENGTH = 1.0, 0.3, math.hypot(1.0, 0.3)
STEEP = 3.0
"""m, rise of a truss that leans over before it snaps through."""


def rhombus() -> dict[str, float]:
    """Angle of the side rods, and how far top and sides differ from a rhombus."""
    at = kt.statics.equilibrium(kt.library.mechanisms.rhombus_with_spring()).position
    x, y = at.sel(node="B0").values
    return {"angle": math.atan2(y, x), "top": float(abs(at.sel(node="B1").values - [1 + x, y]).max())}


def leaning(strain: Strain, load: float) -> kt.Model:
    """Model of the von Mises truss under a load, N."""
    return kt.library.mechanisms.von_mises(rise=RISE, load=load, strain=strain)


def load_at(strain: Strain, y: float) -> float:
    """The load (N) under which the apex rests at the height y (m)."""
    if strain == "green":
        return (RISE**2 - y**2) * y / LENGTH**2
    length = math.hypot(HALF, y)
    return 2 * (LENGTH - length) * y / length


def path(strain: Strain, share: float) -> dict[str, float]:
    """Height and vertical stiffness under the load that belongs to a height above the limit."""
    # heights of the limit: l^3 = l0 a^2, and dP/dy = 0 with Green's strain
    lowest = RISE / math.sqrt(3) if strain == "green" else math.sqrt(LENGTH ** (2 / 3) - 1)
    y = lowest + share * (RISE - lowest)
    found = kt.statics.equilibrium(leaning(strain, load_at(strain, y)))
    shape = abs(found.mode_shape.sel(node="T", axis="y").values)
    return {
        "height": found.position.sel(node="T", axis="y").item(),
        "stiffness": float(found.stiffness.values[int(shape.argmax())]),
    }


def followed(strain: Strain, rise: float = RISE) -> dict[str, float]:
    """Load, N, and height, m, of the first limit point or bifurcation of the path from rest."""
    found = kt.statics.path(kt.library.mechanisms.von_mises(rise=rise, load=1.0, strain=strain), "load", points=40)
    height = found.event_position.sel(node="T", axis="y").values
    kinds = [str(kind) for kind in found.event_kind.values]
    first = {kind: kinds.index(kind) for kind in set(kinds)}
    return {f"{kind}_load": float(found.event_factor.values[k]) for kind, k in first.items()} | {
        f"{kind}_height": float(height[k]) for kind, k in first.items()
    }


def snapped() -> dict[str, float]:
    """Height under a load beyond the limit: hanging."""
    found = kt.statics.equilibrium(leaning("engineering", load_at("engineering", -0.35)))
    return {"height": found.position.sel(node="T", axis="y").item()}
