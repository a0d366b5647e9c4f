"""A cell of one's own from nodes and members, and a chain of cells as one cell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from pydantic import Field

from kinetruss.library.cells.fittings import Fittings, Placing, dressed, placed
from kinetruss.library.cells.flat import panel, triangle
from kinetruss.library.cells.joining import Joined, joined
from kinetruss.library.cells.octahedra import double_octahedron, quadruple_octahedron
from kinetruss.library.cells.ready import any_cell, counted, ready
from kinetruss.library.cells.records import EMPTY, Cell, Face
from kinetruss.library.cells.solid import cube, decahedron, octahedron, prism, tetrahedron
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import Bar, Filled, Name, Node, Table

__all__ = ["READY", "cell", "chain", "stacked"]


@ready("cell")
def cell(
    *,
    nodes: Filled[Name, Node],
    bars: Table[Name, Bar] = EMPTY,
    faces: Table[Name, Face] = EMPTY,
    **fittings: Unpack[Fittings],
) -> Cell:
    """A cell of one's own.

    Parameters
    ----------
    nodes, bars : by name, as of a `Model`. faces : by name, the nodes by which it is joined, see `Face`; ``base`` and ``top``
        are needed in a stack.
    fittings : see `Fittings`. `active` : bars that are driven, or active members by name with their `ends`.

    Raises
    ------
    ModelError : all faults at once.

    Examples
    --------
    >>> mine = cell(nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1), "D": (1, 1)}, faces={"base": ["A", "B"], "top": ["C", "D"]},
    ...             bars={"left": ("A", "C"), "right": ("B", "D"), "top": ("C", "D"), "brace": ("A", "D")}, active=["brace"])
    >>> [name for name, bar in mine.bars.items() if bar.kind == "driven"]
    ['brace']
    """
    return dressed(Cell(nodes=nodes, bars=bars, faces=faces), fittings)


READY = (triangle, panel, tetrahedron, octahedron, decahedron, prism, cube, double_octahedron, quadruple_octahedron, cell)
if TYPE_CHECKING:
    Links = Sequence[Cell | Mapping[str, Any]]
else:
    Links = Annotated[tuple[any_cell(*READY), ...], Field(max_length=MOST_ENTRIES)]


@ready("chain", Placing)
def chain(cells: Links, *, names: Name = "B", **placing: Unpack[Placing]) -> Cell:
    """Cells on top of each other as one cell, to be placed, mirrored, or joined to others: ``B1.N1``, ``B2.M7`` ..

    Parameters
    ----------
    cells : from the base up, as of `stack`. names : what stands before their numbers.
    placing : see `Placing`.

    Raises
    ------
    ModelError : cells that do not fit.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> list(cells.chain([cells.triangle()] * 2, mirrored="x").nodes)
    ['B1.N1', 'B1.N2', 'B1.N3', 'B2.N3']
    """
    return placed(stacked(counted(cells, ("cells",)), names).cell(), placing)


def stacked(cells: list[Cell], names: str, tolerance: float = 1e-6, *, close: bool = False) -> Joined:
    """Cells on top of each other, with the name of each and its number; a single cell has the empty name.

    close : the top of the last lies on the base of the first.

    >>> from kinetruss.library import cells
    >>> list(cells.stacked([cells.panel()] * 2, "B").cell().nodes)
    ['B1.N1', 'B1.N2', 'B1.N3', 'B1.N4', 'B2.N3', 'B2.N4']
    """
    called = [f"{names}{k}" for k in range(1, len(cells) + 1)] if len(cells) > 1 else [""]
    found = dict(zip(called, cells, strict=True))
    ring = {f"{called[-1]}.top": f"{called[0]}.base"} if close else None
    under = {name: below for below, name in pairwise(called)}
    return joined(found, on=under, close=ring, tolerance=tolerance)
