"""Beams as elements whose energy is quadratic in squared distances: deformation modes, stiffness, mass.

An end of a beam has an origin and a frame of nodes, so that its local axes x, y, z (1, 2, 3 of the section) are constant
combinations of differences of nodes. With the chord l = x_Q - x_P of length l0 at the start, p and q the ends, the modes are

    axial     e = 1.2 (|l|^2/l0^2 - 1)/2 - ((x_p + x_q) . l/l0 - 2)/10 - (x_p . x_q - 1)/30
    bending   D = 2 (f_q - f_p) - s,  S = f_p + f_q    about 3 with f = -y . l/l0, s = (y_p . x_q - x_p . y_q)/2,
                                                           about 2 with f = z . l/l0, s = (x_p . z_q - z_p . x_q)/2
    torsion   t = (z_p . y_q - y_p . z_q)/2

and the energy is E A l0 e^2/2 + E I (D^2 + 3 S^2)/(2 l0) about each axis + G J t^2/(2 l0). f is the rotation of a section
from the chord, e the elongation of the axis, with the mean square slope of its deflection, (2 f_p^2 - f_p f_q + 2 f_q^2)/30,
and D the difference of both rotations: theta - theta^5/360 of a beam bent to an arc of the angle theta, whose chord is
shorter than the arc, so that |f| = (1 - cos theta)/theta and s = sin theta. Axial strains are taken as small: f grows with
the chord, which changes moments by about three times the square of the bending strain. The modes are Meijaard's (Nonlinear
Dynamics 9 (1996) 21-36) to second order, with E I/l0 (4 2; 2 4) on (f_p, f_q) in diagonal form. Every mode is linear in dot
products of differences of nodes, so in squared distances: a . b = -1/2 sum a_i b_k c_ik for coefficients with the sum 0. A
beam is an element like a solid (elements.continua_arrays), of all pairs of its 6 (plane) or 8 (space) nodes.

Mass: the axis has the field r = H1 x_P + H2 l0 x_p + H3 x_Q + H4 l0 x_q with Hermite's polynomials, and a section turns with
axes y, z that change linearly from p to q: kinetic energy rho A |r'|^2/2 + rho I3 |y'|^2/2 + rho I2 |z'|^2/2 along the beam,
with constant masses between nodes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.model import WholeModel
from kinetruss.model.beam_frames import axes_of_beam, frame_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Material


MODES = {2: ("axial", "D3", "S3"), 3: ("axial", "D3", "S3", "D2", "S2", "torsion")}
"""Deformation modes in the plane and in space, in the order of the columns of `BeamElements.rigidity`."""

Floats = Any


@dataclass(frozen=True, kw_only=True, eq=False)
class BeamElements:
    """The elastic beams of a model.

    names; nodes (k, v) indices: origin and axes of the first frame, then of the second; length (k,) m, without stress;
    axes (k, dim, v) coefficients of the nodes that give the local axes at the first end (rows 1, 2 (, 3)), and ends (k, dim,
    v) at the second; modes (k, s, w) of the pairs (0, 1), (0, 2), ... of nodes, 1/m^2; rigidity (k, s): E A l0, E I3/l0,
    3 E I3/l0, .., N m; line (k,) kg/m; rotary (k, 2): rho I3, rho I2, kg m; damping (k,) s.
    """

    names: tuple[str, ...]
    nodes: NDArray[np.int64]
    length: NDArray[np.float64]
    axes: NDArray[np.float64]
    ends: NDArray[np.float64]
    modes: NDArray[np.float64]
    rigidity: NDArray[np.float64]
    line: NDArray[np.float64]
    rotary: NDArray[np.float64]
    damping: NDArray[np.float64]

    def stiffness(self) -> NDArray[np.float64]:
        """2 G (k, w, w) by pairs of nodes: the energy is (c - c0)^T G (c - c0)/2 for squared distances c."""
        return np.asarray(2 * np.einsum("ks,ksi,ksj->kij", self.rigidity, self.modes, self.modes))

    def mass(self) -> NDArray[np.float64]:
        """Masses (k, v, v) between nodes, kg."""
        xi, weight = _gauss()
        r = self.fields(xi)
        found = np.einsum("g,k,kgv,kgw->kvw", weight, self.line * self.length, r, r)
        for c, inertia in enumerate(self.rotary.T[: self.axes.shape[1] - 1], start=1):
            turned = (1 - xi)[None, :, None] * self.axes[:, None, c] + xi[None, :, None] * self.ends[:, None, c]
            found += np.einsum("g,k,kgv,kgw->kvw", weight, inertia * self.length, turned, turned)
        return np.asarray(found)

    def shares(self, beam: int, begin: float, end: float, first: float, last: float) -> NDArray[np.float64]:
        """What each node of a beam takes of a load q along it (v,), m: l int q(xi) fields(xi) dxi, q linear from first to last
        between the shares begin and end.
        """
        xi, weight = _gauss()
        own = self.fields(begin + (end - begin) * xi)[beam]
        return np.asarray(self.length[beam] * (end - begin) * (weight * (first + (last - first) * xi)) @ own)

    def fields(self, xi: NDArray[np.float64]) -> NDArray[np.float64]:
        """Coefficients (k, g, v) of the nodes that give the axis of the beam at the shares xi (g,) of its length."""
        h1, h2, h3, h4 = hermite(xi)
        v = self.nodes.shape[1]
        first, second = np.eye(v)[0], np.eye(v)[v // 2]
        l = self.length[:, None, None]
        straight = h1[:, None] * first + h3[:, None] * second
        return np.asarray(
            straight + l * (h2[None, :, None] * self.axes[:, None, 0] + h4[None, :, None] * self.ends[:, None, 0])
        )


def hermite(xi: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Hermite's cubic polynomials on 0..1: value and slope at 0, value and slope at 1."""
    return (1 + 2 * xi) * (1 - xi) ** 2, xi * (1 - xi) ** 2, xi**2 * (3 - 2 * xi), xi**2 * (xi - 1)


