"""What a kind of load consists of."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinetruss.elements.caching import cached

if TYPE_CHECKING:
    from kinetruss.elements.beams import BeamElements
    from kinetruss.kernels.compiled.record import Record
    from kinetruss.mechanics.bars import Bars
    from kinetruss.mechanics.system import System

STEP = 1e-30


class Spread(NamedTuple):
    """From `begin` to `end` of a member, as fractions from A: a force that changes linearly, so that it has the given forces at
    the ends of the member; or one, or a `couple`, whose amount a length has at both ends a known `ratio` to the mean.
    """

    begin: float = 0.0
    end: float = 1.0
    ratio: tuple[float, float] | None = None
    couple: bool = False


class OnMember(NamedTuple):
    """Where a load acts on a member, an index: at a fraction from end A, or spread."""

    member: int
    place: float | Spread


class OnOthers(NamedTuple):
    """Nodes on which a load acts that no one bar joins, and the members there whose bending is not known; names."""

    nodes: tuple[str, ...]
    members: tuple[str, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class UnitLoad(ABC):
    """The forces on `nodes` (k,) of one component of a load, of the amount 1, by data (k, w).

    Of those that depend on positions: kernel, with the interface kernels.structure.element_table.force, on the record of all of
    a class: node[ptr[k]:ptr[k + 1]] flat coordinates of the nodes of load k, data of these, value at time, s, from table_ptr[k]
    on; and `own`, the other fields, one entry a load.
    """

    kernel: ClassVar[Any]
    record: ClassVar[Any]
    own: ClassVar[tuple[str, ...]]
    nodes: NDArray[np.int64]
    data: NDArray[np.float64]

    @classmethod
    def table(cls, loads: Sequence[Turning]) -> Record:
        """The record of loads of this class."""
        units: list[Any] = [one.load for one in loads]
        made: Record = cls.record.of(
            {name: np.array([getattr(one, name) for one in units]) for name in cls.own}
            | {
                "ptr": np.cumsum([0, *(len(one.nodes) for one in units)]),
                "node": np.concatenate([3 * one.nodes for one in units]),
                "data": np.concatenate([one.data for one in units]),
                "table_ptr": np.cumsum([0, *(len(one.times) for one in loads)]),
                "time": np.concatenate([np.asarray(one.times, float) for one in loads]),
                "value": np.concatenate([one.amounts for one in loads]),
            }
        )
        return made

    @property
    @abstractmethod
    def constant(self) -> bool:
        """True if the nodal forces do not depend on positions."""

    @abstractmethod
    def forces(self, r: NDArray[Any]) -> NDArray[Any]:
        """Nodal forces (..., k, 3), N, with the nodes at r (..., k, 3), which may be complex."""

    def tangent(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        """Derivatives (3 k, 3 k) of the nodal forces with the nodes at r (k, 3), by complex steps (Squire & Trapp, 1998).

        Loads that turn have no potential: it is not symmetric.
        """
        size = r.size
        stepped = np.broadcast_to(r, (size, *r.shape)) + 1j * STEP * np.eye(size).reshape(size, *r.shape)
        return np.asarray(self.forces(stepped).imag.reshape(size, size).T / STEP)


class Turning(NamedTuple):
    """A unit load that depends on positions, and its amounts at times, s: linear in between, constant outside."""

    load: UnitLoad
    times: Sequence[float]
    amounts: NDArray[np.float64]


class OnBeam(NamedTuple):
    """A load on elastic beam `beam`, an index, from `begin` to `end` as fractions from A: linear from `shape`[0] to `shape`[1]
    times its history, N/m, or N m/m of a `couple`; or, without a shape, at the place `begin`, N or N m. The history is in
    global axes, or where it `turns` in those of the deformed beam; a `shadow` is the direction along which the beam is
    projected.
    """

    beam: int
    begin: float
    end: float
    shape: tuple[float, float] | None
    turns: bool
    shadow: NDArray[np.float64] | None = None
    couple: bool = False

    def over(self, beams: BeamElements, weights: Callable[[Any], Any]) -> Any:
        """l int q(xi) weights(xi) dxi of the load q = shape, or the weights (..., g, values) at its place; summed over g."""
        if self.shape is None:
            return weights(np.asarray(self.begin)[..., None])[..., 0, :]
        # four points: exact for a load that changes linearly on polynomials up to the sixth power
        at, weight = np.polynomial.legendre.leggauss(4)
        eta = 0.5 * (1.0 + at)
        begin, end, first, last = (np.asarray(one)[..., None] for one in (self.begin, self.end, *self.shape))
        q = beams.length[..., self.beam, None] * (end - begin) * (0.5 * weight * (first + (last - first) * eta))
        own = weights(begin + (end - begin) * eta)
        return np.asarray(q @ own if own.ndim == 2 else (q[..., None, :] @ own)[..., 0, :])

    def shares(self, beams: BeamElements) -> NDArray[Any]:
        """What each node of the beam takes of a force of 1 N/m times the shape, m, or of 1 N at its place, (v,)."""
        return np.asarray(self.over(beams, lambda xi: beams.along(xi)[..., self.beam, :, :]))

    def in_beam(self, history: NDArray[np.float64], frame: NDArray[np.float64]) -> NDArray[np.float64]:
        """The history (times, 3) in the axes (times, 3, 3) of the deformed beam."""
        found = history if self.turns else np.einsum("tac,tc->ta", frame, history)
        if self.shadow is not None:
            found = found * np.linalg.norm(np.cross(frame[:, 0], self.shadow), axis=-1)[:, None]
        return np.asarray(found)


@cached(256)
def load_of(system: System, name: str) -> Any:
    """A load with the fields of its record and the numbers of the system, which may be complex, and copies."""
    record = system.model.loads[name]
    own: dict[str, Any] = {field: getattr(record, field) for field in type(record).model_fields}
    for field, given in own.items():
        if (numbers := system.load_numbers.get(f"load {name} {field}")) is None:
            continue
        if field in (record.amount, record.amounts):
            own[field] = numbers
        else:
            own[field] = numbers[..., 0] if isinstance(given, float) else tuple(np.moveaxis(numbers, -1, 0))
    return SimpleNamespace(**own, amount=record.amount, amounts=record.amounts)


class Load(NamedTuple):
    """A kind of load. units : the unit load of each component of the history of a record. places : where it acts on members.
    on_beams : where it acts along elastic beams.
    """

    units: Callable[[System, Any], tuple[UnitLoad, ...]]
    places: Callable[[System, Bars, Any], Iterator[OnMember | OnOthers]]
    on_beams: Callable[[System, Any], Iterator[OnBeam]] = lambda system, load: iter(())  # noqa: ARG005
