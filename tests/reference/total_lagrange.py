"""Membranes and solids by the total-Lagrangian formulas: forces, and by complex steps the tangent.

f = -V0 F S grad N, S = C E, E = (F^T F - 1)/2 (Bathe, Finite Element Procedures, 6.3). Kinds, materials and axes are those of
the models ``element.KIND`` of the verification.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.verification.cases import model
from kinetruss.verification.solids import STEEL

__all__ = ["KINDS", "forces", "tangent"]

PLY: Any = model("element.orthotropic").membranes["one"].orthotropic
TURN = 0.5
"""rad, of its axis."""

KINDS = (
    "plane_stress",
    "plane_strain",
    "orthotropic",
    "membrane",
    "membrane_orthotropic",
    "tetrahedron",
    "tetrahedron_orthotropic",
    "six_nodes",
)


def forces(kind: str, start: NDArray[Any], x: NDArray[Any]) -> NDArray[Any]:
    """Forces on the nodes (v dim,), N, at positions x (v, dim), which may be complex; start: positions without stress."""
    dim = start.shape[1]
    deep = ((0, 0), (0, 3 - dim))
    return _lagrangian(kind, np.pad(start, deep), np.pad(x, deep))[:, :dim].reshape(-1)


def tangent(kind: str, start: NDArray[np.float64], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Minus the derivative of the forces (v dim, v dim), N/m, by complex steps."""
    steps = x + 1e-30j * np.eye(x.size).reshape(-1, *x.shape)
    return -np.array([forces(kind, start, y).imag / 1e-30 for y in steps]).T


def _law(kind: str) -> NDArray[np.float64]:
    """C in material axes, Pa, written out."""
    if kind.endswith("orthotropic"):
        E1, E2, E3 = PLY.E1, PLY.E2, PLY.E3 or 0.0
        n12, n13, n23 = PLY.nu12, PLY.nu13 or 0.0, PLY.nu23 or 0.0
        if not kind.startswith("tetrahedron"):
            n21 = n12 * E2 / E1
            one = 1 - n12 * n21
            return np.array([[E1 / one, n12 * E2 / one, 0], [n12 * E2 / one, E2 / one, 0], [0, 0, PLY.G12]])
        n21, n31, n32 = n12 * E2 / E1, n13 * E3 / E1, n23 * E3 / E2
        one = (1 - n12 * n21 - n23 * n32 - n13 * n31 - 2 * n21 * n32 * n13) / (E1 * E2 * E3)
        C = np.zeros((6, 6))
        C[0, :3] = np.array([1 - n23 * n32, n21 + n31 * n23, n31 + n21 * n32]) / (E2 * E3 * one)
        C[1, :3] = np.array([n12 + n13 * n32, 1 - n31 * n13, n32 + n31 * n12])
        C[1, :3] = [C[0, 1], C[1, 1] / (E1 * E3 * one), C[1, 2] / (E1 * E3 * one)]
        C[2, :3] = [C[0, 2], C[1, 2], (1 - n12 * n21) / (E1 * E2 * one)]
        C[3, 3], C[4, 4], C[5, 5] = PLY.G23 or 0.0, PLY.G13 or 0.0, PLY.G12
        return C
    E, nu = STEEL.E, STEEL.poisson
    if kind in ("plane_stress", "membrane", "six_nodes"):
        return E / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    lame, G = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
    if kind == "plane_strain":
        return np.array([[lame + 2 * G, lame, 0], [lame, lame + 2 * G, 0], [0, 0, G]])
    return np.asarray(lame * np.pad(np.ones((3, 3)), (0, 3)) + G * np.diag([2.0, 2, 2, 1, 1, 1]))


def _lagrangian(kind: str, x0: NDArray[Any], x: NDArray[Any]) -> NDArray[Any]:
    """Forces on the nodes (v, 3), N, by the total-Lagrangian formulas; x (v, 3) may be complex."""
    C, axes = _law(kind), _axes(kind, x0)
    X = (x0 - x0[0]) @ axes.T
    total = np.zeros(x.shape, x.dtype)
    for weight, local in _points(len(x0)):
        J = local.T @ X
        grad = local @ np.linalg.inv(J).T
        volume = weight * abs(np.linalg.det(J)) * (1.0 if len(C) == 6 else 0.02)
        F = x.T @ grad
        green = 0.5 * (F.T @ F - np.eye(len(axes)))
        if len(C) == 6:
            pairs = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
        else:
            pairs = ((0, 0), (1, 1), (0, 1))
        S = np.zeros(green.shape, x.dtype)
        for value, (a, b) in zip(C @ np.array([green[a, b] * (1 if a == b else 2) for a, b in pairs]), pairs, strict=True):
            S[a, b] = S[b, a] = value
        total -= volume * grad @ S @ F.T
    return total


def _axes(kind: str, x0: NDArray[np.float64]) -> NDArray[np.float64]:
    """Material axes as rows."""
    if kind == "orthotropic":
        return np.array([[math.cos(TURN), math.sin(TURN), 0], [-math.sin(TURN), math.cos(TURN), 0]])
    if kind.startswith("membrane"):
        normal = np.cross(x0[1] - x0[0], x0[2] - x0[0])
        normal /= np.linalg.norm(normal)
        wanted = np.array([1.0, 0.4, 0.2]) if kind.endswith("orthotropic") else np.array([1.0, 0, 0])
        one = wanted - (wanted @ normal) * normal
        one /= np.linalg.norm(one)
        return np.array([one, np.cross(normal, one)])
    if kind == "tetrahedron_orthotropic":
        one, two = np.array([1.0, 0.4, 0.2]), np.array([-0.3, 1.0, 0.1])
        one = one / np.linalg.norm(one)
        two = two - (two @ one) * one
        two /= np.linalg.norm(two)
        return np.array([one, two, np.cross(one, two)])
    return np.eye(3)[: 3 if kind == "tetrahedron" else 2]


def _points(nodes: int) -> list[tuple[float, NDArray[np.float64]]]:
    """Weights and derivatives (v, s) of the shape functions; six nodes: the seven-point rule of degree 5 (Radon, 1948)."""
    if nodes in (3, 4):
        return [(1 / math.factorial(nodes - 1), np.vstack([-np.ones((1, nodes - 1)), np.eye(nodes - 1)]))]
    found, root = [], math.sqrt(15.0)
    places = [(9 / 40, 1 / 3, 1 / 3)]
    for w, a in (((155 - root) / 1200, (6 - root) / 21), ((155 + root) / 1200, (6 + root) / 21)):
        places += [(w, a, a), (w, 1 - 2 * a, a), (w, a, 1 - 2 * a)]
    for w, r, s in places:
        t = 1 - r - s
        by_r = [1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s]
        by_s = [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]
        found.append((w / 2, np.array([by_r, by_s]).T))
    return found