def hermite_slopes(xi: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """The derivatives of `hermite` by xi."""
    return 6 * xi * (xi - 1), (1 - xi) * (1 - 3 * xi), 6 * xi * (1 - xi), xi * (3 * xi - 2)


def beam_elements(model: WholeModel, index: dict[str, int], x0: NDArray[np.float64]) -> BeamElements | None:
    """The elastic beams of a model at positions x0 (n, 3), or None if it has none."""
    elastic = {name: beam for name, beam in model.beams.items() if beam.kind == "elastic"}
    if not elastic:
        return None
    dim, v = model.dim, 2 * (model.dim + 1)
    every = model.inner.frames
    count = len(elastic)
    nodes, length = np.zeros((count, v), np.int64), np.zeros(count)
    axes, ends = np.zeros((count, dim, v)), np.zeros((count, dim, v))
    rigidity, line, rotary = np.zeros((count, len(MODES[dim]))), np.zeros(count), np.zeros((count, 2))
    for k, (name, beam) in enumerate(elastic.items()):
        local = axes_of_beam(model, beam)
        own = [[index[node] for node in every[frame_of(name, beam, end)].all] for end in beam.ends]
        nodes[k] = own[0] + own[1]
        l = length[k] = float(np.linalg.norm(x0[own[1][0]] - x0[own[0][0]]))
        for part, first, found in ((own[0], 0, axes), (own[1], dim + 1, ends)):
            size = np.linalg.norm(x0[part[1:]] - x0[part[0]], axis=1)
            found[k, :, first + 1 : first + dim + 1] = local / size
            found[k, :, first] = -(local / size).sum(axis=1)
        rigidity[k], line[k], rotary[k] = _matter(model, beam, l)
    return BeamElements(
        names=tuple(elastic),
        nodes=nodes,
        length=length,
        axes=axes,
        ends=ends,
        modes=_modes(length, axes, ends),
        rigidity=rigidity,
        line=line,
        rotary=rotary,
        damping=np.array([beam.damping for beam in elastic.values()]),
    )


def _matter(model: WholeModel, beam: Any, l: float) -> tuple[Floats, float, Floats]:
    """Rigidities of the modes, N m, mass a length, kg/m, and rotary inertias a length, kg m."""
    section, material = model.section_of(beam), cast("Material", model.material_of(beam))
    E, A, (I2, I3) = material.E, section.area, section.second_moments
    bending = [E * I3 / l, 3 * E * I3 / l]
    if model.dim == 3:
        G = E / (2 * (1 + material.poisson))
        bending += [E * I2 / l, 3 * E * I2 / l, G * section.torsion_constant / l]
    line = material.density * A if beam.mass is None else beam.mass / l
    return np.array([E * A * l, *bending]), line, np.array([line * I3 / A, line * I2 / A])


def _modes(l: NDArray[np.float64], p: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Modes (k, s, w) by pairs of nodes; p, q (k, dim, v) coefficients of the axes at both ends."""
    v = p.shape[2]
    chord = (np.eye(v)[v // 2] - np.eye(v)[0]) / l[:, None]
    axial = 0.6 * _dot(chord, chord) - 0.1 * _dot(p[:, 0] + q[:, 0], chord) - _dot(p[:, 0], q[:, 0]) / 30

    def bent(across: int, sign: float) -> list[NDArray[np.float64]]:
        # rotations from the chord, and the sine of their difference
        f_p, f_q = -sign * _dot(p[:, across], chord), -sign * _dot(q[:, across], chord)
        s = 0.5 * sign * (_dot(p[:, across], q[:, 0]) - _dot(p[:, 0], q[:, across]))
        return [2 * (f_q - f_p) - s, f_p + f_q]

    rows = [axial, *bent(1, 1.0)]
    if p.shape[1] == 3:
        rows += [*bent(2, -1.0), 0.5 * (_dot(p[:, 2], q[:, 1]) - _dot(p[:, 1], q[:, 2]))]
    return np.stack(rows, axis=1)


def _dot(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients (k, w) of the squared distances of pairs of nodes in the dot product of two combinations of nodes."""
    a, b = np.broadcast_arrays(a, b)
    i, j = np.triu_indices(a.shape[1], 1)
    return np.asarray(-0.5 * (a[:, i] * b[:, j] + a[:, j] * b[:, i]))


def _gauss() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Four points and weights on 0..1: exact for the square of a cubic."""
    x, w = np.polynomial.legendre.leggauss(4)
    return 0.5 * (1 + x), 0.5 * w


# Deformation modes of beams as quadratic forms of positions: gradients, geometric stiffness, damping.
#
# A mode is m_s = sum m_sw c_w over the pairs w of nodes, with c_w = |d_w|^2. Its gradient B_s is linear in positions and its
# second derivative H_s constant, so that H_s v = B_s(v). Mode forces S give the nodes the forces -sum S_s B_s; with damping
# S_s = R_s (m_s + b m_s') and m_s' = B_s . v (Kelvin and Voigt).


def pairs_of(found: BeamElements) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Nodes (k, w) of the pairs of every beam."""
    i, j = np.triu_indices(found.nodes.shape[1], 1)
    return found.nodes[:, i], found.nodes[:, j]


def mode_rates(found: BeamElements, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rates of the modes (times, k, s), 1/s, at x, v (times, n, 3)."""
    p, q = pairs_of(found)
    return np.asarray(np.einsum("ksw,tkw->tks", found.modes, 2 * np.sum((x[:, q] - x[:, p]) * (v[:, q] - v[:, p]), axis=-1)))


def mode_stiffness(found: BeamElements, forces: NDArray[np.float64], count: int) -> csr_array:
    """sum S_s H_s of mode forces (k, s), (3 count, 3 count), N/m: the forces on the nodes are minus this times x."""
    p, q = (nodes.reshape(-1) for nodes in pairs_of(found))
    density = 2 * np.einsum("ks,ksw->kw", forces, found.modes).reshape(-1)
    rows, columns = np.concatenate([p, q, p, q]), np.concatenate([p, q, q, p])
    values = np.concatenate([density, density, -density, -density])
    at = (3 * rows[:, None] + np.arange(3)).reshape(-1), (3 * columns[:, None] + np.arange(3)).reshape(-1)
    return csr_array(coo_array((np.repeat(values, 3), at), shape=(3 * count, 3 * count)))


def damping_forces(found: BeamElements, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces -sum b R_s m_s' B_s of the damping on the nodes (times, n, 3), N, at x, v (times, n, 3)."""
    out = np.zeros_like(x)
    damped = found.damping[:, None] * found.rigidity * mode_rates(found, x, v)
    for i, one in enumerate(damped):
        out[i] = -(mode_stiffness(found, one, x.shape[1]) @ x[i].reshape(-1)).reshape(-1, 3)
    return out


def damping_tangents(found: BeamElements, x: NDArray[np.float64], v: NDArray[np.float64] | None) -> tuple[Any, Any]:
    """Minus the derivatives of `damping_forces` by x and by v, (3 n, 3 n), at x, v (n, 3).

    By v: sum b R B B^T; by x: sum b R (m' H + B(x) B(v)^T), 0 at rest.
    """
    size = x.size
    share = found.damping[:, None] * found.rigidity
    here = mode_gradients(found, x)
    weight = share.reshape(-1)[:, None]
    C = here.T @ (here * weight)
    if v is None or not np.any(v):
        return csr_array((size, size)), C
    rates = mode_rates(found, x[None], v[None])[0]
    return mode_stiffness(found, share * rates, len(x)) + here.T @ (mode_gradients(found, v) * weight), C


def mode_gradients(found: BeamElements, x: NDArray[np.float64]) -> csr_array:
    """B (beams x modes, 3 n) at positions x (n, 3)."""
    p, q = pairs_of(found)
    k, s = found.modes.shape[:2]
    part = 2 * found.modes[..., None] * (x[q] - x[p])[:, None]
    row = np.broadcast_to(np.arange(k * s).reshape(k, s, 1, 1), part.shape)
    rows, columns = [], []
    for nodes in (p, q):
        rows.append(row.reshape(-1))
        columns.append(np.broadcast_to((3 * nodes[:, :, None] + np.arange(3))[:, None], part.shape).reshape(-1))
    values = np.concatenate([-part.reshape(-1), part.reshape(-1)])
    at = np.concatenate(rows), np.concatenate(columns)
    return csr_array(coo_array((values, at), shape=(k * s, x.size)))
