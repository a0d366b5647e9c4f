"""Coordinates of several nodes as arrays of a `System`: of hinge drives, angle drives in space, couplings, elements."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.numbers import size
from kinetruss.errors import InputError
from kinetruss.kernels.coordinates.forms import ALONG, AROUND, BESIDE, COSINE, FIXED_AXIS, NODE, OFFSET
from kinetruss.kernels.coordinates.on_arrays import gradient_on_arrays, value_on_arrays
from kinetruss.model import WholeModel, turns
from kinetruss.model.data import FORCE_ELEMENTS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.numbers import Array, Numbers


X, Y, Z = np.eye(3)
LARGEST_TEETH = 1000
"""Largest integer in the ratio of two factors."""
TURN = 2 * math.pi


def is_measured(model: WholeModel, drive: Any) -> bool:
    """True for drives whose coordinate is a sum of terms, not the length or the planar angle of one bar."""
    return drive.kind == "hinge" or (drive.kind == "angle" and model.dim == 3)


class Term(NamedTuple):
    """kind and places of a term; sign of its factor; its six numbers, of which the first may be a phase, or which are the axes
    of an angle from the line of a bar, p to q (indices of nodes).
    """

    kind: int
    at: list[int]
    numbers: tuple[float, ...] = (*X, *Y)
    sign: float = 1.0
    phase: bool = False
    line: tuple[Any, int, int] | None = None


class Period(NamedTuple):
    """step/whole turns of the part with the largest factor, a term, are the least change of a sum of angles."""

    largest: int
    step: int
    whole: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Measures:
    """Sums of terms. fields : those of `System` in which there are no numbers. data (t, 7) of the terms where they follow from
    no numbers. factors, phases : terms and which of the given ones each has; lines : terms with axes from the line of a bar.
    periods : of each sum, None if it has none; values : couplings whose value is given; turning : drives, to be within half a
    turn.
    """

    fields: dict[str, Any]
    data: NDArray[np.float64]
    factors: NDArray[np.int64]
    signs: NDArray[np.float64]
    phases: NDArray[np.int64]
    lines: dict[int, tuple[Any, int, int]]
    periods: tuple[Period | None, ...]
    values: NDArray[np.int64]
    driven: int


def measures_of(model: WholeModel, index: dict[str, int]) -> tuple[Measures, dict[str, Any]]:
    """The measures of a model: of drives, then of couplings, then of elements, in its order; and their numbers.

    Raises
    ------
    InputError : factors of the angles of an element that are in no ratio.
    """
    drives = {name: drive for name, drive in model.all_drives.items() if is_measured(model, drive)}
    names = tuple(drives)
    if not (drives or model.couplings or model.force_elements):
        return replace(
            _NO_MEASURES, fields=_NO_MEASURES.fields | {"drive_measure": np.full(len(model.all_drives), -1)}
        ), _NO_NUMBERS
    sums: list[tuple[Any, bool]] = [(((drive, 1.0),), False) for drive in drives.values()]
    sums += [(one.terms, True) for one in model.couplings.values()]
    sums += [(one.parts, one.terms is not None) for _, one in model.force_elements.values()]
    terms: list[Term] = []
    data: list[list[float]] = []
    ptr, factors, signs, given, phases, periods = [0], list[tuple[int, int]](), list[float](), list[float](), [], []
    for parts, stated in sums:
        turning = []
        for coordinate, factor in parts:
            if turns(coordinate):
                turning.append((len(terms), float(factor)))
            for one in _terms(model, index, coordinate):
                if stated:
                    factors.append((len(terms), len(given)))
                    signs.append(one.sign)
                if one.phase:
                    phases.append(len(terms))
                data.append([one.sign * float(factor), *one.numbers])
                terms.append(one)
            given += [float(factor)] if stated else []
        ptr.append(len(terms))
        periods.append(_period(turning))
    first = len(sums) - len(model.force_elements)
    for period, (name, (kind, one)) in zip(periods[first:], model.force_elements.items(), strict=True):
        if period is None and any(turns(part) for part, _ in one.parts):
            raise InputError(
                f"{FORCE_ELEMENTS[kind]}: {name}: the factors of its angles are in no ratio of whole numbers. Mend the factors."
            )
    values = {len(names) + k: one.value for k, one in enumerate(model.couplings.values()) if one.value is not None}
    fields = {
        "measures": names + tuple(model.couplings) + tuple(model.force_elements),
        "measure_ptr": np.array(ptr, np.int64),
        "term_kind": np.array([one.kind for one in terms], np.int64),
        "term_at": np.array([one.at for one in terms], np.int64).reshape(-1, 4),
        "drive_measure": np.array([names.index(name) if name in drives else -1 for name in model.all_drives], np.int64),
        "force_elements": tuple(model.force_elements),
        "force_element_measure": np.arange(first, len(sums)),
    }
    found = Measures(
        fields=fields,
        data=np.array(data, float).reshape(-1, 7),
        factors=np.array(factors, np.int64).reshape(-1, 2),
        signs=np.array(signs, float),
        phases=np.array(phases, np.int64),
        lines={t: one.line for t, one in enumerate(terms) if one.line is not None},
        periods=tuple(periods),
        values=np.array(list(values), np.int64),
        driven=len(names),
    )
    numbers = {"factor": given, "phase": found.data[found.phases, 1], "coupling_value": list(values.values())}
    return found, {name: np.array(own, float) for name, own in numbers.items()}


_NO_NUMBERS = dict.fromkeys(("factor", "phase", "coupling_value"), np.zeros(0))
_NO_MEASURES = Measures(
    fields={
        "measures": (),
        "measure_ptr": np.zeros(1, np.int64),
        "term_kind": np.zeros(0, np.int64),
        "term_at": np.zeros((0, 4), np.int64),
        "force_elements": (),
        "force_element_measure": np.zeros(0, np.int64),
    },
    data=np.zeros((0, 7)),
    factors=np.zeros((0, 2), np.int64),
    signs=np.zeros(0),
    phases=np.zeros(0, np.int64),
    lines={},
    periods=(),
    values=np.zeros(0, np.int64),
    driven=0,
)


def measure_arrays(measures: Measures, numbers: Numbers, x0: Array) -> dict[str, Any]:
    """The measures of `System` from numbers, at places x0 (n, 3)."""
    data = numbers.full(*measures.data.shape)
    period = numbers.full(len(measures.periods))
    if not len(measures.periods):
        none = dict.fromkeys(("measure_period", "measure_start", "measure_scale"), period)
        return measures.fields | none | {"term_data": data}
    data[:] = measures.data
    data[..., measures.factors[:, 0], 0] = measures.signs * numbers["factor"][..., measures.factors[:, 1]]
    data[..., measures.phases, 1] = numbers["phase"]
    for t, (drive, p, q) in measures.lines.items():
        data[..., t, 1:4], data[..., t, 4:7] = axes_of(drive, x0[..., q, :] - x0[..., p, :])
    for m, own in enumerate(measures.periods):
        if own is not None:
            factor = data[..., own.largest, 0]
            period[..., m] = TURN * (factor * np.sign(factor.real)) * own.step / own.whole
    found = {"term_data": data, "measure_period": period}
    return measures.fields | found | _starts(measures, numbers, data, period, x0)


def _starts(measures: Measures, numbers: Numbers, data: Array, period: Array, x0: Array) -> dict[str, Any]:
    """Start value and scale of every measure."""
    start, scale = numbers.full(len(measures.periods)), numbers.full(len(measures.periods))
    from kinetruss.kernels.structure.terms import nearest_turn

    turn = np.vectorize(nearest_turn, otypes=[float])
    for m, (value, length) in enumerate((_compiled if numbers.plain else _on_arrays)(measures.fields, data, x0)):
        here, whole = np.real(value), np.real(period[..., m])
        near = here if m >= measures.driven else turn(here, whole)
        turned = np.rint((here - near) / np.where(whole > 0.0, whole, 1.0))
        # less whole turns, as many as of the real part
        start[..., m] = near if numbers.plain else value - turned * period[..., m]
        sized = (np.real(length) > 0.0) & (np.real(length) < math.inf)
        scale[..., m] = np.where(sized, math.sqrt(2.0) / np.where(sized, length, 1.0), 1.0)
    start[..., measures.values] = numbers["coupling_value"]
    return {"measure_start": start, "measure_scale": scale}


def _compiled(fields: dict[str, Any], data: Array, x0: Array) -> Iterator[tuple[Any, Any]]:
    """Value and size of the gradient of every measure at x0 (n, 3)."""
    from kinetruss.kernels.coordinates.straight_line import addresses_of
    from kinetruss.kernels.structure.terms import measure_gradient, measure_value

    arrays, flat = (addresses_of(fields["term_kind"]), fields["term_at"], data), x0.reshape(-1)
    for span in pairwise(fields["measure_ptr"]):
        g = np.zeros(flat.size)
        measure_gradient(*arrays, *span, flat, g, np.zeros(24))
        yield measure_value(*arrays, *span, flat), np.linalg.norm(g)


def _on_arrays(fields: dict[str, Any], data: Array, x0: Array) -> Iterator[tuple[Any, Any]]:
    """The same of complex numbers and of copies, x0 (copies, n, 3)."""
    lead = x0.shape[:-2]
    flat = np.moveaxis(x0.reshape(*lead, -1), -1, 0)
    every = np.moveaxis(data, (-2, -1), (0, 1))
    kinds, places = fields["term_kind"].tolist(), fields["term_at"]
    for first, last in pairwise(fields["measure_ptr"]):
        total, g = np.zeros(lead), np.zeros_like(flat)
        for t in range(first, last):
            part = np.zeros((12, *lead), flat.dtype)
            total = total + value_on_arrays(kinds[t])(places[t], every[t], flat)
            gradient_on_arrays(kinds[t])(places[t], every[t], flat, part)
            np.add.at(g, (places[t][:, None] + np.arange(3)).reshape(-1), part)
        yield total, np.sqrt(np.add.reduce(g * g, axis=0))


def terms_of(
    model: WholeModel, index: dict[str, int], x0: NDArray[np.float64], one: Any, factor: float
) -> list[tuple[int, list[int], list[float]]]:
    """Kind, places and data of the terms of one coordinate."""
    found = []
    for term in _terms(model, index, one):
        numbers = term.numbers
        if term.line is not None:
            drive, p, q = term.line
            numbers = tuple(np.concatenate(axes_of(drive, x0[q] - x0[p])).tolist())
        found.append((term.kind, term.at, [term.sign * factor, *numbers]))
    return found


def _terms(model: WholeModel, index: dict[str, int], one: Any) -> list[Term]:
    """The terms of one coordinate."""

    def at(*names: str) -> list[int]:
        places = [3 * index[name] for name in names]
        return (places + [places[-1]] * 3)[:4]

    if one.kind == "coordinate":
        return [Term(NODE, at(one.node), (*np.eye(3)["xyz".index(one.axis)], *Y))]
    if one.kind == "cosine":
        return [Term(COSINE, at(one.node), (one.phase, 0.0, 0.0, *Y), phase=True)]
    if one.kind == "distance":
        return [Term(ALONG, at(one.nodes[1], one.nodes[0]))]
    if one.kind == "offset":
        if model.dim == 2:
            return [Term(OFFSET, at(one.point, *one.line))]
        shares = (0.0, 1.0) if one.axis is None else (1.0, 0.0)
        return [Term(BESIDE, at(one.point, *one.line), (*(one.axis or one.along), *shares, 0.0))]
    if one.kind == "hinge":
        if len(one.axis) == 1:
            return [Term(FIXED_AXIS, at(one.end, *one.axis)), Term(FIXED_AXIS, at(one.start, *one.axis), sign=-1.0)]
        return [Term(AROUND, at(one.end, *one.axis, one.start))]
    first, second = model.members[one.bar].ends
    if one.kind == "length":
        return [Term(ALONG, at(second, first))]
    places = at(second, first)
    return [Term(FIXED_AXIS, places, line=None if model.dim == 2 else (one, index[first], index[second]))]


def axes_of(drive: Any, d: Array) -> tuple[Array, Array]:
    """Unit vectors at angle 0 and at +90 deg of an angle about a fixed axis; d (3,) or (copies, 3): along the bar, m."""
    axis = np.array(drive.axis)
    reference = np.array(drive.reference) if drive.reference is not None else np.roll(axis, 1) if 1.0 in axis else d
    e1 = reference - (reference @ axis)[..., None] * axis
    e1 = e1 / size(e1)[..., None]
    return e1, np.cross(axis, e1)


def period_of(parts: Any) -> float | None:
    """After what change a sum of coordinates and factors is the same, 0: never; None if its angles are in no ratio."""
    turning = [(k, float(factor)) for k, (one, factor) in enumerate(parts) if turns(one)]
    if not turning:
        return 0.0
    found = _period(turning)
    return None if found is None else TURN * abs(parts[found.largest][1]) * found.step / found.whole


def _period(turning: list[tuple[int, float]]) -> Period | None:
    """Period of a sum of angles times factors (term, factor): its least change by whole turns of these; None if none."""
    largest, place = max(((abs(one), -t) for t, one in turning), default=(0.0, 0))
    if largest == 0.0:
        return None
    shares = [Fraction(one / largest).limit_denominator(LARGEST_TEETH) for _, one in turning]
    if any(abs(float(share) * largest - one) > 1e-9 * largest for share, (_, one) in zip(shares, turning, strict=True)):
        return None
    whole = math.lcm(*(share.denominator for share in shares))
    return Period(-place, reduce(math.gcd, (abs(int(share * whole)) for share in shares)), whole)
