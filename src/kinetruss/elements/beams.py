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
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.elements.directions import axes_along, start_references
from kinetruss.elements.numbers import entries, one_copy, size
from kinetruss.model.beam_frames import axes_of_beam, frame_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.matter import Matter
    from kinetruss.elements.numbers import Array, Numbers
    from kinetruss.model import Beam, WholeModel


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

    def stiffness(self) -> Array:
        """2 G (k, w, w) by pairs of nodes: the energy is (c - c0)^T G (c - c0)/2 for squared distances c."""
        return np.asarray(2 * np.einsum("...ks,...ksi,...ksj->...kij", self.rigidity, self.modes, self.modes))

    def mass(self) -> Array:
        """Masses (k, v, v) between nodes, kg."""
        xi, weight = _gauss()
        r = self.fields(xi)
        found = np.einsum("g,...k,...kgv,...kgw->...kvw", weight, self.line * self.length, r, r)
        for c in range(1, self.axes.shape[-2]):
            first, second = self.axes[..., None, c, :], self.ends[..., None, c, :]
            turned = (1 - xi)[:, None] * first + xi[:, None] * second
            inertia = self.rotary[..., c - 1] * self.length
            found += np.einsum("g,...k,...kgv,...kgw->...kvw", weight, inertia, turned, turned)
        return np.asarray(found)

    def shares(self, beam: int, begin: Any, end: Any, first: Any, last: Any) -> Array:
        """What each node of a beam takes of a load q along it (v,), m: l int q(xi) fields(xi) dxi, q linear from first to last
        between the shares begin and end.
        """
        xi, weight = _gauss()
        begin, end, first, last = (np.asarray(one)[..., None] for one in (begin, end, first, last))
        own = self.fields(begin + (end - begin) * xi)[..., beam, :, :]
        load = self.length[..., beam, None] * (end - begin) * (weight * (first + (last - first) * xi))
        return np.asarray(load @ own if own.ndim == 2 else (load[..., None, :] @ own)[..., 0, :])

    def fields(self, xi: Array) -> Array:
        """Coefficients (k, g, v) of the nodes that give the axis of the beam at the shares xi (g,) of it."""
        h1, h2, h3, h4 = (one[..., None, :] for one in hermite(xi))
        v = self.nodes.shape[1]
        first, second = np.eye(v)[0], np.eye(v)[v // 2]
        l = self.length[..., None, None]
        straight = h1[..., None] * first + h3[..., None] * second
        slopes = h2[..., None] * self.axes[..., None, 0, :] + h4[..., None] * self.ends[..., None, 0, :]
        return np.asarray(straight + l * slopes)


def hermite(xi: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Hermite's cubic polynomials on 0..1: value and slope at 0, value and slope at 1."""
    return (1 + 2 * xi) * (1 - xi) ** 2, xi * (1 - xi) ** 2, xi**2 * (3 - 2 * xi), xi**2 * (xi - 1)


def hermite_slopes(xi: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """The derivatives of `hermite` by xi."""
    return 6 * xi * (xi - 1), (1 - xi) * (1 - 3 * xi), 6 * xi * (1 - xi), xi * (3 * xi - 2)


@dataclass(frozen=True, kw_only=True, eq=False)
class Beams:
    """The structure of the elastic beams of a model: names, records, nodes (k, v); toward (k,) nodes that orient them, -1 none;
    matter (k, 2) places of section and material; mass : of which it is given, and its place; damped (k,) those with damping.
    """

    dim: int
    names: tuple[str, ...]
    records: tuple[Beam, ...]
    nodes: NDArray[np.int64]
    toward: NDArray[np.int64]
    matter_of: Matter
    matter: NDArray[np.int64]
    mass: dict[int, int]
    damped: NDArray[np.int64]


def beams_of(model: WholeModel, index: dict[str, int], matter: Matter) -> tuple[Beams | None, dict[str, Any]]:
    """The elastic beams of a model, None if it has none; and their numbers."""
    elastic = {name: beam for name, beam in model.beams.items() if beam.kind == "elastic"}
    records, every = tuple(elastic.values()), model.inner.frames
    massive = [k for k, beam in enumerate(records) if beam.mass is not None]
    damped = [k for k, beam in enumerate(records) if beam.damping]
    numbers = {
        "beam_mass": np.array([records[k].mass for k in massive], float),
        "beam_damping": np.array([records[k].damping for k in damped], float),
    }
    if not elastic:
        return None, numbers
    ends = [[every[frame_of(name, beam, end)].all for end in beam.ends] for name, beam in elastic.items()]
    found = Beams(
        dim=model.dim,
        names=tuple(elastic),
        records=records,
        nodes=np.array([[index[node] for frame in own for node in frame] for own in ends], np.int64),
        toward=np.array([index[one.orientation] if isinstance(one.orientation, str) else -1 for one in records], np.int64),
        matter_of=matter,
        matter=np.array([matter.of(beam) for beam in records], np.int64),
        mass={k: place for place, k in enumerate(massive)},
        damped=np.array(damped, np.int64),
    )
    return found, numbers


def beams_at(beams: Beams, numbers: Numbers, x0: Array) -> BeamElements:
    """The elastic beams of a model at positions x0 (n, 3)."""
    dim, (count, v) = beams.dim, beams.nodes.shape
    length, local, damping = numbers.full(count), numbers.full(count, dim, dim), numbers.full(count)
    damping[..., beams.damped] = numbers["beam_damping"]
    for k, nodes in enumerate(beams.nodes):
        length[..., k] = size(x0[..., nodes[dim + 1], :] - x0[..., nodes[0], :])
        local[..., k, :, :] = _local_axes(beams, k, numbers, x0)
    axes, ends = numbers.full(count, dim, v), numbers.full(count, dim, v)
    for begin, found in ((0, axes), (dim + 1, ends)):
        part = slice(begin + 1, begin + dim + 1)
        found[..., part] = local / size(x0[..., beams.nodes[:, part], :] - x0[..., beams.nodes[:, [begin]], :])[..., None, :]
        found[..., begin] = -found[..., part].sum(axis=-1)
    rigidity, line, rotary = _matter(beams, numbers, length)
    return BeamElements(
        names=beams.names,
        nodes=beams.nodes,
        length=length,
        axes=axes,
        ends=ends,
        modes=_modes(length, axes, ends),
        rigidity=rigidity,
        line=line,
        rotary=rotary,
        damping=damping,
    )


def _local_axes(beams: Beams, k: int, numbers: Numbers, x0: Array) -> Array:
    """Local axes 1, 2, 3 of a beam at the start as rows, (dim, dim)."""
    beam, dim = beams.records[k], beams.dim
    names, places = list(beam.ends), [beams.nodes[k, 0], beams.nodes[k, dim + 1]]
    if beams.toward[k] >= 0:
        names, places = [*names, str(beam.orientation)], [*places, beams.toward[k]]
    points = x0[..., places, :dim]
    found = np.empty((*numbers.lead, dim, dim))
    for copy in np.ndindex(numbers.lead):
        nodes = {name: SimpleNamespace(at=at) for name, at in zip(names, points[copy].real, strict=True)}
        found[copy] = axes_of_beam(SimpleNamespace(dim=dim, nodes=nodes), beam)  # type: ignore[arg-type]
    if not np.iscomplexobj(points):
        return found
    d = points[..., 1, :] - points[..., 0, :]
    if dim == 2:
        one = (d / size(d)[..., None]).imag
        return found + 1j * np.stack([one, np.stack([-one[..., 1], one[..., 0]], axis=-1)], axis=-2)
    if beams.toward[k] >= 0:
        toward = points[..., 2, :] - points[..., 0, :]
    elif beam.orientation is None:
        toward = start_references(one_copy(points), *np.array([[0], [1]]))[0]
    else:
        toward = np.array(beam.orientation)
    return found + 1j * np.stack(axes_along(d, toward), axis=-2).imag


def _matter(beams: Beams, numbers: Numbers, length: Array) -> tuple[Array, Array, Array]:
    """Rigidities of the modes (k, s), N m, masses a length (k,), kg/m, and rotary inertias a length (k, 2), kg m."""
    E, density, poisson, masses = (numbers.each(name) for name in ("E", "density", "poisson", "beam_mass"))
    shapes = beams.matter_of.shapes(numbers)
    used = {place: shapes[place] for place in beams.matter[:, 0].tolist()}
    known = {place: (one.area, *one.second_moments, one.torsion_constant) for place, one in used.items()}
    rows = []
    for k, ((section, material), l) in enumerate(zip(beams.matter.tolist(), entries(length), strict=True)):
        (A, I2, I3, J), e = known[section], E[material]
        modes = [e * A * l, e * I3 / l, 3 * e * I3 / l]
        if beams.dim == 3:
            G = e / (2 * (1 + poisson[material]))
            modes += [e * I2 / l, 3 * e * I2 / l, G * J / l]
        line = masses[beams.mass[k]] / l if k in beams.mass else density[material] * A
        rows.append([*modes, line, line * I3 / A, line * I2 / A])
    found = np.moveaxis(np.array(rows), (0, 1), (-2, -1))
    rigidity, line, rotary = (np.ascontiguousarray(found[..., columns]) for columns in (slice(-3), -3, slice(-2, None)))
    return rigidity, line, rotary


def _modes(l: Array, p: Array, q: Array) -> Array:
    """Modes (k, s, w) by pairs of nodes; p, q (k, dim, v) coefficients of the axes at both ends."""
    v = p.shape[-1]
    chord = (np.eye(v)[v // 2] - np.eye(v)[0]) / l[..., None]
    p, q = np.moveaxis(p, -2, 0), np.moveaxis(q, -2, 0)
    axial = 0.6 * _dot(chord, chord) - 0.1 * _dot(p[0] + q[0], chord) - _dot(p[0], q[0]) / 30

    def bent(across: int, sign: float) -> list[Array]:
        # rotations from the chord, and the sine of their difference
        f_p, f_q = -sign * _dot(p[across], chord), -sign * _dot(q[across], chord)
        s = 0.5 * sign * (_dot(p[across], q[0]) - _dot(p[0], q[across]))
        return [2 * (f_q - f_p) - s, f_p + f_q]

    rows = [axial, *bent(1, 1.0)]
    if len(p) == 3:
        rows += [*bent(2, -1.0), 0.5 * (_dot(p[2], q[1]) - _dot(p[1], q[2]))]
    return np.stack(rows, axis=-2)


def _dot(a: Array, b: Array) -> Array:
    """Coefficients (k, w) of the squared distances of pairs of nodes in the dot product of two combinations of nodes."""
    i, j = np.triu_indices(a.shape[-1], 1)
    return np.asarray(-0.5 * (a[..., i] * b[..., j] + a[..., j] * b[..., i]))


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
