"""Studies on a Dask cluster: batches of rows go to the workers of the user's scheduler; nothing is started or opened there."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from kinetruss import __version__
from kinetruss.errors import AnalysisError, InputError
from kinetruss.io.exporting import needed
from kinetruss.studies.evaluating import Outcome, Rows, Task, evaluate

SECONDS = 10
"""How long the scheduler may take to answer."""
AHEAD = 3
"""Batches that each worker has: one that it computes, and those that wait for it."""

Found = list[Outcome] | None


def version() -> str:
    """The version of kinetruss in a process."""
    return __version__


@contextmanager
def connected(address: str) -> Iterator[tuple[Callable[[Task, Sequence[Rows]], Iterator[tuple[int, Found]]], int]]:
    """What computes batches on the cluster at an address, and how many workers it has.

    Raises
    ------
    InputError : it is not reached, has no workers, or these have another version of kinetruss, or none.
    """
    distributed = needed("distributed", "cluster", "A cluster")
    try:
        client = distributed.Client(address, timeout=SECONDS, set_as_default=False)
    except (OSError, ValueError, TypeError, ImportError) as error:
        raise InputError(
            f"The cluster at {address} is not reached ({type(error).__name__}: {error}). "
            "Start one: dask scheduler --host 127.0.0.1, and dask worker ADDRESS on each machine; or leave out --cluster."
        ) from None
    try:
        yield _executor(distributed, client, address), _checked(client, address)
    finally:
        client.close()


def _checked(client: Any, address: str) -> int:
    """The number of workers."""
    workers = client.scheduler_info(n_workers=-1)["workers"]
    if not workers:
        raise InputError(f"The cluster at {address} has no workers. Start some: dask worker {address}")
    found = client.run(version, on_error="return")
    bad = {worker: one for worker, one in found.items() if one != __version__}
    if bad:
        worker, one = next(iter(bad.items()))
        has = f"kinetruss {one}" if isinstance(one, str) else f"no kinetruss ({one})"
        raise InputError(f"Worker {worker} has {has}; this is {__version__}. Install the same version on every worker.")
    return len(workers)


def _executor(distributed: Any, client: Any, address: str) -> Callable[[Task, Sequence[Rows]], Iterator[tuple[int, Found]]]:
    def computed(task: Task, batches: Sequence[Rows]) -> Iterator[tuple[int, Found]]:
        """Each batch as it is done; a few for each worker are under way, so that the scheduler holds no long list."""
        asked, left = dict[Any, int](), iter(range(len(batches)))
        running = distributed.as_completed(loop=client.loop)

        def more() -> None:
            most = AHEAD * max(1, len(client.scheduler_info(n_workers=-1)["workers"]))
            while len(asked) < most and (k := next(left, None)) is not None:
                future = client.submit(evaluate, task, batches[k], pure=False)
                asked[future] = k
                running.add(future)

        more()
        while asked:
            future = next(running)
            k = asked.pop(future)
            if future.status in ("cancelled", "lost"):
                raise AnalysisError(
                    f"The cluster at {address} is lost. Rows that are done are kept: start the study again, and it goes on."
                )
            error = future.exception()
            if error is not None and not isinstance(error, distributed.KilledWorker):
                raise error
            yield k, None if error is not None else future.result()
            future.release()
            more()

    return computed
