"""Motions of drives and supports as piecewise polynomials and sines, which kernels evaluate at any time.

Polynomial laws and splines are taken over exactly. Step responses and poses become quintics that agree with the law, its rate
and its acceleration at their ends, halved until they agree in between as well.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.rows import POLYNOMIAL, SINE
from kinetruss.kinematics import sample
from kinetruss.kinematics.time_tables import check_reach, monotone
from kinetruss.model import ConstantRate, Cyclic, Model, Quintic, Sine, Spline, Tabulated, Trapezoid, moved_by

if TYPE_CHECKING:
    from numpy.typing import NDArray


AGREEMENT = 1e-13
"""Largest difference between quintics and law, as a fraction of its largest value."""
SMALLEST = 1e-7
"""Shortest piece, as a fraction of the time; shorter ones occur only at jumps of a law."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Table:
    """One motion: `data` (4,) of a sine, or pieces that begin at `start` (p,), coefficients (p, w) in rising powers."""

    kind: int
    data: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    start: NDArray[np.float64]
    pieces: NDArray[np.float64]


def hold(value: float) -> Table:
    """A constant."""
    return _polynomials([0.0], [[value]])


def stack(tables: list[Table]) -> dict[str, NDArray[Any]]:
    """The arrays of `Equations` for a list of motions."""
    width = max((table.pieces.shape[1] for table in tables), default=1)
    rows = [np.pad(table.pieces, ((0, 0), (0, width - table.pieces.shape[1]))) for table in tables]
    return {
        "motion_kind": np.array([table.kind for table in tables], np.int64),
        "motion_data": np.array([table.data for table in tables], float).reshape(-1, 4),
        "motion_ptr": np.cumsum([0, *(len(table.start) for table in tables)]).astype(np.int64),
        "piece_start": np.concatenate([*(table.start for table in tables), np.zeros(0)]),
        "piece": np.concatenate([*rows, np.zeros((0, width))]),
    }


def drive_tables(model: Model, trajectory: Any, t_end: float) -> dict[str, Table]:
    """The motion of every drive that a trajectory moves, from 0 to t_end (s); drives at rest are left out."""
    if isinstance(trajectory, Tabulated):
        check_reach("the trajectory (counted from its first row)", 0.0, trajectory.duration, 0.0, t_end)
    names = moved_by(trajectory)[1]
    posed = [
        name for pose, record in model.poses.items() for name in record.drives if any(n.startswith(f"{pose}.") for n in names)
    ]
    tables = {
        name: _closed(model, trajectory, name, change, t_end) for name, change in names.items() if name in model.all_drives
    }
    return tables | {name: _sampled(model, trajectory, name, t_end) for name in posed if name not in tables}


def _closed(model: Model, trajectory: Any, name: str, change: Any, t_end: float) -> Table:
    """One drive that the trajectory names."""
    begin, swing = (change[0], change[1] - change[0]) if isinstance(trajectory, (Quintic, Trapezoid, Cyclic)) else (0.0, 0.0)
    if isinstance(trajectory, Quintic):
        T = trajectory.duration
        shape = [begin, 0.0, 0.0, 10 * swing / T**3, -15 * swing / T**4, 6 * swing / T**5]
        return _polynomials([0.0, 0.0, T], [[begin], shape, [begin + swing]])
    if isinstance(trajectory, Trapezoid):
        return _trapezoid(begin, swing, trajectory.duration, trajectory.ramp)
    if isinstance(trajectory, Cyclic):
        w = 2 * math.pi / trajectory.period
        return _sine(begin + 0.5 * swing, 0.5 * swing, w, -0.5 * math.pi)
    start = float(sample(model, trajectory, [0.0]).value[0, list(model.all_drives).index(name)])
    if isinstance(trajectory, ConstantRate):
        return _polynomials([0.0], [[start, change]])
    if isinstance(trajectory, Sine):
        return _sine(start - change * math.sin(trajectory.phase), change, 2 * math.pi / trajectory.period, trajectory.phase)
    if isinstance(trajectory, Spline):
        return table_of(np.array(trajectory.times) - trajectory.times[0], np.array(trajectory.values[name]), trajectory.shape)
    return _sampled(model, trajectory, name, t_end)


def _trapezoid(begin: float, swing: float, T: float, ramp: float) -> Table:
    slope = swing / (1.0 - ramp) / ramp / T**2
    early = 0.5 * slope * (ramp * T) ** 2
    pieces = [
        [begin],
        [begin, 0.0, 0.5 * slope],
        [begin + early, slope * ramp * T],
        [begin + swing - early, slope * ramp * T, -0.5 * slope],
        [begin + swing],
    ]
    return _polynomials([0.0, 0.0, ramp * T, (1.0 - ramp) * T, T], pieces)


