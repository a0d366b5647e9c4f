"""Robots without bars: minimal coordinates of the five-freedom robot, closed forms of Delta and Stewart platform."""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

G = np.array([0.0, 0.0, -9.81])
EZ = np.array([0.0, 0.0, 1.0])

# The robot: lift z, swing g, shoulder b, reach y, wrist a; bodies as in `kinetruss.library.mechanisms.robot_of_bars`

MASS = np.array([200.0, 120.0, 40.0])
CENTRE = np.array([(0.10, 0.20, 0.15), (0.05, 0.30, -0.04), (0.02, 0.25, 0.10)])
INERTIA = np.array([(60.0, 20.0, 50.0), (12.0, 2.0, 11.0), (3.0, 1.2, 2.5)])
START, RATES, END = np.array([1.5, 0.4, -0.2, 0.9, 0.5]), np.array([-0.3, 0.8, 0.5, 0.2, -1.0]), 0.8


def robot_drives(t: float) -> np.ndarray:
    """Forces on lift and reach, N, torques on swing, shoulder and wrist, N m, in the order of the coordinates."""
    return np.array([
        3550 + 200 * math.sin(4 * t), 60 * math.cos(3 * t), -60 + 60 * math.sin(6 * t), -80 + 60 * t, 78 + 15 * math.cos(5 * t)
    ])  # fmt: skip


