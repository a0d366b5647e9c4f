"""Calls, from within kernels, of compiled functions by their addresses."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core.errors import TypingError

from kinetruss.kernels.compiled.words import intrinsic

__all__ = ["caller"]


def caller(signature: Any) -> Any:
    """What kernels call with an address and a tuple of arguments; where the signature has a pointer, an array is given."""

    @intrinsic
    def call(typing_context: Any, address: Any, given: Any) -> Any:  # noqa: ARG001
        for wanted, one in zip(signature.args, given.types, strict=True):
            if wanted != one and not (isinstance(one, types.Array) and one.layout == "C" and wanted.dtype == one.dtype):
                raise TypingError(f"{wanted} is wanted here, not {one}.")

        def codegen(context: Any, builder: Any, made: Any, args: Any) -> Any:
            words = []
            for k, one in enumerate(made.args[1].types):
                value = builder.extract_value(args[1], k)
                words.append(context.make_array(one)(context, builder, value).data if isinstance(one, types.Array) else value)
            nothing = signature.return_type == types.void
            returned = ir.VoidType() if nothing else context.get_value_type(signature.return_type)
            form = ir.FunctionType(returned, [word.type for word in words])
            found = builder.call(builder.inttoptr(args[0], form.as_pointer()), words)
            return context.get_dummy_value() if nothing else found

        return signature.return_type(types.int64, given), codegen

    return call
