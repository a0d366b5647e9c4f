"""Models from points and lines: names, nodes that are near each other, crossings, CSV tables, DXF out."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatch
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError, UnitError, shown
from kinetruss.exchange.imported import Imported, needed
from kinetruss.exchange.robots import LeftOut
from kinetruss.io.part_tables import read_parts
from kinetruss.io.yaml_text import Tree, parse, read_text
from kinetruss.limits import LARGEST, MOST_ENTRIES, hold
from kinetruss.model import Bar, Model, Node, nearest
from kinetruss.model.members import Brace
from kinetruss.units import parse as quantity

if TYPE_CHECKING:
    from numpy.typing import NDArray


_ALLOWED = re.compile(r"[^\w.:+-]+")
LONGEST = 100


class Names:
    """Gives each name of a file one that is allowed and not in use; `renamed` lists those that had to change."""

    def __init__(self) -> None:
        self._taken: dict[str, set[str]] = {}
        self.renamed: list[LeftOut] = []

    def of(self, name: str, where: str, table: str = "link") -> str:
        """A new name in a table; ``ground`` is that of the fixed frame."""
        taken = self._taken.setdefault(table, {"ground"})
        found = base = (_ALLOWED.sub("_", name).strip("_") or table)[:LONGEST]
        count = 1
        while found in taken:
            count += 1
            found = f"{base}_{count}"
        taken.add(found)
        if found != name:
            self.renamed.append(LeftOut("name", where, f"{shown(name)} is called {found!r}"))
        return found


# Texts and tables of files, with the file named in every fault.


def text_of(path: Path, max_size: int) -> str:
    """UTF-8 text of a file; ModelError if it cannot be read."""
    try:
        return read_text(path, max_size)
    except ModelError as error:
        raise ModelError([replace(fault, file=str(path)) for fault in error.faults]) from None


def tree_of(path: Path, max_size: int) -> Tree:
    """The values of a YAML or JSON file with their lines; ModelError if it is not one, or empty."""
    try:
        tree, faults = parse(path, text_of(path, max_size))
        if faults:
            raise ModelError(faults)
    except ModelError as error:
        raise ModelError([replace(fault, file=fault.file or str(path)) for fault in error.faults]) from None
    if tree is None:
        raise ModelError([Fault((), "is empty.", "Name another file.", 1, 1, file=str(path))])
    return tree


# A model from points and lines: nodes that are near each other become one, lines become bars.

FLAT = 1e-12
"""Largest z of a planar drawing, relative to its size: round-off of its own axes."""


def length_of(text: str | float, what: str) -> float:
    """Metres of a length, or of one unit such as ``mm``."""
    try:
        return quantity(text, "length") if not isinstance(text, str) or text[:1].isdigit() else quantity(f"1 {text}", "length")
    except UnitError:
        raise InputError(f"{what} is {text!r}, which is no length. Write for example mm, or '1 mm'.") from None


def matches(name: str, patterns: Iterable[str]) -> bool:
    """True if a name fits one of some patterns with * and ?, in either case."""
    return any(fnmatch(name.lower(), pattern.lower()) for pattern in patterns)


def joined(points: Any, tolerance: float) -> NDArray[np.int64]:
    """For each point (k, 3), m, the number of the first point that is the same node: near it, or near one that is."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    points = np.asarray(points, float)
    if not (np.abs(points) <= LARGEST).all():
        raise InputError(f"A point has a coordinate that is not finite, or beyond {LARGEST:g} m. Correct the drawing.")
    pairs = cKDTree(points).query_pairs(tolerance, output_type="ndarray") if tolerance > 0 else _equal(points)
    links = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(points), len(points)))
    _, group = connected_components(links, directed=False)
    _, first = np.unique(group, return_index=True)
    return np.asarray(first[group])


def _equal(points: NDArray[np.float64]) -> NDArray[np.int64]:
    _, first, back = np.unique(points, axis=0, return_index=True, return_inverse=True)
    return np.stack([first[back.reshape(-1)], np.arange(len(points))], axis=1)


def supported_nodes(patterns: Sequence[str], nodes: Mapping[str, Any], source: str) -> list[str]:
    """Names of the nodes that are fixed; an error for a name that fits none."""
    found: list[str] = []
    for pattern in patterns:
        own = [name for name in nodes if matches(name, [pattern])]
        if not own:
            raise InputError(f"{source}: no node called {pattern!r} to fix. {nearest(pattern, nodes)}")
        found += own
    return list(dict.fromkeys(found))


def model_of(
    source: str, places: Mapping[str, Any], bars: Mapping[str, Bar], fixed: Iterable[str] = (), **tables: Any
) -> Model:
    """The model of nodes by name and place (3,) m, and bars; planar if every z is 0 but for round-off.

    Raises
    ------
    InputError : no nodes, or too many.
    """
    if not places:
        raise InputError(f"{source} has no lines, so no nodes. Name a file with lines.")
    hold(max(len(places), len(bars)), source, "Import a smaller part.", most=MOST_ENTRIES, of="nodes or bars")
    at = np.array(list(places.values()))
    flat = float(np.abs(at[:, 2]).max()) <= FLAT * float(np.ptp(at, axis=0).max()) and not tables.get("solids")
    nodes = {name: Node(at=tuple(float(x) for x in place[: 2 if flat else 3])) for name, place in places.items()}
    return Model(nodes=nodes, bars=dict(bars), fixed=list(fixed), **tables)


# Bars of a drawing that meet where no node is.

MOST = 20
"""Largest number of crossings that are named."""
LARGEST_DRAWING = 5000
"""Lines; each is compared with those near it."""


