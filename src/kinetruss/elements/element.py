"""What a kind of element is to the engines, the analyses and the results."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Results(NamedTuple):
    """What a person reads of the elements of one kind: the kind, a word that names their dimension; their names; by name of the
    result its values along a motion, (times, elements) or vectors (times, elements, 3), their unit, and what they are.
    """

    kind: str
    names: tuple[str, ...]
    values: Mapping[str, tuple[NDArray[np.float64], str, str]]


def _never(record: Any) -> bool:  # noqa: ARG001
    return False


def _no_switches(system: Any) -> Mapping[str, Any]:  # noqa: ARG001
    return MappingProxyType({})


class Element(NamedTuple):
    """table : the record of all elements of this kind in a system, or None. coordinates (rows, w) of its record, flat, -1 for
    none: those of an element, or of an edge, of which many elements consist. kernels : by column of the table of kinds
    (kernels.structure.element_table), interface and kernel. without_series : why a system has no power series of these forces,
    or None. loses : whether elements of its record take energy; feeds : whether they may give some that they do not store.

    With positions and velocities (n, 3), as sparse matrices (3 n, 3 n): tangents : K and C, minus the derivatives of the forces
    by x and by v. geometric : the stiffness of the forces that small displacements u from x add, for critical loads; None where
    these have none. rows : the equations of small displacements have rows for the deformations of its elements
    (statics.small_displacements). results : at times (times,), positions and velocities (times, 3 n), where its elements have
    some that are not on a coordinate; linear_results : the same of small displacements u (n, 3) from x, the values at x and
    their change to first order, at rest. switches : events by name where a law changes its form, for simulations to tell.
    fields : the arrays of the record by name, whose numbers may be complex, and copies, as those of the system are
    (mechanics.numbers); there they are known by `name`, by default that of the file of the kind.
    """

    table: Callable[[Any], Any]
    coordinates: Callable[[Any], NDArray[np.int64]]
    kernels: Mapping[int, tuple[Any, Any]]
    tangents: Callable[[Any, Any, Any, Any], tuple[Any, Any]]
    without_series: Callable[[Any], str | None]
    loses: Callable[[Any], bool]
    geometric: Callable[[Any, Any, Any, Any], Any] | None = None
    rows: bool = False
    results: Callable[[Any, Any, Any, Any, Any], Results] | None = None
    fields: Callable[[Any], dict[str, NDArray[Any]] | None] | None = None
    linear_results: Callable[[Any, Any, Any, Any], Results] | None = None
    switches: Callable[[Any], Mapping[str, Any]] = _no_switches
    feeds: Callable[[Any], bool] = _never
    name: str = ""
