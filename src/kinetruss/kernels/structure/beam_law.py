"""Deformations of a beam between two frames, as an expression, and the code for kernels that is made from it.

With the chord l, of length l0 at the start, and axes x, y, z of the sections at both ends p and q, that are orthonormal, the
deformations depend on scalar products, each bilinear in the positions of nodes:

    E  = (l . l/l0^2 - 1)/2                             C  = (x_p . x_q + y_p . y_q + z_p . z_q - 1)/2
    a3 = -(y_p + y_q) . l/(2 l0)                        a2 = (z_p + z_q) . l/(2 l0)
    s3 = (y_p . x_q - x_p . y_q)/2   s2 = (x_p . z_q - z_p . x_q)/2   s1 = (z_p . y_q - y_p . z_q)/2

1. psi = s theta/sin(theta), C = cos(theta), is the rotation vector from p to q, with the same components in both frames.
2. -sigma/2 are the components of the direction of the chord along y and z of the frame half way between p and q, less
   what bending and twist alone make of it, psi_1 psi_2/24: 0 of a helix, S/2 the rotations of both ends from the chord that
   they have in common.
3. sigma is bending by a part b = 1/(1 + Phi), Phi = 12 E I/(G A_s l0^2), and shear by the rest (Timoshenko's beam under
   end forces): S = b sigma (1 - psi^2/60), and the section leans by t = (1 - b) sigma/2 against the axis.
4. D = psi + S x psi/2 + c (0, psi_3, -psi_2) is the mean curvature times l0: of the rotation psi eta/2 - 3 S (1 - eta^2)/4
   from the frame half way, -1 < eta < 1, Legendre's polynomials 1 and 2; and where bending is stiffer about one axis, twist
   that grows along a bent beam as its moment does (G J k_1' = (E I_2 - E I_3) k_2 k_3), half of which bending gives up.
5. An arc is longer than its chord by 1/mean(cos) = q = 1 + g + 7 g^2/10, g = D^2/24 + S^2/40, so that the elongation of the
   axis is e = q |l|/l0 cos(t) - 1 and the shear q |l|/l0 sin(t).

The energy is E A l0 e^2/2 + E I (D^2 + 3 b S'^2)/(2 l0) about each axis + G J D_1^2/(2 l0) with S' = S + 2 q |l|/l0 t: of
bending 3 S^2 and of shear G A_s are one square, which is b sigma^2 where both are in the ratio of step 3. In the limit of short
elements it is that of Simo and Reissner, with strains of any size (J. C. Simo, Computer Methods in Applied Mechanics and
Engineering 49 (1985) 55-70); without shear that of Kirchhoff's extensible rod.
"""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

from numba import types

from kinetruss.kernels.coordinates.programs import Program, root
from kinetruss.kernels.coordinates.straight_line import Lines, address_of

PLANE, SPACE = 4, 7
"""Numbers of scalar products: E, a3, s3, 1 - C (, a2, s1, s2)."""
_REALS: Any = types.CPointer(types.float64)  # type: ignore[no-untyped-call]
VALUE = types.void(_REALS, _REALS, _REALS)
"""z, data, out: the deformations e, D3, S3 (, D2, S2, D1) of scalar products z into out. data : l0, b3, and in space b2,
E I3/(G J), E I2/(G J).
"""
PULL = types.void(_REALS, _REALS, _REALS, _REALS)
"""z, data, force, out: the derivatives of the sum of deformations times force by z into out."""
RATES = types.void(_REALS, _REALS, _REALS, _REALS, _REALS)
"""z, data, force, v, out: into out the same, how fast they change at rates v of z (their Hessian times v), and the rates of
deformations, one behind the other.
"""
_INVERSE_SINE = (1.0, 1 / 3, 2 / 15, 2 / 35, 8 / 315, 8 / 693, 16 / 3003, 16 / 6435)
"""Coefficients of theta/sin(theta) in powers of 1 - cos(theta): c_k = c_(k-1) k/(2 k + 1)."""


