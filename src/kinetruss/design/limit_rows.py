"""The rows of the limits of a task: each value of each response, named when it is asked for, as there may be millions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, overload

import numpy as np

from kinetruss.design.optimum.evaluations import UNKNOWN
from kinetruss.design.optimum.problem import Limit
from kinetruss.gradients import Entries

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True, eq=False)
class Block:
    """One side of one limit in one load case: which of the analyses (`analysis`), of their responses (`text`), of its values
    (`kept`, those that are known) it is on.
    """

    name: str
    case: str | None
    analysis: int
    text: int
    of: Entries
    kept: NDArray[np.int64]
    limit: float
    size: float
    sign: int
    unit: str

    def subject(self, k: int) -> str:
        """What value k is of."""
        own = self.of.name(int(self.kept[k]))
        own = own if own.startswith("at ") or not own else f"of {own}"
        return " ".join(filter(None, [self.name, own, self.case and f"in {self.case}"]))

    @cached_property
    def family(self) -> NDArray[np.int64]:
        """(values,): the same number for all instants of one value."""
        place = np.array(np.unravel_index(self.kept, self.of.values.shape or (1,)), np.int64)
        own = [i for i, dim in enumerate(self.of.dims) if dim != "time"]
        sizes = [self.of.values.shape[i] for i in own]
        return np.asarray(np.ravel_multi_index([place[i] for i in own], sizes) if own else 0 * self.kept)


class LimitRows(Sequence[Limit]):
    """The limits of all blocks, in their order."""

    def __init__(self, blocks: Sequence[Block]) -> None:
        self.blocks = blocks
        self.first = np.cumsum([0, *(len(one.kept) for one in blocks)])
        sizes = [len(one.kept) for one in blocks]
        self.limit = np.repeat([one.limit for one in blocks], sizes)
        self.sign_over_size = np.repeat([one.sign / one.size for one in blocks], sizes)
        families, count = [], 0
        for one in blocks:
            families.append(one.family + count)
            count += int(one.of.values.size)
        self.families = np.concatenate([np.zeros(0, np.int64), *families])

    def __len__(self) -> int:
        return int(self.first[-1])

    @overload
    def __getitem__(self, k: int) -> Limit: ...
    @overload
    def __getitem__(self, k: slice) -> list[Limit]: ...
    def __getitem__(self, k: int | slice) -> Limit | list[Limit]:
        if isinstance(k, slice):
            return [self[i] for i in range(*k.indices(len(self)))]
        if not 0 <= k < len(self):
            raise IndexError(k)
        block, place = self.place(k)
        return Limit(
            subject=block.subject(place), family=str(self.families[k]), limit=block.limit, size=block.size, sign=block.sign,
            unit=block.unit,
        )  # fmt: skip

    def place(self, k: int) -> tuple[Block, int]:
        """The block of a row, and its place in it."""
        i = int(np.searchsorted(self.first, k, side="right")) - 1
        return self.blocks[i], k - int(self.first[i])

    def at(self, found: Sequence[Sequence[Entries]]) -> LimitRows:
        """The same, with the names that values have in other responses: of other instants."""
        return LimitRows([replace(one, of=found[one.analysis][one.text]) for one in self.blocks])

    def excess(self, found: Sequence[Sequence[Entries]]) -> NDArray[np.float64]:
        """Of all rows (rows,), from the values of the responses of all analyses."""
        own = (found[one.analysis][one.text].values.reshape(-1)[one.kept] for one in self.blocks)
        values = np.concatenate([np.zeros(0), *own])
        return np.asarray(np.nan_to_num((values - self.limit) * self.sign_over_size, nan=UNKNOWN, posinf=UNKNOWN))
