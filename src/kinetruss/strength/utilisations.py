"""Utilisation of every part by every rule at every instant."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.sections.peaks import MOMENT_RESULTANT, MOMENT_SUM, ROUND, least_tension, peaks
from kinetruss.kernels.sections.records import Polynomials
from kinetruss.limits import MOST_STATIONS, whole
from kinetruss.mechanics import System, cached, compile
from kinetruss.model import Model
from kinetruss.results import Arrays, Axes, Forces, variable
from kinetruss.strength.beam_verdict import beam_histories, beam_limits, beam_parts
from kinetruss.strength.critical_loads import amplification, critical_load, end_condition, euler_load
from kinetruss.strength.link_columns import columns_of
from kinetruss.strength.parts import Parts, histories, parts_of, shear_of_torsion, torsion_of, with_torsion

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray


RULES = {"yield": "Pa", "buckling": "N", "beam-column": ""}
"""Rules and the units of their values and limits."""

BATCH = 256  # samples in one batch
SPANS = 12


@dataclass(frozen=True, kw_only=True, eq=False)
class Options:
    """Options of the strength check.

    stations : sections scanned along a part before the largest value is located between them (at least 13).
    moment_factor : Cm of the beam-column rule; 1 suits loads across a member with pinned ends.
    active_section : the section for the buckling of an active member over its whole length: that of its ``base``, its ``tube``,
        or the ``weaker`` (conservative: the real member is stepped, and doubled over the overlap).
    """

    stations: int = 13
    moment_factor: float = 1.0
    active_section: Literal["weaker", "base", "tube"] = "weaker"

    def __post_init__(self) -> None:
        whole(self.stations, "stations", least=2, most=MOST_STATIONS)
        if self.active_section not in ("weaker", "base", "tube"):
            raise InputError(f"active_section {self.active_section!r} is not known. Write 'weaker', 'base' or 'tube'.")
        if not self.moment_factor > 0:
            raise InputError(f"moment_factor {self.moment_factor} must be greater than 0. Give for example 1.0.")


def utilisation(model: Model, forces: Forces, options: Options | None = None) -> xr.Dataset:
    """Demand over capacity of every part by every rule at every sample; each maximum along a part is located.

    Returns
    -------
    Dataset over (time, part, rule): ``value``, ``limit``, ``utilisation``, ``position`` (m from end A) and ``station``
    (fraction of the part's length from its end towards A) of the governing section; over (time, part)
    ``johnson``: True if Johnson's load governs buckling, not Euler's; ``euler``: Euler's load about the weaker axis, N.
    Coordinate ``member``. Parts are bars, and for an active member its whole (``NAME``), base and tube: the rods yield, the
    whole buckles. NaN where a rule does not apply.

    Notes
    -----
    yield: largest von Mises stress along the part over yield strength/`Safety.yielding`; torsion of arms and active members
    (`BodyCouple.member`) adds to it as in `stresses`, with the largest shear stress along the part.
    Beams follow the bars: ``yield`` by `strength.beams` at 97 sections or more, the demand of ``buckling`` without a limit.
    buckling: P, the largest compression along the member (0 if it is in tension everywhere), over P_cr/`Safety.buckling`,
    P_cr by Euler or Johnson for the member's length of that instant, its end conditions and its smallest second moment.
    beam-column: where P > 0, P n_b/P_cr + sum Cm M/((1 - n_b P/P_e) M_allow) with the largest bending moment along the
    member, M_allow = Sy/n_y I/c; round sections take the resultant moment, others add the two. Source: AISC, Allowable
    Stress Design (1989), eq. H1-1, with the safety factors of the model. Infinite where n_b P reaches P_e; the utilisation of
    buckling is then finite and at least 1.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> found = kt.strength.utilisation(model, forces)
    >>> found.utilisation.sel(part="tie", rule="yield").values.round(4).tolist()  # 1414 N/314 mm^2 over 235 MPa
    [0.0192]
    """
    found = utilised(model, forces, options).dataset
    return found.assign_coords(time=forces.whole.coords["time"]) if "pose" in forces.arrays else found


def utilised(model: Model, forces: Forces, options: Options | None = None) -> Arrays:
    """`utilisation` as plain arrays."""
    chosen = options or Options()
    given, parts, twist = histories(model, forces), parts_of(model), twisting(model, forces)
    length = forces.motion.arrays["length"].values[:, : len(parts.first)]
    found = _Found(len(length), parts, model.safety.yielding)
    for start in range(0, len(length), BATCH):
        cut = slice(start, start + BATCH)
        batch = _Batch(given.polynomials(cut), parts, length[cut], max(SPANS, chosen.stations - 1))
        _judge(model, batch, chosen, found, cut)
        if twist is not None:
            shear, _ = batch.peaks(np.where(parts.shape < 0, -1, ROUND), parts.scale[None] * (0, 0, 0, 1), path=False)
            found.stress[cut] = with_torsion(found.stress[cut], shear / math.sqrt(3), twist[cut])
    return _arrays(model, forces, length, found, beam_histories(model, forces, chosen.stations))


def twisting(model: Model, forces: Forces) -> NDArray[np.float64] | None:
    """Shear stress of torsion (times, parts), Pa; None without any."""
    torque = torsion_of(model, forces)
    return None if torque is None else shear_of_torsion(model, torque)


class _Found:
    """Results over (times, parts) for yield, (times, members) for the rest; filled batch by batch."""

    def __init__(self, count: int, parts: Parts, safety: float) -> None:
        shape, whole = (count, len(parts.names)), (count, len(parts.first))
        self.strength = parts.yield_strength / safety
        self.stress, self.stress_at = np.empty(shape), np.empty(shape)
        self.compression, self.compression_at = np.empty(whole), np.empty(whole)
        self.allowed, self.johnson, self.euler = np.empty(whole), np.zeros(whole, np.bool_), np.empty(whole)
        self.combined, self.moment_at = np.empty(whole), np.empty(whole)


class _Batch:
    """Section forces along the parts at some samples, and where the parts lie in their members."""

    def __init__(self, along: Polynomials, parts: Parts, length: NDArray[np.float64], spans: int) -> None:
        self.along, self.parts, self.spans, self.length = along, parts, spans, length
        self.start, self.span = parts.starts(length), parts.lengths(length)

    def peaks(
        self, measure: NDArray[np.int64], scale: NDArray[np.float64], path: bool
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Largest measure along every part and its distance from end A (times, parts)."""
        value, place = (np.empty(self.span.shape) for _ in range(2))
        overhang = self.parts.base if path else np.zeros_like(self.parts.base)
        peaks(self.along, measure, np.ascontiguousarray(scale), overhang, self.spans, value, place)
        return value, self.start + place * self.span

    def least_tension(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Least axial force along every part and its distance from end A (times, parts)."""
        value, place = (np.empty(self.span.shape) for _ in range(2))
        least_tension(self.along, self.parts.base, value, place)
        return value, self.start + place * self.span


def _judge(model: Model, batch: _Batch, options: Options, found: _Found, cut: slice) -> None:
    """Fill the samples of one batch."""
    parts, safety = batch.parts, model.safety.buckling
    found.stress[cut], found.stress_at[cut] = batch.peaks(parts.shape, parts.scale[None], path=False)
    tension, where = batch.least_tension()
    least, found.compression_at[cut] = _worst_part(parts, -tension, where)
    P = np.maximum(0.0, least)
    critical, euler2, euler3, johnson = _critical(model, parts, batch.length, options.active_section)
    found.allowed[cut], found.johnson[cut], found.euler[cut] = critical / safety, johnson, np.fmin(euler2, euler3)
    weights = np.zeros((*batch.span.shape, 4))
    for column, euler, fibre in ((1, euler2, parts.c3 / parts.I2), (2, euler3, parts.c2 / parts.I3)):
        larger = amplification(P, euler, options.moment_factor, safety)[:, parts.member]
        # an infinite factor is inserted afterwards: infinity times a zero moment is NaN
        weights[:, :, column] = np.where(np.isfinite(larger), larger, 0.0) * (fibre / found.strength)
    known = (parts.shape >= 0) & ~np.isnan(found.strength)
    measure = np.where(known, np.where(parts.shape == ROUND, MOMENT_RESULTANT, MOMENT_SUM), -1)
    bent, where = batch.peaks(measure, weights, path=True)
    moment, found.moment_at[cut] = _worst_part(parts, bent, where)
    P[:, parts.cable] = np.nan  # a slack cable neither buckles nor bends as a column
    found.compression[cut] = P
    beyond = safety * P >= found.euler[cut]
    combined = np.where(beyond, np.inf, P * safety / critical + moment)
    unknown = np.isnan(moment) | np.isnan(critical) | np.isnan(P)
    found.combined[cut] = np.where(unknown, np.nan, np.where(P > 0, combined, 0.0))


def _worst_part(
    parts: Parts, values: NDArray[np.float64], places: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Largest value over the parts of each member (times, members), NaN only where all are, and its place."""
    second = np.minimum(parts.first + 1, len(parts.names) - 1)
    a, b = values[:, parts.first], values[:, second]
    take = parts.two & ~(a >= b) & ~np.isnan(b)
    return np.where(take, b, a), np.where(take, places[:, second], places[:, parts.first])


def _critical(
    model: Model, parts: Parts, length: NDArray[np.float64], section: str
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """Critical load, Euler loads about axes 2 and 3 (times, members), N, and whether Johnson's load governs."""
    E = parts.E.copy()
    if section != "weaker":
        E[parts.first[parts.two] + (section == "base")] = np.nan
    C = _end_conditions(compile(model))[parts.member]
    long = length[:, parts.member]
    # C multiplies E I in both formulas
    smallest = np.minimum(parts.I2, parts.I3)
    load = critical_load(C * E, smallest, parts.area, long, parts.yield_strength)
    johnson = load < euler_load(C * E, smallest, long)
    second = np.minimum(parts.first + 1, len(parts.names) - 1)
    euler = [euler_load(C * E, about, long) for about in (parts.I2, parts.I3)]
    weak = [_weaker(parts, values, second) for values in (load, *euler)]
    chosen = np.where(weak[0] == load[:, parts.first], johnson[:, parts.first], johnson[:, second])
    return weak[0], weak[1], weak[2], chosen


def _weaker(parts: Parts, values: NDArray[np.float64], second: NDArray[np.int64]) -> NDArray[np.float64]:
    found: NDArray[np.float64] = np.where(parts.two, np.fmin(values[:, parts.first], values[:, second]), values[:, parts.first])
    return found


def _arrays(
    model: Model, forces: Forces, length: NDArray[np.float64], found: _Found, bent: dict[str, tuple[NDArray[np.float64], ...]]
) -> Arrays:
    """Rules side by side; subjects are bars, whole, base and tube of active members, and beams with what `bent` tells."""
    parts, (names, _, rod, whole) = parts_of(model), subjects(parts_of(model))
    shape = (len(length), len(names), len(RULES))
    value, limit, position = np.full(shape, np.nan), np.full(shape, np.nan), np.full(shape, np.nan)
    has_rod, has_whole = rod >= 0, whole >= 0
    k, r = whole[has_whole], rod[has_rod]
    value[:, has_rod, 0], limit[:, has_rod, 0], position[:, has_rod, 0] = (
        found.stress[:, r],
        found.strength[r],
        found.stress_at[:, r],
    )
    value[:, has_whole, 1], limit[:, has_whole, 1] = found.compression[:, k], found.allowed[:, k]
    position[:, has_whole, 1] = found.compression_at[:, k]
    value[:, has_whole, 2], limit[:, has_whole, 2], position[:, has_whole, 2] = found.combined[:, k], 1.0, found.moment_at[:, k]
    rods = np.maximum(rod, 0)
    start = np.where(has_rod, parts.starts(length)[:, rods], 0.0)
    span = np.where(has_rod, parts.lengths(length)[:, rods], length[:, np.maximum(whole, 0)])
    johnson, euler = np.zeros(shape[:2], np.bool_), np.full(shape[:2], np.nan)
    johnson[:, has_whole], euler[:, has_whole] = found.johnson[:, k], found.euler[:, k]
    station = (position - start[..., None]) / span[..., None]
    if len(beam_parts(model)):
        more = _beam_rows(model, bent)
        value, limit, position, station = (
            np.concatenate(pair, axis=1) for pair in zip((value, limit, position, station), more, strict=True)
        )
        columns, over = columns_of(compile(model)), more[0].shape[:2]
        johnson = np.concatenate([johnson, np.broadcast_to(columns.johnson, over)], axis=1)
        euler = np.concatenate([euler, np.broadcast_to(columns.euler.min(axis=1), over)], axis=1)
    over = ("time", "part", "rule")
    data = {
        "value": variable(over, value, "", "demand, in the rule's unit"),
        "limit": variable(over, limit, "", "allowed, in the rule's unit"),
        "utilisation": variable(over, value / limit, "", "demand over capacity"),
        "position": variable(over, position, "m", "distance of the governing section from end A"),
        "station": variable(over, station, "", "the same as a fraction of the part"),
        "johnson": variable(("time", "part"), johnson, "", "Johnson's load governs buckling"),
        "euler": variable(("time", "part"), euler, "N", "Euler's load about the weaker axis"),
    }
    attrs = {"kind": "utilisation", "load_case": forces.load_case}
    return Arrays(axes_of_verdict(compile(model)), forces.arrays["time"].values, data, attrs)


def _beam_rows(model: Model, bent: dict[str, tuple[NDArray[np.float64], ...]]) -> tuple[NDArray[np.float64], ...]:
    """Value, limit, position and station of beams by every rule, (times, beams, rules)."""
    (stress, stress_at), (push, push_at) = bent["stress"], bent["compression"]
    allowed, length = beam_limits(model)
    found = np.full((4, *stress.shape, len(RULES)), np.nan)
    found[0, :, :, 0], found[1, :, :, 0], found[3, :, :, 0] = stress, allowed, stress_at
    found[0, :, :, 1], found[3, :, :, 1] = np.where(push < 0, 0.0, push), push_at
    found[1, :, :, 1] = columns_of(compile(model)).critical / model.safety.buckling
    found[0, :, :, 2], found[3, :, :, 2] = bent["combined"]
    found[1, :, :, 2] = 1.0
    found[2] = found[3] * length[:, None]
    return tuple(found)


@cached(of_records=True)
def axes_of_verdict(system: System) -> Axes:
    """What is judged, and the rules."""
    names, members, _, _ = subjects(parts_of(system.given))
    beams = list(beam_parts(system.given))
    names, members = names + beams, members + beams
    return Axes(
        {
            "part": np.array(names, dtype=object).astype(str),
            "member": ("part", np.array(members, dtype=object).astype(str)),
            "rule": list(RULES),
            "unit": ("rule", list(RULES.values())),
        }
    )


@cached(of_records=True)
def _end_conditions(system: System) -> NDArray[np.float64]:
    """Of each real member, the constant of its end conditions."""
    return np.array([end_condition(member.buckling) for member in system.model.real_members.values()])


def subjects(parts: Parts) -> tuple[list[str], list[str], NDArray[np.int64], NDArray[np.int64]]:
    """Subjects of the check: names, members, index of the rod for yield (-1 none), of the member for buckling (-1 none)."""
    names, members, rod, whole = [], [], [], []
    for k, first in enumerate(parts.first):
        name = parts.members[first]
        if parts.two[k]:
            names += [name, *parts.names[first : first + 2]]
            members += [name] * 3
            rod += [-1, first, first + 1]
            whole += [k, -1, -1]
        else:
            names.append(name)
            members.append(name)
            rod.append(first)
            whole.append(k)
    return names, members, np.array(rod, np.int64), np.array(whole, np.int64)
