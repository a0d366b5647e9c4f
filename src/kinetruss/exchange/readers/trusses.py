"""A model from points and lines: nodes that are near each other become one, lines become bars."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatch
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, UnitError
from kinetruss.limits import LARGEST, MOST_ENTRIES, hold
from kinetruss.model import Bar, Model, Node, nearest
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["held", "joined", "length_of", "matches", "model_of"]

FLAT = 1e-12
"""Largest z of a planar drawing, relative to its size: round-off of its own axes."""


def length_of(text: str | float, what: str) -> float:
    """Metres of a length, or of one unit such as ``mm``."""
    try:
        return parse(text, "length") if not isinstance(text, str) or text[:1].isdigit() else parse(f"1 {text}", "length")
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


def held(patterns: Sequence[str], nodes: Mapping[str, Any], source: str) -> list[str]:
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
