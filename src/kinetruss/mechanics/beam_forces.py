"""Forces and moments at the ends and along beams, and their axes as curves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.beam_matrices import mode_forces, mode_gradients, mode_rates, mode_values
from kinetruss.elements.beams import MODES, BeamElements, hermite, hermite_slopes
from kinetruss.elements.caching import cached
from kinetruss.model.bracing import CHORD

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from kinetruss.elements.loads.load import OnBeam
    from kinetruss.mechanics.system import System


PIECES, FEW, MANY = 12, 4, 100
"""Straight pieces that show a beam, and those of each beam where there are more than `MANY`."""


@dataclass(frozen=True, kw_only=True, eq=False)
class BeamCurves:
    """The curves of k beams at g places each.

    member (k,) indices of their chords among the members; nodes (k, v) of both ends; along (k, g, v) coefficients of these
    nodes that give the axis, by Hermite's polynomials as in `BeamElements.along`; across (k, g, v) the same of local axis 2.
    """

    member: NDArray[np.int64]
    nodes: NDArray[np.int64]
    along: NDArray[np.float64]
    across: NDArray[np.float64]

    def at(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Points (.., k, g, dim), m, of nodes at x (.., n, dim)."""
        found: NDArray[np.float64] = np.einsum("kgv,...kvc->...kgc", self.along, x[..., self.nodes, :])
        return found


@cached()
def beam_curves(system: System) -> BeamCurves | None:
    """The curves of the elastic beams of a model; None if it has none."""
    beams = None if system.continua is None else system.continua.beams
    if beams is None:
        return None
    index = {name: k for k, name in enumerate(system.model.members)}
    xi = np.linspace(0.0, 1.0, (PIECES if len(beams.names) <= MANY else FEW) + 1)
    across = (1 - xi)[:, None] * beams.axes[:, None, 1] + xi[:, None] * beams.ends[:, None, 1]
    member = np.array([index[f"{name}{CHORD}"] for name in beams.names], np.int64)
    return BeamCurves(member=member, nodes=beams.nodes, along=beams.along(xi), across=across)


# Forces and moments at the ends and along beams, in closed form from the deformation modes and the load along the beam.
#
# With the stresses S = rigidity x mode of each mode, the nodes of an end exert on the beam the force sum S B of their
# gradients B and its moment about the end: the same forces that balance the nodes, so that every beam is in balance with its
# neighbours, its supports and its loads however far it turns. For small deformations these are N = S_e/l; M_3 = S_D - S_S at
# the first end, S_D + S_S at the second; M_2 the same; M_1 = S_t, in the axes of the deformed beam (1 along the chord).
#
# The load along the beam, q = line (g - r''), is carried to the nodes by Hermite's polynomials, as its mass is; what the
# nodes exert on the beam is the force of the modes less that, and sections between follow from equilibrium of the part before
# them, on the deflected axis w = l (H2 f_p + H4 f_q) from the chord and in the axes of the section, which turn with its
# slope. Rotary inertia is a couple along the beam, linear in s. All are exerted by the part behind the section on the part
# before it, as those of bars: N > 0 is tension, dM_3/ds = -V_2, dM_2/ds = V_3.

Floats = Any
POINTS = 0.5 - 0.5 * np.cos(np.pi * (np.arange(4) + 0.5) / 4)
"""Places at which a cubic is read."""


