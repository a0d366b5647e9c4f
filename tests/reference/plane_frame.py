"""A plane frame by the stiffness method: Euler-Bernoulli beams, uniform weight, clamped nodes.

McGuire, Gallagher and Ziemian, Matrix Structural Analysis (2000), eq. 4.34 (stiffness) and table 4.1 (fixed ends).
"""

from __future__ import annotations

import numpy as np


def solve(nodes, beams, clamped, loads, *, EA, EI, weight):
    """Section forces T, V, M at both ends of each beam, and reactions (Fx, Fy, Mz) of clamped nodes.

    nodes : name -> (x, y), m. beams : name -> (A, B). loads : name -> (Fx, Fy), N. weight : N/m, downward.
    Signs: what the B side exerts on the A side, in axes along the beam and 90 degrees to its left.
    """
    index = {name: 3 * k for k, name in enumerate(nodes)}
    size = 3 * len(nodes)
    K, F = np.zeros((size, size)), np.zeros(size)
    parts = {}
    for name, (a, b) in beams.items():
        d = np.subtract(nodes[b], nodes[a])
        L = float(np.hypot(*d))
        c, s = d / L
        R = np.kron(np.eye(2), np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]]))
        k = np.zeros((6, 6))
        k[np.ix_([0, 3], [0, 3])] = EA / L * np.array([[1, -1], [-1, 1]])
        bend = EI / L**3 * np.array([[12, 6 * L, -12, 6 * L], [6 * L, 4 * L**2, -6 * L, 2 * L**2],
                                     [-12, -6 * L, 12, -6 * L], [6 * L, 2 * L**2, -6 * L, 4 * L**2]])  # fmt: skip
        k[np.ix_([1, 2, 4, 5], [1, 2, 4, 5])] = bend
        along, across = -weight * s, -weight * c
        fixed = np.array(
            [along * L / 2, across * L / 2, across * L**2 / 12, along * L / 2, across * L / 2, -across * L**2 / 12]
        )
        at = np.r_[index[a] : index[a] + 3, index[b] : index[b] + 3]
        K[np.ix_(at, at)] += R.T @ k @ R
        F[at] += R.T @ fixed
        parts[name] = at, k, R, fixed
    for name, (fx, fy) in loads.items():
        F[index[name] : index[name] + 2] += fx, fy
    held = [index[name] + k for name in clamped for k in range(3)]
    free = [k for k in range(size) if k not in held]
    u = np.zeros(size)
    u[free] = np.linalg.solve(K[np.ix_(free, free)], F[free])
    ends = {}
    for name, (at, k, R, fixed) in parts.items():
        f = k @ R @ u[at] - fixed  # by the nodes on the beam
        ends[name] = {"T": (-f[0], f[3]), "V2": (-f[1], f[4]), "M3": (-f[2], f[5])}
    reaction = K @ u - F
    return ends, {name: reaction[index[name] : index[name] + 3] for name in clamped}
