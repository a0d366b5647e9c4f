"""Work beside each other in forked copies of this process: a copy that dies costs the piece that it was doing, and no other."""

from __future__ import annotations

import ctypes
import gc
import multiprocessing
import os
import signal
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar

T = TypeVar("T")
LEAST = 4
"""Smallest number of tasks for which processes are started."""
PARENT_DEATH = 1
"""The constant PR_SET_PDEATHSIG of prctl(2)."""
_copies: list[int] = []
"""In a copy its number: it starts no copies of its own."""


def processors() -> int:
    """Number of processors of this process; 1 in a copy, and if the system cannot fork a process with its loaded data."""
    if _copies or not sys.platform.startswith("linux"):
        return 1
    return len(os.sched_getaffinity(0))


def beside(
    work: Callable[[int], T], pieces: Sequence[int], workers: int | None = None, *, lost: T | None = None
) -> Iterator[tuple[int, T]]:
    """Yields (k, ``work(k)``) for each task k as it is done; by forked copies of this process if there are several processors.

    The copies already have all data in memory: compiled kernels are not loaded again. Errors of the package are raised in this
    process too. lost : what is found of a task whose copy died, which is then not done here, and copies are started for the
    first task already, also one alone; by default such tasks are done in this process at the end.
    """
    most = processors() if workers is None else workers
    count, left = min(most, len(pieces)), dict.fromkeys(pieces)
    apart = lost is not None and sys.platform.startswith("linux") and not _copies
    if apart or (count > 1 and len(pieces) >= LEAST):
        for k, done, found in _gathered(work, pieces, max(1, count)):
            if done:
                del left[k]
                yield k, found
            elif lost is not None:
                del left[k]
                yield k, lost
    for k in left:
        yield k, work(k)


class _Copy:
    """A forked copy of this process and what it does now (None: nothing)."""

    def __init__(self, work: Callable[[int], Any]) -> None:
        context = multiprocessing.get_context("fork")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(work, theirs, os.getpid()), daemon=True)
        with warnings.catch_warnings():
            # other threads (of a progress bar, of linear algebra) are not copied, and the copies do not need them
            warnings.simplefilter("ignore", DeprecationWarning)
            self.process.start()
        theirs.close()  # so that the end of the copy is the end of its pipe
        self.piece: int | None = None

    def ask(self, piece: int) -> None:
        self.piece = piece
        with suppress(OSError):  # it died; `wait` will tell
            self.pipe.send(piece)

    def end(self) -> None:
        """End the copy at once: its results are no longer needed."""
        self.process.kill()
        self.process.join()
        self.pipe.close()


def _gathered(work: Callable[[int], T], pieces: Sequence[int], count: int) -> Iterator[tuple[int, bool, Any]]:
    """Each task with True and its result, or with False if its copy died."""
    left, copies = list(reversed(pieces)), list[_Copy]()
    try:
        while left or any(one.piece is not None for one in copies):
            while left and len(copies) < count:
                copies.append(_Copy(work))
            for one in copies:
                if one.piece is None and left:
                    one.ask(left.pop())
            busy = {one.pipe: one for one in copies if one.piece is not None}
            for pipe in wait(list(busy)):
                one = busy[pipe]  # type: ignore[index]
                piece, one.piece = one.piece, None
                try:
                    good, found = one.pipe.recv()
                except (EOFError, OSError):
                    copies.remove(one)
                    one.end()
                    yield int(piece or 0), False, None
                    continue
                if not good:
                    raise found
                yield int(piece or 0), True, found
    finally:
        for one in copies:
            one.end()


def _serve(work: Callable[[int], Any], pipe: Connection, parent: int) -> None:
    """A copy: it does what it is asked for. It ends silently with its parent, and after Ctrl-C."""
    gc.freeze()  # exclude inherited objects from garbage collection, which would copy their memory pages
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(PARENT_DEATH, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
    _copies.append(os.getpid())
    with suppress(EOFError):
        while True:
            piece = pipe.recv()
            try:
                found = True, work(piece)
            except Exception as error:  # noqa: BLE001 - raised again in the parent
                found = False, error
            pipe.send(found)
