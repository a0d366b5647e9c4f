"""The envelope of drives and their trains over pairs."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from kinetruss import actuators
from kinetruss.actuators.demand_summary import QUANTITIES
from kinetruss.display.ranks import place_of_largest
from kinetruss.model import Model, turns
from kinetruss.results import Forces, Row, variable
from kinetruss.runs.joining import DemandAccumulator

DRIVE = ("force", "rate", "power", "rms force", "energy", "holding")
"""Of every drive: the largest |force or torque|, |rate| and |power|, the root mean square of the force, the energy that it
gives (J, braking not counted), and the largest |force| at instants of rest."""
TRAIN = (*QUANTITIES, "holding torque", "electrical power", "drawn energy")
"""Of every screw, gear and motor."""
COLUMNS = ("value", "utilisation", "limit", "time_of", "pair")
STILL = 1e-9


class PairDrives:
    """The drives of one pair, block by block."""

    def __init__(self, model: Model) -> None:
        self.model = model
        shape = (len(model.all_drives), len(DRIVE))
        self.value, self.time = np.zeros(shape), np.full(shape, np.nan)
        self._squares, self._duration = np.zeros(shape[0]), 0.0
        self._last: tuple[float, NDArray[np.float64], NDArray[np.float64]] | None = None
        self.train = DemandAccumulator()
        self.trained = any(
            getattr(one, kind, None) is not None for one in model.actuators.values() for kind in ("screw", "motor")
        )
        self.peaks = {name: np.zeros(len(model.actuators)) for name in ("holding_torque", "electrical_power")}

    def add(self, forces: Forces) -> None:
        """Take a block into account."""
        t, force = forces.arrays["time"].values, forces.arrays["drive_force"].values
        rate = forces.motion.arrays["drive_velocity"].values
        if forces.attrs.get("at_rest", 0):
            rate = np.zeros_like(rate)
        if len(t) and force.shape[1]:
            self._plain(t, force, rate)
        if self.trained and len(t):
            demand = actuators.evaluate(self.model, forces.motion, forces)
            self.train.add(self.model, demand)
            for name, most in self.peaks.items():
                np.fmax(most, np.nan_to_num(np.abs(demand.arrays[name].values)).max(axis=0), out=most)

    @property
    def begun(self) -> bool:
        """True if there are drives and samples."""
        return self._last is not None

    def _plain(self, t: NDArray[np.float64], force: NDArray[np.float64], rate: NDArray[np.float64]) -> None:
        held = np.where(np.abs(rate).max(axis=1, keepdims=True) < STILL, np.abs(force), 0.0)
        for k, values in ((0, np.abs(force)), (1, np.abs(rate)), (2, np.abs(force * rate)), (5, held)):
            at = place_of_largest(values, axis=0)
            most = values[at, np.arange(values.shape[1])]
            new = (most > self.value[:, k]) | np.isnan(self.time[:, k])
            self.value[new, k], self.time[new, k] = most[new], t[at][new]
        # trapezoidal rule, the interval between blocks included
        if self._last is not None:
            before, first, second = self._last
            t, force, rate = np.append(before, t), np.vstack([first, force]), np.vstack([second, rate])
        step, given = np.diff(t)[:, None], np.maximum(force * rate, 0.0)
        self._squares += (0.5 * step * (force[1:] ** 2 + force[:-1] ** 2)).sum(axis=0)
        self.value[:, 4] += (0.5 * step * (given[1:] + given[:-1])).sum(axis=0)
        self._duration += float(t[-1] - t[0])
        self.value[:, 3] = np.sqrt(self._squares / self._duration) if self._duration else np.abs(force[-1])
        self._last = (float(t[-1]), force[-1:], rate[-1:])


class DriveEnvelope:
    """The worst of every drive and train over pairs: ``drives`` (drives, quantities, columns), ``trains`` likewise."""

    def __init__(self, model: Model) -> None:
        self._drives, self._trains = list(model.all_drives), list(model.actuators)
        self.drives = np.full((len(self._drives), len(DRIVE), len(COLUMNS)), np.nan)
        self.trains = np.full((len(self._trains), len(TRAIN), len(COLUMNS)), np.nan)

    def add(self, found: PairDrives, pair: int) -> None:
        """Take a pair that is done into account."""
        if found.begun:
            own = [self._drives.index(name) for name in found.model.all_drives]
            none = np.full_like(found.value, np.nan)
            _raise(self.drives, own, (found.value, none, none, found.time), pair)
        summary = found.train.summary
        if summary is None:
            return
        own = [self._trains.index(name) for name in found.model.actuators]
        more = np.stack([*found.peaks.values(), summary["drawn_energy"].values], axis=1)
        none = np.full_like(more, np.nan)
        columns = [
            np.hstack([summary[name].values, extra])
            for name, extra in (("value", more), ("utilisation", none), ("limit", none), ("time_of", none))
        ]
        _raise(self.trains, own, tuple(columns), pair)


def _raise(table: NDArray[np.float64], own: Sequence[int], found: tuple[NDArray[np.float64], ...], pair: int) -> None:
    """Entries that are larger than those kept; a utilisation counts before a value."""
    value, utilisation = found[:2]
    kept = table[own]
    score, before = (np.where(np.isnan(b), a, b) for a, b in ((value, utilisation), (kept[..., 0], kept[..., 1])))
    new = (score > before) | (np.isnan(before) & ~np.isnan(score))
    kept[new] = np.stack([*found, np.full_like(value, pair)], axis=-1)[new]
    table[own] = kept


def drives_of(model: Model, found: DriveEnvelope, labels: Sequence[str]) -> dict[str, xr.Dataset]:
    """``drives`` over (drive, quantity) and, where there are trains, ``trains`` over (active, quantity)."""
    tables = {"drives": _table(found.drives, "drive", list(model.all_drives), DRIVE, labels)}
    units = [_unit(turns(drive), what) for drive in model.all_drives.values() for what in DRIVE]
    shaped = np.array(units, dtype=str).reshape(-1, len(DRIVE))  # also (0, quantities): a structure without drives
    tables["drives"]["unit"] = variable(("drive", "quantity"), shaped, "", "unit of value and limit")
    if not np.isnan(found.trains).all():
        tables["trains"] = _table(found.trains, "active", list(model.actuators), TRAIN, labels)
    return tables


def train_rows(trains: xr.Dataset) -> list[Row]:
    """The checks of screws, gears and motors over all pairs; ``load_case`` is the label of the governing pair."""
    found = []
    for i, name in enumerate(trains["active"].values.tolist()):
        for j, what in enumerate(QUANTITIES):
            one = {key: trains[key].values[i, j] for key in (*COLUMNS[:4], "label")}
            used, note = float(one["utilisation"]), "" if one["limit"] == one["limit"] else "no limit given"
            if one["value"] == one["value"]:
                found.append(
                    Row(
                        part=str(name), member=str(name), rule=what, unit=QUANTITIES[what][0], note=note,
                        value=float(one["value"]), limit=float(one["limit"]), utilisation=used,
                        margin=1 / used - 1 if used else math.inf, time=float(one["time_of"]), load_case=str(one["label"]),
                    )
                )  # fmt: skip
    return found


def _unit(angle: bool, what: str) -> str:
    force, rate = ("N m", "rad/s") if angle else ("N", "m/s")
    return {"rate": rate, "power": "W", "energy": "J"}.get(what, force)


def _table(
    values: NDArray[np.float64], rows: str, names: list[str], quantities: Sequence[str], labels: Sequence[str]
) -> xr.Dataset:
    over = (rows, "quantity")
    words = ("largest magnitude", "value over limit", "limit", "time of it, in the motion of its pair", "governing pair")
    data = {name: variable(over, values[..., k], "s" if k == 3 else "", words[k]) for k, name in enumerate(COLUMNS)}
    every = np.array([*labels, ""], dtype=object)
    pair = np.where(np.isnan(values[..., 4]), len(labels), np.nan_to_num(values[..., 4])).astype(np.int64)
    data["label"] = variable(over, every[pair].astype(str), "", "governing pair: motion, condition, load case")
    coords = {rows: np.array(names, dtype=object).astype(str), "quantity": list(quantities)}
    return xr.Dataset(data, coords=coords, attrs={"kind": f"mission {rows}"})
