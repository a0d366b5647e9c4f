"""Algebra of one step of DOP853 without any equations: coefficients, stages, error, dense output, size of the next step."""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2

# Coefficients of DOP853: explicit Runge-Kutta of order 8 with error estimates of orders 5 and 3 and dense output of order 7.
#
# Hairer, Norsett & Wanner (1993), Solving Ordinary Differential Equations I, 2nd ed., section II.5 and II.6, and their
# published code DOP853. The method has 12 stages; row 12 is the new state itself, rows 13 to 15 are the extra stages of the
# dense output. Only entries that are not zero are kept: those of row s are PTR[s]:PTR[s + 1], at the stages COL.
# nodes of the stages
C = np.array(
    [
        0.0,
        0.05260015195876773,
        0.0789002279381516,
        0.1183503419072274,
        0.2816496580927726,
        0.3333333333333333,
        0.25,
        0.3076923076923077,
        0.6512820512820513,
        0.6,
        0.8571428571428571,
        1.0,
        1.0,
        0.1,
        0.2,
        0.7777777777777778,
    ]
)

# weights of earlier stages in each stage
PTR = np.array(
    [
        0, 0, 1, 3, 5, 8, 11, 15, 20, 26, 33, 41, 50, 58, 66, 74, 82,
    ]
)  # fmt: skip
COL = np.array(
    [
        0, 0, 1, 0, 2, 0, 2, 3, 0, 3, 4, 0, 3, 4, 5, 0, 3, 4, 5, 6, 0, 3, 4, 5,
        6, 7, 0, 3, 4, 5, 6, 7, 8, 0, 3, 4, 5, 6, 7, 8, 9, 0, 3, 4, 5, 6, 7, 8,
        9, 10, 0, 5, 6, 7, 8, 9, 10, 11, 0, 6, 7, 8, 9, 10, 11, 12, 0, 5, 6, 7, 10, 11,
        12, 13, 0, 5, 6, 7, 8, 12, 13, 14,
    ]
)  # fmt: skip
VAL = np.array(
    [
        0.05260015195876773, 0.0197250569845379, 0.0591751709536137, 0.02958758547680685,
        0.08876275643042054, 0.2413651341592667, -0.8845494793282861, 0.924834003261792,
        0.037037037037037035, 0.17082860872947386, 0.12546768756682242, 0.037109375,
        0.17025221101954405, 0.06021653898045596, -0.017578125, 0.03709200011850479,
        0.17038392571223998, 0.10726203044637328, -0.015319437748624402, 0.008273789163814023,
        0.6241109587160757, -3.3608926294469414, -0.868219346841726, 27.59209969944671,
        20.154067550477894, -43.48988418106996, 0.47766253643826434, -2.4881146199716677,
        -0.590290826836843, 21.230051448181193, 15.279233632882423, -33.28821096898486,
        -0.020331201708508627, -0.9371424300859873, 5.186372428844064, 1.0914373489967295,
        -8.149787010746927, -18.52006565999696, 22.739487099350505, 2.4936055526796523,
        -3.0467644718982196, 2.273310147516538, -10.53449546673725, -2.0008720582248625,
        -17.9589318631188, 27.94888452941996, -2.8589982771350235, -8.87285693353063,
        12.360567175794303, 0.6433927460157636, 0.054293734116568765, 4.450312892752409,
        1.8915178993145003, -5.801203960010585, 0.3111643669578199, -0.1521609496625161,
        0.20136540080403034, 0.04471061572777259, 0.056167502283047954, 0.25350021021662483,
        -0.2462390374708025, -0.12419142326381637, 0.15329179827876568, 0.00820105229563469,
        0.007567897660545699, -0.008298, 0.03183464816350214, 0.028300909672366776,
        0.053541988307438566, -0.05492374857139099, -0.00010834732869724932, 0.0003825710908356584,
        -0.00034046500868740456, 0.1413124436746325, -0.42889630158379194, -4.697621415361164,
        7.683421196062599, 4.06898981839711, 0.3567271874552811, -0.0013990241651590145,
        2.9475147891527724, -9.15095847217987,
    ]
)  # fmt: skip

