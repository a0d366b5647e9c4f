"""Tables of a model at other numbers: complex ones, and copies of them side by side, which give derivatives by all numbers.

Numbers by name (k,) of a model of n nodes in `dim` dimensions; those that a model leaves out are not among them, nor are
directions, points of tables of springs, ratios of angles, and which entries a model has.

place (n, dim), lump (n,), own_gravity, velocity (., dim) of the nodes that have them, gravity (dim,)
section : dimensions of all sections; E, density, poisson of all materials; thickness, orthotropic of membranes and solids
bar_ : length, friction, body, mass, damping, natural, stiffness, pretension, where they are given
part_, point_ : of bases and tubes of active members, and of the masses on them; beam_, body_ : mass, ...
"load NAME force", "case NAME factor" and the like : of loads and load cases
factor, phase, coupling_value : of sums of coordinates; "spring stiffness" and the like, of each element on coordinates
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached, keep
from kinetruss.elements.kinds import ELEMENTS
from kinetruss.elements.numbers import Numbers
from kinetruss.errors import AnalysisError
from kinetruss.mechanics.gathered import Joined, arrays_at, gathered
from kinetruss.mechanics.loads import case_loads, unit_loads_of
from kinetruss.mechanics.system import System, compile, compiles_to
from kinetruss.mechanics.tables import elements

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model


@cached()
def _gathered(system: System) -> tuple[Joined, Numbers]:
    return gathered(system.model)


def numbers_of(system: System) -> Numbers:
    """The numbers of a compiled model by name."""
    return _gathered(system)[1]


def system_at(system: System, changes: Mapping[str, NDArray[Any]]) -> System:
    """The same system with some of its numbers changed: also complex ones, or copies (copies, ...) of which it then has arrays.

    Only formulas that are array code take it; kernels do not.
    """
    joined, own = _gathered(system)
    given = {name: np.asarray(changes[name]) if name in changes else one for name, one in own.items()}
    if unknown := set(changes) - set(own):
        raise AnalysisError(f"The model has no numbers called {', '.join(sorted(unknown))}. It has: {', '.join(own)}.")
    if all(one.shape == own[name].shape and one.dtype == float for name, one in given.items()):
        return replace(system, **arrays_at(joined, Numbers(given)))
    lead = np.broadcast_shapes(*(one.shape[: one.ndim - own[name].ndim] for name, one in given.items()))
    kind: Any = complex if any(np.iscomplexobj(one) for one in given.values()) else float
    every = {name: np.broadcast_to(one, (*lead, *own[name].shape)).astype(kind) for name, one in given.items()}
    return replace(system, **arrays_at(joined, Numbers(every, lead, kind)))


def compile_moved(model: Model, last: Model) -> None:
    """Compile a model that is `last` with nodes at other places: who is joined with whom is not asked again."""
    system = compile(last)
    if model.whole.inner.nodes or model.supports:
        return  # their structure depends on places: it is compiled by itself
    joined, own = _gathered(system)
    place = np.array([node.at for node in model.nodes.values()], float)
    found = replace(system_at(system, {"place": place}), given=model, model=model.whole)
    keep(_gathered, found, (joined, Numbers({**own, "place": place})))
    compiles_to(found, system)


def system_of(system: System, changes: Mapping[str, NDArray[np.float64]], model: Model) -> System | None:
    """The System of a model which is that of another but for these numbers, with each of them in its place as in the other;
    None if its arrays are not those of the model compiled by itself.
    """
    joined, own = _gathered(system)
    found, by_itself = replace(system_at(system, changes), given=model, model=model.whole), compile(model)
    keep(_gathered, found, (joined, Numbers({**own, **changes})))
    one, other = _own_arrays(found), _own_arrays(by_itself)
    same = (found.nodes, found.members, found.measures) == (by_itself.nodes, by_itself.members, by_itself.measures)
    alike = same and one.keys() == other.keys() and all(_alike(one[name], other[name]) for name in one)
    return found if alike and found.continua is None else None


def _own_arrays(system: System) -> dict[str, NDArray[Any]]:
    found = {one.name: getattr(system, one.name) for one in fields(system)} | system.element_numbers | system.load_numbers
    return {name: one for name, one in found.items() if isinstance(one, np.ndarray)}


def _alike(one: NDArray[Any], other: NDArray[Any]) -> bool:
    if one.shape != other.shape or one.dtype.kind != "f":
        return bool(np.array_equal(one, other))
    size = np.nanmax(np.abs(one), initial=0.0)
    return bool(np.allclose(one, other, rtol=1e-10, atol=1e-12 * size if np.isfinite(size) else 0.0, equal_nan=True))


def tables_at(system: System, changes: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Arrays of numbers of a system with some of its numbers changed, (copies, ...): fields of `System`, of `Structure`
    ("structure law"), of the records of elements, by the file of the kind ("scalars numbers"), and of beams ("beams rigidity").

    Derivatives by a number p: tables_at(p + i h).imag/h.

    Raises
    ------
    AnalysisError : a number that is 0, and so left out, is changed.
    """
    at = system_at(system, changes)
    found, base = _tables(at), _own_tables(system)
    lead = at.x0.shape[:-2]
    for name, one in base.items():
        if found[name].shape != (*lead, *one.shape):
            raise AnalysisError(f"Table {name!r} gets other rows. Change no numbers that are 0 in the model, and so left out.")
    return found


