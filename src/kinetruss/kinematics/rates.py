"""Rates along a motion: angular velocity of every member, centres of mass, and the first-order prediction."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.elements.local_axes import local_axes
from kinetruss.kinematics.jacobians import sensitivities, state_of
from kinetruss.mechanics import System, compile, direction_rates, turned
from kinetruss.mechanics.coordinates import coordinate_values, coordinates
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Model
from kinetruss.results import Motion, variable
from kinetruss.results.user_parts import users

if TYPE_CHECKING:
    from numpy.typing import NDArray


Rates = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]
Ends = list[tuple["NDArray[np.float64]", "NDArray[np.float64]"]]


def member_rates(model: Model, motion: Motion) -> xr.Dataset:
    """Angular velocity and acceleration of every member, position, velocity and acceleration of every centre of mass.

    Returns
    -------
    Dataset. ``direction`` (time, member, axis): u, from end A to B. ``member_axes`` (time, member, local, axis): axes 1, 2, 3
    of `strength.sections` as rows, the cosine matrix from global to member axes (in the plane 1 and 2). ``moment_of_inertia``
    (time, member): of the member about an axis across it through its centre of mass, kg m^2; it changes with the length of an
    active member. ``angular_velocity`` rad/s, ``angular_acceleration``
    rad/s^2 (time, member, rotation): normal to the member (the spin of a bar about its own axis is not part of the model),
    global axes; in the plane about z. ``centre``, ``centre_velocity``, ``centre_acceleration`` (time, member, axis): of the
    member's mass, m, m/s, m/s^2; the middle of a massless member. ``part_centre`` and its rates (time, part, axis): the same
    for bars, and for ``NAME.base`` and ``NAME.tube`` of an active member apart.

    Raises
    ------
    InputError : a motion of another model.

    Notes
    -----
    w = u x (v_B - v_A)/L and alpha = u x (a_B - a_A)/L - 2 L' w/L (Lacy, 1991, eq. 4.31 with its errata: no plane is needed,
    and none can be degenerate). The base is clamped at A, the tube at B: c_base = x_A + l_b/2 u, c_tube = x_B - l_t/2 u, with
    u' and u'' exact. The centre of an active member is no fixed fraction of its length.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")}
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"turn": 3.0}, duration=1.0), samples=2)
    >>> rates = kt.kinematics.member_rates(crank, motion).sel(member="b")
    >>> rates.angular_velocity.values[0].round(9).tolist(), rates.centre_velocity.values[0].round(9).tolist()  # rad/s, m/s
    ([3.0], [0.0, 3.0])
    """
    system = compile(model)
    x, time = state_of(system, motion)
    v, a = (flat_positions(system, motion.whole[name].values) for name in ("velocity", "acceleration"))
    ends = [(y.reshape(len(x), -1, 3)[:, system.p], y.reshape(len(x), -1, 3)[:, system.q]) for y in (x, v, a)]
    (L, Ld, _), u = direction_rates(*(B - A for A, B in ends))
    turn = 1.0 / L
    w = np.cross(u[0], ends[1][1] - ends[1][0]) * turn
    alpha = np.cross(u[0], ends[2][1] - ends[2][0]) * turn - 2 * Ld * turn * w
    names, parts = _parts(system, ends, u)
    centre = _centres(system, names, parts, ends)
    dim, turns = system.dim, slice(2, 3) if system.dim == 2 else slice(0, 3)
    member, rotation = ("time", "member", "axis"), ("time", "member", "rotation")
    data = {
        "member_axes": variable(
            ("time", "member", "local", "axis"),
            local_axes(system, motion.whole["position"].values)[:, :, :dim, :dim],
            "",
            "axes",
        ),
        "moment_of_inertia": variable(("time", "member"), _inertia(system, L[..., 0]), "kg m^2", "about the centre"),
        "direction": variable(member, u[0][..., :dim], "", "direction from end A to B"),
        "angular_velocity": variable(rotation, w[..., turns], "rad/s", "angular velocity"),
        "angular_acceleration": variable(rotation, alpha[..., turns], "rad/s^2", "angular acceleration"),
    }
    rates = (("", "m", ""), ("_velocity", "m/s", "velocity of the "), ("_acceleration", "m/s^2", "acceleration of the "))
    for order, (suffix, unit, words) in enumerate(rates):
        data[f"centre{suffix}"] = variable(member, centre[order][..., :dim], unit, f"{words}centre of mass")
        data[f"part_centre{suffix}"] = variable(
            ("time", "part", "axis"), parts[order][..., :dim], unit, f"{words}centre of mass of the part"
        )
    coords = {
        "time": time,
        "member": motion.whole["member"],
        "axis": motion.whole["axis"],
        "local": ["1", "2", "3"][:dim],
        "rotation": ["x", "y", "z"][turns],
        "part": [name for name, _, _ in names],
    }
    return users(xr.Dataset(data, coords=coords, attrs={"kind": "member_rates"}))


def _inertia(system: System, L: NDArray[np.float64]) -> NDArray[np.float64]:
    """Moment of inertia of every member across it about its centre of mass (times, members), kg m^2, at lengths L."""
    m, _, i, m_t, l_t, i_t = system.rods.T
    two = system.two_rods
    l_b = np.where(two, system.rods[:, 1], L)
    whole = np.where(two, m + m_t, 1.0)
    # each rod about its own centre, and both about the common one
    apart = L - 0.5 * (l_b + l_t)
    reduced = np.divide(m * m_t, whole, out=np.zeros_like(m), where=two & (whole > 0))
    found = m * l_b**2 / 12 + i + np.where(two, m_t * l_t**2 / 12 + i_t, 0.0) + reduced * apart**2
    return np.asarray(np.where(system.is_body, system.body[:, 3], found))


def _parts(system: System, ends: Ends, u: Rates) -> tuple[list[tuple[str, int, float]], Rates]:
    """Name, member and mass of every part; its centre with two rates, (times, parts, 3) each."""
    names: list[tuple[str, int, float]] = []
    columns: list[list[NDArray[np.float64]]] = [[], [], []]
    for i, name in enumerate(system.members):
        rod = system.rods[i]
        if not system.two_rods[i]:
            names.append((name, i, system.body[i, 0] if system.is_body[i] else rod[0]))
            for order, (A, B) in enumerate(ends):
                columns[order].append(_body(system, i, A, B) if system.is_body[i] else 0.5 * (A[:, i] + B[:, i]))
            continue
        names += [(f"{name}.base", i, rod[0]), (f"{name}.tube", i, rod[3])]
        for order, (A, B) in enumerate(ends):
            columns[order] += [A[:, i] + 0.5 * rod[1] * u[order][:, i], B[:, i] - 0.5 * rod[4] * u[order][:, i]]
    position, velocity, acceleration = (np.stack(column, axis=1) for column in columns)
    return names, (position, velocity, acceleration)


def _body(system: System, i: int, A: NDArray[np.float64], B: NDArray[np.float64]) -> NDArray[np.float64]:
    """Centre of a planar body, or its rate: (e, f) along and to the left of the bar, which keeps its length."""
    _, e, f, _ = system.body[i] / system.length0[i]
    d = B[:, i] - A[:, i]
    found: NDArray[np.float64] = A[:, i] + e * d + f * turned(d)
    return found


def _centres(system: System, names: list[tuple[str, int, float]], parts: Rates, ends: Ends) -> Rates:
    """Centres of mass of whole members, from their parts."""
    mass = np.zeros(len(system.members))
    for _, i, m in names:
        mass[i] += m
    share = np.array([m / mass[i] if mass[i] > 0 else 0.0 for _, i, m in names])
    found = []
    for order, (A, B) in enumerate(ends):
        centre = np.where(mass[:, None] > 0, 0.0, 0.5 * (A + B))
        for k, (_, i, _) in enumerate(names):
            centre[:, i] += share[k] * parts[order][:, k]
        found.append(centre)
    return found[0], found[1], found[2]


# The first-order prediction of a motion from its start, and its error.


def first_order(model: Model, motion: Motion, wrt: str | Iterable[str] | None = None) -> xr.Dataset:
    """Node positions predicted from the first sample by the Jacobian there, the exact ones, and the error.

    Parameters
    ----------
    wrt : the coordinates whose finite changes are used, as in `jacobian`; by default all drives. Another choice gives another
        prediction (linear in the pose instead of in the lengths, for instance).

    Returns
    -------
    Dataset over (time, node, axis), m: ``predicted`` = x(0) + J(0) (q(t) - q(0)), ``exact``, ``error`` = predicted - exact;
    ``error_size`` (time, node) and ``largest_error`` (time): distances, m.

    Raises
    ------
    InputError : as in `jacobian`; a motion without samples.

    Notes
    -----
    The error is proportional to the square of the step. Moving supports are included.

    Examples
    --------
    >>> import kinetruss as kt
    >>> crank = kt.Model(
    ...     nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")}, drives={"turn": kt.AngleDrive("b")}
    ... )
    >>> motion = kt.kinematics.follow(crank, kt.ConstantRate(rates={"turn": 1.0}, duration=0.1), samples=2)
    >>> kt.kinematics.first_order(crank, motion).largest_error.values.round(4).tolist()  # m: about 2 (0.1 rad)^2/2
    [0.0, 0.01]
    """
    system = compile(model)
    x, time = state_of(system, motion)
    names = list(system.drives) if wrt is None else [wrt] if isinstance(wrt, str) else list(wrt)
    moved = coordinates(system, [*names, *_supports(system, names)])
    q = coordinate_values(system, moved, x)
    S = sensitivities(system, x[:1], moved)[0]
    predicted = (x[0] + (q - q[0]) @ S.T).reshape(len(x), -1, 3)[:, :, : system.dim]
    exact = motion.arrays["position"].values
    nodal = ("time", "node", "axis")
    size = np.linalg.norm(predicted - exact, axis=2)
    data = {
        "predicted": variable(nodal, predicted, "m", "position, first order from the first sample"),
        "exact": variable(nodal, exact, "m", "position"),
        "error": variable(nodal, predicted - exact, "m", "predicted minus exact position"),
        "error_size": variable(("time", "node"), size, "m", "distance of predicted and exact position"),
        "largest_error": variable(("time",), size.max(axis=1), "m", "largest distance of any node"),
    }
    coords = {"time": time, "node": motion.whole["node"], "axis": motion.whole["axis"]}
    return users(xr.Dataset(data, coords=coords, attrs={"kind": "first_order", "wrt": [one.name for one in moved]}))


def _supports(system: System, names: list[str]) -> list[str]:
    """Coordinates of moving supports that are not named already."""
    moving = (f"{node}.{axis}" for node in system.model.support_motion for axis in system.model.fixed[node])
    return [name for name in moving if name not in names]
