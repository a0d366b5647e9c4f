"""Section forces along parts at one instant, with their extreme values and where these are."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss import strength
from kinetruss.errors import InputError

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces

    Array = NDArray[np.float64]

__all__ = ["Along", "Line", "only", "section_lines"]

Values = list[tuple[str, dict[str, "Array"], float, float]]
"""Parts with their section forces (s,) by symbol, their start, m from end A, and their length, m."""
Sampled = Callable[["Model", "Forces", list[str], "Array"], Values]

STATIONS = 97
"""Stations of the first scan, equally spaced, as those at which beams are judged."""
FINER, PASSES = 25, 3
"""Stations around each extreme value, and how often they are set closer: to 1e-5 of the length, also beside a jump."""
ROUND_OFF = 1e-9
"""Share of the largest force, and of that force times the length, up to which a value is round-off."""
WORDS = {
    "T": ("axial force", "N"),
    "V2": ("shear force along 2", "N"),
    "V3": ("shear force along 3", "N"),
    "M2": ("bending moment about 2", "N m"),
    "M3": ("bending moment about 3", "N m"),
    "T_t": ("torque", "N m"),
}
"""Meaning and unit by symbol, in the order in which they are shown."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Line:
    """One section force along a part: values (s,) in `unit`; least and largest, each with its place, m from end A."""

    symbol: str
    words: str
    unit: str
    values: Array
    least: tuple[float, float]
    largest: tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Along:
    """A part at one instant: places x (s,), m from end A of its member, and its section forces by symbol."""

    part: str
    x: Array
    lines: dict[str, Line]


def only(forces: Forces, sample: int) -> Forces:
    """Forces of one sample, with their motion."""
    here = {"time": [sample]}
    motion = forces.motion.with_(data=forces.motion.data.isel(here))
    return forces.with_(data=forces.data.isel(here), motion=motion, static=None)


def section_lines(model: Model, forces: Forces, parts: Sequence[str]) -> list[Along]:
    """Section forces along bars, rods and tubes of active members, and elastic beams, by `strength.sections` and
    `strength.beams`.

    Parameters
    ----------
    forces : of one sample (`only`). parts : names as in a verdict; an active member stands for its base and tube.

    Returns
    -------
    One entry a part whose section forces are known, in the order of `parts`: rigid beams, planar bodies, and beams out of
    balance have none.
    """
    bars = [name for name in _spelt(model, parts) if name not in model.beams]
    beams = [name for name in parts if name in model.beams and model.beams[name].kind == "elastic"]
    found = {one.part: one for one in (*_refined(model, forces, bars, _of_bars), *_refined(model, forces, beams, _of_beams))}
    return [found[name] for name in _spelt(model, parts) if name in found]


def _spelt(model: Model, parts: Sequence[str]) -> list[str]:
    """Names of parts, those of active members in place of the member."""
    named = [[f"{name}.base", f"{name}.tube"] if name in model.active else [name] for name in parts]
    return list(dict.fromkeys(name for names in named for name in names))


def _refined(model: Model, forces: Forces, parts: list[str], values_of: Sampled) -> Iterator[Along]:
    """Scan, then set stations closer around all extreme values."""
    if not parts:
        return
    xi = np.linspace(0.0, 1.0, STATIONS)
    for _ in range(PASSES):
        found = values_of(model, forces, parts, xi)
        near = [_around(xi, values) for _, lines, *_ in found for values in lines.values()]
        xi = np.unique(np.concatenate([xi, *near]))
    for part, lines, start, length in values_of(model, forces, parts, xi):
        known = _without_round_off(lines, length)
        if not any(np.isnan(values).any() for values in known.values()):
            x = start + xi * length
            yield Along(part=part, x=x, lines={name: _line(name, values, x) for name, values in known.items()})


def _around(xi: Array, values: Array) -> Array:
    """Stations about the least and the largest value, between the neighbours of their stations."""
    if np.isnan(values).any():
        return np.zeros(0)
    ends = [(xi[max(k - 1, 0)], xi[min(k + 1, len(xi) - 1)]) for k in (int(values.argmin()), int(values.argmax()))]
    return np.concatenate([np.linspace(low, high, FINER) for low, high in ends])


def _of_bars(model: Model, forces: Forces, parts: list[str], xi: Array) -> Values:
    data = strength.sections(model, forces, stations=xi).data.isel(time=0)
    names = data["part"].values.tolist()
    chosen = [(name, data.isel(part=names.index(name))) for name in parts if name in names]
    return [(name, _lines(one), float(one["part_start"]), float(one["part_length"])) for name, one in chosen]


def _of_beams(model: Model, forces: Forces, parts: list[str], xi: Array) -> Values:
    try:
        data = strength.beams(model, forces, stations=xi).isel(time=0)
    except InputError:  # positions out of balance: nothing is known of beams
        return []
    lengths = dict(zip(forces.motion.data["member"].values, forces.motion.data["length"].values[0], strict=True))
    return [(name, _lines(data.sel(beam=name)), 0.0, float(lengths[f"{name}.chord"])) for name in parts]


def _lines(data: xr.Dataset) -> dict[str, Array]:
    """Values (s,) by symbol."""
    found: dict[str, Array] = {"T": np.asarray(data["section_T"].values, float)}
    for symbol, name, axis in (("V", "section_V", "transverse"), ("M", "section_M", "moment")):
        values = data[name].transpose("station", axis).values
        found |= {f"{symbol}{of}": np.asarray(values[:, k], float) for k, of in enumerate(map(str, data[axis].values))}
    if "torsion" in data:
        found["T_t"] = np.asarray(data["torsion"].values, float)
    return {name: found[name] for name in WORDS if name in found}


def _without_round_off(lines: dict[str, Array], length: float) -> dict[str, Array]:
    """The values, 0 for those that are round-off beside the largest force, or beside that force on the length as its arm."""
    force = max((float(np.abs(values).max()) for name, values in lines.items() if WORDS[name][1] == "N"), default=0.0)
    moment = max((float(np.abs(values).max()) for name, values in lines.items() if WORDS[name][1] != "N"), default=0.0)
    least = {"N": ROUND_OFF * max(force, moment / length), "N m": ROUND_OFF * max(moment, force * length)}
    return {name: np.where(np.abs(values) <= least[WORDS[name][1]], 0.0, values) for name, values in lines.items()}


def _line(symbol: str, values: Array, x: Array) -> Line:
    low, high = int(values.argmin()), int(values.argmax())
    words, unit = WORDS[symbol]
    least, largest = ((float(values[k]), float(x[k])) for k in (low, high))
    return Line(symbol=symbol, words=words, unit=unit, values=values, least=least, largest=largest)