def robot_acceleration(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Second rates of the five: M(q) q'' = Q - h(q, q'), by the Jacobians of three bodies."""
    (cg, sg), (cb, sb), (ca, sa) = ((math.cos(x), math.sin(x)) for x in (q[1], q[2], q[4]))
    R1 = np.array([[cg, -sg, 0.0], [sg, cg, 0.0], [0.0, 0.0, 1.0]])
    R2 = R1 @ np.array([[cb, 0.0, sb], [0.0, 1.0, 0.0], [-sb, 0.0, cb]])
    R3 = R2 @ np.array([[1.0, 0.0, 0.0], [0.0, ca, -sa], [0.0, sa, ca]])
    ey, ex = R1[:, 1], R2[:, 0]
    w1 = EZ * v[1]
    w2 = w1 + ey * v[2]
    w3 = w2 + ex * v[4]
    turn2 = cross(w1, ey) * v[2]
    turn3 = turn2 + cross(w2, ex) * v[4]
    reach = ey * q[3]
    elbow = cross(turn2, reach) + cross(w2, cross(w2, reach) + 2 * v[3] * ey)
    none = np.zeros(3)
    bodies = ((R1, none, w1, none, none), (R2, reach, w2, turn2, elbow), (R3, reach, w3, turn3, elbow))
    M, Q = np.zeros((5, 5)), robot_drives(t)
    for k, (R, base, w, turn, moved) in enumerate(bodies):
        arm = R @ CENTRE[k]
        at = base + arm
        J, T = np.zeros((3, 5)), np.zeros((3, 5))
        J[:, 0], J[:, 1], T[:, 1] = EZ, cross(EZ, at), EZ
        if k > 0:
            J[:, 2], J[:, 3], T[:, 2] = cross(ey, at), ey, ey
        if k > 1:
            J[:, 4], T[:, 4] = cross(ex, arm), ex
        inertia = (R * INERTIA[k]) @ R.T
        M += MASS[k] * (J.T @ J) + T.T @ inertia @ T
        bias = moved + cross(turn, arm) + cross(w, cross(w, arm))
        Q -= MASS[k] * (J.T @ (bias - G)) + T.T @ (inertia @ turn + cross(w, inertia @ w))
    return np.linalg.solve(M, Q)


def robot_end(rtol: float, method: str = "DOP853") -> tuple[np.ndarray, int]:
    """The five coordinates at 0.8 s by SciPy, and how often the right-hand side was asked for."""
    found = solve_ivp(
        lambda t, y: np.concatenate([y[5:], robot_acceleration(t, y[:5], y[5:])]), (0.0, END), np.concatenate([START, RATES]),
        method=method, rtol=rtol, atol=rtol,
    )  # fmt: skip
    return found.y[:5, -1], found.nfev


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of two vectors; np.cross takes ten times as long."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


# The Delta robot of `kinetruss.library.mechanisms.platforms`

DELTA = {"base": 0.2, "arm": 0.35, "rod": 0.8, "side": 0.09 * math.sqrt(3) / 2, "arm_mass": 0.6, "rod_mass": 0.08, "mass": 0.5}


def delta_closed_form(P: np.ndarray, V: np.ndarray, A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angles (times, 3) of the arms, rad, and torques, N m, for place, velocity, acceleration (times, 3) of the platform.

    Angles positive below the horizontal. Torques by virtual work of arms, rods (m/6 (vE vE + vE vP + vP vP)) and platform.
    """
    d = DELTA
    J, load, angles = np.zeros((len(P), 3, 3)), d["mass"] * (A - G), np.zeros((len(P), 3))
    own = np.zeros((len(P), 3))
    m = 2 * d["rod_mass"]
    for k in range(3):
        turn = 2 * math.pi * k / 3
        R = np.array([[math.cos(turn), -math.sin(turn), 0.0], [math.sin(turn), math.cos(turn), 0.0], [0.0, 0.0, 1.0]])
        p, v, a = P @ R + np.array([d["side"] - d["base"], 0.0, 0.0]), V @ R, A @ R
        x, z, L = p[:, 0], p[:, 2], d["arm"]
        theta = np.arctan2(-z, x) - np.arccos(((p**2).sum(1) + L**2 - d["rod"] ** 2) / (2 * L * np.hypot(x, z)))
        c, s, zero = np.cos(theta), np.sin(theta), np.zeros(len(P))
        elbow, first = L * np.stack([c, zero, -s], 1), L * np.stack([-s, zero, -c], 1)
        u = p - elbow
        grip = _dot(u, first)
        rate = _dot(u, v) / grip
        apart = v - first * rate[:, None]
        second = (_dot(apart, apart) + _dot(u, a + elbow * rate[:, None] ** 2)) / grip
        moved = first * second[:, None] - elbow * rate[:, None] ** 2
        own[:, k] = d["arm_mass"] * (L**2 / 3 * second - first @ G / 2) + m * _dot(moved / 3 + a / 6 - G / 2, first)
        J[:, k] = (u / grip[:, None]) @ R.T
        load = load + m * (a / 3 + moved / 6 - G / 2) @ R.T
        angles[:, k] = theta
    return angles, own + np.linalg.solve(J.transpose(0, 2, 1), load[:, :, None])[:, :, 0]


def _dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.einsum("tc,tc->t", a, b)


# Stewart-Gough platforms: feet (6, 3), heads (6, 3) from the platform's middle, which stands at home; equal point masses


def stewart_closed_form(feet, heads, home, mass: float, leg: float, moves) -> tuple[np.ndarray, np.ndarray]:
    """Leg lengths (times, 6), m, and what the legs push with, N.

    moves : values, rates, second rates (times, 6) of x, y, z, roll, pitch, yaw. mass, leg : of the platform, of each uniform
    leg, kg. By virtual work in the six freedoms; a leg moves with its head as m/3 there and weighs m/2.
    """
    R = _turned(2, [y[:, 5] for y in moves])
    for axis, k in ((1, 4), (0, 3)):
        S = _turned(axis, [y[:, k] for y in moves])
        R = [R[0] @ S[0], R[1] @ S[0] + R[0] @ S[1], R[2] @ S[0] + 2 * R[1] @ S[1] + R[0] @ S[2]]
    arms = np.einsum("tij,kj->tki", R[0], heads)
    legs = home + moves[0][:, None, :3] + arms - feet
    length = np.linalg.norm(legs, axis=2)
    along = legs / length[:, :, None]
    speeding = moves[2][:, None, :3] + np.einsum("tij,kj->tki", R[2], heads)
    load = (mass / 6 + leg / 3) * speeding - (mass / 6 + leg / 2) * G
    wrench = np.concatenate([load.sum(1), np.cross(arms, load).sum(1)], 1)
    J = np.concatenate([along, np.cross(arms, along)], 2).transpose(0, 2, 1)
    return length, np.linalg.solve(J, wrench[:, :, None])[:, :, 0]


def _turned(axis: int, angle: list[np.ndarray]) -> list[np.ndarray]:
    """Rotation (times, 3, 3) about an axis with two rates."""
    q, v, a = angle
    c, s = np.cos(q), np.sin(q)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    found = []
    for cos, sin, one in ((c, s, 1.0), (-s * v, c * v, 0.0), (-c * v**2 - s * a, -s * v**2 + c * a, 0.0)):
        R = np.zeros((len(q), 3, 3))
        R[:, axis, axis], R[:, i, i], R[:, j, j], R[:, i, j], R[:, j, i] = one, cos, cos, -sin, sin
        found.append(R)
    return found


def stewart_end(feet, heads, home, mass: float, leg: float, push: float, t_end: float, rtol: float) -> tuple[np.ndarray, int]:
    """Places of the heads (6, 3) after t_end from rest, every leg pushing with `push`, N; Newton-Euler and SciPy's DOP853."""
    inert, heavy = mass / 6 + leg / 3, mass / 6 + leg / 2
    middle = heads.mean(axis=0)

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        p, v, R, w = y[:3], y[3:6], y[6:15].reshape(3, 3), y[15:]
        arms = heads @ R.T
        legs = p + arms - feet
        force = push * legs / np.sqrt((legs * legs).sum(1))[:, None] + heavy * G
        offset = R @ middle
        spread = inert * ((arms * arms).sum() * np.eye(3) - arms.T @ arms)
        S, W = _skew(6 * inert * offset), _skew(w)
        M = np.block([[6 * inert * np.eye(3), -S], [S, spread]])
        bias = np.concatenate([6 * inert * (W @ W @ offset), W @ (spread @ w)])
        total = np.concatenate(
            [force.sum(0), (arms[:, [1, 2, 0]] * force[:, [2, 0, 1]] - arms[:, [2, 0, 1]] * force[:, [1, 2, 0]]).sum(0)]
        )
        a = np.linalg.solve(M, total - bias)
        return np.concatenate([v, a[:3], (W @ R).reshape(-1), a[3:]])

    start = np.concatenate([home, np.zeros(3), np.eye(3).reshape(-1), np.zeros(3)])
    found = solve_ivp(rates, (0.0, t_end), start, method="DOP853", rtol=rtol, atol=rtol)
    y = found.y[:, -1]
    return y[:3] + heads @ y[6:15].reshape(3, 3).T, found.nfev


def _skew(a: np.ndarray) -> np.ndarray:
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])
