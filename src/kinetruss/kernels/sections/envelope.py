"""The envelope of section forces and utilisations over many motions and load cases, kept while they pass.

Of every rod and every member, the worst value of each measure is kept with when, where and in which pair it is reached. A
measure is found exactly (`part_top`, `part_tension`) only where a bound on it exceeds what is kept:

    plain bars   T lies within m |e.u|/8 of its chord, |M| <= m L (|b_A + b_B|/16 + |b_B - b_A| 0.00802), from mass and motion
    any part     the extremes of the parabolas T, V2, V3 and of the cubics M2, M3 in closed form

Samples are taken in an order that jumps along the motion, so that a growing force does not set a record at every one of them.
Rules as in `strength.utilisation`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F0, F1, F2, I1, Floats, Record, record
from kinetruss.kernels.sections.peaks import (
    MOMENT_RESULTANT,
    MOMENT_SUM,
    ROUND,
    Measure,
    largest_parabola,
    part_tension,
    part_top,
)
from kinetruss.kernels.sections.records import Histories, Members, Polynomials
from kinetruss.kernels.sections.sections import member_polynomials

__all__ = ["BEAM_COLUMN", "BUCKLING", "COLUMNS", "YIELD", "Kept", "Rules", "envelope"]


YIELD, BUCKLING, BEAM_COLUMN = 3, 4, 5
"""Rules, as `Kept.top` tells them."""
COLUMNS = 7
"""Of what is kept: score (utilisation, or the value if there is no limit), value, limit, time, place m from end A, pair, 1 for
Johnson's load."""

_SPANS, _SLACK = 12, 1 + 1e-9


@record
class Rules(Record):
    """What sections and materials allow.

    n_buckling : safety factor; moment_factor : C_m. Parts p: shape (p,), scale (p, 4) as for `peaks`, strength (p,) yield
    strength over its factor, Pa, NaN: unknown; fibre (p, 2) c3/I2 and c2/I3; stiff (p, 2) pi^2 C E I2 and I3, N m^2; squash
    (p,) A S_y, N; span (p,) length m, NaN of bars. Members m: first (m,) of their parts, two (m,) 1 of active ones, cable (m,).
    own_part (p,), own_member (m,) : where they are kept.
    """

    n_buckling: F0
    moment_factor: F0
    shape: I1
    first: I1
    two: I1
    cable: I1
    own_part: I1
    own_member: I1
    scale: F2
    strength: F1
    fibre: F2
    stiff: F2
    squash: F1
    span: F1


class Kept(NamedTuple):
    """The envelope. tension, compression, bending, stress (parts, columns) and buckling, combined (members, columns), as
    `COLUMNS`; top (4,) : highest utilisation of the present pair, its part or member, its rule, its time.
    """

    tension: Floats
    compression: Floats
    bending: Floats
    stress: Floats
    buckling: Floats
    combined: Floats
    top: Floats


class _Bounds(NamedTuple):
    """Of one part: T at most and -T at most, |V| and |M| at most."""

    tension: float
    compression: float
    V: float
    M: float


@kernel_inline
def _component(y: Floats, i: int, n: int, c: int) -> float:
    return y[i, n, c] if c < y.shape[2] else 0.0


@kernel_bare
def _plain(members: Members, histories: Histories, ends: Floats, i: int, k: int) -> Any:
    """Length and bounds of a plain bar: its mass is evenly spread, and nothing else acts between its ends."""
    a, b, m = members.p[k], members.q[k], members.rods[k, 0]
    L, along, mid, mean, change = 0.0, 0.0, 0.0, 0.0, 0.0
    # length; b_A + b_B and b_B - b_A, whole and along the bar
    for c in range(3):
        d = _component(histories.position, i, b, c) - _component(histories.position, i, a, c)
        p, q = _component(histories.acceleration, i, a, c), _component(histories.acceleration, i, b, c)
        total = p + q - 2.0 * members.gravity[c]
        L, along, mid = L + d * d, along + d * (q - p), mid + d * total
        mean, change = mean + total * total, change + (q - p) * (q - p)
    # halves of what is left across it; rounding leaves at least none
    mean, change = 0.5 * math.sqrt(max(0.0, mean - mid * mid / L)), 0.5 * math.sqrt(max(0.0, change - along * along / L))
    L = math.sqrt(L)
    bulge = 0.125 * m * abs(along) / L
    tension = max(ends[i, k, 0], ends[i, k, 1]) + bulge
    compression = max(-ends[i, k, 0], -ends[i, k, 1]) + bulge
    # of a load q (2 xi - 1) on two supports: |M| <= q L^2/(36 sqrt 3), V <= q L/6
    return L, _Bounds(tension, compression, m * (0.5 * mean + change / 6.0), m * L * (0.125 * mean + 0.016038 * change))