def beam_forces(
    found: BeamElements, x: NDArray[np.float64], x0: NDArray[np.float64], linear: bool = False
) -> dict[str, NDArray[np.float64]]:
    """Stress of each mode (times, k), N m, at positions x (times, n, 3). linear : to first order in x - x0."""
    if linear:
        moved = (x - x0).reshape(len(x), -1)
        values = (mode_gradients(found, x0) @ moved.T).T.reshape(len(x), *found.rigidity.shape)
    else:
        values = mode_values(found, x)
    stress = found.rigidity * values
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
    loads: Sequence[tuple[OnBeam, Floats, Floats]] = (),
) -> dict[str, NDArray[np.float64]]:
    """Section forces at the shares xi (s,) of beams, along x (times, n, 3); load (times, n, 3) m/s^2 is g - x''.

    given : (times, k, modes) forces of the modes of beams that keep their shape, N m, NaN of the others. v : velocities
    (times, n, 3), m/s, of which beams with damping have further forces. loads : those along beams and at places of them: with
    their history (times, 3), and the forces (times, v, 3), N, that they put on the nodes of the beam at these positions. Where
    a force or a couple acts at a place, the section there belongs to the side of the first end.

    force (times, k, s, 3): N, V_2, V_3; moment (times, k, s, 3): M_1, M_2, M_3, N m, in the axes of the deformed beam; frame
    (times, k, 3, 3) these axes as rows; force_ends, moment_ends (times, k, 2, 3) those of the sections next to the ends.
    """
    stress, slope = _deformed(found, x, x0, linear, given, v)
    l = found.length[:, None]
    frame = beam_frames(found, x0[None] if linear else x)
    frame = np.broadcast_to(frame, (len(x), *frame.shape[1:]))
    # load along the beam in its axes as a cubic: coefficients c_m of xi^m
    read = np.einsum("kgv,tkvc->tkgc", found.along(POINTS), load[:, found.nodes]) * found.line[:, None, None]
    q = np.einsum("mg,tkgc,tkac->tkma", np.linalg.inv(np.vander(POINTS, 4, increasing=True)), read, frame)
    place = x0[None] if linear else x
    ends = _by_nodes(found, stress, place, load, frame, loads)
    force_p, moment_p = ends[0][:, :, 0], ends[1][:, :, 0]
    # the chord of a bent beam is shorter than the beam
    at = place[:, found.nodes]
    chord = np.linalg.norm(at[:, :, at.shape[2] // 2] - at[:, :, 0], axis=-1)[:, :, None, None]
    every = np.append(xi, 1.0)[:, None]
    once, twice = _integrals(q, every[:, 0])
    turned = np.zeros_like(once)
    _add_loads(loads, l[:, 0], every[:, 0], frame, once, twice, turned)
    once, twice = once * l[:, :, None], twice * l[:, :, None] * chord
    force = -force_p[:, :, None] - once
    turn_p, turn_q = _turning(found, load, frame)
    grown = every**2 / 2
    moment = l[:, :, None] * ((every - grown) * turn_p[:, :, None] + grown * turn_q[:, :, None]) - moment_p[:, :, None] - turned
    # equilibrium of the part before the section
    arm = chord * every * force_p[:, :, None] + twice
    moment += np.stack([np.zeros_like(arm[..., 0]), -arm[..., 2], arm[..., 1]], axis=-1)
    # the second end is exact as well; what a load on a bent axis changes between them is spread evenly
    moment += every * (ends[1][:, :, 1, None] - moment[:, :, -1:])
    force, moment = force[:, :, :-1], moment[:, :, :-1]
    if not linear:
        force, moment = _on_the_curve(l, xi, slope, force_p, force, moment)
    signs = np.array([-1.0, 1.0])[:, None]
    return {
        "force": force,
        "moment": moment,
        "frame": np.array(frame),
        "force_ends": ends[0] * signs,
        "moment_ends": ends[1] * signs,
    }


def _deformed(found: BeamElements, x: Floats, x0: Floats, linear: bool, given: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Stress of each mode (times, k, s), N m, and by axis 2 and 3 the slopes (times, k) of both ends from the chord, and
    how far sections lean against the axis; 0 of beams that keep their shape, whose stresses are given.
    """
    stress = beam_forces(found, x, x0, linear)
    EI3, EI2 = found.rigidity[:, 1], found.rigidity[:, -3]
    # slopes from the chord, f_p and f_q, and the rest of the rotation of sections
    none = np.zeros(stress["axial"].shape)
    slope = {}
    for axis, EI, b in ((2, EI2, found.bending[:, 1]), (3, EI3, found.bending[:, 0])):
        D, S = (stress.get(f"{name}{axis}", none) / EI for name in "DS")
        slope[axis] = 0.5 * (S / 3 - D), 0.5 * (S / 3 + D), 0.5 * (1 / b - 1) * S / 3
    if v is not None and found.damping.any():
        lag = found.damping[:, None] * found.rigidity * mode_rates(found, x0[None] if linear else x, v)
        stress = {name: own + lag[..., s] for s, (name, own) in enumerate(stress.items())}
    bent = np.ones(stress["axial"].shape)
    if given is not None:
        stress = {name: np.where(np.isnan(given[..., s]), own, given[..., s]) for s, (name, own) in enumerate(stress.items())}
        bent = np.isnan(given[..., 0]).astype(float)
    turned = {axis: tuple(bent * one for one in own) for axis, own in slope.items()}
    return np.stack(list(stress.values()), axis=-1), turned


def _by_nodes(
    found: BeamElements, stress: Floats, x: Floats, load: Floats, frame: Floats, loads: Sequence[tuple[OnBeam, Floats, Floats]]
) -> tuple[Floats, Floats]:
    """Forces and moments of both ends on beams, (times, k, 2, 3), in their axes `frame`: forces sum S B of the stresses (times,
    k, modes) at positions x, less what mass times load, m/s^2, and loads on beams put on the same nodes.
    """
    v, at = found.nodes.shape[1], x[:, found.nodes]
    nodal = mode_forces(found, np.broadcast_to(x, (len(stress), *x.shape[1:])), stress)
    nodal -= np.einsum("kvw,tkwc->tkvc", found.mass(), load[:, found.nodes])
    for one, _, on_nodes in loads:
        nodal[:, one.beam] -= on_nodes
    forces, moments = [], []
    for first in (0, v // 2):
        own = slice(first, first + v // 2)
        forces.append(nodal[:, :, own].sum(axis=2))
        moments.append(np.cross(at[:, :, own] - at[:, :, first : first + 1], nodal[:, :, own]).sum(axis=2))
    one, two = (np.einsum("tkac,tkec->tkea", frame, np.stack(values, axis=2)) for values in (forces, moments))
    return one, two


def _on_the_curve(l: Floats, xi: Floats, slope: Floats, push: Floats, force: Floats, moment: Floats) -> tuple[Floats, Floats]:
    """Section forces of the chord, of the deflected axis in the axes of its sections; slope : those of the ends from the chord
    about 2 and 3, and the rest of the rotation of sections, (times, k) each; push (times, k, 3) : force on the first end.
    """
    _, h2, _, h4 = hermite(xi)
    _, g2, _, g4 = hermite_slopes(xi)
    (p2, q2, t2), (p3, q3, t3) = ([f[..., None] for f in slope[axis]] for axis in (2, 3))
    # w_2 rises with a rotation about 3, w_3 falls with one about 2
    w2, w3 = l * (h2 * p3 + h4 * q3), -l * (h2 * p2 + h4 * q2)
    at = np.stack([np.zeros_like(w2), w2, w3], axis=-1)
    turned = _turned(g2 * p3 + g4 * q3 + t3, -(g2 * p2 + g4 * q2 + t2))
    moment = moment + np.cross(at, np.broadcast_to(push[:, :, None], at.shape))
    along, about = (np.einsum("tksac,tksc->tksa", turned, one) for one in (force, moment))
    return along, about


def _turned(slope2: Floats, slope3: Floats) -> Floats:
    """Axes (.., 3, 3) as rows, of an axis with slopes along 2 and 3 to the chord: 1 along it, 2 nearest to that of the beam."""
    one = np.stack([np.ones_like(slope2), slope2, slope3], axis=-1)
    one = one / np.linalg.norm(one, axis=-1, keepdims=True)
    two = np.array([0.0, 1.0, 0.0]) - one * one[..., 1:2]
    two = two / np.linalg.norm(two, axis=-1, keepdims=True)
    return np.stack([one, two, np.cross(one, two)], axis=-2)


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


def _integrals(q: Floats, xi: Floats) -> tuple[Floats, Floats]:
    """int q and int (xi - t) q from 0 to the shares xi, (times, k, s, 3)."""
    m = np.arange(4)
    power = xi[:, None] ** (m + 1)
    once = np.einsum("sm,tkma->tksa", power / (m + 1), q)
    twice = np.einsum("sm,tkma->tksa", power * xi[:, None] / ((m + 1) * (m + 2)), q)
    return once, twice


def _add_loads(
    loads: Sequence[tuple[OnBeam, Floats, Floats]],
    length: Floats,
    xi: Floats,
    frame: Floats,
    once: Floats,
    twice: Floats,
    turned: Floats,
) -> None:
    """Add int q and int (xi - t) q of loads on beams of length (k,) from 0 to the shares xi, in the axes of the beams, and to
    `turned` the whole of couples up to there.
    """
    for one, history, _ in loads:
        q, behind = one.in_beam(history, frame[:, one.beam]), np.maximum(xi - one.end, 0.0)
        if one.shape is None:
            single, double, unit = (xi > one.end).astype(float), behind, 1.0 / length[one.beam]
        else:
            width, (first, last), unit = one.end - one.begin, one.shape, 1.0
            eta = np.clip((xi - one.begin) / width, 0.0, 1.0)
            # behind the end the whole acts at its centre
            single = width * eta * (first + (last - first) * eta / 2)
            double = width**2 * eta**2 * (first / 2 + (last - first) * eta / 6) + behind * single
        if one.couple:
            turned[:, one.beam] += unit * length[one.beam] * single[:, None] * q[:, None]
        else:
            once[:, one.beam] += unit * single[:, None] * q[:, None]
            twice[:, one.beam] += unit * double[:, None] * q[:, None]


def beam_frames(found: BeamElements, x: Floats) -> Floats:
    """Axes (times, k, 3, 3) of deformed beams: 1 along the chord, 2 nearest to those of both ends."""
    at, v = x[:, found.nodes], found.nodes.shape[1]
    one = at[:, :, v // 2] - at[:, :, 0]
    one = one / np.linalg.norm(one, axis=-1, keepdims=True)
    two = np.einsum("kv,tkvc->tkc", found.axes[:, 1] + found.ends[:, 1], at)
    two = two - one * np.sum(one * two, axis=-1, keepdims=True)
    two = two / np.linalg.norm(two, axis=-1, keepdims=True)
    return np.stack([one, two, np.cross(one, two)], axis=-2)


# Deflections between the nodes of beams: curvature, shear and strain from the section forces, integrated twice and once,
# between the displacements of both ends. The section forces are polynomials between the ends of loads, so Gauss' rule is exact;
# so are deflections of small displacements, as far as those of the nodes are.


def deflections(
    found: BeamElements,
    x: NDArray[np.float64],
    x0: NDArray[np.float64],
    load: Floats,
    xi: Floats,
    *,
    linear: bool = False,
    given: Floats = None,
    v: Floats = None,
    loads: Sequence[tuple[OnBeam, Floats, Floats]] = (),
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Displacements (times, k, s, 3), m, of the axes of beams at their shares xi (s,), global axes; and how far they are from
    the line of both ends, along the axes 2 and 3 of the deformed beam, (times, k, s, 2). Arguments as of `section_forces`.

    w'' = M/(E I) + (V/(G A_s))', u' = N/(E A) (Timoshenko). NaN of beams that keep their shape.
    """
    ends = np.clip([one for each, *_ in loads for one in (each.begin, each.end)], 0.0, 1.0)
    edges = np.unique(np.concatenate([[0.0, 1.0], np.asarray(xi, float), ends]))
    points, weights = np.polynomial.legendre.leggauss(4)
    width = np.diff(edges)
    at = (edges[:-1, None] + 0.5 * width[:, None] * (1.0 + points)).reshape(-1)
    sections = section_forces(found, x, x0, load, at, linear=linear, given=given, v=v, loads=loads)
    force, moment = sections["force"], sections["moment"]
    l = found.length[:, None]
    EA, EI3, EI2 = found.rigidity[:, [0]] / l, found.rigidity[:, [1]] * l, found.rigidity[:, [-3]] * l
    # b = 1/(1 + 12 E I/(G A_s l^2)), and 1 where a beam is not flexible in shear
    sheared3, sheared2 = ((1.0 / found.bending[:, [c]] - 1.0) * l**2 / 12.0 / EI for c, EI in ((0, EI3), (1, EI2)))
    strain = np.stack([force[..., 0] / EA, sheared3 * force[..., 1], sheared2 * force[..., 2]], axis=-1)
    # w_2 rises with a rotation about 3, w_3 falls with one about 2
    curved = np.stack([np.zeros_like(moment[..., 0]), moment[..., 2] / EI3, -moment[..., 1] / EI2], axis=-1)
    if x.shape[2] and found.axes.shape[1] == 2:
        strain[..., 2] = curved[..., 2] = 0.0
    step = (0.5 * width[:, None] * weights).reshape(-1)

    def to(values: Floats) -> Floats:
        """Integrals from 0 to the edges, (times, k, edges, 3)."""
        parts = (values * step[:, None]).reshape(*values.shape[:2], len(width), 4, 3).sum(axis=3)
        return np.concatenate([np.zeros_like(parts[:, :, :1]), np.cumsum(parts, axis=2)], axis=2)

    scale = l[:, :, None]
    once = scale * to(strain) + scale**2 * (edges[:, None] * to(curved) - to(curved * at[:, None]))
    once = once - edges[:, None] * once[:, :, -1:]
    own = once[:, :, np.searchsorted(edges, xi)]
    if given is not None:
        own = np.where(np.isnan(given[..., 0])[:, :, None, None], own, np.nan)
    P, Q = (found.nodes[:, n] for n in (0, found.nodes.shape[1] // 2))
    line = (1.0 - xi)[:, None] * (x - x0)[:, P][:, :, None] + xi[:, None] * (x - x0)[:, Q][:, :, None]
    return line + np.einsum("tksa,tkac->tksc", own, sections["frame"]), own[..., 1:]
