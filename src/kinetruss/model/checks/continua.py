"""Faults of membranes and solids: nodes, materials, and the shape of their elements."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault, few
from kinetruss.model.checks.common import components, unknown
from kinetruss.model.parts.sections import Material

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model._data import ModelData

__all__ = ["continuum_faults"]

FLAT = 1e-9
"""An element has no volume (area) below this fraction of its size cubed (squared)."""
SHOWN = 3


def continuum_faults(model: ModelData, dim: int) -> Iterator[Fault]:
    """Faults of all membranes and solids of a model with `dim` axes."""
    for table in ("membranes", "solids"):
        for name, part in getattr(model, table).items():
            path = (table, name)
            if table == "solids" and dim == 2:
                mend = "Make it a membrane, or give the nodes z."
                yield Fault(path, "is a solid in a planar model.", mend, about=(("nodes",),))
                continue
            yield from _material(model, part, path, dim)
            known = yield from _nodes(model, part, path, dim)
            if known:
                yield from _shapes(model, part, path, dim)


def _nodes(model: ModelData, part: Any, path: tuple[str, str], dim: int) -> Any:
    """Faults of the nodes; returns True if the shape can be checked."""
    good = True
    for k, node in enumerate(part.nodes):
        if node not in model.nodes:
            yield unknown("node", node, model.nodes, (*path, "nodes", k))
            good = False
        elif len(model.nodes[node].at) != dim:
            good = False
    if len(set(part.nodes)) < len(part.nodes):
        twice = next(node for node in part.nodes if part.nodes.count(node) > 1)
        yield Fault((*path, "nodes"), f"names {twice!r} twice.", "Name each node once.")
    for place in ("axis", "axes"):
        given = getattr(part, place, None)
        for vector in () if given is None else (given,) if place == "axis" else given:
            if len(vector) != dim:
                yield from components(vector, dim, (*path, place))
                good = False
            elif not any(vector):
                yield Fault((*path, place), "has no direction.", "Give a vector other than 0.")
                good = False
    if good and getattr(part, "axes", None) is not None and np.linalg.norm(np.cross(*part.axes)) < FLAT:
        yield Fault((*path, "axes"), "are parallel.", "Give two directions across each other.")
        good = False
    return good


def _material(model: ModelData, part: Any, path: tuple[str, str], dim: int) -> Iterator[Fault]:
    """No material, an unknown one, or one that this law does not support."""
    chosen = part.material if part.material is not None else model.material
    about = ((*path, "material"), (*path, "orthotropic"), ("material",), ("materials",))
    solid = path[0] == "solids"
    if part.orthotropic is not None:
        if part.material is not None:
            yield Fault((*path, "orthotropic"), "is given together with material.", "Give one of them.", about=about[:1])
        if (solid or part.plane == "strain") and not part.orthotropic.spatial:
            mend = "Give E3, nu13 and nu23" + (", G13 and G23." if solid else ".")
            yield Fault((*path, "orthotropic"), "does not say what holds across the plane 1, 2.", mend)
        elif solid and None in (part.orthotropic.G13, part.orthotropic.G23):
            yield Fault((*path, "orthotropic"), "lacks shear moduli.", "Give G13 and G23.")
    elif chosen is None:
        yield Fault(path, "has no material.", "Give material or orthotropic, or a material of the model.", about=about)
    elif isinstance(chosen, str) and chosen not in model.materials:
        if part.material is not None:
            yield unknown("material", chosen, model.materials, (*path, "material"))
    elif (solid or part.plane == "strain") and _poisson(model, chosen) > 0.499999:
        mend = "Give poisson below 0.5, e.g. 0.49."
        yield Fault(path, "has an incompressible material (poisson 0.5), which this law cannot take.", mend, about=about)
    if not solid and part.plane == "strain" and dim == 3:
        yield Fault((*path, "plane"), "is strain for a membrane in space.", "Leave it at stress.", about=(("nodes",),))


def _poisson(model: ModelData, chosen: Any) -> float:
    material = model.materials[chosen] if isinstance(chosen, str) else chosen
    return material.poisson if isinstance(material, Material) else 0.0


def _shapes(model: ModelData, part: Any, path: tuple[str, str], dim: int) -> Iterator[Fault]:
    """Elements that are flat, inverted, or name a node twice."""
    x = np.array([model.nodes[node].at for node in part.nodes])
    rows = np.array(part.elements)
    content, size = _content(x[rows], dim)
    flat = np.abs(content) <= FLAT * size
    mend = "Move a node, or take the element out."
    yield from _faults_of(path, flat, rows, part, "are flat" if flat.sum() > 1 else "is flat", mend)
    if path[0] == "solids" or dim == 2:
        turned = (content < 0) & ~flat
        what = "turned inside out" if path[0] == "solids" else "clockwise"
        mend = "Swap two of its nodes." if path[0] == "solids" else "Give its nodes counter-clockwise."
        yield from _faults_of(path, turned, rows, part, f"{'are' if turned.sum() > 1 else 'is'} {what}", mend)
    if getattr(part, "axis", None) is not None and dim == 3 and not flat.any():
        a, b, c = (x[rows[:, k]] for k in range(3))
        normal = np.cross(b - a, c - a)
        along = np.abs(normal @ np.array(part.axis)) / (np.linalg.norm(normal, axis=1) * np.linalg.norm(part.axis))
        mend = "Choose an axis that lies across no element, or split the membrane."
        yield from _faults_of(path, along > 1 - 1e-9, rows, part, "stand across axis", mend)


def _content(points: NDArray[np.float64], dim: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Signed volume or area (k,) of elements with points (k, v, dim), the least of their parts, and a reference value."""
    if points.shape[1] == 4:
        d = points[:, 1:] - points[:, :1]
        return np.linalg.det(d), np.abs(d).max(axis=(1, 2)) ** 3
    four = ((0, 1, 2),) if points.shape[1] == 3 else ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
    found, size = [], []
    for a, b, c in four:
        u, v = points[:, b] - points[:, a], points[:, c] - points[:, a]
        u, v = (np.pad(w, ((0, 0), (0, 3 - dim))) for w in (u, v))
        normal = np.cross(u, v)
        found.append(normal[:, 2] if dim == 2 else np.linalg.norm(normal, axis=1))
        size.append(np.maximum(np.sum(u * u, axis=1), np.sum(v * v, axis=1)))
    return np.min(found, axis=0), np.max(size, axis=0)


def _faults_of(path: tuple[str, str], bad: NDArray[np.bool_], rows: Any, part: Any, what: str, mend: str) -> Iterator[Fault]:
    """One fault for all elements with the same fault, the first of them named."""
    found = np.flatnonzero(bad)
    if not len(found):
        return
    named = few([f"{int(k)} ({', '.join(part.nodes[i] for i in rows[k])})" for k in found], SHOWN, "; ")
    about = tuple(("nodes", part.nodes[i]) for i in rows[found[0]])
    yield Fault((*path, "elements", int(found[0])), f"elements {named} {what}.", mend, about=about)
