"""Calls, from within kernels, of compiled functions by their addresses: what a model has no use for is never compiled.

`caller` : of functions on plain arrays, whose text is made (kernels.coordinates.straight_line). `Interface` : of kernels of
which a model has one or another, or several: kinds of elements, solvers, methods. `Apart` : of kernels that a model needs
or does not. Addresses stand in records, where Python puts those that it has compiled before: a model is known before it runs.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from functools import partial
from inspect import signature
from typing import Any, ClassVar, get_args, get_type_hints

import numba
import numpy as np
from llvmlite import ir
from numba import TypingError, types
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import compiled_at_address, kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import Record
from kinetruss.kernels.compiled.views import array_on, intrinsic

__all__ = ["Apart", "Interface", "caller"]

_INTS, _REALS = types.Array(types.int64, 1, "C"), types.Array(types.float64, 1, "C")
_Tuple: Any = types.BaseTuple


def _called(context: Any, builder: Any, address: Any, words: list[Any], result: Any) -> Any:
    """What the function at an address returns for some words, in compiled code."""
    nothing = result == types.void
    form = ir.FunctionType(ir.VoidType() if nothing else context.get_value_type(result), [one.type for one in words])
    found = builder.call(builder.inttoptr(address, form.as_pointer()), words)
    return context.get_dummy_value() if nothing else found


def caller(wanted: Any) -> Any:
    """What kernels call with an address and a tuple of arguments; where the signature has a pointer, an array is given."""

    @intrinsic
    def call(typing_context: Any, address: Any, given: Any) -> Any:  # noqa: ARG001
        for kind, one in zip(wanted.args, given.types, strict=True):
            if kind != one and not (isinstance(one, types.Array) and one.layout == "C" and kind.dtype == one.dtype):
                raise TypingError(f"{kind} is wanted here, not {one}.")

        def codegen(context: Any, builder: Any, made: Any, args: Any) -> Any:
            words = []
            for k, one in enumerate(made.args[1].types):
                value = builder.extract_value(args[1], k)
                words.append(context.make_array(one)(context, builder, value).data if isinstance(one, types.Array) else value)
            return _called(context, builder, args[0], words, wanted.return_type)

        return wanted.return_type(types.int64, given), codegen

    return call


def type_of(hint: Any) -> Any:
    """The type in kernels of an annotation: a number, a contiguous array, a record, a named tuple of these."""
    numbers = {int: types.int64, float: types.float64, type(None): types.void}
    if hint in numbers:
        return numbers[hint]
    if isinstance(hint, type) and issubclass(hint, Record):
        return _Tuple.from_types((_INTS, _REALS), hint)
    if isinstance(hint, type) and hasattr(hint, "_fields"):
        return _Tuple.from_types([type_of(one) for one in get_type_hints(hint, include_extras=True).values()], hint)
    scalar, _, axes = get_args(hint)
    while within := get_args(scalar):  # NDArray names its scalar in a dtype, from NumPy 2.5 on itself
        scalar = within[-1]
    return types.Array(numba.from_dtype(np.dtype(scalar)), axes, "C")


# An argument is handed over in words: a number; address and shape of an array; those of all members of a tuple.


def _takes(wanted: Any, given: Any) -> bool:
    """Whether an argument of a type may be given: another record has its fields in other places."""
    if isinstance(wanted, types.Array):
        return isinstance(given, types.Array) and (given.dtype, given.ndim, given.layout) == (wanted.dtype, wanted.ndim, "C")
    if isinstance(wanted, _Tuple):
        same = getattr(given, "instance_class", None) is wanted.instance_class
        return same and all(map(_takes, wanted.types, given.types))
    # whole numbers stand for reals, not the other way round
    return isinstance(given, types.Integer | types.Boolean) or given == wanted


def _types_of_words(wanted: Any) -> list[Any]:
    """The types of the words of an argument."""
    if isinstance(wanted, types.Array):
        return [types.CPointer(wanted.dtype), *[types.int64] * wanted.ndim]
    return [word for one in wanted.types for word in _types_of_words(one)] if isinstance(wanted, _Tuple) else [wanted]


def _words(context: Any, builder: Any, wanted: Any, given: Any, value: Any) -> list[Any]:
    """The words of an argument, in compiled code."""
    if isinstance(wanted, types.Array):
        array = context.make_array(given)(context, builder, value)
        return [array.data, *(builder.extract_value(array.shape, k) for k in range(wanted.ndim))]
    if isinstance(wanted, _Tuple):
        pairs = enumerate(zip(wanted.types, given.types, strict=True))
        return [word for k, pair in pairs for word in _words(context, builder, *pair, builder.extract_value(value, k))]
    return [context.cast(builder, value, given, wanted)]


def _argument(context: Any, builder: Any, wanted: Any, words: Iterator[Any]) -> Any:
    """The argument of the next words, in compiled code."""
    if isinstance(wanted, types.Array):
        return array_on(context, builder, wanted, next(words), [next(words) for _ in range(wanted.ndim)])
    if isinstance(wanted, _Tuple):
        return context.make_tuple(builder, wanted, [_argument(context, builder, one, words) for one in wanted.types])
    return next(words)


def _arguments_of(wanted: list[Any]) -> Any:
    """What makes a tuple of arguments of a tuple of words, in kernels."""
    result = types.Tuple(wanted)

    @intrinsic
    def arguments(typing_context: Any, words: Any) -> Any:  # noqa: ARG001
        def codegen(context: Any, builder: Any, made: Any, args: Any) -> Any:
            plain = (builder.extract_value(args[0], k) for k in range(len(made.args[0].types)))
            return _argument(context, builder, result, plain)

        return result(words), codegen

    return arguments


def _function_of(text: str, names: dict[str, Any], function: Callable[..., Any]) -> Any:
    """The function of a text, in the module of another one."""
    names["__name__"] = function.__module__
    exec(text, names)  # noqa: S102 - a function of as many words as there are has no other form
    return names[function.__name__]


class Interface:
    """A decorator for what many kernels have in common: a function without content. Its first argument may be a `Record`, which
    is then of another class for each of them.

    `address` : of such a kernel, which is compiled when it is first asked for. `call` : in kernels, with an address and a tuple
    of the arguments; two for a record, its buffers.
    """

    def __init__(self, declared: Callable[..., Any]) -> None:
        hints = get_type_hints(declared, include_extras=True)
        self.name, self.result = declared.__name__, type_of(hints.pop("return"))
        kinds = list(hints.values())
        self.of_record = kinds[0] is Record
        self.others = [type_of(one) for one in kinds[self.of_record :]]
        self._compiled: dict[Any, Any] = {}
        self._lock = threading.Lock()
        self.call = self._call()

    def address(self, kernel: Any) -> int:
        """The address of a kernel."""
        function = getattr(kernel, "py_func", kernel)
        with self._lock:  # of two that threads compile at once one would be lost, and what is at its address
            if function not in self._compiled:
                self._compiled[function] = self._entry(kernel, function)
            return int(self._compiled[function].address)

    def _entry(self, kernel: Any, function: Callable[..., Any]) -> Any:
        """A kernel with a C address and words as arguments."""
        wanted = self.others
        if self.of_record:
            first, *_ = get_type_hints(function, include_extras=True).values()
            wanted = [type_of(first), *wanted]
        words = [word for one in wanted for word in _types_of_words(one)]
        names = ", ".join(f"w{k}" for k in range(len(words)))
        text = f"def {function.__name__}({names}): return kernel(*arguments(({names},)))"
        entry = _function_of(text, {"kernel": kernel, "arguments": _arguments_of(wanted)}, function)
        kinds, form = self.result(*words), f"interface {self.name}"
        return compiled_at_address(entry, kinds, function, form, _nrt=kernel.targetoptions["_nrt"])

    def _call(self) -> Any:
        wanted, result, name = [*([_INTS, _REALS] if self.of_record else []), *self.others], self.result, self.name

        @intrinsic
        def call(typing_context: Any, address: Any, given: Any) -> Any:  # noqa: ARG001
            for kind, one in zip(wanted, given.types, strict=True):
                if not _takes(kind, one):
                    raise TypingError(f"{name} takes {kind}, not {one}.")

            def codegen(context: Any, builder: Any, made: Any, args: Any) -> Any:
                words = []
                for k, (kind, one) in enumerate(zip(wanted, made.args[1].types, strict=True)):
                    words += _words(context, builder, kind, one, builder.extract_value(args[1], k))
                return _called(context, builder, args[0], words, result)

            return result(types.int64, given), codegen

        return call


class Apart:
    """A decorator for kernels that a model needs together or not at all; whether one allocates (see kernels.compiled.jit).

    where : the field of the address of number {}, an expression of what they all take: "eq.sums[{}]". They are called as
    any other, and only where the field is filled, with `addresses`.
    """

    every: ClassVar[list[Apart]] = []

    def __init__(self, where: str) -> None:
        self.where, self._module, self._kernels = where, "", list[tuple[Interface, Any]]()
        Apart.every.append(self)

    def __call__(self, function: Callable[..., Any] | None = None, *, allocates: bool = False) -> Any:
        """The kernel of a function. Its arguments are annotated: numbers, contiguous arrays, records, named tuples of these."""
        if function is None:
            return partial(self, allocates=allocates)
        if self._kernels and function.__module__ != self._module:
            raise TypeError(f"{function.__name__} is not of {self._module}: places must not depend on what is imported first.")
        self._module = function.__module__
        inner = (kernel if allocates else kernel_bare)(function)
        if inner is function:  # compiling is switched off
            return function
        interface, given = Interface(function), ", ".join(signature(function).parameters)
        text = f"def {function.__name__}({given}): return call({self.where.format(len(self._kernels))}, ({given},))"
        self._kernels.append((interface, inner))
        return kernel_inline(_function_of(text, {"call": interface.call}, function))

    def addresses(self) -> NDArray[np.int64]:
        """Their addresses; they are compiled when these are first asked for."""
        return np.array([interface.address(inner) for interface, inner in self._kernels], np.int64)
