"""Rods of Simo and Reissner as boundary value problems, by shooting: strains of any size, dead loads.

In the plane r' = R(theta) (1 + N/EA, V/GA), theta' = M/EI, M' = -r' x n; in space r' = R (e1 + N/(EA, GA, GA)), R' = R k,
k = m/K in the axes of the section, where m is the moment of the forces beyond it. J. C. Simo, Comput. Methods Appl. Mech. Eng.
49 (1985) 55-70; E. Reissner, J. Appl. Math. Phys. 23 (1972) 795-804.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize_scalar, root
from scipy.spatial.transform import Rotation

TIGHT: Any = {"rtol": 1e-12, "atol": 1e-12, "method": "DOP853"}


def along(state: Any, length: float, force: Callable[[float], Any], EA: float, EI: float, GA: float = math.inf) -> Any:
    """x, y, theta, M at the end of a straight piece of a plane rod, force(s) (2,) : of the part behind s on that before it."""

    def rates(s: float, y: Any) -> list[float]:
        c, d, n = math.cos(y[2]), math.sin(y[2]), force(s)
        one, two = 1 + (n[0] * c + n[1] * d) / EA, (n[1] * c - n[0] * d) / GA
        x, z = one * c - two * d, one * d + two * c
        return [x, z, y[3] / EI, z * n[0] - x * n[1]]

    return solve_ivp(rates, (0.0, length), state, **TIGHT).y[:, -1]


def cantilever(length: float, load: Callable[[float, float], Any], EA: float, EI: float, GA: float = math.inf) -> Any:
    """x, y, theta at the tip of a rod clamped along x; load(s, part) : force behind s under a part of the load."""
    moment, part = 0.0, 0.0
    for part in np.linspace(0.125, 1.0, 8):

        def left(y: Any, part: float = part) -> Any:
            return along([0.0, 0.0, 0.0, y[0]], length, lambda s: load(s, part), EA, EI, GA)[3:]

        moment = root(left, [moment], tol=1e-13).x[0]
    return along([0.0, 0.0, 0.0, moment], length, lambda s: load(s, 1.0), EA, EI, GA)[:3]


def heavy() -> Any:
    """Tip of a cantilever of 2 m under 78 x 9.81 N/m with EA = 1e6 N and slenderness 20: displacement, m."""
    x, y, _ = cantilever(2.0, lambda s, part: (0.0, -part * 78 * 9.81 * (2.0 - s)), 1e6, 1e6 / 1200)
    return x - 2.0, y


def sheared() -> Any:
    """Tip of a cantilever of 1 m under (-20, 60) N with EA = 1e4 N, EI = 25 N m^2, GA = 1e3 N."""
    return cantilever(1.0, lambda s, part: (-20.0 * part, 60.0 * part), 1e4, 25.0, 1e3)[:2]


def diamond(load: float) -> Any:
    """A square frame of sides 1 on its corner, with hinges at top and bottom, where P = load E I pulls: how far these move away
    from the middle, and the stiff corners at the sides towards it. EA = 4.8e7 E I.
    """
    # from a stiff corner, which does not turn, to the hinge at the top, with half of the load
    a = math.sqrt(0.5)
    turn = Rotation.from_rotvec([0, 0, math.pi / 4]).as_matrix()[:2, :2]
    x, y, _ = cantilever(1.0, lambda s, part: turn.T @ [0.0, 0.5 * part * load], 4.8e7, 1.0)
    end = turn @ [x, y]
    return end[1] - a, a - end[0]


def toggle(drop: float) -> float:
    """Force that holds the middle of a toggle of two clamped legs down by `drop`: 12.943 to each side and 0.386 high, with
    EA = 1.885e6, EI = 9.27e3 (F. W. Williams, Q. J. Mech. Appl. Math. 17 (1964) 451-469; inches and pounds).
    """
    span, rise = 12.943, 0.386
    slope, length, y = math.atan2(rise, span), math.hypot(span, rise), [-1.0, 0.0, 0.0]

    def left(y: Any, down: float) -> Any:
        end = along([0.0, 0.0, slope, y[2]], length, lambda s: (y[0], y[1]), 1.885e6, 9.27e3)
        return end[:3] - [span, rise - down, slope]

    for down in np.linspace(drop / 10, drop, 10):
        y = root(left, y, args=(down,), tol=1e-13).x
    return float(-2 * y[1])


def turning_points(force: Callable[[float], float], *spans: tuple[float, float]) -> list[float]:
    """Extreme forces: a maximum in the first span of displacements, a minimum in the second, ..."""
    found = []
    for k, span in enumerate(spans):
        sign = (-1.0) ** (k + 1)
        at = minimize_scalar(lambda w, sign=sign: sign * force(w), bounds=span, method="bounded", options={"xatol": 1e-6})
        found.append(float(sign * at.fun))
    return found


class Lee:
    """Lee's frame: a column and a beam of 120, on hinges at the far ends, loaded downwards on the beam at 24 from the corner,
    with E = 720, A = 6, I = 2 (S. L. Lee, F. S. Manuel, E. C. Rossow, J. Eng. Mech. Div. ASCE 94 (1968) 521-547).
    """

    EA, EI = 4320.0, 1440.0

    def __init__(self) -> None:
        # forces, turn at the first hinge, load; by how far the loaded point is down
        self._known = {0.0: np.zeros(4)}

    def _ends(self, y: Any) -> tuple[Any, Any]:
        turn, fx, fy, load = y
        state = along([0.0, 0.0, math.pi / 2 + turn, 0.0], 120.0, lambda s: (fx, fy), self.EA, self.EI)
        state[2] -= math.pi / 2
        middle = along(state, 24.0, lambda s: (fx, fy), self.EA, self.EI)
        return middle, along(middle, 96.0, lambda s: (fx, fy + load), self.EA, self.EI)

    def force(self, drop: float) -> float:
        """The load that holds its point down by `drop`."""
        at = max(one for one in self._known if one <= drop)
        y = self._known[at]
        for down in [*np.arange(at + 1.0, drop, 1.0), drop]:

            def left(y: Any, down: float = down) -> Any:
                middle, end = self._ends(y)
                return np.array([end[0] - 120.0, end[1] - 120.0, end[3] / 100, middle[1] - 120.0 + down])

            y = root(left, y, tol=1e-11).x
            self._known[float(down)] = y
        return float(y[3])


class Legs:
    """A rod of straight pieces in space, clamped at its start; turns : of each piece against the one before it, matrices; K :
    G J, E I2, E I3.
    """

    def __init__(self, lengths: Sequence[float], turns: Sequence[Any], K: Any, EA: float) -> None:
        self.lengths, self.turns, self.K, self.EA = lengths, turns, K, EA

    def gap(self, tip: Any, push: Any) -> Any:
        """Where the rod ends under a force that acts at `tip`, from there (3,)."""

        def rates(_: float, y: Any) -> Any:
            Q = y[3:].reshape(3, 3)
            k = Q.T @ np.cross(tip - y[:3], push) / self.K
            W = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
            return np.concatenate([(1 + (Q.T @ push)[0] / self.EA) * Q[:, 0], (Q @ W).ravel()])

        at, Q = np.zeros(3), np.eye(3)
        for length, turn in zip(self.lengths, self.turns, strict=True):
            end = solve_ivp(rates, (0.0, length), np.concatenate([at, (Q @ turn).ravel()]), **TIGHT).y[:, -1]
            at, Q = end[:3], end[3:].reshape(3, 3)
        return at - tip

    def tip(self, force: Any, start: Any, parts: int = 8) -> Any:
        """Where the tip is under a force, from where it is without one."""
        tip = np.array(start, float)
        for part in np.linspace(1 / parts, 1.0, parts):
            tip = root(self.gap, tip, args=(part * np.array(force, float),), tol=1e-12).x
        return tip


STRIP = {"length": 0.508, "width": 12.377e-3, "thickness": 3.2024e-3, "E": 71.7e9, "poisson": 0.31}
"""The strip of the Princeton beam experiment (E. H. Dowell & J. J. Traybar, 1975), m and Pa."""


def princeton(torsion: float, load: float, degrees: float) -> Any:
    """Displacement across the wide and the narrow side, m, of its tip under a load at an angle from the wide side."""
    b, h, E = STRIP["width"], STRIP["thickness"], STRIP["E"]
    K = np.array([E / 2.62 * torsion, E * b * h**3 / 12, E * h * b**3 / 12])
    angle, L = math.radians(degrees), STRIP["length"]
    push = [0.0, load * math.cos(angle), load * math.sin(angle)]
    return Legs([L], [np.eye(3)], K, E * b * h).tip(push, [L, 0.0, 0.0])[1:]


def right_angle(torsion: float) -> float:
    """Load at the tip, in the plane, at which a frame of two legs of 240 at a right angle, a strip 30 x 0.6 with E = 71240 and
    poisson 0.31, buckles sideways (J. H. Argyris et al., Comput. Methods Appl. Mech. Eng. 20 (1979) 105-131).
    """
    E, G, L = 71240.0, 71240.0 / 2.62, 240.0
    K = np.array([G * torsion, E * 30 * 0.6**3 / 12, E * 0.6 * 30**3 / 12])
    corner = Rotation.from_rotvec([0, 0, -math.pi / 2]).as_matrix()

    legs = Legs([L, L], [np.eye(3), corner], K, E * 18.0)

    def back(load: float) -> float:
        # moved aside, the tip is left there by its load where this is 0
        push = np.array([load, 0.0, 0.0])
        return float(legs.gap(legs.tip(push, [L, -L, 0.0], 1) + np.array([0.0, 0.0, 1e-3]), push)[2])

    return float(brentq(back, 0.9, 1.2, xtol=1e-9))
