"""Lines while kernels are compiled: on a terminal, after some seconds, and not too many."""

import io
from itertools import count

import pytest

from kinetruss.kernels.compiled.progress import PATIENCE, Progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


def lines(stream, step):
    """What 10 kernels write that take so many seconds each."""
    clock = count(0.0, step)
    progress = Progress(lambda: 448, stream, lambda: next(clock))
    for _ in range(10):
        progress.compiled()
    return stream.getvalue().splitlines()


def test_a_line_says_how_far_it_is_and_that_it_happens_once():
    found = lines(Terminal(), PATIENCE)
    assert found[0] == f"kinetruss compiles its kernels, once on this machine: 2 of at most 448, {PATIENCE:.0f} s"
    assert len(found) == 9


def test_what_is_quick_says_nothing_and_what_is_long_not_much():
    assert lines(Terminal(), PATIENCE / 20) == []
    assert len(lines(Terminal(), PATIENCE / 4)) == 2


def test_nothing_where_nobody_looks():
    assert lines(io.StringIO(), PATIENCE) == []


def test_a_notebook_shows_the_lines():
    stream = pytest.importorskip("ipykernel.iostream").OutStream
    shown = []

    class Shown(stream):
        """The stream of a kernel that has no client: what is written is kept."""

        __module__ = stream.__module__

        def __init__(self):
            pass

        def write(self, text):
            shown.append(text)

        def isatty(self):
            return False

        flush = close = __del__ = lambda self: None

    clock = count(0.0, PATIENCE)
    progress = Progress(lambda: 448, Shown(), lambda: next(clock))
    for _ in range(3):
        progress.compiled()
    assert shown[0].startswith("kinetruss compiles its kernels, once on this machine: 2 of at most 448")
