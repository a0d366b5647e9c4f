"""All poses of a Stewart-Gough platform by 40 paths from the poses of one generic platform, which are stored.

A pose is q, g (4,) with q . g = 0 (E. Study, Geometrie der Dynamen, 1903): R p = q p q*/N and t = 2 g q*/N, N = q . q. Then
|R p + t - b|^2 = l^2 is a quadratic form times 1/N (M. Husty, Mechanism and Machine Theory 31 (1996) 365-380):

    N (p.p + b.b - l^2) + 4 g.g + 4 p . vec(q* g) - 4 b . vec(g q*) - 2 b . (q p q*) = 0.

Seven quadrics in eight homogeneous unknowns, with 40 common points off q = 0 (M. Raghavan, ASME Journal of Mechanical Design
115 (1993) 277-282). The data p, b, l^2 of another platform are reached on the straight line from generic complex ones, which
with probability one meets no singular system (A. P. Morgan & A. J. Sommese, Applied Mathematics and Computation 29 (1989)
123-160).
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kinematics.homotopy import Quadratics, Solutions, followed

if TYPE_CHECKING:
    from numpy.typing import NDArray


KNOWN = Path(__file__).parent / "data" / "general_platform.json"
"""Written by bench/general_platform.py."""
SAME = 1e-9
"""Relative difference up to which weights, and squared distances, count as equal."""
_BASE_ROTATION = np.array([[2.0, -14.0, 5.0], [10.0, 5.0, 10.0], [-11.0, 2.0, 10.0]]) / 15
"""A rotation of the base. With it, the half turns of symmetric platforms, for which q[0] = 0, become general rotations."""
_WAYS = 2
"""Number of intermediate platforms that are tried if a few paths are lost."""
_FEW = 4
"""Largest number of lost paths for that; if more are lost, the platform is a special one with fewer solutions."""


def _forms() -> NDArray[np.float64]:
    """Symmetric forms (17, 8, 8) over (q, g), with the factors p.p + b.b - l^2, 1, p, b, and b p^T row by row."""
    left = np.zeros((4, 4, 4))  # Hamilton's product: (x y)_k = left[k, i, j] x_i y_j
    for k, i, j, sign in (
        (0, 0, 0, 1),
        (0, 1, 1, -1),
        (0, 2, 2, -1),
        (0, 3, 3, -1),
        (1, 0, 1, 1),
        (1, 1, 0, 1),
        (1, 2, 3, 1),
        (1, 3, 2, -1),
        (2, 0, 2, 1),
        (2, 2, 0, 1),
        (2, 3, 1, 1),
        (2, 1, 3, -1),
        (3, 0, 3, 1),
        (3, 3, 0, 1),
        (3, 1, 2, 1),
        (3, 2, 1, -1),
    ):
        left[k, i, j] = sign
    star = np.diag([1.0, -1.0, -1.0, -1.0])
    found = np.zeros((17, 8, 8))
    found[0, :4, :4], found[1, 4:, 4:] = np.eye(4), 4 * np.eye(4)
    for k in range(3):
        found[2 + k, :4, 4:] = 4 * np.einsum("mi,mj->ij", star, left[k + 1])  # vec(q* g)
        found[5 + k, 4:, :4] = -4 * np.einsum("im,mj->ij", left[k + 1], star)  # vec(g q*)
    turned = np.einsum("kmj,mia,jb->kiab", left, left.transpose(0, 2, 1), star)  # (q p q*)_k of p_i q_a q_b
    for k in range(3):
        for i in range(3):
            found[8 + 3 * k + i, :4, :4] = -2 * turned[k + 1, i + 1]
    return np.asarray(0.5 * (found + found.transpose(0, 2, 1)))


_FORMS = _forms()
_STUDY = np.block([[np.zeros((4, 4)), np.eye(4)], [np.eye(4), np.zeros((4, 4))]]) / 2


@dataclass(frozen=True, eq=False)
class Platform:
    """p, b (6, 3), squares (6,) of leg lengths; lengths over one scale. Complex data are generic."""

    p: Any
    b: Any
    squares: Any

    def data(self) -> NDArray[Any]:
        """All data, (6, 7)."""
        return np.concatenate([self.p, self.b, np.asarray(self.squares)[:, None]], axis=1)

    def at(self, z: Any) -> tuple[Any, Any]:
        """Values (paths, 7) and gradients (paths, 7, 8) at z = (q, g), (paths, 8)."""
        return _values(_quadrics(self.data()[None])[0], z)


def _quadrics(data: Any) -> tuple[Any, Any]:
    """The seven forms (k, 7, 8, 8) of data (k, 6, 7), and their weights (k, 6, 17)."""
    p, b, squares = data[..., :3], data[..., 3:6], data[..., 6]
    first = np.sum(p * p, axis=-1) + np.sum(b * b, axis=-1) - squares
    outer = (b[..., :, None] * p[..., None, :]).reshape(*b.shape[:-1], 9)
    weights = np.concatenate([first[..., None], np.ones_like(first)[..., None], p, b, outer], axis=-1)
    legs = (weights @ _FORMS.reshape(17, 64)).reshape(*weights.shape[:-1], 8, 8)
    study = np.broadcast_to(_STUDY, (*legs.shape[:-3], 1, 8, 8))
    return np.concatenate([legs, study], axis=-3), weights


def _values(Q: Any, z: Any) -> tuple[Any, Any]:
    half = np.einsum("...mij,pj->pmi", Q, z) if Q.ndim == 3 else np.einsum("pmij,pj->pmi", Q, z)
    return np.einsum("pmi,pi->pm", half, z), 2 * half


class _Way:
    """The straight line of the data from a start (t = 1) to a target (t = 0), in projective coordinates on a random plane."""

    def __init__(self, target: Platform, start: Platform, rng: np.random.Generator) -> None:
        self.target = target
        self.first, self.last = start.data(), target.data()
        self.plane = rng.normal(size=8) + 1j * rng.normal(size=8)

    def at(self, z: Any, t: Any) -> tuple[Any, Any, Any]:
        """H with the plane (paths, 8), dH/dz (paths, 8, 8), dH/dt (paths, 8)."""
        change = self.first - self.last
        data = self.last + t[:, None, None] * change
        Q, _ = _quadrics(data)
        H, J, Ht = (np.zeros((len(z), *shape), complex) for shape in ((8,), (8, 8), (8,)))
        H[:, :7], J[:, :7] = _values(Q, z)
        H[:, 7], J[:, 7] = z @ self.plane - 1, self.plane
        p, b, dp, db = data[..., :3], data[..., 3:6], change[:, :3], change[:, 3:6]
        first = 2 * np.sum(p * dp, axis=-1) + 2 * np.sum(b * db, axis=-1) - change[:, 6]
        outer = db[:, :, None] * p[..., None, :] + b[..., :, None] * dp[:, None, :]
        rest = np.broadcast_to(np.concatenate([np.zeros((6, 1)), dp, db], axis=1), (len(z), 6, 7))
        rates = np.concatenate([first[..., None], rest, outer.reshape(len(z), 6, 9)], axis=-1)
        both = (z[:, :, None] * z[:, None, :]).reshape(-1, 64) @ _FORMS.reshape(17, 64).T
        Ht[:, :6] = np.einsum("pmf,pf->pm", rates, both)
        return H, J, Ht


@lru_cache(maxsize=1)
def known_platform() -> tuple[Platform, NDArray[np.complex128]]:
    """The generic platform and its 40 poses (40, 8), q[0] = 1."""
    stored = json.loads(KNOWN.read_text())
    p, b, squares, z = (
        np.array(stored[key]["real"]) + 1j * np.array(stored[key]["imaginary"]) for key in ("p", "b", "l2", "z")
    )
    return Platform(p=p, b=b, squares=squares), z


def solve_platform(target: Platform) -> Solutions:
    """All poses of a platform as u = (q, g)/q[0] without the 1, (solutions, 7)."""
    start, z = known_platform()
    best = followed(_Way(target, start, np.random.default_rng(7)), z)
    rng = np.random.default_rng(5)
    for _ in range(_WAYS):
        if not 0 < len(z) - len(best.u) <= _FEW:
            break
        between = _generic(rng)
        there = followed(_Way(between, start, rng), z)
        again = followed(_Way(target, between, rng), np.concatenate([np.ones((len(there.u), 1)), there.u], axis=1))
        best = again if len(again.u) > len(best.u) else best
    return best


def all_places(block: Quadratics, points: NDArray[np.float64]) -> NDArray[np.complex128] | None:
    """All 40 solutions u (40, 3 k) of the equations of a body of k = 3 or 4 points on six legs, mirror images left out.

    points (k, 3) : of the body in any pose. None if the block has another form, or fewer finite solutions.
    """
    found = _as_platform(block, points)
    if found is None:
        return None
    solutions = solve_platform(found)
    if len(solutions.u) != len(known_platform()[1]):
        return None
    R, t = poses_of(solutions.u)
    R, t = _BASE_ROTATION.T @ R, t @ _BASE_ROTATION
    u = (np.einsum("kij,lj->kli", R, points) + t[:, None]).reshape(len(t), -1)
    return np.asarray(u) if np.isfinite(u).all() else None


def _as_platform(block: Quadratics, points: NDArray[np.float64]) -> Platform | None:
    """The platform given by six rows sum_j w_j u_j + d, sum w = 1 or -1, and the distances of all points."""
    count = len(points)
    if block.D.shape[2] != 3 * count or len(block.s) != 6 + count * (count - 1) // 2 or block.linear.any():
        return None
    w = block.D[:, 0, ::3]
    if np.abs(np.einsum("mk,cd->mckd", w, np.eye(3)).reshape(block.D.shape) - block.D).max() > SAME:
        return None
    total = w.sum(axis=1)
    legs, pairs = np.abs(np.abs(total) - 1) < SAME, np.abs(total) < SAME
    shape = np.sum((w[pairs] @ points) ** 2, axis=1)
    if legs.sum() != 6 or (legs | pairs).sum() != len(total) or np.any(block.d[pairs] != 0):
        return None
    if np.linalg.matrix_rank(w[pairs]) < count - 1 or np.abs(shape - block.s[pairs]).max() > SAME * shape.max():
        return None
    sign = np.sign(total[legs])[:, None]
    return Platform(p=sign * w[legs] @ points, b=-sign * block.d[legs] @ _BASE_ROTATION.T, squares=block.s[legs])


def _generic(rng: np.random.Generator) -> Platform:
    """A platform of random complex data."""

    def drawn(*shape: int) -> Any:
        return rng.normal(size=shape) + 1j * rng.normal(size=shape)

    return Platform(p=drawn(6, 3), b=drawn(6, 3), squares=drawn(6))


def poses_of(u: Any) -> tuple[Any, Any]:
    """Rotations (k, 3, 3) and translations (k, 3) of solutions u (k, 7)."""
    q, g = np.concatenate([np.ones((len(u), 1)), u[:, :3]], axis=1), u[:, 3:]
    w, v = q[:, :1], q[:, 1:]
    N = np.sum(q * q, axis=1)[:, None]
    cross = np.zeros((len(u), 3, 3), q.dtype)
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -v[:, 2], v[:, 1], -v[:, 0]
    cross = cross - cross.transpose(0, 2, 1)
    R = (w * w - np.sum(v * v, axis=1)[:, None])[..., None] * np.eye(3) + 2 * v[:, :, None] * v[:, None, :]
    R = (R + 2 * w[..., None] * cross) / N[..., None]
    t = 2 * (w * g[:, 1:] - g[:, :1] * v - np.cross(g[:, 1:], v)) / N
    return R, t
