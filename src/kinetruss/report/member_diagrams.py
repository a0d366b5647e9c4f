"""Diagrams of section forces along members and beams at one instant: which, their values, their extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import strength
from kinetruss.display import instant, quantity
from kinetruss.display.ranks import largest, largest_first
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.model import nearest
from kinetruss.model.links import bends
from kinetruss.strength.beam_spans import spans_of
from kinetruss.strength.beam_verdict import chords_of
from kinetruss.strength.curves import only

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]


Values = list[tuple[str, dict[str, "Array"], float, float]]
"""Parts with their section forces (s,) by symbol, their start, m from end A, and their length, m."""
Sampled = Callable[["Model", "Forces", list[str], "Array"], Values]

STATIONS = 97
"""Stations of the first scan, equally spaced, as those at which beams are judged."""
FINER, PASSES = 25, 3
"""Stations around each extreme value, and how often they are set closer: to 1e-5 of the length, also beside a jump."""
BESIDE = 1e-6
"""How far beside the pins of links there are stations, as a fraction of their place."""
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
    bars = [name for name in _spelt(model, parts) if name not in model.bending]
    beams = [name for name in parts if name in model.bending and bends(model, model.bending[name])]
    found = {
        one.part: one for one in (*_refined(model, forces, bars, _of_bars), *_refined(model, forces, beams, _sampled_beams))
    }
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
    if values_of is _sampled_beams:  # shear forces jump at the pins of links
        pins = spans_of(compile(model)).pins
        xi = np.unique(np.concatenate([xi, pins, pins * (1.0 - BESIDE), pins * (1.0 + BESIDE)]))
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


def _sampled_beams(model: Model, forces: Forces, parts: list[str], xi: Array) -> Values:
    try:
        data = strength.beams(model, forces, stations=xi).isel(time=0)
    except InputError:  # positions out of balance: nothing is known of beams
        return []
    lengths = dict(zip(forces.motion.whole["member"].values, forces.motion.whole["length"].values[0], strict=True))
    found = [(name, sum(float(lengths[chord]) for chord in chords_of(model, name))) for name in parts]
    return [(name, _lines(data.sel(beam=name)), 0.0, length) for name, length in found]


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


# Which diagrams a report shows: governing members, each at the instant of its entry, and beams at that of the worst one.

MOST = 12
"""Number of beams that are drawn: those of the highest stress."""
NEGLIGIBLE = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Subject:
    """A diagram: section forces along a part, why it is shown, when and under which loads, and the place, m from end A, of the
    entry that governs (None if there is none).
    """

    along: Along
    why: str
    when: str
    load_case: str
    place: float | None = None

    @property
    def moment(self) -> str:
        """Instant and load case as text."""
        case = "all loads" if self.load_case == "all" else f"load case {self.load_case}"
        return ", ".join(filter(None, [self.when, case]))


def governing_diagrams(run: RunResult, record: Mapping[str, Any]) -> tuple[list[Subject], list[Subject]]:
    """Diagrams of the governing members and drives, and of beams: worst first. record : of the report of the run."""
    rows = _governing_rows(run, record)
    members = [one for row in rows if row["part"] not in run.model.bending for one in _of_row(run, row)]
    return _first(members), _of_beams(run, record, rows)


def requested(run: RunResult, parts: Sequence[str], at: float | str | None, case: str | None) -> list[Subject]:
    """Diagrams of given parts at an instant (s, or the name of a pose).

    Raises
    ------
    InputError : an unknown member, instant or load case; forces that are not known.
    """
    if not run.forces:
        raise InputError("The run has no forces. Run an analysis that has: dynamics.inverse, statics.linear.")
    if case is not None and case not in run.forces:
        raise InputError(f"No load case called {case!r}. {nearest(case, run.forces)}")
    known = {
        *run.model.whole.members,
        *run.model.bending,
        *(f"{name}.{role}" for name in run.model.active for role in ("base", "tube")),
    }
    for name in parts:
        if name not in known:
            raise InputError(f"{name!r} is no member, beam or link. {nearest(name, known)}")
    label = case or next(iter(run.forces))
    found = _subjects(run, label, _sample_at(run, at), parts, "")
    if not found:
        raise InputError(
            f"No section forces of {', '.join(parts)} are known: rigid beams and planar bodies have none, and beams only in "
            "positions that are in balance (statics.linear, statics.equilibrium, dynamics.simulate)."
        )
    return found


def diagrams_record(subjects: Iterable[Subject]) -> list[dict[str, Any]]:
    """Extreme values of diagrams as plain data, SI."""
    return [
        {
            "part": one.along.part,
            "when": one.when,
            "load_case": one.load_case,
            "quantity": line.words,
            "symbol": line.symbol,
            "unit": line.unit,
            "least": line.least[0],
            "least_at": line.least[1],
            "largest": line.largest[0],
            "largest_at": line.largest[1],
        }
        for one in subjects
        for line in one.along.lines.values()
    ]


def _governing_rows(run: RunResult, record: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The worst entry of each rule of members, and the worst one of drives that belongs to an instant."""
    found: dict[str, Mapping[str, Any]] = {}
    for row in record["strength"]:
        if row["utilisation"] is not None and float(row["utilisation"]) > NEGLIGIBLE:
            found.setdefault(row["rule"], row)
    drives = [row for row in record["limits"] if row["utilisation"] is not None and _sample_of(run, row) is not None]
    if drives:
        found["drive"] = largest(drives, lambda row: float(row["utilisation"]))
    shares = ((row, float(row["utilisation"])) for row in found.values())
    return [row for row, _ in largest_first(shares, lambda pair: pair[1] if np.isfinite(pair[1]) else 1.0)]


