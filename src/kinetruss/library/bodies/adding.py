"""Adds bodies to a model: their mass-carrying nodes and joints; bodies of simple shapes and closed surfaces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.library.bodies.masses import MassProperties, numbers, refuse_impossible, span_points
from kinetruss.library.bodies.shapes import (
    box_properties,
    cylinder_properties,
    from_stl,
    plate_properties,
    sphere_properties,
    tube_properties,
)
from kinetruss.library.building import own_arguments
from kinetruss.model import Body, Model, Node, nearest
from kinetruss.model.bodies import quality, second_moments
from kinetruss.model.bracing import FLAT, beside

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


THIN = 1e-9
"""A body has no extent in a direction if the second moment is below this fraction of the largest."""
WIDE = 0.1
"""Least thickness of the carrying tetrahedron as a fraction of its length; the mass matrix is exact for any thickness."""
GOOD = 0.05
"""Least normalised volume of existing nodes that serve as carriers."""

Nodes = Sequence[str] | Mapping[str, Any]


@own_arguments
def rigid(
    model: Model,
    name: str,
    properties: MassProperties | None = None,
    *,
    mass: float = 0.0,
    center: ArrayLike | None = None,
    inertia: ArrayLike | None = None,
    nodes: Nodes = (),
    points: Mapping[str, Any] | ArrayLike | None = None,
) -> Model:
    """The model with a rigid body added.

    Parameters
    ----------
    name : of the body, and prefix of the names of its own nodes and bars.
    properties : mass, centre and inertia; or `mass`, kg, `center`, m, and `inertia` about it, kg m^2, global axes (one number
        in the plane; three moments or 3 x 3 in space).
    nodes : the nodes of the body: names of existing nodes (shared with others: joints), or name -> point of new ones.
    points : the carriers of the mass: 4 (a flat body 3, a rod 2; in the plane 2 or 3) points, m, or name -> point. By default
        nodes that span a good tetrahedron, else new ones ``NAME.1``, ... along the principal axes: alternate corners of the
        cuboid with the same moments (the equivalent masses are then m/4 for each of the six bars and -m/8 for each corner), at
        least a tenth as thick as long; the corners of a uniform triangle of a flat body, the ends of a uniform rod, in the
        plane two points of mass m/2.

    Returns
    -------
    Model. If all nodes lie in one plane, which bars hold to second order only, a node ``NAME.apex`` is added off the plane.

    Raises
    ------
    InputError : a name that is in use, no mass, an unknown node. ModelError : an impossible body.

    >>> import kinetruss as kt
    >>> ground = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"], gravity=(0, 0, -9.81))
    >>> top = kt.library.bodies.rigid(ground, "top", mass=1.0, center=(0, 0, 0.1), inertia=(2e-3, 2e-3, 1e-3), nodes=["O"])
    >>> len(top.nodes), len(top.whole.bars), kt.kinematics.mobility(top).degrees_of_freedom
    (5, 9, 3)
    """
    if name in model.bodies:
        raise InputError(f"There is a body called {name!r} already. Give another name.")
    given = properties or _properties(name, model.dim, mass, center, inertia)
    if len(given.center) != model.dim:
        raise InputError(
            f"Body {name!r} has {len(given.center)} axes, the model {model.dim}. Give properties of that dimension."
        )
    refuse_impossible(f"Body {name!r}", given.mass, given.inertia)
    known = {key: np.array(node.at, float) for key, node in model.whole.nodes.items()}
    at = _attached(known, nodes)
    carriers = _given_points(known, name, points, model.dim) if points is not None else _carriers(name, given, at)
    every = {**carriers, **at}
    for place in _apexes(np.array(list(every.values()))):
        every[_free(f"{name}.apex", known | every)] = place
    fields: dict[str, Any] = {"nodes": tuple(every), "carriers": tuple(carriers), "mass": given.mass}
    if given.mass:
        inertia_given = given.inertia.tolist() if model.dim == 3 else float(given.inertia)
        fields |= {"center": tuple(given.center.tolist()), "inertia": inertia_given}
    new = {key: Node(at=tuple(place.tolist())) for key, place in every.items() if key not in known}
    return model.with_(nodes={**model.nodes, **new}, bodies={**model.bodies, name: Body(**fields)})


@own_arguments
def uniform(
    model: Model, name: str, nodes: Nodes, *, mass: float | None = None, density: float | None = None, kind: str = "rigid"
) -> Model:
    """The model with a body added whose mass is distributed evenly over the tetrahedron, triangle or line of its nodes.

    mass kg, or density: kg per m^3, m^2 or m of it. kind : ``rigid`` or ``straining``.

    >>> import kinetruss as kt
    >>> corners = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "D": (0, 0, 1)}
    >>> start = kt.Model(nodes={"A": (0, 0, 0)})
    >>> kt.library.bodies.uniform(start, "stone", corners, density=6.0).bodies["stone"].mass
    1.0
    """
    known = {key: np.array(node.at, float) for key, node in model.whole.nodes.items()}
    at = _attached(known, nodes)
    if (mass is None) == (density is None):
        raise InputError("Give either the mass (kg) or the density (kg per m^3, m^2 or m).")
    if mass is None:
        edges = np.array(list(at.values()))[1:] - next(iter(at.values()))
        size = float(np.prod(np.linalg.svd(edges, compute_uv=False)))
        mass = float(density or 0.0) * size / (1, 1, 2, 6)[min(len(edges), 3)]
    new = {key: Node(at=tuple(place.tolist())) for key, place in at.items() if key not in known}
    body = Body(nodes=tuple(at), mass=mass, kind=kind)
    return model.with_(nodes={**model.nodes, **new}, bodies={**model.bodies, name: body})


def _properties(name: str, dim: int, mass: float, center: ArrayLike | None, inertia: ArrayLike | None) -> MassProperties:
    if center is None or inertia is None:
        if mass:
            raise InputError(f"Body {name!r} has mass only. Give center (m) and inertia (kg m^2) with it, or properties.")
        return MassProperties(mass=0.0, center=np.zeros(dim), inertia=np.zeros((3, 3)) if dim == 3 else np.asarray(0.0))
    place, tensor = numbers(f"center of body {name!r}", center), numbers(f"inertia of body {name!r}", inertia)
    tensor = np.diag(tensor) if tensor.ndim == 1 else tensor
    if tensor.shape != ((3, 3) if dim == 3 else ()):
        raise InputError(
            f"inertia of body {name!r} has the shape {np.shape(inertia)}. Give "
            f"{'three moments or 3 x 3' if dim == 3 else 'a number'}, kg m^2."
        )
    return MassProperties(mass=float(mass), center=place, inertia=tensor)


def _attached(known: Mapping[str, NDArray[np.float64]], nodes: Nodes) -> dict[str, NDArray[np.float64]]:
    """Nodes of the body by name: existing ones and new ones."""
    found = {}
    for key in nodes:
        place = nodes[key] if isinstance(nodes, Mapping) else None
        if place is None or key in known:
            if key not in known:
                raise InputError(f"No node called {key!r}. {nearest(key, known)} Or give its place: {{{key!r}: (...)}}.")
            if place is not None and not np.allclose(known[key], np.array(place, float)):
                raise InputError(f"Node {key!r} stands at {known[key].tolist()} already. Leave out its place, or name another.")
        found[key] = known[key] if key in known else np.array(place, float)
    return found


def _given_points(known: Mapping[str, Any], name: str, points: Any, dim: int) -> dict[str, NDArray[np.float64]]:
    """The given carriers of a body, which must span a tetrahedron, a triangle or a line."""
    if not isinstance(points, Mapping) and (shape := np.shape(points)) and (len(shape) != 2 or shape[1] != dim):
        raise InputError(f"points of body {name!r} has the shape {shape}. Give rows of {dim} coordinates, m.")
    found = _named_points(known, name, points)
    if not 2 <= len(found) <= dim + 1:
        raise InputError(f"points of body {name!r} names {len(found)}. Give {dim + 1}; of a flat body 3, of a rod 2.")
    span_points(f"points of body {name!r}", list(found), np.array(list(found.values())))
    return found


def _named_points(known: Mapping[str, Any], name: str, points: Any) -> dict[str, NDArray[np.float64]]:
    if isinstance(points, Mapping):
        return _attached(known, points)
    return {_free(f"{name}.{k + 1}", known): place for k, place in enumerate(np.array(points, float))}


def _free(name: str, known: Mapping[str, Any]) -> str:
    while name in known:
        name += "'"
    return name


def _carriers(name: str, given: MassProperties, at: dict[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    """Existing nodes that can carry the mass, or new ones."""
    dim = len(given.center)
    places, flat = (_plane_points(given), False) if dim == 2 else _points(given)
    count = len(places) or min(dim + 1, len(at))
    if not flat and (not len(places) or dim == 2 or len(places) == 4):
        sets = islice(combinations(at, count), 2000)
        best = max(sets, key=lambda names: quality([at[key] for key in names]), default=())
        if best and quality([at[key] for key in best]) > (GOOD if given.mass else FLAT):
            return {key: at[key] for key in best}
    if not len(places):
        raise InputError(
            f"The body {name!r} has neither mass nor nodes that make a body. Give mass properties, or {dim + 1} nodes."
        )
    return _named_points(at, name, places)


def _plane_points(given: MassProperties) -> NDArray[np.float64]:
    """Two points of mass m/2 each (2, 2); none without mass."""
    if not given.mass:
        return np.zeros((0, 2))
    reach = float(np.sqrt(given.inertia / given.mass))
    if not reach > 0:
        raise InputError("The body has no moment of inertia: it is a point. Give the mass to a node.")
    return np.asarray(given.center + np.array([[-reach, 0.0], [reach, 0.0]]))


def _points(given: MassProperties) -> tuple[NDArray[np.float64], bool]:
    """Default carriers of a spatial body, (k, 3) m, and whether it is flat or a rod."""
    if not given.mass:
        return np.zeros((0, 3)), False
    values, axes = np.linalg.eigh(second_moments(given.inertia))
    axes = axes[:, ::-1] * np.sign(axes[np.abs(axes).argmax(axis=0), np.arange(3)])[::-1]
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    spread = np.sqrt(np.maximum(values[::-1], 0.0) / given.mass)
    extent = int(np.sum(spread**2 > THIN * spread[0] ** 2)) if spread[0] > 0 else 0
    if extent == 0:
        raise InputError("The body has no moments of inertia: it is a point. Give the mass to a node.")
    if extent == 3:
        local = np.sqrt(3.0) * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
        # the bars of a needle would be nearly parallel
        spread = np.maximum(spread, WIDE * spread[0])
    elif extent == 2:
        turns = np.pi / 2 + 2 * np.pi / 3 * np.arange(3)
        local = np.sqrt(8.0) * np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    else:
        local = np.sqrt(3.0) * np.array([[-1.0, 0, 0], [1.0, 0, 0]])
    return given.center + (local * spread) @ axes.T, extent < 3


def _apexes(points: NDArray[np.float64]) -> list[Any]:
    """Places off the points, if bars between the points alone hold them to second order only."""
    more = beside(points, points.shape[1])
    span = points.shape[1] - len(more)
    return more if len(points) > span + 1 else []


# Bodies of simple shapes, and of closed surfaces, added to a model.


@own_arguments
def box(model: Model, name: str, size: Any, *, nodes: Nodes = (), points: Any = None, **given: Any) -> Model:
    """The model with a box added; `given`: mass or density, at, axes as in `box_properties`, nodes and points as in `rigid`.

    >>> import kinetruss as kt
    >>> floor = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    >>> corner = kt.library.bodies.box(floor, "crate", (1, 2, 3), mass=12.0, nodes=["O"]).nodes["crate.1"].at
    >>> [round(abs(x), 12) for x in corner]
    [0.5, 1.0, 1.5]
    """
    return rigid(model, name, box_properties(size, **given), nodes=nodes, points=points)


@own_arguments
def cylinder(
    model: Model, name: str, length: float, radius: float, *, nodes: Nodes = (), points: Any = None, **given: Any
) -> Model:
    """The model with a cylinder added; see `cylinder_properties` and `rigid`.

    >>> import kinetruss as kt
    >>> post = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    >>> model = kt.library.bodies.cylinder(post, "drum", 0.5, 0.2, mass=12.0)
    >>> found = kt.library.bodies.properties_of(model, "drum")
    >>> found.mass, found.inertia.diagonal().round(6).tolist()  # kg; kg m^2: m l^2/12 + m r^2/4, and m r^2/2
    (12.0, [0.37, 0.37, 0.24])
    """
    return rigid(model, name, cylinder_properties(length, radius, **given), nodes=nodes, points=points)


@own_arguments
def tube(
    model: Model,
    name: str,
    length: float,
    outer_radius: float,
    inner_radius: float,
    *,
    nodes: Nodes = (),
    points: Any = None,
    **given: Any,
) -> Model:
    """The model with a tube added; see `tube_properties` and `rigid`.

    >>> import kinetruss as kt
    >>> post = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    >>> model = kt.library.bodies.tube(post, "mast", 1.0, 0.2, 0.1, mass=12.0)
    >>> found = kt.library.bodies.properties_of(model, "mast")
    >>> found.mass, found.inertia.diagonal().round(6).tolist()  # kg; kg m^2: m l^2/12 + m (R^2 + r^2)/4, and m (R^2 + r^2)/2
    (12.0, [1.15, 1.15, 0.3])
    """
    return rigid(model, name, tube_properties(length, outer_radius, inner_radius, **given), nodes=nodes, points=points)


@own_arguments
def sphere(model: Model, name: str, radius: float, *, nodes: Nodes = (), points: Any = None, **given: Any) -> Model:
    """The model with a sphere added; see `sphere_properties` and `rigid`.

    >>> import kinetruss as kt
    >>> post = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    >>> model = kt.library.bodies.sphere(post, "ball", 0.1, mass=12.0)
    >>> found = kt.library.bodies.properties_of(model, "ball")
    >>> found.mass, found.inertia.diagonal().round(6).tolist()  # kg; kg m^2: 2 m r^2/5
    (12.0, [0.048, 0.048, 0.048])
    """
    return rigid(model, name, sphere_properties(radius, **given), nodes=nodes, points=points)


@own_arguments
def flat(model: Model, name: str, size: Any, *, nodes: Nodes = (), points: Any = None, **given: Any) -> Model:
    """The model with a thin rectangular plate added, carried by three nodes; see `plate_properties` and `rigid`.

    >>> import kinetruss as kt
    >>> post = kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"])
    >>> model = kt.library.bodies.flat(post, "panel", (1.0, 2.0), mass=12.0)
    >>> found = kt.library.bodies.properties_of(model, "panel")
    >>> found.mass, found.inertia.diagonal().round(6).tolist()  # kg; kg m^2: m b^2/12, m a^2/12, their sum
    (12.0, [4.0, 1.0, 5.0])
    """
    return rigid(model, name, plate_properties(size, **given), nodes=nodes, points=points)


@own_arguments
def stl(model: Model, name: str, path: str | Path, *, nodes: Nodes = (), points: Any = None, **given: Any) -> Model:
    """The model with the body inside the surface of an STL file added; see `from_stl` and `rigid`.

    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> from kinetruss.library import bodies
    >>> o, x, y, z = "0 0 0", "1 0 0", "0 1 0", "0 0 1"
    >>> faces = ["facet outer vertex " + " vertex ".join(one) for one in ((o, y, x), (o, x, z), (o, z, y), (x, y, z))]
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "corner.stl")
    ...     _ = file.write_text("solid corner " + " ".join(faces))
    ...     model = bodies.stl(kt.Model(nodes={"O": (0, 0, 0)}, fixed=["O"]), "corner", file, mass=2.0)
    >>> model.bodies["corner"].mass, len(model.bodies["corner"].nodes)
    (2.0, 4)
    """
    return rigid(model, name, from_stl(path, **given), nodes=nodes, points=points)
