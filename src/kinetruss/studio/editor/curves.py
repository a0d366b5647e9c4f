"""The path of a node and the force of a drive along the range of that drive."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.errors import InputError, KinetrussError
from kinetruss.mechanics import compile
from kinetruss.model import Active, LengthDrive, Model, Quintic, nearest, turns

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["curve"]

SAMPLES = 181
"""Number of samples of a curve to either side of the pose shown."""

LEAST = 1e-3
"""Singularity measure at which a curve ends."""


def curve(
    model: Model, position: NDArray[np.float64], node: str, drive: str, low: float | None = None, high: float | None = None
) -> dict[str, Any]:
    """The coupler curve of a node, and the force (N) or torque (N m) that holds the drive at rest at each of its points.

    Parameters
    ----------
    position : (n_nodes, dim), m, the closed pose to start from. low, high : range of the drive, m or rad; by default its
        limits, 0.6 to 1.5 times its length, or a whole turn.

    Raises
    ------
    InputError : unknown names, or a structure that its drives do not hold.
    """
    if node not in model.nodes:
        raise InputError(f"No node called {node!r}. {nearest(node, model.nodes)}")
    if drive not in model.all_drives:
        raise InputError(f"No drive called {drive!r}. {nearest(drive, model.all_drives)}")
    system = compile(model)
    start = dict(zip(system.drives, map(float, system.drive_start), strict=True))
    ends = _range(model, drive, start[drive], position)
    low, high = (given if given is not None else own for given, own in zip((low, high), ends, strict=True))
    up = _followed(model, position, start, drive, high)
    whole = turns(model.all_drives[drive]) and high - low >= 2 * math.pi - 1e-9 and not up[2]
    down = None if whole or low >= start[drive] else _followed(model, position, start, drive, low)
    values, x = (up[0], up[1]) if down is None else (np.r_[down[0][:0:-1], up[0]], np.r_[down[1][:0:-1], up[1]])
    still = np.zeros_like(x)
    motion = kinematics.from_arrays(model, np.arange(len(x), dtype=float), x, still, still)
    forces = dynamics.inverse(model, motion, static=False).arrays
    k = list(model.nodes).index(node)
    held = forces["drive_force"].values[:, list(system.drives).index(drive)]
    return {
        "node": node,
        "drive": drive,
        "unit": "rad" if turns(model.all_drives[drive]) else "m",
        "values": values.tolist(),
        "path": x[:, k].tolist(),
        "force": [float(one) if math.isfinite(one) else None for one in held],
        "stopped": " ".join(part[2] for part in (down, up) if part is not None and part[2]),
    }


def _range(model: Model, drive: str, start: float, position: NDArray[np.float64]) -> tuple[float, float]:
    record = model.all_drives[drive]
    if turns(record):
        return start, start + 2 * math.pi
    if isinstance(record, LengthDrive):
        member = model.members[record.bar]
        if isinstance(member, Active) and member.limits is not None:
            return member.limits
        return 0.6 * start, 1.5 * start
    reach = 0.5 * float(np.ptp(position, axis=0).max())
    return start - reach, start + reach


def _followed(
    model: Model, position: NDArray[np.float64], start: dict[str, float], drive: str, end: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], str]:
    """Drive values, positions and, if the path ends early, the reason."""
    way = Quintic(moves={drive: (start[drive], end)}, duration=1.0)
    try:
        share = np.linspace(0, 1, SAMPLES)
        motion = kinematics.follow(model, way, times=_even(share), start=position, least=LEAST, raise_on_failure=False)
    except KinetrussError as error:
        raise InputError(f"No curve: {error}") from None
    found = motion.arrays
    if not len(found["time"].values):
        raise InputError(f"No curve: {motion.message}")
    names = [str(name) for name in found["drive"].values]
    values = found["drive_position"].values[:, names.index(drive)]
    reason = "" if motion.status.ok else f"It ends at {values[-1]:.6g}: {motion.message}"
    return values, found["position"].values, reason


def _even(share: NDArray[np.float64]) -> NDArray[np.float64]:
    """Times at which a quintic from rest to rest has moved by these shares of its way."""
    time = np.linspace(0, 1, 4001)
    return np.asarray(np.interp(share, time**3 * (10 - 15 * time + 6 * time**2), time))
