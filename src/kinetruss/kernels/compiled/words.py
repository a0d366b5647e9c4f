"""Arguments of kernels as plain words, numbers and addresses of arrays; and arrays on memory that somebody else keeps.

A kind knows the words of an argument, in Numba's types and those of C; which types of Numba it takes; the words of a value; and
the text that makes the argument of the names of words.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, Protocol, get_args, get_type_hints

import numba
import numpy as np
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic as _intrinsic
from numpy.typing import NDArray

from kinetruss.kernels.compiled.record import Record

U1 = Annotated[NDArray[np.uint32], None, 1]
U2 = Annotated[NDArray[np.uint32], None, 2]
B2 = Annotated[NDArray[np.bool_], None, 2]
"""Arrays that no record has."""

Words = list[tuple[Any, Any]]
_NUMBERS: dict[Any, tuple[Any, Any]] = {
    int: (types.int64, ctypes.c_int64),
    float: (types.float64, ctypes.c_double),
    type(None): (types.void, None),
}


class Kind(Protocol):
    """How an argument is handed over."""

    words: Words

    def takes(self, given: Any) -> bool:
        """Whether an argument of a type of Numba is of this kind."""

    def values(self, context: Any, builder: Any, given: Any, value: Any) -> list[Any]:
        """The words of a value."""

    def text(self, names: Iterator[str], parts: dict[str, Any]) -> str:
        """What makes it again of the next names of words; what the text needs is put into parts."""


def kind_of(hint: Any) -> Kind:
    """The kind of an annotation."""
    if hint in _NUMBERS:
        return Number([_NUMBERS[hint]])
    if isinstance(hint, type) and issubclass(hint, Record):
        return Members(hint, [Array(np.int64, 1), Array(np.float64, 1)])
    if isinstance(hint, type) and hasattr(hint, "_fields"):
        return Members(hint, [kind_of(one) for one in get_type_hints(hint, include_extras=True).values()])
    scalar, _, axes = get_args(hint)
    while within := get_args(scalar):  # NDArray names its scalar in a dtype, from NumPy 2.5 on itself
        scalar = within[-1]
    return Array(scalar, axes)


def number_of(hint: Any) -> tuple[Any, Any]:
    """What a kernel returns, in types of Numba and of C."""
    return _NUMBERS[hint]


@dataclass
class Number:
    """A number, or nothing."""

    words: Words

    def takes(self, given: Any) -> bool:
        """Whole numbers stand for reals, not the other way round."""
        return isinstance(given, types.Integer | types.Boolean) or given == self.words[0][0]

    def values(self, context: Any, builder: Any, given: Any, value: Any) -> list[Any]:
        """One word."""
        return [context.cast(builder, value, given, self.words[0][0])]

    def text(self, names: Iterator[str], parts: dict[str, Any]) -> str:  # noqa: ARG002
        """As it is."""
        return next(names)


class Array:
    """A contiguous array of one or two axes: its address and its shape."""

    def __init__(self, dtype: Any, axes: int) -> None:
        self.dtype, self.axes = numba.from_dtype(np.dtype(dtype)), axes
        self.words: Words = [(types.CPointer(self.dtype), ctypes.c_void_p), *[_NUMBERS[int]] * axes]

    def takes(self, given: Any) -> bool:
        """An array of this type."""
        return isinstance(given, types.Array) and (given.dtype, given.ndim, given.layout) == (self.dtype, self.axes, "C")

    def values(self, context: Any, builder: Any, given: Any, value: Any) -> list[Any]:
        """Address and shape."""
        array = context.make_array(given)(context, builder, value)
        return [array.data, *(builder.extract_value(array.shape, k) for k in range(self.axes))]

    def text(self, names: Iterator[str], parts: dict[str, Any]) -> str:
        """An array at this address."""
        parts["array_at"], parts["matrix_at"] = array_at, matrix_at
        return f"{'array_at' if self.axes == 1 else 'matrix_at'}({', '.join(next(names) for _ in range(1 + self.axes))})"


class Members:
    """A record or a named tuple: what is in it, one behind the other."""

    def __init__(self, made: type, kinds: list[Kind]) -> None:
        self.made, self.kinds = made, kinds
        self.words: Words = [word for one in kinds for word in one.words]

    def takes(self, given: Any) -> bool:
        """One of the same class: another record has its fields in other places."""
        same = getattr(given, "instance_class", None) is self.made
        return same and all(kind.takes(one) for kind, one in zip(self.kinds, given.types, strict=True))

    def values(self, context: Any, builder: Any, given: Any, value: Any) -> list[Any]:
        """The words of all."""
        found: list[Any] = []
        for k, (kind, one) in enumerate(zip(self.kinds, given.types, strict=True)):
            found += kind.values(context, builder, one, builder.extract_value(value, k))
        return found

    def text(self, names: Iterator[str], parts: dict[str, Any]) -> str:
        """The class of the members."""
        parts[self.made.__name__] = self.made
        return f"{self.made.__name__}({', '.join(one.text(names, parts) for one in self.kinds)})"


# Arrays on memory that somebody else keeps: views without a reference count.

intrinsic: Any = _intrinsic  # its annotations are of the first of its two forms


def array_on(context: Any, builder: Any, result: Any, data: Any, shape: Any) -> Any:
    """A C-contiguous array of this type and shape on memory that somebody else keeps."""
    array = context.make_array(result)(context, builder)
    size = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(result.dtype)))
    strides = [size] if len(shape) == 1 else [builder.mul(shape[1], size), size]
    pack_array: Any = cgutils.pack_array
    context.populate_array(
        array, data=data, shape=pack_array(builder, shape), strides=pack_array(builder, strides), itemsize=size, meminfo=None
    )
    return array._getvalue()


@intrinsic
def view(typing_context: Any, array: Any, offset: Any, count: Any) -> Any:  # noqa: ARG001
    """array[offset:offset + count] without a reference count; counted from 0, it needs no look at the sign of an index."""
    result = types.Array(array.dtype, 1, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        whole = context.make_array(array)(context, builder, args[0])
        return array_on(context, builder, result, builder.gep(whole.data, [args[1]]), [args[2]])

    return result(array, types.int64, types.int64), codegen


@intrinsic
def array_at(typing_context: Any, pointer: Any, count: Any) -> Any:  # noqa: ARG001
    """Array (count,) at an address."""
    result = types.Array(pointer.dtype, 1, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        return array_on(context, builder, result, args[0], [args[1]])

    return result(pointer, types.int64), codegen


@intrinsic
def matrix_at(typing_context: Any, pointer: Any, rows: Any, columns: Any) -> Any:  # noqa: ARG001
    """Array (rows, columns) at an address."""
    result = types.Array(pointer.dtype, 2, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        return array_on(context, builder, result, args[0], [args[1], args[2]])

    return result(pointer, types.int64, types.int64), codegen
