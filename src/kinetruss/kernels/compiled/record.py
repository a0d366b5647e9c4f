"""Records: many named arrays in two buffers, one of integers and one of reals, declared once.

    @record
    class Equations(Record):
        free: I1        # (rows,) of integers
        mass: F2        # (rows, columns) of reals
        steps: I0       # one integer, and F0 one real: both can be set

Kernels, Python and type checkers read the fields by name: ``eq.mass[k, 1]``, ``eq.steps += 1``. A compiled function that takes
a record of eighty arrays would take 560 words, and seconds to compile; one that takes two buffers does not. A field is a view
without a reference count: it lives as long as its buffer.

    ints     table (offset, rows and columns of every array), single integers, arrays of integers
    reals    single reals, arrays of reals

All are in the order of the declaration, in which numbers come before arrays. A record that is declared on another has the
fields of both, and kernels of the other take it too. A kernel holds the places of the fields that it reads; it is compiled anew
when the declaration changes (kernels.compiled.caches). What kernels make of fields is in kernels.compiled.fields: a record
itself needs no compiler.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable, Mapping
from typing import Annotated, Any, NamedTuple, Self, TypeVar, cast, get_type_hints

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "B2",
    "F0",
    "F1",
    "F2",
    "I0",
    "I1",
    "I2",
    "NAMES",
    "Field",
    "Flags",
    "Floats",
    "Ints",
    "Record",
    "U1",
    "U2",
    "Vector",
    "on_declaration",
    "record",
]

NAMES: set[str] = set()
"""Of all fields of all records."""
_WAITING: list[Callable[[str], None]] = []


def on_declaration(report: Callable[[str], None]) -> None:
    """Call a function with the name of every field, of those declared already and of those to come."""
    for name in NAMES:
        report(name)
    _WAITING.append(report)


def declared(name: str) -> None:
    """A field of this name is declared."""
    if name not in NAMES:
        NAMES.add(name)
        for report in _WAITING:
            report(name)


class Field(NamedTuple):
    """place : of an array in the table, of a number in its buffer. buffer : 0 of integers, 1 of reals. axes : 0, 1 or 2."""

    place: int
    buffer: int
    axes: int


class Count(NamedTuple):
    """How many arrays, single integers and single reals a record has."""

    arrays: int
    integers: int
    reals: int


I0 = Annotated[int, 0, 0]
F0 = Annotated[float, 1, 0]
I1 = Annotated[NDArray[np.int64], 0, 1]
I2 = Annotated[NDArray[np.int64], 0, 2]
F1 = Annotated[NDArray[np.float64], 1, 1]
F2 = Annotated[NDArray[np.float64], 1, 2]
U1 = Annotated[NDArray[np.uint32], None, 1]
U2 = Annotated[NDArray[np.uint32], None, 2]
B2 = Annotated[NDArray[np.bool_], None, 2]
"""Arrays that no record has."""
Floats = NDArray[np.float64]
Ints = NDArray[np.integer[Any]]
Flags = NDArray[np.bool_]
"""Arrays of any number of axes and, of integers, any size: no record has such."""
Vector = tuple[float, float, float]
"""Three components, kept in registers."""


class Record:
    """Base of all records. ints, reals : the buffers."""

    __slots__ = ()
    FIELDS: Mapping[str, Field]
    COUNT: Count
    ints: NDArray[np.int64]
    reals: NDArray[np.float64]

    def __new__(cls, ints: NDArray[np.int64], reals: NDArray[np.float64]) -> Self:
        """A record on buffers that are laid out already."""
        make: Any = tuple.__new__
        return cast("Self", make(cls, (ints, reals)))

    def place_of(self, name: str) -> slice:
        """Where an array stands in its buffer."""
        offset, rows, columns = self.ints[3 * self.FIELDS[name].place :][:3]
        return slice(int(offset), int(offset + rows * columns))

    def copy(self) -> Self:
        """The same record on buffers of its own."""
        return type(self)(self.ints.copy(), self.reals.copy())

    def clear_numbers(self) -> None:
        """Put all numbers to zero."""
        arrays, integers, reals = self.COUNT
        self.ints[3 * arrays : 3 * arrays + integers] = 0
        self.reals[:reals] = 0.0

    @classmethod
    def of(cls, arrays: Mapping[str, Any]) -> Self:
        """The record of named numbers and arrays; booleans count as integers."""
        table = np.zeros((cls.COUNT.arrays, 3), np.int64)
        kept: tuple[list[NDArray[Any]], ...] = [table.reshape(-1)], [np.zeros(0)]
        sizes = [table.size, 0]
        for name, (place, buffer, axes) in cls.FIELDS.items():
            array = np.asarray(arrays[name])
            if axes:
                rows, columns = (*array.shape, 1)[:2]
                table[place] = sizes[buffer], rows, columns
            sizes[buffer] += array.size
            kept[buffer].append(array.reshape(-1))
        return cls(np.concatenate(kept[0]).astype(np.int64), np.concatenate(kept[1]).astype(float))

    @classmethod
    def zeros(cls, shapes: Mapping[str, tuple[int, ...]]) -> Self:
        """A record of zeros of these shapes; fields that are not named are empty."""
        table = np.zeros((cls.COUNT.arrays, 3), np.int64)
        sizes = [table.size, 0]
        for name, (place, buffer, axes) in cls.FIELDS.items():
            rows, columns = (*shapes.get(name, (0, 0)[:axes]), 1, 1)[:2]
            if axes:
                table[place] = sizes[buffer], rows, columns
            sizes[buffer] += rows * columns
        ints, reals = np.zeros(sizes[0], np.int64), np.zeros(sizes[1])
        ints[: table.size] = table.reshape(-1)
        return cls(ints, reals)

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Copies of all fields by name; a number is an array without axes."""
        return {name: np.array(getattr(self, name), (np.int64, float)[field.buffer]) for name, field in self.FIELDS.items()}

    def with_(self, **arrays: NDArray[Any]) -> Self:
        """A record with some fields changed; they may have another size."""
        return self.of(self.arrays() | arrays)


