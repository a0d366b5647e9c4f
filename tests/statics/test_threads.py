"""The linear algebra of an analysis has one thread, and the user's setting is as it was behind it."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

import kinetruss as kt
from kinetruss import threads

HANGING = kt.Model(
    nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 2.0}}, fixed=["A"], bars={"b": ("A", "B")}, gravity=(0, -9.81)
)


@pytest.fixture
def libraries():
    """Functions that get and set the number of threads; both libraries of the wheels have two for the test."""
    found = threads._libraries()
    if not found:
        pytest.skip("neither NumPy nor SciPy has OpenBLAS here")
    before = [get() for get, _ in found]
    for _, put in found:
        put(2)
    yield found
    for (_, put), count in zip(found, before, strict=True):
        put(count)


def counts(libraries):
    return [get() for get, _ in libraries]


def test_wheels_have_two_libraries(libraries):
    assert len(libraries) == 2


def test_an_analysis_has_one_thread_and_leaves_the_users_two(libraries, monkeypatch):
    from kinetruss.statics import large_displacements

    seen, find = [], large_displacements.find_equilibrium
    monkeypatch.setattr(
        large_displacements, "find_equilibrium", lambda *given: [seen.append(counts(libraries)), find(*given)][1]
    )
    assert kt.statics.equilibrium(HANGING).stable
    assert seen == [[1] * len(libraries)]
    assert counts(libraries) == [2] * len(libraries)


def test_so_does_one_that_fails(libraries):
    with pytest.raises(kt.InputError):
        kt.statics.equilibrium(HANGING, load_case="none")
    assert counts(libraries) == [2] * len(libraries)


def test_calls_within_calls_and_side_by_side_give_back_what_the_first_took(libraries):
    together = Barrier(2)
    inner = threads.one_thread(lambda: counts(libraries))

    @threads.one_thread
    def outer(first):
        together.wait()  # both are inside
        found = inner() + counts(libraries)
        together.wait()
        if not first:
            together.wait()  # the other has left
            found += counts(libraries)
        return found

    def run(first):
        found = outer(first)
        if first:
            together.wait()
        return found

    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(run, (True, False)):
            assert set(found) == {1}
    assert counts(libraries) == [2] * len(libraries)


def test_every_analysis_is_one():
    for name in ("deflection", "platform_stiffness", "equilibrium", "buckling", "linear", "path", "at_poses"):
        assert hasattr(getattr(kt.statics, name), "__wrapped__")
    for name in ("inverse", "simulate", "linearise"):
        assert hasattr(getattr(kt.dynamics, name), "__wrapped__")
