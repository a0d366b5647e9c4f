"""Viscous friction about pins of planar structures: a torque against what two bars turn at one pin, or one bar on the ground.

A bar from the pin P to Q turns at w = (d x v_Q - d x v_P)/L^2 with d = x_Q - x_P, so that w = g . v with the gradient
(-d_y, d_x)/L^2 at Q and its negative at P. Friction c (N m s) between two bars gives the torque T = c (w_1 - w_2), which acts
as the forces -T (g_1 - g_2) on the nodes; it takes the power c (w_1 - w_2)^2.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I2
from kinetruss.kernels.structure.structure import Structure

__all__ = ["add_pins", "pin_loss", "pin_torques", "add_pin_forces"]


@kernel_inline
def _gradient(x: F1, P: int, Q: int) -> tuple[float, float]:
    """Gradient of the turning rate of the line from P to Q, at Q; zero where the line is the ground (P = Q)."""
    if P == Q:
        return 0.0, 0.0
    dx, dy = x[Q] - x[P], x[Q + 1] - x[P + 1]
    square = dx * dx + dy * dy
    return -dy / square, dx / square


@kernel_inline
def _gradients(s: Structure, k: int, x: F1) -> tuple[float, ...]:
    """g_1 - g_2 of pair k at P, A and B, six numbers."""
    ax, ay = _gradient(x, s.pin_P[k], s.pin_A[k])
    bx, by = _gradient(x, s.pin_P[k], s.pin_B[k])
    return bx - ax, by - ay, ax, ay, -bx, -by


@kernel_inline
def _torque(s: Structure, k: int, g: tuple[float, ...], v: F1) -> float:
    """c (w_1 - w_2) of pair k, N m."""
    P, A, B = s.pin_P[k], s.pin_A[k], s.pin_B[k]
    return s.pin[k] * (g[0] * v[P] + g[1] * v[P + 1] + g[2] * v[A] + g[3] * v[A + 1] + g[4] * v[B] + g[5] * v[B + 1])


@kernel_bare
def add_pin_forces(s: Structure, x: F1, v: F1, f: F1) -> None:
    """Add to f (3 n,) the nodal forces of friction about pins, N."""
    # -T (g_1 - g_2) at the pin and at both far ends
    for k in range(s.pin_P.size):
        g = _gradients(s, k, x)
        T = _torque(s, k, g, v)
        f[s.pin_P[k]] -= T * g[0]
        f[s.pin_P[k] + 1] -= T * g[1]
        f[s.pin_A[k]] -= T * g[2]
        f[s.pin_A[k] + 1] -= T * g[3]
        f[s.pin_B[k]] -= T * g[4]
        f[s.pin_B[k] + 1] -= T * g[5]


@kernel_bare
def pin_loss(s: Structure, x: F1, v: F1) -> float:
    """Power that friction about pins takes, W: T^2/c of every pair."""
    lost = 0.0
    # power c (w_1 - w_2)^2 of each pair
    for k in range(s.pin_P.size):
        T = _torque(s, k, _gradients(s, k, x), v)
        lost += T * T / s.pin[k]
    return lost


@kernel_bare
def pin_torques(s: Structure, x: F2, v: F2, out: F2) -> None:
    """Torques c (w_1 - w_2), N m, of all pairs into out (times, pairs), along x, v (times, 3 n): on bar 2, and off bar 1."""
    # T = c (w_1 - w_2) of each pair at each sample
    for i in range(x.shape[0]):
        for k in range(s.pin_P.size):
            out[i, k] = _torque(s, k, _gradients(s, k, x[i]), v[i])


@kernel_bare
def add_pins(s: Structure, at: I2, x: F1, gamma: float, value: F1) -> None:
    """Add gamma c g g^T, with g = g_1 - g_2, to the lower triangle of a matrix in value, its places at (pairs, 36)."""
    # damping matrix c g g^T
    for k in range(s.pin_P.size):
        g, c = _gradients(s, k, x), gamma * s.pin[k]
        for i in range(6):
            for j in range(i + 1):
                value[at[k, 6 * i + j]] += c * g[i] * g[j]
