"""The kinds that there are, and the tables of those that a structure has."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.elements import beam_kernels, beam_matrices, continua, continua_matrices, cylinder, on_nodes, scalars
from kinetruss.elements.caching import cached
from kinetruss.elements.element import Element
from kinetruss.elements.loads import along, body_loads, nodal, pressures
from kinetruss.elements.loads.load import Load, Turning, UnitLoad
from kinetruss.elements.pin_friction import pins
from kinetruss.elements.spring import springs
from kinetruss.elements.stop import stops
from kinetruss.kernels.structure.element_table import FORCE, INTS, INTS_END, REALS, REALS_END, force
from kinetruss.model.data import FORCE_ELEMENTS
from kinetruss.model.loads import BodyCouple, BodyForce, NodalForce, Pressure
from kinetruss.model.loads_along import MemberCouple, MemberLoad, MemberPointCouple, MemberPointForce

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.compiled.record import Record
    from kinetruss.mechanics.system import System

ON_COORDINATES = {"friction": pins, "spring": springs, "stop": stops}
"""Kinds of elements on coordinates (elements.scalars): friction, whose elements have no names, and those of a model."""

ON_NODES: tuple[Callable[[System], on_nodes.Part | None], ...] = (cylinder.cylinders,)
"""Kinds of elements on nodes whose law is an expression (elements.on_nodes)."""


@cached()
def parts_of(system: System) -> dict[str, scalars.Part]:
    """The elements on coordinates by kind."""
    return {name: ON_COORDINATES[name](system) for name in ("friction", *FORCE_ELEMENTS)}


@cached()
def on_coordinates(system: System) -> scalars.Scalars | None:
    """All elements on coordinates; None where there are none."""
    fields = fields_on_coordinates(system)
    return None if fields is None else scalars.Scalars.of(fields)


def fields_on_coordinates(system: System) -> dict[str, NDArray[Any]] | None:
    """The fields of the record of all elements on coordinates; None where there are none."""
    if not (system.force_elements or system.friction.any()):
        return None
    parts = list(parts_of(system).values())
    return scalars.fields(parts) if any(len(one.loses) for one in parts) else None


@cached()
def spans_of(system: System) -> dict[str, slice]:
    """Where the elements of each kind stand among those on coordinates."""
    ends = np.cumsum([0, *(len(one.loses) for one in parts_of(system).values())]).tolist()
    return {name: slice(*pair) for name, pair in zip(parts_of(system), pairwise(ends), strict=True)}


def switches(system: System) -> dict[str, Any]:
    """Events by name at which a law changes its form."""
    return {name: event for one in ELEMENTS for name, event in one.switches(system).items()}


def _of_parts(system: System) -> dict[str, Any]:
    return {name: event for part in parts_of(system).values() for name, event in part.switches.items()}


def _bent(system: System) -> str | None:
    for one in parts_of(system).values():
        for k in np.flatnonzero(one.linear == 0)[:1]:
            return one.bent.format(one.names[k])
    return None


ELEMENTS = (
    Element(
        on_coordinates,
        scalars.coordinates,
        scalars.KERNELS,
        scalars.tangents,
        without_series=_bent,
        loses=lambda s: bool(s.loses.any()),
        geometric=scalars.geometric,
        rows=True,
        fields=fields_on_coordinates,
        switches=_of_parts,
    ),
    Element(
        continua_matrices.table,
        continua.coordinates,
        continua.KERNELS,
        continua_matrices.tangents,
        without_series=continua_matrices.without_series,
        loses=lambda s: False,  # noqa: ARG005
        geometric=continua_matrices.geometric,
        rows=True,
        fields=continua_matrices.fields,
    ),
    Element(
        beam_matrices.table,
        beam_kernels.coordinates,
        beam_kernels.KERNELS,
        beam_matrices.tangents,
        without_series=beam_matrices.without_series,
        loses=beam_kernels.loses,
        geometric=beam_matrices.geometric,
        rows=True,
        fields=beam_matrices.fields,
    ),
    *map(on_nodes.element, ON_NODES),
)
"""All kinds, in the order of their sums."""


LOADS: dict[type, Load] = {
    NodalForce: nodal.FORCES,
    BodyForce: body_loads.FORCES,
    BodyCouple: body_loads.COUPLES,
    Pressure: pressures.PRESSURES,
    MemberLoad: along.FORCES,
    MemberPointForce: along.FORCES,
    MemberCouple: along.COUPLES,
    MemberPointCouple: along.COUPLES,
}
"""Kinds of loads by their records."""


def present(system: System) -> list[tuple[Element, Record]]:
    """The kinds that a system has, with their records."""
    found = ((one, one.table(system)) for one in ELEMENTS)
    return [(one, record) for one, record in found if record is not None]


def element_arrays(system: System) -> dict[str, NDArray[Any]]:
    """The fields of `Structure` for elements."""
    return table_of_kinds("element", [(one.kernels, record) for one, record in present(system)])


def load_arrays(loads: Sequence[Turning]) -> dict[str, NDArray[Any]]:
    """The fields of `Equations` for loads that depend on positions."""
    kinds: dict[Any, list[Turning]] = {}
    for one in loads:
        kinds.setdefault(type(one.load), []).append(one)
    times = np.unique([t for one in loads for t in one.times])
    return table_of_kinds("load", [forces_of_loads(own) for own in kinds.values()]) | {"load_time": times.astype(float)}


def forces_of_loads(loads: Sequence[Turning]) -> tuple[Mapping[int, tuple[Any, Any]], Record]:
    """Loads of one class as a row of a table of kinds, with forces alone."""
    kind = type(loads[0].load)
    return {FORCE: (force, kind.kernel)}, kind.table(loads)


def scalar_forces(system: System, k: int) -> tuple[Mapping[int, tuple[Any, Any]], Record]:
    """One of the elements on coordinates as a row of a table of kinds, with forces alone."""
    return {FORCE: scalars.KERNELS[FORCE]}, scalars.alone(cast("scalars.Scalars", on_coordinates(system)), k)


def compile_kinds() -> None:
    """Compile the kernels of all kinds of elements and loads, which a model compiles when it has them."""
    for one in ELEMENTS:
        for interface, kernel in one.kernels.values():
            interface.address(kernel)
    for load in UnitLoad.__subclasses__():
        force.address(load.kernel)


def table_of_kinds(name: str, kinds: Sequence[tuple[Mapping[int, tuple[Any, Any]], Record]]) -> dict[str, NDArray[Any]]:
    """A table of kinds (kernels.structure.element_table) from their kernels by column, and records."""
    rows: list[NDArray[np.int64]] = []
    ints: list[NDArray[Any]] = [np.zeros(0, np.int64)]
    reals: list[NDArray[Any]] = [np.zeros(0)]
    for kernels, record in kinds:
        row = np.zeros(REALS_END + 1, np.int64)
        for column, (interface, kernel) in kernels.items():
            row[column] = interface.address(kernel)
        for buffers, own, begin, end in ((ints, record.ints, INTS, INTS_END), (reals, record.reals, REALS, REALS_END)):
            row[begin] = sum(map(len, buffers))
            row[end] = row[begin] + len(own)
            buffers.append(own)
        rows.append(row)
    return {
        name: np.array(rows, np.int64).reshape(-1, REALS_END + 1),
        f"{name}_ints": np.concatenate(ints),
        f"{name}_reals": np.concatenate(reals),
    }
