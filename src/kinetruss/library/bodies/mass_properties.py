"""Mass, centre and inertia of bodies, and equivalent bars and lumped masses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.library._arguments import own_arguments
from kinetruss.library.bodies.mass_checks import frame_axes, numbers, refuse_impossible, span_points
from kinetruss.model import Body, Model, body_mass, nearest
from kinetruss.model.parts import carried, inertia_of, on_carriers, placed, second_moments

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["BarMasses", "MassProperties", "bar_masses", "combined", "mass_properties", "properties_of"]


@dataclass(frozen=True, kw_only=True, eq=False)
class MassProperties:
    """mass, kg; center (dim,) m; inertia about it in global axes, kg m^2: (3, 3) or three moments, in the plane one number."""

    mass: float
    center: NDArray[np.float64]
    inertia: NDArray[np.float64]

    def __post_init__(self) -> None:
        tensor = np.array(self.inertia, float)
        object.__setattr__(self, "center", np.array(self.center, float))
        object.__setattr__(self, "inertia", np.diag(tensor) if tensor.ndim == 1 else tensor)

    def moved(self, by: ArrayLike = 0.0, axes: ArrayLike | None = None) -> MassProperties:
        """The properties of the body rotated about the origin, then moved by `by` (dim,) m. `axes` (dim, dim): new directions
        of the axes, rows.

        Raises
        ------
        InputError : axes that are not a right-handed orthonormal set.
        """
        turn = np.eye(len(self.center)) if axes is None else frame_axes("the body", axes, len(self.center))
        inertia = self.inertia if self.inertia.ndim == 0 else turn.T @ self.inertia @ turn
        return MassProperties(mass=self.mass, center=turn.T @ self.center + np.asarray(by, float), inertia=inertia)


@dataclass(frozen=True, kw_only=True, eq=False)
class BarMasses:
    """Uniform bars and lumped masses with the inertia of a body.

    bars : mass, kg, of the uniform bar between points i and j, by (i, j); some may be negative. lumped (k,) kg at the points.
    """

    bars: dict[tuple[int, int], float]
    lumped: NDArray[np.float64]


@own_arguments
def bar_masses(points: ArrayLike, mass: float, center: ArrayLike, inertia: ArrayLike) -> BarMasses:
    """Masses of bars between points, 6 m_ij, and lumped at them, m_ii - 2 sum of m_ij, that are equivalent to a body.

    Parameters
    ----------
    points : (k, dim) m: four in space (three of a flat body, two of a rod), three in the plane. center (dim,) m.
    inertia : about the centre, kg m^2, (3, 3) or three moments; in the plane (2, 2), or one number.

    Raises
    ------
    InputError : points in one plane or on one line, mass off a flat body's plane, a mass below 0, impossible moments of
        inertia.

    >>> import numpy as np
    >>> corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / 2
    >>> found = bar_masses(corners, 12.0, (0, 0, 0), (2, 2, 2))  # a cube of edge 1 m: m/4 each, -m/8 at the corners
    >>> round(found.bars[0, 1], 12), round(float(found.lumped[0]), 12)
    (3.0, -1.5)
    """
    points = numbers("points", points)
    span_points("points", [f"point {k}" for k in range(len(points))], points)
    tensor = _tensor(numbers("inertia", inertia), points.shape[1])
    refuse_impossible("The body", mass, tensor if points.shape[1] == 3 else np.trace(tensor))
    m, off = on_carriers(points, mass, numbers("center", center), second_moments(tensor))
    if off > 1e-6:
        raise InputError(f"The body has mass off the plane or line of its points ({off:.1e} of its moments). Give four points.")
    lumped = np.diag(m) - 2 * (m.sum(axis=1) - np.diag(m))
    return BarMasses(bars={(i, j): 6 * float(m[i, j]) for i, j in combinations(range(len(m)), 2)}, lumped=lumped)


def _tensor(inertia: ArrayLike, dim: int) -> NDArray[np.float64]:
    given = np.array(inertia, float)
    if given.ndim == 0:
        given = 0.5 * given * np.eye(dim)
    return np.diag(given) if given.ndim == 1 else given


@own_arguments
def mass_properties(
    points: ArrayLike, bars: Mapping[tuple[int, int], float], lumped: Sequence[float] | ArrayLike = 0.0
) -> MassProperties:
    """Mass, centre and inertia of uniform bars, by (i, j) kg, and lumped masses (k,) kg at points (k, dim) m.

    >>> from kinetruss.library import bodies
    >>> found = bodies.mass_properties([(0, 0), (2, 0)], {(0, 1): 3.0}, lumped=[0.0, 1.0])
    >>> found.mass, found.center.round(6).tolist()  # kg; m: (3 * 1 + 1 * 2)/4
    (4.0, [1.25, 0.0])
    """
    points = np.array(points, float)
    m = np.diag(np.broadcast_to(np.asarray(lumped, float), len(points))).copy()
    for (i, j), mass in bars.items():
        if not (0 <= i < len(points) and 0 <= j < len(points) and i != j):
            raise InputError(
                f"Bar {i}-{j} is between no two of the {len(points)} points. Name two different of 0 to {len(points) - 1}."
            )
        m[[i, j], [i, j]] += mass / 3
        m[[i, j], [j, i]] += mass / 6
    return _of_pairs(points, m)


def _of_pairs(points: NDArray[np.float64], m: NDArray[np.float64]) -> MassProperties:
    mass, center, S = carried(points, m)
    trace = np.trace(S)
    return MassProperties(mass=mass, center=center, inertia=trace * np.eye(3) - S if len(center) == 3 else np.asarray(trace))


@own_arguments
def properties_of(model: Model, body: str | Body) -> MassProperties:
    """Mass, centre and inertia of a body of a model at its position there, global axes.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Body(nodes=tuple(corners), mass=2.0, center=(0.25, 0.25, 0.25), inertia=(0.1, 0.1, 0.1))
    >>> model = kt.Model(nodes=corners, bodies={"block": block})
    >>> found = kt.library.bodies.properties_of(model, "block")
    >>> found.mass, found.center.tolist()
    (2.0, [0.25, 0.25, 0.25])
    """
    if isinstance(body, str):
        if body not in model.bodies:
            raise InputError(f"No body called {body!r}. {nearest(body, model.bodies)}")
        body = model.bodies[body]
    points = np.array([model.nodes[name].at for name in body.carried_by(model.dim)], float)
    if body.center is None:
        return _of_pairs(points, body_mass(model, body)[0])
    origin, axes = placed(body.frame, model.dim)
    tensor = inertia_of(body, model.dim)
    inertia = tensor if model.dim == 3 else np.asarray(np.trace(tensor))
    return MassProperties(mass=body.mass, center=origin + axes.T @ np.array(body.center), inertia=inertia)


@own_arguments
def combined(*parts: MassProperties) -> MassProperties:
    """Several bodies as one; a part of negative mass is a hole.

    >>> import kinetruss as kt
    >>> made = kt.library.bodies.box_properties
    >>> kt.library.bodies.combined(made((2, 2, 2), density=1.0), made((1, 1, 1), density=-1.0)).mass
    7.0
    """
    mass = sum(part.mass for part in parts)
    if not mass > 0:
        shown = " + ".join(f"{part.mass:g}" for part in parts) or "nothing"
        raise InputError(f"The parts have together the mass {shown} = {mass:g} kg. Give parts whose sum is greater than 0.")
    center = np.asarray(sum(part.mass * part.center for part in parts)) / mass
    total: Any = 0.0
    for part in parts:
        r = part.center - center
        shift = r @ r * np.eye(3) - np.outer(r, r) if len(r) == 3 else r @ r
        total = total + part.inertia + part.mass * shift
    return MassProperties(mass=float(mass), center=center, inertia=np.asarray(total))
