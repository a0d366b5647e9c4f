"""Mass, centre and inertia of simple homogeneous shapes, about their centre, with their axis along z."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.library._arguments import own_arguments
from kinetruss.library.bodies.mass_checks import span_points
from kinetruss.library.bodies.mass_properties import MassProperties

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "box_properties",
    "cylinder_properties",
    "plate_properties",
    "rod_properties",
    "sphere_properties",
    "tetrahedron_properties",
    "tube_properties",
]


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
