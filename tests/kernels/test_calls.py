"""Kernels that others reach at addresses."""

from __future__ import annotations

import threading
from types import GenericAlias
from typing import Annotated, NamedTuple

import numpy as np
import pytest
from numba import float64
from numba.core.errors import TypingError

from kinetruss.kernels.compiled.calls import Apart, Interface, type_of
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I0, I1, U1, Record, record


@record
class Numbers(Record):
    """A record for tests."""

    count: I0
    at: I1
    a: F1
    m: F2


@record
class Others(Record):
    """The same fields in other places."""

    m: F2
    a: F1
    at: I1


class Both(NamedTuple):
    """A named tuple for tests."""

    numbers: Numbers
    places: U1


needed = Apart("numbers.at[{}]")


@needed
def weighed(numbers: Numbers, x: F1, y: F2, scale: float, k: int) -> float:
    """Reads all that it is given, and writes."""
    total = scale * k + numbers.count
    for i in range(x.size):
        total += numbers.a[i] * x[i]
    y[1, 1] = total
    numbers.m[1, 0] = total
    return total


@needed(allocates=True)
def picked(numbers: Numbers, both: Both, x: F1) -> None:
    """Writes a plus the count at the places into x."""
    found = np.empty(x.size)
    for i in range(x.size):
        found[i] = both.numbers.a[both.places[i]] + numbers.count
    x[:] = found


@kernel_bare
def outer(numbers, x, y, wanted):
    return weighed(numbers, x, y, 2, 3) if wanted else 0.0


@kernel
def through(numbers, places, x):
    picked(numbers, Both(numbers, places), x)


def numbers(at=()):
    return Numbers.of({"count": 5, "at": np.array(at, np.int64), "a": np.arange(3.0), "m": np.zeros((2, 2))})


@pytest.mark.slow
def test_who_calls_it_compiles_without_it_and_finds_it_at_its_address():
    one, x, y = numbers(), np.ones(3), np.zeros((2, 2))
    assert outer(one, x, y, False) == 0.0
    (interface, inner), _ = needed._kernels
    assert not interface._compiled
    one = numbers(needed.addresses())
    assert outer(one, x, y, True) == 2.0 * 3 + 5 + 3.0
    assert (y[1, 1], one.m[1, 0]) == (14.0, 14.0)
    assert outer(one, 2 * x, y, True) == 17.0
    assert interface.address(inner) == needed.addresses()[0]


def test_python_calls_it_as_any_other():
    one, x, y = numbers(needed.addresses()), np.ones(3), np.zeros((2, 2))
    assert weighed(one, x, y, 0.5, 2) == 9.0


@pytest.mark.slow
def test_named_tuples_and_whole_numbers_without_sign():
    x = np.zeros(2)
    through(numbers(needed.addresses()), np.array([2, 1], np.uint32), x)
    assert x.tolist() == [7.0, 6.0]


def test_all_of_a_group_are_of_one_file():
    """Places in the array would depend on which file is imported first, and compiled code has them."""

    def other(numbers: Numbers) -> float:
        return 0.0

    other.__module__ = "elsewhere"
    with pytest.raises(TypeError, match="other is not of"):
        needed(other)


@pytest.mark.parametrize(
    "array",
    [np.ndarray[tuple[int, ...], np.dtype[np.float64]], GenericAlias(np.ndarray, np.float64)],
    ids=["NumPy 2.4", "NumPy 2.5"],
)
def test_arrays_are_known_by_their_scalar_in_any_numpy(array):
    kind = type_of(Annotated[array, None, 2])
    assert (kind.dtype, kind.ndim) == (float64, 2)


@pytest.mark.parametrize(
    "given",
    [
        pytest.param(lambda: (numbers(), np.ones((3, 2))[:, 0], np.zeros((2, 2)), True), id="layout"),
        pytest.param(lambda: (numbers(), np.ones(3, np.float32), np.zeros((2, 2)), True), id="dtype"),
        pytest.param(lambda: (numbers(), np.ones(3), np.zeros(2), True), id="axes"),
        pytest.param(
            lambda: (
                Others.of({"m": np.zeros((2, 2)), "a": np.zeros(3), "at": np.zeros(2)}),
                np.ones(3),
                np.zeros((2, 2)),
                True,
            ),
            id="record",
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
def test_threads_that_ask_at_once_get_one_address(monkeypatch):
    @Interface
    def first_of(x: F1) -> float:
        raise NotImplementedError  # never called: a declaration, of which Interface reads the annotations

    @kernel_bare
    def shared(x):
        return x[0]

    call, found, made = first_of.call, [], []
    together, entry = threading.Barrier(4), Interface._entry

    @kernel_bare
    def caller(at, x):
        return call(at, (x,))

    def counted(*given):
        made.append(given)
        return entry(*given)

    def ask(k):
        together.wait()
        found.append((first_of.address(shared), caller(first_of.address(shared), np.full(1, float(k)))))

    monkeypatch.setattr(Interface, "_entry", counted)
    threads = [threading.Thread(target=ask, args=(k,)) for k in range(4)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert len(made) == 1
    assert len({address for address, _ in found}) == 1
    assert sorted(value for _, value in found) == [0.0, 1.0, 2.0, 3.0]


@pytest.mark.slow
def test_what_cannot_be_compiled_is_an_error_where_its_address_is_asked_for():
    @Interface
    def of_array(x: F1) -> float:
        raise NotImplementedError  # never called: a declaration, of which Interface reads the annotations

    @kernel_bare
    def broken(x):
        return x.no_such_thing

    with pytest.raises(TypingError, match="no_such_thing"):
        of_array.address(broken)
