"""A model as its structure, who is joined with whom, and its numbers; and arrays of a `System` from both."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.body_masses import Bodies, bodies_of, centers_of, pair_arrays
from kinetruss.elements.continua_arrays import Sheets, continua_at, sheets_of
from kinetruss.elements.matter import Matter
from kinetruss.elements.numbers import Numbers, size
from kinetruss.mechanics.measure_arrays import Measures, measure_arrays, measures_of
from kinetruss.mechanics.members import Members, member_arrays, members_of
from kinetruss.mechanics.row_arrays import AXIS, Rows, row_arrays, rows_of
from kinetruss.model.data import ELEMENT_FIELDS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import WholeModel


class Joined(NamedTuple):
    """The structure of a model. fields : those of `System` without numbers. elements, loads : names of the numbers of elements,
    and of loads and load cases. moving, weighed : nodes with a velocity, and with a gravity of their own.
    """

    dim: int
    fields: dict[str, Any]
    elements: tuple[str, ...]
    loads: tuple[str, ...]
    moving: list[int]
    weighed: list[int]
    members: Members
    bodies: Bodies
    measures: Measures
    rows: Rows
    sheets: Sheets | None


def gathered(model: WholeModel) -> tuple[Joined, Numbers]:
    """The structure of a model, and its numbers by name."""
    index, matter = {name: i for i, name in enumerate(model.nodes)}, Matter(model)
    members, of_members = members_of(model, matter)
    bodies, of_bodies = bodies_of(model, index, matter)
    measures, of_measures = measures_of(model, index)
    sheets, of_sheets = sheets_of(model, index, matter)
    rows = rows_of(model, index, members.fields["kind"], measures.fields["drive_measure"])
    # a scalar has no direction in which it could have a weight, and its mass may be a moment of inertia
    weighed = {
        i: node.gravity or (0.0,) * model.dim
        for i, node in enumerate(model.nodes.values())
        if node.gravity is not None or node.scalar
    }
    moving = {index[name]: vector for name, vector in model.velocities.items()}
    dim, count = model.dim, len(index)
    ends = chain.from_iterable(member.ends for member in model.members.values())
    p, q = np.fromiter((index[name] for name in ends), np.int32, 2 * len(model.members)).reshape(-1, 2).T
    fields = {
        "p": np.ascontiguousarray(p),
        "q": np.ascontiguousarray(q),
        "prescribed": _prescribed(model, index, rows),
        "supports": tuple(name for name in index if name in model.fixed),
    }
    places = [node.at for node in model.nodes.values()]
    own = {
        "place": np.array(places, float).reshape(count, dim),
        "lump": np.array([node.mass for node in model.nodes.values()], float),
        "own_gravity": np.array([*weighed.values()], float).reshape(-1, dim),
        "gravity": np.array(model.gravity or (0.0,) * dim, float),
        "velocity": np.array([*moving.values()], float).reshape(-1, dim),
    }
    elements, loads = _element_numbers(model), _load_numbers(model)
    joined = Joined(
        dim, fields, tuple(elements), tuple(loads), list(moving), list(weighed), members, bodies, measures, rows, sheets
    )
    return joined, Numbers(own | elements | loads | matter.numbers() | of_members | of_bodies | of_measures | of_sheets)


def _element_numbers(model: WholeModel) -> dict[str, Any]:
    """The numbers of elements whose records say their kind, as "spring stiffness", one an element; NaN those not given."""
    found = {}
    for kind, table in ELEMENT_FIELDS.items():
        records: list[Any] = [*getattr(model, table).values()]
        for name in _numbers_in(records[0].__class__) if records else ():
            values = [math.nan if (one := getattr(record, name)) is None else one for record in records]
            found[f"{kind} {name}"] = np.array(values, float)
    return found


@cache
def _numbers_in(record: Any) -> tuple[str, ...]:
    """The fields of an element that are one number each."""
    own = {name: str(field.annotation) for name, field in record.model_fields.items()}
    return tuple(name for name, text in own.items() if "float" in text and "tuple" not in text)


def _load_numbers(model: WholeModel) -> dict[str, Any]:
    """The numbers of loads and load cases, as "load NAME force": amounts (c,) or in time (times, c), others (k,)."""
    found: dict[str, Any] = {}
    for name, load in model.loads.items():
        for field, value in load:
            if isinstance(value, float) or (isinstance(value, tuple) and not isinstance(value[0], str) and field != "times"):
                numbers = np.array(value, float)
                shape = (len(numbers), -1) if field == load.amounts else (-1,)
                found[f"load {name} {field}"] = numbers.reshape(shape)
    for name, case in model.cases.items():
        if case.gravity is not None:
            found[f"case {name} gravity"] = np.array(case.gravity, float)
        if case.loads is not None:
            found[f"case {name} factor"] = np.array(list(case.loads.values()), float)
    return found


def _prescribed(model: WholeModel, index: Mapping[str, int], rows: Rows) -> NDArray[np.bool_]:
    """Flat coordinates that are held or driven."""
    found = np.zeros((len(index), 3), np.bool_)
    found[:, model.dim :] = True
    for name, axes in model.fixed.items():
        found[index[name], [AXIS[axis] for axis in axes]] = True
    if scalars := [i for i, node in enumerate(model.nodes.values()) if node.scalar]:
        found[scalars, 1:] = True
    flat = found.reshape(-1)
    flat[rows.fields["coordinate_drive"][:, 0]] = True
    return flat


def arrays_at(joined: Joined, numbers: Numbers) -> dict[str, Any]:
    """Arrays of `System` by name from the structure of a model and its numbers, complex ones and copies too."""
    count, dim = numbers["lump"].shape[-1], joined.dim
    x0, velocity0, gravity = numbers.full(count, 3), numbers.full(count, 3), numbers.full(3)
    own = numbers.full(count, 3, value=np.nan)
    x0[..., :dim], gravity[..., :dim] = numbers["place"], numbers["gravity"]
    velocity0[..., joined.moving, :dim] = numbers["velocity"]
    own[..., joined.weighed, :] = 0.0
    own[..., joined.weighed, :dim] = numbers["own_gravity"]
    p, q = joined.fields["p"], joined.fields["q"]
    found = member_arrays(joined.members, numbers, size(x0[..., q, :] - x0[..., p, :]))
    found |= pair_arrays(joined.bodies, numbers, x0) | measure_arrays(joined.measures, numbers, x0)
    found |= row_arrays(joined.rows, numbers, x0, (p, q), found["length0"], found["measure_start"])
    loads = {name: numbers[name] for name in joined.loads}
    loads |= centers_of(joined.bodies, numbers)
    nodes = {
        "element_numbers": {name: numbers[name] for name in joined.elements},
        "load_numbers": loads,
        "x0": x0,
        "lump": numbers["lump"],
        "own_gravity": own,
        "gravity": gravity,
        "velocity0": velocity0,
    }
    return joined.fields | found | nodes | {"continua": continua_at(joined.sheets, numbers, x0)}
