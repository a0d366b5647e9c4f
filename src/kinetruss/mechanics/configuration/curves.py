"""The axes of elastic beams as curves: linear in the positions of the nodes of both ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.mechanics.kept import kept
from kinetruss.model.beams import CHORD

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["BeamCurves", "beam_curves"]

PIECES, FEW, MANY = 12, 4, 100
"""Straight pieces that show a beam, and those of each beam where there are more than `MANY`."""


@dataclass(frozen=True, kw_only=True, eq=False)
class BeamCurves:
    """The curves of k beams at g places each.

    member (k,) indices of their chords among the members; nodes (k, v) of both ends; along (k, g, v) coefficients of these
    nodes that give the axis, by Hermite's polynomials as in `BeamElements.fields`; across (k, g, v) the same of local axis 2.
    """

    member: NDArray[np.int64]
    nodes: NDArray[np.int64]
    along: NDArray[np.float64]
    across: NDArray[np.float64]

    def at(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Points (.., k, g, dim), m, of nodes at x (.., n, dim)."""
        found: NDArray[np.float64] = np.einsum("kgv,...kvc->...kgc", self.along, x[..., self.nodes, :])
        return found


@kept()
def beam_curves(system: System) -> BeamCurves | None:
    """The curves of the elastic beams of a model; None if it has none."""
    beams = None if system.continua is None else system.continua.beams
    if beams is None:
        return None
    index = {name: k for k, name in enumerate(system.model.members)}
    xi = np.linspace(0.0, 1.0, (PIECES if len(beams.names) <= MANY else FEW) + 1)
    across = (1 - xi)[:, None] * beams.axes[:, None, 1] + xi[:, None] * beams.ends[:, None, 1]
    member = np.array([index[f"{name}{CHORD}"] for name in beams.names], np.int64)
    return BeamCurves(member=member, nodes=beams.nodes, along=beams.fields(xi), across=across)