# weights of the error estimates of orders 5 and 3
E5 = np.array(
    [
        0.01312004499419488,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.2251564463762044,
        -0.4957589496572502,
        1.6643771824549864,
        -0.35032884874997366,
        0.3341791187130175,
        0.08192320648511571,
        -0.022355307863886294,
    ]
)
E3 = np.array(
    [
        -0.18980075407240762,
        0.0,
        0.0,
        0.0,
        0.0,
        4.450312892752409,
        1.8915178993145003,
        -5.801203960010585,
        -0.4226823213237919,
        -0.1521609496625161,
        0.20136540080403034,
        0.02265179219836082,
    ]
)

# weights of all 16 stages in the last four coefficients of the dense output
D = np.array(
    [
        [
            -8.428938276109013, 0.0, 0.0, 0.0,
            0.0, 0.5667149535193777, -3.0689499459498917, 2.38466765651207,
            2.117034582445028, -0.871391583777973, 2.2404374302607883, 0.6315787787694688,
            -0.08899033645133331, 18.148505520854727, -9.194632392478356, -4.436036387594894,
        ],
        [
            10.427508642579134, 0.0, 0.0, 0.0,
            0.0, 242.28349177525817, 165.20045171727028, -374.5467547226902,
            -22.113666853125306, 7.733432668472264, -30.674084731089398, -9.332130526430229,
            15.697238121770845, -31.139403219565178, -9.35292435884448, 35.81684148639408,
        ],
        [
            19.985053242002433, 0.0, 0.0, 0.0,
            0.0, -387.0373087493518, -189.17813819516758, 527.8081592054236,
            -11.57390253995963, 6.8812326946963, -1.0006050966910838, 0.7777137798053443,
            -2.778205752353508, -60.19669523126412, 84.32040550667716, 11.99229113618279,
        ],
        [
            -25.69393346270375, 0.0, 0.0, 0.0,
            0.0, -154.18974869023643, -231.5293791760455, 357.6391179106141,
            93.40532418362432, -37.45832313645163, 104.0996495089623, 29.8402934266605,
            -43.53345659001114, 96.32455395918828, -39.17726167561544, -149.72683625798564,
        ],
    ]
)  # fmt: skip


# Hairer, Norsett & Wanner (1993), Solving Ordinary Differential Equations I, 2nd ed., sections II.4 to II.6.

SAFETY, SHRINK, GROW = 0.9, 0.333, 6.0
MEMORY = 0.03
"""Exponent of the last error in the step control (a PI controller, II.4 eq. 4.44): less see-saw, a little smaller steps."""


@kernel_bare
def stage_state(y: F1, K: F2, s: int, h: float, out: F1) -> None:
    """State of stage s: out = y + h sum_j a_sj K[j]. The increment is summed before it is added: one rounding of y."""
    first, last, whole = PTR[s], PTR[s + 1], y.size - y.size % 4
    # four components side by side
    for i in range(0, whole, 4):
        p, q, r, t = 0.0, 0.0, 0.0, 0.0
        for e in range(first, last):
            w, j = VAL[e], COL[e]
            p += w * K[j, i]
            q += w * K[j, i + 1]
            r += w * K[j, i + 2]
            t += w * K[j, i + 3]
        out[i] = y[i] + h * p
        out[i + 1] = y[i + 1] + h * q
        out[i + 2] = y[i + 2] + h * r
        out[i + 3] = y[i + 3] + h * t
    # and the last ones
    for i in range(whole, y.size):
        p = 0.0
        for e in range(first, last):
            p += VAL[e] * K[COL[e], i]
        out[i] = y[i] + h * p


@kernel_bare
def error_norm(K: F2, h: float, scale: F1) -> float:
    """|h| e5^2/sqrt(e5^2 + 0.01 e3^2), e5 and e3 the mean-square error estimates of orders 5 and 3 in units of `scale`."""
    e5, e3 = 0.0, 0.0
    # estimates of orders 5 and 3, K[1:5] have zero weights
    for i in range(scale.size):
        five, three = E5[0] * K[0, i], E3[0] * K[0, i]
        for j in range(5, 12):
            five += E5[j] * K[j, i]
            three += E3[j] * K[j, i]
        inverse = 1.0 / scale[i]
        e5 += (five * inverse) ** 2
        e3 += (three * inverse) ** 2
    if e5 == 0.0:
        return 0.0
    return abs(h) * e5 / math.sqrt(scale.size * (e5 + 0.01 * e3))


