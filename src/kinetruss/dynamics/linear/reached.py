"""Motions of a linear system that its inputs do not reach, by the test of Popov, Belevitch and Hautus."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

__all__ = ["not_reached"]

TOLERANCE = 1e-11
"""Of the smallest singular value of [A - p 1, B], and of the decay -Re p, relative to the norm of the balanced A."""


def not_reached(A: Floats, B: Floats) -> tuple[Floats, NDArray[np.complex128]]:
    """Motions of z' = A z + B u that no input changes and that do not decay.

    Returns W (states, k), orthonormal columns with W'B = 0 and W'A = (W'A W) W', and their k poles. A pole p is not
    reached where a row w' has w'A = p w' and w'B = 0: [A - p 1, B] loses rank (Hautus, 1969). What remains across the rows
    found is searched again, for chains of equal poles. Units do not count: A is balanced, the columns of B have its norm.
    """
    from scipy.linalg import matrix_balance, qr

    balanced, (scale, _) = matrix_balance(A, permute=False, separate=True)
    inputs = B / scale[:, None]
    size = float(np.linalg.norm(balanced, 2))
    inputs = inputs * (size / np.maximum(np.linalg.norm(inputs, axis=0), np.finfo(float).tiny))
    basis, rest = np.zeros((len(A), 0)), np.eye(len(A))
    while rest.shape[1]:
        rows = _rows_of(rest.T @ balanced @ rest, rest.T @ inputs, TOLERANCE * size)
        if not rows.shape[1]:
            break
        basis = np.linalg.qr(np.hstack([basis, rest @ rows]))[0]
        rest = qr(basis)[0][:, basis.shape[1] :]
    W = np.linalg.qr(basis / scale[:, None])[0]
    return W, np.linalg.eigvals(W.T @ A @ W)


def _rows_of(A: Floats, B: Floats, least: float) -> Floats:
    """Orthonormal columns w with w'A = p w' and w'B = 0 of poles p that do not decay; a complex row gives two of them."""
    found = []
    for pole in np.linalg.eigvals(A):
        if pole.real >= -least and pole.imag >= -least:
            both = np.hstack([A - pole * np.eye(len(A)), B])
            if np.linalg.svd(both, compute_uv=False)[-1] > least:
                continue
            left, size, _ = np.linalg.svd(both)
            rows = left[:, size <= least].conj()
            found += [rows.real] if abs(pole.imag) <= least else [rows.real, rows.imag]
    if not found:
        return np.zeros((len(A), 0))
    left, size, _ = np.linalg.svd(np.hstack(found), full_matrices=False)
    return left[:, size > np.sqrt(np.finfo(float).eps)]