def load_tables_at(
    system: System, changes: Mapping[str, NDArray[Any]], t: NDArray[np.float64], case: str | None = None
) -> dict[str, NDArray[Any]]:
    """Likewise the tables of the loads of a case at times t, s: gravity, lump_gravity, force (mechanics.loads.Loads), and of
    each component k of a load that is not on nodes "NAME k amount" (times,) and its unit load, "NAME k data".
    """
    at = system_at(system, changes)
    found, lead = _load_tables(at, t, case), at.x0.shape[:-2]
    return {name: np.broadcast_to(found[name], (*lead, *one.shape)) for name, one in _load_tables(system, t, case).items()}


def _load_tables(system: System, t: NDArray[np.float64], case: str | None) -> dict[str, NDArray[Any]]:
    """All tables of numbers of the loads of a case."""
    loads = case_loads(system, t, case, rotating=True)
    found = {"gravity": loads.gravity, "lump_gravity": loads.lump_gravity, "force": loads.force}
    for name, amounts in loads.amounts.items():
        for k, unit in enumerate(unit_loads_of(system, name)):
            found[f"{name} {k} amount"] = amounts[..., k]
            tables = {one.name: np.asarray(getattr(unit, one.name)) for one in fields(unit)}
            found |= {f"{name} {k} {key}": one for key, one in tables.items() if one.dtype.kind in "fc"}
    return found


@cached()
def _own_tables(system: System) -> dict[str, NDArray[Any]]:
    return _tables(system)


def _tables(system: System) -> dict[str, NDArray[Any]]:
    """All tables of numbers of a system."""
    found = {one.name: getattr(system, one.name) for one in fields(system)} | system.element_numbers
    found |= {f"structure {name}": one for name, one in elements(system).items()}
    for kind in ELEMENTS:
        if kind.fields is not None:
            file = kind.name or kind.coordinates.__module__.rpartition(".")[2]
            found |= {f"{file} {name}": one for name, one in (kind.fields(system) or {}).items()}
        elif (record := kind.table(system)) is not None:
            raise AnalysisError(
                f"Elements of the kind {type(record).__name__} have no tables at other numbers. Leave them out."
            )
    if system.continua is not None:
        found |= {"continua mass": system.continua.mass, "continua lump": system.continua.lump}
        if (beams := system.continua.beams) is not None:
            found |= {f"beams {one.name}": getattr(beams, one.name) for one in fields(beams)}
    return {name: one for name, one in found.items() if isinstance(one, np.ndarray) and one.dtype.kind in "fc"}
