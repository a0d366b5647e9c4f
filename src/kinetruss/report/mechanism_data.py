"""What a mechanism does, as plain rows: paths of nodes, angles of members, transmission, quantities of the model; SI, NaN for
what is not known.

Extremes are those of the samples.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display.ranks import largest_first, place_of_largest
from kinetruss.errors import InputError
from kinetruss.kinematics.quantity_histories import quantities
from kinetruss.model import nearest, turns
from kinetruss.model.quantities import kinds_of
from kinetruss.runs.doubts import poses_of
from kinetruss.runs.quantity_limits import entries, limits_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]

STILL = 1e-9
"""Share of the size of a structure below which a node does not move; angle, rad, by which a member does not turn."""
RESTING = 1e-6
"""Share of the largest rate of a drive below which it stands, so that ratios to its rate say nothing."""
LISTED = 400
"""Number of members up to which the angles of all are looked at."""


def moves(run: RunResult) -> bool:
    """True for a motion over time of more than one sample."""
    return run.good > 1 and "pose" not in run.motion.whole.coords and bool(np.any(run.motion.arrays["velocity"].values))


def driver(run: RunResult) -> str:
    """The one drive that moves in a prescribed motion: all rates are in a fixed ratio to its own; empty if there is none."""
    data = run.motion.whole
    if run.simulation is not None or not moves(run) or "drive" not in data.sizes or run.model.support_motion:
        return ""
    rates = np.abs(data["drive_velocity"].values).max(axis=0, initial=0.0)
    moving = [str(name) for name, rate in zip(data["drive"].values, rates, strict=True) if rate > 0]
    return moving[0] if len(moving) == 1 else ""


def _rate_of(run: RunResult, drive: str) -> Array:
    """The rate of a drive, NaN where it stands."""
    data = run.motion.whole
    rate = data["drive_velocity"].values[:, [str(name) for name in data["drive"].values].index(drive)]
    return np.where(np.abs(rate) > RESTING * np.abs(rate).max(), rate, np.nan)


# Nodes.


def node_paths(run: RunResult, names: Sequence[str] = ()) -> list[dict[str, Any]]:
    """Where nodes go: least and largest coordinates (m), length of the path (m), largest speed (m/s) and acceleration (m/s^2)
    with their times (s). names : by default all that move.

    The length of a path is the integral of the speed by the trapezoidal rule with the accelerations at the ends of each step
    (Euler and Maclaurin).

    Raises
    ------
    InputError : unknown nodes; a run that has no motion over time.
    """
    if not moves(run):
        if names:
            raise InputError("The run has no motion over time: its nodes have no paths. Places under load: kinetruss export.")
        return []
    data, known = run.motion.whole, [name for name, one in run.model.nodes.items() if not one.scalar]
    for name in names:
        if name not in known:
            raise InputError(f"No node called {name!r}. {nearest(name, known)}")
    place = {str(name): k for k, name in enumerate(data["node"].values)}
    time, (x, v, a) = data["time"].values, (data[one].values for one in ("position", "velocity", "acceleration"))
    size = float(np.ptp(x[0], axis=0).max())
    found = []
    for name in names or known:
        k = place[name]
        if not names and np.ptp(x[:, k], axis=0).max() <= STILL * size:
            continue
        speed, amount = (np.linalg.norm(one[:, k], axis=1) for one in (v, a))
        at, most = place_of_largest(speed), place_of_largest(amount)
        found.append(
            {
                "node": name,
                "least": x[:, k].min(axis=0).tolist(),
                "largest": x[:, k].max(axis=0).tolist(),
                "start": x[0, k].tolist(),
                "end": x[-1, k].tolist(),
                "path": path_length(time, v[:, k], a[:, k]),
                "speed": float(speed[at]),
                "speed_time": float(time[at]),
                "acceleration": float(amount[most]),
                "acceleration_time": float(time[most]),
            }
        )
    return found


def path_length(time: Array, v: Array, a: Array) -> float:
    """Length of a path, m, from velocities and accelerations (times, dim)."""
    speed, h = np.linalg.norm(v, axis=1), np.diff(time)
    with np.errstate(divide="ignore", invalid="ignore"):
        change = np.nan_to_num(np.einsum("tc,tc->t", v, a) / speed)
    turned = np.einsum("tc,tc->t", v[1:], v[:-1]) <= 0  # through a point of rest the speed has a corner
    ends = np.where(turned, 0.0, h**2 / 12.0 * (change[:-1] - change[1:]))
    return float(np.sum(0.5 * h * (speed[1:] + speed[:-1]) + ends))


# Members.


def member_turns(run: RunResult, names: Sequence[str] = ()) -> list[dict[str, Any]]:
    """How members turn: angle in the plane from +x (rad), least and largest, sweep; largest angular velocity and acceleration
    (rad/s, rad/s^2) with their times; length (m) where it changes. In space the angle is that from the direction at the start.

    With one drive (`driver`) also ``ratio``: rates of the angle over that of the drive, least and largest, with the time of the
    least magnitude; ``advantage``: torque on the member over force or torque of the drive, by virtual work, least magnitude,
    with its time; ``dead`` : times at which the member stands while the drive moves, between samples.

    names : by default all that turn, the largest sweep first.

    Raises
    ------
    InputError : unknown members; a run that has no motion over time.
    """
    own = {**run.model.members, **run.model.bending}
    for name in names:
        if name not in own:
            raise InputError(f"No member called {name!r}. {nearest(name, own)}")
    if not moves(run):
        if names:
            raise InputError("The run has no motion over time: its members do not turn.")
        return []
    if not names and len(own) > LISTED:
        return []
    chosen = list(names or own)
    series = angle_histories(run, chosen)
    time, drive = run.motion.whole["time"].values, driver(run)
    rate = _rate_of(run, drive) if drive else None
    found = []
    for name, (angle, w, b) in zip(chosen, series, strict=True):
        if not names and not np.ptp(angle) > STILL:
            continue
        at, most = place_of_largest(np.abs(np.nan_to_num(w))), place_of_largest(np.abs(np.nan_to_num(b)))
        ends = own[name].ends
        row = {
            "member": name,
            "unit": "rad",
            "least": float(angle.min()),
            "largest": float(angle.max()),
            "sweep": float(np.ptp(angle)),
            "rate": float(w[at]),
            "rate_time": float(time[at]),
            "acceleration": float(b[most]),
            "acceleration_time": float(time[most]),
            "length": _lengths(run, ends),
        }
        if rate is not None and run.model.dim == 2:
            row |= _transmitted(run, drive, name, w, b, rate)
        found.append(row)
    return found if names else largest_first(found, lambda row: row["sweep"])


def angle_histories(run: RunResult, names: Sequence[str]) -> list[tuple[Array, Array, Array]]:
    """Angle, rate and second rate (times,) of members: rad, rad/s, rad/s^2; in space from the direction at the start."""
    if run.model.dim == 2:
        found = quantities(run.model, run.motion, {f"{k}": f"angle(member({name!r}))" for k, name in enumerate(names)})
        return [tuple(found[one].values[:, k] for one in ("value", "rate", "second_rate")) for k in range(len(names))]  # type: ignore[misc]
    data, own = run.motion.whole, {**run.model.members, **run.model.bending}
    place = {str(name): k for k, name in enumerate(data["node"].values)}
    found_ = []
    for name in names:
        p, q = (place[end] for end in own[name].ends)
        d, v, a = (data[one].values[:, q] - data[one].values[:, p] for one in ("position", "velocity", "acceleration"))
        square = np.einsum("tc,tc->t", d, d)
        # w = d x d'/L^2 of a direction, whose spin is not known
        w = np.cross(d, v) / square[:, None]
        b = np.cross(d, a) / square[:, None] - 2.0 * (np.einsum("tc,tc->t", d, v) / square)[:, None] * w
        angle = np.arctan2(np.linalg.norm(np.cross(d[:1], d), axis=1), d @ d[0])
        found_.append((angle, np.linalg.norm(w, axis=1), np.linalg.norm(b, axis=1)))
    return found_


def _lengths(run: RunResult, ends: Sequence[str]) -> list[float] | None:
    """Least and largest distance of the ends of a member, m; None if it does not change."""
    data = run.motion.whole
    place = {str(name): k for k, name in enumerate(data["node"].values)}
    p, q = (data["position"].values[:, place[end]] for end in ends)
    length = np.linalg.norm(q - p, axis=1)
    return [float(length.min()), float(length.max())] if np.ptp(length) > STILL * length.max() else None


def _transmitted(run: RunResult, drive: str, name: str, w: Array, b: Array, rate: Array) -> dict[str, Any]:
    """Ratios of the rate of a member to that of the drive, its mechanical advantage and its dead points."""
    time, ratio = run.motion.whole["time"].values, w / rate
    if np.isnan(ratio).all() or not np.nanmax(np.abs(ratio)) > STILL:
        return {}
    most = int(np.nanargmax(np.abs(ratio)))
    record = run.model.all_drives[drive]
    return {
        "drive": drive,
        "ratio": [float(np.nanmin(ratio)), float(np.nanmax(ratio))],
        "ratio_unit": "" if turns(record) else "rad/m",
        # M w = F q' without friction, weight and inertia
        "advantage": float(1.0 / ratio[most]),
        "advantage_unit": "" if turns(record) else "m/rad",
        "advantage_time": float(time[most]),
        "dead": [] if getattr(record, "bar", "") == name and turns(record) else dead_points(time, w, b, rate),
    }


def dead_points(time: Array, w: Array, b: Array, rate: Array) -> list[float]:
    """Times at which a rate w (times,) is 0 while that of the drive is not: roots of the cubics through w and its rate b.

    w and rate have one sign or another, or NaN where the drive stands.
    """
    largest, found = float(np.nanmax(np.abs(w))), list[float]()
    for i in range(len(time) - 1):
        if np.isnan(rate[i]) or np.isnan(rate[i + 1]) or rate[i] * rate[i + 1] < 0:
            continue
        if abs(w[i]) <= 1e-12 * largest:
            found.append(float(time[i]))
        elif w[i] * w[i + 1] < 0 and abs(w[i + 1]) > 1e-12 * largest:
            h = time[i + 1] - time[i]
            p, q = b[i] * h, b[i + 1] * h
            cubic = [2 * w[i] - 2 * w[i + 1] + p + q, -3 * w[i] + 3 * w[i + 1] - 2 * p - q, p, w[i]]
            roots = [float(s.real) for s in np.roots(cubic) if abs(s.imag) < 1e-9 and -1e-9 <= s.real <= 1 + 1e-9]
            found.append(float(time[i] + h * roots[0]) if roots else float(time[i] + h * w[i] / (w[i] - w[i + 1])))
    if len(time) and abs(w[-1]) <= 1e-12 * largest and not np.isnan(rate[-1]):
        found.append(float(time[-1]))
    return found


# Transmission angles.


def transmission_angles(run: RunResult) -> list[dict[str, Any]]:
    """Transmission angles of a plane mechanism with one drive, 0 to 90 degrees (rad): between a member that turns about a fixed
    pin, other than the drive's, and each member that meets it at its other end; and at a node that slides along an axis between
    a member and the normal of the axis. Least and largest, with the time of the least. 90 degrees transmit best.

    Alt (1932); Hain (1967), Applied Kinematics, chapter 2.
    """
    drive = driver(run)
    if not drive or run.model.dim != 2 or len(run.model.members) > LISTED:
        return []
    model, data = run.model, run.motion.whole
    place = {str(name): k for k, name in enumerate(data["node"].values)}
    x, moved = data["position"].values, getattr(model.all_drives[drive], "bar", "")
    # a link of more pins than two has no one direction in which it transmits
    own = {**model.members, **{name: one for name, one in model.links.items() if len(one.nodes) == 2}}
    along = {name: x[:, place[one.ends[1]]] - x[:, place[one.ends[0]]] for name, one in own.items()}
    meeting: dict[str, list[str]] = {}
    for name, one in own.items():
        for end in one.ends if name != moved else ():
            meeting.setdefault(end, []).append(name)
    pairs: list[tuple[str, str, str, Array, Array]] = []
    for pin, end, name in _followers(model, own, moved):
        for other in meeting[end]:
            if other != name and pin not in own[other].ends:
                d, e = along[name], along[other]
                pairs.append((end, name, other, d[:, 0] * e[:, 1] - d[:, 1] * e[:, 0], np.einsum("tc,tc->t", d, e)))
    for node, axes in model.fixed.items():
        if node in place and (free := {"x": 1, "y": 0}.get(axes)) is not None:
            # the angle between the member and the normal of the axis
            pairs += [
                (node, f"slider {node}", name, along[name][:, free], along[name][:, 1 - free]) for name in meeting.get(node, ())
            ]
    rows = (_transmission(*one, data["time"].values) for one in pairs)
    # members of one rigid part keep their angle
    return [row for row in rows if row["largest"] - row["least"] > STILL]


def _followers(model: Model, own: Mapping[str, Any], moved: str) -> Iterator[tuple[str, str, str]]:
    """Members, of `own`, with a fixed pin and a free end: pin, end and name; moved : by the drive."""
    for name, one in own.items():
        for pin, end in (one.ends, one.ends[::-1]):
            if {"x", "y"} <= set(model.fixed.get(pin, "")) and end not in model.fixed and name != moved:
                yield pin, end, name


def _transmission(node: str, of: str, other: str, s: Array, c: Array, time: Array) -> dict[str, Any]:
    angle = np.arctan2(np.abs(s), np.abs(c))
    at = place_of_largest(-angle)
    least, largest = float(angle[at]), float(angle.max())
    return {"node": node, "member": of, "with": other, "least": least, "largest": largest, "time": float(time[at])}


# Quantities that the model defines.


def quantity_rows(run: RunResult) -> list[dict[str, Any]]:
    """Value at the start, least and largest (with times, s), largest rate (with time) of the quantities of the model, each in
    its unit; its limits, and whether they are kept.
    """
    found, kinds, poses = list[dict[str, Any]](), kinds_of(run.model), poses_of(run)
    status: dict[tuple[str, str], str] = {}
    for one in run.finding.quantities:
        status.setdefault((one.part, one.load_case), one.status)
    for case, data, k, name in entries(run.model, run.quantities):
        timed = "time" in data.coords
        time = data["time"].values if timed else np.zeros(1)
        values = data["value"].values[:, k] if timed else data["value"].values[k : k + 1]
        rates = data["rate"].values[:, k] if "rate" in data else np.full(len(values), np.nan)
        kind, record, limits = kinds[name], run.model.quantities[name], limits_of(run.model, name, case)
        ends = _extreme("least", time, values, -values) | _extreme("largest", time, values, values)
        named = {
            f"{end}_pose": poses[round(at)] if poses and timed and not math.isnan(at := ends[f"{end}_time"]) else ""
            for end in ("least", "largest")
        }
        found.append(
            {
                "quantity": name,
                "words": record.words,
                "value": record.value,
                "unit": kind.unit,
                "rate_unit": kind._replace(time=kind.time - 1).unit,
                "load_case": case,
                "limits": None if limits is None else list(limits),
                "status": status.get((name, case), ""),
                "start": float(values[0]),
                "unknown": int(np.isnan(values).sum()),
                **ends,
                **named,
                **_extreme("rate", time, rates, np.abs(rates)),
            }
        )
    return found


def deflection_records(run: RunResult) -> list[dict[str, Any]]:
    """The checks of deflections, worst first, as plain data."""
    rows = largest_first(run.deflections, lambda row: row.utilisation if row.checked else -math.inf)
    return [{**asdict(row), "status": row.status} for row in rows]


def _extreme(name: str, time: Array, values: Array, rank: Array) -> dict[str, float]:
    """The value of the highest rank, and its time; NaN if none is known."""
    if np.isnan(rank).all():
        return {name: math.nan, f"{name}_time": math.nan}
    at = int(np.nanargmax(rank))
    return {name: float(values[at]), f"{name}_time": float(time[at])}


def mechanism_record(run: RunResult) -> dict[str, Any]:
    """What the summary and the report tell of the motion."""
    return {
        "driver": driver(run),
        "paths": largest_first(node_paths(run), lambda row: row["path"]),
        "turns": member_turns(run),
        "transmission": transmission_angles(run),
    }
