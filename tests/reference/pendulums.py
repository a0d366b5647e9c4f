"""Chains of pin-jointed rods in the plane, in absolute angles: Lagrange's equations written out, and the joint forces after.

Angles are measured from hanging, positive towards +x. The rod k has the end masses behind it as bobs:
    M_jk = C_jk cos(th_j - th_k),  C_jk = l_j l_k (half of the rod max(j, k) + all behind it),  C_kk = l_k^2 (m_k/3 + behind)
    sum_k M_jk th_k'' + C_jk sin(th_j - th_k) th_k'^2 + g l_j (m_j/2 + all behind it) sin th_j = torque_j - torque_{j+1}
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

__all__ = ["Chain"]


@dataclass(frozen=True)
class Chain:
    """Lengths (m), masses of uniform rods and of bobs at their far ends (kg), gravity (m/s^2) along -y, torques at the pins."""

    lengths: tuple[float, ...]
    rods: tuple[float, ...]
    bobs: tuple[float, ...]
    gravity: float = 9.81
    torques: tuple[float, ...] | None = None

    def _weights(self) -> tuple[np.ndarray, np.ndarray]:
        l, m, b = (np.array(values, float) for values in (self.lengths, self.rods, self.bobs))
        behind = np.array([b[k:].sum() + m[k + 1 :].sum() for k in range(len(l))])
        reach = l * (m / 2 + behind)  # first moment about its own pin of what the rod k carries
        C = np.empty((len(l), len(l)))
        for j in range(len(l)):
            for k in range(len(l)):
                C[j, k] = l[min(j, k)] * reach[max(j, k)] if j != k else l[k] ** 2 * (m[k] / 3 + behind[k])
        return C, reach

    def acceleration(self, theta: np.ndarray, rate: np.ndarray) -> np.ndarray:
        """Second derivatives of the angles."""
        C, reach = self._weights()
        apart = theta[:, None] - theta
        torque = np.zeros(len(theta) + 1)
        if self.torques is not None:
            torque[:-1] = self.torques
        right = torque[:-1] - torque[1:] - (C * np.sin(apart)) @ rate**2 - self.gravity * reach * np.sin(theta)
        return np.linalg.solve(C * np.cos(apart), right)

    def energy(self, theta: np.ndarray, rate: np.ndarray) -> tuple[float, float]:
        """Kinetic and potential (zero where all hang), J."""
        C, reach = self._weights()
        apart = theta[:, None] - theta
        return 0.5 * float(rate @ (C * np.cos(apart)) @ rate), float(self.gravity * reach @ (1 - np.cos(theta)))

    def run(self, theta: np.ndarray, rate: np.ndarray, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Angles and rates (times, links) from the start at times[0]."""
        count = len(self.lengths)

        def slope(_: float, state: np.ndarray) -> np.ndarray:
            return np.concatenate([state[count:], self.acceleration(state[:count], state[count:])])

        start = np.concatenate([theta, rate]).astype(float)
        found = solve_ivp(slope, (times[0], times[-1]), start, "DOP853", times, rtol=1e-13, atol=1e-14)
        return found.y[:count].T, found.y[count:].T

    def joints(self, theta: np.ndarray, rate: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Positions, velocities, accelerations (links, 2) of the far ends of the rods."""
        second = self.acceleration(theta, rate)
        l = np.array(self.lengths)[:, None]
        out, left = np.stack([np.sin(theta), -np.cos(theta)], 1), np.stack([np.cos(theta), np.sin(theta)], 1)
        velocity, acceleration = l * left * rate[:, None], l * (left * second[:, None] - out * (rate**2)[:, None])
        return tuple(np.cumsum(value, axis=0) for value in (l * out, velocity, acceleration))

    def pin_forces(self, theta: np.ndarray, rate: np.ndarray) -> np.ndarray:
        """Force (links, 2) on each rod at its near pin: the rate of momentum of all behind it, less its weight."""
        acceleration = self.joints(theta, rate)[2]
        before = np.vstack([np.zeros(2), acceleration[:-1]])
        up = np.array([0.0, self.gravity])
        m, b = np.array(self.rods)[:, None], np.array(self.bobs)[:, None]
        own = m * ((before + acceleration) / 2 + up) + b * (acceleration + up)
        return np.cumsum(own[::-1], axis=0)[::-1]
