"""Bodies: mass carried by a few nodes, and their mass matrices."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, PlainValidator, WithJsonSchema, model_validator

from kinetruss.errors import shown
from kinetruss.model.record import Flag, Mass, Number, Point, Record, Series, short_form
from kinetruss.model.references import NodeName
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model.data import ModelData


_KIND = "moment of inertia"


def _tensor(value: Any) -> Any:
    """One number, three principal moments, or the rows of a matrix."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, (list, tuple)):
        return parse(value, _KIND)
    rows = [isinstance(row, (list, tuple)) for row in value]
    if all(rows) and len(value) in (2, 3) and all(len(row) == len(value) for row in value):
        return tuple(tuple(parse(entry, _KIND) for entry in row) for row in value)
    if any(rows) or len(value) != 3:
        raise ValueError(f"{shown(value)} is no inertia. Give one number (plane), three principal moments, or a 3 x 3 matrix.")
    return tuple(parse(entry, _KIND) for entry in value)


_ONE: dict[str, Any] = {"anyOf": [{"type": "number"}, {"type": "string"}]}
_ROW = {"type": "array", "items": _ONE, "minItems": 2, "maxItems": 3}
_SCHEMA = {
    "anyOf": [
        *_ONE["anyOf"],
        {"type": "array", "items": _ONE, "minItems": 3, "maxItems": 3},
        {"type": "array", "items": _ROW, "minItems": 2, "maxItems": 3},
    ],
    "description": "moment of inertia: a number in kg m^2 or text with a unit; three of them; or a matrix",
    "x-unit": "kg m^2",
}
InertiaTensor = Annotated[Any, PlainValidator(_tensor), WithJsonSchema(_SCHEMA)]
"""kg m^2: one number (plane), principal moments about the axes of a frame, or a matrix in it."""

_Axis = Annotated[tuple[Number, ...], Field(min_length=2, max_length=3), Series]


class Frame(Record):
    """Axes fixed in a body, given in the start configuration.

    origin : m, in global axes; 0 if not given. axes : one row each, the unit vectors of the frame in global axes, a right-
    handed set; the global axes if not given.
    """

    origin: Point | None = None
    axes: Annotated[tuple[_Axis, ...], Field(min_length=2, max_length=3), Series] | None = None


class Body(Record):
    """A body with mass, carried by nodes.

    frame : axes fixed in the body in which `center` and `inertia` are given; by default the global axes.
    nodes : the nodes of the body; other bodies and bars share them (joints).
    mass : kg. center : its centre, m, and inertia : about the centre, kg m^2, both in `frame`: one number in the plane;
        in space the three moments about the axes of the frame, or a 3 x 3 matrix. Without them the mass is distributed evenly
        over the line, triangle or tetrahedron of the carriers.
    carriers : the mass-carrying nodes, by default the first three (plane) or four (space) of `nodes`: a tetrahedron, a
        triangle (flat in space), a line.
    kind : ``rigid``, or ``straining``: the body strains evenly with its carriers, which bars may lengthen (in the plane and
        with two carriers: by similarity).
    brace : missing rigid bars between the nodes are added in `Model.whole`; they have no mass, and are called ``BODY.N1-N2``.

    The mass matrix of the nodes' coordinates is constant: m_ij times the unit matrix with m_ij = int L_i L_j dm over the body,
    L_i the barycentric coordinates of the carriers; in the plane two carriers represent the whole body as in `PlanarBody`.
    The concept: J. P. Meijaard and V. van der Wijk, Multibody System Dynamics 48 (2020) 259-282.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> list(kt.Model(nodes=corners, bodies={"b": kt.Body(nodes=("O", "X", "Y", "Z"), mass=2.0)}).whole.bars)
    ['b.O-X', 'b.O-Y', 'b.O-Z', 'b.X-Y', 'b.X-Z', 'b.Y-Z']
    """

    nodes: Annotated[tuple[NodeName, ...], Field(min_length=1), Series]
    mass: Mass = 0.0
    center: Point | None = None
    inertia: InertiaTensor | None = None
    frame: Frame | None = None
    carriers: Annotated[tuple[NodeName, ...], Field(min_length=1), Series] | None = None
    kind: Literal["rigid", "straining"] = "rigid"
    brace: Flag = True

    @model_validator(mode="before")
    @classmethod
    def _from_nodes(cls, value: Any) -> Any:
        return short_form(value, "nodes")

    def carried_by(self, dim: int) -> tuple[str, ...]:
        """The mass-carrying nodes in a model of dimension 2 or 3."""
        return self.nodes[: dim + 1] if self.carriers is None else self.carriers


