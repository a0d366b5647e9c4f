"""Andrews' squeezing mechanism in its seven angles, reduced to the crank: no node coordinates, no multipliers.

Every point is a sum of turning links, z = z0 + sum r exp(i n.q), so that Jacobians and velocity terms are exact:
dz/dq = sum i n r exp(i n.q), bias = -sum (n.v)^2 r exp(i n.q). The state is (beta, beta'); the six other angles close the
three loops at E by Newton's method at every evaluation. Data of Hairer & Wanner, Solving ODEs II, section VII.7.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp

__all__ = ["END", "START", "TORQUE", "acceleration", "closed", "energy", "nodes", "points", "rates", "run"]

TORQUE = 0.033
START = np.array([-0.0617138900142764496, 0.0, 0.455279819163070380, 0.222668390165885885, 0.487364979543842550,
                  -0.222668390165885885, 1.23054744454982119])  # fmt: skip
END = 0.03
A, B, C = -0.06934 - 0.00227j, -0.03635 + 0.03273j, 0.014 + 0.072j
SPRING, REST = 4530.0, 0.07785
# angles: 0 beta, 1 Theta, 2 gamma, 3 Phi, 4 delta, 5 Omega, 6 epsilon; (sin a, -cos a) = -i exp(i a)
BETA, COUPLER, GAMMA, PHI, DELTA, OMEGA, EPSILON = (np.array(n, float) for n in (
    (1, 0, 0, 0, 0, 0, 0), (1, 1, 0, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0, 0), (0, 0, 0, 1, 1, 0, 0), (0, 0, 0, 0, 1, 0, 0),
    (0, 0, 0, 0, 0, 1, 1), (0, 0, 0, 0, 0, 0, 1)))  # fmt: skip
F = (0j, [(0.007, BETA)])
G = (A, [(0.04, DELTA)])
H = (A, [(-0.04j, EPSILON)])
E = (0j, [(0.007, BETA), (-0.028, COUPLER)])
E_BY_B = (B, [(-0.035j, GAMMA)])
E_BY_G = (A, [(0.04, DELTA), (-0.020j, PHI)])
E_BY_H = (A, [(-0.04j, EPSILON), (0.020, OMEGA)])
D = (B, [(0.020 - 0.018j, GAMMA)])
BODIES = (  # mass, central inertia, direction, centre
    (0.04325, 2.194e-6, BETA, (0j, [(0.00092, BETA)])),
    (0.00365, 4.410e-7, COUPLER, (0j, [(0.007, BETA), (-0.0115, COUPLER)])),
    (0.02373, 5.255e-6, GAMMA, (B, [(0.01043 - 0.01874j, GAMMA)])),
    (0.00706, 5.667e-7, PHI, (A, [(0.04, DELTA), (-(0.020 - 0.01421) * 1j, PHI)])),
    (0.07050, 1.169e-5, DELTA, (A, [(0.02308 + 0.00916j, DELTA)])),
    (0.00706, 5.667e-7, OMEGA, (A, [(-0.04j, EPSILON), (0.020 - 0.01421, OMEGA)])),
    (0.05498, 1.912e-5, EPSILON, (A, [(-0.00449 - 0.01228j, EPSILON)])),
)

Point = tuple[complex, list[tuple[complex, np.ndarray]]]


def _turned(point: Point, q: np.ndarray, v: np.ndarray) -> tuple[complex, np.ndarray, complex]:
    """Position, gradient (7,), velocity term of a point."""
    z, gradient, bias = point[0], np.zeros(7, complex), 0j
    for r, n in point[1]:
        arm = r * np.exp(1j * (n @ q))
        z, gradient, bias = z + arm, gradient + 1j * n * arm, bias - (n @ v) ** 2 * arm
    return z, gradient, bias


def _loops(q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Gaps (6,) of the loops, Jacobian (6, 7), velocity terms (6,)."""
    z, gradient, bias = _turned(E, q, v)
    gaps, rows, terms = [], [], []
    for other in (E_BY_B, E_BY_G, E_BY_H):
        w, slope, term = _turned(other, q, v)
        gaps += [(z - w).real, (z - w).imag]
        rows += [(gradient - slope).real, (gradient - slope).imag]
        terms += [(bias - term).real, (bias - term).imag]
    return np.array(gaps), np.array(rows), np.array(terms)


