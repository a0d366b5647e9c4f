"""Equilibrium with large displacements: a rhombus on its spring, the von Mises truss up to its limit and beyond."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal

import numpy as np

from kinetruss import statics
from kinetruss.library import mechanisms
from kinetruss.model import Model
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

RHOMBUS = Reference("closed-form", "2 m g s cos t + k (2 s sin(t/2) - l0) s cos(t/2) = 0, solved at 40 digits")
PATH = Reference("closed-form", "P = 2 k (l0 - l) y/l, stiffness 2 k (1 - l0 a^2/l^3) (von Mises 1923)")
GREEN = Reference("closed-form", "P = k (h^2 - y^2) y/l0^2, stiffness k (3 y^2 - h^2)/l0^2, Green's strain")
LIMIT = Reference("closed-form", "P = 2 k a ((l0/a)^(2/3) - 1)^(3/2); Green's strain 2 k h^3/(3 sqrt(3) l0^2)")
SWAY = Reference("closed-form", "no stiffness sideways where l^3 = l0 y^2, P = 2 k (l0 - l) y/l")

Strain = Literal["engineering", "green"]

ANGLE = 1.0662472589998337
"""rad, of the rhombus at rest."""
HALF, RISE, LENGTH = 1.0, 0.3, math.hypot(1.0, 0.3)
STEEP = 3.0
"""m, rise of a truss that leans over before it snaps through."""
SHARES = (0.9, 0.5, 0.1, 0.01)
"""Of the way from the limit back to the start."""


def rhombus() -> dict[str, float]:
    """Angle of the side rods, and how far top and sides differ from a rhombus."""
    at = statics.equilibrium(mechanisms.rhombus_with_spring()).position
    x, y = at.sel(node="B0").values
    return {"angle": math.atan2(y, x), "top": float(abs(at.sel(node="B1").values - [1 + x, y]).max())}


def leaning(strain: Strain, load: float) -> Model:
    """The von Mises truss under a load, N."""
    return mechanisms.von_mises(rise=RISE, load=load, strain=strain)


def load_at(strain: Strain, y: float) -> float:
    """The load (N) under which the apex rests at the height y (m)."""
    if strain == "green":
        return (RISE**2 - y**2) * y / LENGTH**2
    length = math.hypot(HALF, y)
    return 2 * (LENGTH - length) * y / length


def stiffness_at(strain: Strain, y: float) -> float:
    """Its vertical stiffness there, N/m."""
    if strain == "green":
        return (3 * y**2 - RISE**2) / LENGTH**2
    return 2 * (1 - LENGTH * HALF**2 / math.hypot(HALF, y) ** 3)


def limit(strain: Strain) -> tuple[float, float]:
    """Height (m) and load (N) at the limit."""
    if strain == "green":
        return RISE / math.sqrt(3), 2 * RISE**3 / (3 * math.sqrt(3) * LENGTH**2)
    return math.sqrt(LENGTH ** (2 / 3) - 1), 2 * (LENGTH ** (2 / 3) - 1) ** 1.5


def path(strain: Strain, share: float) -> dict[str, float]:
    """Height and vertical stiffness under the load that belongs to a height above the limit."""
    lowest = limit(strain)[0]
    y = lowest + share * (RISE - lowest)
    found = statics.equilibrium(leaning(strain, load_at(strain, y)))
    shape = abs(found.mode_shape.sel(node="T", axis="y").values)
    return {
        "height": found.position.sel(node="T", axis="y").item(),
        "stiffness": float(found.stiffness.values[int(shape.argmax())]),
    }


def followed(strain: Strain, rise: float = RISE) -> dict[str, float]:
    """Load, N, and height, m, of the first limit point or bifurcation of the path from rest."""
    found = statics.path(mechanisms.von_mises(rise=rise, load=1.0, strain=strain), "load", points=40)
    height = found.event_position.sel(node="T", axis="y").values
    kinds = [str(kind) for kind in found.event_kind.values]
    first = {kind: kinds.index(kind) for kind in set(kinds)}
    return {f"{kind}_load": float(found.event_factor.values[k]) for kind, k in first.items()} | {
        f"{kind}_height": float(height[k]) for kind, k in first.items()
    }


def swaying(rise: float = STEEP) -> tuple[float, float]:
    """Height (m) and load (N) at which a steep truss leans over: no stiffness sideways at l^3 = l0 y^2."""
    rest = math.hypot(HALF, rise)
    length = max(root.real for root in np.roots([1.0, -rest, 0.0, rest * HALF**2]) if abs(root.imag) < 1e-12)
    y = math.sqrt(length**2 - HALF**2)
    return y, 2 * (rest - length) * y / length


def snapped() -> dict[str, float]:
    """Height under a load beyond the limit: hanging."""
    found = statics.equilibrium(leaning("engineering", load_at("engineering", -0.35)))
    return {"height": found.position.sel(node="T", axis="y").item()}


def cases() -> Iterator[Case]:
    """Exact to round-off; towards the limit heights are worth less, as the stiffness goes to zero."""
    for name, value in (("angle", ANGLE), ("top", 0.0)):
        yield Case(f"equilibrium.rhombus.{name}", RHOMBUS, value, 1e-12, rhombus, (), (name,), 1.0)
    sources: dict[Strain, Reference] = {"engineering": PATH, "green": GREEN}
    for strain, source in sources.items():
        lowest, load = limit(strain)
        for share in SHARES:
            y = lowest + share * (RISE - lowest)
            where = f"equilibrium.von_mises.{strain}.{share:g}"
            yield Case(f"{where}.height", source, y, 1e-12 / share, path, (strain, share), ("height",))
            expected = stiffness_at(strain, y)
            yield Case(f"{where}.stiffness", source, expected, 1e-12 / share, path, (strain, share), ("stiffness",), 0.1)
        for name, value in (("height", lowest), ("load", load)):
            key = f"limit_{name}"
            yield Case(f"equilibrium.von_mises.{strain}.{key}", LIMIT, value, 1e-12, followed, (strain,), (key,))
    for name, value in zip(("height", "load"), swaying(), strict=True):
        key = f"bifurcation_{name}"
        yield Case(f"equilibrium.von_mises.steep.{key}", SWAY, value, 1e-12, followed, ("engineering", STEEP), (key,))
    yield Case("equilibrium.von_mises.snapped.height", PATH, -0.35, 1e-12, snapped, (), ("height",))