# Mass matrix of a body at its carriers: m_ij = int L_i L_j dm, and the inverse; shapes and sizes of simplices.
#
# With the second moments S about the centre c, J = [[S + m c c^T, m c], [m c^T, m]] and A = [[r_1 .. r_k], [1 .. 1]] of the
# positions of the carriers, m_ij = A^+ J A^+T (Garcia de Jalon & Bayo, 1994, for natural coordinates); S = (tr I/2) 1 - I in
# space.

Floats = Any


def placed(frame: Frame | None, dim: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Origin (dim,) m and axes (dim, dim) of a frame, rows, made exactly orthonormal."""
    origin = np.zeros(dim) if frame is None or frame.origin is None else np.array(frame.origin, float)
    if frame is None or frame.axes is None:
        return origin, np.eye(dim)
    left, _, right = np.linalg.svd(np.array(frame.axes, float))
    return origin, np.asarray(left @ right)


def inertia_of(body: Body, dim: int) -> NDArray[np.float64]:
    """The central inertia in global axes: (3, 3) in space; in the plane (2, 2), one number as half of it about each axis."""
    given = np.array(0.0 if body.inertia is None else body.inertia, float)
    tensor = np.diag(given) if given.ndim == 1 else 0.5 * given * np.eye(dim) if given.ndim == 0 else given
    axes = placed(body.frame, dim)[1]
    return np.asarray(axes.T @ tensor @ axes)


def second_moments(inertia: NDArray[np.float64]) -> NDArray[np.float64]:
    """S = int d d^T dm from the inertia, (3, 3) or of the plane (2, 2), about the same point."""
    trace = np.trace(inertia)
    return np.asarray((trace if len(inertia) == 2 else 0.5 * trace) * np.eye(len(inertia)) - inertia)


def principal(body: Body, dim: int) -> NDArray[np.float64]:
    """Principal moments about the centre, kg m^2, least first: three, or one of the plane."""
    tensor = inertia_of(body, dim)
    return np.asarray(np.trace(tensor).reshape(1) if dim == 2 else np.linalg.eigvalsh(tensor))


def uniform(mass: float, count: int) -> NDArray[np.float64]:
    """m_ij (k, k), kg, of mass spread evenly over a simplex of `count` corners: m/10 and m/20 of a tetrahedron."""
    return np.asarray(mass * (1.0 + np.eye(count)) / (count * (count + 1)))


def on_carriers(points: Floats, mass: float, center: Floats, S: Floats) -> tuple[NDArray[np.float64], float]:
    """m_ij (k, k), kg, of carriers at points (k, dim), m, and the misfit: mass off their line or plane, as a fraction.

    center (dim,) m, S (dim, dim) kg m^2 about it.
    """
    points = np.asarray(points, float)
    middle = points.mean(axis=0)
    r, c = points - middle, np.asarray(center, float) - middle
    size = float(np.abs(r).max())
    r, c = r / size, c / size
    J = np.block([[S / size**2 + mass * np.outer(c, c), mass * c[:, None]], [mass * c[None], np.array([[mass]])]])
    A = np.vstack([r.T, np.ones(len(r))])
    back = np.linalg.pinv(A)
    m = back @ J @ back.T
    largest = float(np.abs(J).max())
    return 0.5 * (m + m.T), float(np.abs(A @ m @ A.T - J).max()) / largest if largest else 0.0


def on_line(p: Floats, q: Floats, mass: float, center: Floats, inertia: float) -> tuple[float, float, float, float]:
    """m_pp, m_pq, m_qq and the skew part of a whole planar body at two nodes (see kernels.structure.bodies), kg."""
    d, c = np.asarray(q, float) - p, np.asarray(center, float) - p
    ll = float(d @ d)
    e, f = float(c @ d) / ll, float(d[0] * c[1] - d[1] * c[0]) / ll
    polar = inertia / ll + mass * f * f
    return polar + mass * (1 - e) ** 2, mass * e * (1 - e) - polar, polar + mass * e * e, mass * f


def carried(points: Floats, m: Floats) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
    """Mass, centre (dim,) and S about it (dim, dim) of m_ij (k, k) at points (k, dim)."""
    points, m = np.asarray(points, float), np.asarray(m, float)
    mass = float(m.sum())
    shares = m.sum(axis=1)
    center = shares @ points / mass if mass else points.mean(axis=0)
    r = points - center
    return mass, np.asarray(center), np.asarray(r.T @ m @ r)


@cache
def _pairs(count: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Both indices of each pair of `count` points."""
    return np.triu_indices(count, 1)


def quality(points: Floats) -> float:
    """Normalised volume of a simplex of points (k, dim): 1 for a regular one, 0 if the points span a lower dimension."""
    points = np.asarray(points, float)
    edges = points[1:] - points[0]
    k = len(edges)
    if not k:
        return 1.0
    i, j = _pairs(k + 1)
    mean = float(((points[i] - points[j]) ** 2).sum(axis=1).mean())
    if mean == 0.0 or k > points.shape[1]:
        return 0.0
    # the product of singular values of the edges of a regular simplex of edge 1 is sqrt((k + 1)/2^k)
    volume = float(np.prod(np.linalg.svd(edges, compute_uv=False)[:k]))
    return float(volume / mean ** (k / 2) / np.sqrt((k + 1) / 2**k))


def body_mass(model: ModelData, body: Body) -> tuple[NDArray[np.float64], float]:
    """m_ij (k, k), kg, of the carriers of a body at their positions in the model, and the skew part of two in the plane.

    >>> import kinetruss as kt
    >>> body = kt.Body(nodes=("A", "B"), mass=6.0)
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bodies={"rod": body})
    >>> kt.model.body_mass(model, body)[0].round(9).tolist()  # kg: m/3 and m/6, as of a slender rod
    [[2.0, 1.0], [1.0, 2.0]]
    """
    dim = model.dim
    points = np.array([model.nodes[name].at for name in body.carried_by(dim)], float)
    if body.center is None:
        return uniform(body.mass, len(points)), 0.0
    origin, axes = placed(body.frame, dim)
    center = origin + axes.T @ np.array(body.center, float)
    inertia = inertia_of(body, dim)
    if dim == 2 and len(points) == 2:
        pp, pq, qq, skew = on_line(points[0], points[1], body.mass, center, float(np.trace(inertia)))
        return np.array([[pp, pq], [pq, qq]]), skew
    return on_carriers(points, body.mass, center, second_moments(inertia))[0], 0.0


def barycentric(points: Floats, place: Floats) -> tuple[NDArray[np.float64], float]:
    """L_i (k,) of a place relative to points (k, dim), and its distance from their span, m."""
    points, place = np.asarray(points, float), np.asarray(place, float)
    middle = points.mean(axis=0)
    size = float(np.abs(points - middle).max())
    A = np.vstack([(points - middle).T / size, np.ones(len(points))])
    shares = np.linalg.pinv(A) @ np.append((place - middle) / size, 1.0)
    return np.asarray(shares), float(np.linalg.norm(shares @ points - place))


def fixed_vector(points: Floats, vector: Floats) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coefficients c (k,) of points (k, dim) with sum 0 that make a vector fixed in the body, and its misfit."""
    points, vector = np.asarray(points, float), np.asarray(vector, float)
    r = points - points.mean(axis=0)
    size = float(np.abs(r).max())
    c = np.linalg.pinv(np.vstack([r.T / size, np.ones(len(r))])) @ np.append(vector, 0.0) / size
    return np.asarray(c), np.asarray(vector - c @ points)
