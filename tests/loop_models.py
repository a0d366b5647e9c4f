"""Loops of rigid bodies with skew hinges, placed by the lengths, twists and offsets of Denavit & Hartenberg (1955)."""

import numpy as np
from scipy.optimize import least_squares

import kinetruss as kt


def goldberg():
    """Lengths, twists, offsets of Goldberg's five hinges: two of Bennett's linkages with a common link that is taken out."""
    a, alpha, beta, gamma = 0.35, 1.0, 0.55, 0.35
    size = a / np.sin(alpha)
    b, c = size * np.sin(beta), size * np.sin(gamma)
    return (a, b + c, a, c, b), (alpha, beta + gamma, alpha, gamma, beta), (0.0,) * 5


def line_symmetric():
    """Bricard's six hinges that are symmetric about a line: what is opposite is alike."""
    return (0.3, 0.2, 0.25) * 2, (0.8, 1.2, -0.7) * 2, (0.05, 0.1, -0.08) * 2


def plane_symmetric():
    """Bricard's six hinges with a plane of symmetry through the first and the fourth."""
    return (0.3, 0.2, 0.25, 0.25, 0.2, 0.3), (0.8, 1.2, 0.7, -0.7, -1.2, -0.8), (0.0, 0.08, 0.05, 0.0, -0.05, -0.08)


def _turn(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]] if axis else [[1, 0, 0], [0, c, -s], [0, s, c]])


def hinges(lengths, twists, offsets, angles):
    """Points and directions of the hinges, and how far the loop is from closing (9,)."""
    R, at, found = np.eye(3), np.zeros(3), []
    for a, alpha, offset, angle in zip(lengths, twists, offsets, angles, strict=True):
        found.append((at + offset * R[:, 2], R[:, 2]))
        at = at + offset * R[:, 2]
        R = R @ _turn(1, angle)
        at, R = at + a * R[:, 0], R @ _turn(0, alpha)
    return found, np.concatenate([at, (R - np.eye(3))[np.triu_indices(3)]])


STARTS = {
    "goldberg": (1.0, -2.7967, -1.6376, 2.1416, 1.2927),
    "line_symmetric": (1.0, 3.0176, -1.0372, 1.0, 3.0176, -1.0372),
    "plane_symmetric": (1.0, -2.6546, -1.5951, 1.9502, -1.5951, -2.6546),
}
"""Angles of the loops near which they close with the first at 1 rad."""


def angles_at(data, first, guess):
    """The angles of a loop with the first one given."""
    found = least_squares(lambda rest: hinges(*data, [first, *rest])[1], guess[1:], xtol=1e-15, ftol=1e-15, gtol=1e-15)
    assert found.cost < 1e-20
    return np.array([first, *found.x])


def loop(data, angles, hinge=0.15):
    """The model: bodies L1, L2, ... between hinges with nodes Pk, Ak; the last is the ground; `crank` turns the first hinge."""
    count = len(data[0])
    nodes = {}
    for k, (point, direction) in enumerate(hinges(*data, angles)[0], start=1):
        nodes |= {f"P{k}": tuple(point), f"A{k}": tuple(point + hinge * direction)}
    bodies = {f"L{k}": kt.Body(nodes=(f"P{k}", f"A{k}", f"P{k + 1}", f"A{k + 1}"), mass=1.0 + 0.2 * k) for k in range(1, count)}
    return kt.Model(
        nodes=nodes, fixed=["P1", "A1", f"P{count}", f"A{count}"], bodies=bodies, gravity=(0, 0, -9.81),
        drives={"crank": kt.HingeDrive(axis=("P1", "A1"), start=f"P{count}", end="P2")},
    )  # fmt: skip
