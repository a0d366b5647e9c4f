"""Membranes and solids: meshes of triangles and tetrahedra, and their cross-checks."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, WithJsonSchema, model_validator
from pydantic_core import core_schema

from kinetruss.errors import Fault, few
from kinetruss.model.common_faults import components
from kinetruss.model.record import Density, Number, PositiveLength, Record, Series, Stress
from kinetruss.model.references import NodeName
from kinetruss.model.sections import Material, MaterialOrName

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model.data import ModelData


def _elements(value: Any) -> tuple[tuple[int, ...], ...]:
    """A table of whole numbers, one row per element: nested lists, an array, or text with rows separated by ; or line ends."""
    if isinstance(value, str):
        value = [line.replace(",", " ").split() for line in value.replace(";", "\n").splitlines() if line.strip()]
    try:
        table = np.array(value)
        if table.dtype.kind not in "iufUO":
            raise TypeError(table.dtype)
        with np.errstate(invalid="raise"):
            whole = table.astype(np.int64)
    except (TypeError, ValueError, OverflowError, FloatingPointError):
        raise ValueError("the elements are no table of whole numbers. Give rows of equal length, e.g. [[0, 1, 2]].") from None
    if table.ndim != 2 or not table.size or (table.dtype.kind == "f" and np.any(whole != table)):
        raise ValueError(f"the elements have shape {table.shape}. Give one row of node numbers for each, e.g. [[0, 1, 2]].")
    if whole.min() < 0:
        raise ValueError(f"the elements name node {whole.min()}. Count nodes from 0.")
    return tuple(map(tuple, whole.tolist()))


class _Table:
    """Annotation of a table; the plain schema reads and writes tables of any size in one call."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(_elements)


_ROWS = {"type": "array", "items": {"type": "array", "items": {"type": ["integer", "string"]}}}
Elements = Annotated[
    tuple[tuple[int, ...], ...],
    _Table(),
    WithJsonSchema({"anyOf": [_ROWS, {"type": "string"}], "description": "one row of nodes for each element"}),
]
"""Rows of places in `nodes`, counted from 0."""

Axis = Annotated[tuple[Number, ...], Field(min_length=2, max_length=3), Series]


class Orthotropic(Record):
    """Orthotropic elastic material: moduli E1 E2 E3, shear moduli G12 G13 G23 (Pa), ratios nu12 nu13 nu23, density.

    nu12 is minus the strain along 2 over that along 1 under tension along 1; nu21 = nu12 E2/E1. Plane stress needs only E1,
    E2, nu12 and G12.

    E1, E2, E3 : moduli along the axes 1, 2, 3, Pa. G12, G13, G23 : shear moduli, Pa. nu12, nu13, nu23 : ratios.
    source : where the values come from.
    """

    E1: Stress
    E2: Stress
    nu12: Number
    G12: Stress
    E3: Stress | None = None
    nu13: Number | None = None
    nu23: Number | None = None
    G13: Stress | None = None
    G23: Stress | None = None
    density: Density = 0.0
    source: str = ""

    @property
    def spatial(self) -> bool:
        """True if the constants across the plane 1, 2 are given as well."""
        return None not in (self.E3, self.nu13, self.nu23)

    @model_validator(mode="after")
    def _possible(self) -> Orthotropic:
        if abs(self.nu12) >= math.sqrt(self.E1 / self.E2):
            most = math.sqrt(self.E1 / self.E2)
            raise ValueError(f"nu12 {self.nu12:g} gives energy for nothing. Give |nu12| below sqrt(E1/E2) = {most:g}.")
        if self.E3 is not None and self.nu13 is not None and self.nu23 is not None:
            S = np.diag([1 / self.E1, 1 / self.E2, 1 / self.E3])
            S[0, 1] = S[1, 0] = -self.nu12 / self.E1
            S[0, 2] = S[2, 0] = -self.nu13 / self.E1
            S[1, 2] = S[2, 1] = -self.nu23 / self.E2
            if np.linalg.eigvalsh(S / math.sqrt(np.prod(np.diag(S)) ** (2 / 3)))[0] <= 0:
                raise ValueError(
                    f"nu12 {self.nu12:g}, nu13 {self.nu13:g}, nu23 {self.nu23:g} together give energy for nothing. "
                    "Give smaller ratios; nu_ij belongs to E_i."
                )
        return self


