"""Lines while kernels are compiled: after some seconds, not too many, and no count that ends before its total."""

import io
import subprocess
import sys

import pytest

from kinetruss.kernels.compiled.progress import PATIENCE, SOON, Progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


class Clock:
    """A clock that goes on by a step with every kernel."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


def compiled(stream, step: float, kernels: int = 10) -> Progress:
    """The progress of some kernels one after the other, each of which takes so many seconds."""
    clock = Clock()
    progress = Progress(stream, clock)
    for _ in range(kernels):
        progress.begin()
        clock.now += step
        progress.compiled()
        progress.tell()
    return progress


def lines(stream, step: float) -> list[str]:
    compiled(stream, step)
    return stream.getvalue().splitlines()


def test_a_line_says_how_far_it_is_and_that_it_happens_once():
    found = lines(Terminal(), PATIENCE)
    assert found[0] == f"kinetruss: compiling (first start only): 1 kernel, {PATIENCE:.0f} s"
    assert len(found) == 10
    assert " of " not in "".join(found)  # how many there will be is not known


def test_what_is_quick_says_nothing_and_what_is_long_not_much():
    assert lines(Terminal(), SOON / 20) == []
    assert len(lines(Terminal(), PATIENCE / 4)) == 3


def test_in_a_pipe_one_line_says_that_it_begins_and_one_that_it_is_done():
    stream = io.StringIO()
    progress = compiled(stream, PATIENCE)
    assert stream.getvalue() == "kinetruss: compiling (first start only) ...\n"
    progress.end()
    progress.end()
    assert stream.getvalue().splitlines()[1:] == [f"kinetruss: compiled 10 kernels in {10 * PATIENCE:.0f} s."]
    stream = io.StringIO()
    compiled(stream, SOON / 20).end()
    assert stream.getvalue() == ""


def test_kernels_within_kernels_are_one_time_and_those_that_failed_are_forgotten():
    clock = Clock()
    progress = Progress(io.StringIO(), clock)
    progress.begin("entry")
    clock.now = 1.0
    progress.begin()
    clock.now = 3.0
    assert (progress.at_work, progress.seconds, progress.count) == (True, 3.0, 0)
    progress.compiled()
    assert progress.at_work  # the entry
    clock.now = 4.0
    progress.compiled("entry")
    clock.now = 9.0
    assert (progress.at_work, progress.seconds, progress.count) == (False, 4.0, 1)
    progress.begin("entry")
    progress.begin()  # refused: it is never done
    clock.now = 10.0
    progress.begin("entry")
    progress.compiled("entry")
    assert (progress.at_work, progress.seconds) == (False, 5.0)


@pytest.mark.slow
def test_a_kernel_that_is_compiled_is_seen_at_work():
    """Numba asks for what is kept, compiles, and saves: what it does is known meanwhile."""
    code = """
from kinetruss.kernels.compiled import jit
found = jit.keeper.progress
seen = []
@jit.kernel
def inner(a: int) -> int:
    return a + 1
@jit.kernel
def outer(a: int) -> int:
    return inner(a) + 1
save = jit.Kept.save_overload
def saved(*given):
    seen.append((found.at_work, found.depth))
    save(*given)
jit.Kept.save_overload = saved
assert outer(1) == 3
print(seen, found.at_work, found.count, found.seconds > 0)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split("\n")[0] == "[(True, 3), (True, 2), (True, 1)] False 2 True"


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

    compiled(Shown(), PATIENCE, 3)
    assert shown[0].startswith("kinetruss: compiling (first start only): 1 kernel")
    assert len(shown) == 3
