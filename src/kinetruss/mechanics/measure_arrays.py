"""Coordinates of several nodes as arrays of a `System`: of hinge drives, angle drives in space, couplings, elements."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import reduce
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.coordinates.forms import ALONG, AROUND, COSINE, FIXED_AXIS, NODE, OFFSET
from kinetruss.model import WholeModel, turns
from kinetruss.model.data import FORCE_ELEMENTS

if TYPE_CHECKING:
    from numpy.typing import NDArray


X, Y, Z = np.eye(3)
LARGEST_TEETH = 1000
"""Largest integer in the ratio of two factors."""
TURN = 2 * math.pi
_OF_STARTS = ("measure_period", "measure_start", "measure_scale")


def is_measured(model: WholeModel, drive: Any) -> bool:
    """True for drives whose coordinate is a sum of terms, not the length or the planar angle of one bar."""
    return drive.kind == "hinge" or (drive.kind == "angle" and model.dim == 3)


def measure_arrays(model: WholeModel, index: dict[str, int], x0: NDArray[np.float64]) -> dict[str, Any]:
    """The measures of `System`: of drives, then of couplings, then of elements, in the order of the model."""
    sums: list[tuple[str, list[tuple[Any, float]], float | None]]
    sums = [(name, [(drive, 1.0)], None) for name, drive in model.all_drives.items() if is_measured(model, drive)]
    names = tuple(name for name, _, _ in sums)
    sums += [(name, list(one.terms), one.value) for name, one in model.couplings.items()]
    sums += [(name, list(one.parts), None) for name, (_, one) in model.force_elements.items()]
    terms: list[tuple[int, list[int], list[float]]] = []
    ptr = [0]
    for _, parts, _ in sums:
        for coordinate, factor in parts:
            terms += terms_of(model, index, x0, coordinate, float(factor))
        ptr.append(len(terms))
    found: dict[str, Any] = {
        "measures": names + tuple(model.couplings) + tuple(model.force_elements),
        "measure_ptr": np.array(ptr, np.int64),
        "term_kind": np.array([kind for kind, _, _ in terms], np.int64),
        "term_at": np.array([at for _, at, _ in terms], np.int64).reshape(-1, 4),
        "term_data": np.array([data for _, _, data in terms], float).reshape(-1, 7),
        "drive_measure": np.array([names.index(name) if name in names else -1 for name in model.all_drives], np.int64),
    }
    found |= _starts(model, found, sums, x0) if sums else {name: np.zeros(0) for name in _OF_STARTS}
    first = len(sums) - len(model.force_elements)
    for m, (name, (kind, one)) in enumerate(model.force_elements.items(), first):
        if found["measure_period"][m] == 0.0 and any(turns(part) for part, _ in one.parts):
            raise InputError(
                f"{FORCE_ELEMENTS[kind]}: {name}: the factors of its angles are in no ratio of whole numbers. Mend the factors."
            )
    return found | {"force_elements": tuple(model.force_elements), "force_element_measure": np.arange(first, len(sums))}


def _starts(model: WholeModel, found: dict[str, Any], sums: list[Any], x0: NDArray[np.float64]) -> dict[str, Any]:
    """Scale, period and start value of every measure."""
    from kinetruss.kernels.coordinates.straight_line import addresses_of
    from kinetruss.kernels.structure.terms import measure_gradient, measure_value, nearest_turn

    arrays, ptr = (addresses_of(found["term_kind"]), found["term_at"], found["term_data"]), found["measure_ptr"]
    driven = len(sums) - len(model.couplings) - len(model.force_elements)
    flat, period, start, scale = x0.reshape(-1), [], [], []
    for m, (_, parts, value) in enumerate(sums):
        period.append(_period([float(factor) for one, factor in parts if turns(one)]))
        here = measure_value(*arrays, ptr[m], ptr[m + 1], flat)
        start.append(float(value) if value is not None else here if m >= driven else nearest_turn(here, period[-1]))
        g = np.zeros(flat.size)
        measure_gradient(*arrays, ptr[m], ptr[m + 1], flat, g, np.zeros(24))
        size = float(np.linalg.norm(g))
        scale.append(math.sqrt(2.0) / size if 0.0 < size < math.inf else 1.0)
    return dict(zip(_OF_STARTS, (np.array(period), np.array(start), np.array(scale)), strict=True))


def terms_of(
    model: WholeModel, index: dict[str, int], x0: NDArray[np.float64], one: Any, factor: float
) -> list[tuple[int, list[int], list[float]]]:
    """Kind, places and data of the terms of one coordinate."""

    def at(*names: str) -> list[int]:
        places = [3 * index[name] for name in names]
        return (places + [places[-1]] * 3)[:4]

    plane = [factor, *X, *Y]
    if one.kind == "coordinate":
        return [(NODE, at(one.node), [factor, *np.eye(3)["xyz".index(one.axis)], *Y])]
    if one.kind == "cosine":
        return [(COSINE, at(one.node), [factor, one.phase, 0.0, 0.0, *Y])]
    if one.kind == "offset":
        return [(OFFSET, at(one.point, *one.line), plane)]
    if one.kind == "hinge":
        if len(one.axis) == 1:
            return [(FIXED_AXIS, at(one.end, *one.axis), plane), (FIXED_AXIS, at(one.start, *one.axis), [-factor, *X, *Y])]
        return [(AROUND, at(one.end, *one.axis, one.start), plane)]
    first, second = model.members[one.bar].ends
    if one.kind == "length":
        return [(ALONG, at(second, first), plane)]
    e1, e2 = (X, Y) if model.dim == 2 else axes_of(one, x0[index[second]] - x0[index[first]])
    return [(FIXED_AXIS, at(second, first), [factor, *e1, *e2])]


def axes_of(drive: Any, d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Unit vectors at angle 0 and at +90 deg of an angle about a fixed axis; d : along the bar, m."""
    axis = np.array(drive.axis)
    reference = np.array(drive.reference) if drive.reference is not None else np.roll(axis, 1) if 1.0 in axis else d
    e1 = reference - (reference @ axis) * axis
    e1 = e1 / np.linalg.norm(e1)
    return e1, np.cross(axis, e1)


def _period(factors: list[float]) -> float:
    """Period of a sum of factors times angles: its least change by whole turns of these; 0 if there is none."""
    largest = max((abs(one) for one in factors), default=0.0)
    if largest == 0.0:
        return 0.0
    shares = [Fraction(one / largest).limit_denominator(LARGEST_TEETH) for one in factors]
    if any(abs(float(share) * largest - one) > 1e-9 * largest for share, one in zip(shares, factors, strict=True)):
        return 0.0
    whole = math.lcm(*(share.denominator for share in shares))
    step = reduce(math.gcd, (abs(int(share * whole)) for share in shares))
    return TURN * largest * step / whole
