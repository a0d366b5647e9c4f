"""Forces and moments at the ends and along beams, in closed form from the deformation modes and the load along the beam.

With the stresses s = rigidity x mode of each mode, in the axes of the deformed beam (1 along the chord):

    N = s_e/l;   M_3 = s_D - s_S at the first end, s_D + s_S at the second;   M_2 the same;   M_1 = s_t

The load along the beam, q = line (g - r''), is carried to the nodes by Hermite's polynomials, as its mass is; what the nodes
exert on the beam is the force of the modes less that, and sections between follow from equilibrium: they are those of the
deformed beam plus those of a beam clamped at both ends under q. Rotary inertia is a couple along the beam, linear in s. All
are exerted by the part behind the section on the part before it, as those of bars: N > 0 is tension, dM_3/ds = -V_2, dM_2/ds
= V_3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics.beams.elements import MODES, BeamElements, hermite
from kinetruss.mechanics.beams.modes import mode_rates

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["beam_forces", "section_forces"]

Floats = Any
POINTS = 0.5 - 0.5 * np.cos(np.pi * (np.arange(4) + 0.5) / 4)
"""Places at which a cubic is read."""


def beam_forces(
    found: BeamElements, x: NDArray[np.float64], x0: NDArray[np.float64], linear: bool = False
) -> dict[str, NDArray[np.float64]]:
    """Stress of each mode (times, k), N m, at positions x (times, n, 3). linear : to first order in x - x0."""
    i, j = np.triu_indices(found.nodes.shape[1], 1)
    p, q = found.nodes[:, i], found.nodes[:, j]
    d0 = x0[q] - x0[p]
    u = (x - x0)[:, q] - (x - x0)[:, p]
    # change of the squared distances
    change = 2 * np.einsum("kwc,tkwc->tkw", d0, u)
    if not linear:
        change = change + np.einsum("tkwc,tkwc->tkw", u, u)
    stress = np.einsum("ks,ksw,tkw->tks", found.rigidity, found.modes, change)
    return {name: stress[..., s] for s, name in enumerate(MODES[found.axes.shape[1]])}


def section_forces(
    found: BeamElements,
    x: NDArray[np.float64],
    x0: NDArray[np.float64],
    load: Floats,
    xi: Floats,
    *,
    linear: bool = False,
    given: Floats = None,
    v: Floats = None,
) -> dict[str, NDArray[np.float64]]:
    """Section forces at the shares xi (s,) of beams, along x (times, n, 3); load (times, n, 3) m/s^2 is g - x''.

    given : (times, k, modes) forces of the modes of beams that keep their shape, N m, NaN of the others. v : velocities
    (times, n, 3), m/s, of which beams with damping have further forces.

    force (times, k, s, 3): N, V_2, V_3; moment (times, k, s, 3): M_1, M_2, M_3, N m, in the axes of the deformed beam; frame
    (times, k, 3, 3) these axes as rows; force_ends, moment_ends (times, k, 2, 3) those of the sections next to the ends.
    """
    stress = beam_forces(found, x, x0, linear)
    EI3, EI2 = found.rigidity[:, 1], found.rigidity[:, -3]
    # rotations from the chord, f_p and f_q
    none = np.zeros(stress["axial"].shape)
    slope = {}
    for axis, EI in ((2, EI2), (3, EI3)):
        D, S = (stress.get(f"{name}{axis}", none) / EI for name in "DS")
        slope[axis] = 0.5 * (S / 3 - D), 0.5 * (S / 3 + D)
    if v is not None and found.damping.any():
        lag = found.damping[:, None] * found.rigidity * mode_rates(found, x0[None] if linear else x, v)
        stress = {name: own + lag[..., s] for s, (name, own) in enumerate(stress.items())}
    bent = np.ones(stress["axial"].shape)
    if given is not None:
        stress = {name: np.where(np.isnan(given[..., s]), own, given[..., s]) for s, (name, own) in enumerate(stress.items())}
        bent = np.isnan(given[..., 0]).astype(float)
    l = found.length[:, None]
    frame = _frames(found, x0[None] if linear else x)
    frame = np.broadcast_to(frame, (len(x), *frame.shape[1:]))
    # load along the beam in its axes as a cubic: coefficients c_m of xi^m
    read = np.einsum("kgv,tkvc->tkgc", found.fields(POINTS), load[:, found.nodes]) * found.line[:, None, None]
    q = np.einsum("mg,tkgc,tkac->tkma", np.linalg.inv(np.vander(POINTS, 4, increasing=True)), read, frame)
    # carried to the nodes: int q H1 ds, int q l H2 ds
    nodal, couple, other = (_weighted(q, h) * l ** (1 if h == 0 else 2) for h in (0, 1, 3))
    D3, S3, D2, S2 = (stress.get(name, none) for name in ("D3", "S3", "D2", "S2"))
    # moments at both ends by the modes: of bending, and of the axial force on the slopes, which are f from the chord
    first, second = {}, {}
    for axis, D, S in ((1, D2, S2), (2, D3, S3)):
        f_p, f_q = slope[axis + 1]
        slopes = 0.0 if linear else bent * stress["axial"] / 30
        first[axis], second[axis] = S - D + slopes * (4 * f_p - f_q), S + D + slopes * (4 * f_q - f_p)
    turn_p, turn_q = _turning(found, load, frame)
    force_p = (
        np.stack([-stress["axial"] / l[:, 0], (first[2] + second[2]) / l[:, 0], -(first[1] + second[1]) / l[:, 0]], axis=-1)
        - nodal
    )
    moment_p = np.stack([-stress.get("torsion", none), first[1] + couple[..., 2], first[2] - couple[..., 1]], axis=-1)
    moment_p += l * (turn_p / 3 + turn_q / 6)
    s = l[:, :, None] * xi[None, :, None]
    once, twice = _integrals(q, xi)
    once, twice = once * l[:, :, None], twice * l[:, :, None] ** 2
    force = -force_p[:, :, None] - once
    arm, spread = s * force_p[:, :, None], twice
    grown = xi[:, None] ** 2 / 2
    spun = (xi[:, None] - grown) * turn_p[:, :, None] + grown * turn_q[:, :, None]
    moment = l[:, :, None] * spun - moment_p[:, :, None]
    # equilibrium of the part before the section
    moment[..., 2] += arm[..., 1] + spread[..., 1]
    moment[..., 1] -= arm[..., 2] + spread[..., 2]
    force_q = -force_p - _integrals(q, np.ones(1))[0][:, :, 0] * l
    moment_q = np.stack([stress.get("torsion", none), second[1] + other[..., 2], second[2] - other[..., 1]], axis=-1)
    moment_q += l * (turn_p / 6 + turn_q / 3)
    ends = {"force_ends": np.stack([-force_p, force_q], axis=2), "moment_ends": np.stack([-moment_p, moment_q], axis=2)}
    return {"force": force, "moment": moment, "frame": np.array(frame), **ends}


def _turning(found: BeamElements, load: Floats, frame: Floats) -> tuple[Floats, Floats]:
    """Couples a length, N, that turn the sections at both ends: rotary inertia times angular acceleration, (times, k, 3)."""
    ends = []
    for axes in (found.axes, found.ends):
        # second rates of the axes y, z of the section along those of the beam
        rates = -np.einsum("kcv,tkvi,tkai->tkca", axes, load[:, found.nodes], frame)
        I3, I2 = found.rotary.T
        y, z = rates[:, :, 1], rates[:, :, 2] if rates.shape[2] == 3 else np.zeros_like(rates[:, :, 1])
        ends.append(np.stack([I3 * y[..., 2] - I2 * z[..., 1], I2 * z[..., 0], -I3 * y[..., 0]], axis=-1))
    return ends[0], ends[1]


def _weighted(q: Floats, which: int) -> Floats:
    """int q H ds/l over 0..1 of cubics q (times, k, 4, 3); which : 0 H1, 1 H2, 3 H4."""
    xi, weight = np.polynomial.legendre.leggauss(4)
    xi, weight = 0.5 * (1 + xi), 0.5 * weight
    return np.einsum("g,gm,tkma->tka", weight * hermite(xi)[which], np.vander(xi, 4, increasing=True), q)


def _integrals(q: Floats, xi: Floats) -> tuple[Floats, Floats]:
    """int q and int (xi - t) q from 0 to the shares xi, (times, k, s, 3)."""
    m = np.arange(4)
    power = xi[:, None] ** (m + 1)
    once = np.einsum("sm,tkma->tksa", power / (m + 1), q)
    twice = np.einsum("sm,tkma->tksa", power * xi[:, None] / ((m + 1) * (m + 2)), q)
    return once, twice


def _frames(found: BeamElements, x: Floats) -> Floats:
    """Axes (times, k, 3, 3) of deformed beams: 1 along the chord, 2 nearest to those of both ends."""
    at, v = x[:, found.nodes], found.nodes.shape[1]
    one = at[:, :, v // 2] - at[:, :, 0]
    one = one / np.linalg.norm(one, axis=-1, keepdims=True)
    two = np.einsum("kv,tkvc->tkc", found.axes[:, 1] + found.ends[:, 1], at)
    two = two - one * np.sum(one * two, axis=-1, keepdims=True)
    two = two / np.linalg.norm(two, axis=-1, keepdims=True)
    return np.stack([one, two, np.cross(one, two)], axis=-2)
