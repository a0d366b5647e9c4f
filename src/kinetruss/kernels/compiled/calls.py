"""Calls, from within kernels, of compiled functions by their addresses.

`caller` : of functions on plain arrays, whose text is made (kernels.coordinates.straight_line). `Interface` : of kernels on
records, each of another one: what calls them knows the buffers of a record, not its fields, and is compiled once for all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, get_type_hints

import numpy as np
from llvmlite import ir
from numba import types
from numba.core.ccallback import CFunc
from numba.core.errors import TypingError

from kinetruss.kernels.compiled.caches import Kept
from kinetruss.kernels.compiled.jit import HOT, keeper
from kinetruss.kernels.compiled.record import Record
from kinetruss.kernels.compiled.words import Array, Kind, intrinsic, kind_of, number_of

__all__ = ["Interface", "called", "caller", "entry_of", "function_of", "words_of"]


def called(context: Any, builder: Any, address: Any, words: list[Any], result: Any) -> Any:
    """What the function at an address returns for some words, in compiled code."""
    nothing = result == types.void
    form = ir.FunctionType(ir.VoidType() if nothing else context.get_value_type(result), [one.type for one in words])
    found = builder.call(builder.inttoptr(address, form.as_pointer()), words)
    return context.get_dummy_value() if nothing else found


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
            return called(context, builder, args[0], words, signature.return_type)

        return signature.return_type(types.int64, given), codegen

    return call


def function_of(text: str, names: dict[str, Any], function: Callable[..., Any]) -> Any:
    """The function of a text, in the module of another one."""
    names["__name__"] = function.__module__
    exec(text, names)  # noqa: S102 - Numba folds no *arguments
    return names[function.__name__]


def entry_of(function: Callable[..., Any], inner: Any, kinds: list[Kind], result: Any, form: str, **options: Any) -> Any:
    """The kernel `inner`, made of a function, with a C address and arguments of these kinds; kept as a form of the function."""
    plain = [word for one in kinds for word in one.words]
    words = [f"w{k}" for k in range(len(plain))]
    names: Iterator[str] = iter(words)
    parts: dict[str, Any] = {"kernel": inner}
    call = ", ".join(one.text(names, parts) for one in kinds)
    entry = function_of(f"def {function.__name__}({', '.join(words)}): return kernel({call})", parts, function)
    found: Any = CFunc(entry, (tuple(in_numba for in_numba, _ in plain), result), locals={}, options=HOT | options)
    found._cache = Kept(keeper, function, form)
    found.compile()
    return found


def words_of(context: Any, builder: Any, kinds: list[Kind], given: Any, value: Any) -> list[Any]:
    """The words of a tuple of arguments, in compiled code."""
    words: list[Any] = []
    for k, (kind, one) in enumerate(zip(kinds, given.types, strict=True)):
        words += kind.values(context, builder, one, builder.extract_value(value, k))
    return words


class Interface:
    """A decorator for what many kernels have in common: a function without content. Its first argument may be a `Record`, which
    is then of another class for each of them.

    `address` : of such a kernel, which is compiled when it is first asked for. `call` : in kernels, with an address and a tuple
    of the arguments; two for a record, its buffers.
    """

    def __init__(self, declared: Callable[..., Any]) -> None:
        hints = get_type_hints(declared, include_extras=True)
        self.name, (self.result, _) = declared.__name__, number_of(hints.pop("return"))
        kinds = list(hints.values())
        self.of_record = kinds[0] is Record
        self.others = [kind_of(one) for one in kinds[self.of_record :]]
        self._compiled: dict[Any, Any] = {}
        self.call = self._call()

    def address(self, kernel: Any) -> int:
        """The address of a kernel."""
        function = getattr(kernel, "py_func", kernel)
        if function not in self._compiled:
            first, *_ = get_type_hints(function, include_extras=True).values()
            kinds = [*([kind_of(first)] if self.of_record else []), *self.others]
            self._compiled[function] = entry_of(function, kernel, kinds, self.result, f"interface {self.name}", _nrt=True)
        return int(self._compiled[function].address)

    def _call(self) -> Any:
        kinds = [*([Array(np.int64, 1), Array(np.float64, 1)] if self.of_record else []), *self.others]
        result, name = self.result, self.name

        @intrinsic
        def call(typing_context: Any, address: Any, given: Any) -> Any:  # noqa: ARG001
            for kind, one in zip(kinds, given.types, strict=True):
                if not kind.takes(one):
                    raise TypingError(f"{name} takes {kind}, not {one}.")

            def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
                return called(context, builder, args[0], words_of(context, builder, kinds, signature.args[1], args[1]), result)

            return result(types.int64, given), codegen

        return call