def table_of(times: NDArray[np.float64], values: NDArray[np.float64], shape: str = "spline") -> Table:
    """The interpolant of a table (`kinematics.time_tables.through`); no run goes beyond it: the last piece has no end."""
    from scipy.interpolate import PPoly, make_interp_spline

    if np.all(values == values[0]):
        return hold(float(values[0]))
    if shape == "monotone":
        curve = PPoly.from_bernstein_basis(monotone(times, values[:, None]))
        return Table(kind=POLYNOMIAL, start=curve.x[:-1].copy(), pieces=np.ascontiguousarray(curve.c[::-1, :, 0].T))
    degree = 5 if times.size >= 6 else 3 if times.size >= 4 else times.size - 1
    scale = (times[-1] - times[0]) / (times.size - 1)
    found = PPoly.from_spline(make_interp_spline((times - times[0]) / scale, values, k=degree))
    keep = np.flatnonzero(np.diff(found.x) > 0.0)
    pieces = found.c[::-1, keep].T / scale ** np.arange(degree + 1)
    return Table(kind=POLYNOMIAL, start=times[0] + scale * found.x[keep], pieces=pieces)


def _sampled(model: Model, trajectory: Any, name: str, t_end: float) -> Table:
    """One drive by its values, rates and accelerations at chosen times."""
    column = list(model.all_drives).index(name)

    def law(t: NDArray[np.float64]) -> NDArray[np.float64]:
        found = sample(model, trajectory, t)
        return np.stack([found.value[:, column], found.rate[:, column], found.acceleration[:, column]], axis=1)

    breaks = [0.0, trajectory.duration]
    if isinstance(trajectory, Trapezoid):
        breaks += [trajectory.ramp * trajectory.duration, (1.0 - trajectory.ramp) * trajectory.duration]
    if isinstance(trajectory, Tabulated):
        breaks += [t - trajectory.times[0] for t in trajectory.times]
    return coordinate_table(law, sorted({t for t in breaks if t < t_end} | {t_end}))


def coordinate_table(law: Callable[[NDArray[np.float64]], NDArray[np.float64]], breaks: list[float]) -> Table:
    """Quintics between the breaks, halved until law (n,) -> (n, 3) and its quintic agree."""
    left, right = np.array(breaks[:-1]), np.array(breaks[1:])
    starts: list[NDArray[np.float64]] = []
    pieces: list[NDArray[np.float64]] = []
    span = breaks[-1] - breaks[0]
    while left.size:
        found = _hermite(law, left, right)
        h = right - left
        size = np.abs(found[:, 0]).max()
        off = np.zeros(left.size)
        # largest difference of quintic and law within each interval
        for share in (0.25, 0.5, 0.7):
            s = (share * h)[:, None] ** np.arange(6)
            off = np.maximum(off, np.abs((found * s).sum(axis=1) - law(left + share * h)[:, 0]))
        good = (off <= AGREEMENT * size) | (h < SMALLEST * span)
        starts.append(left[good])
        pieces.append(found[good])
        middle = 0.5 * (left + right)[~good]
        left, right = np.concatenate([left[~good], middle]), np.concatenate([middle, right[~good]])
    start, piece = np.concatenate(starts), np.concatenate(pieces)
    order = np.argsort(start)
    return Table(kind=POLYNOMIAL, start=start[order], pieces=piece[order])


def _hermite(law: Any, left: NDArray[np.float64], right: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients (p, 6) in rising powers of t - left."""
    h = right - left
    # just inside: at a jump at an end, the value inside counts
    inside = 1e-12 * h
    y, z = law(left + inside), law(right - inside)
    c = np.zeros((left.size, 6))
    c[:, 0], c[:, 1], c[:, 2] = y[:, 0], y[:, 1], 0.5 * y[:, 2]
    p = z[:, 0] - c[:, 0] - h * (c[:, 1] + h * c[:, 2])
    q = h * (z[:, 1] - c[:, 1] - 2 * h * c[:, 2])
    r = h**2 * (z[:, 2] - 2 * c[:, 2])
    c[:, 3] = (10 * p - 4 * q + 0.5 * r) / h**3
    c[:, 4] = (-15 * p + 7 * q - r) / h**4
    c[:, 5] = (6 * p - 3 * q + 0.5 * r) / h**5
    return c


def _polynomials(start: list[float], pieces: list[list[float]]) -> Table:
    width = max(map(len, pieces))
    return Table(kind=POLYNOMIAL, start=np.array(start), pieces=np.array([row + [0.0] * (width - len(row)) for row in pieces]))


def _sine(mean: float, amplitude: float, w: float, phase: float) -> Table:
    return Table(kind=SINE, data=(mean, amplitude, w, phase), start=np.zeros(1), pieces=np.zeros((1, 1)))