@kernel_bare
def _length(members: Members, histories: Histories, i: int, k: int) -> float:
    L = 0.0
    for c in range(histories.position.shape[2]):
        d = histories.position[i, members.q[k], c] - histories.position[i, members.p[k], c]
        L += d * d
    return math.sqrt(L)


@kernel_inline
def _cubic(c: Any, n: int, lo: float, hi: float) -> float:
    """Largest |c_n + c_n+1 x + c_n+2 x^2 + c_n+3 x^3| over [lo, hi]."""
    c0, c1, c2, c3 = c[n], c[n + 1], c[n + 2], c[n + 3]
    best = max(abs(c0 + lo * (c1 + lo * (c2 + lo * c3))), abs(c0 + hi * (c1 + hi * (c2 + hi * c3))))
    # where its slope c1 + 2 c2 x + 3 c3 x^2 is zero
    root = c2 * c2 - 3.0 * c1 * c3
    if root < 0.0:
        return best
    r = -(c2 + math.copysign(math.sqrt(root), c2))
    for way in range(2):
        x = lo
        if way == 0 and c3 != 0.0:
            x = r / (3.0 * c3)
        elif way == 1 and r != 0.0:
            x = c1 / r
        if lo < x < hi:
            best = max(best, abs(c0 + x * (c1 + x * (c2 + x * c3))))
    return best


@kernel_bare
def _rod_bounds(given: Polynomials, part: int, overhang: bool) -> _Bounds:
    """Bounds from the polynomials of a part in row 0."""
    V, M = 0.0, 0.0
    _, tension = part_tension(given, 0, part, overhang, 1.0)
    _, compression = part_tension(given, 0, part, overhang, -1.0)
    if overhang:  # all of the rod counts for its stress
        _, other = part_tension(given, 0, part, False, 1.0)
        _, less = part_tension(given, 0, part, False, -1.0)
        tension, compression = max(tension, other), max(compression, less)
    for j in range(given.coef.shape[2]):
        lo, hi = 0.0 if j == 0 else max(0.0, given.ends[0, part, j - 1]), min(1.0, given.ends[0, part, j])
        if j > 0 and lo >= 1.0:
            break
        c = given.coef[0, part, j]
        V = max(V, math.hypot(largest_parabola(c[3], c[4], c[5], lo, hi), largest_parabola(c[6], c[7], c[8], lo, hi)))
        M = max(M, math.hypot(_cubic(c, 9, lo, hi), _cubic(c, 13, lo, hi)))
    return _Bounds(tension, compression, V, M)


@kernel_inline
def _critical(rules: Rules, part: int, L: float) -> Any:
    """Critical load of a part over the length of its member, Euler's loads about 2 and 3, and 1 where Johnson's counts."""
    e2, e3, squash = rules.stiff[part, 0] / (L * L), rules.stiff[part, 1] / (L * L), rules.squash[part]
    euler = min(e2, e3)
    if euler > 0.5 * squash:
        return squash * (1.0 - squash / (4.0 * euler)), e2, e3, 1.0
    return euler, e2, e3, 0.0


@kernel_bare
def _allowed(rules: Rules, k: int, L: float) -> Any:
    """The same of a member: of an active one the weaker of base and tube, each that is known."""
    first = rules.first[k]
    load, e2, e3, johnson = _critical(rules, first, L)
    if rules.two[k] != 0:
        other, f2, f3, formula = _critical(rules, first + 1, L)
        if not load <= other and other == other:
            load, johnson = other, formula
        e2 = f2 if not e2 <= f2 and f2 == f2 else e2
        e3 = f3 if not e3 <= f3 and f3 == f3 else e3
    return load, e2, e3, johnson


@kernel_inline
def _stress_bound(rules: Rules, part: int, at_most: _Bounds) -> float:
    """Bound on the von Mises stress of a part."""
    s = rules.scale
    bent = at_most.M * (max(s[part, 1], s[part, 2]) if rules.shape[part] == ROUND else s[part, 1] + s[part, 2])
    normal = max(at_most.tension, at_most.compression) * s[part, 0] + bent
    return math.sqrt(normal * normal + 6.0 * (at_most.V * s[part, 3]) ** 2)


@kernel_inline
def _keep(slot: Any, score: float, value: float, limit: float, time: float, place: float, pair: float, formula: float) -> None:
    if score > slot[0]:
        slot[0], slot[1], slot[2], slot[3], slot[4], slot[5], slot[6] = score, value, limit, time, place, pair, formula


@kernel_inline
def _raise_top(top: Floats, score: float, subject: int, rule: int, time: float) -> None:
    if score > top[0]:
        top[0], top[1], top[2], top[3] = score, subject, rule, time


