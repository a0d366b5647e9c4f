"""Local axes of members: across them in the plane, their orientation about axis 1 in space, and the axes at any positions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.elements.directions import start_references
from kinetruss.elements.numbers import one_copy

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


class Orientation(NamedTuple):
    """Plane 1-2 is spanned by the member and node (m,), or if that is -1 by the direction reference (m, 3)."""

    node: NDArray[np.int32]
    reference: NDArray[np.float64]


def turned(r: NDArray[Any]) -> NDArray[Any]:
    """Vectors (..., 3) turned by 90 degrees in the plane, counter-clockwise; complex ones allowed."""
    return np.stack([-r[..., 1], r[..., 0], np.zeros_like(r[..., 0])], axis=-1)


@cached()
def orientation(system: System) -> Orientation:
    """Orientation of all members in the start configuration."""
    members = system.model.members.values()
    node = np.array([-1 if m.orientation is None else system.node_index(m.orientation) for m in members], np.int32)
    return Orientation(node, start_references(one_copy(system.x0)[:, : system.dim], system.p, system.q))


def local_axes(system: System, position: NDArray[np.float64], member: Any = slice(None)) -> NDArray[np.float64]:
    """Axes 1, 2, 3 of members (k,), all by default, as rows (t, k, 3, 3), at positions (t, n, dim)."""
    from kinetruss.kernels.sections.sections import member_axes  # compiled; callers that only draw do not need it

    node, reference = (one[member] for one in orientation(system))
    out = np.empty((len(position), len(node), 3, 3))
    member_axes(np.ascontiguousarray(position), system.p[member], system.q[member], node, reference, out)
    return out
