"""The quantities of a run by load case, and whether the limits that a model gives them and deflections are kept."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NoReturn, Protocol

import numpy as np

from kinetruss.errors import shown
from kinetruss.kinematics.quantity_histories import quantities
from kinetruss.model import Model, ReadOnly, nearest
from kinetruss.model.load_cases import applies_in
from kinetruss.model.quantities import needs_forces
from kinetruss.results.wide_tables import NOT_CHECKED, Row
from kinetruss.strength.deflection_limits import KINDS, deflections, unchecked_row

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.results import Forces, Motion, Result


ONE_MOTION = "one_motion"
"""Attribute of the quantities of load cases that have the same motion."""


UNKNOWN = "deflections are known of a structure at rest in its place, by statics.linear or statics.equilibrium"


class Ran(Protocol):
    """What of a run its quantities rest on."""

    @property
    def model(self) -> Model: ...  # noqa: D102

    @property
    def motion(self) -> Motion: ...  # noqa: D102

    @property
    def statics(self) -> Mapping[str, Result]: ...  # noqa: D102

    @property
    def forces(self) -> Mapping[str, Forces]: ...  # noqa: D102


class ByCase(ReadOnly[str, Any]):
    """The quantities of each load case."""

    __slots__ = ()

    def __missing__(self, key: object) -> NoReturn:
        if not self:
            raise KeyError(f"{shown(key)}: the run has no quantities, or no good sample.")
        case, names = next(iter(self)), next(iter(self.values()))["quantity"].values.astype(str).tolist()
        if key in names:
            raise KeyError(f"{shown(key)} is a quantity. Write run.quantities[{case!r}].value.sel(quantity={key!r}).")
        raise KeyError(f"{shown(key)} is neither a load case nor a quantity. {nearest(key, [*self, *names])}")


def quantities_of(run: Ran) -> dict[str, xr.Dataset]:
    """The quantities of a run by load case, as of `kinematics.quantities`; under ``all`` those of a motion that does not depend
    on the case, if none of them needs forces. Empty if the model defines none, or no sample is good.
    """
    if not run.model.quantities or not run.motion.arrays["time"].values.size:
        return ByCase({})
    # of linear statics and equilibria the positions are those under the loads of the case
    placed: dict[str, Result] = {
        case: one for case, one in run.statics.items() if one.attrs.get("kind") in ("linear", "equilibrium")
    }
    if placed:
        return ByCase({case: quantities(run.model, one, forces=run.forces.get(case)) for case, one in placed.items()})
    loaded = run.forces if any(needs_forces(run.model, name) for name in run.model.quantities) else {}
    return ByCase(
        {
            case: quantities(run.model, run.motion, forces=loaded.get(case)).assign_attrs({ONE_MOTION: 1})
            for case in loaded or ("all",)
        }
    )


def entries(model: Model, found: Mapping[str, xr.Dataset]) -> Iterator[tuple[str, xr.Dataset, int, str]]:
    """Load case, dataset, place and name of quantities; of one motion those that do not depend on the case once, as ``all``."""
    for case, data in found.items():
        for k, name in enumerate(map(str, data["quantity"].values)):
            if len(found) == 1 or ONE_MOTION not in data.attrs or needs_forces(model, name):
                yield case, data, k, name
            elif data is next(iter(found.values())):
                yield "all", data, k, name


def limits_of(model: Model, name: str, case: str) -> tuple[float | None, float | None] | None:
    """The limits of a quantity in a load case, or None if there are none."""
    one = model.quantities[name]
    return one.limits if applies_in(model, one.load_cases, case) else None


def limit_rows(model: Model, found: Mapping[str, xr.Dataset]) -> Iterator[Row]:
    """A row for each quantity that has limits, and load case: its worst value and the limit next to it.

    Utilisation : of two limits the distance from their middle over half their range. Of a largest value above 0 or a least one
    below, the value over it, at least 0; of the others the limit over the value; of a limit 0, 0 or infinite.
    """
    for case, data, k, name in entries(model, found):
        if (limits := limits_of(model, name, case)) is None:
            continue
        time = data["time"].values if "time" in data.coords else np.zeros(1)
        values = data["value"].values[:, k] if "time" in data.coords else data["value"].values[k : k + 1]
        used, why = _used(values, *limits), f"its value is not known at {np.isnan(values).sum()} of {len(values)} samples"
        if np.isnan(used).any():
            if np.isnan(used).all() and needs_forces(model, name):
                why = "it needs forces that the run does not have"
            yield _row(data, k, case, note=f"{NOT_CHECKED}{why}")
        if not np.isnan(used).all():
            at = int(np.nanargmax(used))
            yield _row(
                data, k, case, float(used[at]), float(values[at]), limits, float(time[at]) if len(time) > 1 else math.nan
            )


def unchecked_rows(model: Model, why: str) -> Iterator[Row]:
    """A row, not checked, for each quantity and deflection that has limits, where there are no values to check."""
    for name, one in model.quantities.items():
        if one.limits is not None:
            none: dict[str, Any] = dict.fromkeys(("value", "limit", "utilisation", "margin", "time"), math.nan)
            yield Row(part=name, member=name, rule="limit", unit="", note=f"{NOT_CHECKED}{why}", **none)
    for name, limit in model.deflections.items():
        yield unchecked_row(name, limit, why)


def deflection_rows(run: Ran, *, moved: bool) -> Iterator[Row]:
    """A row for each deflection that has a limit, and load case in which this applies; not checked where it is not known.

    moved : whether drives move the structure from the place of the model.
    """
    known = {case: one for case, one in run.statics.items() if one.attrs.get("kind") in KINDS and not moved}
    rows = [row for one in known.values() for row in deflections(run.model, one)] if run.model.deflections else []
    yield from rows
    why = "none of its load cases is in this run" if known else UNKNOWN
    checked = {row.part for row in rows}
    for name, one in run.model.deflections.items():
        if (lacking := unchecked_row(name, one, why)).part not in checked:
            yield lacking


def _row(
    data: xr.Dataset,
    k: int,
    case: str,
    used: float = math.nan,
    value: float = math.nan,
    limits: tuple[float | None, float | None] = (None, None),
    time: float = math.nan,
    note: str = "",
) -> Row:
    """The row of quantity k; of two limits that is shown which is nearer to its value."""
    name, known = str(data["quantity"].values[k]), [one for one in limits if one is not None]
    return Row(
        part=name,
        member=name,
        rule="limit",
        value=value,
        limit=float(min(known, key=lambda one: abs(value - one))) if known else math.nan,
        unit=str(data["quantity_unit"].values[k]),
        utilisation=used,
        margin=math.inf if used == 0 else 1 / used - 1,
        time=time,
        load_case=case,
        note="beyond its limit" if math.isinf(used) else note,
    )


def _used(values: NDArray[np.float64], low: float | None, high: float | None) -> NDArray[np.float64]:
    if low is not None and high is not None:
        return np.abs(values - 0.5 * (low + high)) / (0.5 * (high - low))
    if high is None:  # a least value is the largest one of what is measured the other way
        values, high = -values, -low  # type: ignore[operator]
    with np.errstate(divide="ignore", invalid="ignore"):
        if high > 0:
            used = np.maximum(values / high, 0.0)
        elif high < 0:
            used = np.where(values < 0, high / values, np.inf)
        else:
            used = np.where(values <= high, 0.0, np.inf)
    return np.where(np.isnan(values), np.nan, used)
