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
from typing import Any, NamedTuple

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F0, F1, I1, Floats, Ints, Record, record
from kinetruss.kernels.sections.peaks import MOMENT_RESULTANT, ROUND, Measure, largest_parabola, part_least_tension, part_top
from kinetruss.kernels.sections.records import Polynomials

__all__ = ["Sized", "assess", "scan"]


_SPANS = 12  # sections scanned along a part, as the check does


@record
class Sized(Record):
    """Members that get a tube, the tubes of all groups, and the safety asked for.

    n_yield, n_buckling : safety factors; moment_factor : C_m. Members k: part (k,) the bar or tube among all parts, base (k,)
    the base rod, or -1; member (k,), group (k,); E (k,) end condition times modulus and strength (k,) yield strength of the
    tube, Pa; base_least, base_largest (k,) C E I of the base, N m^2, and base_squash (k,) its A S_y, N; 0: it does not count.
    start, stop (groups,) : tubes of a group, lightest first. Tubes n: area (n,) m^2, inertia (n,) m^4, fibre (n,) m, factor
    (n,) of shear.
    """

    n_yield: F0
    n_buckling: F0
    moment_factor: F0
    part: I1
    base: I1
    member: I1
    group: I1
    start: I1
    stop: I1
    E: F1
    strength: F1
    base_least: F1
    base_largest: F1
    base_squash: F1
    area: F1
    inertia: F1
    fibre: F1
    factor: F1


class Demand(NamedTuple):
    """Largest |T|, |V| N and |M| N m along a part, the largest compression P, N, along its member, and its length L, m."""

    T: float
    V: float
    M: float
    P: float
    L: float


@kernel_bare
def _critical(euler: float, squash: float) -> float:
    """Johnson's load of a stocky member, else Euler's."""
    return squash * (1.0 - 0.25 * squash / euler) if euler > 0.5 * squash else euler


@kernel_bare
def _demand(sized: Sized, k: int, given: Polynomials, length: Floats, i: int) -> Demand:
    """What sized member k has to carry at sample i."""
    coef, ends, _ = given
    T, V, part, base = 0.0, 0.0, sized.part[k], sized.base[k]
    # largest |T| and |V| over the segments of the part
    for j in range(coef.shape[2]):
        lo, hi = 0.0 if j == 0 else ends[i, part, j - 1], min(1.0, ends[i, part, j])
        if lo >= 1.0:
            break
        c = coef[i, part, j]
        T = max(T, largest_parabola(c[0], c[1], c[2], lo, hi))
        V = max(V, math.sqrt(largest_parabola(c[3], c[4], c[5], lo, hi) ** 2 + largest_parabola(c[6], c[7], c[8], lo, hi) ** 2))
    _, M = part_top(Measure(MOMENT_RESULTANT, 0.0, 1.0, 1.0, 0.0), given, i, part, False, _SPANS)
    _, least = part_least_tension(given, i, part, False)
    if base >= 0:
        least = min(least, part_least_tension(given, i, base, True)[1])
    return Demand(T, V, M, max(0.0, -least), length[i, sized.member[k]])


@kernel_bare
def _worst(sized: Sized, k: int, n: int, demand: Demand, given: Polynomials, i: int, exact: bool) -> Any:
    """Utilisation of tube n by yield, buckling and beam-column. Not `exact`: a yield that surely holds may be a bound."""
    T, V, M, P, L = demand
    area, inertia, fibre, factor = sized.area[n], sized.inertia[n], sized.fibre[n], sized.factor[n]
    strength, per = sized.strength[k], math.pi * math.pi / (L * L)
    euler = sized.E[k] * inertia * per
    critical = _critical(euler, area * strength)
    if sized.base_least[k] > 0.0:  # the base of the member buckles with it: the weaker counts
        base, squash = sized.base_least[k] * per, sized.base_squash[k]
        critical = min(critical, _critical(base, squash) if squash > 0.0 else base)
        euler = min(euler, sized.base_largest[k] * per)
    load = sized.n_buckling * P
    buckling, combined = load / critical, 0.0
    if P > 0.0:
        combined = math.inf
        if load < euler:
            bent = sized.moment_factor * M * fibre / inertia / (1.0 - load / euler)
            combined = buckling + bent * sized.n_yield / strength
    bending = T / area + M * fibre / inertia
    stress = math.sqrt(bending * bending + 3.0 * (factor * V / area) ** 2) * sized.n_yield / strength
    if exact or stress > 1.0:
        per = fibre / inertia
        measure = Measure(ROUND, 1.0 / area, per, per, factor / area)
        stress = part_top(measure, given, i, sized.part[k], False, _SPANS)[1] * sized.n_yield / strength
    return stress, buckling, combined


@kernel
def scan(sized: Sized, given: Polynomials, length: Floats, offset: int, pointer: Ints, seen: Ints) -> None:
    """Move the pointer of every group past the tubes that some member of it does not stand.

    length (t, members). offset: of the samples. pointer (groups,) into the tubes. seen (n,): the sample at which a tube was
    turned down.
    """
    part, group, stop = sized.part, sized.group, sized.stop
    # a tube that fails once is passed by all samples after
    for i in range(length.shape[0]):
        for k in range(part.shape[0]):
            g = group[k]
            if pointer[g] >= stop[g]:
                continue
            demand = _demand(sized, k, given, length, i)
            while pointer[g] < stop[g]:
                stress, buckling, combined = _worst(sized, k, pointer[g], demand, given, i, False)
                if stress <= 1.0 and buckling <= 1.0 and combined <= 1.0:
                    break
                seen[pointer[g]] = offset + i
                pointer[g] += 1


@kernel
def assess(sized: Sized, given: Polynomials, length: Floats, chosen: int, most: Floats) -> None:
    """The highest utilisation of the tubes of group `chosen` over its members, into most (n,); else as `scan`."""
    # highest utilisation of each tube over members and samples
    for i in range(length.shape[0]):
        for k in range(sized.part.shape[0]):
            if sized.group[k] != chosen:
                continue
            demand = _demand(sized, k, given, length, i)
            for n in range(sized.start[chosen], sized.stop[chosen]):
                stress, buckling, combined = _worst(sized, k, n, demand, given, i, True)
                if combined == math.inf:  # beyond Euler's load: buckling tells how far
                    combined = 1.000001
                most[n] = max(most[n], stress, buckling, combined)
