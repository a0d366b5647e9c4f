"""Kernels are drafts, kept on disk and linked into what calls them, and Python calls their entries."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numba
import numpy as np
import pytest
from numba.core.errors import TypingError

from kinetruss.kernels.compiled.drafts import DraftCompiler
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline

TWICE = """
import json, sys
from pathlib import Path
import numba
from kinetruss.kernels.compiled.caches import Keeper, Kept
from kinetruss.kernels.compiled.drafts import DRAFT, DraftCompiler, rebuilt
def twice(a):
    return a + a
inner = numba.njit(pipeline_class=DraftCompiler, no_cpython_wrapper=True, no_cfunc_wrapper=True)(twice)
inner._cache = Kept(Keeper({"<string>": "s" * 16}, [Path(sys.argv[1])]), twice, DRAFT, rebuilt)
more = float(sys.argv[2])
@numba.njit
def outer(a):
    return inner(a) + more
print(json.dumps({"found": outer(21.0), "hits": sum(inner.stats.cache_hits.values())}))
"""


def process(place: Path, more: float) -> dict[str, float]:
    done = subprocess.run([sys.executable, "-c", TWICE, str(place), str(more)], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return json.loads(done.stdout)


@pytest.mark.slow
def test_a_draft_of_one_process_is_part_of_a_kernel_of_another(tmp_path):
    assert process(tmp_path, 1.0) == {"found": 43.0, "hits": 0}
    assert len(list(tmp_path.glob("*/*.kernel"))) == 1
    assert process(tmp_path, -2.0) == {"found": 40.0, "hits": 1}


@pytest.mark.slow
def test_a_draft_has_no_machine_code():
    inner = numba.njit(pipeline_class=DraftCompiler, no_cpython_wrapper=True, no_cfunc_wrapper=True)(lambda a: a * 2.0)

    @numba.njit
    def outer(a):
        return inner(a)

    assert outer(4.0) == 8.0
    (form,) = inner.overloads.values()
    engine = form.target_context.codegen()._engine
    assert not engine.is_symbol_defined(form.fndesc.llvm_func_name)
    (form,) = outer.overloads.values()
    assert engine.is_symbol_defined(form.fndesc.llvm_func_name)


@pytest.mark.parametrize("decorator", [kernel_bare, kernel_inline], ids=["bare", "inline"])
def test_known_and_unknown_numbers_are_one_form(decorator):
    @decorator
    def pick(y, i):
        return y[i]

    @numba.njit
    def outer(y, k):
        return pick(y, 0) + pick(y, 2) + pick(y, k) + pick(y, i=k)

    assert outer(np.array([1.0, 10.0, 100.0]), 1) == 121.0
    assert len(pick.overloads) == 1


@pytest.mark.slow
@pytest.mark.parametrize("used", [False, True], ids=["new", "used"])
def test_python_calls_the_entry_of_a_kernel(used):
    @kernel_bare
    def half(a):
        return 0.5 * a

    @numba.njit
    def outer(a):
        return half(a)

    if used:
        assert outer(3.0) == 1.5
    for kind in (float, complex, int, float):
        assert half(kind(3)) == 1.5
    assert (len(half.overloads), len(half.entry.overloads)) == (3, 3)
    with pytest.raises(TypeError):
        half()
    with pytest.raises(TypingError):
        half("three")


@pytest.mark.slow
def test_a_kernel_of_arrays_gives_back_arrays():
    @kernel
    def doubled(a):
        return a + a

    given = np.arange(3.0)
    assert np.array_equal(doubled(given), 2 * given)
    assert np.array_equal(doubled(given[::-1]), 2 * given[::-1])
    assert len(doubled.entry.overloads) == 2


CHANGED = """
import json, sys
import numba
from numba.core import codegen
numba.__version__ = "99.0.0"
{change}
import numpy as np
from kinetruss.kernels.compiled import jit
from kinetruss.kernels.structure.lengths import lengths
x = np.zeros((1, 6)); x[0, 3:] = (3.0, 4.0, 12.0)
out = [np.zeros((1, 1)) for _ in range(3)]
lengths(np.array([0]), np.array([1]), x, 0 * x, 0 * x, *out)
print(json.dumps({{"drafts": jit.DRAFTS, "found": out[0][0, 0], "hits": sum(lengths.entry.stats.cache_hits.values())}}))
"""
CHANGES = {
    "nothing": "",
    "a name": "del codegen.JITCodeLibrary",
    "a class": "def refused(cls): raise TypeError('final')\ncodegen.JITCodeLibrary.__init_subclass__ = classmethod(refused)",
    "a method": """
finalize = codegen.JITCodeLibrary._finalize_dynamic_globals
def changed(self):
    if type(self) is not codegen.JITCodeLibrary:
        raise AttributeError("_finalize_dynamic_globals")
    finalize(self)
codegen.JITCodeLibrary._finalize_dynamic_globals = changed""",
}


@pytest.mark.slow
@pytest.mark.parametrize("change", CHANGES)
def test_where_the_inside_of_numba_is_another_kernels_are_compiled_as_numba_does(change, tmp_path):
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    command = [sys.executable, "-c", CHANGED.format(change=CHANGES[change])]
    for hits in (0, 1):
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert json.loads(done.stdout) == {"drafts": change == "nothing", "found": 13.0, "hits": hits}
