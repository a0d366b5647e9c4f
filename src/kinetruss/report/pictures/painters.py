"""Pictures drawn beside the computation: processes that load the drawing library while the kernels still work."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import StoreError

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["Painters", "painters"]

COUNT = 2


class Painters:
    """Waiting processes; `figures` gives each its share of the pictures."""

    def __init__(self, waiting: Sequence[subprocess.Popen[bytes]]) -> None:
        self._waiting = list(waiting)

    def figures(self, run: RunResult, folder: str | Path, formats: Iterable[str] = ("png", "svg")) -> list[Path]:
        """Draw the pictures of a run as `report.figures` does; the same files, the same errors."""
        from kinetruss.report.pictures.figures import specifications

        specs, kinds = specifications(run), tuple(formats)
        shares = [specs[k :: len(self._waiting)] for k in range(len(self._waiting))]
        for painter, share in zip(self._waiting, shares, strict=True):
            assert painter.stdin is not None  # noqa: S101 - opened as a pipe
            with suppress(OSError):  # a painter that died is found out when it does not answer
                pickle.dump((share, Path(folder), kinds), painter.stdin)
                painter.stdin.close()
        written: list[Path] = []
        for painter, share in zip(self._waiting, shares, strict=True):
            written += _answer(painter, share, Path(folder), kinds)
        order = {spec.name: k for k, spec in enumerate(specs)}
        return sorted(written, key=lambda path: order[path.stem])


def _answer(painter: subprocess.Popen[bytes], share: list[Any], folder: Path, kinds: tuple[str, ...]) -> list[Path]:
    assert painter.stdout is not None  # noqa: S101 - opened as a pipe
    try:
        found = pickle.load(painter.stdout)
    except (EOFError, pickle.UnpicklingError):
        # it died (out of memory, say): draw here
        from kinetruss.report.pictures.draw import save

        return save(share, folder, kinds)
    if isinstance(found, StoreError):
        raise found
    paths: list[Path] = found
    return paths


@contextmanager
def painters() -> Iterator[Painters | None]:
    """Painters for the time of a run; None where there is one processor only, or no process can be started."""
    waiting: list[subprocess.Popen[bytes]] = []
    try:
        if (os.cpu_count() or 1) > 1:
            command = [sys.executable, "-m", "kinetruss.report.pictures.painters"]
            with suppress(OSError):
                # in a group of their own: Ctrl-C is told by this process; they end with it
                group: dict[str, Any] = {} if sys.platform == "win32" else {"process_group": 0}
                waiting += [
                    subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, **group) for _ in range(COUNT)
                ]
        yield Painters(waiting) if len(waiting) == COUNT else None
    finally:
        for painter in waiting:
            painter.kill()
            for pipe in (painter.stdin, painter.stdout):
                if pipe is not None:
                    with suppress(OSError):
                        pipe.close()
            painter.wait()


def _work() -> None:
    """One painter: load what draws, wait for the share, draw it, answer. Ends with its parent (its input ends)."""
    from kinetruss.report.pictures.draw import save, warm

    warm()
    try:
        share, folder, kinds = pickle.load(sys.stdin.buffer)
    except EOFError:
        return
    try:
        answer: object = save(share, folder, kinds)
    except StoreError as error:
        answer = error
    pickle.dump(answer, sys.stdout.buffer)


if __name__ == "__main__":
    _work()
