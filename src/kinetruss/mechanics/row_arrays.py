"""Prescribed lengths, angles and sums of a model, and where its drives start."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.coordinates.on_arrays import angle_of
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SUM
from kinetruss.mechanics.members import DRIVEN, RIGID
from kinetruss.model import AngleDrive, CoordinateDrive, LengthDrive, WholeModel

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.numbers import Array, Numbers


AXIS = {"x": 0, "y": 1, "z": 2}


@dataclass(frozen=True, kw_only=True, eq=False)
class Rows:
    """fields : those of `System` in which there are no numbers. kept : members whose length the first rows prescribe; held :
    rows of couplings, with the measures that they hold. starts : by what drives move (SUM, ANGLE, LENGTH or PLACE) drives,
    and measures, members or flat coordinates.
    """

    fields: dict[str, Any]
    kept: NDArray[np.int64]
    held: NDArray[np.int64]
    starts: dict[int, NDArray[np.int64]]


PLACE = -1


def rows_of(model: WholeModel, index: dict[str, int], kind: NDArray[np.int8], drive_measure: NDArray[np.int64]) -> Rows:
    """The rows of a model, of whose members `kind` are the kinds, and of whose drives `drive_measure` the measures."""
    place = {name: i for i, name in enumerate(model.members)} if model.all_drives else {}
    driven = np.full(len(kind), -1)
    rows: list[tuple[int, int, int, int]] = []
    starts: dict[int, list[tuple[int, int]]] = {SUM: [], ANGLE: [], LENGTH: [], PLACE: []}
    for d, (drive, m) in enumerate(zip(model.all_drives.values(), drive_measure.tolist(), strict=True)):
        if m >= 0:
            rows.append((0, SUM, d, m))
            starts[SUM].append((d, m))
        elif isinstance(drive, AngleDrive):
            rows.append((place[drive.bar], ANGLE, d, -1))
            starts[ANGLE].append((d, place[drive.bar]))
        elif isinstance(drive, CoordinateDrive):
            starts[PLACE].append((d, 3 * index[drive.node] + AXIS[drive.axis]))
        elif isinstance(drive, LengthDrive):
            driven[place[drive.bar]] = d
            starts[LENGTH].append((d, place[drive.bar]))
    kept = np.flatnonzero((kind == RIGID) | (kind == DRIVEN))
    first = len(starts[SUM])
    held = [(len(kept) + len(rows) + k, first + k) for k in range(len(model.couplings))]
    rows += [(0, SUM, -1, m) for _, m in held]
    every = np.full((4, len(kept) + len(rows)), -1)
    every[0, : len(kept)], every[1, : len(kept)], every[2, : len(kept)] = kept, LENGTH, driven[kept]
    if rows:
        every[:, len(kept) :] = np.array(rows, np.int64).T
    fields: dict[str, Any] = {name: own.astype(size) for (name, size), own in zip(_FIELDS, every, strict=True)}
    fields["coordinate_drive"] = np.array([(flat, d) for d, flat in starts[PLACE]], np.int32).reshape(-1, 2)
    places = {what: np.array(own, np.int64) if own else _NONE for what, own in starts.items()}
    return Rows(fields=fields, kept=kept, held=np.array(held, np.int64) if held else _NONE, starts=places)


_FIELDS = (("row_member", np.int32), ("row_kind", np.int8), ("row_drive", np.int32), ("row_measure", np.int64))
_NONE = np.zeros((0, 2), np.int64)


def row_arrays(
    rows: Rows, numbers: Numbers, x0: Array, ends: tuple[Any, Any], length0: Array, measure_start: Array
) -> dict[str, Any]:
    """Rows of `System` from numbers; at places x0 (n, 3) of members from p to q, the ends (m,)."""
    value, start = numbers.full(len(rows.fields["row_kind"])), numbers.full(sum(map(len, rows.starts.values())))
    value[..., : len(rows.kept)] = length0[..., rows.kept]
    value[..., rows.held[:, 0]] = measure_start[..., rows.held[:, 1]]
    if not start.size:
        return rows.fields | {"row_value": value, "drive_start": start}
    flat = x0.reshape(*numbers.lead, -1)
    for what, source in ((SUM, measure_start), (LENGTH, length0), (PLACE, flat)):
        drive, at = rows.starts[what].T
        start[..., drive] = source[..., at]
    drive, bars = rows.starts[ANGLE].T
    d = x0[..., ends[1][bars], :] - x0[..., ends[0][bars], :]
    start[..., drive] = angle_of(d[..., 1], d[..., 0])
    return rows.fields | {"row_value": value, "drive_start": start}