def closed(beta: float, guess: np.ndarray) -> np.ndarray:
    """All seven angles at a crank angle, near a guess."""
    q = np.concatenate([[beta], guess[1:]])
    for _ in range(20):
        gaps, rows, _ = _loops(q, np.zeros(7))
        step = np.linalg.solve(rows[:, 1:], gaps)
        q[1:] -= step
        if np.abs(step).max() < 1e-14:
            break
    return q


def rates(q: np.ndarray, crank: float) -> np.ndarray:
    """All seven rates where the crank turns at this rate, rad/s."""
    rows = _loops(q, np.zeros(7))[1]
    return crank * np.concatenate([[1.0], -np.linalg.solve(rows[:, 1:], rows[:, 0])])


def _sums(q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mass matrix (7, 7) in the angles; generalised forces (7,) less velocity terms."""
    M, right = np.zeros((7, 7)), TORQUE * BETA
    for mass, inertia, turn, centre in BODIES:
        _, gradient, bias = _turned(centre, q, v)
        J = np.stack([gradient.real, gradient.imag])
        M += mass * J.T @ J + inertia * np.outer(turn, turn)
        right = right - mass * (J.T @ np.array([bias.real, bias.imag]))
    z, gradient, _ = _turned(D, q, v)
    pull = SPRING * (abs(z - C) - REST) * (C - z) / abs(z - C)
    return M, right + gradient.real * pull.real + gradient.imag * pull.imag


def acceleration(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Second derivatives (7,) of the angles."""
    _, rows, terms = _loops(q, v)
    M, right = _sums(q, v)
    slope = np.concatenate([[1.0], -np.linalg.solve(rows[:, 1:], rows[:, 0])])
    bend = np.concatenate([[0.0], -np.linalg.solve(rows[:, 1:], terms)])
    return slope * (slope @ (right - M @ bend)) / (slope @ M @ slope) + bend


def energy(q: np.ndarray, v: np.ndarray) -> float:
    """Kinetic, spring and (less) the work of the motor since beta = 0, J."""
    M, _ = _sums(q, v)
    z, _, _ = _turned(D, q, v)
    return 0.5 * float(v @ M @ v) + SPRING / 2 * (abs(z - C) - REST) ** 2 - TORQUE * q[0]


def points(q: np.ndarray) -> dict[str, np.ndarray]:
    """Places of the five free nodes, m."""
    named = {"F": F, "E": E, "D": D, "G": G, "H": H}
    return {name: np.array([z.real, z.imag]) for name, z in ((n, _turned(p, q, q)[0]) for n, p in named.items())}


def nodes(q: np.ndarray, v: np.ndarray) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Places, velocities and accelerations of all nine nodes."""
    w = acceleration(q, v)
    found: tuple[dict[str, np.ndarray], ...] = ({}, {}, {})
    for name, point in {
        "O": (0j, []),
        "A": (A, []),
        "B": (B, []),
        "C": (C, []),
        "F": F,
        "E": E,
        "D": D,
        "G": G,
        "H": H,
    }.items():
        z, gradient, bias = _turned(point, q, v)
        for values, number in zip(found, (z, gradient @ v, gradient @ w + bias), strict=True):
            values[name] = np.array([number.real, number.imag])
    return found


def run(times: np.ndarray, start: np.ndarray = START) -> tuple[np.ndarray, np.ndarray]:
    """Angles and rates (times, 7) from rest at times[0]."""
    last = [start]

    def slope(_: float, state: np.ndarray) -> np.ndarray:
        last[0] = q = closed(state[0], last[0])
        return np.array([state[1], acceleration(q, rates(q, state[1]))[0]])

    found = solve_ivp(slope, (times[0], times[-1]), [start[0], 0.0], "DOP853", times, rtol=1e-13, atol=1e-13)
    angles, turning, q = [], [], start
    for beta, rate in found.y.T:
        # small turns between one sample and the next, so that the branch stays the same
        for part in np.linspace(q[0], beta, 1 + int(abs(beta - q[0]) / 0.2) + 1)[1:]:
            q = closed(part, q)
        angles.append(q)
        turning.append(rates(q, rate))
    return np.array(angles), np.array(turning)
