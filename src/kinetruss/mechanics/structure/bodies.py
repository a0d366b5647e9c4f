"""Mass of bodies at the nodes that carry them, as pairs of nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model import Model, body_mass
from kinetruss.model.beams import rigid_beams

if TYPE_CHECKING:
    from numpy.typing import NDArray


__all__ = ["pair_arrays"]

THIN = 1e-10
"""Eigenvalues of m_ij below this fraction of the largest count as zero: the body lies in a plane or on a line."""


def pair_arrays(model: Model, index: dict[str, int]) -> dict[str, NDArray[Any]]:
    """pair_p, pair_q, pair_mass, pair_skew and thin of `System`."""
    pairs: list[tuple[int, int, float, float]] = []
    thin = np.zeros(len(index), np.bool_)
    for body in [*model.bodies.values(), *rigid_beams(model)]:
        if body.mass:
            nodes = [index[name] for name in body.carried_by(model.dim)]
            m, skew = body_mass(model, body)
            pairs += [
                (nodes[i], nodes[j], float(m[i, j]), skew if i != j else 0.0)
                for i in range(len(nodes))
                for j in range(i, len(nodes))
                if m[i, j] or (skew and i != j)
            ]
            thin[nodes] |= _is_thin(m, skew)
    p, q, mass, turn = zip(*pairs, strict=True) if pairs else ((), (), (), ())
    return {
        "pair_p": np.array(p, np.int32),
        "pair_q": np.array(q, np.int32),
        "pair_mass": np.array(mass, np.float64),
        "pair_skew": np.array(turn, np.float64),
        "thin": thin,
    }


def _is_thin(m: NDArray[np.float64], skew: float) -> bool:
    """True if the matrix of a body has a direction without inertia."""
    values = np.linalg.eigvalsh(m + 1j * np.triu(np.full_like(m, skew), 1) - 1j * np.tril(np.full_like(m, skew), -1))
    return bool(values[0] <= THIN * values[-1])
