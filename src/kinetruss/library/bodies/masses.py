"""Mass, centre and inertia of bodies, equivalent bars and lumped masses; checks of what was given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.library.building import own_arguments
from kinetruss.model import Body, Model, body_mass, nearest
from kinetruss.model.bodies import carried, inertia_of, on_carriers, placed, quality, second_moments
from kinetruss.model.body_checks import impossible
from kinetruss.model.bracing import FLAT, beside, lying

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


ROUND = 1e-9
"""Tolerance of unit vectors of a frame and of an inertia, as a fraction of the largest."""


def numbers(what: str, value: Any) -> NDArray[np.float64]:
    """The value as an array of finite numbers; InputError otherwise."""
    try:
        found = np.array(value, float)
    except (TypeError, ValueError):
        raise InputError(f"{what} is {value!r}, which is no number. Give bare numbers in SI.") from None
    if not np.isfinite(found).all():
        raise InputError(f"{what} is {value!r}, which is not finite. Give finite numbers in SI.")
    return found


def refuse_impossible(what: str, mass: float, inertia: NDArray[np.float64]) -> None:
    """Raise an InputError for a negative mass, or moments of inertia that are impossible.

    mass kg, inertia (3, 3) kg m^2 about the centre, or one number of the plane.
    """
    if not mass >= 0:
        mend = "Give 0 or more; a hole is a part of negative mass beside the whole: bodies.combined(whole, hole)."
        raise InputError(f"{what} has the mass {mass:g} kg. {mend}")
    tensor = np.asarray(inertia, float)
    if tensor.ndim == 2 and np.abs(tensor - tensor.T).max() > ROUND * np.abs(tensor).max():
        i, j = np.unravel_index(int(np.abs(tensor - tensor.T).argmax()), tensor.shape)
        raise InputError(
            f"The inertia of {_small(what)} is not symmetric: entries {i + 1},{j + 1} and "
            f"{j + 1},{i + 1} are {tensor[i, j]:g} and {tensor[j, i]:g}. Give both the same value, minus "
            "the integral of the product of the coordinates."
        )
    if found := impossible(np.linalg.eigvalsh(tensor) if tensor.ndim == 2 else tensor.reshape(1)):
        mend = "Give moments about the centre of mass, kg m^2; about a point at a distance d they are larger by m d^2."
        raise InputError(f"The inertia of {_small(what)} {found} {mend}")


def _small(what: str) -> str:
    return what[0].lower() + what[1:]


def span_points(what: str, names: Sequence[str], points: NDArray[np.float64]) -> None:
    """Raise an InputError if points (k, dim), m, span no tetrahedron, triangle or line; it names them, and a suitable place."""
    if quality(points) > FLAT:
        return
    for i, one in enumerate(points):
        for j in range(i):
            if np.array_equal(one, points[j]):
                raise InputError(f"{what}: {names[j]} and {names[i]} stand at one place. Move one of them, or leave it out.")
    more = beside(points, min(len(points) - 1, points.shape[1]))
    places = " and ".join(f"({', '.join(f'{float(v):.4g}' for v in place)})" for place in more)
    moved = f"Move {'one of them, e.g.' if len(more) == 1 else 'two of them, e.g.' if len(more) == 2 else 'them'} to {places}"
    fewer = ", or give fewer points: three of a flat body, two of a rod" if points.shape[1] == 3 else ", or give two points"
    raise InputError(f"{what}: {', '.join(names)} lie {lying(points)}. {moved}{fewer}.")


def frame_axes(what: str, axes: Any, dim: int) -> NDArray[np.float64]:
    """Axes (dim, dim) of a frame, rows; InputError unless they are a right-handed orthonormal set."""
    found = numbers(f"axes of {what}", axes)
    if found.shape != (dim, dim):
        raise InputError(
            f"axes of {what} has the shape {found.shape}. Give {dim} rows of {dim}: the unit vectors of the frame."
        )
    if (off := float(np.abs(found @ found.T - np.eye(dim)).max())) > 1e3 * ROUND:
        raise InputError(
            f"axes of {what} miss unit vectors at right angles by {off:.3g}. Give unit vectors, each normal to the others."
        )
    if np.linalg.det(found) < 0:
        last = [float(-v) + 0.0 for v in found[-1]]
        raise InputError(
            f"axes of {what} are a left-handed frame. Turn the last axis round ({'xyz'[dim - 1]}: {last}), or swap two."
        )
    return found


# Mass, centre and inertia of bodies, and equivalent bars and lumped masses.


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
        if body not in model.whole.bodies:
            raise InputError(f"No body called {body!r}. {nearest(body, model.bodies)}")
        body = model.whole.bodies[body]
    points = np.array([model.whole.nodes[name].at for name in body.carried_by(model.dim)], float)
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
