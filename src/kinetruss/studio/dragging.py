"""A mechanism moved by its nodes: all lengths are kept, drives follow."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import diags

from kinetruss.errors import InputError
from kinetruss.mechanics import compile, constraint_jacobian
from kinetruss.model import Model, nearest
from kinetruss.statics.saddle_point import Saddle, rows_of
from kinetruss.statics.search import projected, row_errors
from kinetruss.studio.poses import CLOSED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.studio.edits import Data

    Floats = NDArray[np.float64]

LIGHT = 1e-4
"""Weight of nodes that follow, against that of those that are dragged."""

CLOSING = 3
"""Largest number of steps by which the rows are closed on the way."""

ROUNDS = 12
"""Largest number of steps towards a place; the next move of the pointer goes on from there."""

LONGEST = 0.1
"""Longest step, as a fraction of the size of the structure, so that the branch is kept."""

STILL = 1e-9
"""Steps below this fraction of the size end the search."""


@dataclass
class Grip:
    """A model in the hand, from the pose in which it was taken.

    data : of the model, with its nodes in the pose `start` (n_nodes, dim), m, a closed one. number : of the drag.
    """

    data: Data
    model: Model
    start: Floats
    number: int | None
    x: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        system = compile(self.model)
        free = system.prescribed.copy()
        free[system.coordinate_drive[:, 0]] = False
        self.system = replace(system.with_rows(system.row_drive < 0), prescribed=free)
        self.x = np.zeros_like(system.x0)
        self.x[:, : system.dim] = self.start
        self.rows = rows_of(self.system, self.x)
        self.size = float(np.ptp(self.x, axis=0).max()) or 1.0

    def to(self, places: Mapping[str, Sequence[float]]) -> Floats:
        """The pose (n_nodes, dim), m, with nodes as near to these places as the lengths allow, on the branch of the start.

        Steps of gradients: of the squared distances of the dragged nodes on the linearised rows, with a small weight on the
        steps of all other nodes. Each is as long as the change of the last one says (Barzilai and Borwein, 1988, eq. 5),
        then the rows are closed.

        Raises
        ------
        InputError : an unknown node.
        """
        system, x = self.system, self.x.copy()
        nodes = list(self.model.nodes)
        if unknown := [name for name in places if name not in nodes]:
            raise InputError(f"No node called {unknown[0]!r}. {nearest(unknown[0], nodes)}")
        held = np.full(x.size, np.nan)
        for name, place in places.items():
            at = 3 * nodes.index(name)
            held[at : at + system.dim] = place
        held = held[system.free]
        pulled = np.isfinite(held)
        weight = np.where(pulled, 1.0, LIGHT)
        H, wanted = diags(weight).tocsc(), system.row_value
        share, last = 1.0, np.zeros(len(pulled))
        for _ in range(ROUNDS if pulled.any() else 0):
            J = constraint_jacobian(system, x)[:, system.free]
            pull = np.where(pulled, held - x.reshape(-1)[system.free], 0.0)
            dx, _ = Saddle(H, J, self.rows).solve(pull, -row_errors(system, x, wanted))
            far = float(np.abs(dx).max(initial=0.0))
            if not np.isfinite(far) or far <= STILL * self.size:
                break
            change = float(last @ (weight * (last - dx)))
            if change > 0:
                share *= float(np.clip(last @ (weight * last) / change, 0.1, 4.0))
            share = min(share, LONGEST * self.size / far)
            x.reshape(-1)[system.free] += share * dx
            x, _ = projected(system, x, wanted, self.size, CLOSING, self.rows) if len(wanted) else (x, 0.0)
            last = dx
        found, worst = projected(system, x, wanted, self.size, rows=self.rows) if len(wanted) else (x, 0.0)
        if worst <= CLOSED * self.size and np.isfinite(found).all():
            self.x = found
        return self.x[:, : system.dim].copy()
