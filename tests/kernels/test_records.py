"""Records: declared once, the same in Python and in kernels; kernels that read them are compiled anew with them."""

import ast
import inspect
from pathlib import Path
from typing import NamedTuple

import numba
import numpy as np
import pytest
from numba.core.registry import cpu_target

import kinetruss.kernels
from kinetruss.kernels.compiled.caches import Keeper, Kept
from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F0, F1, F2, I0, I1, I2, Record, record
from kinetruss.kernels.integrate.fixed_steps import Step
from kinetruss.kernels.integrate.state import Control, Memory, Work
from kinetruss.kernels.series.orders import SeriesWork
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.structure import Plan, Structure


@record
class Small(Record):
    """steps; t, s; ends (n,); pairs (n, 2); x (n,); table (n, 3)."""

    steps: I0
    t: F0
    ends: I1
    pairs: I2
    x: F1
    table: F2


@record
class More(Small):
    """Small, and turns; weight (n,)."""

    turns: I0
    weight: F1


class Plain(NamedTuple):
    """With a field of the name of one of `Small`."""

    x: np.ndarray


ARRAYS = {
    "steps": 3, "t": 0.5, "ends": np.array([4, 5]), "pairs": np.array([[1, 2], [3, 4], [5, 6]]), "x": np.array([0.25]),
    "table": np.arange(6.0).reshape(2, 3),
}  # fmt: skip


@kernel
def read_and_set(one, plain):
    one.steps += 1
    one.t = one.table[1, 2] + one.x[0] + one.pairs[2, 1] + one.ends[1] + plain.x[0]
    one.table[0, 0] = one.pairs.shape[0]
    return one.steps


@pytest.mark.slow
def test_kernels_and_python_see_the_same():
    one = Small.of(ARRAYS)
    for name, value in ARRAYS.items():
        assert np.array_equal(getattr(one, name), value)
    assert read_and_set(one, Plain(np.array([100.0]))) == one.steps == 4
    assert one.t == 5.0 + 0.25 + 6 + 5 + 100.0
    assert one.table[0, 0] == 3.0


@pytest.mark.slow
def test_a_record_on_another_has_the_fields_of_both():
    """Kernels of the one take the other, with its own places."""
    both = More.of(ARRAYS | {"turns": 7, "weight": np.array([2.0, 3.0])})
    assert isinstance(both, Small)
    assert read_and_set(both, Plain(np.array([100.0]))) == both.steps == 4
    assert (both.turns, both.t, both.weight.tolist()) == (7, 5.0 + 0.25 + 6 + 5 + 100.0, [2.0, 3.0])
    assert np.array_equal(both.ends, ARRAYS["ends"])
    assert both.x[0] == 0.25 and both.table[0, 0] == 3.0


def test_what_was_compiled_for_another_declaration_is_not_found():
    def declared(fields):
        return record(type("Same", (Record,), {"__annotations__": fields, "__module__": __name__}))

    codegen = cpu_target.target_context.codegen()
    kept = Kept(Keeper({"None": "state"}, []), read_and_set.py_func)
    names = {
        kept._name((numba.typeof(declared(fields).zeros({})),), codegen)
        for fields in ({"x": F1}, {"x": F1}, {"x": F1, "y": F1}, {"y": F1, "x": F1})
    }
    assert len(names) == 3


def test_views_write_to_the_record_and_copies_do_not():
    one = Small.of(ARRAYS)
    one.x[0], one.t, one.arrays()["table"][:] = 7.0, 8.0, -1.0
    assert (one.x[0], one.t, one.table[1, 2]) == (7.0, 8.0, 5.0)
    assert one.reals[one.place_of("x")] == 7.0


def test_a_field_may_take_another_size():
    one = Small.of(ARRAYS).with_(x=np.arange(4.0), steps=9)
    assert (one.steps, one.x.tolist(), one.t) == (9, [0.0, 1.0, 2.0, 3.0], 0.5)
    assert np.array_equal(one.pairs, ARRAYS["pairs"])


def test_all_numbers_are_put_to_zero_and_arrays_are_not():
    one = Small.of(ARRAYS)
    one.clear_numbers()
    assert (one.steps, one.t) == (0, 0.0)
    assert np.array_equal(one.table, ARRAYS["table"]) and np.array_equal(one.ends, ARRAYS["ends"])


def test_arrays_are_not_set_and_numbers_come_first():
    with pytest.raises(AttributeError):
        Small.of(ARRAYS).x = np.zeros(1)
    with pytest.raises(TypeError, match="Put numbers first"):

        @record
        class Wrong(Record):
            x: F1
            t: F0


RECORDS = (Control, Equations, Memory, Plan, Work, SeriesWork, Step, Structure, Workspace)
NAMES = {"control": Control, "eq": Equations, "memory": Memory, "plan": Plan, "step": Step, "ws": Workspace}
FILES = sorted(Path(inspect.getfile(kinetruss.kernels)).parent.rglob("*.py"))


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_a_kernel_that_reads_a_record_names_it(path):
    """The import of its type is what compiles a kernel anew when a declaration changes."""
    for function in ast.walk(ast.parse(path.read_text("utf-8"))):
        if not isinstance(function, ast.FunctionDef):
            continue
        read = {(node.value.id, node.attr) for node in ast.walk(function)
                if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)}  # fmt: skip
        for argument in function.args.args:
            kind = NAMES.get(argument.arg)
            if kind is not None and any(attribute in kind.FIELDS for name, attribute in read if name == argument.arg):
                assert argument.annotation is not None, f"line {function.lineno}: {function.name}({argument.arg})"
                assert ast.unparse(argument.annotation).strip("'") in {one.__name__ for one in RECORDS}
