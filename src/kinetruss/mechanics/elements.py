"""Springs, membranes, solids and beams in the equations: forces, energies and tangent stiffness at given positions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array

from kinetruss.elements import beam_kernels, beam_matrices, continua, continua_matrices, scalars
from kinetruss.elements.beam_matrices import beam_stiffness
from kinetruss.elements.continua_matrices import continua_stiffness
from kinetruss.elements.element import Results
from kinetruss.elements.kinds import on_coordinates, present, spans_of
from kinetruss.errors import AnalysisError
from kinetruss.kernels.structure.element_table import ENERGY, FORCE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


class Histories(NamedTuple):
    """value and rate of the coordinate (m or rad, m/s or rad/s), force on it (N or N m), energy (J), all (times, elements).

    An angle is known within half a turn of the rest.
    """

    value: NDArray[np.float64]
    rate: NDArray[np.float64]
    force: NDArray[np.float64]
    energy: NDArray[np.float64]


def scalar_motions(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> Histories:
    """Elements on coordinates along x, v (times, n, 3) or flat; without v at rest. A positive force raises the coordinate."""
    place, rate = (
        np.ascontiguousarray(y, float).reshape(-1, system.x0.size) for y in (x, np.zeros(system.x0.size) if v is None else v)
    )
    if (every := on_coordinates(system)) is None:
        return Histories(*np.zeros((4, len(place), 0)))
    found = np.empty((4, len(place), len(every.law)))
    scalars.histories(every, place, rate, found)
    return Histories(found[0] + every.rest, *found[1:])


def named_motions(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> Histories:
    """`scalar_motions` of those with a name, (times, force_elements)."""
    found = scalar_motions(system, x, v)
    if on_coordinates(system) is None:
        return found
    first = spans_of(system)["friction"].stop
    return Histories(*(one[:, first:] for one in found))


EDGE = 0.02
"""Angle before half a turn, rad, at which an element has come to it."""


def turned_over(system: System, x: NDArray[np.float64], v: NDArray[np.float64], ahead: float) -> str:
    """The element on an angle that comes to half a turn from its rest within a time `ahead`, s, as ``Spring 's'``; or ''."""
    period, every = system.measure_period[system.force_element_measure], on_coordinates(system)
    if every is None or not np.any(period):
        return ""
    first = spans_of(system)["friction"].stop
    found = named_motions(system, x, v)
    left = 0.5 * period - np.abs(found.value[0] - every.rest[first:])
    near = np.flatnonzero((period > 0.0) & (left <= np.maximum(EDGE, np.abs(found.rate[0]) * ahead)))
    if not len(near):
        return ""
    name = system.force_elements[int(near[0])]
    return f"{system.model.force_elements[name][0].capitalize()} {name!r}"


def refuse_turns(system: System, t: NDArray[np.float64], x: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Refuse motions x, v (times, 3 n) of angles beyond half a turn from the rest of an element, where its law would jump.

    Of two samples on both sides of the jump, the rates distinguish the way over it from that through the rest.

    Raises
    ------
    AnalysisError : the spring and the time.
    """
    period = system.measure_period[system.force_element_measure]
    if not np.any(period):
        return
    found = named_motions(system, x, v)
    change, ahead = np.diff(found.value, axis=0), 0.5 * (found.rate[1:] + found.rate[:-1]) * np.diff(t)[:, None]
    over = (np.abs(change) > 0.5 * period) & (np.abs(change - np.sign(change) * period - ahead) < 0.25 * period)
    for i, k in np.argwhere(over & (period > 0.0))[:1]:
        name = system.force_elements[k]
        kind = system.model.force_elements[name][0]
        raise AnalysisError(
            f"{kind.capitalize()} {name!r} passes half a turn from its rest between t = {t[i]:.6g} and {t[i + 1]:.6g} s, where "
            "its law would jump. Give another rest, or the moment of a spring wound up by more as its preload."
        )


def has_elements(system: System) -> bool:
    """True if a system has elements besides bars and the friction of their pins: springs, stops, beams, membranes, ..."""
    return bool(system.force_elements) or any(not isinstance(record, scalars.Scalars) for _, record in present(system))


def element_forces(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None, t: float = 0.0, *, rows: bool = True
) -> NDArray[np.float64]:
    """Forces of the elements of all kinds on the nodes (3 n,), N, at x, v (n, 3) and t, s; without v at rest. rows : include
    those kinds whose deformations are rows of small displacements: all on coordinates, membranes, solids and beams.
    """
    found = np.zeros(system.x0.size)
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros_like(found) if v is None else v))
    for one, record in present(system):
        if rows or not one.rows:
            one.kernels[FORCE][1](record, t, place, rate, found)
    return found