def _of_row(run: RunResult, row: Mapping[str, Any]) -> list[Subject]:
    """The part of an entry at its instant; of a drive, the member that it moves."""
    drive = run.model.all_drives.get(row["part"])
    name = row["part"] if drive is None or row["part"] in run.model.whole.members else getattr(drive, "bar", "")
    sample = _sample_of(run, row)
    if sample is None or row["load_case"] not in run.forces:
        return []
    place, share = row.get("position"), float(row["utilisation"])
    why = f"{row['rule']} {quantity(share, '%')}" if np.isfinite(share) else f"{row['rule']} without finite value"
    return _subjects(run, row["load_case"], sample, [name], why, None if place is None else float(place))


def _of_beams(run: RunResult, record: Mapping[str, Any], rows: Sequence[Mapping[str, Any]]) -> list[Subject]:
    """The most stressed beams at the instant of the worst one; without any that was checked, of the governing entry."""
    names = [name for name, one in run.model.bending.items() if bends(run.model, one)]
    if not names or not run.forces:
        return []
    checked = [row for row in record["strength"] if row["part"] in run.model.bending and row["value"] is not None]
    known = [row for row in (*checked[:1], *rows) if row["load_case"] in run.forces and _sample_of(run, row) is not None]
    case, sample = (known[0]["load_case"], _sample_of(run, known[0])) if known else (next(iter(run.forces)), 0)
    try:
        data = strength.beams(run.model, only(run.forces[case], sample or 0), stations=9)
    except InputError:
        return []
    stress = data["stress"].isel(time=0).max("station").to_series()
    worst = [str(name) for name in stress.sort_values(ascending=False).index]
    places = {row["part"]: row for row in reversed(checked)}
    found = []
    for one in _subjects(run, case, sample or 0, worst[:MOST], ""):
        row = places.get(one.along.part)
        here = row is not None and row["load_case"] == case and _sample_of(run, row) == sample and row["position"] is not None
        found.append(replace(one, place=float(row["position"])) if here and row is not None else one)
    return found


def _first(subjects: Iterable[Subject]) -> list[Subject]:
    """One diagram a part, instant and load case: that of its worst entry, with the rules of all."""
    found: dict[tuple[str, str, str], Subject] = {}
    for one in subjects:
        key = one.along.part, one.when, one.load_case
        if key in found and one.why not in found[key].why:
            before = found[key]
            one = Subject(
                along=one.along,
                why=f"{before.why}, {one.why}",
                when=one.when,
                load_case=one.load_case,
                place=before.place if before.place is not None else one.place,
            )
        found[key] = one
    return list(found.values())


def _subjects(
    run: RunResult, case: str, sample: int, parts: Sequence[str], why: str, place: float | None = None
) -> list[Subject]:
    found = section_lines(run.model, only(run.forces[case], sample), parts)
    return [Subject(along=one, why=why, when=_when(run, sample), load_case=case, place=place) for one in found]


def _when(run: RunResult, sample: int) -> str:
    data = run.motion.whole
    if "pose" in data.coords:
        return f"pose {data['pose'].values[sample]}"
    return f"t = {instant(float(data['time'].values[sample]))}" if run.good > 1 else ""


def _sample_of(run: RunResult, row: Mapping[str, Any]) -> int | None:
    """Index of the sample of an entry, by its pose or time; None of one that belongs to the whole run."""
    data = run.motion.whole
    if row.get("pose") and "pose" in data.coords:
        found = np.flatnonzero(data["pose"].values == row["pose"])
        return int(found[0]) if len(found) else None
    if row.get("time") is None:
        return None
    return int(np.abs(data["time"].values - float(row["time"])).argmin())


def _sample_at(run: RunResult, at: float | str | None) -> int:
    from kinetruss.units import parse

    data = run.motion.whole
    if at is None:
        return 0
    if "pose" in data.coords:
        names = [str(name) for name in data["pose"].values]
        if str(at) not in names:
            raise InputError(f"No pose called {str(at)!r}. {nearest(str(at), names)}")
        return names.index(str(at))
    wanted, time = parse(at, "time"), data["time"].values
    apart = 1e-9 * float(time[-1] - time[0])
    if not time[0] - apart <= wanted <= time[-1] + apart:
        raise InputError(f"at={wanted:g} s: the run goes from {time[0]:g} to {time[-1]:g} s.")
    return int(np.abs(time - wanted).argmin())
