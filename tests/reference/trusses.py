"""Plane and space trusses by the stiffness method in NumPy, with exact derivatives by the areas: an own reference for optima.

Displacements K u = F, K = sum of E A/l b b^T over the bars, b (dofs,) from the directions; forces N = E A/l b.u. With areas as
variables dK/dA_i = E/l_i b_i b_i^T, so du/dA_i = -K^-1 E/l_i b_i (b_i.u) (Haftka and Gurdal, Elements of Structural
Optimization, 1992, section 7.2).
"""

from __future__ import annotations

import numpy as np

IN, LB = 0.0254, 0.45359237
KSI, KIP = 6.894757293168361e6, 4448.2216152605
RAJEEV = (
    1.62, 1.80, 1.99, 2.13, 2.38, 2.62, 2.63, 2.88, 2.93, 3.09, 3.13, 3.38, 3.47, 3.55, 3.63, 3.84, 3.87, 3.88, 4.18, 4.22,
    4.49, 4.59, 4.80, 4.97, 5.12, 5.74, 7.22, 7.97, 11.5, 13.5, 13.9, 14.2, 15.5, 16.0, 16.9, 18.8, 19.9, 22.0, 22.9, 26.5,
    30.0, 33.5,
)  # fmt: skip
"""Sections of the discrete 10-bar truss, in^2 (Rajeev and Krishnamoorthy, J. Struct. Eng. 118 (1992) 1233)."""


class Truss:
    """A truss in inches, kips and ksi; density in lb/in^3, limits of stress in ksi, displacement in in."""

    def __init__(self, nodes, bars, fixed, loads, E=1e4, density=0.1, groups=None):
        names = list(nodes)
        self.names, self.bars, self.E, self.density = names, list(bars), E, density
        places = np.array([nodes[name] for name in names], float)
        dim = places.shape[1]
        free = [(name, axis) for name in names if name not in fixed for axis in range(dim)]
        self.dofs = {one: k for k, one in enumerate(free)}
        ends = np.array([[names.index(a), names.index(b)] for a, b in bars])
        d = places[ends[:, 1]] - places[ends[:, 0]]
        self.length = np.linalg.norm(d, axis=1)
        self.b = np.zeros((len(bars), len(free)))
        for i, (a, b) in enumerate(bars):
            for axis in range(dim):
                u = d[i, axis] / self.length[i]
                if (b, axis) in self.dofs:
                    self.b[i, self.dofs[b, axis]] += u
                if (a, axis) in self.dofs:
                    self.b[i, self.dofs[a, axis]] -= u
        self.loads = []
        for case in loads:
            F = np.zeros(len(free))
            for name, vector in case.items():
                for axis, value in enumerate(vector):
                    F[self.dofs[name, axis]] += value
            self.loads.append(F)
        self.groups = groups or [[i] for i in range(len(bars))]
        self.spread = np.zeros((len(bars), len(self.groups)))
        for g, members in enumerate(self.groups):
            self.spread[members, g] = 1

    def weight(self, A):
        """lb."""
        return self.density * self.length @ (self.spread @ A)

    def weight_gradient(self):
        return self.density * self.length @ self.spread

    def analysed(self, A):
        """Displacements (cases, dofs) and stresses (cases, bars), and their derivatives by the areas of the groups, last."""
        a = self.spread @ A
        k = self.E * a / self.length
        K = (self.b.T * k) @ self.b
        inverse = np.linalg.inv(K)
        u = np.array([inverse @ F for F in self.loads])
        e = u @ self.b.T
        du = -np.einsum("di,ci,i->cdi", inverse @ self.b.T, e, self.E / self.length) @ self.spread
        stress = self.E * e / self.length
        dstress = np.einsum("id,cdg->cig", self.b, du) * (self.E / self.length)[None, :, None]
        return u, stress, du, dstress


def ten_bars():
    """The 10-bar cantilever of two bays of 360 in, 100 kip down at both lower nodes (Venkayya 1971; Haftka and Gurdal)."""
    nodes = {"1": (720, 360), "2": (720, 0), "3": (360, 360), "4": (360, 0), "5": (0, 360), "6": (0, 0)}
    bars = [
        ("5", "3"),
        ("3", "1"),
        ("6", "4"),
        ("4", "2"),
        ("3", "4"),
        ("1", "2"),
        ("5", "4"),
        ("6", "3"),
        ("3", "2"),
        ("4", "1"),
    ]
    return Truss(nodes, bars, ("5", "6"), [{"2": (0, -100), "4": (0, -100)}])


def twenty_five_bars():
    """The 25-bar tower in 8 groups under two load cases (Schmit and Farshi, AIAA J. 12 (1974) 692)."""
    nodes = {
        "1": (-37.5, 0, 200), "2": (37.5, 0, 200), "3": (-37.5, 37.5, 100), "4": (37.5, 37.5, 100), "5": (37.5, -37.5, 100),
        "6": (-37.5, -37.5, 100), "7": (-100, 100, 0), "8": (100, 100, 0), "9": (100, -100, 0), "10": (-100, -100, 0),
    }  # fmt: skip
    groups = [
        ["1-2"], ["1-4", "2-3", "1-5", "2-6"], ["2-5", "2-4", "1-3", "1-6"], ["3-6", "4-5"], ["3-4", "5-6"],
        ["3-10", "6-7", "4-9", "5-8"], ["3-8", "4-7", "6-9", "5-10"], ["3-7", "4-8", "5-9", "6-10"],
    ]  # fmt: skip
    bars = [tuple(name.split("-")) for group in groups for name in group]
    first, index = 0, []
    for group in groups:
        index.append(list(range(first, first + len(group))))
        first += len(group)
    loads = [
        {"1": (1, 10, -5), "2": (0, 10, -5), "3": (0.5, 0, 0), "6": (0.5, 0, 0)},
        {"1": (0, 20, -5), "2": (0, -20, -5)},
    ]
    return Truss(nodes, bars, ("7", "8", "9", "10"), loads, groups=index)