def element_energy(system: System, x: NDArray[np.float64]) -> float:
    """Energy stored in the elements of all kinds, J, at x (n, 3)."""
    place = np.ascontiguousarray(x, float).reshape(-1)
    return float(sum(one.kernels[ENERGY][1](record, place) for one, record in present(system)))


def fed(system: System) -> bool:
    """True if some elements may give energy that they do not store."""
    return any(one.feeds(record) for one, record in present(system))


def element_change(system: System, x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
    """Work against the elements of all kinds from x to y, (n, 3), J: their energy, and of those that give some the work of
    their forces along the straight line, by the trapezoidal rule.
    """
    change = element_energy(system, y) - element_energy(system, x)
    for one, record in present(system):
        if one.feeds(record):
            places = [np.ascontiguousarray(z, float).reshape(-1) for z in (x, y)]
            force = np.zeros(x.size)
            for place in places:
                one.kernels[FORCE][1](record, 0.0, place, np.zeros(x.size), force)
            before, after = (one.kernels[ENERGY][1](record, place) for place in places)
            change -= 0.5 * float(force @ (places[1] - places[0])) + after - before
    return change


def element_tangents(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None, *, rows: bool = True
) -> tuple[Any, Any]:
    """K and C (3 n, 3 n), N/m and N s/m: minus the derivatives of `element_forces` by x and by v, both (n, 3)."""
    K = C = csr_array((x.size, x.size))
    for one, record in present(system):
        if rows or not one.rows:
            own = one.tangents(system, record, x, v)
            K, C = K + own[0], C + own[1]
    return K, C


def element_results(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None, t: NDArray[np.float64] | None = None
) -> list[Results]:
    """Results of the elements that are not on coordinates, along x, v (times, n, 3) or flat and t (times,), s; without v at
    rest, without t at 0.
    """
    place, rate = (
        np.ascontiguousarray(y, float).reshape(-1, system.x0.size) for y in (x, np.zeros_like(x) if v is None else v)
    )
    rate = np.broadcast_to(rate, place.shape)  # at rest one row stands for all
    times = np.broadcast_to(0.0 if t is None else t, len(place))
    return [one.results(system, record, times, place, rate) for one, record in present(system) if one.results is not None]


def displaced_results(system: System, x: NDArray[np.float64], u: NDArray[np.float64]) -> list[Results]:
    """The same at rest with small displacements u from x, both (n, 3), to first order: of those kinds that have such."""
    return [one.linear_results(system, record, x, u) for one, record in present(system) if one.linear_results is not None]


def scalar_laws(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """Resistance F, dF/dq and dF/dq' of each element on a coordinate (elements, 3) at x, v (n, 3)."""
    if (every := on_coordinates(system)) is None:
        return np.zeros((0, 3))
    found = np.zeros((len(every.law), 3))
    place, rate = (np.ascontiguousarray(y, float).reshape(-1) for y in (x, np.zeros(system.x0.size) if v is None else v))
    scalars.slopes(every, place, rate, found)
    return found


def named_laws(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """`scalar_laws` of those with a name."""
    return scalar_laws(system, x, v)[spans_of(system)["friction"].stop :]


def material_stiffness(system: System, x: NDArray[np.float64]) -> Any:
    """Stiffness (3 n, 3 n), N/m, of membranes, solids and beams at x (n, 3), without that of their stresses there."""
    K, found = continuum_stiffness(system, x), system.continua
    if found is not None and found.beams is not None:
        K = K + beam_stiffness(found.beams, x, np.zeros(found.beams.rigidity.shape), found.beams.rigidity)
    return K


def continuum_stiffness(system: System, x: NDArray[np.float64]) -> Any:
    """The same of membranes and solids."""
    found = system.continua
    if found is None or not found.patches:
        return csr_array((x.size, x.size))
    return continua_stiffness(found, x, np.zeros(found.edges))


def strained_forces(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces of membranes, solids and beams on the nodes (3 n,), N, at x (n, 3) or flat, at rest."""
    found = np.zeros(system.x0.size)
    place, rest = np.ascontiguousarray(x, float).reshape(-1), np.zeros_like(found)
    for own, kernels in ((continua_matrices, continua.KERNELS), (beam_matrices, beam_kernels.KERNELS)):
        if (record := own.table(system)) is not None:
            kernels[FORCE][1](record, 0.0, place, rest, found)
    return found