@kernel_inline
def next_step(h: float, error: float, error_old: float, rejected_before: bool) -> float:
    """Size of the step after one with this error, accepted (error <= 1) or not."""
    if error > 1.0:
        return h * max(SHRINK, SAFETY * error ** (-1.0 / 8.0))
    factor = SAFETY * max(error, 1e-14) ** (-(1.0 / 8.0 - 0.2 * MEMORY)) * error_old**MEMORY
    factor = min(GROW, max(SHRINK, factor))
    return h * min(factor, 1.0) if rejected_before else h * factor


@kernel_bare
def dense_coefficients(y: F1, new: F1, K: F2, h: float, F: F2) -> None:
    """Coefficients F (8, ny) of the interpolant of order 7 between the states y and new; K with all 16 stages."""
    # cubic Hermite part: value, difference, slopes at both ends
    for i in range(y.size):
        d = new[i] - y[i]
        F[0, i] = y[i]
        F[1, i] = d
        F[2, i] = h * K[0, i] - d
        F[3, i] = 2.0 * d - h * (K[12, i] + K[0, i])
    # corrections of higher order from all 16 stages (II.6)
    for r in range(4):
        for i in range(y.size):
            F[4 + r, i] = 0.0
        for j in range(16):
            w = h * D[r, j]
            if w != 0.0:
                for i in range(y.size):
                    F[4 + r, i] += w * K[j, i]


@kernel_bare
def interpolate(F: F2, s: float, out: F1) -> None:
    """State at the fraction s of the step: F0 + s (F1 + (1-s)(F2 + s (F3 + (1-s)(F4 + s (F5 + (1-s)(F6 + s F7))))))."""
    r = 1.0 - s
    # nested form in s and 1 - s
    for i in range(out.size):
        high = F[4, i] + s * (F[5, i] + r * (F[6, i] + s * F[7, i]))
        out[i] = F[0, i] + s * (F[1, i] + r * (F[2, i] + s * (F[3, i] + r * high)))


@kernel_bare
def interpolate_rate(F: F2, s: float, h: float, out: F1) -> None:
    """Time derivative of the interpolant at the fraction s of a step of h (s)."""
    r = 1.0 - s
    # derivative of the nested form, from the inside out
    for i in range(out.size):
        value, slope = F[7, i], 0.0
        for k in range(6, -1, -1):
            # p <- F_k + (s or 1 - s) p, and its derivative
            if k % 2 == 0:
                slope = value + s * slope
                value = F[k, i] + s * value
            else:
                slope = r * slope - value
                value = F[k, i] + r * value
        out[i] = slope / h


@kernel_bare
def stiffness(K: F2, last: F1, new: F1, h: float, nf: int) -> float:
    """h |lambda|, the dominant eigenvalue estimated from two states at the end of the step (IV.2 eq. 2.7).

    last : state of stage 11, with rate K[11]; new : state of the step, with rate K[12]. The first nf numbers are positions,
    the next nf velocities: |lambda| is both |da|/|dv| and sqrt(|da|/|dx|) where a mode dominates, the less counts.
    """
    dx, dv, da = 0.0, 0.0, 0.0
    # squared norms of the differences of two states at the end of the step
    for i in range(nf):
        dx += (new[i] - last[i]) ** 2
        dv += (new[nf + i] - last[nf + i]) ** 2
        da += (K[12, nf + i] - K[11, nf + i]) ** 2
    if dv == 0.0:
        return 0.0
    rate = math.sqrt(da / dv)
    # positions that a stiff damper holds do not change by a digit
    return abs(h) * (min(rate, math.sqrt(math.sqrt(da / dx))) if dx > 0.0 else rate)
