"""Kernels that are compiled when they are first called."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from types import GenericAlias
from typing import Annotated, NamedTuple

import numpy as np
import pytest
from numba import float64
from numba.core.errors import TypingError

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1, F2, I0, Record, record
from kinetruss.kernels.compiled.words import U1, kind_of


@record
class Numbers(Record):
    """A record for tests."""

    count: I0
    a: F1
    m: F2


@record
class Others(Record):
    """The same fields in other places."""

    m: F2
    a: F1


class Both(NamedTuple):
    """A named tuple for tests."""

    numbers: Numbers
    places: U1


@kernel_late
def weighed(numbers: Numbers, x: F1, y: F2, scale: float, k: int) -> float:
    """Reads all that it is given, and writes."""
    total = scale * k + numbers.count
    for i in range(x.size):
        total += numbers.a[i] * x[i]
    y[1, 1] = total
    numbers.m[1, 0] = total
    return total


@kernel_late(allocates=True)
def picked(both: Both, x: F1) -> None:
    """Writes the a at the places into x."""
    found = np.empty(x.size)
    for i in range(x.size):
        found[i] = both.numbers.a[both.places[i]]
    x[:] = found


@kernel_bare
def outer(numbers, x, y, wanted):
    return weighed(numbers, x, y, 2, 3) if wanted else 0.0


@kernel
def through(numbers, places, x):
    picked(Both(numbers, places), x)


def numbers():
    return Numbers.of({"count": 5, "a": np.arange(3.0), "m": np.zeros((2, 2))})


@pytest.mark.slow
def test_it_is_compiled_when_it_is_first_called():
    one, x, y = numbers(), np.ones(3), np.zeros((2, 2))
    assert outer(one, x, y, False) == 0.0
    assert weighed.late.entry is None
    assert outer(one, x, y, True) == 2.0 * 3 + 5 + 3.0
    assert (y[1, 1], one.m[1, 0]) == (14.0, 14.0)
    entry = weighed.late.entry
    assert outer(one, 2 * x, y, True) == 17.0
    assert weighed.late.entry is entry


def test_python_calls_it_as_any_other():
    one, x, y = numbers(), np.ones(3), np.zeros((2, 2))
    assert weighed(one, x, y, 0.5, 2) == 9.0


@pytest.mark.slow
def test_named_tuples_and_whole_numbers_without_sign():
    x = np.zeros(2)
    through(numbers(), np.array([2, 1], np.uint32), x)
    assert x.tolist() == [2.0, 1.0]


@pytest.mark.parametrize(
    "array",
    [np.ndarray[tuple[int, ...], np.dtype[np.float64]], GenericAlias(np.ndarray, np.float64)],
    ids=["NumPy 2.4", "NumPy 2.5"],
)
def test_arrays_are_known_by_their_scalar_in_any_numpy(array):
    kind = kind_of(Annotated[array, None, 2])
    assert (kind.dtype, kind.axes) == (float64, 2)


@pytest.mark.parametrize(
    "given",
    [
        pytest.param(lambda: (numbers(), np.ones((3, 2))[:, 0], np.zeros((2, 2)), True), id="layout"),
        pytest.param(lambda: (numbers(), np.ones(3, np.float32), np.zeros((2, 2)), True), id="dtype"),
        pytest.param(lambda: (numbers(), np.ones(3), np.zeros(2), True), id="axes"),
        pytest.param(
            lambda: (Others.of({"m": np.zeros((2, 2)), "a": np.zeros(3)}), np.ones(3), np.zeros((2, 2)), True), id="record"
        ),
    ],
)
def test_other_arguments_are_refused_when_the_caller_is_compiled(given):
    with pytest.raises(TypingError, match="takes"):
        outer(*given())


def test_a_kernel_is_the_same_whoever_asks_for_it_first():
    """Numba gives a kernel what is not said of it from the one that calls it: an inlined one would make it inlined."""

    @kernel_bare
    def asked(x):
        return x[0] + 1.0

    @kernel_inline
    def asking(x):
        return asked(x)

    @kernel_bare
    def whole(x):
        return asking(x)

    assert whole(np.ones(1)) == 2.0
    (found,) = asked.overloads.values()
    module = found.library._final_module
    inlined = {one.name: any(b"alwaysinline" in flag for flag in one.attributes) for one in module.functions}
    assert [forced for name, forced in inlined.items() if "asked" in name] == [False]


@pytest.mark.slow
def test_threads_meet_one_kernel():
    @kernel_late
    def shared(x: F1) -> float:
        return x[0]

    @kernel_bare
    def caller(x):
        return shared(x)

    found: list[float] = []
    threads = [threading.Thread(target=lambda k=k: found.append(caller(np.full(1, float(k))))) for k in range(4)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert sorted(found) == [0.0, 1.0, 2.0, 3.0]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot send these signals to a process")
def test_ctrl_c_while_it_is_compiled_is_heard_behind_the_call(monkeypatch):
    @kernel_late
    def slow(x: F1) -> float:
        return 2.0 * x[0]

    @kernel_bare
    def caller(x, out):
        out[0] = slow(x)

    compiled = type(slow.late)._compile

    def interrupted(cell):
        os.kill(os.getpid(), signal.SIGINT)
        return compiled(cell)

    monkeypatch.setattr(type(slow.late), "_compile", interrupted)
    out = np.zeros(1)
    with pytest.raises(KeyboardInterrupt):
        caller(np.ones(1), out)
        assert out[0] == 2.0
        threading.Event().wait(5.0)
    assert out[0] == 2.0


BROKEN = """
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1
import numpy as np

@kernel_late
def broken(x: F1) -> float:
    return x.no_such_thing

@kernel_bare
def caller(x):
    return broken(x)

print(caller(np.ones(1)))
"""


@pytest.mark.slow
def test_what_cannot_be_compiled_never_gives_a_number(tmp_path: Path):
    (tmp_path / "broken.py").write_text(BROKEN)
    done = subprocess.run([sys.executable, tmp_path / "broken.py"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (70, "")
    assert "cannot be compiled" in done.stderr
