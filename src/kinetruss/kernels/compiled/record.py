"""Records: many named arrays in two buffers, one of integers and one of reals, declared once.

    @record
    class Equations(Record):
        free: I1        # (rows,) of integers
        mass: F2        # (rows, columns) of reals

Kernels, Python and type checkers read the fields by name: ``eq.mass[k, 1]``. A compiled function that takes a record of eighty
arrays would take 560 words, and seconds to compile; one that takes two buffers does not. A field is a view without a reference
count: it lives as long as its buffer. The first integers of a record are its table: offset, rows and columns of every field, in
the order of the declaration. So a kernel holds the order of all fields that it reads: its file imports the record, and is
compiled anew when the declaration changes (kernels.compiled.caches).
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Mapping
from typing import Annotated, Any, NamedTuple, Self, TypeVar, cast, get_type_hints

import numpy as np
from numba.core import types
from numba.core.typing.templates import AttributeTemplate
from numba.core.typing.templates import infer_getattr as _infer_getattr
from numba.cpython.tupleobj import namedtuple_getattr
from numba.extending import lower_getattr as _lower_getattr
from numpy.typing import NDArray

from kinetruss.kernels.compiled.parts import array_on

__all__ = ["F1", "F2", "I1", "I2", "Record", "record"]


class Field(NamedTuple):
    """place : in the table. buffer : 0 of integers, 1 of reals. axes : 1 or 2."""

    place: int
    buffer: int
    axes: int


I1 = Annotated[NDArray[np.int64], 0, 1]
I2 = Annotated[NDArray[np.int64], 0, 2]
F1 = Annotated[NDArray[np.float64], 1, 1]
F2 = Annotated[NDArray[np.float64], 1, 2]

infer_getattr: Any = _infer_getattr
lower_getattr: Any = _lower_getattr


class Record:
    """Base of all records. ints, reals : the buffers."""

    __slots__ = ()
    FIELDS: Mapping[str, Field]
    ints: NDArray[np.int64]
    reals: NDArray[np.float64]

    def __new__(cls, ints: NDArray[np.int64], reals: NDArray[np.float64]) -> Self:
        """A record on buffers that are laid out already."""
        make: Any = tuple.__new__
        return cast("Self", make(cls, (ints, reals)))

    def place_of(self, name: str) -> slice:
        """Where a field stands in its buffer."""
        offset, rows, columns = self.ints[3 * self.FIELDS[name].place :][:3]
        return slice(int(offset), int(offset + rows * columns))

    @classmethod
    def of(cls, arrays: Mapping[str, NDArray[Any]]) -> Self:
        """The record of named arrays; booleans count as integers."""
        table = np.zeros((len(cls.FIELDS), 3), np.int64)
        kept: tuple[list[NDArray[Any]], ...] = [table.reshape(-1)], [np.zeros(0)]
        sizes = [table.size, 0]
        for name, (place, buffer, _) in cls.FIELDS.items():
            array = np.asarray(arrays[name])
            rows, columns = (*array.shape, 1)[:2]
            table[place] = sizes[buffer], rows, columns
            sizes[buffer] += array.size
            kept[buffer].append(array.reshape(-1))
        return cls(np.concatenate(kept[0]).astype(np.int64), np.concatenate(kept[1]).astype(float))

    @classmethod
    def zeros(cls, shapes: Mapping[str, tuple[int, ...]]) -> Self:
        """A record of zeros of these shapes; fields that are not named are empty."""
        return cls.of({name: np.zeros(shapes.get(name, (0, 0)[: field.axes])) for name, field in cls.FIELDS.items()})


Pair = namedtuple("Pair", ("ints", "reals"))
"""The two buffers, as Numba knows them; `Record` gives their types."""
T = TypeVar("T", bound=Record)


def record(cls: type[T]) -> type[T]:
    """Make the class a record whose fields are its annotations `name: I1 | I2 | F1 | F2`."""
    hints = get_type_hints(cls, include_extras=True)
    fields = {name: Field(k, *hints[name].__metadata__) for k, name in enumerate(cls.__annotations__)}
    body = {name: value for name, value in vars(cls).items() if name not in ("__dict__", "__weakref__", "__annotations__")}
    body |= {name: property(_view(field)) for name, field in fields.items()}
    made = type(cls.__name__, (Record, Pair), body | {"__slots__": (), "FIELDS": fields})
    for name in fields:
        _lower(name)
    return cast("type[T]", made)


def _view(field: Field) -> Any:
    """A field as a view for Python; writing to it writes to the record."""

    def read(self: Record) -> NDArray[Any]:
        offset, rows, columns = self.ints[3 * field.place : 3 * field.place + 3]
        found: NDArray[Any] = (self.reals if field.buffer else self.ints)[offset : offset + rows * columns]
        return found if field.axes == 1 else found.reshape(rows, columns)

    return read


def _field_of(pair: Any, name: str) -> Field | None:
    """The field of a tuple's type, where it is a record that has one of this name."""
    found: Field | None = getattr(getattr(pair, "instance_class", None), "FIELDS", {}).get(name)
    return found


@infer_getattr
class _Fields(AttributeTemplate):
    """Types of fields in kernels."""

    key = types.BaseNamedTuple

    def generic_resolve(self, pair: Any, name: str) -> Any:  # type: ignore[override]
        field = _field_of(pair, name)
        return None if field is None else types.Array(pair.types[field.buffer].dtype, field.axes, "C")


_LOWERED: set[str] = set()


def _lower(name: str) -> None:
    """Code of the fields of a name, whatever record they are of."""
    if name in _LOWERED:
        return
    _LOWERED.add(name)

    @lower_getattr(types.BaseNamedTuple, name)
    def code(context: Any, builder: Any, pair: Any, value: Any) -> Any:
        field = _field_of(pair, name)
        if field is None:  # a plain named tuple
            return namedtuple_getattr(context, builder, pair, value, name)
        buffers = [
            context.make_array(kind)(context, builder, builder.extract_value(value, k)) for k, kind in enumerate(pair.types)
        ]
        ints, kept = buffers[0], buffers[field.buffer]
        at = [context.get_constant(types.intp, 3 * field.place + k) for k in range(1 + field.axes)]
        offset, *shape = (builder.load(builder.gep(ints.data, [place])) for place in at)
        result = types.Array(pair.types[field.buffer].dtype, field.axes, "C")
        return array_on(context, builder, result, builder.gep(kept.data, [offset]), shape)
