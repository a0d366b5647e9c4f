"""Independent pieces of work in processes beside each other."""

from __future__ import annotations

import gc
import multiprocessing
import os
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar, cast

from kinetruss.errors import KinetrussError

__all__ = ["beside", "processors"]

T = TypeVar("T")
LEAST = 4
"""Pieces of work below this are done before a process has begun."""


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
            if isinstance(found, KinetrussError):
                raise found
            del left[k]
            yield k, found
    for k in left:
        yield k, work(k)


def _gathered(work: Callable[[int], T], pieces: Sequence[int], count: int) -> Iterator[tuple[int, T]]:
    context = multiprocessing.get_context("fork")
    processes, ends = [], []
    try:
        for first in range(count):
            end, far = context.Pipe(duplex=False)
            process = context.Process(target=_share, args=(far, work, pieces[first::count]), daemon=True)
            with warnings.catch_warnings():
                # other threads (of a progress bar, of the linear algebra) stay behind; the copies use none of theirs
                warnings.simplefilter("ignore", DeprecationWarning)
                process.start()
            far.close()
            processes.append(process)
            ends.append(end)
        while ends:
            for end in cast("list[Connection]", wait(ends)):
                try:
                    yield end.recv()
                except EOFError:  # it has done its share, or died
                    end.close()
                    ends.remove(end)
    finally:
        for process in processes:
            process.terminate()
            process.join()


def _share(far: Connection, work: Callable[[int], Any], pieces: Sequence[int]) -> None:
    """The work of one copy; it ends with its parent, which no longer listens."""
    gc.freeze()  # what came with the copy is no garbage; looking through it would copy its memory
    try:
        for k in pieces:
            try:
                far.send((k, work(k)))
            except KinetrussError as error:
                far.send((k, error))
                return
    except (KeyboardInterrupt, BrokenPipeError):
        return
