"""Independent pieces of work in processes beside each other."""

from __future__ import annotations

import ctypes
import gc
import multiprocessing
import os
import signal
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import Any, TypeVar

__all__ = ["beside", "processors"]

T = TypeVar("T")
LEAST = 4
"""Pieces of work below this are done before a process has begun."""
PARENT_DEATH = 1
"""PR_SET_PDEATHSIG of prctl(2)."""


def processors() -> int:
    """Processors this process may use; 1 where processes cannot be copied with what they have loaded."""
    if not sys.platform.startswith("linux"):
        return 1
    return len(os.sched_getaffinity(0))


def beside(work: Callable[[int], T], pieces: Sequence[int], workers: int | None = None) -> Iterator[tuple[int, T]]:
    """``work(k)`` for each piece k, (k, result) as they come; by copies of this process where there is more than one processor.

    What the copies need is in memory already: compiled kernels need not be loaded again. Pieces of a copy that dies are done
    here. Errors of the package are raised here too.
    """
    count = min(processors() if workers is None else workers, len(pieces))
    left = dict.fromkeys(pieces)
    if count > 1 and len(pieces) >= LEAST:
        for k, found in _gathered(work, pieces, count):
            del left[k]
            yield k, found
    for k in left:
        yield k, work(k)


def _gathered(work: Callable[[int], T], pieces: Sequence[int], count: int) -> Iterator[tuple[int, T]]:
    """What the copies did; what a copy that died had to do is left out."""
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("fork"), _begin, (work, os.getpid()))
    try:
        with warnings.catch_warnings():
            # other threads (of a progress bar, of the linear algebra) stay behind; the copies use none of theirs
            warnings.simplefilter("ignore", DeprecationWarning)
            asked = {pool.submit(_piece, k): k for k in pieces}
        for future in as_completed(asked):
            if not isinstance(future.exception(), BrokenProcessPool):
                yield asked[future], future.result()
    except BaseException:
        for process in set(multiprocessing.active_children()) - others:
            process.terminate()  # nobody waits for what they are doing
        raise
    finally:
        pool.shutdown(cancel_futures=True)


_mine: list[Callable[[int], Any]] = []
"""In a copy: its work."""


def _begin(work: Callable[[int], Any], parent: int) -> None:
    """The start of a copy. It dies with its parent, and of Ctrl-C, in silence."""
    gc.freeze()  # what came with the copy is no garbage; looking through it would copy its memory
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(PARENT_DEATH, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
    _mine[:] = [work]


def _piece(k: int) -> Any:
    return _mine[0](k)
