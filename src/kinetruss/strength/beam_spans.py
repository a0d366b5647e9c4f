"""Elastic beams as the user has them: beams, and links, of which each part between two pins is a beam of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.mechanics import System, cached
from kinetruss.model import Piece
from kinetruss.model.links import bends, length_along

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Beam, Link


@dataclass(frozen=True, kw_only=True, eq=False)
class Spans:
    """Beams and links by name, in the order of results; and of the elements that they are made of: of (k,) the place of the
    beam or link, start and length (k,) m along it. total (names,) length, m. bare : links without section or material, and
    their lengths, which follow in a verdict.
    """

    names: tuple[str, ...]
    records: tuple[Beam | Link, ...]
    of: NDArray[np.int64]
    start: NDArray[np.float64]
    length: NDArray[np.float64]
    total: NDArray[np.float64]
    bare: dict[str, float]

    @property
    def parted(self) -> bool:
        """Whether some of them are of several elements."""
        return len(self.names) < len(self.of)

    @property
    def pins(self) -> NDArray[np.float64]:
        """Places of pins between the ends of links, as fractions of their lengths, ascending."""
        return np.unique((self.start / self.total[self.of])[self.start > 0])

    def elements(self, name: str) -> NDArray[np.int64]:
        """Those of a beam or link, from its first end on."""
        return np.flatnonzero(self.of == self.names.index(name))

    def places(self, xi: NDArray[np.float64]) -> NDArray[np.float64]:
        """Fractions of the lengths of elements at which those of whole beams and links, xi (s,), have their values."""
        if not self.parted:
            return xi
        own = (xi * self.total[self.of][:, None] - self.start[:, None]) / self.length[:, None]
        own[np.abs(own) < SAME] = 0.0
        own[np.abs(own - 1.0) < SAME] = 1.0
        return np.unique(own[(own >= 0) & (own <= 1)])

    def chosen(
        self, xi: NDArray[np.float64], local: NDArray[np.float64], size: NDArray[np.float64]
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Element and place among `local` (p,) of each beam or link at xi (s,), both (.., names, s). At a pin the side where
        size (.., k, p) is larger.
        """
        lead = size.shape[:-2]
        element, place = (np.zeros((*lead, len(self.names), len(xi)), np.int64) for _ in range(2))
        best = np.full(element.shape, -np.inf)
        own = (xi * self.total[self.of][:, None] - self.start[:, None]) / self.length[:, None]
        for k, (name, at) in enumerate(zip(self.of.tolist(), own, strict=True)):
            here = np.flatnonzero((at > -SAME) & (at < 1.0 + SAME))
            near = np.abs(local[None] - np.clip(at[here], 0.0, 1.0)[:, None]).argmin(axis=1)
            value = np.nan_to_num(size[..., k, near], nan=0.0)
            better = value > best[..., name, here]
            for out, new in ((element, k), (place, near), (best, value)):
                out[..., name, here] = np.where(better, new, out[..., name, here])
        return element, place


SAME = 1e-9
"""Fraction of the length of an element within which a place is at its end."""


@cached()
def spans_of(system: System) -> Spans:
    """The elastic beams of a model, and its links of such."""
    model = system.model
    names, records = list[str](), list["Beam | Link"]()
    of, start, length, total = list[int](), list[float](), list[float](), list[float]()
    for name, beam in model.beams.items():
        if beam.kind != "elastic":
            continue
        own = beam.link if isinstance(beam, Piece) else name
        if own not in names:
            names.append(own)
            records.append(model.links[own] if isinstance(beam, Piece) else beam)
            total.append(0.0)
        of.append(names.index(own))
        start.append(total[of[-1]])
        a, b = (system.x0[system.node_index(end)] for end in beam.ends)
        length.append(float(np.linalg.norm(b - a)))
        total[of[-1]] += length[-1]
    return Spans(
        names=tuple(names),
        records=tuple(records),
        of=np.array(of, np.int64),
        start=np.array(start),
        length=np.array(length),
        total=np.array(total),
        bare={name: length_along(model, one) for name, one in model.links.items() if not bends(model, one)},
    )
