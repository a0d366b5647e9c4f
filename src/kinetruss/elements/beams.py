"""Beams between two frames: their axes, rigidities and masses.

An end of a beam has an origin and a frame of nodes, so that its local axes x, y, z (1, 2, 3 of the section) are constant
combinations of differences of nodes: 6 nodes in the plane, 8 in space. Their deformations (axial, D and S of bending about 3
and 2, torsion) are those of kernels.structure.beam_law, with E A l0, E I/l0, 3 b E I/l0 and G J/l0 as rigidities; forces
and tangents are in elements.beam_kernels.

Mass: the axis has the field r = H1 x_P + H2 l0 x_p + H3 x_Q + H4 l0 x_q with Hermite's polynomials, and a section turns with
axes y, z that change linearly from p to q: kinetic energy rho A |r'|^2/2 + rho I3 |y'|^2/2 + rho I2 |z'|^2/2 along the beam,
with constant masses between nodes. What is antisymmetric in the slopes of both ends is shear in part: the mean of b about 3
and 2 of it remains.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.directions import axes_along, start_references
from kinetruss.elements.numbers import entries, one_copy, size
from kinetruss.model.beam_frames import axes_of_beam, frame_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.beam_kernels import BeamTable
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
    v) at the second; start (k, v, 3) places of the nodes without stress, m; rigidity (k, s): E A l0, E I3/l0, 3 b E I3/l0, ..,
    N m; bending (k, 2) : b about 3 and 2, 1 of beams that are not flexible in shear; line (k,) kg/m; rotary (k, 2): rho I3,
    rho I2, kg m; damping (k,) s.
    """

    names: tuple[str, ...]
    nodes: NDArray[np.int64]
    length: NDArray[np.float64]
    axes: NDArray[np.float64]
    ends: NDArray[np.float64]
    start: NDArray[np.float64]
    rigidity: NDArray[np.float64]
    bending: NDArray[np.float64]
    line: NDArray[np.float64]
    rotary: NDArray[np.float64]
    damping: NDArray[np.float64]

    def chosen(self, which: NDArray[np.bool_]) -> BeamElements:
        """Some of them."""
        arrays = {name: value[which] for name, value in vars(self).items() if isinstance(value, np.ndarray)}
        kept = tuple(name for name, one in zip(self.names, which, strict=True) if one)
        return BeamElements(names=kept, **{one.name: arrays[one.name] for one in fields(self) if one.name != "names"})

    @cached_property
    def record(self) -> BeamTable:
        """What kernels take."""
        from kinetruss.elements.beam_kernels import BeamTable  # compiled; callers that only check do not need it

        return BeamTable.of(self.fields())

    def fields(self) -> dict[str, Array]:
        """Its fields; the numbers may be complex, and copies."""
        from kinetruss.kernels.structure.beam_law import addresses

        count, v = self.nodes.shape
        half, lead = v // 2, self.length.shape[:-1]
        both = np.stack([self.axes[..., 1:half], self.ends[..., half + 1 :]], axis=-3)
        return {
            "law": np.array(addresses(half - 1), np.int64),
            "at": 3 * self.nodes,
            "start": self.start.reshape(*lead, count, 3 * v),
            "axes": both.reshape(*lead, count, -1),
            "data": np.concatenate([self.length[..., None], self.bending, self._over_torsion()], axis=-1),
            "rigidity": self.rigidity,
            "damping": self.damping,
        }

    @cached_property
    def pattern(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """Rows and columns of what beams put into a matrix of all coordinates; which of them each entry of their blocks is."""
        at = (3 * self.nodes[:, :, None] + np.arange(3)).reshape(len(self.nodes), -1)
        every = int(at.max()) + 1
        found, place = np.unique(at[:, :, None] * every + at[:, None, :], return_inverse=True)
        return found // every, found % every, place.reshape(-1)

    def mass(self) -> Array:
        """Masses (k, v, v) between nodes, kg."""
        xi, weight = _gauss()
        r = self.along(xi)
        found = np.einsum("g,...k,...kgv,...kgw->...kvw", weight, self.line * self.length, r, r)
        for c in range(1, self.axes.shape[-2]):
            first, second = self.axes[..., None, c, :], self.ends[..., None, c, :]
            turned = (1 - xi)[:, None] * first + xi[:, None] * second
            inertia = self.rotary[..., c - 1] * self.length
            found += np.einsum("g,...k,...kgv,...kgw->...kvw", weight, inertia, turned, turned)
        return np.asarray(found)

    def along(self, xi: Array) -> Array:
        """Coefficients (k, g, v) of the nodes that give the axis of the beam at the shares xi (g,) of it."""
        xi = np.asarray(xi)[..., None, :]
        _, h2, _, h4 = hermite(xi)
        v, l = self.nodes.shape[1], self.length[..., None]
        # Hermite's polynomials with the part of the slopes that is antisymmetric about the middle b times as large
        one, two = 0.5 * (h2 + h4) * self._bent, 0.5 * (h4 - h2)
        first, second = (np.eye(v)[at] for at in (0, v // 2))
        straight = (1 - xi + 2 * one)[..., None] * first + (xi - 2 * one)[..., None] * second
        slopes = (l * (one - two))[..., None] * self.axes[..., None, 0, :] + (l * (one + two))[..., None] * self.ends[
            ..., None, 0, :
        ]
        return np.asarray(straight + slopes)

    def _over_torsion(self) -> Array:
        """E I3/(G J) and E I2/(G J), (k, 2); 0 in the plane."""
        if self.rigidity.shape[-1] == len(MODES[2]):
            return np.zeros_like(self.bending)
        return np.asarray(self.rigidity[..., [1, 3]] / self.rigidity[..., 5:])

    @property
    def _bent(self) -> Array:
        """The mean share (k, 1) of bending in both planes."""
        planes = self.axes.shape[-2] - 1
        return np.asarray(self.bending[..., :planes].mean(axis=-1)[..., None])


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
    rigidity, bending, line, rotary = _matter(beams, numbers, length)
    return BeamElements(
        names=beams.names,
        nodes=beams.nodes,
        length=length,
        axes=axes,
        ends=ends,
        start=x0[..., beams.nodes, :],
        rigidity=rigidity,
        bending=bending,
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


def _matter(beams: Beams, numbers: Numbers, length: Array) -> tuple[Array, Array, Array, Array]:
    """Rigidities of the modes (k, s), N m, shares of bending (k, 2), masses a length (k,), kg/m, and rotary inertias a length
    (k, 2), kg m.
    """
    E, density, poisson, masses = (numbers.each(name) for name in ("E", "density", "poisson", "beam_mass"))
    shapes = beams.matter_of.shapes(numbers)
    used = {place: shapes[place] for place in beams.matter[:, 0].tolist()}
    known = {place: (one.area, *one.second_moments, one.torsion_constant, one.shear_areas) for place, one in used.items()}
    rows = []
    for k, ((section, material), l) in enumerate(zip(beams.matter.tolist(), entries(length), strict=True)):
        (A, I2, I3, J, sheared), e = known[section], E[material]
        G = e / (2 * (1 + poisson[material]))
        b3 = b2 = e / e
        if sheared is not None:
            b3, b2 = (1 / (1 + 12 * e * I / (G * own * l**2)) for I, own in zip((I3, I2), sheared, strict=True))
        modes = [e * A * l, e * I3 / l, 3 * b3 * e * I3 / l]
        if beams.dim == 3:
            modes += [e * I2 / l, 3 * b2 * e * I2 / l, G * J / l]
        line = masses[beams.mass[k]] / l if k in beams.mass else density[material] * A
        rows.append([*modes, b3, b2, line, line * I3 / A, line * I2 / A])
    found = np.moveaxis(np.array(rows), (0, 1), (-2, -1))
    columns = slice(-5), slice(-5, -3), -3, slice(-2, None)
    rigidity, bending, line, rotary = (np.ascontiguousarray(found[..., own]) for own in columns)
    return rigidity, bending, line, rotary


def _gauss() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Four points and weights on 0..1: exact for the square of a cubic."""
    x, w = np.polynomial.legendre.leggauss(4)
    return 0.5 * (1 + x), 0.5 * w
