"""Models from cells: a stack, a ring, branches, any tree of cells; a cell of one's own, a chain as one cell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from pydantic import BeforeValidator, Field

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.library.building import builder
from kinetruss.library.cells.fittings import Fittings, Placing, any_cell, counted, dressed, made, placed, ready
from kinetruss.library.cells.joining import Joined, joined
from kinetruss.library.cells.octahedra import double_octahedron, quadruple_octahedron
from kinetruss.library.cells.records import EMPTY, Cell, Face
from kinetruss.library.cells.shapes import cube, decahedron, octahedron, panel, prism, tetrahedron, triangle
from kinetruss.limits import MOST_ENTRIES
from kinetruss.model import Bar, Filled, GravityVector, Model, Name, Node, PositiveNumber, Table, nearest


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


# Models from cells: a stack, a ring, branches from a hub, any tree of cells.


def _listed(value: Any) -> Any:
    """A single cell as a list."""
    return value if isinstance(value, (list, tuple)) else [value]


if TYPE_CHECKING:
    AnyCell = Cell | Mapping[str, Any]
    Cells = Sequence[AnyCell]
    Arms = Mapping[Name, AnyCell | Cells]
    Named = Mapping[Name, AnyCell]
else:
    AnyCell = any_cell(*READY, chain)
    Cells = Annotated[tuple[AnyCell, ...], Field(max_length=MOST_ENTRIES)]
    Arms = Annotated[dict[Name, Annotated[Cells, BeforeValidator(_listed)]], Field(min_length=1, max_length=MOST_ENTRIES)]
    Named = Annotated[dict[Name, AnyCell], Field(min_length=1, max_length=MOST_ENTRIES)]
Fixed = tuple[Name, ...]
DOWN = (0.0, 0.0, -9.81)


@builder("cells.stack")
def stack(
    cells: Cells,
    *,
    names: Name = "B",
    fixed: Fixed | None = None,
    links: Table[Name, Bar] = EMPTY,
    gravity: GravityVector | None = DOWN,
    tolerance: PositiveNumber = 1e-6,
    title: str = "",
) -> Model:
    """A chain of cells, each with its ``base`` on the ``top`` of the one below: a mast, a manipulator, a crane.

    Names have the cell before the dot: ``B1.N1``, ``B2.M7``; a node or member that two cells have in common belongs to the
    lower one, with its section. A single cell keeps its own names.

    Parameters
    ----------
    cells : from the base up: cells of this package; in a file ``{kind: octahedron, side: 1 m, count: 6}``. Each may have
        its own sizes, sections and drives, as long as its base fits on the top below.
    names : what stands before the numbers of the cells.
    fixed : faces (``base``, ``B3.top``) and nodes that are fixed; by default the base. links : more bars between nodes of
        the whole.
    gravity : m/s^2; None for none; by default downwards (in the plane along -y).
    tolerance : largest difference of two edges that are joined, as a fraction of the edge.

    Returns
    -------
    Model.

    Raises
    ------
    ModelError : all faults of the parameters; cells that do not fit, with where, got, expected, and the mend.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> arm = cells.stack([cells.double_octahedron(base=1.2, longeron=0.9)] * 6)
    >>> len(arm.nodes), len(arm.members), list(arm.poses), arm.bars["B2.M1"].ends
    (39, 108, ['B1', 'B2', 'B3', 'B4', 'B5', 'B6'], ('B2.N6', 'B1.N9'))
    """
    found = counted(cells, ("cells",))
    whole = stacked(found, names, tolerance)
    return _model(whole, fixed, links, gravity, title or f"Stack of {len(found)} cells")


@builder("cells.ring")
def ring(
    cells: Cells,
    *,
    names: Name = "B",
    fixed: Fixed | None = None,
    links: Table[Name, Bar] = EMPTY,
    gravity: GravityVector | None = DOWN,
    tolerance: PositiveNumber = 1e-6,
    title: str = "",
) -> Model:
    """A chain of cells that closes: the top of the last one is the base of the first. Parameters as of `stack`.

    Raises
    ------
    ModelError : as of `stack`; a ring that does not close, with its gap and angle.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> hexagon = cells.ring([cells.triangle()] * 6)
    >>> len(hexagon.nodes), len(hexagon.bars)
    (7, 12)
    """
    found = counted(cells, ("cells",))
    if len(found) < 2:
        raise ModelError([Fault(("cells",), "one cell makes no ring.", "Give two cells or more.")])
    whole = stacked(found, names, tolerance, close=True)
    return _model(whole, fixed, links, gravity, title or f"Ring of {len(found)} cells")


@builder("cells.branch")
def branch(
    hub: AnyCell,
    arms: Arms,
    *,
    fixed: Fixed | None = None,
    links: Table[Name, Bar] = EMPTY,
    gravity: GravityVector | None = DOWN,
    tolerance: PositiveNumber = 1e-6,
    title: str = "",
) -> Model:
    """Arms on the faces of a hub: ``hub.N1``, ``side1.N4`` of a single cell, ``side2.B3.M7`` of a chain.

    Parameters
    ----------
    hub : a cell. arms : face of the hub -> a cell, or a list of cells from the hub outwards.
    fixed, links, gravity, tolerance : as of `stack`.

    Raises
    ------
    ModelError : as of `stack`; a face that the hub does not have.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> tree = cells.branch(cells.octahedron(), {"side1": [cells.octahedron()] * 2, "top": cells.tetrahedron()})
    >>> [name for name in tree.nodes if "side1" in name]
    ['side1.B1.N4', 'side1.B1.N5', 'side1.B1.N6', 'side1.B2.N4', 'side1.B2.N5', 'side1.B2.N6']
    """
    found = {"hub": made(hub, ("hub",))}
    for face, given in arms.items():
        if face not in found["hub"].faces:
            known = nearest(face, found["hub"].faces)
            raise ModelError([Fault(("arms", face), f"the hub has no face {shown(face)}.", known)])
        cells = counted(_listed(given), ("arms", face))
        arm = cells[0] if len(cells) == 1 else stacked(cells, "B", tolerance).cell()
        found[face] = arm
    under = {face: f"hub.{face}" for face in arms}
    return _model(joined(found, on=under, tolerance=tolerance), fixed, links, gravity, title or f"Hub with {len(arms)} arms")


@builder("cells.assemble")
def assemble(
    cells: Named,
    *,
    close: Table[Name, Name] = EMPTY,
    fixed: Fixed | None = None,
    links: Table[Name, Bar] = EMPTY,
    gravity: GravityVector | None = DOWN,
    tolerance: PositiveNumber = 1e-6,
    title: str = "",
) -> Model:
    """Any cells by name, each in its place or `on` a face of one before it.

    Parameters
    ----------
    cells : name -> cell; ``on="hub.side1"`` stands it on a face, ``at`` and ``towards`` place one that stands on none.
    close : face -> face on which it lies when all cells are in place.
    fixed : by default the bases of all cells that stand on no other. links, gravity, tolerance : as of `stack`.

    Raises
    ------
    ModelError : as of `stack`; faces that are not there; faces to be closed that do not meet.

    Examples
    --------
    Two trusses that face each other, with a link between their tops:

    >>> from kinetruss.library import cells
    >>> bay = cells.double_octahedron()
    >>> left = cells.chain([bay] * 2, towards=(1, 0, 0))
    >>> right = cells.chain([bay] * 2, at=(5, 0, 0), towards=(-1, 0, 0))
    >>> model = cells.assemble({"L": left, "R": right}, links={"link": ("L.B2.N8", "R.B2.N8")})
    >>> len(model.members), len(model.fixed)
    (73, 6)
    """
    found = {name: made(one, ("cells", name)) for name, one in cells.items()}
    whole = joined(found, close=close, tolerance=tolerance)
    return _model(whole, fixed, links, gravity, title or f"Assembly of {len(found)} cells")


def _model(whole: Joined, fixed: Fixed | None, links: Mapping[str, Bar], gravity: Any, title: str) -> Model:
    """The model of cells in their places."""
    first = next(iter(whole.cells.values()))
    if fixed is None:
        held = [node for name in whole.roots() if "base" in whole.cells[name].faces for node in _corners(whole, name, "base")]
    else:
        held = [node for name in fixed for node in _fixed_nodes(whole, name)]
    tables = whole.tables()
    if twice := [name for name in links if name in tables.get("bars", {}) or name in tables.get("active", {})]:
        raise ModelError([Fault(("links", twice[0]), "is the name of a member of a cell.", "Rename the link.")])
    tables["bars"] = tables.get("bars", {}) | dict(links)
    down = (0.0, -9.81) if first.dim == 2 and gravity == DOWN else gravity
    return Model(**tables, title=title, fixed=list(dict.fromkeys(held)), gravity=down)


def _fixed_nodes(whole: Joined, name: str) -> list[str]:
    """Nodes of a face, or the node of this name."""
    if name in whole.places:
        return [name]
    if name in ("base", "top"):
        cell = next(iter(whole.cells)) if name == "base" else list(whole.cells)[-1]
        if name in whole.cells[cell].faces:
            return _corners(whole, cell, name)
    cell, face = whole.face(name, ("fixed",))
    return _corners(whole, cell, face)


def _corners(whole: Joined, cell: str, face: str) -> list[str]:
    return whole.corners(cell, whole.cells[cell].faces[face].nodes)