def deformations(z: Any, ratios: Any) -> tuple[Any, ...]:
    """e, D3, S3, D2, S2, D1 of scalar products (E, a3, s3, 1 - C, a2, s1, s2), 0 where the plane has none; ratios : b3, b2,
    E I3/(G J), E I2/(G J).
    """
    E, a3, s3, less, a2, s1, s2 = z
    b3, b2, r3, r2 = ratios
    stretch = root(1.0 + 2.0 * E)
    over = _over_sine(less)
    p1, p2, p3 = s1 * over, s2 * over, s3 * over
    h3, h2 = a3 / stretch, a2 / stretch
    # from the mean of both axes to the frame half way, and less the chord of a helix: 1/4 + 1/12
    sigma3 = 2.0 * h3 * (1.0 + 0.125 * (p1 * p1 + p3 * p3)) + p2 * (p1 / 3.0 + 0.25 * p3 * h2)
    sigma2 = 2.0 * h2 * (1.0 + 0.125 * (p1 * p1 + p2 * p2)) + p3 * (0.25 * p2 * h3 - p1 / 3.0)
    S3, S2 = b3 * sigma3 * (1.0 - p3 * p3 / 60.0), b2 * sigma2 * (1.0 - p2 * p2 / 60.0)
    t3, t2 = 0.5 * (1.0 - b3) * sigma3, 0.5 * (1.0 - b2) * sigma2
    grown = (r3 - r2) * p2 * p3 / (24.0 + r2 * p3 * p3 + r3 * p2 * p2)
    D1, D2, D3 = p1 + 0.5 * (S2 * p3 - S3 * p2), p2 + 0.5 * S3 * p1 + grown * p3, p3 - 0.5 * S2 * p1 - grown * p2
    g = (D2 * D2 + D3 * D3) / 24.0 + (S2 * S2 + S3 * S3) / 40.0
    more = g + 0.7 * g * g
    long = stretch * (1.0 + more)
    # q |l|/l0 cos(t) - 1, small ones to all digits
    lean = t3 * t3 + t2 * t2
    e = 2.0 * E / (1.0 + stretch) + stretch * more - long * lean / (1.0 + root(1.0 - lean))
    return e, D3, S3 + 2.0 * long * t3, D2, S2 + 2.0 * long * t2, D1


def _over_sine(less: Any) -> Any:
    """theta/sin(theta) of 1 - cos(theta), by four halvings of the angle: below half a turn."""
    cosine = root(1.0 - 0.5 * less)
    product = cosine
    for _ in range(3):
        cosine = root(0.5 + 0.5 * cosine)
        product = product * cosine
    rest = 1.0 - cosine
    series: Any = 0.0
    for one in reversed(_INVERSE_SINE):
        series = one + rest * series
    return series / product


@cache
def addresses(dim: int) -> tuple[int, int, int]:
    """Addresses of the value, the derivatives and their rates in the plane or in space."""
    kinds = (("value", VALUE), ("pull", PULL), ("rates", RATES))
    value, pull, rates = (
        address_of(f"beam_{name}_{dim}", lambda own, name=name: _text(own, name, dim), one, sys.modules[__name__])  # type: ignore[misc]
        for name, one in kinds
    )
    return value, pull, rates


def _text(name: str, kind: str, dim: int) -> str:
    """Source of one of the three functions."""
    program, count = Program(), PLANE if dim == 2 else SPACE
    z = [program.coordinate(i) for i in range(count)]
    if dim == 2:
        one, zero = program.number(1.0), program.number(0.0)
        made = deformations([*z, zero, zero, zero], (program.parameter(), one, zero, zero))
    else:
        made = deformations(z, [program.parameter() for _ in range(4)])
    found = [one.index for one in made[: 3 if dim == 2 else 6]]
    lines = Lines(program.operations, 1 if kind == "rates" else 0, lambda a, k: f"{'zv'[k]}[{a}]", "data[{}]", first=1)
    lines.forward()
    if kind == "value":
        lines.text += [f"out[{k}] = {lines.of(j, 0)}" for k, j in enumerate(found)]
    else:
        lines.backward({j: f"force[{k}]" for k, j in enumerate(found)})
        orders = 2 if kind == "rates" else 1
        lines.text += [f"out[{count * k + i}] = {lines.gradient(i, k) or '0.0'}" for k in range(orders) for i in range(count)]
    if kind == "rates":
        lines.text += [f"out[{2 * count + k}] = {lines.of(j, 1)}" for k, j in enumerate(found)]
    given = {"value": "", "pull": "force, ", "rates": "force, v, "}[kind]
    return "\n    ".join([f"def {name}(z, data, {given}out):", *lines.text]) + "\n"
