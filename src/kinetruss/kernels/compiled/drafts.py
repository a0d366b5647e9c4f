"""A kernel is a draft: the entry that Python calls inlines, optimises and translates it with all that it calls, at once.

Numba optimises each function by itself, translates it to machine code, and does both again, with all that it calls, for each
function above it. Of a kernel within others nobody ever runs that machine code. A first start (bench/cold_start.py; Numba
0.68.1) takes some 23 s of processor time with drafts and 43 s without for `inverse`, 31 s and 71 s for `simulate`.

That is all that this file brings, and no other subclasses what is inside of Numba. Where its version is not one of those that
are known, and drafts do not work with it, kernels are compiled as Numba does it by itself (kernels.compiled.jit).
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from functools import partial
from inspect import signature
from typing import Any

import numba
from llvmlite import binding as llvm
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult, compile_result

__all__ = ["drafted", "rebuilt", "work"]

log = logging.getLogger("kinetruss.kernels")
DRAFT = "draft"
KNOWN = ((0, 63), (0, 69))
"""Versions of Numba that drafts were tried with: from the first to before the last."""


class Draft(JITCodeLibrary):
    """The code of a kernel and of what it calls, before it is optimised."""

    def finalize(self) -> None:
        """Link what it calls; optimise and translate nothing."""
        self._raise_if_finalized()
        for library in dict.fromkeys(self._linking_libraries):
            self._reload_init.update(library._reload_init)
            self._final_module.link_in(library._get_module_for_linking(), preserve=True)
        self._final_module.verify()
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:  # noqa: ARG002
        """It has no address."""
        self._ensure_finalized()
        return 0

    @property
    def codegen(self) -> Any:
        """What sets the environment of its machine code: nothing, as it has none."""
        return self

    def set_env(self, env_name: str, env: Any) -> None:
        """Nothing to set."""

    def serialize_using_object_code(self) -> tuple[str, str, bytes]:
        """To be kept on disk."""
        self._ensure_finalized()
        return self.name, DRAFT, self._get_module_for_linking().as_bitcode()


class DraftCompiler(Compiler):
    """Numba's compiler, with a draft as its library."""

    def compile_extra(self, func: Callable[..., Any]) -> Any:
        """Compile a function into a draft."""
        self.state.library = Draft(self.state.targetctx.codegen(), func.__qualname__)
        return super().compile_extra(func)


def rebuilt(context: Any, data: tuple[Any, ...]) -> Any:
    """What was compiled, from what was kept of it (`CompileResult._reduce`)."""
    (name, kind, code), fndesc, environment, signature, objectmode, lifted, annotation, reload_init, envs = data
    if kind != DRAFT:
        return CompileResult._rebuild(context, *data)
    library = Draft(context.codegen(), name)
    library._final_module = llvm.parse_bitcode(code)
    library._finalized = True
    return compile_result(
        target_context=context,
        typing_context=context.typing_context,
        library=library,
        environment=environment,
        entry_point=context.get_executable(library, fndesc, environment),
        fndesc=fndesc,
        type_annotation=annotation,
        signature=signature,
        objectmode=objectmode,
        lifted=lifted,
        reload_init=reload_init,
        referenced_envs=envs,
    )


def drafted(function: Callable[..., Any], options: dict[str, Any], keep: Callable[[Any, str], None]) -> Any:
    """A kernel that is a draft, with an entry for Python. keep : called with what keeps its forms, and a name for these."""
    draft: Any = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "pipeline_class": DraftCompiler}
    found: Any = numba.njit(nogil=True, **options, **draft)(function)
    keep(found, DRAFT)
    found.entry = None
    found._compile_for_args = partial(_entered, found, found._insert, partial(_entry, found, function, options, keep))
    found._insert = _nothing  # a draft has no address that Python could call
    return found


def _entry(found: Any, function: Callable[..., Any], options: dict[str, Any], keep: Callable[[Any, str], None]) -> Any:
    """What Python calls instead of a kernel: the call of it, compiled as a whole."""
    given, names = ", ".join(signature(function).parameters), {"kernel": found, "__name__": function.__module__}
    exec(f"def {function.__name__}({given}): return kernel({given})", names)  # noqa: S102 - Numba folds no *arguments
    made: Any = numba.njit(nogil=True, **options)(names[function.__name__])
    keep(made, "entry")
    return made


def _entered(found: Any, insert: Callable[..., None], entry: Callable[[], Any], *args: Any) -> Any:
    """The compiled entry of a kernel for these arguments; the next call with such finds it by itself."""
    found.entry = found.entry or entry()
    form = found.entry._compile_for_args(*args)
    insert([found.typeof_pyval(one)._code for one in args], form, False)
    return form


def _nothing(*_: Any) -> None:
    """No entry for Python."""


def work() -> bool:
    """Whether drafts work with this Numba: with versions that are known they do, with others two kernels are tried."""
    version = tuple(int(part) for part in numba.__version__.split(".")[:2])
    if KNOWN[0] <= version < KNOWN[1]:
        return True

    def half(x: float) -> float:
        return 0.5 * x

    def tried(x: float) -> float:
        return inner(x) + 1.0

    try:
        inner = drafted(half, {}, _nothing)
        return bool(drafted(tried, {}, _nothing)(3.0) == 2.5)
    except Exception as error:  # noqa: BLE001 - whatever has changed
        log.info("Numba %s compiles each kernel by itself: %s", numba.__version__, error)
        return False