def _named(value: Any) -> Any:
    """Convert rows of node names to `nodes` and rows of their places."""
    if not isinstance(value, dict) or value.get("nodes") is not None:
        return value
    rows = value.get("elements")
    if isinstance(rows, (list, tuple)) and all(isinstance(row, (list, tuple)) for row in rows):
        names = list(dict.fromkeys(name for row in rows for name in row if isinstance(name, str)))
        if names and all(isinstance(name, str) for row in rows for name in row):
            place = {name: k for k, name in enumerate(names)}
            return value | {"nodes": names, "elements": [[place[name] for name in row] for row in rows]}
    return value


def _columns(elements: tuple[tuple[int, ...], ...], nodes: tuple[str, ...], allowed: tuple[int, ...], what: str) -> None:
    if len(elements[0]) not in allowed:
        counts = " or ".join(map(str, allowed))
        raise ValueError(f"elements have {len(elements[0])} nodes each; {what} have {counts}. Give {counts} a row.")
    most = max(map(max, elements))
    if most >= len(nodes):
        raise ValueError(f"elements name node {most}; the {len(nodes)} nodes are counted from 0. Give it, or mend the row.")


class Membrane(Record):
    """An elastic skin of triangles: a plate loaded in its plane (planar models), a membrane in space.

    nodes : names of nodes of the model. elements : rows of three places in `nodes`, counted from 0, or of six (corners, then
        the middles of sides 1-2, 2-3, 3-1); or rows of node names, without `nodes`. The start configuration is free of stress.
    thickness : m. material : name or record, isotropic (E and `poisson`); by default that of the model. orthotropic : instead.
    axis : direction of material axis 1, projected onto the plane of each element; by default x. Axis 2 lies to its left (in
        space: about the normal of the element's corners). plane : ``stress``, or ``strain`` in planar models.
    strain : of six-node triangles, ``constant`` in each of four triangles between its nodes, or ``linear`` over the whole.

    Strain is Green's, E = (F^T F - 1)/2, from the elongations of the edges; stress is proportional to it (St Venant-Kirchhoff).
    Its mass is that of uniform triangles. It also carries compression: wrinkling is not modelled.
    """

    nodes: Annotated[tuple[NodeName, ...], Series]
    elements: Elements
    thickness: PositiveLength
    material: MaterialOrName | None = None
    orthotropic: Orthotropic | None = None
    axis: Axis | None = None
    plane: Literal["stress", "strain"] = "stress"
    strain: Literal["constant", "linear"] = "constant"

    _read_names = model_validator(mode="before")(_named)

    @model_validator(mode="after")
    def _table(self) -> Membrane:
        _columns(self.elements, self.nodes, (3, 6), "triangles")
        return self


class Solid(Record):
    """An elastic solid of tetrahedra (spatial models), each under constant strain.

    nodes : names of nodes of the model. elements : rows of four places in `nodes`, counted from 0, the first three
        counter-clockwise as seen from the fourth (a positive volume); or rows of node names.
    material : name or record, isotropic (E and `poisson`); by default that of the model. orthotropic : instead, with E3, nu13,
        nu23, G13, G23. axes : directions of material axes 1 and 2; by default x and y. Strain and mass as in `Membrane`.
    """

    nodes: Annotated[tuple[NodeName, ...], Series]
    elements: Elements
    material: MaterialOrName | None = None
    orthotropic: Orthotropic | None = None
    axes: tuple[Axis, Axis] | None = None

    _read_names = model_validator(mode="before")(_named)

    @model_validator(mode="after")
    def _table(self) -> Solid:
        _columns(self.elements, self.nodes, (4,), "tetrahedra")
        return self


# Faults of membranes and solids: nodes, materials, and the shape of their elements.

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
    good = all(node in model.nodes and len(model.nodes[node].at) == dim for node in part.nodes)
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
    """No material, or one that this law does not support."""
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
    elif (solid or part.plane == "strain") and _poisson(model, chosen) > 0.499999:
        mend = "Give poisson below 0.5, e.g. 0.49."
        yield Fault(path, "has an incompressible material (poisson 0.5), which this law cannot take.", mend, about=about)
    if not solid and part.plane == "strain" and dim == 3:
        yield Fault((*path, "plane"), "is strain for a membrane in space.", "Leave it at stress.", about=(("nodes",),))


def _poisson(model: ModelData, chosen: Any) -> float:
    material = model.materials.get(chosen) if isinstance(chosen, str) else chosen
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
