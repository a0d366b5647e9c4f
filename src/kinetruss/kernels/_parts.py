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
from numba.extending import intrinsic
from numpy.typing import NDArray

from kinetruss.kernels._jit import kernel_inner

__all__ = ["grid", "integers", "matrix", "pack", "stretch", "unpack", "vector"]


@intrinsic
def _view(typing_context, buffer, offset, rows, columns):  # type: ignore[no-untyped-def]  # noqa: ARG001
    """Array (rows, columns), or (rows,) where columns is None, on buffer[offset:]."""
    flat = isinstance(columns, types.NoneType)
    result = types.Array(buffer.dtype, 1 if flat else 2, "C")
    signature = result(buffer, types.int64, types.int64, columns if flat else types.int64)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        source = context.make_array(signature.args[0])(context, builder, args[0])
        array = context.make_array(result)(context, builder)
        size = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(result.dtype)))
        pack_array: Any = cgutils.pack_array
        shape = [args[2]] if flat else [args[2], args[3]]
        strides = [size] if flat else [builder.mul(args[3], size), size]
        context.populate_array(
            array, data=builder.gep(source.data, [args[1]]), shape=pack_array(builder, shape),
            strides=pack_array(builder, strides), itemsize=size, meminfo=None,
        )  # fmt: skip
        return array._getvalue()

    return signature, codegen


@kernel_inner
def stretch(array, offset, count):  # type: ignore[no-untyped-def]
    """array[offset:offset + count] without a reference count; counted from 0, it needs no look at the sign of an index."""
    return _view(array, offset, count, None)  # type: ignore[call-arg]


@kernel_inner
def integers(record, part):  # type: ignore[no-untyped-def]
    """Part (rows,) of integers."""
    return _view(record.ints, record.ints[3 * part], record.ints[3 * part + 1], None)  # type: ignore[call-arg]


@kernel_inner
def grid(record, part):  # type: ignore[no-untyped-def]
    """Part (rows, columns) of integers."""
    at = 3 * part
    return _view(record.ints, record.ints[at], record.ints[at + 1], record.ints[at + 2])  # type: ignore[call-arg]


@kernel_inner
def vector(record, part):  # type: ignore[no-untyped-def]
    """Part (rows,) of reals."""
    return _view(record.reals, record.ints[3 * part], record.ints[3 * part + 1], None)  # type: ignore[call-arg]


@kernel_inner
def matrix(record, part):  # type: ignore[no-untyped-def]
    """Part (rows, columns) of reals."""
    at = 3 * part
    return _view(record.reals, record.ints[at], record.ints[at + 1], record.ints[at + 2])  # type: ignore[call-arg]


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
