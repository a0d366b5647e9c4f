"""Drives through their range: the whole motion that a drawing plays with its forces, and the path of a node along it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss import dynamics, kinematics, statics
from kinetruss.display import quantity
from kinetruss.errors import InputError, KinetrussError
from kinetruss.mechanics import compile
from kinetruss.model import ConstantRate, Model, nearest, turns
from kinetruss.results import Status
from kinetruss.results.user_parts import clamps
from kinetruss.studio.poses import LEAST, number, range_of, reason, used_over

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Forces, Motion

    Floats = NDArray[np.float64]

SAMPLES, FEWEST = 361, 61
"""Samples of a range, and of that of a large structure."""

MOST = 400_000
"""Largest product of samples and members where there are more than `FEWEST` samples."""

FINER = 33
"""Instants between the last good sample and the next, by which the end of a motion that blocks is found."""

TURN, STROKE = 6.0, 4.0
"""Seconds of a whole turn and of a whole stroke, if no rate is given."""

ALIGNED = math.radians(3.0)
"""Angle up to which two bars of a node count as in line, in the words for a pose where a drive blocks."""


FORCES = ("member_force", "drive_force", "reaction", "reaction_moment")
HISTORIES = ("time", "position", "velocity", "acceleration", "drive_position")


@dataclass(frozen=True, kw_only=True, eq=False)
class Swept:
    """Drives through their range, at constant rates.

    time (k,) s, increasing, 0 in the pose of the start, sample `here`; position, velocity, acceleration (k, n_nodes, dim) of
    all nodes; values (k, drives) of those swept, m or rad. rate : of the first drive, rad/s or m/s. whole : a full turn, whose
    end is its start. ends : why it ends before its first and after its last sample, or empty where the range does.
    """

    drives: tuple[str, ...]
    time: Floats
    position: Floats
    velocity: Floats
    acceleration: Floats
    values: Floats
    here: int
    rate: float
    whole: bool
    ends: tuple[str, str]


def swept(
    model: Model, position: Floats, drives: Sequence[str], bounds: Mapping[str, tuple[float, float]] | None = None,
    rate: float | None = None, samples: int = SAMPLES,
) -> Swept:  # fmt: skip
    """Drives from a closed pose (n_nodes, dim), m, to both ends of their ranges, all together; the others stay.

    Parameters
    ----------
    bounds : their ranges, m or rad; by default a whole turn, the limits of a member, or 0.6 to 1.5 times a length.
    rate : of the first drive, rad/s or m/s; by default a turn takes 6 s, a stroke 4 s. samples : their largest number.

    Raises
    ------
    InputError : unknown names, or a structure that its drives do not hold.
    """
    if not drives:
        raise InputError("Nothing moves: the model has no drive. Give a bar a driven length or a driven angle.")
    for name in drives:
        if name not in model.all_drives:
            raise InputError(f"No drive called {name!r}. {nearest(name, model.all_drives)}")
    system = compile(model)
    start = dict(zip(system.drives, map(float, system.drive_start), strict=True))
    turning = {name: turns(model.all_drives[name]) for name in drives}
    ranges = {name: _range(model, name, position, start[name]) for name in drives} | dict(bounds or {})
    low, high = ranges[drives[0]]
    if rate is None:
        rate = 2 * math.pi / TURN if turning[drives[0]] else (high - low) / STROKE
    if not rate > 0:
        raise InputError(f"The rate of {drives[0]!r} is {rate:g}. Give one above 0.")
    goals = {name: ranges[name][1] for name in drives}
    up = _way(model, position, start, goals, rate)
    around = all(turning[name] and ranges[name][1] - start[name] >= 2 * math.pi - 1e-9 for name in drives) and not up.why
    whole = around and bool(np.abs(up.last - position).max() <= 1e-6 * float(np.ptp(position, axis=0).max()))
    goals = {name: ranges[name][0] for name in drives}
    if bounds is None:
        goals |= {name: start[name] - 2 * math.pi for name in drives if turning[name]}
    back = not whole and any(goals[name] < start[name] for name in drives)
    down = _way(model, position, start, goals, rate) if back else Way(up.law, 0.0, position, "")
    total = up.duration + down.duration
    if not total > 0:
        raise InputError(" ".join(dict.fromkeys(filter(None, [up.why, down.why]))) or "The range of the drives is empty.")
    count = min(samples, int(np.clip(MOST // max(1, len(model.members)), FEWEST, SAMPLES))) - 1
    here = round(count * down.duration / total)
    before, after = (_histories(model, position, way, n + 1) for way, n in ((down, here), (up, count - here)))
    found = {
        name: np.concatenate([(-1 if name in ("time", "velocity") else 1) * before[name][:0:-1], after[name]]) for name in after
    }
    names = list(system.drives)
    found["values"] = found.pop("drive_position")[:, [names.index(name) for name in drives]]
    return Swept(drives=tuple(drives), here=len(before["time"]) - 1, rate=rate, whole=whole, ends=(down.why, up.why), **found)


def _range(model: Model, name: str, position: Floats, start: float) -> tuple[float, float]:
    """A whole turn, or the range of a slider."""
    return (start, start + 2 * math.pi) if turns(model.all_drives[name]) else range_of(model, name, position)[:2]


class Way(NamedTuple):
    """How far drives get at constant rates: their law, the time they take (s), the last pose, and why they get no further."""

    law: ConstantRate
    duration: float
    last: Floats
    why: str


def _way(model: Model, position: Floats, start: Mapping[str, float], goal: Mapping[str, float], rate: float) -> Way:
    """How far drives get from a pose on to their ends, at the rate of the first of them that moves."""
    far = {name: end - start[name] for name, end in goal.items()}
    first = next((name for name in far if far[name]), None)
    if first is None:
        return Way(ConstantRate(rates=far, duration=1.0), 0.0, position, "")
    duration = abs(far[first]) / rate
    law = ConstantRate(rates={name: one / duration for name, one in far.items()}, duration=duration)
    times = np.linspace(0.0, duration, SAMPLES)
    motion = _followed(model, law, times, position)
    good, data = len(motion.whole["time"]), motion.whole
    if not good:
        raise InputError(f"Nothing moves from this pose: {reason(motion.message)}.")
    if good == len(times):
        return Way(law, duration, data["position"].values[-1], "")
    finer = _followed(model, law, np.linspace(times[good - 1], times[good], FINER), data["position"].values[-1])
    data = finer.whole if len(finer.whole["time"]) else data
    value = float(data["drive_position"].sel(drive=first).values[-1])
    last = data["position"].values[-1]
    return Way(law, float(data["time"].values[-1]), last, _why(model, first, value, last, motion))


def _followed(model: Model, law: ConstantRate, times: Floats, at: Floats) -> Motion:
    try:
        return kinematics.follow(model, law, times=times, start=at, least=LEAST, raise_on_failure=False)
    except KinetrussError as error:
        raise InputError(f"Nothing moves: {error}") from None


def _histories(model: Model, position: Floats, way: Way, samples: int) -> dict[str, Floats]:
    """The motion as far as it goes, at equally spaced instants."""
    times = np.linspace(0.0, way.duration, samples) if samples > 1 else np.zeros(1)
    data = _followed(model, way.law, times, position).whole
    return {name: data[name].values for name in HISTORIES}


def _why(model: Model, drive: str, value: float, x: Floats, motion: Motion) -> str:
    """Why a drive gets no further, in words."""
    at = f"{drive} {{}} at {quantity(value, 'rad' if turns(model.all_drives[drive]) else 'm')}: "
    if motion.status is Status.OUT_OF_REACH:
        return at.format("blocks") + (_aligned(model, x) or "beyond it the bars do not close") + "."
    if motion.status is Status.SINGULAR:
        beyond = "beyond this dead point the drives do not determine the motion"
        return at.format("stops") + "; ".join(filter(None, [_aligned(model, x), beyond])) + "."
    return at.format("stops") + reason(motion.message) + "."


def _aligned(model: Model, x: Floats) -> str:
    """The two bars or links that are nearest to one line at a common node that is not held, if they are near."""
    places = dict(zip(model.nodes, x, strict=False))
    lines = [(name, one.ends) for name, one in (model.members | model.beams).items()]
    lines += [(name, pair) for name, link in model.links.items() for pair in combinations(link.nodes, 2)]
    at: dict[str, list[tuple[str, str]]] = {}
    for name, ends in lines:
        for node, other in (ends, ends[::-1]):
            if node not in model.fixed and node in places and other in places:
                at.setdefault(node, []).append((name, other))
    best = (ALIGNED, "")
    for node, found in at.items():
        if len(found) > 8:
            continue
        for (one, far), (two, away) in combinations(found, 2):
            if one == two:
                continue
            a, b = places[far] - places[node], places[away] - places[node]
            size = float(np.linalg.norm(a) * np.linalg.norm(b))
            if size:
                off = math.asin(min(1.0, math.sqrt(max(0.0, 1 - (float(a @ b) / size) ** 2))))
                best = min(best, (off, f"{one} and {two} are in line at {node}"))
    return best[1]


def settled(swept: Swept, model: Model, stop: Callable[[], object] = bool) -> Swept:
    """The same at rest, with elastic parts in the equilibrium near each pose; as far as there is a stable one.

    stop : called before each pose, ends it by an error.
    """
    system = compile(model)
    values, x = _driven(model, swept, system.drives), swept.position.copy()
    unit = "rad" if turns(model.all_drives[swept.drives[0]]) else "m"
    bounds, ends = [], list(swept.ends)
    for end, steps in enumerate((range(swept.here, -1, -1), range(swept.here, len(x)))):
        reached = swept.here
        for k in steps:
            stop()
            try:
                rest = statics.equilibrium(model, x[k], lengths=dict(zip(system.drives, values[k].tolist(), strict=True)))
                why = "" if rest.stable else "The equilibrium is not stable"
            except KinetrussError as error:
                why = str(error).rstrip(".")
            if why:
                ends[end] = f"{swept.drives[0]} stops at {quantity(float(swept.values[reached, 0]), unit)}: {why}."
                break
            x[k], reached = rest.whole["position"].values, k
        bounds.append(reached)
    low, high = bounds
    kept = slice(low, high + 1)
    if high == low:
        raise InputError(f"Nothing moves: {ends[1]}")
    return replace(
        swept, time=swept.time[kept], position=x[kept], velocity=0 * x[kept], acceleration=0 * x[kept],
        values=swept.values[kept], here=swept.here - low, whole=swept.whole and high - low + 1 == len(x),
        ends=(ends[0], ends[1]),
    )  # fmt: skip


# What a page gets.


class Film(NamedTuple):
    """A motion to be played: names and words, arrays over time (positions, forces, reactions), and all forces.

    The header names members whose strength was asked for as `judged`; their utilisation is the array `used`.
    """

    header: dict[str, Any]
    arrays: dict[str, Floats]
    forces: Forces


def film(swept: Swept, model: Model, at_speed: bool = False) -> Film:
    """What a page plays. at_speed : with the inertia of the motion at its rates; else every pose at rest."""
    still = np.zeros_like(swept.position)
    v, a = (swept.velocity, swept.acceleration) if at_speed else (still, still)
    motion = kinematics.from_arrays(model, swept.time, swept.position, v, a)
    found = packed(swept, model, dynamics.inverse(model, motion, static=False))
    return found._replace(header=found.header | {"at_speed": at_speed})


def packed(swept: Swept, model: Model, forces: Forces) -> Film:
    """A motion and its forces, as a page plays them."""
    arrays = forces.arrays
    names = [str(name) for name in arrays["drive"].values]
    moments = clamps(compile(model))
    header = {
        "drives": [{"name": name, "unit": "rad" if turns(model.all_drives[name]) else "m"} for name in names],
        "swept": list(swept.drives),
        "here": swept.here,
        "rate": swept.rate,
        "whole": swept.whole,
        "ends": list(swept.ends),
        "nodes": list(model.nodes),
        "members": [str(name) for name in arrays["member"].values],
        "supports": [str(name) for name in arrays["support"].values] if "support" in arrays else [],
        "moments": sorted(moments),
        "unsure": list(forces.attrs.get("not_unique", ())),
        "judged": None,
    }
    kept = {
        "time": swept.time,
        "position": swept.position[:, : len(model.nodes)],
        "drive_position": _driven(model, swept, names),
        **{
            name: arrays[name].values
            for name in ("member_force", "drive_force", "reaction", "reaction_moment")
            if name in arrays
        },
    }
    return Film(header, kept, forces)


def with_strength(film: Film, model: Model) -> Film:
    """The same motion, with the utilisation of its members."""
    used = used_over(model, film.forces)
    arrays = {"used": np.stack(list(used.values()), axis=1)} if used else {}
    return Film(film.header | {"judged": list(used)}, film.arrays | arrays, film.forces)


def _driven(model: Model, swept: Swept, names: Sequence[str]) -> Floats:
    """Values of all drives (k, drives); those that are not swept stay."""
    system = compile(model)
    start = dict(zip(system.drives, map(float, system.drive_start), strict=True))
    found = np.tile([start[name] for name in names], (len(swept.time), 1))
    found[:, [names.index(name) for name in swept.drives]] = swept.values
    return found


def curve(
    model: Model, position: Floats, node: str, drive: str, low: float | None = None, high: float | None = None
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
    own = _range(model, drive, position, float(system.drive_start[list(system.drives).index(drive)]))
    ends = (own[0] if low is None else low, own[1] if high is None else high)
    try:
        found = swept(model, position, [drive], {drive: ends})
        header, arrays, _ = film(found, model)
    except KinetrussError as error:
        raise InputError(f"No curve: {error}") from None
    held = arrays["drive_force"][:, [one["name"] for one in header["drives"]].index(drive)]
    return {
        "node": node,
        "drive": drive,
        "unit": "rad" if turns(model.all_drives[drive]) else "m",
        "values": found.values[:, 0].tolist(),
        "path": arrays["position"][:, list(model.nodes).index(node)].tolist(),
        "force": [number(one) for one in held],
        "stopped": " ".join(filter(None, found.ends)),
    }
