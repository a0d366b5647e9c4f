"""Membranes and solids: meshes of triangles and tetrahedra as edges with a coupled constitutive law, and their materials."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, WithJsonSchema, model_validator
from pydantic_core import core_schema

from kinetruss.model._record import Density, Name, Number, PositiveLength, Record, Series, Stress
from kinetruss.model.parts.sections import MaterialOrName

__all__ = ["Axis", "Elements", "Membrane", "Orthotropic", "Solid"]


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

    nodes: Annotated[tuple[Name, ...], Series]
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

    nodes: Annotated[tuple[Name, ...], Series]
    elements: Elements
    material: MaterialOrName | None = None
    orthotropic: Orthotropic | None = None
    axes: tuple[Axis, Axis] | None = None

    _read_names = model_validator(mode="before")(_named)

    @model_validator(mode="after")
    def _table(self) -> Solid:
        _columns(self.elements, self.nodes, (4,), "tetrahedra")
        return self
