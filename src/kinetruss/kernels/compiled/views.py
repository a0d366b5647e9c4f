"""Arrays in kernels on memory that somebody else keeps: views without a reference count."""

from __future__ import annotations

from typing import Any

from numba import types
from numba.extending import intrinsic as _intrinsic

__all__ = ["array_on", "intrinsic", "view"]

intrinsic: Any = _intrinsic  # its annotations are of the first of its two forms


def array_on(context: Any, builder: Any, result: Any, data: Any, shape: Any) -> Any:
    """A C-contiguous array of this type and shape on memory that somebody else keeps."""
    array = context.make_array(result)(context, builder)
    size = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(result.dtype)))
    strides = [size] if len(shape) == 1 else [builder.mul(shape[1], size), size]
    context.populate_array(array, data=data, shape=shape, strides=strides, itemsize=size, meminfo=None)
    return array._getvalue()


@intrinsic
def view(typing_context: Any, array: Any, offset: Any, count: Any) -> Any:  # noqa: ARG001
    """array[offset:offset + count] without a reference count; counted from 0, it needs no look at the sign of an index."""
    result = types.Array(array.dtype, 1, "C")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ARG001
        whole = context.make_array(array)(context, builder, args[0])
        return array_on(context, builder, result, builder.gep(whole.data, [args[1]]), [args[2]])

    return result(array, types.int64, types.int64), codegen
