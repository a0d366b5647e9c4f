"""Kernels that are compiled when they are first called, from within others too: what a model has no use for costs no time.

A kernel that calls another is compiled with it. One that is late is reached by the address in a cell instead. At first that is
the address of a function in Python, which compiles the kernel, puts its address into the cell and calls it. All that is known
of it before are the types of its arguments, from its annotations. The cell is a symbol of the process, by whose name code that
was kept on disk finds it.
"""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import threading
import traceback
import warnings
from _thread import interrupt_main
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any, get_type_hints

import llvmlite.binding
import numba
from llvmlite import ir
from numba.core.errors import TypingError

from kinetruss.kernels.compiled.calls import called, entry_of, function_of, words_of
from kinetruss.kernels.compiled.jit import DRAFT, HOT, as_called, kernel, kernel_bare
from kinetruss.kernels.compiled.words import Kind, intrinsic, kind_of, number_of

__all__ = ["compile_late", "kernel_late"]

STOPPED = 70
"""Exit code where a kernel cannot be compiled while another waits for what it returns."""


def kernel_late(function: Callable[..., Any] | None = None, *, allocates: bool = False) -> Any:
    """A kernel that is compiled when it is first called; whether it allocates (see kernels.compiled.jit).

    Its arguments are annotated: records, arrays (I1, F1, F2, ...; contiguous), named tuples of these, int or float; and what it
    returns: int, float or None.
    """
    if function is None:
        return partial(kernel_late, allocates=allocates)
    inner = (kernel if allocates else kernel_bare)(function)
    if inner is function:  # compiling is switched off
        return function
    cell = _Cell(function, inner, {"_nrt": allocates})
    given = ", ".join(cell.kinds)
    caller = function_of(f"def {function.__name__}({given}): return call(({given},))", {"call": cell.call()}, function)
    made: Any = numba.njit(nogil=True, **(HOT | {"forceinline": True}), **DRAFT)(caller)
    made.get_call_template = partial(as_called, made.get_call_template)
    made._insert = inner._insert  # nothing: it has no address that Python could call
    made._compile_for_args = inner._compile_for_args  # there it is an ordinary kernel
    made.late = cell
    _CELLS.append(cell)  # what is at its addresses must stay
    return made


def compile_late() -> None:
    """Compile every late kernel of the modules that are imported."""
    for cell in _CELLS:
        cell.ready()


_CELLS: list[_Cell] = []


class _Cell:
    """Where the address of a late kernel stands. kinds : of its arguments by name; result : its type in Numba."""

    def __init__(self, function: Callable[..., Any], inner: Any, options: dict[str, Any]) -> None:
        self.function, self.inner, self.options = function, inner, options
        hints = get_type_hints(function, include_extras=True)
        self.result, result = number_of(hints.pop("return"))
        self.kinds: dict[str, Kind] = {name: kind_of(hint) for name, hint in hints.items()}
        self.words = [word for one in self.kinds.values() for word in one.words]
        self.form = ctypes.CFUNCTYPE(result, *(in_c for _, in_c in self.words))
        self.first = self.form(self._compiled)
        self.entry: Any = None
        self.lock = threading.Lock()
        self.symbol = f"{function.__module__}.{function.__name__}".replace(".", "_")
        self.address = ctypes.c_void_p(ctypes.cast(self.first, ctypes.c_void_p).value)
        llvmlite.binding.add_symbol(self.symbol, ctypes.addressof(self.address))

    def _compiled(self, *words: Any) -> Any:
        """What the cell holds the address of at first: compile, and call."""
        with _uninterrupted(), warnings.catch_warnings():
            warnings.simplefilter("default")  # as an error, a warning would not get past the kernel that waits
            try:
                self.ready()
            except BaseException:  # noqa: BLE001
                # a kernel waits for what this returns, and would take anything for it
                traceback.print_exc()
                sys.stderr.write(f"kinetruss: {self.symbol} cannot be compiled.\n")
                sys.stderr.flush()
                os._exit(STOPPED)
        return self.form(self.entry.address)(*words)

    def ready(self) -> None:
        """Compile the kernel, unless it is."""
        with self.lock:
            self.entry = self.entry or self._compile()
        self.address.value = self.entry.address

    def _compile(self) -> Any:
        """The kernel with a C address."""
        return entry_of(self.function, self.inner, list(self.kinds.values()), self.result, "late", **self.options)

    def call(self) -> Any:
        """What kernels call, with a tuple of the arguments."""
        symbol, result, kinds = self.symbol, self.result, list(self.kinds.values())

        @intrinsic
        def call(typing_context: Any, given: Any) -> Any:  # noqa: ARG001
            for kind, one in zip(kinds, given.types, strict=True):
                if not kind.takes(one):
                    raise TypingError(f"{symbol} takes {kind}, not {one}.")

            def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
                words = words_of(context, builder, kinds, signature.args[0], args[0])
                cell = builder.module.globals.get(symbol) or ir.GlobalVariable(builder.module, ir.IntType(64), symbol)
                return called(context, builder, builder.load(cell), words, result)

            return result(given), codegen

        return call


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Ctrl-C is heard when the kernel at work has returned: within a call from it, an exception would get lost."""
    if threading.current_thread() is not threading.main_thread() or signal.getsignal(signal.SIGINT) is None:
        yield
        return
    heard: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, _: heard.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if heard:
            threading.Timer(0.05, interrupt_main).start()
