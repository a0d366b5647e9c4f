"""Couples on elastic beams as forces on the nodes of their ends.

A couple C at the share xi of a beam does the work C . dtheta on the rotation of the section there. In the axes of the deformed
beam (1 along the chord, as in mechanics.beam_forces) and with theta_P, theta_Q of the ends and psi of the chord

    theta_1 = (1 - xi) theta_P + xi theta_Q
    theta_i = g psi + a_P theta_P + a_Q theta_Q,  g = 6 b xi (1 - xi),  a_P, a_Q = (1 - g)/2 +- (1 - 2 xi)/2     i = 2, 3

which are those of a beam that is loaded at its ends alone, b the part of bending that shear leaves (elements.beams). So C is
worth the couples T_P, T_Q on the frames of the ends, on the axes a_c of a frame the forces T x a_c/2 (T/2 in the plane), and
X x 1/|d| and its opposite on Q and P. Source: reciprocity (Betti, 1872) with the exact shapes of Przemieniecki (1968, ch. 5).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.directions import axes_along, unit
from kinetruss.elements.loads.load import OnBeam, UnitLoad
from kinetruss.elements.local_axes import turned
from kinetruss.elements.numbers import size
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, Record, Vector, record
from kinetruss.kernels.structure.tables import entry_at, weighted_place

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.beams import BeamElements


@record
class BeamCouples(Record):
    """axis (k,) 0, 1, 2 about which couple k acts, of the beam where turns (k,) is 1, else global; planar (k,).

    node[ptr[k]:ptr[k + 1]] flat coordinates of the nodes of both ends, with data (nodes, 8): factors of d, of the axes 1, 2, 3
    of the frames at P and Q, and of the direction that spans the plane 1-2; about (k, 9) parts of P, Q and the chord of
    the couple about axes 1, 2, 3. value at time, s, from table_ptr[k] on.
    """

    axis: I1
    turns: I1
    planar: I1
    ptr: I1
    node: I1
    table_ptr: I1
    time: F1
    value: F1
    data: F2
    about: F2


@kernel_bare
def _cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel_bare
def _put(s: BeamCouples, k: int, column: int, push: Vector, f: F1) -> None:
    """Add push times a factor at the nodes of couple k."""
    for i in range(s.ptr[k], s.ptr[k + 1]):
        at, factor = s.node[i], s.data[i, column]
        f[at] += factor * push[0]
        f[at + 1] += factor * push[1]
        f[at + 2] += factor * push[2]


@kernel_bare
def _unit(a: Vector) -> Vector:
    factor = 1.0 / math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])
    return a[0] * factor, a[1] * factor, a[2] * factor


@kernel
def force(s: BeamCouples, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    # T_P, T_Q on the frames and X on the chord, of each couple
    for k in range(s.axis.size):
        amount = entry_at(s.time, s.value, s.table_ptr[k], s.table_ptr[k + 1], t)
        d = weighted_place(s.node, s.data, s.ptr[k], s.ptr[k + 1], 0, x)
        one = _unit(d)
        two = (-one[1], one[0], 0.0)
        if s.planar[k] == 0:
            h = weighted_place(s.node, s.data, s.ptr[k], s.ptr[k + 1], 7, x)
            along = h[0] * one[0] + h[1] * one[1] + h[2] * one[2]
            two = _unit((h[0] - along * one[0], h[1] - along * one[1], h[2] - along * one[2]))
        three = _cross(one, two)
        c1, c2, c3 = one[s.axis[k]], two[s.axis[k]], three[s.axis[k]]
        if s.turns[k] != 0:
            c1, c2, c3 = 0.0, 0.0, 0.0
            if s.axis[k] == 0:
                c1 = 1.0
            elif s.axis[k] == 1:
                c2 = 1.0
            else:
                c3 = 1.0
        c1, c2, c3 = amount * c1, amount * c2, amount * c3
        for where in range(3):
            p1, p2, p3 = c1 * s.about[k, 3 * where], c2 * s.about[k, 3 * where + 1], c3 * s.about[k, 3 * where + 2]
            T = (
                p1 * one[0] + p2 * two[0] + p3 * three[0],
                p1 * one[1] + p2 * two[1] + p3 * three[1],
                p1 * one[2] + p2 * two[2] + p3 * three[2],
            )
            if where == 2:
                push, far = _cross(T, one), 1.0 / math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
                _put(s, k, 0, (far * push[0], far * push[1], far * push[2]), f)
                continue
            for c in range(3 - s.planar[k]):
                push = _cross(T, weighted_place(s.node, s.data, s.ptr[k], s.ptr[k + 1], 1 + 3 * where + c, x))
                _put(s, k, 1 + 3 * where + c, (0.5 * push[0], 0.5 * push[1], 0.5 * push[2]), f)


@dataclass(frozen=True, kw_only=True, eq=False)
class BeamCouple(UnitLoad):
    """A couple of 1 N m/m along a beam, or of 1 N m at a place of it, about an axis; the fields of `BeamCouples`."""

    kernel, record, own = force, BeamCouples, ("axis", "turns", "planar", "about")
    axis: int
    turns: int
    planar: int
    about: NDArray[np.float64]

    @property
    def constant(self) -> bool:
        """As UnitLoad.constant."""
        return False

    def forces(self, r: NDArray[Any]) -> NDArray[Any]:
        """As UnitLoad.forces."""
        read = np.einsum("jm,...jc->...mc", self.data, r)
        d, h = read[..., 0, :], read[..., 7, :]
        one = unit(d)
        frame = np.stack([one, turned(one), np.broadcast_to(np.eye(3)[2], one.shape)], axis=-2)
        if not self.planar:
            frame = np.stack(axes_along(d, h), axis=-2)
        own = np.broadcast_to(np.eye(3)[self.axis], d.shape) if self.turns else frame[..., self.axis]
        # couples on P, Q and the chord along global axes
        T = np.einsum("wa,...a,...ac->...wc", self.about.reshape(3, 3), own, frame)
        found = self.data[:, :1] * (np.cross(T[..., 2, :], one) / size(d)[..., None])[..., None, :]
        for where in (0, 1):
            columns = slice(1 + 3 * where, 4 + 3 * where - self.planar)
            push = 0.5 * np.cross(T[..., where, None, :], read[..., columns, :])
            found = found + np.einsum("jm,...mc->...jc", self.data[:, columns], push)
        return np.asarray(found)


def couples_on_beam(beams: BeamElements, one: OnBeam, dim: int) -> tuple[UnitLoad, ...]:
    """The unit couples on a beam: about z in the plane, about three axes in space."""
    v, k = beams.nodes.shape[1], one.beam
    kind = np.result_type(beams.axes, beams.length)
    data = np.zeros((*beams.length.shape[:-1], v, 8), kind)
    data[..., 0] = np.eye(v)[v // 2] - np.eye(v)[0]
    data[..., 1 : 1 + dim] = np.swapaxes(beams.axes[..., k, :, :], -1, -2)
    data[..., 4 : 4 + dim] = np.swapaxes(beams.ends[..., k, :, :], -1, -2)
    data[..., 7] = beams.axes[..., k, 1, :] + beams.ends[..., k, 1, :]
    about = one.over(beams, lambda xi: _parts(beams, k, xi))
    own = {"nodes": beams.nodes[k], "data": data, "about": about, "planar": int(dim == 2), "turns": int(one.turns)}
    return tuple(BeamCouple(axis=axis, **own) for axis in ((2,) if dim == 2 else (0, 1, 2)))


def _parts(beams: BeamElements, k: int, xi: Any) -> NDArray[Any]:
    """Parts (..., g, 9) of P, Q and the chord of couples about axes 1, 2, 3 at the shares xi (..., g)."""
    xi = np.asarray(xi)
    found = [[1.0 - xi], [xi], [0.0 * xi]]
    for column in (1, 0):  # b about 2, about 3
        g = 6.0 * beams.bending[..., k, column, None] * xi * (1.0 - xi)
        found[0].append(0.5 * (1.0 - g) + (0.5 - xi))
        found[1].append(0.5 * (1.0 - g) - (0.5 - xi))
        found[2].append(g)
    return np.stack(np.broadcast_arrays(*(one for row in found for one in row)), axis=-1)