def unjoined(places: Mapping[str, Any], bars: Mapping[str, Bar], near: float) -> list[str]:
    """Notes on lines that cross, or touch another between its ends, without a node there: their bars pass each other."""
    from scipy.spatial import cKDTree

    if len(bars) < 2:
        return []
    if len(bars) > LARGEST_DRAWING:
        return [f"not checked for lines that meet without a node: more than {LARGEST_DRAWING:,} lines"]
    names = list(bars)
    a, b = (np.array([places[bars[name].ends[k]] for name in names]) for k in (0, 1))
    middle, half = (a + b) / 2, np.linalg.norm(b - a, axis=1) / 2
    tree, found = cKDTree(middle), []
    for i, name in enumerate(names):
        for j in tree.query_ball_point(middle[i], half[i] + float(half.max()) + near):
            if j <= i or set(bars[name].ends) & set(bars[names[j]].ends):
                continue
            if (place := _crossing(a[i], b[i], a[j], b[j], near)) is not None:
                found.append(f"{name} and {names[j]} at ({', '.join(f'{round(float(x), 12) + 0.0:.6g}' for x in place)}) m")
        if len(found) > MOST:
            break
    if not found:
        return []
    more = [f"  {text}" for text in found[:MOST]] + ["  and more"] * (len(found) > MOST)
    head = "lines that meet between their ends are not joined; break them where they meet if they are to be:"
    return [head, *more]


def _crossing(a: Any, b: Any, c: Any, d: Any, near: float) -> Any:
    """The point where two segments come nearer than `near`, between the ends of one of them; None without."""
    u, v, w = b - a, d - c, a - c
    uu, uv, vv, uw, vw = u @ u, u @ v, v @ v, u @ w, v @ w
    det = uu * vv - uv * uv
    if det <= 1e-12 * uu * vv:
        return None  # parallel
    s = min(1.0, max(0.0, (uv * vw - vv * uw) / det))
    t = min(1.0, max(0.0, (uv * s + vw) / vv))
    s = min(1.0, max(0.0, (uv * t - uw) / uu))
    place = a + s * u
    return place if float(np.linalg.norm(place - c - t * v)) <= near else None


# A model from two CSV files: nodes and members.


def tables(path: Path, *, max_size: int, members: str | Path | None = None, fixed: Sequence[str] = ()) -> Imported:
    """The model of a table of nodes (``node, x [mm], y [mm], z [mm], mass [kg]``) and one of members (``member, from, to, kind,
    section, material, mass [kg]``), as `io.read_cell` reads them. fixed : names of nodes, with the axes if not all: ``E:y``.
    """
    if members is None:
        raise InputError(f"{path} holds the nodes. Name the table of members too: --members FILE (members=...).")
    parts: dict[str, Any] = read_parts(path, Path(members), max_size)
    bars = {name: bar | ({"kind": "driven"} if name in parts["active"] else {}) for name, bar in parts["bars"].items()}
    model = Model(nodes=parts["nodes"], bars=bars, fixed=_supports(fixed, parts["nodes"], str(path)))
    left = [LeftOut("face", f"{path}: face.{name}", "faces belong to cells of the library") for name in parts["faces"]]
    return Imported(model=model, source=str(path), left_out=left)


def _supports(fixed: Sequence[str], nodes: Mapping[str, Any], source: str) -> dict[str, str]:
    """Axes in which nodes are held: all, or those after a colon."""
    every = "xyz"[: len(next(iter(nodes.values()))["at"])] if nodes else ""
    found: dict[str, str] = {}
    for text in fixed:
        name, colon, axes = text.rpartition(":")
        if not colon or not axes or set(axes) - set(every) or text in nodes:
            name, axes = text, every
        found |= dict.fromkeys(supported_nodes([name], nodes, source), axes)
    return found


# DXF of a model in a pose: a line for each bar, points at supports.

LAYERS = {"rigid": "bars", "driven": "active", "elastic": "elastic", "cable": "cables", "free": "free"}
METRES = 6
"""Number of the metre in $INSUNITS."""


def write_dxf(path: Path, model: Model, x: NDArray[np.float64]) -> list[LeftOut]:
    """Write lines on layers by what the bars do (``bars``, ``active``, ``bodies``, ...), names as texts at their middles, and
    points on ``support`` at fixed nodes; lengths in m. x (n, 3).
    """
    ezdxf = needed("ezdxf", "exchange")
    document: Any = ezdxf.new("R2010", units=METRES)
    space = document.modelspace()
    place = {name: k for k, name in enumerate(model.whole.nodes)}
    driven = model.driven_members
    for name, member in model.whole.members.items():
        a, b = (x[place[node]] for node in member.ends)
        brace = isinstance(member, Brace)
        layer = "active" if name in driven else "bodies" if brace else LAYERS[getattr(member, "kind", "rigid")]
        space.add_line(a.tolist(), b.tolist(), dxfattribs={"layer": layer})
        if not brace:
            height = 0.02 * float(((b - a) @ (b - a)) ** 0.5)
            text = re.sub(r"[\x00-\x1f]", " ", name)
            space.add_text(text, height=height, dxfattribs={"layer": layer, "insert": ((a + b) / 2).tolist()})
    for name in (one for one in model.nodes if one in model.whole.fixed):
        space.add_point(x[place[name]].tolist(), dxfattribs={"layer": "support"})
    document.saveas(path)
    said = "of a support a point is drawn where it is rigid; it is not said what it holds"
    left = [LeftOut("supports", name, said) for name in model.supports]
    left += [LeftOut("fixed", name, f"is held along {axes} only; a point marks it") for name, axes in model.fixed.items()
            if len(axes) < model.dim]  # fmt: skip
    for table in ("beams", "membranes", "solids"):
        left += [LeftOut(table, name, "only bars are drawn") for name in getattr(model, table)]
    return left
