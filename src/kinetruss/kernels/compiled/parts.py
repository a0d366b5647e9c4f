"""Many named arrays in two buffers, one of integers and one of reals, so that records of them are cheap to hand around.

A compiled function that takes a record of eighty arrays takes 560 words, and seconds to compile; one that takes two buffers
does not. A part is a view without a reference count: it lives as long as its buffer. The first integers of a record are its
table: offset, rows and columns of every part, in the order of the names.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic as _intrinsic
from numpy.typing import NDArray

__all__ = ["array_at", "grid", "integers", "intrinsic", "matrix", "pack", "stretch", "unpack", "vector"]

intrinsic: Any = _intrinsic  # its annotations are of the first of its two forms


def _array_on(context: Any, builder: Any, result: Any, data: Any, shape: Any) -> Any:
    """A C-contiguous array of this type and shape on memory that somebody else keeps."""
    array = context.make_array(result)(context, builder)
    size = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(result.dtype)))
    strides = [size] if len(shape) == 1 else [builder.mul(shape[1], size), size]
    pack_array: Any = cgutils.pack_array
    context.populate_array(
        array, data=data, shape=pack_array(builder, shape), strides=pack_array(builder, strides), itemsize=size, meminfo=None
    )
    return array._getvalue()


def _part_of(record: Any, buffer: int, axes: int) -> Any:
    """Type and code of a part with one or two axes on one of the two buffers of a record."""
    result = types.Array(record.types[buffer].dtype, axes, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        ints, kept = (
            context.make_array(record.types[k])(context, builder, builder.extract_value(args[0], k)) for k in (0, buffer)
        )
        three, one = args[1].type(3), args[1].type(1)
        place, table = builder.mul(args[1], three), []
        for _ in range(1 + axes):
            table.append(builder.load(builder.gep(ints.data, [place])))
            place = builder.add(place, one)
        return _array_on(context, builder, result, builder.gep(kept.data, [table[0]]), table[1:])

    return result(record, types.int64), codegen


@intrinsic
def integers(typing_context, record, part):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """Part (rows,) of integers."""
    return _part_of(record, 0, 1)


@intrinsic
def grid(typing_context, record, part):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """Part (rows, columns) of integers."""
    return _part_of(record, 0, 2)


@intrinsic
def vector(typing_context, record, part):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """Part (rows,) of reals."""
    return _part_of(record, 1, 1)


@intrinsic
def matrix(typing_context, record, part):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """Part (rows, columns) of reals."""
    return _part_of(record, 1, 2)


@intrinsic
def stretch(typing_context, array, offset, count):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """array[offset:offset + count] without a reference count; counted from 0, it needs no look at the sign of an index."""
    result = types.Array(array.dtype, 1, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        whole = context.make_array(array)(context, builder, args[0])
        return _array_on(context, builder, result, builder.gep(whole.data, [args[1]]), [args[2]])

    return result(array, types.int64, types.int64), codegen


@intrinsic
def array_at(typing_context, pointer, count):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """Array (count,) at an address."""
    result = types.Array(pointer.dtype, 1, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        return _array_on(context, builder, result, args[0], [args[1]])

    return result(pointer, types.int64), codegen


def pack(names: tuple[str, ...], arrays: Mapping[str, NDArray[Any]]) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """The two buffers of arrays (at most two dimensions) in the order of the names; booleans and integers are integers."""
    table = np.zeros((len(names), 3), np.int64)
    ints, reals = [table.reshape(-1)], [np.zeros(0)]
    sizes = {True: table.size, False: 0}
    for k, name in enumerate(names):
        array = np.asarray(arrays[name])
        whole = array.dtype.kind in "bi"
        rows, columns = (*array.shape, 1)[:2]
        table[k] = sizes[whole], rows, columns
        sizes[whole] += array.size
        (ints if whole else reals).append(array.reshape(-1))
    return np.concatenate(ints).astype(np.int64), np.concatenate(reals).astype(float)


def unpack(record: Any, part: int, whole: bool, flat: bool) -> NDArray[Any]:
    """A part as a view for Python; writing to it writes to the record."""
    offset, rows, columns = record.ints[3 * part : 3 * part + 3]
    found: NDArray[Any] = (record.ints if whole else record.reals)[offset : offset + rows * columns]
    return found if flat else found.reshape(rows, columns)
