"""Round tubes of a catalogue against the section forces of members: which is the lightest that carries them.

The forces of a member (`section_polynomials`) are those of the model at hand; only the tube that meets them changes. What does
not depend on the tube is found once a sample: the largest |T|, |V|, |M| along the part and the largest compression P along
the member. Rules as in `strength.utilisation`:

    yield        von Mises along the part; first the bound (|T|/A + |M| c/I)^2 + 3 (k |V|/A)^2, exactly where that exceeds 1
    buckling     n_b P/P_cr, P_cr by Euler or Johnson
    beam-column  n_b P/P_cr + C_m M c/I/((1 - n_b P/P_e) S_y/n_y) where P > 0
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.sections.peaks import MOMENT_RESULTANT, part_least_tension, part_top
from kinetruss.kernels.sections.stress import ROUND

__all__ = ["assess", "scan"]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_SPANS = 12  # sections scanned along a part, as the check does


@kernel_inline
def _largest(c0: float, c1: float, c2: float, lo: float, hi: float) -> float:
    """Largest |c0 + c1 x + c2 x^2| over [lo, hi]."""
    best = max(abs(c0 + lo * (c1 + lo * c2)), abs(c0 + hi * (c1 + hi * c2)))
    if c2 != 0.0:
        x = -0.5 * c1 / c2
        if lo < x < hi:
            best = max(best, abs(c0 + 0.5 * c1 * x))
    return best


@kernel
def _critical(euler: float, squash: float) -> float:
    """Johnson's load of a stocky member, else Euler's."""
    return squash * (1.0 - 0.25 * squash / euler) if euler > 0.5 * squash else euler


@kernel
def _demand(coef: Floats, ends: Floats, i: int, part: int, base: int) -> Any:
    """|T|, |V|, |M| along a part and P along its member."""
    T, V = 0.0, 0.0
    for j in range(coef.shape[2]):
        lo, hi = 0.0 if j == 0 else ends[i, part, j - 1], min(1.0, ends[i, part, j])
        if lo >= 1.0:
            break
        c = coef[i, part, j]
        T = max(T, _largest(c[0], c[1], c[2], lo, hi))
        V = max(V, math.sqrt(_largest(c[3], c[4], c[5], lo, hi) ** 2 + _largest(c[6], c[7], c[8], lo, hi) ** 2))
    _, M = part_top(MOMENT_RESULTANT, coef, ends, i, part, False, _SPANS, 0.0, 1.0, 1.0, 0.0)
    _, least = part_least_tension(coef, ends, i, part, False)
    if base >= 0:
        least = min(least, part_least_tension(coef, ends, i, base, True)[1])
    return T, V, M, max(0.0, -least)


@kernel
def _worst(coef: Floats, ends: Floats, i: int, part: int, T: float, V: float, M: float, P: float, L: float, tube: Floats,
           n: int, stuff: Floats, k: int, n_yield: float, n_buckling: float, Cm: float, exact: bool) -> Any:  # fmt: skip
    """Utilisation of tube n by yield, buckling and beam-column. Not `exact`: a yield that surely holds may be a bound."""
    area, inertia, fibre, factor = tube[n, 0], tube[n, 1], tube[n, 2], tube[n, 3]
    E, strength, per = stuff[k, 0], stuff[k, 1], math.pi * math.pi / (L * L)
    euler = E * inertia * per
    critical = _critical(euler, area * strength)
    if stuff[k, 2] > 0.0:  # the base of the member buckles with it: the weaker counts
        base = stuff[k, 2] * per
        critical = min(critical, _critical(base, stuff[k, 4]) if stuff[k, 4] > 0.0 else base)
        euler = min(euler, stuff[k, 3] * per)
    load = n_buckling * P
    buckling, combined = load / critical, 0.0
    if P > 0.0:
        combined = math.inf
        if load < euler:
            combined = buckling + Cm * M * fibre / inertia / (1.0 - load / euler) * n_yield / strength
    bending = T / area + M * fibre / inertia
    stress = math.sqrt(bending * bending + 3.0 * (factor * V / area) ** 2) * n_yield / strength
    if exact or stress > 1.0:
        per = fibre / inertia
        _, top = part_top(ROUND, coef, ends, i, part, False, _SPANS, 1.0 / area, per, per, factor / area)
        stress = top * n_yield / strength
    return stress, buckling, combined


@kernel
def scan(coef: Floats, ends: Floats, length: Floats, part: Ints, base: Ints, member: Ints, group: Ints, stuff: Floats,
         tube: Floats, stop: Ints, safety: Floats, offset: int, pointer: Ints, seen: Ints) -> None:  # fmt: skip
    """Move the pointer of every group past the tubes that some member of it does not stand.

    coef, ends from `section_polynomials`; length (t, members). Sized parts k: part (k,), base (k,) part of the base rod or -1,
    member (k,), group (k,), stuff (k, 5): C E, S_y of the tube; C E I least and largest and A S_y of the base (0: none).
    tube (n, 4): A, I, c, shear factor, lightest first in each group; pointer (g,) into it, stop (g,) behind the group's last.
    safety: n_y, n_b, C_m. offset: of the samples. seen (n,): the sample at which a tube was turned down.
    """
    for i in range(coef.shape[0]):
        for k in range(part.shape[0]):
            g = group[k]
            if pointer[g] >= stop[g]:
                continue
            T, V, M, P = _demand(coef, ends, i, part[k], base[k])
            L = length[i, member[k]]
            while pointer[g] < stop[g]:
                stress, buckling, combined = _worst(
                    coef, ends, i, part[k], T, V, M, P, L, tube, pointer[g], stuff, k, safety[0], safety[1], safety[2], False
                )
                if stress <= 1.0 and buckling <= 1.0 and combined <= 1.0:
                    break
                seen[pointer[g]] = offset + i
                pointer[g] += 1


@kernel
def assess(coef: Floats, ends: Floats, length: Floats, part: Ints, base: Ints, member: Ints, group: Ints, stuff: Floats,
           tube: Floats, first: int, last: int, chosen: int, safety: Floats, most: Floats) -> None:  # fmt: skip
    """The highest utilisation of the tubes first:last over the members of group `chosen`, into most (n,); else as `scan`."""
    for i in range(coef.shape[0]):
        for k in range(part.shape[0]):
            if group[k] != chosen:
                continue
            T, V, M, P = _demand(coef, ends, i, part[k], base[k])
            for n in range(first, last):
                stress, buckling, combined = _worst(
                    coef, ends, i, part[k], T, V, M, P, length[i, member[k]], tube, n, stuff, k, safety[0], safety[1],
                    safety[2], True,
                )  # fmt: skip
                if combined == math.inf:  # beyond Euler's load: buckling tells how far
                    combined = 1.000001
                most[n] = max(most[n], stress, buckling, combined)