Pair = namedtuple("Pair", ("ints", "reals"))
"""The two buffers, as Numba knows them; `Record` gives their types."""
T = TypeVar("T", bound=Record)


def record(cls: type[T]) -> type[T]:
    """Make the class a record whose fields are its annotations `name: I0 | F0 | I1 | I2 | F1 | F2`, numbers first."""
    hints, base = get_type_hints(cls, include_extras=True), cls.__bases__[0]
    forms = [(name, *hints[name].__metadata__) for name in cls.__annotations__]
    inherited = [(name, field.buffer, field.axes) for name, field in getattr(base, "FIELDS", {}).items()]
    if sorted(forms, key=_is_array) != forms:
        raise TypeError(f"{cls.__name__} declares a number behind an array. Put numbers first.")
    forms = sorted([*inherited, *forms], key=_is_array)
    count = Count(*(sum(map(wanted, forms)) for wanted in (_is_array, lambda f: f[1:] == (0, 0), lambda f: f[1:] == (1, 0))))
    following = {(True, 0): 0, (True, 1): 0, (False, 0): 3 * count.arrays, (False, 1): 0}
    fields = {}
    for name, buffer, axes in forms:
        kind = (True, 0) if axes else (False, buffer)
        fields[name] = Field(following[kind], buffer, axes)
        following[kind] += 1
    body = {name: value for name, value in vars(cls).items() if name not in ("__dict__", "__weakref__", "__annotations__")}
    body |= {name: _view(field) for name, field in fields.items()} | {"FIELDS": fields, "COUNT": count, "__slots__": ()}
    made = type(cls.__name__, (base,) if inherited else (Record, Pair), body)
    for name in fields:
        declared(name)
    return cast("type[T]", made)


def _is_array(form: tuple[str, int, int]) -> bool:
    return form[2] > 0


def _view(field: Field) -> property:
    """A field for Python: a number, or a view; writing to it writes to the record."""
    place, buffer, axes = field

    def number(self: Record) -> Any:
        return (self.reals if buffer else self.ints).item(place)

    def set_number(self: Record, value: float) -> None:
        (self.reals if buffer else self.ints)[place] = value

    def array(self: Record) -> NDArray[Any]:
        offset, rows, columns = self.ints[3 * place : 3 * place + 3].tolist()
        found: NDArray[Any] = (self.reals if buffer else self.ints)[offset : offset + rows * columns]
        return found if axes == 1 else found.reshape(rows, columns)

    return property(array) if axes else property(number, set_number)
