"""Independent tasks in parallel processes."""

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
"""Smallest number of tasks for which processes are started."""
PARENT_DEATH = 1
"""The constant PR_SET_PDEATHSIG of prctl(2)."""


def processors() -> int:
    """Number of processors of this process; 1 if the system cannot fork a process with its loaded data."""
    if not sys.platform.startswith("linux"):
        return 1
    return len(os.sched_getaffinity(0))


def beside(work: Callable[[int], T], pieces: Sequence[int], workers: int | None = None) -> Iterator[tuple[int, T]]:
    """Yields (k, ``work(k)``) for each task k as it is done; by forked copies of this process if there are several processors.

    The copies already have all data in memory: compiled kernels are not loaded again. Tasks of a copy that dies are done in
    this process. Errors of the package are raised in this process too.
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
    """The results of the copies; those of a copy that died are missing."""
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("fork"), _begin, (work, os.getpid()))
    try:
        with warnings.catch_warnings():
            # other threads (of a progress bar, of linear algebra) are not copied, and the copies do not need them
            warnings.simplefilter("ignore", DeprecationWarning)
            asked = {pool.submit(_piece, k): k for k in pieces}
        for future in as_completed(asked):
            if not isinstance(future.exception(), BrokenProcessPool):
                yield asked[future], future.result()
    except BaseException:
        for process in set(multiprocessing.active_children()) - others:
            process.terminate()  # their results are no longer needed
        raise
    finally:
        pool.shutdown(cancel_futures=True)


_mine: list[Callable[[int], Any]] = []
"""The work of a copy, set in the copy."""


def _begin(work: Callable[[int], Any], parent: int) -> None:
    """Start of a copy. It ends silently with its parent, and after Ctrl-C."""
    gc.freeze()  # exclude inherited objects from garbage collection, which would copy their memory pages
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(PARENT_DEATH, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
    _mine[:] = [work]


def _piece(k: int) -> Any:
    return _mine[0](k)