@kernel_bare
def _amplified(P: float, euler: float, factor: float, safety: float) -> float:
    """C_m/(1 - n P/P_e); infinite from n P = P_e on, NaN where P_e is not known."""
    left = 1.0 - safety * P / euler
    return factor / left if left > 0.0 else (math.inf if left == left else math.nan)


@kernel_bare
def _moment_measure(rules: Rules, part: int, P: float, e2: float, e3: float) -> Any:
    """The bending share of the beam-column rule, as a measure; its kind is -1 where it is not known."""
    a2 = _amplified(P, e2, rules.moment_factor, rules.n_buckling)
    a3 = _amplified(P, e3, rules.moment_factor, rules.n_buckling)
    w2 = (a2 if a2 < math.inf else 0.0) * (rules.fibre[part, 0] / rules.strength[part])
    w3 = (a3 if a3 < math.inf else 0.0) * (rules.fibre[part, 1] / rules.strength[part])
    kind = MOMENT_RESULTANT if rules.shape[part] == ROUND else MOMENT_SUM
    if rules.shape[part] < 0 or rules.strength[part] != rules.strength[part]:
        kind = -1
    return Measure(kind, 0.0, w2, w3, 0.0)


@kernel_bare
def _rod_exceeds(rules: Rules, kept: Kept, part: int, at_most: _Bounds) -> bool:
    """True where a bound of a rod is above what is kept of it, or of this pair."""
    p = rules.own_part[part]
    if at_most.tension * _SLACK > kept.tension[p, 0] or at_most.compression * _SLACK > kept.compression[p, 0]:
        return True
    if kept.bending[p, 0] < at_most.M * _SLACK:
        return True
    if rules.shape[part] < 0:
        return False
    stress, strength = _stress_bound(rules, part, at_most) * _SLACK, rules.strength[part]
    if strength != strength:
        return stress > kept.stress[p, 0]
    return stress > min(kept.stress[p, 0], kept.top[0]) * strength


@kernel_bare
def _whole_exceeds(rules: Rules, kept: Kept, k: int, L: float, P: float, M: float) -> bool:
    """The same of the buckling of a member: P the largest compression, M the largest moment."""
    if rules.cable[k] != 0:
        return False
    m, top = rules.own_member[k], kept.top[0]
    P = max(0.0, P) * _SLACK
    load, e2, e3, _ = _allowed(rules, k, L)
    if load != load:
        return kept.buckling[m, 0] < P
    used = rules.n_buckling * P / load
    if used > min(kept.buckling[m, 0], top):
        return True
    least = min(kept.combined[m, 0], top)
    if least < 0.0 or least == math.inf or P <= 0.0:
        return least < 0.0
    most = 0.0
    for part in range(rules.first[k], rules.first[k] + 1 + rules.two[k]):
        measure = _moment_measure(rules, part, P, e2, e3)
        if measure.kind >= 0:
            most = max(most, (measure.M2 + measure.M3) * M * _SLACK)
    if not rules.n_buckling * P < min(e2, e3):
        return True
    return used + most > least


@kernel_bare
def _judge_rod(rules: Rules, kept: Kept, given: Polynomials, part: int, at_most: _Bounds, where: Any) -> None:
    """Measures of a part, each exactly where its bound is above what is kept. where : start, span m, time s, pair."""
    p, (start, span, time, pair) = rules.own_part[part], where
    if at_most.tension * _SLACK > kept.tension[p, 0]:
        x, T = part_tension(given, 0, part, False, 1.0)
        _keep(kept.tension[p], T, T, math.nan, time, start + x * span, pair, 0.0)
    if at_most.compression * _SLACK > kept.compression[p, 0]:
        x, C = part_tension(given, 0, part, False, -1.0)
        _keep(kept.compression[p], C, C, math.nan, time, start + x * span, pair, 0.0)
    if kept.bending[p, 0] < at_most.M * _SLACK:
        x, M = part_top(Measure(MOMENT_RESULTANT, 0.0, 1.0, 1.0, 0.0), given, 0, part, False, _SPANS)
        _keep(kept.bending[p], M, M, math.nan, time, start + x * span, pair, 0.0)
    if rules.shape[part] < 0:
        return
    strength, s = rules.strength[part], rules.scale
    scale, least = strength, min(kept.stress[p, 0], kept.top[0])
    if strength != strength:
        scale, least = 1.0, kept.stress[p, 0]
    if _stress_bound(rules, part, at_most) * _SLACK > least * scale:
        x, stress = part_top(
            Measure(rules.shape[part], s[part, 0], s[part, 1], s[part, 2], s[part, 3]), given, 0, part, False, _SPANS
        )
        _keep(kept.stress[p], stress / scale, stress, strength, time, start + x * span, pair, 0.0)
        if strength == strength:
            _raise_top(kept.top, stress / strength, p, YIELD, time)


