"""A kernel is a draft: the entry that Python calls inlines, optimises and translates it with all that it calls, at once.

Numba optimises each function by itself, translates it to machine code, and does both again, with all that it calls, for each
function above it. Of a kernel within others nobody ever runs that machine code; without it a first start takes half the time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from llvmlite import binding as llvm
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult, compile_result

__all__ = ["DraftCompiler", "rebuilt"]

DRAFT = "draft"


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
