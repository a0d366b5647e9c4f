"""Two models of one structure in one table: ideal joints beside hubs, friction, compliance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, number, quantity
from kinetruss.errors import InputError
from kinetruss.model import turns
from kinetruss.report._page import Page
from kinetruss.results.records import check_samples
from kinetruss.strength import sections, stresses

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.results import Forces

__all__ = ["Both", "beside"]

HEAD = ("quantity", "of", "ideal", "real", "difference", "ratio")
ROUND_OFF = 1e-12
"""Share of the largest value of a quantity up to which another one is round-off."""
UNITS = {"member_force": "N", "drive_force": "N", "von_mises": "Pa", "position": "m"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Both:
    """One quantity of one member, drive, part or node in both models.

    ideal, real : the values of largest magnitude along the motion, with sign; None for places. difference : the largest
    difference at one instant; of places the largest distance. ratio : of the magnitudes, real over ideal; None if that is
    round-off beside the largest of the quantity.
    """

    quantity: str
    of: str
    unit: str
    ideal: float | None
    real: float | None
    difference: float
    ratio: float | None


def beside(ideal: tuple[Model, Forces], real: tuple[Model, Forces]) -> Page:
    """Forces, stresses and places of two models of one structure, by the names that both have.

    Parameters
    ----------
    ideal, real : a model and its forces, from `dynamics.inverse`, at the same instants. The second may have hubs, bearings and
        what else is real.

    Returns
    -------
    A page with one `Both` per quantity and name, those of each quantity by falling difference: ``member_force`` (mean over the
    length, N), ``drive_force`` (N or N m), ``von_mises`` (largest over the stations of a part, Pa), ``position`` (m).

    Raises
    ------
    InputError : other instants; nothing in common.

    >>> import kinetruss as kt
    >>> arm = kt.Model(nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=3)}, fixed=["O"], bars={"arm": ("O", "A")},
    ...                drives={"turn": kt.AngleDrive("arm")}, gravity=(0, -9.81))
    >>> rough = arm.with_(bearings={"pin": kt.Bearing(member="arm", node="O", radius=0.03, friction=0.2)})
    >>> motion = kt.kinematics.follow(arm, kt.ConstantRate(rates={"turn": 1}, duration=0.5), samples=3)
    >>> found = kt.report.beside(*((one, kt.dynamics.inverse(one, motion)) for one in (arm, rough)))
    >>> print(found.text.splitlines()[2])
    drive_force   turn  14.71 N m  14.89 N m  176.8 mN m  1.012
    """
    (one, first), (two, second) = ideal, real
    check_samples(first)
    if not np.array_equal(first.arrays["time"].values, second.arrays["time"].values):
        raise InputError("The two have other instants. Follow the same trajectory with the same samples.")
    found: list[Both] = []
    for name, axis in (("member_force", "member"), ("drive_force", "drive")):
        pair = [_columns(forces.arrays[axis].values, forces.arrays[name].values) for forces in (first, second)]
        found += _both(name, pair)
    moments = {name for name, drive in one.all_drives.items() if turns(drive)}
    found = [replace(row, unit="N m") if row.quantity == "drive_force" and row.of in moments else row for row in found]
    braces = {name for model in (one, two) for name, bar in model.bars.items() if bar.brace}
    found = [row for row in found if row.of not in braces]
    found += _both("von_mises", [_stress(model, forces) for model, forces in (ideal, real)])
    places = [
        _columns(forces.motion.arrays["node"].values, forces.motion.arrays["position"].values) for forces in (first, second)
    ]
    found += _both("position", places)
    if not found:
        raise InputError("The two models have no member, drive or node in common.")
    return Page(found=found, as_record=_records, as_text=_text, as_rows=_rows)


def _stress(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Largest von Mises stress over the stations of every part with a section, (times,) Pa."""
    data = stresses(model, sections(model, forces)).von_mises
    values = data.values.max(axis=2)
    return {name: values[:, k] for k, name in enumerate(data["part"].values.tolist()) if np.isfinite(values[:, k]).all()}


def _columns(names: Any, values: Any) -> dict[str, NDArray[np.float64]]:
    return {name: values[:, k] for k, name in enumerate(names.tolist())}


def _both(name: str, pair: Sequence[dict[str, NDArray[np.float64]]]) -> list[Both]:
    """The rows of one quantity, by falling difference."""
    rows = []
    largest = max((float(np.abs(values).max()) for values in pair[0].values()), default=0.0)
    for of in pair[0]:
        if of not in pair[1]:
            continue
        one, two = pair[0][of], pair[1][of]
        if one.ndim == 2:
            away = float(np.linalg.norm(two - one, axis=1).max())
            rows.append(Both(quantity=name, of=of, unit="m", ideal=None, real=None, difference=away, ratio=None))
            continue
        first, second = (float(values[np.argmax(np.abs(values))]) for values in (one, two))
        rows.append(
            Both(
                quantity=name,
                of=of,
                unit=UNITS[name],
                ideal=first,
                real=second,
                difference=float(np.abs(two - one).max()),
                ratio=abs(second / first) if abs(first) > ROUND_OFF * largest else None,
            )
        )
    return sorted(rows, key=lambda row: -row.difference)


def _text(found: Sequence[Both]) -> str:
    return Table(HEAD, map(_cells, found)).text


def _cells(one: Both) -> tuple[str, ...]:
    values = ["-" if value is None else quantity(value, one.unit) for value in (one.ideal, one.real, one.difference)]
    return one.quantity, one.of, *values, "-" if one.ratio is None else number(one.ratio, 4)


def _records(found: Sequence[Both]) -> list[dict[str, Any]]:
    return [{name: getattr(one, name) for name in one.__slots__} for one in found]


def _rows(found: Sequence[Both]) -> Iterator[list[Any]]:
    yield list(Both.__slots__)
    for one in found:
        yield ["" if getattr(one, name) is None else getattr(one, name) for name in Both.__slots__]
