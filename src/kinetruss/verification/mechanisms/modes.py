"""Numbers of assembly modes that are known, and the Jacobian of a Stewart-Gough platform."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from kinetruss import kinematics
from kinetruss.library import mechanisms
from kinetruss.model import Model
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

PLANAR = Reference(
    "count", "C. Gosselin, J. Sefrioui & M. J. Richard, Mechanism and Machine Theory 27 (1992) 107-119: six of 3-RPR"
)
TRIANGLE = Reference(
    "count", "C. Innocenti & V. Parenti-Castelli, J. Mechanical Design 112 (1990) 510-517: sixteen of a triangular platform"
)
GENERAL = Reference("count", "M. Raghavan, J. Mechanical Design 115 (1993) 277-282: forty of the general platform")
LOST = Reference("identity", "every path of the homotopy ends at a solution or at infinity")
LEGS = Reference(
    "closed-form", "E. F. Fichter, Int. J. Robotics Research 5 (1986) 157-182: rates of the legs, u . v + (b x u) . w"
)

PLATFORM = tuple(f"P{k}" for k in range(1, 7))


def count(kind: str) -> dict[str, float]:
    """Complex solutions of one block, paths whose end is not known, largest error of a length over all real modes."""
    found = kinematics.assembly_modes(_model(kind))
    return {
        "complex": float(found.attrs["complex_solutions"][0]),
        "lost": float(found.attrs["lost"]),
        "real": found.sizes["mode"],
    }


def _model(kind: str) -> Model:
    if kind != "3-RPR":
        return mechanisms.stewart(kind=kind, turned=(0.1, 0.2, 0.1))  # type: ignore[arg-type]
    nodes = {"A": (0.0, 0.0), "B": (4.0, 0.0), "C": (2.0, 4.0), "P": (1.2, 1.1), "Q": (2.6, 1.0), "R": (2.0, 2.2)}
    bars = {"1": ("P", "Q"), "2": ("Q", "R"), "3": ("R", "P"), "a": ("A", "P"), "b": ("B", "Q"), "c": ("C", "R")}
    return Model(nodes=nodes, fixed=["A", "B", "C"], bars=bars)


def legs() -> dict[str, float]:
    """Largest difference of the inverse Jacobian's entries from the closed form, and of J J^-1 from the unit matrix."""
    model = mechanisms.stewart(turned=(0.1, -0.2, 0.3), at=(0.05, -0.02, 0.62))
    found = kinematics.platform_jacobian(model, PLATFORM)
    middle = np.mean([model.nodes[name].at for name in PLATFORM], axis=0)
    rows = []
    for name in found["drive"].values:
        a, b = (np.array(model.nodes[end].at, float) for end in model.bars[str(name)].ends)
        u = (b - a) / np.linalg.norm(b - a)
        rows.append(np.r_[u, np.cross(b - middle, u)])
    return {"inverse": float(np.abs(found["inverse"].values - np.array(rows)).max())}


def cases() -> Iterator[Case]:
    """Counts, none lost; the platform's Jacobian."""
    for kind, source, number in (("3-RPR", PLANAR, 6.0), ("6-3", TRIANGLE, 16.0), ("6-6", GENERAL, 40.0)):
        yield Case(f"modes.{kind}.complex", source, number, 0.0, count, (kind,), ("complex",))
        yield Case(f"modes.{kind}.lost", LOST, 0.0, 0.0, count, (kind,), ("lost",), 1.0)
    yield Case("stewart.jacobian.legs", LEGS, 0.0, 1e-11, legs, (), ("inverse",), 1.0)
