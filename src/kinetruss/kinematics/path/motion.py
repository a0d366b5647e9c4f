"""Creates the Motion record from arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.lengths import lengths
from kinetruss.mechanics import System, kept
from kinetruss.results import Arrays, Axes, Motion, Status, provenance, variable
from kinetruss.results.records import drive_unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.path.passed import Passed

__all__ = ["Course", "motion_of", "rods_that_stick_out"]

AXES = ("x", "y", "z")


@kept()
def _axes(system: System) -> Axes:
    """Names of nodes, axes, members and drives."""
    return Axes(
        {
            "node": np.array(system.nodes, dtype=object).astype(str),
            "axis": list(AXES[: system.dim]),
            "member": np.array(system.members, dtype=object).astype(str),
            "drive": np.array(system.drives, dtype=object).astype(str),
            **drive_unit(system)[1],
        }
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """Histories of a motion: t (times,) s; x, v, a (times, 3 n); drive : values, rates and second rates (times or more,
    drives); gauge (times,) : singularity measure, None if not computed; passed : the states between samples; attrs : more
    attributes.
    """

    t: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    drive: tuple[NDArray[np.float64], ...]
    gauge: NDArray[np.float64] | None = None
    passed: Passed | None = None
    attrs: Mapping[str, Any] = field(default_factory=dict)

    def until(self, k: int) -> Course:
        """The first k samples."""
        gauge = None if self.gauge is None else self.gauge[:k]
        return replace(self, t=self.t[:k], x=self.x[:k], v=self.v[:k], a=self.a[:k], gauge=gauge)


def motion_of(system: System, found: Course, space: str, status: Status, message: str) -> Motion:
    """Motion from histories of nodes and drives."""
    t, x, v, a, drive = found.t, found.x, found.v, found.a, found.drive
    count = len(t)
    gauge = np.full(count, np.nan) if found.gauge is None else found.gauge
    L, Ld, Ldd = allocate(*[(count, len(system.members))] * 3)
    lengths(system.p, system.q, x, v, a, L, Ld, Ldd)
    nodal, member, driven = ("time", "node", "axis"), ("time", "member"), ("time", "drive")

    def shaped(y: NDArray[np.float64]) -> NDArray[np.float64]:
        return y.reshape(count, len(system.nodes), 3)[:, :, : system.dim]

    unit = drive_unit(system)[0]
    data = {
        "position": variable(nodal, shaped(x), "m", "node position"),
        "velocity": variable(nodal, shaped(v), "m/s", "node velocity"),
        "acceleration": variable(nodal, shaped(a), "m/s^2", "node acceleration"),
        "length": variable(member, L, "m", "member length"),
        "length_rate": variable(member, Ld, "m/s", "rate of member length"),
        "length_acceleration": variable(member, Ldd, "m/s^2", "second rate of member length"),
        "drive_position": variable(driven, drive[0][:count], unit, "drive coordinate"),
        "drive_velocity": variable(driven, drive[1][:count], f"{unit}/s", "drive rate"),
        "drive_acceleration": variable(driven, drive[2][:count], f"{unit}/s^2", "drive acceleration"),
        "singularity": variable(("time",), gauge, "", "distance from a singular position"),
    }
    if found.passed is not None:
        data |= found.passed.variables(system)
    kept = Arrays(_axes(system), t, data, {"kind": "motion", "trajectory_space": space, **found.attrs})
    message = f"{message} {rods_that_stick_out(system, t, L)}".strip()
    return Motion(data=kept.later, status=status, message=message, provenance=provenance(system.model, space=space))


def rods_that_stick_out(system: System, t: NDArray[np.float64], length: NDArray[np.float64]) -> str:
    """Which active members become shorter than one of their rods, and when; empty if none does."""
    two = np.flatnonzero(system.two_rods)
    if not len(t) or not len(two):
        return ""
    rod = system.own_rods[two][:, [1, 4]]
    short = length[:, two].argmin(axis=0)
    least = length[short, two]
    off = rod.max(axis=1) - least
    bad = np.flatnonzero(off > 1e-9 * least)
    if not len(bad):
        return ""
    k = int(bad[off[bad].argmax()])
    which = ("base", "tube")[int(rod[k].argmax())]
    more = f" So do {len(bad) - 1} more." if len(bad) > 1 else ""
    return (
        f"{system.members[two[k]]} shortens to {least[k]:.6g} m (t = {t[short[k]]:g} s), less than its {which} rod of "
        f"{rod[k].max():.6g} m, which is impossible: forces include the whole rod.{more} Shorten the rod, or the stroke."
    )