@kernel_bare
def _judge_whole(rules: Rules, kept: Kept, given: Polynomials, k: int, L: float, time: float, pair: float) -> None:
    """Buckling and the beam-column rule of a member."""
    m, n, nan = rules.own_member[k], rules.n_buckling, math.nan
    load, e2, e3, johnson = _allowed(rules, k, L)
    worst, at, moment, bent_at = nan, 0.0, nan, 0.0
    # largest compression over the parts of the member; the overhang of a base carries nothing but itself
    for part in range(rules.first[k], rules.first[k] + 1 + rules.two[k]):
        over = rules.two[k] != 0 and part == rules.first[k]
        start, span = _placed(rules, k, part, L)
        x, C = part_tension(given, 0, part, over, -1.0)
        if not worst >= C and C == C:
            worst, at = C, start + x * span
    if worst != worst:
        return
    P = max(0.0, worst)
    used = n * P / load
    _keep(kept.buckling[m], used if used == used else P, P, load / n, time, at, pair, johnson)
    _raise_top(kept.top, used, m, BUCKLING, time)
    for part in range(rules.first[k], rules.first[k] + 1 + rules.two[k]):
        measure = _moment_measure(rules, part, P, e2, e3)
        if measure.kind < 0:
            continue
        over = rules.two[k] != 0 and part == rules.first[k]
        start, span = _placed(rules, k, part, L)
        x, M = part_top(measure, given, 0, part, over, _SPANS)
        if not moment >= M and M == M:
            moment, bent_at = M, start + x * span
    if moment != moment or load != load:
        return
    least = e2 if not e3 < e2 else e3
    if P > 0.0 and n * P >= least:
        # no finite interaction; the utilisation of buckling, at least 1, is the number of this sample
        _keep(kept.combined[m], math.inf, n * P, 1.0, time, bent_at, pair, least)
        return
    combined = P * n / load + moment if P > 0.0 else 0.0
    _keep(kept.combined[m], combined, combined, 1.0, time, bent_at, pair, 0.0)
    _raise_top(kept.top, combined, m, BEAM_COLUMN, time)


@kernel_inline
def _placed(rules: Rules, k: int, part: int, L: float) -> Any:
    """Distance of a part's end towards A from that end of its member, and its length."""
    if rules.two[k] == 0:
        return 0.0, L
    span = rules.span[part]
    return (0.0 if part == rules.first[k] else L - span), span


@kernel_bare
def _member(
    rules: Rules, members: Members, histories: Histories, ends: Floats, at: Any, scratch: Polynomials, kept: Kept
) -> None:
    """All measures of a member at a sample. at : sample, member, time, pair."""
    i, k, time, pair = at
    first = rules.first[k]
    plain = rules.two[k] == 0 and members.rods[k, 2] == 0.0 and members.acting[k] == members.acting[k + 1]
    if plain:
        L, at_most = _plain(members, histories, ends, i, k)
        alone = _rod_exceeds(rules, kept, first, at_most)
        if not alone and not _whole_exceeds(rules, kept, k, L, at_most.compression, at_most.M):
            return
    else:
        L = _length(members, histories, i, k)
    member_polynomials(members, histories, i, k, scratch, first)
    P, M = -math.inf, 0.0
    for part in range(first, first + 1 + rules.two[k]):
        at_most = _rod_bounds(scratch, part, rules.two[k] != 0 and part == first)
        P, M = max(P, at_most.compression), max(M, at_most.M)
        if _rod_exceeds(rules, kept, part, at_most):
            start, span = _placed(rules, k, part, L)
            _judge_rod(rules, kept, scratch, part, at_most, (start, span, time, pair))
    if _whole_exceeds(rules, kept, k, L, P, M):
        _judge_whole(rules, kept, scratch, k, L, time, pair)


@kernel
def envelope(
    rules: Rules, members: Members, histories: Histories, ends: Floats, times: F1, scratch: Polynomials, kept: Kept, pair: float
) -> None:
    """Take the samples of one pair into what is kept. ends (t, m, 2): axial tension at A and B, N. scratch : for one sample."""
    count = times.size
    # a step near the golden section of the samples, without a common divisor: every sample once, spread over the motion
    step = max(1, int(0.381966 * count))
    while _divisor(step, count) > 1:
        step += 1
    i = 0
    for _ in range(count):
        for k in range(rules.first.size):
            _member(rules, members, histories, ends, (i, k, times[i], pair), scratch, kept)
        i = (i + step) % count


@kernel_inline
def _divisor(a: int, b: int) -> int:
    """Greatest common divisor."""
    while b:
        a, b = b, a % b
    return a
