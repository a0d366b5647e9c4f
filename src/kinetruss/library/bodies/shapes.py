"""Mass, centre and inertia of simple homogeneous shapes, and of a closed surface of triangles from an STL file."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.library.bodies.masses import MassProperties, span_points
from kinetruss.library.building import own_arguments

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def _mass(volume: float, mass: float | None, density: float | None) -> float:
    if (mass is None) == (density is None):
        raise InputError(f"Give either the mass (kg) or the density (kg/m^3), not {'both' if mass is not None else 'neither'}.")
    return float(mass) if mass is not None else float(density or 0.0) * volume


def _made(mass: float, moments: Sequence[float], at: ArrayLike, axes: ArrayLike | None) -> MassProperties:
    own = MassProperties(mass=mass, center=np.zeros(3), inertia=mass * np.diag(moments))
    return own.moved(at, axes)


def _positive(**sizes: float) -> None:
    for name, value in sizes.items():
        if not value > 0:
            raise InputError(f"{name} is {value:g} m. Give a size greater than 0.")


@own_arguments
def box_properties(
    size: Sequence[float],
    *,
    mass: float | None = None,
    density: float | None = None,
    at: ArrayLike = (0.0, 0.0, 0.0),
    axes: ArrayLike | None = None,
) -> MassProperties:
    """Box with edges `size` (3) m along its axes; its centre is at `at`, its axes are along the rows of `axes`.

    >>> from kinetruss.library import bodies
    >>> box = bodies.box_properties((1.0, 2.0, 3.0), density=100.0)
    >>> box.mass, box.inertia.diagonal().round(6).tolist()  # kg; kg m^2: m (b^2 + c^2)/12
    (600.0, [650.0, 500.0, 250.0])
    """
    a, b, c = map(float, size)
    _positive(size=min(a, b, c))
    moments = ((b * b + c * c) / 12, (a * a + c * c) / 12, (a * a + b * b) / 12)
    return _made(_mass(a * b * c, mass, density), moments, at, axes)


@own_arguments
def tube_properties(
    length: float,
    outer_radius: float,
    inner_radius: float = 0.0,
    *,
    mass: float | None = None,
    density: float | None = None,
    at: ArrayLike = (0.0, 0.0, 0.0),
    axes: ArrayLike | None = None,
) -> MassProperties:
    """Tube along its z axis, middle at `at`.

    >>> from kinetruss.library import bodies
    >>> tube = bodies.tube_properties(1.0, 0.2, 0.1, mass=10.0)
    >>> round(float(tube.inertia[2, 2]), 6)  # kg m^2, about its axis: m (R^2 + r^2)/2
    0.25
    """
    _positive(length=length, outer_radius=outer_radius, wall=outer_radius - inner_radius)
    square = outer_radius**2 + inner_radius**2
    across = square / 4 + length**2 / 12
    volume = math.pi * (outer_radius**2 - inner_radius**2) * length
    return _made(_mass(volume, mass, density), (across, across, square / 2), at, axes)


@own_arguments
def cylinder_properties(
    length: float,
    radius: float,
    *,
    mass: float | None = None,
    density: float | None = None,
    at: ArrayLike = (0.0, 0.0, 0.0),
    axes: ArrayLike | None = None,
) -> MassProperties:
    """Cylinder along its z axis, middle at `at`.

    >>> from kinetruss.library import bodies
    >>> roller = bodies.cylinder_properties(0.5, 0.2, mass=10.0)
    >>> round(float(roller.inertia[2, 2]), 6)  # kg m^2, about its axis: m r^2/2
    0.2
    """
    return tube_properties(length, radius, 0.0, mass=mass, density=density, at=at, axes=axes)


@own_arguments
def sphere_properties(
    radius: float, *, mass: float | None = None, density: float | None = None, at: ArrayLike = (0.0, 0.0, 0.0)
) -> MassProperties:
    """Solid sphere.

    >>> from kinetruss.library import bodies
    >>> ball = bodies.sphere_properties(0.5, mass=10.0, at=(0.0, 0.0, 1.0))
    >>> ball.center.tolist(), ball.inertia.diagonal().round(6).tolist()  # m; kg m^2: 2 m r^2/5
    ([0.0, 0.0, 1.0], [1.0, 1.0, 1.0])
    """
    _positive(radius=radius)
    return _made(_mass(4 / 3 * math.pi * radius**3, mass, density), (0.4 * radius**2,) * 3, at, None)


@own_arguments
def plate_properties(
    size: Sequence[float], *, mass: float, at: ArrayLike = (0.0, 0.0, 0.0), axes: ArrayLike | None = None
) -> MassProperties:
    """Thin rectangle with edges `size` (2) m along its x and y axes: a flat body.

    >>> from kinetruss.library import bodies
    >>> plate = bodies.plate_properties((1.0, 2.0), mass=12.0)
    >>> plate.inertia.diagonal().round(6).tolist()  # kg m^2: m b^2/12, m a^2/12, their sum
    [4.0, 1.0, 5.0]
    """
    a, b = map(float, size)
    _positive(size=min(a, b))
    return _made(float(mass), (b * b / 12, a * a / 12, (a * a + b * b) / 12), at, axes)


@own_arguments
def rod_properties(start: ArrayLike, end: ArrayLike, *, mass: float) -> MassProperties:
    """Thin uniform rod between two points (3,) m.

    >>> from kinetruss.library import bodies
    >>> rod = bodies.rod_properties((0, 0, 0), (2, 0, 0), mass=3.0)
    >>> rod.center.tolist(), rod.inertia.diagonal().round(6).tolist()  # m; kg m^2: m l^2/12 across it
    ([1.0, 0.0, 0.0], [0.0, 1.0, 1.0])
    """
    p, q = np.array(start, float), np.array(end, float)
    d = q - p
    _positive(length=float(np.linalg.norm(d)))
    return MassProperties(mass=float(mass), center=(p + q) / 2, inertia=mass / 12 * (d @ d * np.eye(3) - np.outer(d, d)))


@own_arguments
def tetrahedron_properties(points: ArrayLike, *, mass: float | None = None, density: float | None = None) -> MassProperties:
    """Tetrahedron with corners (4, 3) m: second moments m/20 of the sum of r r^T about its middle.

    >>> from kinetruss.library import bodies
    >>> corner = bodies.tetrahedron_properties([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], density=6.0)
    >>> round(corner.mass, 9), corner.center.round(9).tolist()  # kg: volume 1/6 m^3; m
    (1.0, [0.25, 0.25, 0.25])
    """
    r = np.array(points, float)
    center = r.mean(axis=0)
    span_points("points", [f"point {k}" for k in range(len(r))], r)
    volume = abs(float(np.linalg.det(np.array([b - a for a, b in pairwise(r)])))) / 6
    m = _mass(volume, mass, density)
    S = m / 20 * (r - center).T @ (r - center)
    return MassProperties(mass=m, center=center, inertia=np.trace(S) * np.eye(3) - S)


# Mass, centre and inertia of a closed surface of triangles, from an STL file (text or binary).
#
# Every triangle spans a tetrahedron with the origin, of signed volume det(a, b, c)/6, centre (a + b + c)/4 and second moments
# V/20 (sum of r r^T over the corners and of s s^T with s = a + b + c); the sum is exact for the polyhedron (divergence
# theorem).

_BINARY = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


@own_arguments
def read_stl(path: str | Path, scale: float = 1.0) -> NDArray[np.float64]:
    """Corners (triangles, 3, 3) of an STL file, times `scale` (0.001 for a file in millimetres).

    Raises
    ------
    InputError : no such file, or not an STL file.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> from kinetruss.library import bodies
    >>> o, x, y, z = "0 0 0", "1 0 0", "0 1 0", "0 0 1"
    >>> faces = ["facet outer vertex " + " vertex ".join(one) for one in ((o, y, x), (o, x, z), (o, z, y), (x, y, z))]
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "corner.stl")
    ...     _ = file.write_text("solid corner " + " ".join(faces))
    ...     bodies.read_stl(file, scale=0.001).shape  # triangles, corners, axes
    (4, 3, 3)
    """
    path = Path(path)
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}. Name an STL file.") from None
    count = int.from_bytes(data[80:84], "little") if len(data) >= 84 else -1
    if count > 0 and len(data) == 84 + count * _BINARY.itemsize:
        return np.frombuffer(data, _BINARY, count, 84)["corners"].astype(float) * scale
    words = data.decode("ascii", "replace").split()
    try:
        at = [k for k, word in enumerate(words) if word.lower() == "vertex"]
        corners = np.array([[float(words[k + c]) for c in (1, 2, 3)] for k in at])
    except (ValueError, IndexError):
        corners = np.zeros((0, 3))
    if not words or words[0].lower() != "solid" or not len(corners) or len(corners) % 3:
        raise InputError(f"{path} is no STL file: neither text with three vertices a facet, nor binary of the length it tells.")
    return np.asarray(corners.reshape(-1, 3, 3) * scale)


@own_arguments
def from_stl(
    path: str | Path, *, mass: float | None = None, density: float | None = None, scale: float = 1.0
) -> MassProperties:
    """Mass, centre and inertia of the body inside the surface in an STL file.

    Parameters
    ----------
    mass, density : one of them, kg or kg/m^3. scale : of the file's lengths; 0.001 for millimetres.

    Raises
    ------
    InputError : a file that cannot be read, a surface that is not closed or has no volume.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> from kinetruss.library import bodies
    >>> o, x, y, z = "0 0 0", "1 0 0", "0 1 0", "0 0 1"
    >>> faces = ["facet outer vertex " + " vertex ".join(one) for one in ((o, y, x), (o, x, z), (o, z, y), (x, y, z))]
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "corner.stl")
    ...     _ = file.write_text("solid corner " + " ".join(faces))
    ...     found = bodies.from_stl(file, density=6.0)
    >>> round(found.mass, 9), found.center.round(9).tolist()  # kg: volume 1/6 m^3; m
    (1.0, [0.25, 0.25, 0.25])
    """
    return surface_properties(read_stl(path, scale), mass=mass, density=density, name=str(path))


@own_arguments
def surface_properties(
    triangles: ArrayLike, *, mass: float | None = None, density: float | None = None, name: str = "The surface"
) -> MassProperties:
    """The same for a surface of triangles (triangles, 3, 3) m, all oriented outwards or all inwards.

    >>> from kinetruss.library import bodies
    >>> o, x, y, z = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
    >>> found = bodies.surface_properties([(o, y, x), (o, x, z), (o, z, y), (x, y, z)], mass=2.0)
    >>> found.mass, found.center.round(9).tolist()  # of a tetrahedron
    (2.0, [0.25, 0.25, 0.25])
    """
    if (mass is None) == (density is None):
        raise InputError("Give either the mass (kg) or the density (kg/m^3).")
    r = np.array(triangles, float)
    size = _closed(r, name)
    middle = r.reshape(-1, 3).mean(axis=0)  # round-off is least near the origin
    r = r - middle
    volumes = np.linalg.det(r) / 6
    volume = float(volumes.sum())
    if abs(volume) <= 1e-9 * size**3:
        raise InputError(f"{name} encloses no volume. Its triangles must all be turned alike, outwards.")
    s = r.sum(axis=1)
    center = volumes @ s / 4 / volume
    second = (np.einsum("t,tki,tkj->ij", volumes, r, r) + np.einsum("t,ti,tj->ij", volumes, s, s)) / 20 / volume
    S = second - np.outer(center, center)
    m = float(mass) if mass is not None else float(density or 0.0) * abs(volume)
    return MassProperties(mass=m, center=center + middle, inertia=m * (np.trace(S) * np.eye(3) - S))


def _closed(r: NDArray[np.float64], name: str) -> float:
    """The size of a surface, m; every edge must occur once in each direction."""
    size = float(np.ptp(r.reshape(-1, 3), axis=0).max(initial=0.0))
    if not size > 0 or not np.isfinite(r).all():
        raise InputError(f"{name} has no size, or corners that are not finite.")
    _, corner = np.unique(np.round(r.reshape(-1, 3) / (1e-6 * size)).astype(np.int64), axis=0, return_inverse=True)
    corner = corner.reshape(-1, 3)
    count = corner.max() + 1
    a, b = corner[:, [0, 1, 2]].reshape(-1), corner[:, [1, 2, 0]].reshape(-1)
    real = a != b  # triangles may be degenerate
    there, back = np.sort(a[real] * count + b[real]), np.sort(b[real] * count + a[real])
    if not np.array_equal(there, back):
        open_edges = len(np.setxor1d(there, back)) // 2
        message = (
            f"{open_edges} edges are met from one side only" if open_edges else "some edges are met more often one way round"
        )
        raise InputError(
            f"{name} is not a closed surface, all turned alike: {message}. Mend the mesh, or give mass properties."
        )
    return size
