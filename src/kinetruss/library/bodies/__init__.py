"""Bodies: adding them to a model by mass properties or shapes; mass properties of shapes and surfaces; equivalent bars."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from kinetruss.late import listed
from kinetruss.library._arguments import own_arguments
from kinetruss.library.bodies.mass_properties import (
    BarMasses,
    MassProperties,
    bar_masses,
    combined,
    mass_properties,
    properties_of,
)
from kinetruss.library.bodies.place_body import Nodes, rigid, uniform
from kinetruss.library.bodies.shapes import (
    box_properties,
    cylinder_properties,
    plate_properties,
    rod_properties,
    sphere_properties,
    tetrahedron_properties,
    tube_properties,
)
from kinetruss.library.bodies.stl import from_stl, read_stl, surface_properties
from kinetruss.model import Model

__all__ = [
    "BarMasses",
    "MassProperties",
    "bar_masses",
    "box",
    "box_properties",
    "combined",
    "cylinder",
    "cylinder_properties",
    "flat",
    "from_stl",
    "mass_properties",
    "plate_properties",
    "properties_of",
    "read_stl",
    "rigid",
    "rod_properties",
    "sphere",
    "sphere_properties",
    "stl",
    "surface_properties",
    "tetrahedron_properties",
    "tube",
    "tube_properties",
    "uniform",
]

__dir__ = listed(__name__)


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
